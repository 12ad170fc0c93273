// Elements by their id, numbers as text, and templates by lit.
export { html, nothing, render, svg } from "lit-html";

export const byId = (id) => document.getElementById(id);

export function format(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  return value.toLocaleString("en", { maximumSignificantDigits: digits, useGrouping: false });
}

/** Like `format`; numbers far from 1 have a power of ten. */
export function scientific(value, digits = 3) {
  const size = Math.abs(value);
  if (!Number.isFinite(value) || value === 0 || (size >= 0.01 && size < 1e5)) return format(value, digits);
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return `${Number(mantissa)}·10${raised(Number(exponent))}`;
}

export const raised = (exponent) => String(exponent).replaceAll(/[-\d]/g, (sign) => (sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[sign]));
