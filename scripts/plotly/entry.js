// What the page of `stribeck report` draws with: lines and points, maps with level lines, surfaces.

const Plotly = require("plotly.js/lib/core");

Plotly.register([
  require("plotly.js/lib/heatmap"),
  require("plotly.js/lib/contour"),
  require("plotly.js/lib/surface"),
  require("plotly.js/lib/scatter3d"),
]);

module.exports = Plotly;
