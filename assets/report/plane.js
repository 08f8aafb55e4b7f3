// The quantity over α and β at one f: what map and surface share.

import { axisPlaces } from "./axes.js";
import { quantityValues } from "./columns.js";
import { element, say, show, showPicture } from "./elements.js";
import { failedAt, indicesOf, isSurface, overPlane } from "./grid.js";
import { scaleOf } from "./scale.js";
import { placesTable } from "./tables.js";
import { theme } from "./theme.js";
import { hoverWords, unitsOf, wordsOf } from "./words.js";

const [, alphaPlaces, betaPlaces] = axisPlaces;

// Numbers on their scale, one row for each β, with their colours. Kept until another quantity, scale, f or theme is
// shown: Plotly draws nothing again that is the same object as before.
let plane = { key: null };
export function planeOf({ quantity, scale: choice, iF }) {
  const key = [quantity, choice, iF, theme()].join(" ");
  if (plane.key === key) return plane;
  const values = quantityValues(quantity);
  const scale = scaleOf(values, choice, unitsOf(quantity));
  // A failed case has its known limits, and is a hole all the same.
  const z = overPlane(iF, (place) => (failedAt[place] ? NaN : scale.to(values[place])));
  const isEmpty = z.every((row) => row.every((value) => !Number.isFinite(value)));
  const text = overPlane(iF, hoverWords);
  const failed = overPlane(iF, (place) => place)
    .flat()
    .filter((place) => failedAt[place]);
  const crosses = {
    x: failed.map((place) => alphaPlaces[indicesOf(place)[1]]),
    y: failed.map((place) => betaPlaces[indicesOf(place)[2]]),
    text: failed.map(hoverWords),
  };
  const range = [scale.to(scale.low), scale.to(scale.high)];
  const colours = { colorscale: "Viridis", hovertemplate: "%{text}<extra></extra>", text };
  plane = { key, scale, z, isEmpty, crosses, range, colours };
  return plane;
}

// The numbers behind map and surface.
export const planeTable = ({ quantity, iF }) => placesTable(overPlane(iF, (place) => place).flat(), [quantity]);

// Why there is no map or no surface; nothing if there are both.
function lack(scale, isEmpty) {
  if (failedAt.every((failed) => failed)) return "Every case failed; the reasons are below.";
  if (scale.empty) return "No case has this number.";
  return isEmpty ? "At this f no case has this number, so there is no surface; what failed is × in the map." : "";
}

// Says what is shown, and hides what cannot be: which of the two pictures can be drawn.
export function nameQuantity(selection) {
  show("plane", isSurface);
  if (!isSurface) return { map: false, surface: false };
  const long = wordsOf(selection.quantity);
  element("surface-title").textContent = `${long[0].toUpperCase()}${long.slice(1)}`;
  const { scale, isEmpty } = planeOf(selection);
  say("no-surface", lack(scale, isEmpty));
  const map = !scale.empty;
  const surface = map && !isEmpty;
  show("surface-pair", map);
  show("hint", map);
  showPicture("surface", surface);
  return { map, surface };
}

// Where the selected case stands in the plane.
export function chosenPoint({ place }) {
  const [, iAlpha, iBeta] = indicesOf(place);
  return { iAlpha, iBeta, x: [alphaPlaces[iAlpha]], y: [betaPlaces[iBeta]] };
}
