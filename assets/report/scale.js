// How the numbers of a quantity are shown: as they are, in a unit of their size, or in their logarithm with ticks that
// read as the numbers.

import { logTicks } from "./ticks.js";
import { takesPrefix, titled, unitFor, withUnit } from "./units.js";

// The scale of these numbers; the choice is "linear", "log" or "auto".
export function scaleOf(values, choice, units) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  const possible = low > 0 && high < Infinity;
  const logarithmic = possible && (choice === "log" || (choice === "auto" && high > 30 * low));
  const { word, one } = unitFor(units, Math.max(Math.abs(low), Math.abs(high)));
  const to = logarithmic ? (value) => (value > 0 ? Math.log10(value) : NaN) : (value) => value / one;
  const ticks = () => {
    if (!logarithmic) return {};
    const ends = [low, high];
    const found = logTicks(...ends.map(Math.log10), units);
    const own = { values: ends.map(Math.log10), text: ends.map((end) => withUnit(end, units, { count: 3 })) };
    const { values: tickvals, text: ticktext } = found.values.length > 1 ? found : own;
    return { tickmode: "array", tickvals, ticktext };
  };
  // Ticks of a logarithmic scale bear the unit.
  const title = (words) => titled(words, logarithmic && takesPrefix(units) ? "" : word);
  return { logarithmic, to, ticks, title, empty: low > high, low, high };
}
