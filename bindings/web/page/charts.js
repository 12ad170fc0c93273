// The charts of a solved stage: load, thickness, forming limit. Each has a sentence for who does not see it.
import { draw } from "./plot.js";
import { nearest } from "./section.js";
import { format } from "./dom.js";

const nothing = (host, text) => host.replaceChildren(Object.assign(document.createElement("p"), { className: "nothing", textContent: text }));

function forceUnit(stage) {
  const largest = Math.max(...stage.steps.punch_force.map(Math.abs), ...stage.steps.holder_force.map(Math.abs));
  return largest >= 1000 ? { by: 1e-3, unit: `k${stage.forceUnit}` } : { by: 1, unit: stage.forceUnit };
}

const scaled = (values, by) => Array.from(values, (value) => value * by);

const peakOf = (values) => values.indexOf(Math.max(...values));

export function drawLoad(host, { stage, picture, other, onTravel }) {
  const { steps } = stage;
  if (stage.isRelease || steps.travel.length === 0) return nothing(host, "no force in this stage");
  const byGas = stage.travel === 0;
  const [over, xLabel] = byGas ? [steps.pole_height, "Height of the middle"] : [steps.travel, "Punch travel"];
  const { by, unit } = byGas ? { by: 1, unit: "MPa" } : forceUnit(stage);
  const keys = byGas
    ? [["pressure", "Pressure"]]
    : [["punch_force", "Punch force"], ["holder_force", "Holder force"], ["edge_force", "Edge force"]];
  const acts = keys.filter(([key], i) => i === 0 || steps[key].some((value) => value !== 0));
  const series = acts.map(([key, label], i) => ({ name: label, x: over, y: scaled(steps[key], by), look: `c${i}` }));
  if (other && other.stage.steps.travel.length > 0) {
    const before = other.stage.steps;
    series.push({ name: `A: ${acts[0][1]}`, x: byGas ? before.pole_height : before.travel, y: scaled(before[acts[0][0]], by), look: "a" });
  }
  const main = series[0].y;
  const peak = peakOf(main);
  const text = `peak ${format(main[peak])} ${unit} at ${format(over[peak])} mm`;
  const flags = byGas ? [] : stage.events.map(({ label, travel, force }) => ({ x: travel, y: force * by, label }));
  const now = stage.film.travel[picture];
  draw(host, {
    x: { label: `${xLabel} [mm]` },
    y: { label: `${byGas ? "Pressure" : "Load"} [${unit}]`, least: 1e-6 },
    series,
    flags: [...flags, { x: over[peak], y: main[peak], label: text }],
    cursor: byGas ? undefined : { x: now, y: main[nearest(over, now)] },
    summary: `${acts[0][1]}: ${text}. ${stage.events.map(({ label, travel }) => `${label}, ${format(travel)} mm`).join("; ")}`,
    onPick: byGas ? undefined : onTravel,
  });
}

const at = ({ film }, key, picture) => film[key].subarray(film.elements * picture, film.elements * (picture + 1));

const placeLabel = (isRound) => `Initial distance from the ${isRound ? "axis" : "middle"} [mm]`;

export function drawThickness(host, { stage, picture, other, isRound, chosen, onPlace }) {
  const { s0 } = stage.end;
  const now = at(stage, "thickness", picture);
  const flat = { x: [0, stage.length], y: [stage.thickness, stage.thickness], look: "flat" };
  const series = [flat, { name: "Thickness", x: s0, y: now, look: "c0" }];
  if (other) series.push({ name: "A: Thickness", x: other.stage.end.s0, y: at(other.stage, "thickness", other.picture), look: "a" });
  const least = now.indexOf(Math.min(...now));
  const text = `thinnest ${format(now[least])} mm at ${format(s0[least])} mm`;
  draw(host, {
    x: { label: placeLabel(isRound) },
    y: { label: "Thickness [mm]", least: 0.1 * stage.thickness },
    series,
    flags: [{ x: s0[least], y: now[least], label: text, isBelow: true }],
    cursor: chosen >= 0 ? { x: s0[chosen], y: now[chosen] } : undefined,
    summary: `Thickness on the part: ${text}`,
    onPick: onPlace,
  });
}

export function drawLimit(host, { stage, picture, other, isRound, chosen: place, onPlace }) {
  if (!stage.limit) return nothing(host, "no forming limit in this case");
  const { s0 } = stage.end;
  const [minor, major, limit] = ["minor", "major", "limit"].map((key) => at(stage, key, picture));
  const worst = peakOf(Array.from(major, (strain, e) => (Number.isNaN(limit[e]) ? -Infinity : strain - limit[e])));
  const text = `nearest to the limit: ${format((100 * major[worst]) / limit[worst])} % at ${format(s0[worst])} mm`;
  const chosen = place >= 0 ? place : worst;
  const name = `limit: ${stage.limit.name}`;
  const summary = `Forming limit: ${text}`;
  if (!isRound) {
    const level = stage.limit.planeStrain;
    return draw(host, {
      x: { label: placeLabel(false) },
      y: { label: "Major strain [–]", least: 0.05 },
      series: [{ name: "Major strain", x: s0, y: major, look: "c0" }, { name, x: [0, stage.length], y: [level, level], look: "limit" }],
      flags: [{ x: s0[worst], y: major[worst], label: text }],
      cursor: place >= 0 ? { x: s0[chosen], y: major[chosen] } : undefined,
      summary,
      onPick: onPlace,
    });
  }
  const [low, high] = [Math.min(-0.05, ...minor) - 0.05, Math.max(0.1, ...minor) + 0.05];
  const isSeen = (x) => x >= low && x <= high;
  const top = 1.1 * Math.max(...major, stage.limit.planeStrain, ...stage.limit.major.filter((_, i) => isSeen(stage.limit.minor[i]) && stage.limit.minor[i] > 0));
  const path = (key) => Array.from({ length: picture + 1 }, (_, i) => at(stage, key, i)[chosen]);
  const dots = [{ x: minor, y: major, look: "c0" }, { x: [minor[chosen]], y: [major[chosen]], look: "chosen" }];
  if (other) dots.unshift({ x: at(other.stage, "minor", other.picture), y: at(other.stage, "major", other.picture), look: "a" });
  draw(host, {
    x: { label: "Minor strain [–]", range: [low, high] },
    y: { label: "Major strain [–]", range: [Math.min(0, ...major), top] },
    series: [
      { name, x: stage.limit.minor, y: stage.limit.major, look: "limit" },
      { x: path("minor"), y: path("major"), look: "path" },
      { name: "elements", x: [], y: [], look: "c0" },
    ],
    dots,
    flags: [{ x: minor[worst], y: major[worst], label: text }],
    summary,
  });
}
