// What the page of `stribeck report` draws with: lines and points, maps with level lines, surfaces.

const Plotly = require("plotly.js/lib/core");

Plotly.register([require("plotly.js/lib/heatmap"), require("plotly.js/lib/contour")]);

// Pictures in space need as much code again, which runs when the first of them is drawn.
Plotly.startSpace = () => Plotly.register([require("plotly.js/lib/surface"), require("plotly.js/lib/scatter3d")]);

module.exports = Plotly;
