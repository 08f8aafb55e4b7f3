// Estimated errors of the numbers, and the bars that show them where they can be seen.

import { column, columns } from "./columns.js";
import { digits } from "./numbers.js";
import { colour } from "./theme.js";

// Half a bar over the height of the curves from which on it is drawn: about the width of a line.
const visible = 0.005;

// What a curve is taken to span at least, in decades or over its value: bars of one that is constant are no news.
const flat = 0.01;

// What the estimated error of a column is over: its value; μᵥ may be next to nothing beside the other friction.
function errorScale(name, place) {
  const own = Math.abs(column(name)[place]);
  if (name !== "mu_v") return own;
  const sum = ["mu_v", "mu_shear", "mu_pressure"].reduce((total, part) => total + column(part)[place], 0);
  return Math.max(own, 1e-3 * Math.abs(sum));
}

export const hasErrors = (name) => Boolean(columns.get(name)?.error);

// The estimated error of a column at a place, in its unit; NaN where none is known.
export function errorAt(name, place) {
  return hasErrors(name) ? column(columns.get(name).error)[place] * errorScale(name, place) : NaN;
}

// Bars of these errors. Given what the curves of the picture span on its scale, those that cannot be seen are left out.
// On a logarithmic scale a bar that would reach zero ends at a thousandth of its value.
export function errorBars(values, errors, scale, span = null) {
  const isSeen = (value, error) => {
    if (span === null) return true;
    const half = scale.to(value + error) - scale.to(value);
    return half > visible * Math.max(span, scale.logarithmic ? flat : flat * Math.abs(scale.to(value)));
  };
  const array = [];
  const arrayminus = [];
  values.forEach((value, i) => {
    const seen = isSeen(value, errors[i]);
    const least = Math.max(value - errors[i], scale.logarithmic ? value / 1e3 : -Infinity);
    array.push(seen ? scale.to(value + errors[i]) - scale.to(value) : null);
    arrayminus.push(seen ? scale.to(value) - scale.to(least) : null);
  });
  return { type: "data", symmetric: false, array, arrayminus, color: colour("--text"), thickness: 1, width: 3 };
}

// What is said of the bars of curves: where none can be seen, how large the errors are at most.
export function errorWords(bars, values, errors) {
  if (bars.some(({ array }) => array.some((half) => half !== null))) {
    return "Bars are estimated errors, where they are wider than a line.";
  }
  const most = (list) => list.reduce((found, value) => (Math.abs(value) > found ? Math.abs(value) : found), 0);
  const share = most(errors) / most(values);
  return share > 0 ? `Estimated errors are too small to be seen: at most ${digits(100 * share, 2)} %.` : "";
}
