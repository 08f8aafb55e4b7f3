// What all pictures have in common: how they look, how they are drawn, and that a click on a point does something.

import { element } from "./elements.js";
import { colour, isOnPaper } from "./theme.js";

// Starts the drawing library, which the page holds as a text, if it has not started.
export function startPlotly() {
  if ("Plotly" in window) return;
  const library = document.createElement("script");
  library.textContent = element("plotly").textContent;
  document.head.append(library);
}

// The wheel scrolls the page, and on a touch screen a finger does: pictures leave both alone.
const touch = matchMedia("(pointer: coarse)").matches;
const config = {
  displaylogo: false,
  responsive: true,
  scrollZoom: false,
  displayModeBar: touch ? false : "hover",
  modeBarButtonsToRemove: ["lasso2d", "select2d", "toImage"],
};

// What goes round the selected case.
export const selectedMarker = { symbol: "circle-open", size: 15, color: "#D55E00", line: { width: 3 } };

function axisLook(axis) {
  return {
    gridcolor: colour("--line"),
    zerolinecolor: colour("--line"),
    linecolor: colour("--quiet"),
    automargin: true,
    exponentformat: "power",
    ...axis,
    title: { standoff: 14, ...axis.title },
  };
}

// The size of a picture on paper, with the heights of page.css: two of them, or a wide one, fit on A4 and on Letter. On
// the screen it is that of its element.
function sizeOf(id) {
  if (!isOnPaper()) return {};
  const is = (name) => element(id).classList.contains(name);
  return { width: is("wide") ? 690 : 340, height: is("tall") ? 300 : 260 };
}

function layout(more) {
  const text = { color: colour("--text") };
  const base = {
    paper_bgcolor: "rgba(0,0,0,0)",
    plot_bgcolor: "rgba(0,0,0,0)",
    font: { ...text, family: "system-ui, sans-serif", size: isOnPaper() ? 11 : 13 },
    margin: { l: 60, r: 15, t: 10, b: 50 },
    hoverlabel: { align: "left", bgcolor: colour("--raised"), bordercolor: colour("--quiet"), font: text },
    modebar: { bgcolor: "rgba(0,0,0,0)", color: colour("--quiet"), activecolor: colour("--accent") },
    showlegend: false,
    dragmode: touch ? false : "zoom",
    uirevision: "kept",
  };
  const made = { ...base, ...more };
  for (const name of ["xaxis", "yaxis"]) if (made[name]) made[name] = axisLook(made[name]);
  return made;
}

// What was painted into the page to be seen before this picture was drawn.
function removeFirst(picture) {
  picture.closest("figure").querySelector(".first")?.remove();
}

const clicked = [];

// Adds a function that is called with the id of a picture and the point in it that was clicked.
export const whenClicked = (act) => clicked.push(act);

// For each picture drawn a function that makes the rows of the table behind it.
const tables = new Map();
export const tableOf = (id) => tables.get(id)();

// Draws traces into the picture of this id, with what its layout has beside the common one, and keeps the function that
// makes its table. True if it is new.
export function draw(id, traces, more, table) {
  const picture = element(id);
  const isNew = !picture.on;
  tables.set(id, table);
  Plotly.react(picture, traces, layout({ ...more, ...sizeOf(id) }), config).then(() => removeFirst(picture));
  // Later, for a picture in space tells of a click while it is being drawn.
  const tell = (point) => clicked.forEach((act) => act(id, point));
  if (isNew) picture.on("plotly_click", (event) => setTimeout(tell, 0, event.points[0]));
  return isNew;
}
