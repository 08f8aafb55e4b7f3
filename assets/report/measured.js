// Measured points of the quantity, as diamonds with their standard errors.

import { positionOn } from "./axes.js";
import { contents } from "./contents.js";
import { errorBars } from "./errors.js";
import { axisWords, coordinatesOf } from "./grid.js";
import { digits } from "./numbers.js";
import { colour } from "./theme.js";

// What is known of the experiment at a place: quantities that are one number, and quantities of the axes by name.
export const quantitiesAt = (place) => ({ ...contents.fixed, ...Object.fromEntries(coordinatesOf(place)) });

// Measured points that belong to the curve along this axis through the place: where the file says so, points that were
// measured elsewhere belong to other curves.
function rowsOnCurve(place, axis) {
  const { coordinates } = contents.measured;
  const { name: along } = axisWords[axis];
  const same = (one, other) => one === other || Math.abs(Math.log(one / other)) < 0.01;
  const own = Object.entries(quantitiesAt(place)).filter(([name]) => name !== along && coordinates[name]);
  const belongs = (i) => own.every(([name, value]) => same(coordinates[name][i], value));
  return coordinates[along].map((_, i) => i).filter(belongs);
}

// Traces of the measured points on the curve along an axis; none where the points do not say how they lie along it.
export function measuredPoints({ quantity, place }, axis, scale) {
  const { measured } = contents;
  const along = measured?.coordinates[axisWords[axis].name];
  if (!along || measured.column !== quantity) return [];
  const rows = rowsOnCurve(place, axis);
  const friction = rows.map((i) => measured.friction[i]);
  const errors = measured.errors && rows.map((i) => measured.errors[i]);
  const y = friction.map(scale.to);
  const text = friction.map((value, i) => `measured ${digits(value)}${errors ? ` ± ${digits(errors[i], 2)}` : ""}`);
  return [
    {
      ...{ type: "scatter", mode: "markers", x: rows.map((i) => positionOn(axis, along[i])), y, text },
      hovertemplate: "%{text}<extra></extra>",
      marker: { symbol: "diamond-open", size: 8, color: colour("--text"), line: { width: 1.5 } },
      ...(errors ? { error_y: errorBars(friction, errors, scale) } : {}),
    },
  ];
}
