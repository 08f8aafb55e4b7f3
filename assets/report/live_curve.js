// The curve of friction and its parts, or of another quantity, along a cut through the surface. It is drawn from the
// surface itself, at as many points as a smooth line takes.

import { element } from "./elements.js";
import { kept, pictureAxis, pointWords, positionOf, valueWords } from "./live_axes.js";
import { allFriction, live, way } from "./live_point.js";
import { isFriction, quantityNames, surface, symbolOf, unitsOf, withError, wordsOf } from "./live_surface.js";
import { draw, selectedMarker } from "./picture.js";
import { scaleOf } from "./scale.js";
import { colour, lineColours, pinColours } from "./theme.js";

// How many points a line has; a cut along no axis takes a whole evaluation for each.
const pointsAlong = 241;
const pointsOfWay = 121;

const placesOf = (count) => Array.from({ length: count }, (_, i) => i / (count - 1));

// A cut along an axis: positions in the picture, points, and values there.
function alongAxis(name) {
  const { axes } = surface();
  const m = axes.findIndex((axis) => axis.name === name);
  const line = surface().line(name, live.point);
  // The point itself is one of the line's.
  const own = axes[m].place(live.point[m]);
  const places = [...new Set([...placesOf(pointsAlong), own])].sort((a, b) => a - b);
  const xs = places.map((place) => (place === own ? live.point[m] : axes[m].value(place)));
  return {
    x: xs.map((x) => positionOf(m, x)),
    points: xs.map((x) => live.point.map((other, i) => (i === m ? x : other))),
    values: xs.map(line),
    mark: positionOf(m, live.point[m]),
  };
}

// The point so far along the straight way from the point to the pinned one, in the coordinates in which the surface
// is smooth.
function onWay(share) {
  if (share === 0) return live.point;
  if (share === 1) return live.pin;
  const between = ({ place, value }, m) => value((1 - share) * place(live.point[m]) + share * place(live.pin[m]));
  return surface().axes.map((axis, m) => (live.point[m] === live.pin[m] ? live.point[m] : between(axis, m)));
}

function alongWay() {
  const x = placesOf(pointsOfWay);
  const points = x.map(onWay);
  return { x, points, values: points.map((point) => surface().evaluate(point)), mark: 0 };
}

// The names of what is shown, the uppermost line first.
export const shownNames = () => (live.show === allFriction ? quantityNames().filter(isFriction) : [live.show]);

// Lines of friction as in the friction curve of a sweep; what it does not have has looks of the same kind. Plotly
// leaves out no point of them, so that they are smooth.
function lookOf(name) {
  const [blue, orange, green, pink] = lineColours();
  const looks = {
    mu_drag: { color: colour("--text"), width: 2.5 },
    mu_v: { color: blue, dash: "solid" },
    mu_v_flat: { color: blue, dash: "longdash" },
    mu_v_roller: { color: blue, dash: "dot" },
    mu_shear: { color: green, dash: "dash" },
    mu_pressure: { color: orange, dash: "dot" },
    mu_h: { color: pink, dash: "dashdot" },
    mu_h_cavity: { color: pink, dash: "dot" },
    mu_tot: { color: colour("--quiet"), dash: "longdash" },
    mu_torque: { color: orange, dash: "longdashdot" },
  };
  return { width: 2, simplify: false, ...(looks[name] ?? { color: isFriction(name) ? colour("--quiet") : blue }) };
}

// What the pointer rests on: the point, and each number with its error.
function hoverTexts({ points, values }, names) {
  return points.map((point, i) => {
    const errors = surface().errors(values[i]);
    const numbers = names.map((name) => `${symbolOf(name)} = ${withError(name, values[i][name], errors[name])}`);
    return [pointWords(point, kept), ...numbers].join("<br>");
  });
}

// Logarithms of friction reach down to a ten-thousandth of the largest.
function scaleFor(names, values) {
  const all = names.flatMap((name) => values.map((value) => value[name]));
  const most = Math.max(...all);
  const shown = live.scale === "log" ? all.filter((value) => value > 1e-4 * most) : all;
  return scaleOf(shown, live.scale, unitsOf(names[0]));
}

// The height of the picture: on a logarithmic scale what it shows, else all.
function rangeOf({ logarithmic, to, low, high }) {
  const uirevision = `${live.cut} ${live.show} ${live.scale}`;
  if (!logarithmic) return { uirevision };
  const room = 0.05 * (to(high) - to(low)) + 0.02;
  return { uirevision, range: [to(low) - room, to(high) + room] };
}

function tracesOf({ x, points, values, mark }, names, scale) {
  const text = hoverTexts({ points, values }, names);
  const hover = { text, hovertemplate: "%{text}<extra></extra>" };
  const y = (name) => values.map((value) => scale.to(value[name]));
  const lines = names.map((name) => ({
    ...{ type: "scatter", mode: "lines", x, y: y(name), name: wordsOf(name), line: lookOf(name), ...hover },
  }));
  const marks = { type: "scatter", mode: "markers", hoverinfo: "skip", showlegend: false };
  const at = x.indexOf(mark);
  const ring = { ...marks, x: [mark], y: [scale.to(values[at][names[0]])], marker: selectedMarker };
  const dots = { color: names.map((name) => lookOf(name).color), size: 8 };
  const own = { ...marks, x: names.map(() => mark), y: names.map((name) => scale.to(values[at][name])), marker: dots };
  // The drag lies above its parts.
  return [...lines.reverse(), own, ring];
}

// The ends of the way and what lies between, with the values of the axes that change on it.
function wayAxis(isNarrow) {
  const shares = placesOf(isNarrow ? 3 : 5);
  const varied = live.point.flatMap((x, m) => (x === live.pin[m] ? [] : [m]));
  const words = (share) => varied.map((m) => valueWords(m, onWay(share)[m], kept)).join("<br>");
  const title = { text: varied.length ? "from here to the pinned point" : "here is the pinned point: move a slider" };
  return { title, tickmode: "array", tickvals: shares, ticktext: shares.map(words), tickangle: 0, zeroline: false };
}

// The pinned point at the end of the way to it.
function pinMark({ points, x, values }, names, scale) {
  if (live.cut !== way) return [];
  const last = points.length - 1;
  const marker = { symbol: "square-open", size: 13, color: pinColours()[0], line: { width: 3 } };
  const y = [scale.to(values[last][names[0]])];
  return [{ type: "scatter", mode: "markers", x: [x[last]], y, marker, hoverinfo: "skip", showlegend: false }];
}

// The points of the curve as it was drawn last.
const drawn = { points: [] };

// The point of the curve that was clicked.
export const pointClicked = ({ pointNumber }) => drawn.points[pointNumber];

function tableOf({ points, values }) {
  const { axes } = surface();
  const names = quantityNames();
  const text = (x) => (x === Infinity ? "inf" : String(x));
  const rows = points.map((point, i) => [...point.map(text), ...names.map((name) => values[i][name])]);
  return [[...axes.map(({ name }) => name), ...names], ...rows];
}

export function drawLiveCurve() {
  const isWay = live.cut === way;
  const names = shownNames();
  const cut = isWay ? alongWay() : alongAxis(live.cut);
  drawn.points = cut.points;
  const scale = scaleFor(names, cut.values);
  const isNarrow = element("live-curve").clientWidth < 600;
  const m = surface().axes.findIndex(({ name }) => name === live.cut);
  const xaxis = isWay ? wayAxis(isNarrow) : pictureAxis(m, isNarrow ? 0.1 : 0.055);
  const ownTitle = isNarrow ? symbolOf(live.show) : wordsOf(live.show);
  const title = live.show === allFriction ? "friction coefficient" : ownTitle;
  const guide = { type: "line", xref: "x", yref: "paper", x0: cut.mark, x1: cut.mark, y0: 0, y1: 1 };
  const look = {
    // What was zoomed is left as it is until another cut is shown.
    xaxis: { ...xaxis, uirevision: live.cut },
    yaxis: { title: { text: scale.title(title) }, ...rangeOf(scale), ...scale.ticks() },
    shapes: [{ ...guide, line: { color: colour("--quiet"), width: 1, dash: "dot" }, layer: "below" }],
    showlegend: names.length > 1,
    legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0, traceorder: "reversed" },
    margin: { l: 60, r: 15, t: 30, b: 50 },
  };
  const traces = [...tracesOf(cut, names, scale), ...pinMark(cut, names, scale)];
  draw("live-curve", traces, look, () => tableOf(cut));
}
