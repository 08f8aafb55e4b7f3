// Numbers as text.

const raised = (integer) => Array.from(String(integer), (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit] ?? "⁻").join("");

// A power of ten: 10⁻⁵.
export const decade = (power) => `10${raised(power)}`;

// A number with so many digits: 0.7013, 3.2·10⁻⁵, ∞; a dash where there is none.
export function digits(value, count = 4) {
  if (Number.isNaN(value)) return "–";
  if (value === Infinity) return "∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return String(Number(value.toPrecision(count))).replace("-", "−");
  const [mantissa, power] = value.toExponential(count - 1).split("e");
  const short = String(Number(mantissa)).replace("-", "−");
  return short === "1" ? decade(Number(power)) : `${short}·${decade(Number(power))}`;
}

// A number as summary.csv writes it, to seven digits.
export function plain(value) {
  if (Number.isNaN(value)) return "";
  if (value === Infinity) return "inf";
  return String(Number(value.toPrecision(7)));
}

// A count with its noun: 1 case, 2 cases.
export const plural = (count, noun) => `${count.toLocaleString("en")} ${noun}${count === 1 ? "" : "s"}`;
