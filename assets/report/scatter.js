// The largest estimated error of each case against the seconds it took; failed cases in a row of their own above.

// Each case once, however often it stands in the sweep: the places of those with an error to show, of the failed ones, of others.
const scattered = { known: [], failed: [], unknown: [] };
if (costs) {
  const seen = new Set();
  for (let place = 0; place < placeCount; place++) {
    if (seen.has(caseOf[place])) continue;
    seen.add(caseOf[place]);
    (failedAt[place] ? scattered.failed : largestErrors[place] > 0 ? scattered.known : scattered.unknown).push(place);
  }
}

// What the clock could not tell from nothing stands at a millionth of a second.
const secondsPlace = (place) => Math.log10(Math.max(costs.seconds[place], 1e-6));
const errorPlace = (place) => Math.log10(largestErrors[place]);

function scatterWords() {
  const { known, failed, unknown } = scattered;
  if (!costs) return "There is no timings.csv beside the data set, so nothing is known of seconds.";
  return [
    known.length ? "" : "No case has an estimated error above zero.",
    unknown.length ? `Not shown: ${plural(unknown.length, "case")} without an estimate above zero. With the relaxation method a sweep asks for estimates by estimate = true.` : "",
    failed.length ? `${plural(failed.length, "failed case")} in the row above, as ×.` : "",
  ].join(" ").trim();
}

function points(places, y, marker, more) {
  return { type: "scatter", mode: "markers", x: places.map(secondsPlace), y: places.map(y), customdata: places, text: places.map(hoverWords), hovertemplate: "%{text}<extra></extra>", marker: { size: 6, opacity: 0.65, ...marker }, ...more };
}

// A few values of f have a colour and a shape each; many share a scale of colours.
function knownPoints() {
  const { known } = scattered;
  if (fs.length > 4) {
    const { values: tickvals, text: ticktext } = logTicks(Math.min(...fPlaces), Math.max(...fPlaces));
    const colorbar = { title: { text: "f", side: "right" }, thickness: 14, tickmode: "array", tickvals, ticktext };
    return [points(known, errorPlace, { color: known.map((place) => fPlaces[indicesOf(place)[0]]), colorscale: "Viridis", colorbar }, { name: "converged", showlegend: false })];
  }
  return fs.map((f, iF) => {
    const own = known.filter((place) => indicesOf(place)[0] === iF);
    return points(own, errorPlace, { color: kinds()[iF], symbol: ["circle", "square", "triangle-up", "diamond"][iF] }, { name: `f = ${digits(f)}` });
  });
}

// All but the mark of the selected case; kept until another theme is shown.
let cloud = { theme: null };
function cloudOf(theme) {
  if (cloud.theme === theme) return cloud;
  const { known, failed } = scattered;
  const all = [...known, ...failed];
  const ends = (list) => list.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
  const [fast, slow] = ends(all.map(secondsPlace));
  const [small, large] = known.length ? ends(known.map(errorPlace)) : [-1, 0];
  const times = logTicks(fast - 0.1, slow + 0.1);
  const errors = known.length ? logTicks(small - 0.1, large + 0.1) : { values: [], text: [] };
  const row = large + 0.12 * (large - small) + 0.3;
  const traces = knownPoints();
  if (failed.length) {
    traces.push(points(failed, () => row, { symbol: "x", color: style("--failed") }, { name: "failed" }));
    errors.values.push(row);
    errors.text.push("failed");
  }
  const look = {
    xaxis: { title: { text: "seconds for a case  (s)" }, tickmode: "array", tickvals: times.values, ticktext: times.text, range: [fast - 0.15, slow + 0.15] },
    yaxis: { title: { text: "largest relative error" }, tickmode: "array", tickvals: errors.values, ticktext: errors.text, range: [small - 0.3, (failed.length ? row : large) + 0.3] },
    showlegend: fs.length <= 4 && (fs.length > 1 || failed.length > 0),
    legend: { orientation: "h", y: 1.02, yanchor: "bottom" },
    margin: { l: 60, r: 15, t: 40, b: 50 },
  };
  cloud = { theme, all, row, traces, look };
  return cloud;
}

function drawScatter({ place: selected }) {
  const words = scatterWords();
  document.getElementById("no-scatter").textContent = words;
  show("no-scatter", words !== "");
  const possible = scattered.known.length + scattered.failed.length > 0;
  show("scatter", possible);
  if (!possible) return;
  const { all, row, traces, look } = cloudOf(root.dataset.theme);
  const chosen = all.filter((place) => caseOf[place] === caseOf[selected]);
  // A shape, for another trace would have thousands of points computed again.
  const { size, color, line } = selectedMarker;
  const ring = { type: "circle", xsizemode: "pixel", ysizemode: "pixel", x0: -size / 2, x1: size / 2, y0: -size / 2, y1: size / 2, line: { ...line, color } };
  const shapes = chosen.map((place) => ({ ...ring, xanchor: secondsPlace(place), yanchor: failedAt[place] ? row : errorPlace(place) }));
  draw("scatter", traces, { ...look, shapes });
}
