// Tables as CSV, and files that the browser saves.

import { plain } from "./numbers.js";

const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

// Rows of cells as CSV; numbers to seven digits.
export function csv(rows) {
  const cell = (value) => (typeof value === "number" ? plain(value) : quoted(value));
  return rows.map((cells) => `${cells.map(cell).join(",")}\n`).join("");
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
