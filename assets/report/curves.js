// The quantity along α and along β through the selected case, other values of the other axis faint.

function drawCurves(state) {
  const values = quantityValues(state.quantity);
  const scale = scaleOf(values, state.scale);
  const [iF, iAlpha, iBeta] = indicesOf(state.place);
  const words = scale.empty
    ? "No case has this number."
    : [[alphaSymbol, alphas], [betaSymbol, betas]].filter(([symbol, axis]) => symbol && axis.length < 2).map(([symbol]) => `${symbol} has one value in this sweep, so there is no curve along it.`).join(" ");
  document.getElementById("no-curves").textContent = words;
  show("no-curves", words !== "");
  drawCurve("curve-alpha", scale, state, alphas, alphaPlaces, alphaAxis(), betas, iBeta, iAlpha, 2, (i, other) => placeAt(iF, i, other));
  drawCurve("curve-beta", scale, state, betas, betaPlaces, betaAxis(), alphas, iAlpha, iBeta, 1, (i, other) => placeAt(iF, other, i));
}

function drawCurve(id, scale, state, along, places, axis, others, iOther, iChosen, otherAxis, placeOf) {
  const possible = along.length > 1 && !scale.empty;
  show(id, possible);
  if (!possible) return;
  const values = quantityValues(state.quantity);
  const line = (other) => {
    const shown = along.map((_, i) => placeOf(i, other));
    return { type: "scatter", x: places, y: shown.map((place) => (failedAt[place] ? NaN : scale.to(values[place]))), customdata: shown, text: shown.map(hoverWords), hovertemplate: "%{text}<extra></extra>" };
  };
  // About seven others are enough to see where the case stands.
  const step = Math.max(1, Math.ceil(others.length / 7));
  const faint = others.map((_, i) => i).filter((i) => i !== iOther && i % step === 0);
  const chosen = line(iOther);
  draw(
    id,
    [
      ...faint.map((other) => ({ ...line(other), mode: "lines", line: { color: style("--quiet"), width: 1 }, opacity: 0.45 })),
      { ...chosen, mode: "lines+markers", line: { color: kinds()[0], width: 2.5 }, marker: { size: 5 } },
      ...measuredPoints(state, 3 - otherAxis, scale),
      { type: "scatter", mode: "markers", x: [places[iChosen]], y: [chosen.y[iChosen]], marker: selectedMarker, hoverinfo: "skip" },
    ],
    {
      xaxis: axis,
      // What was zoomed is left as it is until another quantity is shown.
      yaxis: { title: { text: axisName(state.quantity) }, uirevision: `${state.quantity} ${state.scale}`, ...scale.ticks() },
      annotations: [{ text: others.length > 1 ? `${valueWords(otherAxis, iOther)}; faint: other ${axisWords[otherAxis].symbol}` : valueWords(otherAxis, iOther), xref: "paper", yref: "paper", x: 0.02, y: 1, xanchor: "left", yanchor: "bottom", showarrow: false, font: { color: style("--quiet") } }],
      margin: { l: 60, r: 15, t: 26, b: 50 },
    },
  );
}

// Measured points of the quantity, where they say how they lie along this axis, with their standard errors.
function measuredPoints(state, axis, scale) {
  const { measured } = contents;
  const along = measured?.coordinates[axisWords[axis].name];
  if (!along || measured.column !== state.quantity) return [];
  // Where the file says so, points that were measured elsewhere belong to other curves.
  const same = (one, other) => one === other || Math.abs(Math.log(one / other)) < 0.01;
  const own = Object.entries(quantitiesAt(state.place)).filter(([name]) => name !== axisWords[axis].name && measured.coordinates[name]);
  const rows = along.map((_, i) => i).filter((i) => own.every(([name, value]) => same(measured.coordinates[name][i], value)));
  const friction = rows.map((i) => measured.friction[i]);
  const errors = measured.errors && rows.map((i) => measured.errors[i]);
  const y = friction.map((value) => (scale.logarithmic && value <= 0 ? NaN : scale.to(value)));
  const text = friction.map((value, i) => `measured ${digits(value)}${errors ? ` ± ${digits(errors[i], 2)}` : ""}`);
  const above = errors?.map((error, i) => scale.to(friction[i] + error) - y[i]);
  const below = errors?.map((error, i) => y[i] - scale.to(Math.max(friction[i] - error, scale.logarithmic ? friction[i] / 1e3 : -Infinity)));
  const bars = above ? { error_y: { type: "data", symmetric: false, array: above, arrayminus: below, color: style("--text"), thickness: 1, width: 3 } } : {};
  return [{ type: "scatter", mode: "markers", x: rows.map((i) => Math.log10(along[i])), y, text, hovertemplate: "%{text}<extra></extra>", marker: { symbol: "diamond-open", size: 8, color: style("--text"), line: { width: 1.5 } }, ...bars }];
}
