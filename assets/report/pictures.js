// All pictures of the page: drawn one after the other on the screen, at once on paper, and again in other colours.

import { element } from "./elements.js";
import { startPlotly } from "./picture.js";
import { changeTheme, useOnPaper, useOnScreen } from "./theme.js";
import { drawAtOnce, drawInTurns } from "./turns.js";

// What is seen first is drawn first, and last a picture in space, which takes longest where there is no graphics
// processor.
const order = { soon: [], later: [], inSpace: [] };

// Adds functions that draw pictures, for when it is their turn: "soon", "later" or "inSpace".
export const addPictures = (when, draws) => order[when].push(...draws);

export const redraw = () => drawInTurns([...order.soon, ...order.later, ...order.inSpace]);

// Draws all for the first time. Words are on the screen before the drawing library starts, and with them the picture
// that the page was made with.
export function drawFirst() {
  const [own, ...rest] = [...order.soon, ...order.later, ...order.inSpace];
  const start = () => {
    startPlotly();
    own();
    performance.mark("first live picture");
  };
  drawInTurns([() => {}, start, ...rest]);
}

// Draws again for the other theme and for paper, where a map stands for what is in space, which could not be drawn in
// time.
export function followLook() {
  element("theme").addEventListener("click", () => {
    changeTheme();
    redraw();
  });
  window.addEventListener("beforeprint", () => {
    useOnPaper();
    drawAtOnce([startPlotly, ...order.soon, ...order.later]);
  });
  window.addEventListener("afterprint", () => {
    useOnScreen();
    redraw();
  });
}
