// Renders formulas: reads a list of { source, display } as JSON, writes a list of { html } or { error }.
// KaTeX is in .tools/site, where scripts/site/packages installs it.

const path = require("node:path");
const katex = require(path.join(__dirname, "../../.tools/site/node_modules/katex"));

function render({ source, display }) {
  try {
    return { html: katex.renderToString(source, { displayMode: display, strict: "error", throwOnError: true }) };
  } catch (error) {
    return { error: error.message };
  }
}

const formulas = JSON.parse(require("node:fs").readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(formulas.map(render)));
