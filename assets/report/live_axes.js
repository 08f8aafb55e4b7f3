// The axes of the surface: values in words and out of words, and where they stand in a picture. A logarithmic axis of
// the surface is one in the picture too. One that reaches 0 or ∞ is drawn in the coordinate in which the surface is
// smooth.

import { surface, words } from "./live_surface.js";
import { decade, digits } from "./numbers.js";
import { logTicks } from "./ticks.js";
import { takesPrefix, titled, unitFor, withUnit } from "./units.js";

// Steps of a slider.
export const steps = 1000;

// Sliders give values of so many digits, or as many more as tell their steps apart. These stand beside them.
export const kept = 4;

const axisAt = (m) => surface().axes[m];
const unitOf = (m, x) => unitFor(axisAt(m).units, Math.abs(x === Infinity ? 1 : x));

export const symbolAt = (m) => words().axes[m].symbol;
export const labelAt = (m) => words().axes[m].label;

// A value in words, with its unit, and with its name before it: with all digits that it was given, or with so many.
const all = 12;
export const valueText = (m, x, count = all) => withUnit(x, axisAt(m).units, { count });
export const valueWords = (m, x, count = all) => `${symbolAt(m)} = ${valueText(m, x, count)}`;
export const pointWords = (point, count = all) => point.map((x, m) => valueWords(m, x, count)).join(", ");

// What the surface is over: α from 0 to ∞, β from 10 to 1000.
export const axesWords = () =>
  surface()
    .axes.map(({ from, to }, m) => `${symbolAt(m)} from ${valueText(m, from)} to ${valueText(m, to)}`)
    .join(", ");

// A value near a place between 0 and 1, with few digits in the unit that it is shown in; the ends are exact.
export function roundValue(m, place) {
  const { value, from, to } = axisAt(m);
  const x = value(place);
  if (place <= 0 || place >= 1 || !Number.isFinite(x)) return x;
  const { one, zero } = unitOf(m, x);
  const number = (x - zero) / one;
  // Half a step, towards the middle: the other way may be endless.
  const half = Math.abs(value(place + (place < 0.5 ? 0.5 : -0.5) / steps) - x) / one;
  const count = Math.ceil(Math.floor(Math.log10(Math.abs(number))) + 1 - Math.log10(half));
  const short = Math.abs(number) < 0.01 * half ? 0 : Number(number.toPrecision(Math.min(Math.max(count, kept), 15)));
  return Math.min(Math.max(Number((short * one + zero).toPrecision(12)), from), to);
}

// The point with few digits that is next to one.
export const roundPoint = (point) => point.map((x, m) => roundValue(m, axisAt(m).place(x)));

// 3.2·10⁻⁵ as 3.2e-5.
function plainNumber(text) {
  const power = (raised) => Array.from(raised, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(digit)).map((d) => (d < 0 ? "-" : d));
  const raisedPower = (_, before, raised) => `${before ? before[0] : "1"}e${power(raised).join("")}`;
  return text.replace("−", "-").replace(/(?:(\d)·|^)10([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)/, raisedPower);
}

// One of a unit, and where its zero is; nothing if it is none of this axis.
function namedUnit(units, name, shown) {
  if (name === "") return shown;
  if (units === "K") return { "°C": shown, degC: shown, K: { one: 1, zero: 0 } }[name];
  if (!takesPrefix(units)) return undefined;
  const prefixes = { p: 1e-12, n: 1e-9, µ: 1e-6, μ: 1e-6, u: 1e-6, m: 1e-3, "": 1, k: 1e3, M: 1e6, G: 1e9 };
  const found = Object.entries(prefixes).find(([prefix]) => `${prefix}${units}` === name);
  return found && { one: found[1], zero: 0 };
}

// The value that a text stands for, such as 0.3, inf, ∞ or 5 mm/s. A number alone is in the unit that is shown for
// another value. Throws an error if it is none, or none of the axis.
export function parseValue(m, text, shownFor) {
  const { units, from, to } = axisAt(m);
  const said = `${symbolAt(m)}: “${text.trim()}”`;
  const [, number, unit] = /^([-+]?(?:\d+\.?\d*(?:e[-+]?\d+)?|\.\d+(?:e[-+]?\d+)?|inf|∞)) *(.*)$/i.exec(
    plainNumber(text.trim()),
  ) ?? [null, "", ""];
  const named = namedUnit(units, unit, unitOf(m, shownFor));
  if (number === "" || !named) throw new RangeError(`${said} is no value; write one such as ${valueText(m, shownFor)}`);
  const isEndless = /[i∞]/i.test(number);
  const x = isEndless ? Infinity : Number((Number(number) * named.one + named.zero).toPrecision(15));
  if (from <= x && x <= to) return x;
  const ends = `${valueText(m, from)} to ${valueText(m, to)}`;
  throw new RangeError(`${said} is outside the surface, which goes from ${ends}; nothing is extrapolated`);
}

// The unit of a linear axis in a picture.
const linearUnit = (m) => unitFor(axisAt(m).units, Math.max(Math.abs(axisAt(m).from), Math.abs(axisAt(m).to)));

// Where a value stands in a picture.
export function positionOf(m, x) {
  const { map, place } = axisAt(m);
  if (map === "log") return Math.log10(x);
  if (map === "compact") return place(x);
  const { one, zero } = linearUnit(m);
  return (x - zero) / one;
}

// Decades of a compact axis with its ends, each with room beside it.
function compactTicks(m, room) {
  const { from, to, place } = axisAt(m);
  const ends = [from, to].map((x) => ({ at: place(x), text: digits(x) }));
  const decades = [];
  for (let power = -12; power <= 12; power++) {
    const x = Number(`1e${power}`);
    if (from < x && x < to) decades.push({ at: place(x), text: Math.abs(power) < 3 ? digits(x) : decade(power) });
  }
  const ticks = [ends[0]];
  // From the middle outwards, where decades are far apart.
  const middle = (tick) => Math.abs(tick.at - 0.5);
  for (const tick of [ends[1], ...decades.sort((a, b) => middle(a) - middle(b))]) {
    if (ticks.every(({ at }) => Math.abs(at - tick.at) >= room)) ticks.push(tick);
  }
  return { values: ticks.map(({ at }) => at), text: ticks.map(({ text }) => text) };
}

// The axis of a picture over the whole axis; labels stand so far apart at least, as a part of its width.
export function pictureAxis(m, room) {
  const { units, from, to, map } = axisAt(m);
  const [low, high] = [positionOf(m, from), positionOf(m, to)];
  const edge = 0.015 * (high - low);
  const look = { range: [low - edge, high + edge], tickangle: 0, zeroline: false };
  if (map === "linear") return { ...look, title: { text: titled(labelAt(m), linearUnit(m).word) } };
  const { values: tickvals, text: ticktext } = map === "log" ? logTicks(low, high, units) : compactTicks(m, room);
  const unit = takesPrefix(units) ? "" : unitFor(units, 1).word;
  return { ...look, title: { text: titled(labelAt(m), unit) }, tickmode: "array", tickvals, ticktext };
}
