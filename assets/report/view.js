// What is chosen of a sweep, in the address of the page: quantity=…&scale=…&f=…&alpha=…&beta=…&pin=….

import { addAddressPart, read, written } from "./address.js";
import { quantities } from "./columns.js";
import { axes, coordinatesAt, coordinatesOf, placeAt } from "./grid.js";
import { mostPins } from "./pins.js";
import { beginning, selection } from "./selection.js";

const scales = ["auto", "linear", "log"];

const near = (one, other) => one === other || Math.abs(one - other) <= 1e-6 * Math.abs(other);

// True if some index of an axis has this value of the quantity of this name.
const isOnAxis = (name, wanted) =>
  axes.some((values, axis) =>
    values.some((_, i) => coordinatesAt(axis, i).some(([other, value]) => other === name && near(wanted, value))),
  );

// The place with these values by their names; null if there is none.
function placeOf(wanted) {
  const indices = axes.map((values, axis) =>
    values.findIndex((_, i) => coordinatesAt(axis, i).every(([name, value]) => near(wanted[name], value))),
  );
  return indices.includes(-1) ? null : placeAt(...indices);
}

function pinOf(text) {
  const values = text.split(",").map(read);
  const names = coordinatesOf(0).map(([name]) => name);
  return values.length === names.length ? placeOf(Object.fromEntries(names.map((name, i) => [name, values[i]]))) : null;
}

const axisNames = coordinatesOf(beginning.place).map(([name]) => name);
const names = ["quantity", "scale", "pin", ...axisNames];

// What an address asks for, as far as the page has it, and what the page does not have.
function understood(asked) {
  const missing = [];
  const known = (name, values) => {
    const value = asked.get(name) ?? beginning[name];
    if (values.includes(value)) return value;
    missing.push(`${name} = ${value}`);
    return beginning[name];
  };
  const own = Object.fromEntries(coordinatesOf(beginning.place));
  const given = axisNames.filter((name) => asked.has(name));
  const place = placeOf({ ...own, ...Object.fromEntries(given.map((name) => [name, read(asked.get(name))])) });
  const absent = given.filter((name) => !isOnAxis(name, read(asked.get(name))));
  missing.push(...absent.map((name) => `${name} = ${asked.get(name)}`));
  const pins = [];
  for (const text of asked.getAll("pin")) {
    const pin = pinOf(text);
    if (pin !== null && (pins.includes(pin) || pins.length < mostPins)) pins.push(pin);
    else missing.push(`pin = ${text}`);
  }
  const view = { quantity: known("quantity", quantities), scale: known("scale", scales) };
  return { view: { ...view, place: place ?? beginning.place, pins: [...new Set(pins)] }, missing };
}

// Adds all this to the address of the page.
export function addView() {
  addAddressPart({
    owns: (name) => names.includes(name),
    readFrom(asked) {
      const { view, missing } = understood(asked);
      Object.assign(selection, view);
      return missing;
    },
    toWrite() {
      const { quantity, scale, place, pins } = selection;
      const own = coordinatesOf(place).map(([name, value]) => [name, written(value)]);
      const pinned = pins.map((pin) => ["pin", coordinatesOf(pin).map(([, value]) => written(value)).join(",")]);
      return [["quantity", quantity], ["scale", scale], ...own, ...pinned];
    },
  });
}
