// Where the reader is on the surface: a point, one that is pinned, and the cut through them that is drawn.

import { addAddressPart, read, written } from "./address.js";
import { roundValue } from "./live_axes.js";
import { isFriction, quantityNames, surface } from "./live_surface.js";

// Cuts: along an axis by its name, or the straight way to the pinned point.
export const way = "pin";

// What a cut shows: all friction, or the quantity of this name.
export const allFriction = "friction";

export const scales = ["linear", "log"];

const running = ["speed", "entrainment_speed", "flat_speed", "roller_speed", "beta"];

export const live = {};

// Where the page begins: in the middle of all axes, along the speed.
function beginning() {
  const { axes } = surface();
  const names = axes.map(({ name }) => name);
  const [first] = quantityNames();
  return {
    point: axes.map((_, m) => roundValue(m, 0.5)),
    cut: running.find((name) => names.includes(name)) ?? names[0],
    show: isFriction(first) ? allFriction : first,
    scale: "linear",
    pin: null,
  };
}

export const cuts = () => [...surface().axes.map(({ name }) => name), ...(live.pin ? [way] : [])];
export const shows = () => {
  const names = quantityNames();
  const others = names.filter((name) => !isFriction(name));
  return names.some(isFriction) ? [allFriction, ...others] : others;
};

const isOn = ({ from, to }, x) => from <= x && x <= to;

// Takes over what an address asks for, and returns what of it the surface does not have.
function take(asked) {
  const { axes } = surface();
  const missing = [];
  const start = beginning();
  const known = (name, values) => {
    const value = asked.get(`live.${name}`) ?? start[name];
    if (values.includes(value)) return value;
    missing.push(`${name} = ${value}`);
    return start[name];
  };
  const point = axes.map((axis, m) => {
    const text = asked.get(`live.${axis.name}`);
    if (text === null) return start.point[m];
    if (isOn(axis, read(text))) return read(text);
    missing.push(`${axis.name} = ${text}`);
    return start.point[m];
  });
  const pinned = asked.get("live.pin");
  const pin = pinned === null ? null : pinned.split(",").map(read);
  const isPin = pin === null || (pin.length === axes.length && axes.every((axis, m) => isOn(axis, pin[m])));
  if (!isPin) missing.push(`pin = ${pinned}`);
  Object.assign(live, { point, pin: isPin ? pin : null });
  Object.assign(live, { cut: known("cut", cuts()), show: known("show", shows()), scale: known("scale", scales) });
  const names = ["cut", "show", "scale", "pin", ...axes.map(({ name }) => name)].map((name) => `live.${name}`);
  const strange = [...asked.keys()].filter((name) => name.startsWith("live.") && !names.includes(name));
  return [...missing, ...strange.map((name) => `${name} = …`)];
}

// What the address asks for.
let asked = new URLSearchParams();

// What of this is not as the page begins.
function changed() {
  if (!live.point) return [...asked].filter(([name]) => name.startsWith("live."));
  const start = beginning();
  const { axes } = surface();
  const own = axes.map(({ name }, m) => [name, live.point[m], start.point[m]]);
  const choices = ["cut", "show", "scale"].map((name) => [name, live[name], start[name]]);
  const pairs = [...own, ...choices].filter(([, value, first]) => value !== first);
  if (live.pin) pairs.push(["pin", live.pin.map(written).join(",")]);
  return pairs.map(([name, value]) => [`live.${name}`, typeof value === "number" ? written(value) : value]);
}

// Adds all this to the address of the page; `follow` is called when another address asks for something. An address that
// asks before the surface is read waits.
export function addLivePoint(follow) {
  addAddressPart({
    owns: (name) => name.startsWith("live."),
    readFrom(address) {
      asked = address;
      if (live.point) follow();
      return [];
    },
    toWrite: changed,
  });
}

// Goes where the address asks for, and returns what of it the surface does not have.
export const goToAddress = () => take(asked);
