// Charts by uPlot: curves from arrays, marks with their words, a cursor that follows the pointer or the arrow keys.
import uPlot from "uplot";
import { format } from "./dom.js";

/** Colour (a variable of the style sheet), width [px] and dashes of each look. */
const LOOKS = {
  c0: ["--c0", 2, []], c1: ["--c1", 2, [8, 3]], c2: ["--c2", 2, [2, 3]], a: ["--a", 2, [5, 4]],
  flat: ["--rule", 2, []], limit: ["--ink", 2.4, []], path: ["--c1", 2, []], chosen: ["--c1", 2, []],
};
const FONT = "12px system-ui, sans-serif";
const probe = document.createElement("i");

/** A colour of the style sheet in the theme that is shown. */
function color(name) {
  document.body.append(probe);
  probe.style.color = `var(${name})`;
  const resolved = getComputedStyle(probe).color;
  probe.remove();
  return resolved;
}

function range(values, least, room) {
  const finite = values.filter(Number.isFinite);
  if (finite.length === 0) return [0, 1];
  const [low, high] = [Math.min(...finite), Math.max(...finite)];
  const span = Math.max(high - low, least);
  return [low === 0 ? 0 : low - (0.04 + room.below) * span, high + (0.06 + room.above) * span];
}

const rises = (xs) => Array.prototype.every.call(xs, (x, i) => i === 0 || x > xs[i - 1]);
const power = (exponent) => `10${String(exponent).replaceAll(/[-\d]/g, (sign) => (sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[sign]))}`;

/** Points on the canvas [px]. */
function points(u, { x, y }) {
  return Array.from(x, (value, i) => [u.valToPos(value, "x", true), u.valToPos(y[i], "y", true)]).filter(([, top]) => Number.isFinite(top));
}

/** Dots, paths that turn back, and the cursor's dot. */
function drawFree(u, chart, paths) {
  const { ctx } = u;
  for (const path of paths) {
    ctx.strokeStyle = color(LOOKS[path.look][0]);
    ctx.lineWidth = 2 * devicePixelRatio;
    ctx.beginPath();
    points(u, path).forEach(([left, top], i) => (i ? ctx.lineTo(left, top) : ctx.moveTo(left, top)));
    ctx.stroke();
  }
  const cursor = chart.cursor && Number.isFinite(chart.cursor.y) ? [{ x: [chart.cursor.x], y: [chart.cursor.y], look: "limit" }] : [];
  for (const dots of [...(chart.dots ?? []), ...cursor]) {
    ctx.fillStyle = color(LOOKS[dots.look][0]);
    for (const [left, top] of points(u, dots)) {
      ctx.beginPath();
      ctx.arc(left, top, 3 * devicePixelRatio, 0, 2 * Math.PI);
      ctx.fill();
    }
  }
}

/** Words at their marks; they step down where they would stand on one another. */
function drawFlags(u, flags) {
  const { ctx, bbox } = u;
  const line = 15 * devicePixelRatio;
  const taken = [];
  ctx.font = FONT.replace("12px", `${12 * devicePixelRatio}px`);
  for (const { x, y, label, isBelow } of flags) {
    const [[left, top]] = points(u, { x: [x], y: [y] });
    const width = ctx.measureText(label).width;
    const begin = Math.max(bbox.left + 4, Math.min(left - width / 2, bbox.left + bbox.width - width));
    let base = isBelow || top - bbox.top < 1.5 * line ? top + 1.3 * line : top - 0.8 * line;
    while (taken.some((other) => Math.abs(other.base - base) < line && begin < other.end && begin + width > other.begin)) base += line;
    taken.push({ base, begin, end: begin + width });
    ctx.strokeStyle = ctx.fillStyle = color("--ink");
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    ctx.arc(left, top, 3 * devicePixelRatio, 0, 2 * Math.PI);
    ctx.stroke();
    ctx.fillText(label, begin, base);
  }
}

/**
 * Draws into `host`, in the place of what was there.
 * chart: { x: {label, range?}, y: {label, range?, least?, powers?}, series: [{name, x, y, look}], dots?: [{x, y, look}],
 *          flags?: [{x, y, label, isBelow?}], cursor?: {x, y?}, summary, onPick?(x) }
 */
export function draw(host, chart) {
  const width = Math.max(240, host.clientWidth);
  const height = Math.round(Math.min(0.62 * width, Math.max(220, 0.28 * innerHeight)));
  const lines = chart.series.filter(({ x, look }) => look !== "path" && rises(x));
  const paths = chart.series.filter((series) => !lines.includes(series));
  const all = (key) => [...chart.series, ...(chart.dots ?? [])].flatMap((series) => Array.from(series[key]));
  const has = (isBelow) => (chart.flags?.some((flag) => Boolean(flag.isBelow) === isBelow) ? 0.15 : 0);
  const xRange = chart.x.range ?? range(all("x"), 1e-9, { below: 0, above: 0 });
  const yRange = chart.y.range ?? range(all("y"), chart.y.least ?? 1e-9, { below: has(true), above: has(false) });
  const axis = (label, text) => ({
    label, font: FONT, labelFont: FONT, stroke: color("--quiet"), grid: { stroke: color("--rule"), width: 1 }, ticks: { stroke: color("--rule") },
    values: (_, ticks) => ticks.map(text),
  });
  const pick = (x) => chart.onPick(Math.min(xRange[1], Math.max(xRange[0], x)));
  const options = {
    width, height,
    legend: { show: lines.some(({ name }) => name), live: false },
    cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
    scales: { x: { time: false, range: xRange }, y: { range: yRange } },
    axes: [axis(chart.x.label, (value) => format(value, 6)), { ...axis(chart.y.label, chart.y.powers ? power : (value) => format(value, 6)), size: 58 }],
    series: [{}, ...lines.map(({ name, look }) => {
      const [variable, thick, dash] = LOOKS[look];
      return { label: name, stroke: color(variable), width: thick, dash, spanGaps: true, points: { show: false } };
    })],
    hooks: { draw: [(u) => (drawFree(u, chart, paths), drawFlags(u, chart.flags ?? []))] },
  };
  const tables = lines.map(({ x, y }) => [Array.from(x), Array.from(y, (value) => (Number.isFinite(value) ? value : null))]);
  const data = tables.length > 1 ? uPlot.join(tables) : (tables[0] ?? [[], []]);
  host.replaceChildren();
  const plot = new uPlot(options, data, host);
  if (chart.cursor) plot.setCursor({ left: plot.valToPos(chart.cursor.x, "x"), top: 0 }, false);
  for (const entry of host.querySelectorAll(".u-series")) entry.hidden = !entry.textContent.trim();
  Object.assign(host, { tabIndex: 0, role: "img", ariaLabel: chart.summary });
  if (chart.onPick) plot.over.onpointermove = plot.over.onpointerdown = ({ offsetX }) => pick(plot.posToVal(offsetX, "x"));
  host.onkeydown = (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step || !chart.onPick) return;
    event.preventDefault();
    pick((chart.cursor?.x ?? xRange[0]) + (step * (xRange[1] - xRange[0])) / 40);
  };
}
