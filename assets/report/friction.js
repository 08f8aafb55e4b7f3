// The friction along the axis of the sweep: the drag, with the parts that it is the sum of (T54).

import { axisPlaces, gridAxis } from "./axes.js";
import { column, hysteresis, quantityValues } from "./columns.js";
import { contents } from "./contents.js";
import { say, show, showPicture } from "./elements.js";
import { errorAt, errorBars, errorWords } from "./errors.js";
import { axes, axisWords, failedAt, indicesOf, isSurface, placesAlong } from "./grid.js";
import { measuredPoints, quantitiesAt } from "./measured.js";
import { digits } from "./numbers.js";
import { draw, selectedMarker } from "./picture.js";
import { pinMarks } from "./pins.js";
import { scaleOf } from "./scale.js";
import { symbols } from "./symbols.js";
import { placesTable } from "./tables.js";
import { colour, lineColours } from "./theme.js";
import { hoverWords, unitsOf, wordsAt, wordsOf } from "./words.js";

const name = "mu_drag";

// The axis that the curve runs along: the speed, or the other one that varies; none in a sweep of one case.
const long = [2, 1, 0].filter((axis) => axes[axis].length > 1);
const along = long.find((axis) => axisWords[axis].name !== "combination") ?? long[0];

// An experiment begins with its friction, and so does a sweep that has no surface.
export const beginsWithFriction = along !== undefined && (contents.laboratory || !isSurface);

// The slide-to-roll ratio S at a place.
function slideRoll(place) {
  const { slide_roll: ratio, slide_roll_ratio: twice, roller_speed: roller, flat_speed: flat } = quantitiesAt(place);
  if (ratio !== undefined) return ratio;
  if (twice !== undefined) return twice / 2;
  return flat === undefined ? 1 : (flat - roller) / (flat + roller);
}

// The parts: their column, and the factor that they are in the sum with.
const parts = [
  { part: hysteresis, factor: () => 1 },
  { part: "mu_shear", factor: slideRoll },
  { part: "mu_pressure", factor: () => -1 },
];

const ratioWords = (ratio) => (ratio === 1 ? "" : `${digits(ratio)} `);

// The sum in symbols, S as a number where it is the same at all these places.
function sumWords(places) {
  const ratios = new Set(places.map(slideRoll));
  const [ratio] = ratios;
  const shear = ratios.size > 1 ? "+ S " : `${ratio < 0 ? "−" : "+"} ${ratioWords(Math.abs(ratio))}`;
  return `${symbols.mu_drag} = ${symbols[hysteresis]} ${shear}${symbols.mu_shear} − ${symbols.mu_pressure}`;
}

function partName({ part }, places) {
  if (part === hysteresis) return wordsOf(part);
  if (part === "mu_pressure") return `less ${wordsOf(part)}`;
  const ratios = new Set(places.map(slideRoll));
  const [ratio] = ratios;
  if (ratio === 1 && ratios.size === 1) return wordsOf(part);
  return `${ratios.size > 1 ? "S" : digits(ratio)} times ${wordsOf(part)}`;
}

// Parts that are known everywhere and positive lie one upon the other, so that the uppermost line is the drag.
function partTraces(places, scale) {
  const x = places.map((place) => axisPlaces[along][indicesOf(place)[along]]);
  const sizes = parts.map(({ part, factor }) => places.map((place) => factor(place) * column(part)[place]));
  const isPile = !scale.logarithmic && sizes.every((size) => size.every((value) => value >= 0));
  const [blue, orange, green] = lineColours();
  const colours = [blue, green, orange];
  let below = places.map(() => 0);
  return parts.map((one, i) => {
    const top = sizes[i].map((value, at) => value + (isPile ? below[at] : 0));
    below = top;
    return {
      ...{ type: "scatter", mode: "lines", x, y: top.map(scale.to), customdata: places, name: partName(one, places) },
      line: { color: colours[i], width: isPile ? 1 : 2, dash: isPile ? "solid" : ["solid", "dash", "dot"][i] },
      ...(isPile ? { fill: i ? "tonexty" : "tozeroy", fillcolor: `${colours[i]}66` } : {}),
      ...{ text: places.map(hoverWords), hovertemplate: "%{text}<extra></extra>" },
    };
  });
}

// Drags for other values of the axis between, faint, about seven of them.
function otherDrags(place, scale) {
  const across = [1, 2, 0].find((axis) => axis !== along && axes[axis].length > 1);
  if (across === undefined) return [];
  const all = placesAlong(across, place).filter((other) => other !== place);
  const step = Math.max(1, Math.ceil(all.length / 7));
  return all
    .filter((_, i) => i % step === 0)
    .map((other) => {
      const places = placesAlong(along, other);
      const y = places.map((one) => (failedAt[one] ? NaN : scale.to(column(name)[one])));
      const look = { mode: "lines", line: { color: colour("--quiet"), width: 1 }, opacity: 0.6, showlegend: false };
      const hover = { text: places.map(hoverWords), hovertemplate: "%{text}<extra></extra>" };
      return { type: "scatter", x: axisPlaces[along], y, customdata: places, ...hover, ...look };
    });
}

function dragTrace(places, scale) {
  const values = places.map((place) => (failedAt[place] ? NaN : column(name)[place]));
  const errors = places.map((place) => errorAt(name, place));
  const shown = values.map(scale.to);
  const finite = shown.filter(Number.isFinite);
  const bars = errorBars(values, errors, scale, Math.max(...finite) - (scale.logarithmic ? Math.min(...finite) : 0));
  say("friction-errors", errorWords([bars], values, errors));
  return {
    ...{ type: "scatter", mode: "lines+markers", x: axisPlaces[along], y: shown, customdata: places },
    ...{ name: wordsOf(name), line: { color: colour("--text"), width: 2.5 }, marker: { size: 5 }, error_y: bars },
    ...{ text: places.map(hoverWords), hovertemplate: "%{text}<extra></extra>" },
  };
}

// What the curve is drawn for, and how the drag is made of its parts.
function frictionWords(place, places) {
  const others = [0, 1, 2].filter((axis) => axis !== along);
  const at = others.map((axis) => wordsAt(axis, indicesOf(place)[axis])).filter(Boolean);
  const varied = others.filter((axis) => axes[axis].length > 1).map((axis) => axisWords[axis].symbol);
  const faint = varied.length ? ` Faint: the drag at other ${varied[0]}.` : "";
  return `${sumWords(places)}, at ${at.join(", ")}.${faint}`;
}

// Linear if nothing else is asked for: parts that add up do so on no other scale. Logarithms reach down to a
// ten-thousandth of the largest drag.
function frictionScale({ scale: choice }) {
  const drags = quantityValues(name);
  if (choice !== "log") return scaleOf(drags, "linear", unitsOf(name));
  const most = drags.reduce((largest, drag) => (drag > largest ? drag : largest), 0);
  const shown = ({ part }) => column(part).map(Math.abs).filter((size) => size > 1e-4 * most);
  return scaleOf([drags, ...parts.map(shown)].flatMap((values) => [...values]), "log", unitsOf(name));
}

// Says what the curve is of, above the place where it is drawn; true if it can be.
export function sayFriction({ place }) {
  show("friction-section", beginsWithFriction);
  if (!beginsWithFriction) return false;
  const places = placesAlong(along, place);
  const isSolved = places.some((one) => !failedAt[one]);
  showPicture("friction", isSolved);
  const all = failedAt.every((failed) => failed);
  const lack = all ? "Every case failed; the reasons are below." : "No case of this curve converged.";
  say("friction-words", isSolved ? frictionWords(place, places) : lack);
  return isSolved;
}

export function drawFriction(selection) {
  say("friction-errors", "");
  if (!sayFriction(selection)) return;
  const { place } = selection;
  const places = placesAlong(along, place);
  const scale = frictionScale(selection);
  const x = (one) => axisPlaces[along][indicesOf(one)[along]];
  const y = (one) => scale.to(column(name)[one]);
  const marked = { type: "scatter", mode: "markers", x: [x(place)], y: [y(place)], marker: selectedMarker };
  const traces = [
    ...partTraces(places, scale),
    ...otherDrags(place, scale),
    dragTrace(places, scale),
    ...measuredPoints({ quantity: name, place }, along, scale),
    ...pinMarks(selection, x, y).map((mark) => ({ ...mark, showlegend: false })),
    { ...marked, hoverinfo: "skip", showlegend: false },
  ];
  const look = {
    xaxis: gridAxis(along),
    yaxis: { title: { text: scale.title("friction coefficient") }, uirevision: selection.scale, ...scale.ticks() },
    showlegend: true,
    legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0 },
    margin: { l: 60, r: 15, t: 30, b: 50 },
  };
  draw("friction", traces, look, () => placesTable(places, [name, ...parts.map(({ part }) => part)]));
}
