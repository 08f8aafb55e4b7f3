// The numbers behind pictures of a sweep, as tables.

import { column, columns, quantityValues } from "./columns.js";
import { hasErrors } from "./errors.js";
import { coordinatesOf } from "./grid.js";

// The names and the values of all axes at a place; values have all their digits.
export const axisNames = () => coordinatesOf(0).map(([name]) => name);
export const axisTexts = (place) =>
  coordinatesOf(place).map(([, value]) => (value === Infinity ? "inf" : String(value)));

// The rows of these places: values of the axes, these quantities, and their estimated errors, relative as in
// summary.csv.
export function placesTable(places, names) {
  const errors = names.filter(hasErrors).map((name) => columns.get(name).error);
  const rows = [...new Set(places)].map((place) => [
    ...axisTexts(place),
    ...names.map((name) => quantityValues(name)[place]),
    ...errors.map((name) => column(name)[place]),
  ]);
  return [[...axisNames(), ...names, ...errors], ...rows];
}
