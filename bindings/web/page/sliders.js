// A slider for each number that matters, with its unit and a field beside it.
import { format, html } from "./dom.js";

/** Keys of radii, of which shops measure the diameter; keys of the law, which a sheet of the library brings. */
const [RADII, LAW] = [["blank", "punch_radius", "throat", "inner_radius"], ["k", "n"]];
const STEPS = 200;

/** onMove(key, value, isLast): while it moves, and when it is let go. */
export function drawSliders(host, { sliders }, { values, sheet, isRound }, onMove) {
  const shown = sliders.filter(({ key }) => !(sheet && LAW.includes(key)));
  host.replaceChildren(...shown.map((slider) => row(slider, values[slider.key] ?? slider.value, isRound, onMove)));
}

function row({ key, label, value: begun, unit, low, high }, value, isRound, onMove) {
  const [most, least] = [Math.max(high, value), Math.min(low, value)];
  const ariaLabel = `${label} [${unit || "–"}]`;
  const range = html("input", { type: "range", min: least, max: most, step: (most - least) / STEPS, value, ariaLabel });
  const field = html("input", { type: "number", step: "any", value: Number(value.toPrecision(4)), ariaLabel });
  const across = html("small");
  const line = html("div", { className: "slider" }, html("span", {}, label, " ", across), range, field, html("span", { className: "unit" }, unit || "–"));
  line.dataset.key = key;
  const show = (now) => {
    range.setAttribute("aria-valuetext", `${format(now)} ${unit}`);
    across.textContent = isRound && RADII.includes(key) ? `Ø ${format(2 * now, 4)} ${unit}` : "";
    line.classList.toggle("moved", Math.abs(now - begun) > 1e-9 * Math.abs(begun));
  };
  range.addEventListener("input", () => {
    field.value = Number(range.valueAsNumber.toPrecision(4));
    show(range.valueAsNumber);
    onMove(key, range.valueAsNumber, false);
  });
  range.addEventListener("change", () => onMove(key, range.valueAsNumber, true));
  field.addEventListener("change", () => {
    if (!Number.isFinite(field.valueAsNumber)) return;
    range.value = field.valueAsNumber;
    show(field.valueAsNumber);
    onMove(key, field.valueAsNumber, true);
  });
  show(value);
  return line;
}
