// The quantity over α and β as a map.

import { axisPlaces, gridAxis } from "./axes.js";
import { indicesOf } from "./grid.js";
import { draw, selectedMarker } from "./picture.js";
import { pinMarks } from "./pins.js";
import { chosenPoint, nameQuantity, planeOf, planeTable } from "./plane.js";
import { colour } from "./theme.js";
import { wordsOf } from "./words.js";

// Made anew for each picture, for Plotly writes the levels that it chooses into it.
const contourLook = () => ({
  contours: { coloring: "none" },
  line: { color: "rgba(255,255,255,0.75)", width: 1 },
  ncontours: 12,
  showscale: false,
  hoverinfo: "skip",
  connectgaps: false,
});

export function drawMap(selection) {
  if (!nameQuantity(selection).map) return;
  const { scale, z, range, colours, crosses } = planeOf(selection);
  const [, x, y] = axisPlaces;
  const title = { text: scale.title(wordsOf(selection.quantity)), side: "right" };
  const colorbar = { title, thickness: 14, len: 0.9, ...scale.ticks() };
  const cross = { symbol: "x", size: 8, color: colour("--failed") };
  const { x: chosenX, y: chosenY } = chosenPoint(selection);
  draw(
    "map",
    [
      { type: "heatmap", x, y, z, ...colours, zmin: range[0], zmax: range[1], colorbar, hoverongaps: true },
      { type: "contour", x, y, z, ...contourLook() },
      { type: "scatter", mode: "markers", ...crosses, marker: cross, hovertemplate: "%{text}<extra></extra>" },
      ...pinMarks(selection, (pin) => x[indicesOf(pin)[1]], (pin) => y[indicesOf(pin)[2]]),
      { type: "scatter", mode: "markers", x: chosenX, y: chosenY, marker: selectedMarker, hoverinfo: "skip" },
    ],
    // Where labels would lie over each other they are turned.
    { xaxis: { ...gridAxis(1), tickangle: "auto" }, yaxis: gridAxis(2) },
    () => planeTable(selection),
  );
}
