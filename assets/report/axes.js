// Where the values of the grid stand on the axes of pictures: at their logarithms; 0 and ∞ stand beyond the ends.
// Temperatures, combinations, and axes with values below 0 are linear.

import { axes, axisWords } from "./grid.js";
import { digits } from "./numbers.js";
import { logTicks } from "./ticks.js";
import { takesPrefix, titled, unitFor, withUnit } from "./units.js";

const isLogarithmic = (value) => value > 0 && value < Infinity;

function isLinear(axis) {
  const { name, unit } = axisWords[axis];
  return unit === "K" || name === "combination" || axes[axis].some((value) => value < 0);
}

// The unit of a linear axis.
const linearUnit = (axis) => unitFor(axisWords[axis].unit, Math.max(...axes[axis].map(Math.abs)));

// Where a value stands on an axis, given that it is neither 0 nor ∞ if the axis is logarithmic.
export function positionOn(axis, value) {
  if (!isLinear(axis)) return Math.log10(value);
  const { one, zero } = linearUnit(axis);
  return (value - zero) / one;
}

function positions(axis) {
  const values = axes[axis];
  if (isLinear(axis)) return values.map((value) => positionOn(axis, value));
  const finite = values.filter(isLogarithmic).map(Math.log10);
  const low = finite.length ? Math.min(...finite) : 0;
  const high = finite.length ? Math.max(...finite) : 0;
  const gap = Math.max(0.08 * (high - low), 0.25);
  return values.map((value) => (value === 0 ? low - gap : value === Infinity ? high + gap : Math.log10(value)));
}

// The positions of the values of f, α and β.
export const axisPlaces = [0, 1, 2].map(positions);

// The axis of a picture over the values of an axis of the grid.
export function gridAxis(axis) {
  const [values, places, { label, unit }] = [axes[axis], axisPlaces[axis], axisWords[axis]];
  const words = unit ? label.replace(`  (${unit})`, "") : label;
  if (isLinear(axis)) return { title: { text: titled(words, linearUnit(axis).word) }, tickangle: 0 };
  const finite = places.filter((_, i) => isLogarithmic(values[i]));
  const ticks = finite.length ? logTicks(Math.min(...finite), Math.max(...finite), unit) : { values: [], text: [] };
  const { values: tickvals, text: ticktext } = ticks;
  // One value alone may have no round place.
  if (finite.length && !tickvals.length) {
    tickvals.push(finite[0]);
    ticktext.push(withUnit(10 ** finite[0], unit));
  }
  values.forEach((value, i) => {
    if (value !== 0 && value !== Infinity) return;
    tickvals.push(places[i]);
    ticktext.push(digits(value));
  });
  const title = { text: takesPrefix(unit) ? words : label };
  return { title, tickmode: "array", tickvals, ticktext, tickangle: 0 };
}

// The index of the value of an axis whose position is nearest to the wanted one.
export function nearestIndex(axis, wanted) {
  const places = axisPlaces[axis];
  const distance = (i) => Math.abs(places[i] - wanted);
  return places.reduce((best, _, i) => (distance(i) < distance(best) ? i : best), 0);
}
