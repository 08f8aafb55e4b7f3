// The controls above the pictures, which choose quantity, scale, f and colours, and the keys of map and surface.

import { columns, quantities } from "./columns.js";
import { element, show } from "./elements.js";
import { axes, indicesOf, placeAt } from "./grid.js";
import { select, selection, selectNeighbour } from "./selection.js";
import { turnSurface } from "./surface.js";
import { changeTheme } from "./theme.js";
import { longName, symbols, wordsAt } from "./words.js";

const [fs] = axes;

export function fillControls() {
  for (const name of quantities) {
    const words = columns.has(name) ? `${symbols[name]}, ${longName(name)}` : longName(name);
    element("quantity").add(new Option(words, name));
  }
  element("f-slider").max = fs.length - 1;
  show("f-control", fs.length > 1);
  showStrength();
}

// Shows the f of the selected place, and its slide-to-roll ratio where that is an axis.
export function showStrength() {
  const { iF } = selection;
  element("f-slider").value = iF;
  const words = wordsAt(0, iF);
  element("f-value").textContent = words;
  element("f-slider").setAttribute("aria-valuetext", words);
}

const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function moveInMap(event) {
  const step = steps[event.key];
  if (!step) return;
  event.preventDefault();
  selectNeighbour(...step);
}

// Listens to the controls; pictures are drawn again by `redraw`.
export function listenToControls(redraw) {
  const on = (id, event, act) => element(id).addEventListener(event, act);
  on("quantity", "change", (event) => {
    selection.quantity = event.target.value;
    redraw();
  });
  on("scale", "change", (event) => {
    selection.scale = event.target.value;
    redraw();
  });
  on("f-slider", "input", (event) => {
    const [, iAlpha, iBeta] = indicesOf(selection.place);
    select(placeAt(Number(event.target.value), iAlpha, iBeta));
  });
  on("theme", "click", () => {
    changeTheme();
    redraw();
  });
  on("map", "keydown", moveInMap);
  on("surface", "keydown", turnSurface);
}
