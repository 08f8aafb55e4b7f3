// The quantity along each axis through the selected place; curves at other values of the other axis are faint.

import { axisPlaces, gridAxis } from "./axes.js";
import { quantityValues } from "./columns.js";
import { say, show, showPicture } from "./elements.js";
import { errorAt, errorBars, errorWords, hasErrors } from "./errors.js";
import { axes, axisWords, failedAt, indicesOf, placesAlong } from "./grid.js";
import { measuredPoints } from "./measured.js";
import { draw, selectedMarker } from "./picture.js";
import { pinMarks } from "./pins.js";
import { scaleOf } from "./scale.js";
import { placesTable } from "./tables.js";
import { colour, lineColours } from "./theme.js";
import { hoverWords, unitsOf, wordsAt, wordsOf } from "./words.js";

// For each picture its id, the axis that its curves run along, and the axis that tells one curve from another. Along f
// there is one where nothing else varies.
const isLong = (axis) => axes[axis].length > 1;
const pictures = [
  { id: "curve-alpha", along: 1, across: 2, isThere: isLong(1) },
  { id: "curve-beta", along: 2, across: 1, isThere: isLong(2) },
  { id: "curve-f", along: 0, across: 1, isThere: isLong(0) && !isLong(1) && !isLong(2) },
];

// The places of the curve through the selected place, and of about seven others, enough to see where the case stands.
function curvesOf({ along, across }, place) {
  const others = placesAlong(across, place);
  const step = Math.max(1, Math.ceil(others.length / 7));
  const faint = others.filter((other, i) => other !== place && i % step === 0);
  return { chosen: placesAlong(along, place), faint: faint.map((other) => placesAlong(along, other)) };
}

function trace(places, values, along, scale) {
  return {
    ...{ type: "scatter", x: axisPlaces[along], customdata: places, text: places.map(hoverWords) },
    y: places.map((place) => (failedAt[place] ? NaN : scale.to(values[place]))),
    hovertemplate: "%{text}<extra></extra>",
  };
}

// What all these curves span on the scale.
function spanOf(curves, values, scale) {
  const shown = curves.flat().filter((place) => !failedAt[place]);
  const heights = shown.map((place) => scale.to(values[place])).filter(Number.isFinite);
  return Math.max(...heights) - Math.min(...heights);
}

// The traces of a picture, and the error bars of the chosen curve with its values and errors.
function tracesOf(picture, curves, selection, scale) {
  const { along } = picture;
  const { quantity, place } = selection;
  const values = quantityValues(quantity);
  const { chosen, faint } = curves;
  const faintLook = { mode: "lines", line: { color: colour("--quiet"), width: 1 }, opacity: 0.45 };
  const chosenLook = { mode: "lines+markers", line: { color: lineColours()[0], width: 2.5 }, marker: { size: 5 } };
  const own = chosen.map((one) => (failedAt[one] ? NaN : values[one]));
  const errors = chosen.map((one) => errorAt(quantity, one));
  const bars = errorBars(own, errors, scale, spanOf([chosen, ...faint], values, scale));
  const x = (one) => axisPlaces[along][indicesOf(one)[along]];
  const y = (one) => (failedAt[one] ? NaN : scale.to(values[one]));
  const traces = [
    ...faint.map((places) => ({ ...trace(places, values, along, scale), ...faintLook })),
    { ...trace(chosen, values, along, scale), ...chosenLook, ...(hasErrors(quantity) ? { error_y: bars } : {}) },
    ...measuredPoints(selection, along, scale),
    ...pinMarks(selection, x, y),
    { type: "scatter", mode: "markers", x: [x(place)], y: [y(place)], marker: selectedMarker, hoverinfo: "skip" },
  ];
  return { traces, bars, own, errors };
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
    yaxis: { title: { text: scale.title(wordsOf(quantity)) }, uirevision: `${quantity} ${choice}`, ...scale.ticks() },
    annotations: [note],
    margin: { l: 60, r: 15, t: 26, b: 50 },
  };
}

export function drawCurves(selection) {
  const { quantity, place } = selection;
  const scale = scaleOf(quantityValues(quantity), selection.scale, unitsOf(quantity));
  const there = pictures.filter(({ isThere }) => isThere);
  show("curves", there.length > 0);
  say("no-curves", scale.empty ? "No case has this number." : "");
  const drawn = [];
  // A picture takes the room that those beside it leave, so these are hidden first.
  for (const { id, isThere } of pictures) showPicture(id, isThere && !scale.empty);
  for (const picture of scale.empty ? [] : there) {
    const curves = curvesOf(picture, place);
    const { traces, ...chosen } = tracesOf(picture, curves, selection, scale);
    drawn.push(chosen);
    const table = () => placesTable([curves.chosen, ...curves.faint].flat(), [quantity]);
    draw(picture.id, traces, lookOf(picture, selection, scale), table);
  }
  const all = (name) => drawn.flatMap((chosen) => chosen[name]);
  say("curve-errors", drawn.length ? errorWords(all("bars"), all("own"), all("errors")) : "");
}
