// The words that stand once: title, counts, where the numbers come from.

import { contents } from "./contents.js";
import { element, show, withText } from "./elements.js";
import { axes, axisWords, placeCount } from "./grid.js";
import { plural } from "./numbers.js";

const inSI = "Numbers bear their units; copies and downloads are in SI units. x of the fields is over a₀.";
const dimensionless =
  "Friction is over a₀/R, film and displacement over a₀²/R, x over a₀, pressure over 2N/(πa₀), tractions over N/R.";

// How many places, cases and failures there are, and how the places lie on the axes.
function countWords() {
  const named = (words) => words.filter((_, axis) => axisWords[axis].symbol);
  const shape = named(axes.map((axis) => axis.length)).join(" × ");
  const whole = named(contents.shape).join(" × ");
  const symbols = named(axisWords.map((axis) => axis.symbol)).join(", ");
  const failed = contents.failures.count;
  const shown = shape === whole ? shape : `${shape} of ${whole}, spread evenly`;
  return [
    `${plural(placeCount, "place")} of (${symbols}): ${shown}`,
    plural(contents.cases.length, "case"),
    failed ? `${failed} failed` : "none failed",
  ].join(", ");
}

export function fillHead() {
  document.title = contents.title;
  element("title").textContent = contents.title;
  element("counts").textContent = countWords();
  show("outdated", contents.outdated);
  const units = contents.laboratory ? inSI : dimensionless;
  element("version").textContent = `Published by stribeck ${contents.version}. ${units}`;
  element("notes").replaceChildren(...contents.notes.map((note) => withText("li", note)));
}
