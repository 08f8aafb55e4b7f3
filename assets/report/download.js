// The rows of the table as a CSV file: the values of the axes, and the numbers of the page.

import { reasonOf } from "./case.js";
import { column, columns } from "./columns.js";
import { contents } from "./contents.js";
import { csv, saveFile } from "./csv.js";
import { axisNames, axisTexts } from "./tables.js";
import { caseOf, failedAt } from "./grid.js";
import { outcomeOf } from "./rows.js";

// Has the browser save the rows of these places.
export function downloadTable(places) {
  const names = [...columns.keys()];
  const line = (place) => [
    contents.cases[caseOf[place]],
    ...axisTexts(place),
    outcomeOf(place),
    failedAt[place] ? reasonOf(place) : "",
    ...names.map((name) => column(name)[place]),
  ];
  const rows = [["case", ...axisNames(), "status", "reason", ...names], ...places.map(line)];
  saveFile(new Blob([csv(rows)], { type: "text/csv" }), "cases.csv");
}
