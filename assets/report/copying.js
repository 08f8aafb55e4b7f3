// Two buttons below each picture: its numbers as CSV, itself as PNG. They go to the clipboard, or into a file where the
// browser lets nothing be copied.

import { csv, saveFile } from "./csv.js";
import { button, element, withText } from "./elements.js";
import { tableOf } from "./picture.js";
import { colour } from "./theme.js";

async function pngOf(id) {
  const { data, layout, clientWidth: width, clientHeight: height } = element(id);
  const look = { ...layout, paper_bgcolor: colour("--paper") };
  const address = await Plotly.toImage({ data, layout: look }, { format: "png", width, height, scale: 2 });
  const raw = atob(address.split(",")[1]);
  return new Blob([Uint8Array.from(raw, (letter) => letter.charCodeAt(0))], { type: "image/png" });
}

const kinds = [
  { name: "CSV", type: "text/plain", ending: "csv", of: async (id) => csv(tableOf(id)) },
  { name: "PNG", type: "image/png", ending: "png", of: pngOf },
];

async function copy(id, { type, ending, of }, report) {
  report("…");
  const blob = new Blob([await of(id)], { type });
  try {
    await window.navigator.clipboard.write([new window.ClipboardItem({ [type]: blob })]);
    report("copied");
  } catch {
    saveFile(blob, `${id}.${ending}`);
    report(`saved as ${id}.${ending}, as this browser lets nothing be copied`);
  }
}

// Puts the buttons below all pictures.
export function addCopyButtons() {
  for (const { id } of document.querySelectorAll(".plot")) {
    const said = withText("span", "");
    said.setAttribute("role", "status");
    const report = (words) => {
      said.textContent = words;
    };
    const buttons = kinds.map((kind) => {
      const made = button(kind.name, () => copy(id, kind, report));
      made.setAttribute("aria-label", `copy ${element(id).dataset.name} as ${kind.name}`);
      return made;
    });
    const line = document.createElement("div");
    line.className = "copy";
    line.append("copy ", ...buttons, said);
    element(id).after(line);
  }
}
