// The quantity over α and β as a surface in space.

// Where the eye was left by pointer or keys. Until then a narrow picture has it farther away, to hold the labels.
let camera = null;
function beginningCamera() {
  const away = document.getElementById("surface").clientWidth < 420 ? 1.3 : 1;
  return { eye: { x: -1.1 * away, y: -1.4 * away, z: 1.2 * away }, center: { x: 0, y: 0, z: -0.15 }, up: { x: 0, y: 0, z: 1 } };
}

const padded = ([low, high]) => {
  const room = 0.03 * (high - low || 1);
  return [low - room, high + room];
};
const whole = (places) => padded([Math.min(...places), Math.max(...places)]);

function drawSurface(state) {
  if (!nameQuantity(state).surface) return;
  const { scale, z, range, colours } = planeOf(state);
  const { iAlpha, iBeta, x, y } = chosenPoint(state);
  const wall = { backgroundcolor: style("--raised"), showbackground: true, gridcolor: style("--line"), zerolinecolor: style("--line") };
  const mesh = { show: true, color: "rgba(0,0,0,0.25)", highlight: false };
  const picture = document.getElementById("surface");
  const isNew = !picture.on;
  draw(
    "surface",
    [
      {
        type: "surface", x: alphaPlaces, y: betaPlaces, z, ...colours, cmin: range[0], cmax: range[1], showscale: false,
        contours: { x: mesh, y: mesh, z: { highlight: false } },
        lighting: { ambient: 0.85, diffuse: 0.35, specular: 0.05 },
      },
      { type: "scatter3d", mode: "markers", x, y, z: [z[iBeta][iAlpha]], marker: { size: 6, color: "#D55E00", line: { color: "#fff", width: 2 } }, hoverinfo: "skip" },
    ],
    {
      margin: { l: 0, r: 0, t: 0, b: 0 },
      scene: {
        xaxis: { ...wall, ...alphaAxis(), title: { text: alphaSymbol }, range: whole(alphaPlaces) },
        yaxis: { ...wall, ...betaAxis(), title: { text: betaSymbol }, range: whole(betaPlaces) },
        zaxis: { ...wall, title: { text: axisName(state.quantity) }, range: padded(range), ...scale.ticks() },
        aspectratio: { x: 1.25, y: 1, z: 0.75 },
        dragmode: "turntable",
        camera: camera ?? beginningCamera(),
        uirevision: false,
      },
    },
  );
  if (isNew) picture.on("plotly_relayout", (change) => {
    camera = change["scene.camera"] ?? camera;
  });
}

// Arrow keys go round the surface and over it, + and − nearer and farther.
function turnSurface(event) {
  const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1], "+": [0, 0, 1 / 1.15], "-": [0, 0, 1.15] }[event.key];
  if (!turn || !canDraw) return;
  event.preventDefault();
  const [around, over, farther = 1] = turn;
  const from = camera ?? beginningCamera();
  const { x, y, z } = from.eye;
  const distance = farther * Math.hypot(x, y, z);
  const azimuth = Math.atan2(y, x) + around * (Math.PI / 18);
  const height = Math.min(Math.max(Math.asin(z / Math.hypot(x, y, z)) + over * (Math.PI / 24), -1.5), 1.5);
  const eye = { x: distance * Math.cos(height) * Math.cos(azimuth), y: distance * Math.cos(height) * Math.sin(azimuth), z: distance * Math.sin(height) };
  camera = { ...from, eye };
  Plotly.relayout("surface", { "scene.camera": camera });
}
