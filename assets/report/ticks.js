// Labelled places of a logarithmic axis.

import { decade, digits } from "./numbers.js";
import { takesPrefix, withUnit } from "./units.js";

// The digits of a decade that are labelled, where there are fewer than one, fewer than three, and more decades. Labels
// with units are long, so there are fewer.
const bare = { few: [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9], some: [1, 2, 5], many: [1], most: 8 };
const longer = { few: [1, 2, 3, 5, 7], some: [1, 3], many: [1], most: 5 };

// Places between two logarithms: decades, or some digits of each where there are few.
export function logTicks(low, high, units) {
  const values = [];
  const text = [];
  const hasUnit = takesPrefix(units);
  const { few, some, many, most } = hasUnit ? longer : bare;
  const decades = Math.floor(high + 1e-9) - Math.ceil(low - 1e-9) + 1;
  const step = Math.max(1, Math.ceil(decades / most));
  const label = (digit, power) => {
    if (hasUnit) return withUnit(digit * 10 ** power, units, { count: 2 });
    return decades >= 3 ? decade(power) : digits(digit * 10 ** power);
  };
  for (let power = Math.floor(low); power <= high + 1e-9; power++) {
    for (const digit of decades >= 3 ? many : decades >= 1 ? some : few) {
      const place = power + Math.log10(digit);
      const labelled = decades < 3 || power % step === 0;
      if (place < low - 1e-9 || place > high + 1e-9 || !labelled) continue;
      values.push(place);
      text.push(label(digit, power));
    }
  }
  return { values, text };
}
