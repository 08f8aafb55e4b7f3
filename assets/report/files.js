// Tables as CSV, and files that the browser saves.

import { column, columns, quantityValues } from "./columns.js";
import { hasErrors } from "./errors.js";
import { coordinatesOf } from "./grid.js";
import { plain } from "./numbers.js";

const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

// Rows of cells as CSV; numbers to seven digits.
export function csv(rows) {
  const cell = (value) => (typeof value === "number" ? plain(value) : quoted(value));
  return rows.map((cells) => `${cells.map(cell).join(",")}\n`).join("");
}

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

// Has the browser save a file.
export function saveFile(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has taken the text when the click returns; the address is let go of later, as some read it in between.
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
