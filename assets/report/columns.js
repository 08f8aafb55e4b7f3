// The numbers of each place: the columns of summary.csv, the largest error, and what the case cost.

import { contents, floats, integers } from "./contents.js";
import { failedAt, placeCount } from "./grid.js";

// The friction that is shown first: of an experiment the drag, which an instrument reads, else the total of the paper.
export const headline = contents.laboratory ? "mu_drag" : "mu_tot";

// Each column is decoded when it is first asked for.
export const columns = new Map(contents.columns.map((part) => [part.name, { ...part, decoded: null }]));

// The hysteresis that is a part of the drag: that of the flat, which is all of it where the roller has none (T54).
export const hysteresis = columns.has("mu_v_flat") ? "mu_v_flat" : "mu_v";

// The parts of the headline.
export const frictionParts = contents.laboratory
  ? [hysteresis, "mu_shear", "mu_pressure"]
  : ["mu_v", "mu_h", "mu_drag"];

export function column(name) {
  const found = columns.get(name);
  found.decoded ??= floats(found.values);
  return found.decoded;
}

// The largest of the estimated errors of each place; NaN if one is not known.
const errorColumns = ["error_mu_v", "error_mu_h", "error_c", "error_mu_drag"].map(column);
export const largestErrors = Float32Array.from({ length: placeCount }, (_, place) =>
  // Math.max is NaN if one of its numbers is.
  Math.max(...errorColumns.map((errors) => errors[place])),
);

export const costs = contents.costs && {
  seconds: floats(contents.costs.seconds),
  iterations: floats(contents.costs.iterations),
  seedOf: integers(contents.costs.seed),
};

// Pictures over the axes have holes for failed cases; the scatter shows what these cost.
const solvedOnly = (values) => values.map((value, place) => (failedAt[place] ? NaN : value));
const solvedCosts = costs && { seconds: solvedOnly(costs.seconds), iterations: solvedOnly(costs.iterations) };

// The quantities that surface, map and curves can show, in the order of the list.
export const quantities = [
  headline,
  ...frictionParts,
  ...(contents.laboratory ? ["mu_tot", "mu_h"] : ["mu_shear", "mu_pressure"]),
  ...(contents.laboratory && hysteresis !== "mu_v" ? ["mu_v"] : []),
  ...["mu_h_cavity", "c", "film_min", "p_max", "x_outlet", "largest_error", "load_residual"],
  ...["dry_mu_v", "approx_mu_h"],
  ...(contents.laboratory ? ["alpha", "beta"] : []),
  ...(costs ? ["seconds", "iterations"] : []),
];

// The numbers of such a quantity, one for each place.
export function quantityValues(name) {
  if (name === "largest_error") return largestErrors;
  if (name === "seconds" || name === "iterations") return solvedCosts[name];
  return column(name);
}
