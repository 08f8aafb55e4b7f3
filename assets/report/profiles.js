// The fields of the selected case over x.

import { contents } from "./contents.js";
import { say, show } from "./elements.js";
import { fieldsOf, hasFields } from "./fields.js";
import { failedAt, nearestPlace } from "./grid.js";
import { digits } from "./numbers.js";
import { draw } from "./picture.js";
import { scaleOf } from "./scale.js";
import { lineColours } from "./theme.js";
import { pointWords, unitOf } from "./words.js";

const traction = contents.laboratory ? "Pa" : "N/R";

// For each picture its id, the name of the field, the title of its axis, and its scale.
const pictures = [
  { id: "pressure", name: "pressure", title: `pressure p  (${unitOf("p_max")})`, choice: "linear" },
  { id: "film", name: "film_thickness", title: `film thickness u  (${unitOf("film_min")})`, choice: "auto" },
  {
    id: "displacement",
    name: "displacement",
    title: `height of the surface w  (${unitOf("film_min")})`,
    choice: "linear",
  },
  { id: "shear", name: "shear_traction", title: `shear on the roller  (${traction})`, choice: "linear" },
  { id: "hysteresis", name: "hysteresis_traction", title: `hysteresis (2/π) p w′  (${traction})`, choice: "linear" },
];

// What is not shown as one would expect, given the nearest place with fields and these fields.
function missingWords(place, near, fields) {
  if (failedAt[place]) return "A failed case has no fields.";
  if (!contents.fields) return "The sweep has no fields.";
  const missing = fields ? pictures.filter(({ name }) => !fields[name]).map(({ name }) => name.replace("_", " ")) : [];
  const elsewhere = "The fields of this case are not in this page. These are of the nearest one that has them here";
  return [
    fields && near !== place ? `${elsewhere}: ${pointWords(near)}.` : "",
    missing.length ? `Not among the fields of this sweep: ${missing.join(", ")}.` : "",
  ]
    .join(" ")
    .trim();
}

export function drawFields({ place }) {
  const near = failedAt[place] || !contents.fields ? null : nearestPlace(place, hasFields);
  const fields = near === null ? null : fieldsOf(near);
  say("no-fields", missingWords(place, near, fields));
  show("field-plots", fields !== null);
  if (!fields) return;
  pictures.forEach(({ id, name, title, choice }, i) => {
    const values = fields[name];
    show(id, values !== undefined);
    if (!values) return;
    const scale = scaleOf(values, choice);
    const line = {
      ...{ type: "scatter", mode: "lines", x: fields.x, y: values.map(scale.to) },
      customdata: values.map((value) => digits(value)),
      line: { color: lineColours()[i], width: 2 },
      hovertemplate: "x = %{x:.4g} a₀<br>%{customdata}<extra></extra>",
    };
    const xaxis = { title: { text: "x  (a₀), inlet on the right" } };
    draw(id, [line], { xaxis, yaxis: { title: { text: title }, ...scale.ticks() } });
  });
}
