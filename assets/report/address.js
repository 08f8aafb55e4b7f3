// What is chosen, in the address of the page, such as #quantity=…&scale=…&f=…. A link opens the same view.

import { say } from "./elements.js";

// A number of the address.
export const written = (value) => (value === Infinity ? "inf" : String(value));
export const read = (text) => (text === "inf" ? Infinity : text.trim() === "" ? NaN : Number(text));

const parts = [];

// Adds what a part of the page has in the address: `owns` tells its names, `readFrom` takes over what an address asks
// for and returns what of it the page does not have, `toWrite` returns pairs of names and values.
export const addAddressPart = (part) => parts.push(part);

// Takes over what the address asks for, and says what of it is not in this page. A place of the page, such as #case,
// asks for nothing.
export function readAddress() {
  const address = window.location.hash.slice(1);
  if (address && !address.includes("=")) return;
  const asked = new URLSearchParams(address);
  const missing = parts.flatMap(({ readFrom }) => readFrom(asked));
  const strange = [...asked.keys()].filter((name) => !parts.some(({ owns }) => owns(name)));
  missing.push(...strange.map((name) => `${name} = …`));
  const words = `This link asks for what is not in this page: ${missing.join("; ")}. In its place stands the default.`;
  say("address", missing.length ? words : "");
}

export function writeAddress() {
  const asked = new URLSearchParams(parts.flatMap(({ toWrite }) => toWrite()));
  window.history.replaceState(null, "", `#${asked.toString().replaceAll("%2C", ",")}`);
  say("address", "");
}
