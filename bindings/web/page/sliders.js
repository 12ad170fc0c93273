// A slider for each number that matters, with its unit and a field beside it.
import { format } from "./dom.js";

const LABELS = {
  blank: "Blank",
  thickness: "Sheet thickness",
  punch_radius: "Punch",
  nose: "Punch nose radius",
  throat: "Die opening",
  shoulder: "Die shoulder radius",
  clearance: "Clearance",
  inner_radius: "Holder opening",
  holder_force: "Holder force",
  holder_pressure: "Holder pressure",
  travel: "Punch travel",
  friction: "Friction",
  k: "Hardening k",
  n: "Hardening n",
  elements: "Elements",
};
/** Those that are half of what shops measure, of a round part. */
const HALVES = ["blank", "punch_radius", "throat", "inner_radius"];
/** Of a sheet of the library the law is not the case's. */
const OF_THE_LAW = ["k", "n"];
const STEPS = 200;

/** onMove(key, value, isLast): while it moves, and when it is let go. */
export function drawSliders(host, { sliders }, { values, sheet, isRound }, onMove) {
  const shown = sliders.filter(({ key }) => !(sheet && OF_THE_LAW.includes(key)));
  host.replaceChildren(...shown.map((slider) => row(slider, values[slider.key] ?? slider.value, isRound, onMove)));
}

function row({ key, value: begun, unit, low, high }, value, isRound, onMove) {
  const [most, least] = [Math.max(high, value), Math.min(low, value)];
  const range = Object.assign(document.createElement("input"), { type: "range", min: least, max: most, step: (most - least) / STEPS, value });
  const field = Object.assign(document.createElement("input"), { type: "number", step: "any", value: Number(value.toPrecision(4)) });
  const line = document.createElement("div");
  const name = (LABELS[key]);
  line.className = "slider";
  line.dataset.key = key;
  range.setAttribute("aria-label", `${name} [${unit || "–"}]`);
  field.setAttribute("aria-label", `${name} [${unit || "–"}]`);
  const across = document.createElement("small");
  const show = (now) => {
    range.setAttribute("aria-valuetext", `${format(now)} ${unit}`);
    across.textContent = isRound && HALVES.includes(key) ? `Ø ${format(2 * now, 4)} ${unit}` : "";
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
  const label = document.createElement("span");
  label.append(name, " ", across);
  const units = document.createElement("span");
  units.className = "unit";
  units.textContent = unit || "–";
  line.append(label, range, field, units);
  show(value);
  return line;
}
