// The surface of the page, and what its quantities are called.

import { readSurface } from "../surface.js";
import { element } from "./elements.js";
import { digits } from "./numbers.js";
import { symbols } from "./symbols.js";
import { withUnit } from "./units.js";

const contentsOf = (id) => JSON.parse(element(id).textContent);

let kept = null;

// The surface, read when it is first asked for. Throws an error if its check points do not hold.
export function surface() {
  kept ??= readSurface(contentsOf("surface-file"));
  return kept;
}

let keptWords = null;

// What axes and quantities are called, by their names.
export function words() {
  keptWords ??= contentsOf("surface-words");
  return keptWords;
}

const quantityOf = (name) => surface().quantities.find((one) => one.name === name);

// What a number of a quantity is in: a unit, or the scale that it is over.
export const unitsOf = (name) => quantityOf(name).scale ?? quantityOf(name).units;

export const wordsOf = (name) => words().quantities[name];
export const symbolOf = (name) => symbols[name] ?? name;

export const isFriction = (name) => name.startsWith("mu_");

// The names of all quantities: the drag and the other friction first.
export function quantityNames() {
  const names = surface().quantities.map(({ name }) => name);
  const friction = names.filter((name) => isFriction(name) && name !== "mu_drag");
  return [...names.filter((name) => name === "mu_drag"), ...friction, ...names.filter((name) => !isFriction(name))];
}

// How many digits of a number its error leaves.
function digitsBeside(value, error) {
  if (!(error > 0) || value === 0) return 5;
  return Math.min(Math.max(Math.ceil(-Math.log10(error / Math.abs(value))) + 1, 1), 9);
}

// A number of a quantity with its unit and its error: 0.72338 ± 3.2·10⁻⁴ a₀/R. One that is nothing beside its error
// is 0. Where only its relative error is known, that stands there: −1.3 mm ± 0.1 %.
export function withError(name, value, error) {
  if (Number.isNaN(error)) {
    const { largest } = surface().certificate.errors[name];
    return `${withUnit(value, unitsOf(name), { count: digitsBeside(1, largest) })} ± ${digits(100 * largest, 2)} %`;
  }
  const shown = Math.abs(value) < 0.005 * error ? 0 : value;
  return withUnit(shown, unitsOf(name), { count: digitsBeside(shown, error), error });
}
