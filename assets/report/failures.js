// The list of failed places, by the reasons why they failed.

import { contents } from "./contents.js";
import { button, element, withText } from "./elements.js";
import { axes, placeAt } from "./grid.js";
import { plural } from "./numbers.js";
import { select } from "./selection.js";
import { valueWords, wordsAt } from "./words.js";

// An item with a button that selects the place of these values. Of a thinned grid not every failed place is on the
// page.
function failureItem(values) {
  const indices = axes.map((axis, i) => axis.indexOf(values[i]));
  const words = values.map((value, i) => (indices[i] < 0 ? valueWords(i, value) : wordsAt(i, indices[i])));
  const choice = button(words.filter(Boolean).join(", "), () => select(placeAt(...indices)));
  choice.disabled = indices.includes(-1);
  const item = document.createElement("li");
  item.append(choice);
  return item;
}

export function listFailures() {
  const { count, kinds, listed } = contents.failures;
  if (count === 0) {
    element("failure-list").textContent = "None: every case converged.";
    return;
  }
  const parts = kinds.flatMap((kind, index) => {
    const more = kind.varied ? " (or the same with other numbers)" : "";
    const own = listed.filter((failure) => failure[1] === index);
    const items = document.createElement("ul");
    for (const [values] of own) {
      items.append(failureItem(values.map((value) => (value === "inf" ? Infinity : value))));
    }
    return [withText("h3", `${plural(kind.count, "place")}: ${kind.reason}${more}`), items];
  });
  element("failure-list").replaceChildren(...parts);
}
