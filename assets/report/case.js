// The numbers of the selected case, with their estimated errors.

import { column, columns, costs, headline } from "./columns.js";
import { contents, integers } from "./contents.js";
import { element, withText } from "./elements.js";
import { errorAt } from "./errors.js";
import { caseOf, failedAt } from "./grid.js";
import { digits } from "./numbers.js";
import { symbols } from "./symbols.js";
import { withUnit } from "./units.js";
import { pointWords, valueOf, wordsOf } from "./words.js";

const reasonIndices = integers(contents.failures.reason_of);

// Why a case failed. With very many different reasons not all are in the page.
export const reasonOf = (place) => contents.failures.reasons[reasonIndices[place]] ?? "the reason is in summary.csv";

const withError = (name, place) => valueOf(name, column(name)[place], { count: 5, error: errorAt(name, place) });

// The rows of the list: what a number is, the number, and its name in the terminal and in files. An estimated error
// stands beside its number.
function rowsOf(place) {
  const errors = new Set([...columns.values()].map(({ error }) => error));
  const names = [...columns.keys()].filter((name) => !errors.has(name));
  const rows = names.map((name) => [wordsOf(name), withError(name, place), name]);
  if (costs) {
    rows.push(["solved in", withUnit(costs.seconds[place], "s", { count: 3 })]);
    rows.push(["iterations", digits(costs.iterations[place])]);
    rows.push(["first guess from", contents.costs.seeds[costs.seedOf[place]]]);
  }
  return [...rows, ["id, for `stribeck explain`", contents.cases[caseOf[place]]]];
}

export function showNumbers({ place }) {
  const friction = `${symbols[headline]} = ${valueOf(headline, column(headline)[place])}`;
  const outcome = failedAt[place] ? `failed, ${reasonOf(place)}` : `converged, ${friction}`;
  element("selected").textContent = `${pointWords(place)}: ${outcome}`;
  element("numbers").replaceChildren(
    ...rowsOf(place).map(([words, value, name = ""]) => {
      const row = document.createElement("div");
      row.title = name;
      row.append(withText("dt", words), withText("dd", value));
      return row;
    }),
  );
}
