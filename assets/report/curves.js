// The quantity along α and along β through the selected case, other values of the other axis faint.

function drawCurves(state) {
  const values = quantityValues(state.quantity);
  const scale = scaleOf(values, state.scale);
  const [iF, iAlpha, iBeta] = indicesOf(state.place);
  const words = scale.empty
    ? "No case has this number."
    : [["α", alphas], ["β", betas]].filter(([, axis]) => axis.length < 2).map(([symbol]) => `${symbol} has one value in this sweep, so there is no curve along it.`).join(" ");
  document.getElementById("no-curves").textContent = words;
  show("no-curves", words !== "");
  drawCurve("curve-alpha", scale, state, alphas, alphaPlaces, alphaAxis(), betas, iBeta, iAlpha, "β", (i, other) => placeAt(iF, i, other));
  drawCurve("curve-beta", scale, state, betas, betaPlaces, betaAxis(), alphas, iAlpha, iBeta, "α", (i, other) => placeAt(iF, other, i));
}

function drawCurve(id, scale, state, along, places, axis, others, iOther, iChosen, symbol, placeOf) {
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
      { type: "scatter", mode: "markers", x: [places[iChosen]], y: [chosen.y[iChosen]], marker: selectedMarker, hoverinfo: "skip" },
    ],
    {
      xaxis: axis,
      // What was zoomed is left as it is until another quantity is shown.
      yaxis: { title: { text: axisName(state.quantity) }, uirevision: `${state.quantity} ${state.scale}`, ...scale.ticks() },
      annotations: [{ text: `${symbol} = ${digits(others[iOther])}; faint: other ${symbol}`, xref: "paper", yref: "paper", x: 0.02, y: 1, xanchor: "left", yanchor: "bottom", showarrow: false, font: { color: style("--quiet") } }],
      margin: { l: 60, r: 15, t: 26, b: 50 },
    },
  );
}
