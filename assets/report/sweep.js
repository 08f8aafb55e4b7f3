// The sweep: numbers decoded from the page, by place. A place is a point of the grid over three axes, the last one fastest: f, α and β,
// or f, quantities of the laboratory and the speed. Names here are those of the dimensionless axes.

const contents = JSON.parse(document.getElementById("contents").textContent);

function bytes(text) {
  const raw = atob(text);
  const decoded = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) decoded[i] = raw.charCodeAt(i);
  return decoded.buffer;
}

const floats = (text) => new Float32Array(bytes(text));
const integers = (text) => new Int32Array(bytes(text));
const shorts = (text) => new Uint16Array(bytes(text));

const axes = contents.axes.map((axis) => axis.map((value) => (value === "inf" ? Infinity : value)));
const [fs, alphas, betas] = axes;
const axisWords = contents.axis_words;
const [, alphaSymbol, betaSymbol] = axisWords.map((axis) => axis.symbol);
const placeCount = fs.length * alphas.length * betas.length;

const placeAt = (iF, iAlpha, iBeta) => (iF * alphas.length + iAlpha) * betas.length + iBeta;
function indicesOf(place) {
  const iBeta = place % betas.length;
  const rest = (place - iBeta) / betas.length;
  return [Math.floor(rest / alphas.length), rest % alphas.length, iBeta];
}

const caseOf = integers(contents.case_of);
const failedAt = integers(contents.status);

// Each column is decoded when it is first asked for.
const columns = new Map(contents.columns.map((column) => [column.name, { ...column, decoded: null }]));
function column(name) {
  const found = columns.get(name);
  found.decoded ??= floats(found.values);
  return found.decoded;
}

const costs = contents.costs && {
  seconds: floats(contents.costs.seconds),
  iterations: floats(contents.costs.iterations),
  factorisations: floats(contents.costs.factorisations),
  seedOf: integers(contents.costs.seed),
};

// The largest of the three estimated errors; NaN if one is not known.
const largestErrors = (() => {
  const parts = ["error_mu_v", "error_mu_h", "error_c"].map(column);
  // Math.max is NaN if one of its numbers is.
  return Float32Array.from({ length: placeCount }, (_, place) => Math.max(...parts.map((part) => part[place])));
})();

// Fields are decoded when one is first asked for.
let fieldParts = null;
function decodedFields() {
  const part = contents.fields;
  if (!fieldParts) {
    fieldParts = { x: floats(part.x), slots: integers(part.slots), indices: shorts(part.indices), fields: {} };
    for (const [name, field] of Object.entries(part.fields)) {
      fieldParts.fields[name] = { ...field, low: floats(field.low), high: floats(field.high), steps: shorts(field.steps) };
    }
  }
  return fieldParts;
}

// The place itself if it suits, else the one that suits the fewest steps away on the axes; null if none does.
function nearestPlace(place, suits) {
  if (suits(place)) return place;
  const own = indicesOf(place);
  let best = null;
  let fewest = Infinity;
  for (let other = 0; other < placeCount; other++) {
    if (!suits(other)) continue;
    // Another f is farther than any step along α and β.
    const [iF, iAlpha, iBeta] = indicesOf(other).map((index, i) => Math.abs(index - own[i]));
    const steps = iF * (alphas.length + betas.length) + iAlpha + iBeta;
    if (steps < fewest) [fewest, best] = [steps, other];
  }
  return best;
}

const hasFields = (place) => decodedFields().slots[caseOf[place]] >= 0;

// The fields of a case: { x, pressure, film_thickness, displacement }, as far as the sweep has them.
function fieldsOf(place) {
  const part = contents.fields;
  const fieldParts = decodedFields();
  const slot = fieldParts.slots[caseOf[place]];
  const from = slot * part.points;
  const found = { x: Array.from({ length: part.points }, (_, i) => fieldParts.x[fieldParts.indices[from + i]]) };
  for (const [name, field] of Object.entries(fieldParts.fields)) {
    const low = field.low[slot];
    const span = field.high[slot] - low;
    found[name] = Array.from({ length: part.points }, (_, i) => {
      const value = low + (span * field.steps[from + i]) / 65535;
      return field.logarithmic[slot] ? 10 ** value : value;
    });
  }
  return found;
}

// What is known of the experiment at a place: quantities that are one number, and those of the axes by their names.
function quantitiesAt(place) {
  const known = { ...contents.fixed };
  indicesOf(place).forEach((index, axis) => {
    const { name, members } = axisWords[axis];
    if (members.length) members[index].forEach(([member, value]) => (known[member] = value));
    else if (name) known[name] = axes[axis][index];
  });
  return known;
}
