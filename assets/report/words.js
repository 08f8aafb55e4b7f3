// What columns, units, values of axes and places are called.

import { column, columns, frictionParts, headline, largestErrors } from "./columns.js";
import { axes, axisWords, failedAt, indicesOf } from "./grid.js";
import { digits } from "./numbers.js";

export const symbols = {
  mu_v: "μᵥ",
  mu_h: "μₕ",
  mu_tot: "μₜₒₜ",
  mu_drag: "drag",
  mu_pressure: "P",
  mu_shear: "C",
  error_mu_drag: "error of drag",
  mu_h_cavity: "μₕ, cavity",
  c: "c",
  film_min: "uₘᵢₙ",
  p_max: "pₘₐₓ",
  x_outlet: "xₒᵤₜ",
  error_mu_v: "error of μᵥ",
  error_mu_h: "error of μₕ",
  error_c: "error of c",
  load_residual: "load residual",
  dry_mu_v: "μᵥ, dry",
  approx_mu_h: "μₕ, large β",
  alpha: "α",
  beta: "β",
  largest_error: "largest estimated error",
  seconds: "seconds",
  iterations: "iterations",
};

const unitWords = {
  1: "",
  a0: "a₀",
  "a0/R": "a₀/R",
  "a0^2/R": "a₀²/R",
  "2N/(pi a0)": "2N/(πa₀)",
  "N/R": "N/R",
  m: "m",
  Pa: "Pa",
};

export function unitOf(name) {
  if (name === "seconds") return "s";
  return columns.has(name) ? unitWords[columns.get(name).units] : "";
}

// The long name of a column, with symbols for names of columns.
export function longName(name) {
  const words = columns.get(name)?.long_name ?? symbols[name];
  const names = { mu_v: "μᵥ", mu_h: "μₕ", beta: "β" };
  return words.replace(/\b(mu_v|mu_h|beta)\b/g, (found) => names[found]);
}

// The title of an axis that a column stands on: its symbol and its unit.
export function axisName(name) {
  const unit = unitOf(name);
  return unit ? `${symbols[name]}  (${unit})` : symbols[name];
}

// The name of a value on an axis: "β = 100", "V = 0.001 m/s"; nothing for an axis without a symbol.
export function valueWords(axis, value) {
  const { symbol, unit } = axisWords[axis];
  return symbol ? `${symbol} = ${digits(value)}${unit ? ` ${unit}` : ""}` : "";
}

// The same for a value shown, by its index; where several quantities are taken together, what it stands for.
export const wordsAt = (axis, index) => axisWords[axis].combinations[index] ?? valueWords(axis, axes[axis][index]);

export const pointWords = (place) =>
  indicesOf(place)
    .map((index, axis) => wordsAt(axis, index))
    .filter(Boolean)
    .join(", ");

// What is said when the pointer rests on a place.
export function hoverWords(place) {
  if (failedAt[place]) return `${pointWords(place)}<br>failed`;
  const number = (name) => `${symbols[name]} ${digits(column(name)[place])}`;
  return [
    pointWords(place),
    `${[headline, ...frictionParts].map(number).join(", ")}  ${unitOf(headline)}`,
    `${number("film_min")}  ${unitOf("film_min")}`,
    `largest estimated error ${digits(largestErrors[place], 2)}`,
  ].join("<br>");
}
