// The fields of the selected case and of the pinned ones over x.

import { contents } from "./contents.js";
import { say, show, showPicture } from "./elements.js";
import { fieldsOf, hasFields } from "./fields.js";
import { failedAt, nearestPlace } from "./grid.js";
import { draw } from "./picture.js";
import { comparedCases } from "./pins.js";
import { scaleOf } from "./scale.js";
import { withUnit } from "./units.js";
import { pointWords } from "./words.js";

// For each picture its id, the name of the field, and its scale.
const pictures = [
  { id: "pressure", name: "pressure", choice: "linear" },
  { id: "film", name: "film_thickness", choice: "auto" },
  { id: "displacement", name: "displacement", choice: "linear" },
  { id: "shear", name: "shear_traction", choice: "linear" },
  { id: "hysteresis", name: "hysteresis_traction", choice: "linear" },
];

// A compared case with the fields of the nearest place that has some; a failed case has none.
function withFields(one) {
  const near = failedAt[one.place] || !contents.fields ? null : nearestPlace(one.place, hasFields);
  return { ...one, near, fields: near === null ? null : fieldsOf(near) };
}

// What is not shown as one would expect.
function missingWords(cases) {
  if (!contents.fields) return "The sweep has no fields.";
  const known = contents.fields.fields;
  const missing = pictures.filter(({ name }) => !known[name]).map(({ name }) => name.replace("_", " "));
  const words = cases.map(({ place, name, near }, i) => {
    const whose = i ? name : "this case";
    if (failedAt[place]) return i ? `${name} failed and has no fields.` : "A failed case has no fields.";
    if (near === place) return "";
    const elsewhere = `The fields of ${whose} are not in this page. These are of the nearest one that has them here`;
    return `${elsewhere}: ${pointWords(near)}.`;
  });
  if (missing.length) words.push(`Not among the fields of this sweep: ${missing.join(", ")}.`);
  return words.filter(Boolean).join(" ");
}

// The rows of the table behind a picture: all points of all cases.
function tableRows(shown, name) {
  const rows = shown.flatMap(({ near, fields }) =>
    fields.x.map((x, i) => [pointWords(near), x, fields[name][i]]),
  );
  return [["case", "x", name], ...rows];
}

function drawField({ id, name, choice }, shown) {
  const { words, units } = contents.fields.fields[name];
  const scale = scaleOf(shown.flatMap(({ fields }) => fields[name]), choice, units);
  const lines = shown.map(({ name: whose, fields, line }) => ({
    ...{ type: "scatter", mode: "lines", x: fields.x, y: fields[name].map(scale.to), name: whose, line },
    customdata: fields[name].map((value) => withUnit(value, units)),
    hovertemplate: `x = %{x:.4g} a₀<br>%{customdata}<extra>${shown.length > 1 ? whose : ""}</extra>`,
  }));
  const look = {
    xaxis: { title: { text: "x  (a₀), inlet on the right" } },
    yaxis: { title: { text: scale.title(words) }, ...scale.ticks() },
    showlegend: shown.length > 1,
    legend: { orientation: "h", y: 1.02, yanchor: "bottom" },
    margin: { l: 60, r: 15, t: shown.length > 1 ? 30 : 10, b: 50 },
  };
  draw(id, lines, look, () => tableRows(shown, name));
}

export function drawFields(selection) {
  const cases = comparedCases(selection).map(withFields);
  const shown = cases.filter(({ fields }) => fields !== null);
  say("no-fields", missingWords(cases));
  show("field-plots", shown.length > 0);
  for (const picture of pictures) {
    const there = shown.length > 0 && picture.name in contents.fields.fields;
    showPicture(picture.id, there);
    if (there) drawField(picture, shown);
  }
}
