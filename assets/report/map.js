// The quantity over α and β as a map, and what the surface in space shows besides.

const isSurface = alphas.length > 1 && betas.length > 1;

// What failed cases cost is shown in the scatter; here they are holes.
const solvedOnly = (values) => values.map((value, place) => (failedAt[place] ? NaN : value));
const solvedCosts = costs && { seconds: solvedOnly(costs.seconds), iterations: solvedOnly(costs.iterations) };

function quantityValues(name) {
  if (name === "largest_error") return largestErrors;
  if (name === "seconds" || name === "iterations") return solvedCosts[name];
  return column(name);
}

// One row for each β.
const overPlane = (iF, cell) => betas.map((_, iBeta) => alphas.map((_, iAlpha) => cell(placeAt(iF, iAlpha, iBeta))));

// What surface and map show: numbers on their scale, one row for each β, with their colours. Kept until another quantity, scale, f
// or theme is shown: Plotly draws nothing again that is the same object as before.
let plane = { key: null };
function planeOf({ quantity, scale: choice, iF }) {
  const key = [quantity, choice, iF, root.dataset.theme].join(" ");
  if (plane.key === key) return plane;
  const values = quantityValues(quantity);
  const scale = scaleOf(values, choice);
  // A failed case has its known limits, and is a hole all the same.
  const z = overPlane(iF, (place) => (failedAt[place] ? NaN : scale.to(values[place])));
  const isEmpty = z.every((row) => row.every((value) => !Number.isFinite(value)));
  const places = overPlane(iF, (place) => place);
  const text = places.map((row) => row.map(hoverWords));
  const failed = places.flat().filter((place) => failedAt[place]);
  const crosses = {
    x: failed.map((place) => alphaPlaces[indicesOf(place)[1]]),
    y: failed.map((place) => betaPlaces[indicesOf(place)[2]]),
    text: failed.map(hoverWords),
  };
  plane = { key, scale, z, isEmpty, crosses, range: [scale.to(scale.low), scale.to(scale.high)], colours: { colorscale: "Viridis", hovertemplate: "%{text}<extra></extra>", text } };
  return plane;
}

// Says what is shown, and hides what cannot be: which of the two pictures can be drawn.
function nameQuantity(state) {
  const long = longName(state.quantity);
  document.getElementById("surface-title").textContent = `${long[0].toUpperCase()}${long.slice(1)}`;
  const { scale, isEmpty } = planeOf(state);
  const words = failedAt.every((failed) => failed)
    ? "Every case failed; the reasons are below."
    : scale.empty
      ? "No case has this number."
      : !isSurface
        ? alphaSymbol ? `A surface needs two values of ${alphaSymbol} and two of ${betaSymbol}: see the curves below.` : "A surface needs an axis between f and the speed, and there is none here: see the curves below."
        : isEmpty
          ? "At this f no case has this number, so there is no surface; what failed is × in the map."
          : "";
  document.getElementById("no-surface").textContent = words;
  show("no-surface", words !== "");
  const map = isSurface && !scale.empty;
  const surface = map && !isEmpty;
  show("surface-pair", map);
  show("hint", map);
  show("surface", surface);
  return { map, surface };
}

// Where the selected case stands in the plane.
function chosenPoint({ place }) {
  const [, iAlpha, iBeta] = indicesOf(place);
  return { iAlpha, iBeta, x: [alphaPlaces[iAlpha]], y: [betaPlaces[iBeta]] };
}

function drawMap(state) {
  if (!nameQuantity(state).map) return;
  const { scale, z, range, colours, crosses } = planeOf(state);
  const { x, y } = chosenPoint(state);
  const bar = { title: { text: axisName(state.quantity), side: "right" }, thickness: 14, len: 0.9, ...scale.ticks() };
  draw(
    "map",
    [
      { type: "heatmap", x: alphaPlaces, y: betaPlaces, z, ...colours, zmin: range[0], zmax: range[1], colorbar: bar, hoverongaps: true },
      { type: "contour", x: alphaPlaces, y: betaPlaces, z, contours: { coloring: "none" }, line: { color: "rgba(255,255,255,0.75)", width: 1 }, ncontours: 12, showscale: false, hoverinfo: "skip", connectgaps: false },
      { type: "scatter", mode: "markers", ...crosses, marker: { symbol: "x", size: 8, color: style("--failed") }, hovertemplate: "%{text}<extra></extra>" },
      { type: "scatter", mode: "markers", x, y, marker: selectedMarker, hoverinfo: "skip" },
    ],
    { xaxis: alphaAxis(), yaxis: betaAxis() },
  );
}
