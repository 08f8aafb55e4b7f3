// The numbers of the selected case.

import { column, columns, costs, headline } from "./columns.js";
import { contents, integers } from "./contents.js";
import { element, withText } from "./elements.js";
import { caseOf, failedAt } from "./grid.js";
import { digits } from "./numbers.js";
import { longName, pointWords, symbols, unitOf } from "./words.js";

const reasonIndices = integers(contents.failures.reason_of);

// Why a case failed. With very many different reasons not all are in the page.
export const reasonOf = (place) => contents.failures.reasons[reasonIndices[place]] ?? "the reason is in summary.csv";

const withUnit = (value, name) => (Number.isNaN(value) ? digits(value) : `${digits(value, 5)} ${unitOf(name)}`.trim());

// The rows of the list: symbol, number, and what is said when the pointer rests on them.
function rowsOf(place) {
  const rows = [...columns.keys()].map((name) => [symbols[name], withUnit(column(name)[place], name), longName(name)]);
  if (costs) {
    rows.push(["solved in", `${digits(costs.seconds[place], 3)} s`, "seconds on its thread"]);
    rows.push(["iterations", digits(costs.iterations[place]), "iterations"]);
    rows.push(["seed", contents.costs.seeds[costs.seedOf[place]], "where the first guess came from"]);
  }
  return [...rows, ["id", contents.cases[caseOf[place]], "id of the case, for `stribeck explain`"]];
}

export function showNumbers({ place }) {
  const friction = `${symbols[headline]} = ${digits(column(headline)[place])} ${unitOf(headline)}`.trim();
  const outcome = failedAt[place] ? `failed, ${reasonOf(place)}` : `converged, ${friction}`;
  element("selected").textContent = `${pointWords(place)}: ${outcome}`;
  element("numbers").replaceChildren(
    ...rowsOf(place).map(([name, value, title]) => {
      const row = document.createElement("div");
      row.title = title;
      row.append(withText("dt", name), withText("dd", value));
      return row;
    }),
  );
}
