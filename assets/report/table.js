// All cases as a table that can be sorted, filtered and downloaded; the failed ones by their reasons.

const PAGE = 100;
const shownColumns = ["mu_tot", "mu_v", "mu_h", "c", "film_min", "p_max", "x_outlet"];
const axisTitle = (axis) => [axisWords[axis].symbol, axisWords[axis].unit && `(${axisWords[axis].unit})`].filter(Boolean).join(" ");
const tableColumns = [
  { name: "f", title: "f", of: (place) => fs[indicesOf(place)[0]] },
  ...(alphaSymbol ? [{ name: axisWords[1].name, title: axisTitle(1), of: (place) => axisWords[1].combinations[indicesOf(place)[1]] ?? alphas[indicesOf(place)[1]] }] : []),
  { name: axisWords[2].name, title: axisTitle(2), of: (place) => betas[indicesOf(place)[2]] },
  { name: "status", title: "status", of: (place) => (failedAt[place] ? "failed" : "converged") },
  ...shownColumns.map((name) => ({ name, title: axisName(name), of: (place) => column(name)[place] })),
  { name: "largest_error", title: "largest error", of: (place) => largestErrors[place] },
  ...(costs ? [{ name: "seconds", title: "seconds", of: (place) => costs.seconds[place] }] : []),
];

const table = { sort: null, descending: false, from: 0, rows: [] };

const cellText = (value) => (typeof value === "number" ? digits(value, 5) : value);
const rowWords = (place) => `${pointWords(place)}, ${failedAt[place] ? "failed" : "converged"}`;

function arrangeTable() {
  const wanted = document.getElementById("filter").value.trim().toLowerCase();
  // "f = 10" is not to find f = 100: each part is a whole one of the row.
  const parts = wanted.split(",").map((part) => part.replace(/\s*=\s*/, " = ").trim()).filter(Boolean);
  const all = Array.from({ length: placeCount }, (_, place) => place);
  table.rows = parts.length
    ? all.filter((place) => {
        const own = rowWords(place).toLowerCase().split(", ");
        // A value may be written without its unit.
        const isValue = (word, part) => word === part || word.startsWith(`${part} `);
        return parts.every((part) => own.some((word) => (part.includes("=") ? isValue(word, part) : word.includes(part))));
      })
    : all;
  if (table.sort) {
    const { of } = tableColumns.find((one) => one.name === table.sort);
    const keys = new Map(table.rows.map((place) => [place, of(place)]));
    const missing = (key) => typeof key === "number" && Number.isNaN(key);
    table.rows.sort((one, other) => {
      const [a, b] = [keys.get(one), keys.get(other)];
      // What is not there stands last, whichever way.
      if (missing(a) || missing(b)) return missing(a) - missing(b) || one - other;
      const order = a < b ? -1 : a > b ? 1 : 0;
      return (table.descending ? -order : order) || one - other;
    });
  }
  table.from = 0;
}

function drawTableHead() {
  const row = document.createElement("tr");
  for (const { name, title } of tableColumns) {
    const head = document.createElement("th");
    head.scope = "col";
    head.setAttribute("aria-sort", "none");
    head.dataset.column = name;
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = title;
    button.addEventListener("click", () => {
      table.descending = table.sort === name && !table.descending;
      table.sort = name;
      arrangeTable();
      drawTable();
      document.getElementById("rows").scrollTop = 0;
    });
    head.append(button);
    row.append(head);
  }
  document.querySelector("#table thead").replaceChildren(row);
}

function drawTable() {
  for (const head of document.querySelectorAll("#table th")) {
    const sorted = head.dataset.column === table.sort;
    head.setAttribute("aria-sort", !sorted ? "none" : table.descending ? "descending" : "ascending");
    const { title } = tableColumns.find((one) => one.name === head.dataset.column);
    head.firstChild.textContent = sorted ? `${title} ${table.descending ? "▼" : "▲"}` : title;
  }
  const shown = table.rows.slice(table.from, table.from + PAGE);
  document.querySelector("#table tbody").replaceChildren(
    ...shown.map((place) => {
      const row = document.createElement("tr");
      row.tabIndex = 0;
      row.dataset.place = place;
      row.setAttribute("aria-selected", place === state.place);
      for (const { of } of tableColumns) row.insertCell().textContent = cellText(of(place));
      if (failedAt[place]) row.classList.add("failed");
      row.addEventListener("click", () => select(place));
      row.addEventListener("keydown", (event) => {
        if (event.key === "Enter") select(place);
      });
      return row;
    }),
  );
  const last = Math.min(table.from + PAGE, table.rows.length);
  document.getElementById("row-count").textContent = table.rows.length ? `${table.from + 1} to ${last} of ${table.rows.length}` : "no case fits the filter";
  document.getElementById("previous").disabled = table.from === 0;
  document.getElementById("next").disabled = last >= table.rows.length;
}

function markTableRow() {
  for (const row of document.querySelectorAll("#table tbody tr")) row.setAttribute("aria-selected", Number(row.dataset.place) === state.place);
}

// The rows of the table as they are filtered and sorted: the three axes, and the numbers of the page.
function tableText() {
  const names = [...columns.keys()];
  const named = [0, 1, 2].filter((axis) => axisWords[axis].name);
  const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const line = (place) => {
    const indices = indicesOf(place);
    const parameter = (axis) => axisWords[axis].combinations[indices[axis]] ?? (axes[axis][indices[axis]] === Infinity ? "inf" : String(axes[axis][indices[axis]]));
    const parameters = named.map((axis) => quoted(parameter(axis)));
    const reason = failedAt[place] ? reasonOf(place) : "";
    return [contents.cases[caseOf[place]], ...parameters, failedAt[place] ? "failed" : "converged", quoted(reason), ...names.map((name) => plain(column(name)[place]))].join(",");
  };
  return [["case", ...named.map((axis) => axisWords[axis].name), "status", "reason", ...names].join(","), ...table.rows.map(line), ""].join("\n");
}

function download() {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([tableText()], { type: "text/csv" }));
  link.download = "cases.csv";
  link.click();
  // The browser has taken the text when the click returns; the address is let go of later, as some read it in between.
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// As valueWords, also for a value that a thinned grid has left out.
function failureWords(axis, value, index) {
  if (index >= 0) return valueWords(axis, index);
  const { symbol, unit } = axisWords[axis];
  return `${symbol} = ${digits(value)}${unit ? ` ${unit}` : ""}`;
}

function drawFailures() {
  const { count, kinds, listed } = contents.failures;
  const list = document.getElementById("failure-list");
  if (count === 0) {
    list.textContent = "None: every case converged.";
    return;
  }
  list.replaceChildren(
    ...kinds.flatMap((kind, index) => {
      const own = listed.filter((failure) => failure[3] === index);
      const title = document.createElement("h3");
      title.textContent = `${plural(kind.count, "place")}: ${kind.reason}${kind.varied ? " (or the same with other numbers)" : ""}`;
      const cases = document.createElement("ul");
      for (const [f, alpha, beta] of own) {
        const point = [f, alpha, beta].map((value) => (value === "inf" ? Infinity : value));
        const indices = axes.map((axis, i) => axis.indexOf(point[i]));
        const item = document.createElement("li");
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = point.map((value, axis) => failureWords(axis, value, indices[axis])).filter(Boolean).join(", ");
        // Of a thinned grid not every failed place is on the page.
        button.disabled = indices.includes(-1);
        button.addEventListener("click", () => select(placeAt(...indices)));
        item.append(button);
        cases.append(item);
      }
      return [title, cases];
    }),
  );
}
