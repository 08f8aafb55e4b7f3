// The controls of the surface: for each axis a slider and a field beside it, and what is drawn.

import { element, say, withText } from "./elements.js";
import { labelAt, parseValue, roundValue, steps, symbolAt, valueText } from "./live_axes.js";
import { allFriction, cuts, live, scales, shows, way } from "./live_point.js";
import { surface, wordsOf } from "./live_surface.js";

const moved = (m, x) => live.point.map((other, i) => (i === m ? x : other));

const controls = [];

function sliderOf(m, id, choose) {
  const slider = document.createElement("input");
  Object.assign(slider, { type: "range", id, min: 0, max: steps, step: 1 });
  slider.addEventListener("input", () => choose({ point: moved(m, roundValue(m, Number(slider.value) / steps)) }));
  return slider;
}

// A field for a value in words. What it does not understand it leaves there, and says why.
function fieldOf(m, choose) {
  const field = document.createElement("input");
  Object.assign(field, { type: "text", size: 10, autocomplete: "off", spellcheck: false });
  field.setAttribute("aria-label", `${labelAt(m)}, a value`);
  field.addEventListener("change", () => {
    try {
      choose({ point: moved(m, parseValue(m, field.value, live.point[m])) });
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      field.setAttribute("aria-invalid", "true");
      say("live-said", error.message);
    }
  });
  return field;
}

// A line with the label and the field, and below it the slider between its ends.
function rowOf(m, choose) {
  const { name, from, to } = surface().axes[m];
  const slider = sliderOf(m, `live-${name}`, choose);
  const field = fieldOf(m, choose);
  field.id = `live-${name}-value`;
  const label = withText("label", labelAt(m));
  label.htmlFor = slider.id;
  const row = document.createElement("div");
  const [head, line] = ["div", "div"].map((tag) => document.createElement(tag));
  head.append(label, field);
  line.append(withText("span", valueText(m, from)), slider, withText("span", valueText(m, to)));
  row.append(head, line);
  controls.push({ slider, field });
  return row;
}

const cutWords = (cut) =>
  cut === way ? "to the pinned point" : `along ${symbolAt(surface().axes.findIndex((it) => it.name === cut))}`;
const showWords = (show) => (show === allFriction ? "friction and its parts" : wordsOf(show));
const scaleWords = { linear: "linear", log: "logarithmic" };

// Fills a list, and shows what is chosen of it.
function fillList(id, values, wordsFor, chosen) {
  element(id).replaceChildren(...values.map((value) => new Option(wordsFor(value), value)));
  element(id).value = chosen;
}

function togglePin(choose) {
  if (!live.pin) return choose({ pin: live.point });
  return choose({ pin: null, ...(live.cut === way ? { cut: cuts()[0] } : {}) });
}

// Makes the controls; `choose` takes what is chosen.
export function fillLiveControls(choose) {
  element("live-axes").replaceChildren(...surface().axes.map((_, m) => rowOf(m, choose)));
  for (const name of ["cut", "show", "scale"]) {
    element(`live-${name}`).addEventListener("change", (event) => choose({ [name]: event.target.value }));
  }
  element("live-pin").addEventListener("click", () => togglePin(choose));
}

export function showLiveControls() {
  controls.forEach(({ slider, field }, m) => {
    const x = live.point[m];
    slider.value = Math.round(steps * surface().axes[m].place(x));
    field.value = valueText(m, x);
    field.removeAttribute("aria-invalid");
    slider.setAttribute("aria-valuetext", field.value);
  });
  fillList("live-cut", cuts(), cutWords, live.cut);
  fillList("live-show", shows(), showWords, live.show);
  fillList("live-scale", scales, (scale) => scaleWords[scale], live.scale);
  element("live-pin").textContent = live.pin ? "unpin the point" : "pin this point";
}
