// Units as readers meet them: µm, kPa, mm/s, °C, and the scales that dimensionless numbers are over.

import { digits } from "./numbers.js";

const scaleWords = {
  1: "",
  a0: "a₀",
  "a0/R": "a₀/R",
  "a0^2/R": "a₀²/R",
  "2N/(pi a0)": "2N/(πa₀)",
  "N/R": "N/R",
};

const prefixes = [
  [1e-12, "p"],
  [1e-9, "n"],
  [1e-6, "µ"],
  [1e-3, "m"],
  [1, ""],
  [1e3, "k"],
  [1e6, "M"],
  [1e9, "G"],
];

// Units that take a prefix, and the largest one that people use with each.
const largest = { m: 1, "m/s": 1, s: 1, "Pa s": 1, "N/m": 1e3, Pa: 1e9 };

export const takesPrefix = (units) => units in largest;

// The unit for numbers of this size: its word, and what one of it and where its zero is in the unit of the data.
export function unitFor(units, size) {
  if (units === "K") return { word: "°C", one: 1, zero: 273.15 };
  if (!takesPrefix(units)) return { word: scaleWords[units] ?? units, one: 1, zero: 0 };
  const possible = prefixes.filter(([one]) => one <= largest[units]);
  const fitting = possible.filter(([one]) => one <= size * (1 + 1e-9));
  const [one, prefix] = fitting.length ? fitting[fitting.length - 1] : possible[size > 0 ? 0 : 4];
  return { word: `${prefix}${units}`, one, zero: 0 };
}

// A number with its unit, and its error if there is one: 0.5 mm/s, 3.214 ± 0.002 µm.
export function withUnit(value, units, { count = 4, error = NaN } = {}) {
  if (Number.isNaN(value)) return digits(value);
  const { word, one, zero } = unitFor(units, Math.abs(value));
  const margin = error > 0 ? ` ± ${digits(error / one, 2)}` : "";
  return `${digits((value - zero) / one, count)}${margin} ${word}`.trim();
}

// Words with a unit behind them, for an axis.
export const titled = (words, unit) => (unit ? `${words}  (${unit})` : words);
