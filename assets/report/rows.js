// The rows of the table of all cases: what stands in them, filtered and sorted.

import { column, costs, frictionParts, headline, largestErrors } from "./columns.js";
import { contents } from "./contents.js";
import { axes, axisWords, failedAt, indicesOf, placeCount } from "./grid.js";
import { headOf, pointWords, unitsOf } from "./words.js";

// A value of an axis at a place; in words where several quantities are taken together.
function axisValue(axis, place) {
  const index = indicesOf(place)[axis];
  return axisWords[axis].combinations[index] ?? axes[axis][index];
}

export const outcomeOf = (place) => (failedAt[place] ? "failed" : "converged");

function axisColumn(axis) {
  const { name, symbol, unit } = axisWords[axis];
  return { name, title: symbol, units: unit, of: (place) => axisValue(axis, place) };
}

const numberColumns = [headline, ...frictionParts, "c", "film_min", "p_max", "x_outlet"];

// In a laboratory numbers have their units beside them; otherwise these stand in the head.
const unitsIn = (name) => (contents.laboratory ? unitsOf(name) : "");

// The columns of the table: name, title, what a place has in it, and the unit of that.
export const tableColumns = [
  ...[0, 1, 2].filter((axis) => axisWords[axis].symbol).map(axisColumn),
  { name: "status", title: "status", of: outcomeOf },
  ...numberColumns.map((name) => {
    return { name, title: headOf(name), units: unitsIn(name), of: (place) => column(name)[place] };
  }),
  { name: "largest_error", title: "largest error", of: (place) => largestErrors[place] },
  ...(costs ? [{ name: "seconds", title: "time", units: "s", of: (place) => costs.seconds[place] }] : []),
];

// The places whose rows have each part of a filter such as "f = 100, failed".
function filtered(filter) {
  const parts = filter
    .toLowerCase()
    .split(",")
    .map((part) => part.replace(/\s*=\s*/, " = ").trim())
    .filter(Boolean);
  // "f = 10" is not to find f = 100: each part is a whole one of the row. A value may be written without its unit.
  const isValue = (word, part) => word === part || word.startsWith(`${part} `);
  const fits = (place) => {
    const words = `${pointWords(place)}, ${outcomeOf(place)}`.toLowerCase().split(", ");
    return parts.every((part) =>
      words.some((word) => (part.includes("=") ? isValue(word, part) : word.includes(part))),
    );
  };
  return Array.from({ length: placeCount }, (_, place) => place).filter((place) => parts.length === 0 || fits(place));
}

// Puts places into the order of a column. What is not there stands last, whichever way.
function sort(places, name, descending) {
  const { of } = tableColumns.find((one) => one.name === name);
  const keys = new Map(places.map((place) => [place, of(place)]));
  const missing = (key) => typeof key === "number" && Number.isNaN(key);
  places.sort((one, other) => {
    const [a, b] = [keys.get(one), keys.get(other)];
    if (missing(a) || missing(b)) return missing(a) - missing(b) || one - other;
    const order = a < b ? -1 : a > b ? 1 : 0;
    return (descending ? -order : order) || one - other;
  });
}

// The places of all rows that fit the filter, in the order of the column to sort by, if there is one.
export function arrangedPlaces(filter, { name, descending }) {
  const places = filtered(filter);
  if (name) sort(places, name, descending);
  return places;
}
