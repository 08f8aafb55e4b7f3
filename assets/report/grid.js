// The grid of the sweep. A place is a point of the grid over three axes, the last one fastest: f, α and β,
// or f, quantities of the laboratory and the speed. Names here are the names of the dimensionless axes.

import { contents, integers } from "./contents.js";

export const axes = contents.axes.map((axis) => axis.map((value) => (value === "inf" ? Infinity : value)));
export const axisWords = contents.axis_words;
const [fs, alphas, betas] = axes;

export const placeCount = fs.length * alphas.length * betas.length;

export const placeAt = (iF, iAlpha, iBeta) => (iF * alphas.length + iAlpha) * betas.length + iBeta;

export function indicesOf(place) {
  const iBeta = place % betas.length;
  const rest = (place - iBeta) / betas.length;
  return [Math.floor(rest / alphas.length), rest % alphas.length, iBeta];
}

// One row for each β, with a cell for each α.
export const overPlane = (iF, cell) =>
  Array.from(betas.keys(), (iBeta) => Array.from(alphas.keys(), (iAlpha) => cell(placeAt(iF, iAlpha, iBeta))));

// The places that share all indices with this one but that on one axis, in the order of this axis.
export function placesAlong(axis, place) {
  const indices = indicesOf(place);
  return axes[axis].map((_, i) => placeAt(...indices.map((index, other) => (other === axis ? i : index))));
}

// Names and values at an index of an axis: several where quantities are taken together, none where there is no name.
export function coordinatesAt(axis, index) {
  const { name, members } = axisWords[axis];
  if (members.length) return members[index];
  return name ? [[name, axes[axis][index]]] : [];
}

export const coordinatesOf = (place) => indicesOf(place).flatMap((index, axis) => coordinatesAt(axis, index));

// True if a quantity is a surface over the last two axes.
export const isSurface = alphas.length > 1 && betas.length > 1;

// For each place the index of its case, and 1 if the case failed, else 0.
export const caseOf = integers(contents.case_of);
export const failedAt = integers(contents.status);

// The place itself if it suits, else the place that suits the fewest steps away on the axes; null if none does.
export function nearestPlace(place, suits) {
  if (suits(place)) return place;
  const own = indicesOf(place);
  let best = null;
  let fewest = Infinity;
  for (let other = 0; other < placeCount; other++) {
    if (!suits(other)) continue;
    // Another f is farther than any step along α and β.
    const [iF, iAlpha, iBeta] = indicesOf(other).map((index, i) => Math.abs(index - own[i]));
    const steps = iF * (alphas.length + betas.length) + iAlpha + iBeta;
    if (steps < fewest) [fewest, best] = [steps, other];
  }
  return best;
}
