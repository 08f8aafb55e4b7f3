// All cases as a table, a page of rows at a time.

import { downloadTable } from "./download.js";
import { button, element } from "./elements.js";
import { failedAt } from "./grid.js";
import { arrangedPlaces, tableColumns } from "./rows.js";
import { select, selection } from "./selection.js";
import { withUnit } from "./units.js";

const pageLength = 100;

// The column that the rows are sorted by, if any, the places of all rows, and the first row shown.
const table = { order: { name: null, descending: false }, places: [], from: 0 };

// Arranges the rows anew by filter and order, and shows the first.
export function arrangeTable() {
  table.places = arrangedPlaces(element("filter").value, table.order);
  table.from = 0;
  drawRows();
}

function sortBy(name) {
  const { order } = table;
  table.order = { name, descending: order.name === name && !order.descending };
  arrangeTable();
  element("rows").scrollTop = 0;
}

export function drawTableHead() {
  const row = document.createElement("tr");
  for (const { name, title } of tableColumns) {
    const head = document.createElement("th");
    head.scope = "col";
    head.dataset.column = name;
    head.title = name;
    head.append(button(title, () => sortBy(name)));
    row.append(head);
  }
  document.querySelector("#table thead").replaceChildren(row);
}

// Says in the head which column the rows are sorted by.
function markOrder() {
  const { name: sorted, descending } = table.order;
  document.querySelectorAll("#table th").forEach((head, i) => {
    const { name, title } = tableColumns[i];
    head.setAttribute("aria-sort", name !== sorted ? "none" : descending ? "descending" : "ascending");
    head.firstChild.textContent = name === sorted ? `${title} ${descending ? "▼" : "▲"}` : title;
  });
}

function tableRow(place) {
  const row = document.createElement("tr");
  row.tabIndex = 0;
  row.dataset.place = place;
  for (const { of, units = "" } of tableColumns) {
    const value = of(place);
    row.insertCell().textContent = typeof value === "number" ? withUnit(value, units, { count: 5 }) : value;
  }
  if (failedAt[place]) row.classList.add("failed");
  row.addEventListener("click", () => select(place));
  row.addEventListener("keydown", (event) => {
    if (event.key === "Enter") select(place);
  });
  return row;
}

function drawRows() {
  markOrder();
  const { places, from } = table;
  const last = Math.min(from + pageLength, places.length);
  document.querySelector("#table tbody").replaceChildren(...places.slice(from, last).map(tableRow));
  markSelectedRow();
  const count = places.length ? `${from + 1} to ${last} of ${places.length}` : "no case fits the filter";
  element("row-count").textContent = count;
  element("previous").disabled = from === 0;
  element("next").disabled = last >= places.length;
}

export function markSelectedRow() {
  for (const row of document.querySelectorAll("#table tbody tr")) {
    row.setAttribute("aria-selected", Number(row.dataset.place) === selection.place);
  }
}

function turnPage(by) {
  table.from += by * pageLength;
  drawRows();
  element("rows").scrollTop = 0;
}

export function listenToTable() {
  element("filter").addEventListener("input", arrangeTable);
  element("previous").addEventListener("click", () => turnPage(-1));
  element("next").addEventListener("click", () => turnPage(1));
  element("download").addEventListener("click", () => downloadTable(table.places));
}
