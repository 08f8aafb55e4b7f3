// Light and dark: the colours of the page and its pictures.

import { element } from "./elements.js";

const root = document.documentElement;

// A colour of page.css by its name, such as "--quiet".
export const colour = (name) => getComputedStyle(root).getPropertyValue(name).trim();

export const theme = () => root.dataset.theme;

function setTheme(name) {
  root.dataset.theme = name;
  const other = name === "dark" ? "light" : "dark";
  element("theme").textContent = other;
  element("theme").setAttribute("aria-label", `change to ${other} colours`);
  try {
    sessionStorage.setItem("stribeck-theme", name);
  } catch {
    // It is forgotten at the next load.
  }
}

// assets/early.js has chosen it.
setTheme(theme());

export const changeTheme = () => setTheme(theme() === "dark" ? "light" : "dark");

// On paper all is light, whatever the screen has.
export function useOnPaper() {
  root.dataset.screen = theme();
  root.dataset.theme = "light";
}

export function useOnScreen() {
  root.dataset.theme = root.dataset.screen;
  delete root.dataset.screen;
}

export const isOnPaper = () => "screen" in root.dataset;

// Okabe and Ito's colours, lighter on dark; darker ones for pinned cases.
const onDark = ["#56B4E9", "#E69F00", "#2FD0A0", "#E7A3CB"];
const onLight = ["#0072B2", "#D55E00", "#009E73", "#AA4499"];
export const lineColours = () => (theme() === "dark" ? onDark : onLight);

const pinsOnDark = ["#E69F00", "#2FD0A0", "#E7A3CB", "#F0E442"];
const pinsOnLight = ["#D55E00", "#009E73", "#AA4499", "#7A6400"];
export const pinColours = () => (theme() === "dark" ? pinsOnDark : pinsOnLight);
