// The rows of the table as a CSV file: the values of the axes, and the numbers of the page.

import { reasonOf } from "./case.js";
import { column, columns } from "./columns.js";
import { contents } from "./contents.js";
import { axisWords, caseOf, failedAt } from "./grid.js";
import { plain } from "./numbers.js";
import { axisValue, outcomeOf } from "./rows.js";

const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

// Values of axes have all their digits.
const axisText = (value) => quoted(value === Infinity ? "inf" : String(value));

function tableText(places) {
  const names = [...columns.keys()];
  const named = [0, 1, 2].filter((axis) => axisWords[axis].name);
  const line = (place) => [
    contents.cases[caseOf[place]],
    ...named.map((axis) => axisText(axisValue(axis, place))),
    outcomeOf(place),
    failedAt[place] ? quoted(reasonOf(place)) : "",
    ...names.map((name) => plain(column(name)[place])),
  ];
  const head = ["case", ...named.map((axis) => axisWords[axis].name), "status", "reason", ...names];
  return [head, ...places.map(line)].map((cells) => `${cells.join(",")}\n`).join("");
}

// Has the browser save the rows of these places.
export function downloadTable(places) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([tableText(places)], { type: "text/csv" }));
  link.download = "cases.csv";
  link.click();
  // The browser has taken the text when the click returns; the address is let go of later, as some read it in between.
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
