// The selected case: its numbers and its fields.

const reasonIndices = integers(contents.failures.reason_of);
// With very many different reasons not all are in the page.
const reasonOf = (place) => contents.failures.reasons[reasonIndices[place]] ?? "the reason is in summary.csv";

const withUnit = (value, name) => (Number.isNaN(value) ? digits(value) : `${digits(value, 5)} ${unitOf(name)}`.trim());

function showNumbers({ place }) {
  const failed = failedAt[place] === 1;
  const total = digits(column("mu_tot")[place]);
  document.getElementById("selected").textContent = failed
    ? `${pointWords(place)}: failed, ${reasonOf(place)}`
    : `${pointWords(place)}: converged, μₜₒₜ = ${total} ${unitOf("mu_tot")}`.trim();
  const rows = [...columns.keys()].map((name) => [symbols[name], withUnit(column(name)[place], name), longName(name)]);
  if (costs) {
    rows.push(["solved in", `${digits(costs.seconds[place], 3)} s`, "seconds on its thread"]);
    rows.push(["iterations", digits(costs.iterations[place]), "iterations"]);
    rows.push(["seed", contents.costs.seeds[costs.seedOf[place]], "where the first guess came from"]);
  }
  rows.push(["id", contents.cases[caseOf[place]], "id of the case, for `stribeck explain`"]);
  document.getElementById("numbers").replaceChildren(
    ...rows.map(([name, value, title]) => {
      const row = document.createElement("div");
      row.title = title;
      const term = document.createElement("dt");
      const number = document.createElement("dd");
      term.textContent = name;
      number.textContent = value;
      row.append(term, number);
      return row;
    }),
  );
}

// Id of the picture, name of the field, title of its axis, scale.
const pictures = [
  ["pressure", "pressure", `pressure p  (${unitOf("p_max")})`, "linear"],
  ["film", "film_thickness", `film thickness u  (${unitOf("film_min")})`, "auto"],
  ["displacement", "displacement", `height of the surface w  (${unitOf("film_min")})`, "linear"],
];

function drawFields({ place }) {
  const failed = failedAt[place] === 1;
  const near = failed || !contents.fields ? null : nearestPlace(place, hasFields);
  const fields = near === null ? null : fieldsOf(near);
  const missing = fields ? pictures.filter(([, name]) => !fields[name]).map(([, name]) => name.replace("_", " ")) : [];
  const words = [
    fields && near !== place ? `The fields of this case are not in this page. These are of the nearest one that has them here: ${pointWords(near)}.` : "",
    missing.length ? `Not among the fields of this sweep: ${missing.join(", ")}.` : "",
    failed ? "A failed case has no fields." : contents.fields ? "" : "The sweep has no fields.",
  ].join(" ").trim();
  document.getElementById("no-fields").textContent = words;
  show("no-fields", words !== "");
  show("field-plots", !!fields);
  if (!fields) return;
  pictures.forEach(([id, name, title, choice], i) => {
    show(id, !!fields[name]);
    if (!fields[name]) return;
    const scale = scaleOf(fields[name], choice);
    draw(
      id,
      [{ type: "scatter", mode: "lines", x: fields.x, y: fields[name].map(scale.to), customdata: fields[name].map((value) => digits(value)), line: { color: kinds()[i], width: 2 }, hovertemplate: "x = %{x:.4g} a₀<br>%{customdata}<extra></extra>" }],
      { xaxis: { title: { text: "x  (a₀), inlet on the right" } }, yaxis: { title: { text: title }, ...scale.ticks() } },
    );
  });
}
