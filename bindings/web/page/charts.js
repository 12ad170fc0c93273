// The charts of a solved stage: load, thickness, forming limit. Each has a sentence for who does not see it.
import { draw } from "./plot.js";
import { nearest } from "./section.js";
import { format, html } from "./dom.js";

/** Forces of several thousand are shown in thousands. */
function forceUnit(stage) {
  const largest = Math.max(...stage.steps.punch_force.map(Math.abs), ...stage.steps.holder_force.map(Math.abs));
  return largest >= 1000 ? { by: 1e-3, unit: `k${stage.forceUnit}` } : { by: 1, unit: stage.forceUnit };
}

function scaled(values, by) {
  return Array.from(values, (value) => value * by);
}

function peakOf(values) {
  let best = 0;
  for (let i = 1; i < values.length; i++) if (values[i] > values[best]) best = i;
  return best;
}

/** Index of the last step up to a travel. */
function stepAt(xs, x) {
  let i = 0;
  while (i + 1 < xs.length && xs[i + 1] <= x + 1e-9) i++;
  return i;
}

export function drawLoad(host, { stage, picture, other, onTravel }) {
  const { steps } = stage;
  if (stage.isRelease || steps.travel.length === 0) return nothing(host, "no force in this stage");
  const byGas = stage.travel === 0;
  const [over, xLabel] = byGas ? [steps.pole_height, "Height of the middle"] : [steps.travel, "Punch travel"];
  const { by, unit } = byGas ? { by: 1, unit: "MPa" } : forceUnit(stage);
  const keys = byGas
    ? [["pressure", "Gas pressure"]]
    : [["punch_force", "Punch force"], ["holder_force", "Holder force"], ["edge_force", "Edge force"]];
  const acts = keys.filter(([key], i) => i === 0 || steps[key].some((value) => value !== 0));
  const series = acts.map(([key, label], i) => ({ name: (label), x: over, y: scaled(steps[key], by), look: `c${i}` }));
  if (other && other.stage.steps.travel.length > 0) {
    const before = other.stage.steps;
    series.push({ name: `A: ${(acts[0][1])}`, x: byGas ? before.pole_height : before.travel, y: scaled(before[acts[0][0]], by), look: "a" });
  }
  const main = series[0].y;
  const peak = peakOf(main);
  const text = `peak ${format(main[peak])} ${unit} at ${format(over[peak])} mm`;
  const flags = byGas ? [] : stage.events.map(({ label, travel, force }) => ({ x: travel, y: force * by, label }));
  const now = byGas ? over[stepAt(steps.time, Infinity)] : stage.film.travel[picture];
  draw(host, {
    x: { label: `${xLabel} [mm]` },
    y: { label: `${(byGas ? "Gas pressure" : "Load")} [${unit}]`, least: 1e-6 },
    series,
    flags: [...flags, { x: over[peak], y: main[peak], label: text }],
    cursor: byGas ? undefined : { x: now, y: main[stepAt(over, now)] },
    summary: `${(acts[0][1])}: ${text}. ${stage.events.map(({ label, travel }) => `${label}, ${format(travel)} mm`).join("; ")}`,
    onPick: byGas ? undefined : onTravel,
  });
}

function thicknessAt(stage, picture) {
  return stage.film.thickness.subarray(stage.film.elements * picture, stage.film.elements * (picture + 1));
}

function placeLabel(isRound) {
  return `${(isRound ? "Initial distance from the axis" : "Initial distance from the middle")} [mm]`;
}

export function drawThickness(host, { stage, picture, other, isRound, place, onPlace }) {
  const { s0 } = stage.end;
  const now = thicknessAt(stage, picture);
  const flat = { x: [0, stage.length], y: [stage.thickness, stage.thickness], look: "flat" };
  const series = [flat, { name: "Thickness", x: s0, y: now, look: "c0" }];
  if (other) series.push({ name: "A: Thickness", x: other.stage.end.s0, y: thicknessAt(other.stage, other.picture), look: "a" });
  const least = now.indexOf(Math.min(...now));
  const text = `thinnest ${format(now[least])} mm at ${format(s0[least])} mm`;
  draw(host, {
    x: { label: placeLabel(isRound) },
    y: { label: "Thickness [mm]", least: 0.1 * stage.thickness },
    series,
    flags: [{ x: s0[least], y: now[least], label: text, isBelow: true }],
    cursor: Number.isFinite(place) ? { x: place, y: now[nearest(s0, place)] } : undefined,
    summary: `Thickness on the part: ${text}`,
    onPick: onPlace,
  });
}

/** Minor and major strain of every element at a picture, and the limit's major strain there [–]. */
function strains({ film }, picture) {
  const [minor, major, limit] = [film.minor, film.major, film.limit].map((all) => all.subarray(film.elements * picture, film.elements * (picture + 1)));
  return { minor, major, limit };
}

export function drawLimit(host, { stage, picture, other, isRound, place, onPlace }) {
  if (!stage.limit) return nothing(host, "no forming limit in this case");
  const { s0 } = stage.end;
  const { minor, major, limit } = strains(stage, picture);
  const worst = peakOf(Array.from(major, (strain, e) => (Number.isNaN(limit[e]) ? -Infinity : strain - limit[e])));
  const text = `nearest to the limit: ${format((100 * major[worst]) / limit[worst])} % at ${format(s0[worst])} mm`;
  const chosen = Number.isFinite(place) ? nearest(s0, place) : worst;
  const name = `limit: ${stage.limit.name}`;
  const summary = `Forming limit: ${text}`;
  if (!isRound) {
    const level = stage.limit.planeStrain;
    return draw(host, {
      x: { label: placeLabel(false) },
      y: { label: "Major strain [–]", least: 0.05 },
      series: [{ name: "Major strain", x: s0, y: major, look: "c0" }, { name, x: [0, stage.length], y: [level, level], look: "limit" }],
      flags: [{ x: s0[worst], y: major[worst], label: text }],
      cursor: Number.isFinite(place) ? { x: place, y: major[chosen] } : undefined,
      summary,
      onPick: onPlace,
    });
  }
  const [low, high] = [Math.min(-0.05, ...minor) - 0.05, Math.max(0.1, ...minor) + 0.05];
  const isSeen = (x) => x >= low && x <= high;
  const top = 1.1 * Math.max(...major, stage.limit.planeStrain, ...stage.limit.major.filter((_, i) => isSeen(stage.limit.minor[i]) && stage.limit.minor[i] > 0));
  const path = Array.from({ length: picture + 1 }, (_, i) => strains(stage, i));
  const dots = [{ x: minor, y: major, look: "c0" }, { x: [minor[chosen]], y: [major[chosen]], look: "chosen" }];
  if (other) {
    const before = strains(other.stage, other.picture);
    dots.unshift({ x: before.minor, y: before.major, look: "a" });
  }
  draw(host, {
    x: { label: "Minor strain [–]", range: [low, high] },
    y: { label: "Major strain [–]", range: [Math.min(0, ...major), top] },
    series: [
      { name, x: stage.limit.minor, y: stage.limit.major, look: "limit" },
      { name: "", x: path.map((at) => at.minor[chosen]), y: path.map((at) => at.major[chosen]), look: "path" },
    ],
    dots,
    flags: [{ x: minor[worst], y: major[worst], label: text }],
    summary,
  });
}

function nothing(host, text) {
  host.replaceChildren(html("p", { className: "nothing" }, text));
}
