// What columns, values of axes and places are called.

import { column, columns, frictionParts, headline, largestErrors } from "./columns.js";
import { contents } from "./contents.js";
import { axes, axisWords, failedAt, indicesOf } from "./grid.js";
import { digits } from "./numbers.js";
import { symbols } from "./symbols.js";
import { titled, unitFor, withUnit } from "./units.js";

// Quantities that are no column.
const others = {
  largest_error: "largest estimated error",
  seconds: "time to solve a case",
  iterations: "iterations",
};

// A quantity in words, with its symbol, as in all pictures of the program.
export function wordsOf(name) {
  if (name === "alpha") return `α, ${columns.get(name).words}`;
  if (name === "beta") return `β, ${columns.get(name).words}`;
  return columns.get(name)?.words ?? others[name];
}

export const unitsOf = (name) => (name === "seconds" ? "s" : (columns.get(name)?.units ?? "1"));

// A number of a quantity with its unit.
export const valueOf = (name, value, look) => withUnit(value, unitsOf(name), look);

// The short name of a column with the unit that all of them share; in a laboratory each number has its own.
export const headOf = (name) => titled(symbols[name], contents.laboratory ? "" : unitFor(unitsOf(name), 1).word);

// The name of a value on an axis: "β = 100", "V = 0.5 mm/s"; nothing for an axis without a symbol.
export function valueWords(axis, value) {
  const { symbol, unit } = axisWords[axis];
  return symbol ? `${symbol} = ${withUnit(value, unit)}` : "";
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
  const number = (name) => `${symbols[name]} = ${valueOf(name, column(name)[place])}`;
  return [
    pointWords(place),
    [headline, ...frictionParts].map(number).join(", "),
    number("film_min"),
    `largest estimated error ${digits(largestErrors[place], 2)}`,
  ].join("<br>");
}
