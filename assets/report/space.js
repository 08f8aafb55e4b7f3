// The quantity over α and β as a surface in space.

import { axisPlaces, gridAxis } from "./axes.js";
import { element } from "./elements.js";
import { axisWords } from "./grid.js";
import { draw } from "./picture.js";
import { chosenPoint, nameQuantity, planeOf, planeTable } from "./plane.js";
import { symbols } from "./symbols.js";
import { colour } from "./theme.js";

// Where the eye was left by pointer or keys. Until then a narrow picture has it farther away, to hold the labels.
let camera = null;
function beginningCamera() {
  const away = element("surface").clientWidth < 420 ? 1.45 : 1;
  return {
    eye: { x: -1.1 * away, y: -1.4 * away, z: 1.2 * away },
    center: { x: 0, y: 0, z: -0.15 },
    up: { x: 0, y: 0, z: 1 },
  };
}

const padded = ([low, high]) => {
  const room = 0.03 * (high - low || 1);
  return [low - room, high + room];
};

function sceneOf(selection) {
  const { scale, range } = planeOf(selection);
  const wall = {
    backgroundcolor: colour("--raised"),
    showbackground: true,
    gridcolor: colour("--line"),
    zerolinecolor: colour("--line"),
  };
  const over = (axis) => {
    const places = axisPlaces[axis];
    const ends = [Math.min(...places), Math.max(...places)];
    return { ...wall, ...gridAxis(axis), title: { text: axisWords[axis].symbol }, range: padded(ends) };
  };
  // The heading has the whole name, for which there is no room in space.
  const title = { text: scale.title(symbols[selection.quantity] ?? "") };
  return {
    xaxis: over(1),
    yaxis: over(2),
    zaxis: { ...wall, title, range: padded(range), ...scale.ticks() },
    aspectratio: { x: 1.25, y: 1, z: 0.75 },
    dragmode: "turntable",
    camera: camera ?? beginningCamera(),
    uirevision: false,
  };
}

function surfaceLook() {
  const mesh = { show: true, color: "rgba(0,0,0,0.25)", highlight: false };
  return {
    showscale: false,
    contours: { x: mesh, y: mesh, z: { highlight: false } },
    lighting: { ambient: 0.85, diffuse: 0.35, specular: 0.05 },
  };
}

export function drawSurface(selection) {
  if (!nameQuantity(selection).surface) return;
  if (!element("surface").on) Plotly.startSpace();
  const { z, range, colours } = planeOf(selection);
  const [, alphaPlaces, betaPlaces] = axisPlaces;
  const marker = { size: 6, color: "#D55E00", line: { color: "#fff", width: 2 } };
  const limits = { cmin: range[0], cmax: range[1] };
  const { iAlpha, iBeta, x, y } = chosenPoint(selection);
  const isNew = draw(
    "surface",
    [
      { type: "surface", x: alphaPlaces, y: betaPlaces, z, ...colours, ...limits, ...surfaceLook() },
      { type: "scatter3d", mode: "markers", x, y, z: [z[iBeta][iAlpha]], marker, hoverinfo: "skip" },
    ],
    { margin: { l: 0, r: 0, t: 0, b: 0 }, scene: sceneOf(selection) },
    () => planeTable(selection),
  );
  if (!isNew) return;
  element("surface").on("plotly_relayout", (change) => {
    camera = change["scene.camera"] ?? camera;
  });
}

const turns = {
  ArrowLeft: { around: -1 },
  ArrowRight: { around: 1 },
  ArrowUp: { over: 1 },
  ArrowDown: { over: -1 },
  "+": { farther: 1 / 1.15 },
  "-": { farther: 1.15 },
};

// Arrow keys go round the surface and over it, + and − nearer and farther.
export function turnSurface(event) {
  const turn = turns[event.key];
  if (!turn || !element("surface").on) return;
  event.preventDefault();
  const { around = 0, over = 0, farther = 1 } = turn;
  const from = camera ?? beginningCamera();
  const { x, y, z } = from.eye;
  const distance = Math.hypot(x, y, z);
  const azimuth = Math.atan2(y, x) + around * (Math.PI / 18);
  const height = Math.min(Math.max(Math.asin(z / distance) + over * (Math.PI / 24), -1.5), 1.5);
  const [level, away] = [Math.cos(height), farther * distance];
  const eye = {
    x: away * level * Math.cos(azimuth),
    y: away * level * Math.sin(azimuth),
    z: away * Math.sin(height),
  };
  camera = { ...from, eye };
  Plotly.relayout("surface", { "scene.camera": camera });
}
