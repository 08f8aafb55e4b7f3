// What numbers and columns are called.

const symbols = {
  mu_v: "μᵥ", mu_h: "μₕ", mu_tot: "μₜₒₜ", mu_drag: "drag", mu_h_cavity: "μₕ, cavity", c: "c", film_min: "uₘᵢₙ",
  p_max: "pₘₐₓ", x_outlet: "xₒᵤₜ", error_mu_v: "error of μᵥ", error_mu_h: "error of μₕ", error_c: "error of c",
  load_residual: "load residual", dry_mu_v: "μᵥ, dry", approx_mu_h: "μₕ, large β",
  alpha: "α", beta: "β", largest_error: "largest estimated error", seconds: "seconds", iterations: "iterations",
};

const unitWords = { "1": "", "a0": "a₀", "a0/R": "a₀/R", "a0^2/R": "a₀²/R", "2N/(pi a0)": "2N/(πa₀)", m: "m", Pa: "Pa" };

function unitOf(name) {
  if (name === "seconds") return "s";
  return columns.has(name) ? unitWords[columns.get(name).units] : "";
}

// In words, with symbols for names of columns.
function longName(name) {
  const words = columns.get(name)?.long_name ?? symbols[name];
  const names = { mu_v: "μᵥ", mu_h: "μₕ", beta: "β" };
  return words.replace(/\b(mu_v|mu_h|beta)\b/g, (found) => names[found]);
}

// "total friction coefficient" is in the title; axes have symbol and unit.
function axisName(name) {
  const unit = unitOf(name);
  return unit ? `${symbols[name]}  (${unit})` : symbols[name];
}

const superscripts = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
const raised = (integer) => String(integer).split("").map((digit) => superscripts[digit]).join("");
const decade = (power) => `10${raised(power)}`;

// A number with so many digits: 0.7013, 3.2·10⁻⁵, ∞; a dash where there is none.
function digits(value, count = 4) {
  if (Number.isNaN(value)) return "–";
  if (value === Infinity) return "∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return String(Number(value.toPrecision(count))).replace("-", "−");
  const [mantissa, power] = value.toExponential(count - 1).split("e");
  const short = String(Number(mantissa)).replace("-", "−");
  return short === "1" ? decade(Number(power)) : `${short}·${decade(Number(power))}`;
}

// As summary.csv writes it, to seven digits.
function plain(value) {
  if (Number.isNaN(value)) return "";
  if (value === Infinity) return "inf";
  return String(Number(value.toPrecision(7)));
}

function pointWords(place) {
  const [iF, iAlpha, iBeta] = indicesOf(place);
  return [iF, iAlpha, iBeta].map((index, axis) => valueWords(axis, index)).filter(Boolean).join(", ");
}

// "β = 100", "V = 0.001 m/s"; nothing for an axis that is none.
function valueWords(axis, index) {
  const { symbol, unit, combinations } = axisWords[axis];
  if (combinations.length) return combinations[index];
  return symbol ? `${symbol} = ${digits(axes[axis][index])}${unit ? ` ${unit}` : ""}` : "";
}

// What is said when the pointer rests on a place.
function hoverWords(place) {
  if (failedAt[place]) return `${pointWords(place)}<br>failed`;
  const number = (name) => `${symbols[name]} ${digits(column(name)[place])}`;
  return [
    pointWords(place),
    `${["mu_tot", "mu_v", "mu_h"].map(number).join(", ")}  ${unitOf("mu_tot")}`,
    `${number("film_min")}  ${unitOf("film_min")}`,
    `largest estimated error ${digits(largestErrors[place], 2)}`,
  ].join("<br>");
}

const plural = (count, word) => `${count.toLocaleString("en")} ${word}${count === 1 ? "" : "s"}`;
