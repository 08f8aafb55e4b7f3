// Where values stand on axes. α and β are shown in their logarithm; 0 and ∞ have places of their own beyond the ends.

function positions(values) {
  const finite = values.filter((value) => value > 0 && value < Infinity).map(Math.log10);
  const low = finite.length ? Math.min(...finite) : 0;
  const high = finite.length ? Math.max(...finite) : 0;
  const gap = Math.max(0.08 * (high - low), 0.25);
  return values.map((value) => (value === 0 ? low - gap : value === Infinity ? high + gap : Math.log10(value)));
}

const alphaPlaces = positions(alphas);
const betaPlaces = positions(betas);
const fPlaces = positions(fs);

// Labelled places of a logarithmic axis between two logarithms: decades, or 1, 2 and 5 of each where there are few.
function logTicks(low, high) {
  const values = [];
  const text = [];
  const decades = Math.floor(high + 1e-9) - Math.ceil(low - 1e-9) + 1;
  const step = Math.max(1, Math.ceil(decades / 8));
  for (let power = Math.floor(low); power <= high + 1e-9; power++) {
    for (const digit of decades >= 3 ? [1] : decades >= 1 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9]) {
      const place = power + Math.log10(digit);
      const labelled = decades < 3 || power % step === 0;
      if (place < low - 1e-9 || place > high + 1e-9 || !labelled) continue;
      values.push(place);
      text.push(decades >= 3 ? decade(power) : digits(digit * 10 ** power));
    }
  }
  return { values, text };
}

function gridAxis(values, places, title) {
  const finite = places.filter((_, i) => values[i] > 0 && values[i] < Infinity);
  const { values: tickvals, text: ticktext } = finite.length ? logTicks(Math.min(...finite), Math.max(...finite)) : { values: [], text: [] };
  // One value alone may have no round place.
  if (finite.length && !tickvals.length) {
    tickvals.push(finite[0]);
    ticktext.push(digits(10 ** finite[0]));
  }
  values.forEach((value, i) => {
    if (value !== 0 && value !== Infinity) return;
    tickvals.push(places[i]);
    ticktext.push(value === 0 ? "0" : "∞");
  });
  return { title: { text: title }, tickmode: "array", tickvals, ticktext, tickangle: 0 };
}

const alphaAxis = () => gridAxis(alphas, alphaPlaces, axisWords[1].label);
const betaAxis = () => gridAxis(betas, betaPlaces, axisWords[2].label);

const nearest = (places, wanted) =>
  places.reduce((best, place, i) => (Math.abs(place - wanted) < Math.abs(places[best] - wanted) ? i : best), 0);

// How numbers are shown: as they are, or in their logarithm with ticks that read as the numbers.
function scaleOf(values, choice) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  const possible = low > 0 && high < Infinity;
  const logarithmic = possible && (choice === "log" || (choice === "auto" && high > 30 * low));
  const to = logarithmic ? (value) => (value > 0 ? Math.log10(value) : NaN) : (value) => value;
  const ticks = () => {
    if (!logarithmic) return {};
    const { values: tickvals, text: ticktext } = logTicks(Math.log10(low), Math.log10(high));
    return tickvals.length > 1 ? { tickmode: "array", tickvals, ticktext } : {};
  };
  return { logarithmic, to, ticks, empty: low > high, low, high };
}
