// Labelled places of a logarithmic axis.

import { decade, digits } from "./numbers.js";

const everyDigit = [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9];

// Places between two logarithms: decades, or 1, 2 and 5 of each where there are few.
export function logTicks(low, high) {
  const values = [];
  const text = [];
  const decades = Math.floor(high + 1e-9) - Math.ceil(low - 1e-9) + 1;
  const step = Math.max(1, Math.ceil(decades / 8));
  for (let power = Math.floor(low); power <= high + 1e-9; power++) {
    for (const digit of decades >= 3 ? [1] : decades >= 1 ? [1, 2, 5] : everyDigit) {
      const place = power + Math.log10(digit);
      const labelled = decades < 3 || power % step === 0;
      if (place < low - 1e-9 || place > high + 1e-9 || !labelled) continue;
      values.push(place);
      text.push(decades >= 3 ? decade(power) : digits(digit * 10 ** power));
    }
  }
  return { values, text };
}
