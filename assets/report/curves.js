// The quantity along α and along β through the selected place; curves at other values of the other axis are faint.

import { axisPlaces, gridAxis } from "./axes.js";
import { quantityValues } from "./columns.js";
import { say, show } from "./elements.js";
import { axes, axisWords, failedAt, indicesOf, placeAt } from "./grid.js";
import { measuredPoints } from "./measured.js";
import { draw, selectedMarker } from "./picture.js";
import { scaleOf } from "./scale.js";
import { colour, lineColours } from "./theme.js";
import { axisName, hoverWords, wordsAt } from "./words.js";

// For each picture its id, the axis that its curves run along, and the axis that tells one curve from another.
const pictures = [
  { id: "curve-alpha", along: 1, across: 2 },
  { id: "curve-beta", along: 2, across: 1 },
];

export function drawCurves(selection) {
  const values = quantityValues(selection.quantity);
  const scale = scaleOf(values, selection.scale);
  const single = [1, 2].filter((axis) => axisWords[axis].symbol && axes[axis].length < 2);
  const lacks = single.map((axis) => {
    const { symbol } = axisWords[axis];
    return `${symbol} has one value in this sweep, so there is no curve along it.`;
  });
  say("no-curves", scale.empty ? "No case has this number." : lacks.join(" "));
  for (const picture of pictures) {
    const possible = axes[picture.along].length > 1 && !scale.empty;
    show(picture.id, possible);
    if (possible) draw(picture.id, tracesOf(picture, selection, scale), lookOf(picture, selection, scale));
  }
}

function tracesOf({ along, across }, selection, scale) {
  const values = quantityValues(selection.quantity);
  const chosen = indicesOf(selection.place);
  const places = axisPlaces[along];
  const curve = (other) => {
    const shown = places.map((_, i) => {
      const indices = [...chosen];
      [indices[along], indices[across]] = [i, other];
      return placeAt(...indices);
    });
    const y = shown.map((place) => (failedAt[place] ? NaN : scale.to(values[place])));
    const text = shown.map(hoverWords);
    return { type: "scatter", x: places, y, customdata: shown, text, hovertemplate: "%{text}<extra></extra>" };
  };
  // About seven others are enough to see where the case stands.
  const others = axes[across].map((_, i) => i);
  const step = Math.max(1, Math.ceil(others.length / 7));
  const faint = others.filter((i) => i !== chosen[across] && i % step === 0);
  const faintLook = { mode: "lines", line: { color: colour("--quiet"), width: 1 }, opacity: 0.45 };
  const chosenLook = { mode: "lines+markers", line: { color: lineColours()[0], width: 2.5 }, marker: { size: 5 } };
  const chosenCurve = curve(chosen[across]);
  const point = { x: [places[chosen[along]]], y: [chosenCurve.y[chosen[along]]] };
  return [
    ...faint.map((other) => ({ ...curve(other), ...faintLook })),
    { ...chosenCurve, ...chosenLook },
    ...measuredPoints(selection, along, scale),
    { type: "scatter", mode: "markers", ...point, marker: selectedMarker, hoverinfo: "skip" },
  ];
}

function lookOf({ along, across }, { quantity, scale: choice, place }, scale) {
  const value = wordsAt(across, indicesOf(place)[across]);
  const note = {
    text: axes[across].length > 1 ? `${value}; faint: other ${axisWords[across].symbol}` : value,
    ...{ xref: "paper", yref: "paper", x: 0.02, y: 1, xanchor: "left", yanchor: "bottom" },
    showarrow: false,
    font: { color: colour("--quiet") },
  };
  return {
    xaxis: gridAxis(along),
    // What was zoomed is left as it is until another quantity is shown.
    yaxis: { title: { text: axisName(quantity) }, uirevision: `${quantity} ${choice}`, ...scale.ticks() },
    annotations: [note],
    margin: { l: 60, r: 15, t: 26, b: 50 },
  };
}
