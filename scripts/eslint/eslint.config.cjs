// What ESLint asks of the scripts of the page; scripts/lint-page runs it. This file is no ES module, as those cannot be
// told where the packages are.

const { configs } = require("@eslint/js");

// All that the scripts take from the browser, and Plotly, which the page starts itself.
const globals = [
  ...["Blob", "Option", "Plotly", "URL", "URLSearchParams", "atob", "clearTimeout", "document", "getComputedStyle"],
  ...["matchMedia", "performance", "requestAnimationFrame", "sessionStorage", "setTimeout", "window"],
];

module.exports = [
  { ignores: ["assets/plotly/"] },
  configs.recommended,
  {
    languageOptions: {
      // Browsers of 2021 or later.
      ecmaVersion: 2021,
      sourceType: "module",
      globals: Object.fromEntries(globals.map((name) => [name, "readonly"])),
    },
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      eqeqeq: "error",
      "max-len": ["error", 120],
      "max-lines-per-function": ["error", 60],
      "max-params": ["error", 5],
      "no-duplicate-imports": "error",
      "no-shadow": "error",
      "no-var": "error",
      "prefer-const": "error",
    },
  },
];
