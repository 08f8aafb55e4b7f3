// What is chosen, in the address of the page: #quantity=…&scale=…&f=…&alpha=…&beta=…&pin=…. A link opens the same view.

import { quantities } from "./columns.js";
import { say } from "./elements.js";
import { axes, coordinatesAt, coordinatesOf, placeAt } from "./grid.js";
import { mostPins } from "./pins.js";
import { beginning, selection } from "./selection.js";

const scales = ["auto", "linear", "log"];

const written = (value) => (value === Infinity ? "inf" : String(value));
const read = (text) => (text === "inf" ? Infinity : text.trim() === "" ? NaN : Number(text));

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

// What an address asks for, as far as the page has it, and what the page does not have.
function understood(address) {
  const asked = new URLSearchParams(address);
  const missing = [];
  const known = (name, values) => {
    const value = asked.get(name) ?? beginning[name];
    if (values.includes(value)) return value;
    missing.push(`${name} = ${value}`);
    return beginning[name];
  };
  const own = Object.fromEntries(coordinatesOf(beginning.place));
  const given = Object.keys(own).filter((name) => asked.has(name));
  const place = placeOf({ ...own, ...Object.fromEntries(given.map((name) => [name, read(asked.get(name))])) });
  const absent = given.filter((name) => !isOnAxis(name, read(asked.get(name))));
  missing.push(...absent.map((name) => `${name} = ${asked.get(name)}`));
  const pins = [];
  for (const text of asked.getAll("pin")) {
    const pin = pinOf(text);
    if (pin !== null && (pins.includes(pin) || pins.length < mostPins)) pins.push(pin);
    else missing.push(`pin = ${text}`);
  }
  const names = ["quantity", "scale", "pin", ...Object.keys(own)];
  missing.push(...[...asked.keys()].filter((name) => !names.includes(name)).map((name) => `${name} = …`));
  const view = { quantity: known("quantity", quantities), scale: known("scale", scales) };
  return { view: { ...view, place: place ?? beginning.place, pins: [...new Set(pins)] }, missing };
}

// Takes over what the address asks for, and says what of it is not in this page. A place of the page, such as #case,
// asks for nothing.
export function readAddress() {
  const address = window.location.hash.slice(1);
  if (address && !address.includes("=")) return;
  const { view, missing } = understood(address);
  Object.assign(selection, view);
  const words = `This link asks for what is not in this page: ${missing.join("; ")}. In its place stands the default.`;
  say("address", missing.length ? words : "");
}

export function writeAddress() {
  const { quantity, scale, place, pins } = selection;
  const asked = new URLSearchParams({ quantity, scale });
  for (const [name, value] of coordinatesOf(place)) asked.append(name, written(value));
  for (const pin of pins) asked.append("pin", coordinatesOf(pin).map(([, value]) => written(value)).join(","));
  window.history.replaceState(null, "", `#${asked.toString().replaceAll("%2C", ",")}`);
  say("address", "");
}
