// The values of every quantity at the point, and at the pinned one, each with its error.

import { element, withText } from "./elements.js";
import { pointWords } from "./live_axes.js";
import { live } from "./live_point.js";
import { quantityNames, surface, withError, wordsOf } from "./live_surface.js";
import { digits, plural } from "./numbers.js";

// What is known of the error of a quantity.
function errorWords(name) {
  const { largest, percentile_99: most, median } = surface().certificate.errors[name];
  const [a, b, c] = [largest, most, median].map((error) => digits(error, 2));
  return `${name}: relative errors, the largest ${a}, 99 % below ${b}, the median ${c}`;
}

// A number, and its error, which stands below it where there is little room.
function cellOf(text) {
  const cell = document.createElement("td");
  const [number, error] = text.split(" ± ");
  cell.append(withText("span", number));
  if (error) cell.append(" ", withText("span", `± ${error}`));
  return cell;
}

function rowOf(name, columns) {
  const row = document.createElement("tr");
  row.title = errorWords(name);
  const head = withText("th", wordsOf(name));
  head.scope = "row";
  row.append(head, ...columns.map(({ values, errors }) => cellOf(withError(name, values[name], errors[name]))));
  return row;
}

export function showLiveValues() {
  const points = [live.point, ...(live.pin ? [live.pin] : [])];
  const columns = points.map((point) => {
    const values = surface().evaluate(point);
    return { values, errors: surface().errors(values) };
  });
  const heads = document.createElement("tr");
  const titles = live.pin ? ["", "here", "pinned"] : ["", "here"];
  heads.append(...titles.map((title) => withText("th", title)));
  document.querySelector("#live-values thead").replaceChildren(...(live.pin ? [heads] : []));
  document.querySelector("#live-values tbody").replaceChildren(
    ...quantityNames().map((name) => rowOf(name, columns)),
  );
  element("live-point").textContent = pointWords(live.point);
  element("live-pinned").textContent = live.pin ? `Pinned: ${pointWords(live.pin)}.` : "";
}

// What the errors are, once for all.
export function sayLiveErrors() {
  const { certificate, title, tolerance, evaluate, errors } = surface();
  const { points, cases, errors: measured } = certificate;
  const isAbove = Object.values(measured).some(({ largest }) => largest > tolerance);
  const isShare = Object.values(errors(evaluate(live.point))).some(Number.isNaN);
  const sentences = [
    `± is a number times the largest relative error of its quantity at ${points.toLocaleString("en")} random points: ` +
      "measured, not proved.",
    isShare ? "In percent it is that error, over the number or over its scale (a₀, or a₀²/R) if that is larger." : "",
    isAbove ? `An error is above the tolerance of ${digits(tolerance, 2)} that was asked for.` : "",
    `“${title}”, a surface made from ${plural(cases, "case")}.`,
  ];
  element("live-errors").textContent = sentences.filter(Boolean).join(" ");
}
