// Reads surfaces: friction as a function of its axes, from the file that `stribeck surface` makes
// (docs/reference/surface-file.md).
// This module needs no other; it runs in browsers and in Node.js.

const known = "stribeck surface 1";

// How far a value at a check point may be from the one in the file.
const near = 1e-12;

const damaged = (what) => new Error(`${what}; the file is damaged, make it again with \`stribeck surface\``);

// z of a value, in which t is linear, the value at a z, and dz/dx. A compact axis reaches x = 0, where the slope is
// infinite, and ∞.
const maps = {
  linear: () => ({ z: (x) => x, x: (z) => z, slope: () => 1 }),
  log: () => ({ z: Math.log, x: Math.exp, slope: (x) => 1 / x }),
  compact: ({ center }) => {
    const root = (x) => Math.sqrt(Math.sqrt(x / center));
    const z = (x) => (x === Infinity ? 1 : root(x) / (1 + root(x)));
    return { z, x: (at) => center * (at / (1 - at)) ** 4, slope: (x) => z(x) / (4 * x * (1 + root(x))) };
  },
};

function axisOf(record) {
  const { name, units, long_name: longName, from, map } = record;
  if (!Object.keys(maps).includes(map)) throw damaged(`${name} has the map \`${map}\`, which is none`);
  const to = record.to === "inf" ? Infinity : record.to;
  const { z, x: atZ, slope } = maps[map](record);
  const [start, length] = [z(from), z(to) - z(from)];
  if (!(length > 0 && length < Infinity)) throw damaged(`${name} from ${from} to ${to} is no range`);
  // Rounding may lead beyond the ends.
  const within = (low, x, high) => Math.min(Math.max(x, low), high);
  const inside = (place) => within(from, atZ(start + place * length), to);
  return {
    ...{ name, units, longName, map, from, to },
    t: (x) => within(-1, (2 * (z(x) - start)) / length - 1, 1),
    slope: (x) => (2 * slope(x)) / length,
    place: (x) => within(0, (z(x) - start) / length, 1),
    value: (place) => (place <= 0 ? from : place >= 1 ? to : inside(place)),
  };
}

function bytesOf(name, text) {
  try {
    const letters = atob(text);
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < bytes.length; i++) bytes[i] = letters.charCodeAt(i);
    return bytes;
  } catch (error) {
    throw damaged(`${name}: not base64 (${error.message})`);
  }
}

// Numbers in base64, little-endian.
function decode({ name, numbers }, text, count) {
  const bytes = bytesOf(name, text);
  const view = new DataView(bytes.buffer);
  const [size, get] = { float32: [4, "getFloat32"], float64: [8, "getFloat64"] }[numbers];
  const found = Float64Array.from({ length: bytes.length / size }, (_, place) => view[get](size * place, true));
  if (bytes.length !== size * count || !found.every(Number.isFinite)) {
    throw damaged(`${name}: ${bytes.length} bytes, and ${count} finite numbers are expected`);
  }
  return found;
}

// A quantity: its series y in Tucker form, and how it follows from y. `before` has the quantities before it.
function quantityOf(record, before, axes) {
  const { name, shape, transform } = record;
  if (shape.length !== axes.length) throw damaged(`${name}: ${shape.length} factors, and ${axes.length} axes`);
  if (!["identity", "exp", "sinh", "root"].includes(transform)) {
    throw damaged(`${name} has the transform \`${transform}\`, which is none`);
  }
  const whole = transform in partOf ? before.findIndex((other) => other.name === record.of) : null;
  if (whole === -1) throw damaged(`${name}: the quantity that it is a part of is not before it`);
  const factors = shape.map(([degrees, rank], m) => ({
    ...{ degrees, rank },
    numbers: decode(record, record.factors[m], degrees * rank),
  }));
  const core = decode(
    record,
    record.core,
    shape.reduce((size, [, rank]) => size * rank, 1),
  );
  const { units, scale = null, long_name: longName, share, offset } = record;
  return { ...{ name, units, scale, longName, transform, whole, factors, core }, share, offset };
}

// out[i] = Σ_k weights[k] numbers[k][i], for so many rows and columns. Four rows at once halve loads and stores.
function contract(numbers, rows, columns, weights, out) {
  out.fill(0, 0, columns);
  let k = 0;
  for (; k + 4 <= rows; k += 4) {
    const [a, b, c, d] = [weights[k], weights[k + 1], weights[k + 2], weights[k + 3]];
    for (let i = 0, at = k * columns; i < columns; i++, at++) {
      const first = a * numbers[at] + b * numbers[at + columns];
      out[i] += first + (c * numbers[at + 2 * columns] + d * numbers[at + 3 * columns]);
    }
  }
  for (; k < rows; k++) {
    for (let i = 0, at = k * columns; i < columns; i++, at++) out[i] += weights[k] * numbers[at];
  }
}

// T_k(t), and k U_(k−1)(t) times the slope, which are their derivatives.
function fillBasis(t, slope, [polynomials, derivatives]) {
  let [before, second] = [0, 1];
  for (let k = 0; k < polynomials.length; k++) {
    polynomials[k] = k === 0 ? 1 : k === 1 ? t : 2 * t * polynomials[k - 1] - polynomials[k - 2];
    derivatives[k] = slope * k * before;
    [before, second] = [second, 2 * t * second - before];
  }
}

// The series of a quantity at the point whose polynomials are in `bases`: y, or its derivative along one axis.
function seriesAt({ factors, core }, bases, along, { weights, parts }) {
  let from = core;
  factors.forEach(({ degrees, rank, numbers }, m) => {
    contract(numbers, degrees, rank, bases[m][m === along ? 1 : 0], weights);
    const out = parts[m % 2];
    const columns = factors.slice(m + 1).reduce((size, other) => size * other.rank, 1);
    contract(from, rank, columns, weights, out);
    from = out;
  });
  return from[0];
}

// Chebyshev coefficients of a quantity along one axis, where the polynomials of all other axes are in `bases`.
function coefficientsAlong({ factors, core }, bases, along) {
  let [from, outer, inner] = [core, 1, core.length];
  factors.forEach(({ degrees, rank, numbers }, m) => {
    inner /= rank;
    if (m === along) {
      outer = rank;
      return;
    }
    const weights = new Float64Array(rank);
    contract(numbers, degrees, rank, bases[m][0], weights);
    const out = new Float64Array(outer * inner);
    for (let o = 0; o < outer; o++) {
      const block = from.subarray(o * rank * inner, (o + 1) * rank * inner);
      contract(block, rank, inner, weights, out.subarray(o * inner, (o + 1) * inner));
    }
    from = out;
  });
  const { degrees, rank, numbers } = factors[along];
  const row = (k) => numbers.subarray(k * rank, (k + 1) * rank);
  return Float64Array.from({ length: degrees }, (_, k) => row(k).reduce((sum, u, a) => sum + u * from[a], 0));
}

// Σ c_k T_k(t), by Clenshaw's recurrence.
function seriesOf(coefficients, t) {
  let [b1, b2] = [0, 0];
  for (let k = coefficients.length - 1; k > 0; k--) [b1, b2] = [coefficients[k] + 2 * t * b1 - b2, b1];
  return coefficients[0] + t * b1 - b2;
}

// What a part of a whole is over its share of that, and the derivative of that, by its transform.
const partOf = {
  sinh: (y) => [Math.sinh(y), Math.cosh(y)],
  root: (y, offset) => {
    const [change, least] = [Math.expm1(0.5 * y), Math.sqrt(offset)];
    return [change * (change + 2 * least), (change + least) * (change + 1)];
  },
};

function valueOf({ transform, share, whole, offset }, y, values) {
  if (transform in partOf) return share * values[whole] * partOf[transform](y, offset)[0];
  return transform === "exp" ? Math.exp(y) : y;
}

// The derivative of a quantity, from y and dy, its value, and values and slopes of the quantities before it.
function slopeOf({ transform, share, whole, offset }, [y, dy], value, values, slopes) {
  if (transform in partOf) {
    const [part, change] = partOf[transform](y, offset);
    return share * (slopes[whole] * part + values[whole] * change * dy);
  }
  return transform === "exp" ? value * dy : dy;
}

function checkInside({ name, from, to }, x) {
  if (from <= x && x <= to) return;
  throw new RangeError(`${name} = ${x} is outside the surface, which has ${name} from ${from} to ${to}`);
}

// Coordinates in the order of the axes, from a list or by name.
function coordinatesOf(axes, point) {
  const coordinates = "length" in point ? Array.from(point) : axes.map(({ name }) => point[name]);
  if (coordinates.includes(undefined) || Object.keys(point).length !== axes.length) {
    const names = axes.map(({ name }) => name).join(", ");
    throw new RangeError(`a point of this surface has ${names}: give each of them once, in this order or by name`);
  }
  axes.forEach((axis, m) => checkInside(axis, coordinates[m]));
  return coordinates;
}

// What evaluates quantities: functions of coordinates, for values, for derivatives, and for values along an axis. They
// share their memory.
function evaluatorOf(axes, quantities) {
  const most = (size) => Math.max(...quantities.map(size));
  const bases = axes.map((_, m) => {
    const degrees = most(({ factors }) => factors[m].degrees);
    return [new Float64Array(degrees), new Float64Array(degrees)];
  });
  const largest = most(({ core }) => core.length);
  const memory = {
    weights: new Float64Array(most(({ factors }) => Math.max(...factors.map(({ rank }) => rank)))),
    parts: [new Float64Array(largest), new Float64Array(largest)],
  };
  const fillBases = (coordinates) =>
    axes.forEach((axis, m) => fillBasis(axis.t(coordinates[m]), axis.slope(coordinates[m]), bases[m]));
  const valuesOf = (series) => {
    const found = [];
    quantities.forEach((quantity, q) => found.push(valueOf(quantity, series[q], found)));
    return found;
  };
  const values = (coordinates) => {
    fillBases(coordinates);
    const series = quantities.map((quantity) => seriesAt(quantity, bases, null, memory));
    return { series, values: valuesOf(series) };
  };
  // For each axis the derivatives of all quantities.
  const derivatives = (coordinates) => {
    const at = values(coordinates);
    return axes.map((_, m) => {
      const slopes = [];
      quantities.forEach((quantity, q) => {
        const y = [at.series[q], seriesAt(quantity, bases, m, memory)];
        slopes.push(slopeOf(quantity, y, at.values[q], at.values, slopes));
      });
      return slopes;
    });
  };
  // A function of the coordinate on one axis; what the other coordinates take is done once.
  const line = (along, coordinates) => {
    fillBases(coordinates);
    const coefficients = quantities.map((quantity) => coefficientsAlong(quantity, bases, along));
    return (x) => valuesOf(coefficients.map((own) => seriesOf(own, axes[along].t(x))));
  };
  return { values: (coordinates) => values(coordinates).values, derivatives, line };
}

// What a difference of a quantity is relative to: itself, or of a part its share of the whole where that is larger.
const sizeOf = ({ share, whole }, q, values) =>
  Math.max(Math.abs(values[q]), whole === null ? 0 : share * Math.abs(values[whole]));

// What a measured error of a quantity is relative to. Positions are also measured by their unit, which is 1 where they
// are over a scale, and not in the file where they are in SI units.
function errorScale(quantity, q, values) {
  const size = sizeOf(quantity, q, values);
  if (quantity.transform !== "identity") return size;
  return quantity.scale === null ? NaN : Math.max(size, 1);
}

// Compares values with the check points.
function compare(checks, quantities, evaluate) {
  checks.forEach(({ point, values }, number) => {
    const found = evaluate(point);
    quantities.forEach((quantity, q) => {
      const { name } = quantity;
      if (Math.abs(found[q] - values[q]) <= near * sizeOf(quantity, q, values)) return;
      throw damaged(`${name} at check point ${number + 1} is ${found[q]}, and the file says ${values[q]}`);
    });
  });
}

// A surface, from the object that its JSON is. `evaluate` and `derivatives` take a point, as a list in the order of
// the axes or an object with a value of each. They give objects: each quantity, and for each quantity its derivative
// with respect to each axis, NaN at the end 0 of a compact axis. A point outside is a RangeError. `line` takes the name
// of an axis and a point, and gives a function of the coordinate on that axis, which is fast. `errors` takes what
// `evaluate` gives, and says how far off each quantity may be: its largest measured error there, NaN where that is not
// known.
//
// An axis has functions there and back between its values and places from 0 to 1, in which the surface is smooth:
// `place(x)` and `value(place)`.
export function readSurface(file) {
  if (file?.format !== known) {
    throw new Error(`the format is \`${file?.format}\`, and this reader knows \`${known}\`; take one that fits it`);
  }
  const axes = file.axes.map(axisOf);
  if (!(axes.length >= 1 && axes.length <= 3)) throw damaged(`${axes.length} axes, and one to three are possible`);
  const quantities = [];
  file.quantities.forEach((record) => quantities.push(quantityOf(record, quantities, axes)));
  const evaluator = evaluatorOf(axes, quantities);
  compare(file.checks, quantities, (point) => evaluator.values(coordinatesOf(axes, point)));
  const named = (list, of) => Object.fromEntries(list.map(({ name }, place) => [name, of(place)]));
  const { title, tolerance, certificate } = file;
  return {
    ...{ title, tolerance },
    axes: axes.map(({ name, units, longName, map, from, to, place, value }) => {
      return { ...{ name, units, longName, map, from, to }, place, value };
    }),
    quantities: quantities.map(({ name, units, scale, longName }) => ({ name, units, scale, longName })),
    certificate: { ...certificate, errors: named(quantities, (q) => certificate.errors[q]) },
    evaluate(point) {
      const values = evaluator.values(coordinatesOf(axes, point));
      return named(quantities, (q) => values[q]);
    },
    line(name, point) {
      const along = axes.findIndex((axis) => axis.name === name);
      if (along < 0) throw new RangeError(`there is no axis ${name}`);
      const values = evaluator.line(along, coordinatesOf(axes, point));
      return (x) => {
        checkInside(axes[along], x);
        const found = values(x);
        return named(quantities, (q) => found[q]);
      };
    },
    errors(values) {
      const list = quantities.map(({ name }) => values[name]);
      return named(quantities, (q) => certificate.errors[q].largest * errorScale(quantities[q], q, list));
    },
    derivatives(point) {
      const slopes = evaluator.derivatives(coordinatesOf(axes, point));
      return named(quantities, (q) => named(axes, (m) => slopes[m][q]));
    },
  };
}
