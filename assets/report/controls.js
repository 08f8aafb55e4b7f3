// The controls above the pictures, which choose quantity, scale and f, and the keys of map and surface.

import { quantities } from "./columns.js";
import { element, show } from "./elements.js";
import { axes, indicesOf, placeAt } from "./grid.js";
import { choose, selection, selectNeighbour } from "./selection.js";
import { turnSurface } from "./space.js";
import { wordsAt, wordsOf } from "./words.js";

const [fs] = axes;

export function fillControls() {
  for (const name of quantities) element("quantity").add(new Option(wordsOf(name), name));
  element("f-slider").max = fs.length - 1;
  show("f-control", fs.length > 1);
  showChoice();
}

// Shows what is chosen; beside the slider stands f, and the slide-to-roll ratio where that is an axis.
export function showChoice() {
  const { iF } = selection;
  element("quantity").value = selection.quantity;
  element("scale").value = selection.scale;
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

export function listenToControls() {
  const on = (id, event, act) => element(id).addEventListener(event, act);
  on("quantity", "change", (event) => choose({ quantity: event.target.value }));
  on("scale", "change", (event) => choose({ scale: event.target.value }));
  on("f-slider", "input", (event) => {
    const [, iAlpha, iBeta] = indicesOf(selection.place);
    choose({ place: placeAt(Number(event.target.value), iAlpha, iBeta) });
  });
  on("map", "keydown", moveInMap);
  on("surface", "keydown", turnSurface);
}
