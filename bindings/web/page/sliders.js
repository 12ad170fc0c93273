// A slider for each number that matters, with its unit and a field beside it; those of the method stand by themselves.
import { byId, format, html, nothing, render, scientific } from "./dom.js";

/** Keys of radii, of which shops measure the diameter; keys of the law, which a sheet of the library brings. */
const [RADII, LAW] = [["blank", "punch_radius", "throat", "inner_radius"], ["k", "n"]];
const WHOLE = /elements|layers|iterations/;
const STEPS = 200;
/** Largest over smallest number of a slider from which it goes by powers of ten. */
const DECADES = 99;

/** onMove(key, value, isLast): while it moves, and when it is let go. */
export function drawSliders({ sliders }, { values, sheet, isRound }, onMove) {
  const shown = sliders.filter(({ key }) => !(sheet && LAW.includes(key)));
  const rows = (isOfMethod) => shown.filter((one) => one.isOfMethod === isOfMethod).map((one) => row(one, values[one.key] ?? one.value, isRound, onMove));
  render(rows(false), byId("sliders"));
  render(rows(true), byId("method-sliders"));
}

export function row({ key, label, value: begun, unit, low, high }, value, isRound, onMove) {
  const clean = (x) => (WHOLE.test(key) ? Math.round(x) : Number(x.toPrecision(6)));
  const [most, least] = [Math.max(high, value), Math.min(low, value)].map(clean);
  const short = Number(value.toPrecision(4));
  const name = `${label} [${unit || "–"}]`;
  const [to, from] = least > 0 && most / least > DECADES ? [Math.log10, (x) => 10 ** x] : [(x) => x, (x) => x];
  const step = WHOLE.test(key) ? 1 : (to(most) - to(least)) / STEPS;
  const move = (isLast) => ({ target }) => onMove(key, clean(from(target.valueAsNumber)), isLast);
  const type = ({ target }) => Number.isFinite(target.valueAsNumber) && onMove(key, clean(target.valueAsNumber), true);
  return html`<div class="slider ${value === begun ? "" : "moved"}" data-key=${key}>
    <span>${label} ${isRound && RADII.includes(key) ? html`<small>Ø ${format(2 * value, 4)} ${unit}</small>` : nothing}</span>
    <input type="range" min=${to(least)} max=${to(most)} step=${step} .value=${to(value)} aria-label=${name} aria-valuetext="${scientific(value)} ${unit}" @input=${move(false)} @change=${move(true)}>
    <input type="number" step="any" .value=${value > 0 && value < 1e-3 ? short.toExponential() : String(short)} aria-label=${name} @change=${type}>
    <span class="unit">${unit || "–"}</span></div>`;
}
