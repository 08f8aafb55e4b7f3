// The page from its beginning: what is drawn when, and what follows a choice. The build of the program starts here.

import { showNumbers } from "./case.js";
import { fillControls, listenToControls, showStrength } from "./controls.js";
import { drawCurves } from "./curves.js";
import { listFailures } from "./failures.js";
import { fillHead } from "./head.js";
import { drawMap } from "./map.js";
import { canDraw, startPlotly } from "./picture.js";
import { nameQuantity } from "./plane.js";
import { drawFields } from "./profiles.js";
import { drawScatter } from "./scatter.js";
import { selection, whenSelected } from "./selection.js";
import { drawSurface } from "./surface.js";
import { arrangeTable, drawTableHead, listenToTable, markSelectedRow } from "./table.js";

function drawPlanePictures() {
  drawMap(selection);
  drawFields(selection);
  drawCurves(selection);
  drawScatter(selection);
}

function drawPictures() {
  if (!canDraw()) return;
  drawPlanePictures();
  drawSurface(selection);
}

whenSelected(() => {
  showStrength();
  showNumbers(selection);
  markSelectedRow();
  drawPictures();
});

function showWords() {
  fillHead();
  fillControls();
  listenToControls(drawPictures);
  listenToTable();
  nameQuantity(selection);
  showNumbers(selection);
  listFailures();
  drawTableHead();
  arrangeTable();
}

function startPictures() {
  startPlotly();
  drawPlanePictures();
}

// Each step after the one before is on the screen: words and table at once, then the plane pictures, and the one in
// space, which takes longest where there is no graphics processor, last.
const steps = [
  ["words", showWords],
  ["plane", startPictures],
  ["all", () => drawSurface(selection)],
];

function begin([[name, act], ...rest]) {
  act();
  document.body.dataset.drawn = name;
  if (rest.length) requestAnimationFrame(() => setTimeout(begin, 0, rest));
}

begin(steps);
