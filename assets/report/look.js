// Light and dark, and what all pictures have in common.

const root = document.documentElement;
const style = (name) => getComputedStyle(root).getPropertyValue(name).trim();

function storedTheme() {
  // A page from a file may be refused a storage; it then follows the system.
  try {
    return sessionStorage.getItem("stribeck-theme");
  } catch {
    return null;
  }
}

function setTheme(theme) {
  root.dataset.theme = theme;
  const button = document.getElementById("theme");
  button.textContent = theme === "dark" ? "light" : "dark";
  button.setAttribute("aria-label", `change to ${button.textContent} colours`);
  try {
    sessionStorage.setItem("stribeck-theme", theme);
  } catch {
    // It is forgotten at the next load.
  }
}

setTheme(storedTheme() ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));

// The wheel scrolls the page, and on a touch screen a finger does: pictures leave both alone.
const touch = matchMedia("(pointer: coarse)").matches;
const config = { displaylogo: false, responsive: true, scrollZoom: false, displayModeBar: touch ? false : "hover", modeBarButtonsToRemove: ["lasso2d", "select2d"] };

// Okabe and Ito's colours, lighter on dark.
const kinds = () => (root.dataset.theme === "dark" ? ["#56B4E9", "#E69F00", "#2FD0A0", "#E7A3CB"] : ["#0072B2", "#D55E00", "#009E73", "#AA4499"]);

// What goes round the selected case.
const selectedMarker = { symbol: "circle-open", size: 15, color: "#D55E00", line: { width: 3 } };

function axisLook(axis) {
  return { gridcolor: style("--line"), zerolinecolor: style("--line"), linecolor: style("--quiet"), automargin: true, exponentformat: "power", ...axis };
}

function layout(more) {
  const base = {
    paper_bgcolor: "rgba(0,0,0,0)",
    plot_bgcolor: "rgba(0,0,0,0)",
    font: { color: style("--text"), family: "system-ui, sans-serif", size: 13 },
    margin: { l: 60, r: 15, t: 10, b: 50 },
    hoverlabel: { align: "left", bgcolor: style("--raised"), bordercolor: style("--quiet"), font: { color: style("--text") } },
    modebar: { bgcolor: "rgba(0,0,0,0)", color: style("--quiet"), activecolor: style("--accent") },
    showlegend: false,
    dragmode: touch ? false : "zoom",
    uirevision: "kept",
  };
  const made = { ...base, ...more };
  for (const name of ["xaxis", "yaxis"]) if (made[name]) made[name] = axisLook(made[name]);
  return made;
}

function draw(id, traces, more) {
  const picture = document.getElementById(id);
  const isNew = !picture.on;
  Plotly.react(picture, traces, layout(more), config);
  // Later, for a picture in space tells of a click while it is being drawn.
  if (isNew) picture.on("plotly_click", (event) => setTimeout(clicked, 0, id, event.points[0]));
}

const show = (id, shown) => {
  document.getElementById(id).hidden = !shown;
};
