// Cases that are pinned, to be compared with the selected one.

import { frictionParts, headline, quantityValues } from "./columns.js";
import { button, element, show, withText } from "./elements.js";
import { failedAt } from "./grid.js";
import { choose, selection } from "./selection.js";
import { symbols } from "./symbols.js";
import { colour, lineColours, pinColours } from "./theme.js";
import { hoverWords, pointWords, valueOf, wordsOf } from "./words.js";

const dashes = ["dash", "dot", "dashdot", "longdash"];

export const mostPins = dashes.length;

// The selected case and those pinned: place, name, and the look of their lines.
export function comparedCases({ place, pins }) {
  const selected = { place, name: "selected", line: { color: lineColours()[0], width: 2.5 } };
  const pinned = pins.map((pin, i) => {
    return { place: pin, name: `pin ${i + 1}`, line: { color: pinColours()[i], width: 2, dash: dashes[i] } };
  });
  return [selected, ...pinned];
}

// Numbers in circles where pinned cases stand in a picture, given their coordinates.
export function pinMarks({ pins }, x, y) {
  return pins.map((place, i) => {
    const line = { color: pinColours()[i], width: 2 };
    return {
      ...{ type: "scatter", mode: "markers+text", x: [x(place)], y: [y(place)], customdata: [place] },
      ...{ text: [String(i + 1)], textfont: { size: 11, color: colour("--text") } },
      marker: { symbol: "circle", size: 17, color: colour("--paper"), line },
      hovertemplate: `pin ${i + 1}: ${hoverWords(place)}<extra></extra>`,
    };
  });
}

function togglePin() {
  const { place, pins } = selection;
  choose({ pins: pins.includes(place) ? pins.filter((pin) => pin !== place) : [...pins, place] });
}

// What is compared; the largest error is that of the numbers that the tolerance holds for.
const compared = [headline, ...frictionParts, "film_min", "p_max", "largest_error"];

function caseRow({ place, name, line }, isPinned) {
  const row = document.createElement("tr");
  const head = withText("th", `${name}: ${pointWords(place)}${failedAt[place] ? " (failed)" : ""}`);
  head.scope = "row";
  head.style.borderLeft = `5px ${line.dash ? "dashed" : "solid"} ${line.color}`;
  row.append(head, ...compared.map((quantity) => withText("td", valueOf(quantity, quantityValues(quantity)[place]))));
  const cell = row.insertCell();
  if (isPinned) {
    const unpin = button("unpin", () => choose({ pins: selection.pins.filter((pin) => pin !== place) }));
    unpin.setAttribute("aria-label", `unpin ${pointWords(place)}`);
    cell.append(unpin);
  }
  return row;
}

export function showPins() {
  const { place, pins } = selection;
  const isPinned = pins.includes(place);
  const pin = element("pin");
  pin.textContent = isPinned ? "unpin this case" : "pin this case";
  pin.disabled = !isPinned && pins.length === mostPins;
  pin.title = pin.disabled ? `${mostPins} cases are pinned: unpin one first` : "keeps it in the pictures, to compare";
  show("pins", pins.length > 0);
  const titles = ["case", ...compared.map((name) => symbols[name] ?? wordsOf(name)), ""];
  const heads = document.createElement("tr");
  heads.append(...titles.map((title) => withText("th", title)));
  document.querySelector("#pins thead").replaceChildren(heads);
  const rows = comparedCases(selection).map((one, i) => caseRow(one, i > 0));
  document.querySelector("#pins tbody").replaceChildren(...rows);
}

export const listenToPin = () => element("pin").addEventListener("click", togglePin);
