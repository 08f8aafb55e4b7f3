// What a page shows of a sweep: what is drawn when, and what follows a choice.

import { readAddress, writeAddress } from "./address.js";
import { showNumbers } from "./case.js";
import { fillControls, listenToControls, showChoice } from "./controls.js";
import { addCopyButtons } from "./copying.js";
import { drawCurves } from "./curves.js";
import { listFailures } from "./failures.js";
import { beginsWithFriction, drawFriction, sayFriction } from "./friction.js";
import { fillHead } from "./head.js";
import { drawMap } from "./map.js";
import { whenClicked } from "./picture.js";
import { addPictures, drawFirst, followLook, redraw } from "./pictures.js";
import { listenToPin, showPins } from "./pins.js";
import { nameQuantity } from "./plane.js";
import { drawFields } from "./profiles.js";
import { drawScatter } from "./scatter.js";
import { selection, selectPoint, whenChosen } from "./selection.js";
import { drawSurface } from "./space.js";
import { arrangeTable, drawTableHead, listenToTable, markSelectedRow } from "./table.js";
import { addView } from "./view.js";

function showWords() {
  showChoice();
  showNumbers(selection);
  showPins();
  markSelectedRow();
}

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
  whenClicked(selectPoint);
  listenToControls();
  listenToPin();
  listenToTable();
  followLook();
  window.addEventListener("hashchange", followAddress);
}

const own = (draw) => () => draw(selection);

export function beginSweep() {
  addView();
  const first = beginsWithFriction ? [drawFriction, drawMap] : [drawMap];
  addPictures("soon", [...first, drawCurves, drawFields, drawScatter].map(own));
  addPictures("inSpace", [own(drawSurface)]);
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
  drawFirst();
}
