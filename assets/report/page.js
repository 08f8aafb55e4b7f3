// The state of the page, and what changes it.

const quantities = ["mu_tot", "mu_v", "mu_h", "mu_drag", "mu_h_cavity", "c", "film_min", "p_max", "x_outlet", "largest_error", "load_residual", "dry_mu_v", "approx_mu_h", ...(contents.laboratory ? ["alpha", "beta"] : []), ...(costs ? ["seconds", "iterations"] : [])];

// The first case shown is one that dissipates much, or the nearest that converged: the largest f, the α nearest to 1, in the
// middle of β; over quantities of the laboratory in the middle of these.
const middleOf = (values) => Math.floor(values.length / 2);
const firstPlace = placeAt(fs.length - 1, contents.laboratory ? middleOf(alphas) : nearest(alphaPlaces, 0), middleOf(betas));
const state = {
  quantity: "mu_tot",
  scale: "auto",
  place: nearestPlace(firstPlace, (place) => !failedAt[place]) ?? firstPlace,
  get iF() {
    return indicesOf(this.place)[0];
  },
};

// False until the drawing library is there.
let canDraw = false;

function select(place) {
  state.place = place;
  showStrength();
  showNumbers(state);
  markTableRow();
  drawPictures();
  document.body.dataset.place = place;
}

function drawPictures() {
  if (!canDraw) return;
  drawMap(state);
  drawFields(state);
  drawCurves(state);
  drawScatter(state);
  drawSurface(state);
}

function showStrength() {
  document.getElementById("f-slider").value = state.iF;
  document.getElementById("f-value").textContent = digits(fs[state.iF]);
  document.getElementById("f-slider").setAttribute("aria-valuetext", `f = ${digits(fs[state.iF])}`);
}

function fillHead() {
  const failed = contents.failures.count;
  const named = (numbers) => numbers.filter((_, axis) => axisWords[axis].symbol).join(" × ");
  const shape = named(axes.map((axis) => axis.length));
  const whole = named(contents.shape);
  const shapeWords = shape === whole ? shape : `${shape} of ${whole}, spread evenly`;
  document.title = contents.title;
  document.getElementById("title").textContent = contents.title;
  document.getElementById("counts").textContent = `${plural(placeCount, "place")} of (${axisWords.map((axis) => axis.symbol).filter(Boolean).join(", ")}): ${shapeWords}, ${plural(contents.cases.length, "case")}, ${failed ? `${failed} failed` : "none failed"}`;
  show("outdated", contents.outdated);
  document.getElementById("version").textContent = `Published by stribeck ${contents.version}. ${contents.laboratory ? "Numbers are in SI units; x of the fields is over a₀." : "Friction is over a₀/R, film and displacement over a₀²/R, x over a₀, pressure over 2N/(πa₀)."}`;
  document.getElementById("notes").replaceChildren(
    ...contents.notes.map((note) => {
      const item = document.createElement("li");
      item.textContent = note;
      return item;
    }),
  );
  const choice = document.getElementById("quantity");
  for (const name of quantities) choice.add(new Option(columns.has(name) ? `${symbols[name]}, ${longName(name)}` : longName(name), name));
  const slider = document.getElementById("f-slider");
  slider.max = fs.length - 1;
  show("f-control", fs.length > 1);
  showStrength();
}

function listen() {
  const on = (id, event, act) => document.getElementById(id).addEventListener(event, act);
  on("quantity", "change", (event) => {
    state.quantity = event.target.value;
    drawPictures();
  });
  on("scale", "change", (event) => {
    state.scale = event.target.value;
    drawPictures();
  });
  on("f-slider", "input", (event) => {
    const [, iAlpha, iBeta] = indicesOf(state.place);
    select(placeAt(Number(event.target.value), iAlpha, iBeta));
  });
  on("theme", "click", () => {
    setTheme(root.dataset.theme === "dark" ? "light" : "dark");
    drawPictures();
  });
  on("map", "keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const [iF, iAlpha, iBeta] = indicesOf(state.place);
    const within = (index, count) => Math.min(Math.max(index, 0), count - 1);
    select(placeAt(iF, within(iAlpha + step[0], alphas.length), within(iBeta + step[1], betas.length)));
  });
  on("surface", "keydown", turnSurface);
  on("filter", "input", () => {
    arrangeTable();
    drawTable();
  });
  on("previous", "click", () => turnPage(-PAGE));
  on("next", "click", () => turnPage(PAGE));
  on("download", "click", download);
}

function turnPage(by) {
  table.from += by;
  drawTable();
  document.getElementById("rows").scrollTop = 0;
}

// Points of curves and of the scatter know their place; those of surface and map stand there.
function clicked(id, point) {
  const onPlane = id === "surface" || id === "map";
  const place = onPlane ? placeAt(state.iF, nearest(alphaPlaces, point.x), nearest(betaPlaces, point.y)) : point.customdata;
  if (place !== undefined) select(place);
}

// Each step after the one before is on the screen: words and table at once, then the plane pictures, and the one in space, which
// takes longest where there is no graphics processor, last.
const steps = [
  [
    "words",
    () => {
      fillHead();
      listen();
      nameQuantity(state);
      showNumbers(state);
      drawFailures();
      drawTableHead();
      arrangeTable();
      drawTable();
    },
  ],
  [
    "plane",
    () => {
      const library = document.createElement("script");
      library.textContent = document.getElementById("plotly").textContent;
      document.head.append(library);
      canDraw = true;
      drawMap(state);
      drawFields(state);
      drawCurves(state);
      drawScatter(state);
    },
  ],
  [
    "all",
    () => {
      drawSurface(state);
    },
  ],
];

function begin([[name, act], ...rest]) {
  act();
  document.body.dataset.drawn = name;
  if (rest.length) requestAnimationFrame(() => setTimeout(begin, 0, rest));
}

begin(steps);
