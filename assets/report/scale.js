// How the numbers of a quantity are shown: as they are, or in their logarithm with ticks that read as the numbers.

import { logTicks } from "./ticks.js";

// The scale of these numbers; the choice is "linear", "log" or "auto".
export function scaleOf(values, choice) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  const possible = low > 0 && high < Infinity;
  const logarithmic = possible && (choice === "log" || (choice === "auto" && high > 30 * low));
  const to = logarithmic ? (value) => (value > 0 ? Math.log10(value) : NaN) : (value) => value;
  const ticks = () => {
    if (!logarithmic) return {};
    const { values: tickvals, text: ticktext } = logTicks(Math.log10(low), Math.log10(high));
    return tickvals.length > 1 ? { tickmode: "array", tickvals, ticktext } : {};
  };
  return { logarithmic, to, ticks, empty: low > high, low, high };
}
