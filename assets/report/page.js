// The page from its beginning: what is drawn when, and what follows a choice. The build of the program starts here.

import { readAddress, writeAddress } from "./address.js";
import { showNumbers } from "./case.js";
import { fillControls, listenToControls, showChoice } from "./controls.js";
import { addCopyButtons } from "./copying.js";
import { drawCurves } from "./curves.js";
import { listFailures } from "./failures.js";
import { beginsWithFriction, drawFriction, sayFriction } from "./friction.js";
import { fillHead } from "./head.js";
import { drawMap } from "./map.js";
import { startPlotly } from "./picture.js";
import { listenToPin, showPins } from "./pins.js";
import { nameQuantity } from "./plane.js";
import { drawFields } from "./profiles.js";
import { drawScatter } from "./scatter.js";
import { selection, whenChosen } from "./selection.js";
import { drawSurface } from "./surface.js";
import { arrangeTable, drawTableHead, listenToTable, markSelectedRow } from "./table.js";
import { useOnPaper, useOnScreen } from "./theme.js";
import { drawAtOnce, drawInTurns } from "./turns.js";

// What is seen first is drawn first, and last the picture in space, which takes longest where there is no graphics
// processor.
const first = beginsWithFriction ? [drawFriction, drawMap] : [drawMap];
const pictures = [...first, drawCurves, drawFields, drawScatter].map((draw) => () => draw(selection));
const inSpace = () => drawSurface(selection);

function showWords() {
  showChoice();
  showNumbers(selection);
  showPins();
  markSelectedRow();
}

const redraw = () => drawInTurns([...pictures, inSpace]);

function followChoice() {
  writeAddress();
  showWords();
  redraw();
}

function followAddress() {
  readAddress();
  showWords();
  redraw();
}

function listen() {
  whenChosen(followChoice);
  listenToControls(redraw);
  listenToPin();
  listenToTable();
  window.addEventListener("hashchange", followAddress);
  // On paper the map stands for the surface, which could not be drawn in time.
  window.addEventListener("beforeprint", () => {
    useOnPaper();
    drawAtOnce([startPlotly, ...pictures]);
  });
  window.addEventListener("afterprint", () => {
    useOnScreen();
    redraw();
  });
}

// Words are on the screen before the drawing library starts, and with them the picture that the page was made with.
function begin() {
  readAddress();
  fillHead();
  fillControls();
  addCopyButtons();
  nameQuantity(selection);
  sayFriction(selection);
  drawTableHead();
  arrangeTable();
  showWords();
  listFailures();
  listen();
  const [own, ...rest] = pictures;
  const drawFirst = () => {
    startPlotly();
    own();
    performance.mark("first live picture");
  };
  drawInTurns([() => {}, drawFirst, ...rest, inSpace]);
}

begin();
