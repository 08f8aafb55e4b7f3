// What the reader has chosen: a quantity, its scale, a place, and places that are pinned.

import { nearestIndex } from "./axes.js";
import { headline } from "./columns.js";
import { contents } from "./contents.js";
import { axes, failedAt, indicesOf, isSurface, nearestPlace, placeAt } from "./grid.js";

// The first place shown is one whose case dissipates much, or the nearest that converged: the largest f, the α nearest
// to 1, in the middle of β; over quantities of the laboratory in the middle of these.
function firstPlace() {
  const middle = (axis) => Math.floor(axes[axis].length / 2);
  const wanted = placeAt(axes[0].length - 1, contents.laboratory ? middle(1) : nearestIndex(1, 0), middle(2));
  return nearestPlace(wanted, (place) => !failedAt[place]) ?? wanted;
}

// Where a page begins. Beside the friction curve of a sweep without surfaces stands the film.
export const beginning = {
  quantity: isSurface ? headline : "film_min",
  scale: "auto",
  place: firstPlace(),
  pins: [],
};

export const selection = {
  ...beginning,
  get iF() {
    return indicesOf(this.place)[0];
  },
};

let follow = () => {};

// Names the one function that is called whenever something else is chosen.
export function whenChosen(act) {
  follow = act;
}

// Chooses some of quantity, scale, place and pins.
export function choose(chosen) {
  Object.assign(selection, chosen);
  follow();
  document.body.dataset.place = selection.place;
}

export const select = (place) => choose({ place });

// Selects the place that lies so many values farther along α and β, as far as there are values.
export function selectNeighbour(alongAlpha, alongBeta) {
  const [iF, iAlpha, iBeta] = indicesOf(selection.place);
  const within = (index, axis) => Math.min(Math.max(index, 0), axes[axis].length - 1);
  select(placeAt(iF, within(iAlpha + alongAlpha, 1), within(iBeta + alongBeta, 2)));
}

// Selects the place of a point of a picture: points of curves and of the scatter know their place; points of surface
// and map stand at it.
export function selectPoint(id, { x, y, customdata }) {
  const onPlane = id === "surface" || id === "map";
  const place = onPlane ? placeAt(selection.iF, nearestIndex(1, x), nearestIndex(2, y)) : customdata;
  if (Number.isInteger(place)) select(place);
}
