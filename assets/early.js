// What the page of a report must know before anything of it is painted: its colours, and whether its address asks for
// another view than the one whose picture stands in it.

"use strict";
(() => {
  const root = document.documentElement;
  let stored = null;
  try {
    stored = sessionStorage.getItem("stribeck-theme");
  } catch {
    // A page from a file may be refused a storage; it then follows the system.
  }
  root.dataset.theme = stored ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
  if (window.location.hash.length > 1) root.dataset.linked = "";
})();
