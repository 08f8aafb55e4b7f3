// Where the values of the grid stand on the axes of pictures: at their logarithms; 0 and ∞ stand beyond the ends.
// An axis with values below 0 is linear.

import { axes, axisWords } from "./grid.js";
import { digits } from "./numbers.js";
import { logTicks } from "./ticks.js";

const isLogarithmic = (value) => value > 0 && value < Infinity;

const isLinear = (values) => values.some((value) => value < 0);

function positions(values) {
  if (isLinear(values)) return values;
  const finite = values.filter(isLogarithmic).map(Math.log10);
  const low = finite.length ? Math.min(...finite) : 0;
  const high = finite.length ? Math.max(...finite) : 0;
  const gap = Math.max(0.08 * (high - low), 0.25);
  return values.map((value) => (value === 0 ? low - gap : value === Infinity ? high + gap : Math.log10(value)));
}

// The positions of the values of f, α and β.
export const axisPlaces = axes.map(positions);

// The axis of a picture over the values of an axis of the grid.
export function gridAxis(axis) {
  const [values, places] = [axes[axis], axisPlaces[axis]];
  if (isLinear(values)) return { title: { text: axisWords[axis].label }, tickangle: 0 };
  const finite = places.filter((_, i) => isLogarithmic(values[i]));
  const ticks = finite.length ? logTicks(Math.min(...finite), Math.max(...finite)) : { values: [], text: [] };
  const { values: tickvals, text: ticktext } = ticks;
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
  return { title: { text: axisWords[axis].label }, tickmode: "array", tickvals, ticktext, tickangle: 0 };
}

// The index of the value of an axis whose position is nearest to the wanted one.
export function nearestIndex(axis, wanted) {
  const places = axisPlaces[axis];
  const distance = (i) => Math.abs(places[i] - wanted);
  return places.reduce((best, _, i) => (distance(i) < distance(best) ? i : best), 0);
}
