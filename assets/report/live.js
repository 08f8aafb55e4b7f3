// Friction at any point: what follows when the reader moves on the surface.

import { writeAddress } from "./address.js";
import { element, say, show } from "./elements.js";
import { roundPoint } from "./live_axes.js";
import { fillLiveControls, showLiveControls } from "./live_controls.js";
import { drawLiveCurve, pointClicked } from "./live_curve.js";
import { addLivePoint, goToAddress, live } from "./live_point.js";
import { surface } from "./live_surface.js";
import { sayLiveErrors, showLiveValues } from "./live_values.js";
import { whenClicked } from "./picture.js";
import { addPictures } from "./pictures.js";

// Milliseconds without a move after which the address follows: browsers let it change only so often.
const rest = 250;

// "new", "begun", or "refused" if the surface cannot be read.
const state = { is: "new", isDrawing: false, waiting: null };

function showAll() {
  showLiveControls();
  showLiveValues();
  if ("Plotly" in window) drawLiveCurve();
  element("live").dataset.shown = "all";
}

// Shows what was chosen in the next frame, however often something was chosen before it.
function follow() {
  element("live").dataset.shown = "some";
  if (state.isDrawing) return;
  state.isDrawing = true;
  requestAnimationFrame(() => {
    state.isDrawing = false;
    showAll();
  });
}

function choose(chosen) {
  Object.assign(live, chosen);
  say("live-said", "");
  follow();
  clearTimeout(state.waiting);
  state.waiting = setTimeout(writeAddress, rest);
}

function followAddress() {
  const missing = goToAddress();
  const words = `This link asks for what is not on this surface: ${missing.join("; ")}.`;
  say("live-said", missing.length ? `${words} In its place stands the default.` : "");
  follow();
}

// Reads the surface and shows it, if that was not done before. False if the surface cannot be read, which is said.
export function beginLive() {
  if (state.is !== "new") return state.is === "begun";
  try {
    surface();
    state.is = "begun";
  } catch (error) {
    state.is = "refused";
    say("live-refused", `The surface in this page is not shown. ${error.message}`);
    show("live-body", false);
    element("live").dataset.shown = "all";
    return false;
  }
  fillLiveControls(choose);
  followAddress();
  sayLiveErrors();
  return true;
}

// Adds the surface to the page, which it begins when it is the turn of its picture.
export function addLive() {
  addLivePoint(followAddress);
  addPictures("later", [
    () => {
      if (beginLive()) drawLiveCurve();
    },
  ]);
  whenClicked((id, point) => {
    const to = id === "live-curve" ? pointClicked(point) : undefined;
    if (to) choose({ point: roundPoint(to) });
  });
}
