// The largest estimated error of each case against the seconds it took; failed cases stand in a row of their own above.

import { axisPlaces } from "./axes.js";
import { costs, largestErrors } from "./columns.js";
import { say, showPicture } from "./elements.js";
import { axes, axisWords, caseOf, failedAt, indicesOf, placeCount } from "./grid.js";
import { plural } from "./numbers.js";
import { draw, selectedMarker } from "./picture.js";
import { placesTable } from "./tables.js";
import { colour, lineColours, theme } from "./theme.js";
import { logTicks } from "./ticks.js";
import { hoverWords, wordsAt, wordsOf } from "./words.js";

const [fs] = axes;
const [fPlaces] = axisPlaces;

// One place of each case, however often it stands in the sweep: those with an error to show, failed ones, others.
const places = { known: [], failed: [], unknown: [] };
if (costs) {
  const seen = new Set();
  for (let place = 0; place < placeCount; place++) {
    if (seen.has(caseOf[place])) continue;
    seen.add(caseOf[place]);
    places[failedAt[place] ? "failed" : largestErrors[place] > 0 ? "known" : "unknown"].push(place);
  }
}

// What the clock could not tell from nothing stands at a millionth of a second.
const secondsPlace = (place) => Math.log10(Math.max(costs.seconds[place], 1e-6));
const errorPlace = (place) => Math.log10(largestErrors[place]);

// What the scatter does not show, and what its upper row is.
function scatterWords() {
  const { known, failed, unknown } = places;
  if (!costs) return "There is no timings.csv beside the data set, so nothing is known of seconds.";
  const estimate = "With the relaxation method a sweep asks for estimates by estimate = true.";
  return [
    known.length ? "" : "No case has an estimated error above zero.",
    unknown.length ? `Not shown: ${plural(unknown.length, "case")} without an estimate above zero. ${estimate}` : "",
    failed.length ? `${plural(failed.length, "failed case")} in the row above, as ×.` : "",
  ]
    .join(" ")
    .trim();
}

function points(shown, y, marker, more) {
  return {
    ...{ type: "scatter", mode: "markers", x: shown.map(secondsPlace), y: shown.map(y), customdata: shown },
    text: shown.map(hoverWords),
    hovertemplate: "%{text}<extra></extra>",
    marker: { size: 6, opacity: 0.65, ...marker },
    ...more,
  };
}

// A few values of f have a colour and a shape each; many share a scale of colours.
function knownPoints() {
  const { known } = places;
  if (fs.length > 4) {
    const { values: tickvals, text: ticktext } = logTicks(Math.min(...fPlaces), Math.max(...fPlaces));
    const title = { text: axisWords[0].symbol, side: "right" };
    const colorbar = { title, thickness: 14, tickmode: "array", tickvals, ticktext };
    const color = known.map((place) => fPlaces[indicesOf(place)[0]]);
    const more = { name: "converged", showlegend: false };
    return [points(known, errorPlace, { color, colorscale: "Viridis", colorbar }, more)];
  }
  const shapes = ["circle", "square", "triangle-up", "diamond"];
  return fs.map((_, iF) => {
    const own = known.filter((place) => indicesOf(place)[0] === iF);
    return points(own, errorPlace, { color: lineColours()[iF], symbol: shapes[iF] }, { name: wordsAt(0, iF) });
  });
}

const ends = (list) => list.reduce(([low, high], x) => [Math.min(low, x), Math.max(high, x)], [Infinity, -Infinity]);

// All but the mark of the selected case; kept until another theme is shown.
let cloud = { theme: null };
function cloudOf(name) {
  if (cloud.theme === name) return cloud;
  const { known, failed } = places;
  const all = [...known, ...failed];
  const [fast, slow] = ends(all.map(secondsPlace));
  const [small, large] = known.length ? ends(known.map(errorPlace)) : [-1, 0];
  const times = logTicks(fast - 0.1, slow + 0.1, "s");
  const errors = known.length ? logTicks(small - 0.1, large + 0.1) : { values: [], text: [] };
  const row = large + 0.12 * (large - small) + 0.3;
  const traces = knownPoints();
  if (failed.length) {
    traces.push(points(failed, () => row, { symbol: "x", color: colour("--failed") }, { name: "failed" }));
    errors.values.push(row);
    errors.text.push("failed");
  }
  const axis = (text, ticks, range) => {
    return { title: { text }, tickmode: "array", tickvals: ticks.values, ticktext: ticks.text, range };
  };
  const look = {
    xaxis: axis(wordsOf("seconds"), times, [fast - 0.15, slow + 0.15]),
    yaxis: axis(wordsOf("largest_error"), errors, [small - 0.3, (failed.length ? row : large) + 0.3]),
    showlegend: fs.length <= 4 && (fs.length > 1 || failed.length > 0),
    legend: { orientation: "h", y: 1.02, yanchor: "bottom" },
    margin: { l: 60, r: 15, t: 40, b: 50 },
  };
  cloud = { theme: name, all, row, traces, look };
  return cloud;
}

// A ring round the selected case: a shape, for another trace would have thousands of points computed again.
function ringAt(xanchor, yanchor) {
  const { size, color, line } = selectedMarker;
  const [low, high] = [-size / 2, size / 2];
  const pixels = { xsizemode: "pixel", ysizemode: "pixel", x0: low, x1: high, y0: low, y1: high };
  return { type: "circle", ...pixels, line: { ...line, color }, xanchor, yanchor };
}

export function drawScatter({ place: selected }) {
  say("no-scatter", scatterWords());
  const possible = places.known.length + places.failed.length > 0;
  showPicture("scatter", possible);
  if (!possible) return;
  const { all, row, traces, look } = cloudOf(theme());
  const chosen = all.filter((place) => caseOf[place] === caseOf[selected]);
  const shapes = chosen.map((place) => ringAt(secondsPlace(place), failedAt[place] ? row : errorPlace(place)));
  draw("scatter", traces, { ...look, shapes }, () => placesTable(all, ["seconds", "largest_error"]));
}
