// The charts of a solved stage: load, thickness, forming limit. Each has a sentence for who does not see it.
import { draw } from "./plot.js";
import { nearest } from "./section.js";
import { format } from "./dom.js";

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
  if (other) series.push({ name: `A: Thickness`, x: other.stage.end.s0, y: thicknessAt(other.stage, other.picture), look: "a" });
  const least = now.indexOf(Math.min(...now));
  const text = `thinnest ${format(now[least])} mm at ${format(s0[least])} mm`;
  draw(host, {
    x: { label: placeLabel(isRound) },
    y: { label: `Thickness [mm]`, least: 0.1 * stage.thickness },
    series,
    flags: [{ x: s0[least], y: now[least], label: text, isBelow: true }],
    cursor: Number.isFinite(place) ? { x: place, y: now[nearest(s0, place)] } : undefined,
    summary: `Thickness on the part: ${text}`,
    onPick: onPlace,
  });
}

/** Minor and major strain of every element at a picture [–]. */
function strains({ film }, picture) {
  const at = 2 * film.elements * picture;
  const pairs = Array.from({ length: film.elements }, (_, e) => Array.from(film.strains.subarray(at + 2 * e, at + 2 * e + 2)).sort((a, b) => a - b));
  return { minor: pairs.map((pair) => pair[0]), major: pairs.map((pair) => pair[1]) };
}

/** The major strain of the limit at a minor strain, as the solver goes on beyond its points [–]. */
function limitAt(points, minor) {
  const last = points.length - 2;
  if (minor <= points[0]) return points[1] + points[0] - minor;
  if (minor >= points[last]) return points[last + 1];
  let i = 0;
  while (points[i + 2] < minor) i += 2;
  return points[i + 1] + ((points[i + 3] - points[i + 1]) * (minor - points[i])) / (points[i + 2] - points[i]);
}

export function drawLimit(host, { stage, picture, other, isRound, place, onPlace }) {
  if (!stage.limit) return nothing(host, "no forming limit in this case");
  const { points, name, endsAt } = stage.limit;
  const now = strains(stage, picture);
  const margin = now.major.map((major, e) => limitAt(points, now.minor[e]) - major);
  const judged = margin.map((left, e) => (endsAt === null || now.minor[e] <= endsAt ? -left : -Infinity));
  const worst = peakOf(judged);
  const used = now.major[worst] / limitAt(points, now.minor[worst]);
  const { s0 } = stage.end;
  const text = `nearest to the limit: ${format(100 * used)} % at ${format(s0[worst])} mm`;
  const chosen = Number.isFinite(place) ? nearest(s0, place) : worst;
  if (!isRound) {
    const level = limitAt(points, 0);
    return draw(host, {
      x: { label: placeLabel(false) },
      y: { label: `Major strain [–]`, least: 0.05 },
      series: [
        { name: "Major strain", x: s0, y: now.major, look: "c0" },
        { name: `limit: ${name}`, x: [0, stage.length], y: [level, level], look: "limit" },
      ],
      flags: [{ x: s0[worst], y: now.major[worst], label: text }],
      cursor: Number.isFinite(place) ? { x: place, y: now.major[chosen] } : undefined,
      summary: `Forming limit: ${text}`,
      onPick: onPlace,
    });
  }
  const low = Math.min(-0.05, ...now.minor) - 0.05;
  const high = Math.max(0.1, ...now.minor) + 0.05;
  const top = 1.1 * Math.max(...now.major, limitAt(points, 0), limitAt(points, high));
  const grid = Array.from({ length: 61 }, (_, i) => low + (i * (high - low)) / 60).filter((minor) => endsAt === null || minor <= endsAt);
  const limits = grid.map((minor) => limitAt(points, minor)).map((major) => (major <= top ? major : NaN));
  const pictures = Array.from({ length: picture + 1 }, (_, i) => strains(stage, i));
  const dots = [{ x: now.minor, y: now.major, look: "c0" }];
  if (other) dots.unshift(((before) => ({ x: before.minor, y: before.major, look: "a" }))(strains(other.stage, other.picture)));
  draw(host, {
    x: { label: `Minor strain [–]`, range: [low, high] },
    y: { label: `Major strain [–]`, range: [Math.min(0, ...now.major), top] },
    series: [
      { name: `limit: ${name}`, x: grid, y: limits, look: "limit" },
      { name: "", x: pictures.map(({ minor }) => minor[chosen]), y: pictures.map(({ major }) => major[chosen]), look: "path" },
    ],
    dots: [...dots, { x: [now.minor[chosen]], y: [now.major[chosen]], look: "chosen" }],
    flags: [{ x: now.minor[worst], y: now.major[worst], label: text }],
    summary: `Forming limit: ${text}`,
  });
}

function nothing(host, text) {
  const words = document.createElement("p");
  words.className = "nothing";
  words.textContent = text;
  host.replaceChildren(words);
}
