// The fields of each case over x.

import { contents, floats, integers, shorts } from "./contents.js";
import { caseOf } from "./grid.js";

// Fields are decoded when one is first asked for.
let decoded = null;
function decodedFields() {
  const part = contents.fields;
  if (!decoded) {
    decoded = { x: floats(part.x), slots: integers(part.slots), indices: shorts(part.indices), fields: {} };
    for (const [name, field] of Object.entries(part.fields)) {
      const { low, high, steps } = field;
      decoded.fields[name] = { ...field, low: floats(low), high: floats(high), steps: shorts(steps) };
    }
  }
  return decoded;
}

export const hasFields = (place) => decodedFields().slots[caseOf[place]] >= 0;

// The fields of a case by their names, as far as the sweep has them, and their x.
export function fieldsOf(place) {
  const { points } = contents.fields;
  const { x, slots, indices, fields } = decodedFields();
  const slot = slots[caseOf[place]];
  const from = slot * points;
  const found = { x: Array.from({ length: points }, (_, i) => x[indices[from + i]]) };
  for (const [name, field] of Object.entries(fields)) {
    const low = field.low[slot];
    const span = field.high[slot] - low;
    found[name] = Array.from({ length: points }, (_, i) => {
      const value = low + (span * field.steps[from + i]) / 65535;
      return field.logarithmic[slot] ? 10 ** value : value;
    });
  }
  return found;
}
