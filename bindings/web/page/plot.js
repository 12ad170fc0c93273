// Charts by uPlot: curves from arrays, marks with their words, a cursor that follows the pointer or the arrow keys.
import uPlot from "uplot";
import { format, raised } from "./dom.js";

/** Colour (a variable of the style sheet), width [px] and dashes of each look. */
const LOOKS = {
  c0: ["--c0", 2, []], c1: ["--c1", 2, [8, 3]], c2: ["--c2", 2, [2, 3]], a: ["--a", 2, [5, 4]],
  flat: ["--rule", 2, []], limit: ["--ink", 2.4, []], path: ["--c1", 2, []], chosen: ["--c1", 2, []],
};
const FONT = "12px system-ui, sans-serif";

function color(name) {
  const probe = document.body.appendChild(document.createElement("i"));
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

/** Paths that turn back, dots, the cursor's dot, and words at their marks, which step down where they would stand on one another. */
function drawFree(u, chart, paths) {
  const { ctx, bbox } = u;
  const [ratio, line, taken] = [devicePixelRatio, 15 * devicePixelRatio, []];
  const points = ({ x, y }) => Array.from(x, (value, i) => [u.valToPos(value, "x", true), u.valToPos(y[i], "y", true)]).filter(([, top]) => Number.isFinite(top));
  const circle = ([left, top]) => (ctx.beginPath(), ctx.arc(left, top, 3 * ratio, 0, 2 * Math.PI));
  Object.assign(ctx, { font: FONT.replace("12", 12 * ratio), textAlign: "left", textBaseline: "alphabetic", lineWidth: 2 * ratio });
  for (const path of paths) {
    ctx.strokeStyle = color(LOOKS[path.look][0]);
    ctx.beginPath();
    points(path).forEach((at, i) => (i ? ctx.lineTo(...at) : ctx.moveTo(...at)));
    ctx.stroke();
  }
  const cursor = Number.isFinite(chart.cursor?.y) ? [{ x: [chart.cursor.x], y: [chart.cursor.y], look: "limit" }] : [];
  for (const dots of [...(chart.dots ?? []), ...cursor]) {
    ctx.fillStyle = color(LOOKS[dots.look][0]);
    points(dots).forEach((at) => (circle(at), ctx.fill()));
  }
  ctx.strokeStyle = ctx.fillStyle = color("--ink");
  ctx.lineWidth = ratio;
  for (const { x, y, label, isBelow } of chart.flags ?? []) {
    const [[left, top]] = points({ x: [x], y: [y] });
    const width = ctx.measureText(label).width;
    const begin = Math.max(bbox.left + 4, Math.min(left - width / 2, bbox.left + bbox.width - width));
    let base = isBelow || top - bbox.top < 1.5 * line ? top + 1.3 * line : top - 0.8 * line;
    while (taken.some((other) => Math.abs(other.base - base) < line && begin < other.end && begin + width > other.begin)) base += line;
    taken.push({ base, begin, end: begin + width });
    circle([left, top]);
    ctx.stroke();
    Object.assign(ctx, { strokeStyle: color("--panel"), lineWidth: 4 * ratio });
    ctx.strokeText(label, begin, base);
    Object.assign(ctx, { strokeStyle: ctx.fillStyle, lineWidth: ratio });
    ctx.fillText(label, begin, base);
  }
}

/**
 * Draws into `host`, in the place of what was there.
 * chart: { x: {label, range?}, y: {label, range?, least?, powers?}, series: [{name?, x, y, look}], dots?: [{x, y, look}],
 *          flags?: [{x, y, label, isBelow?}], cursor?: {x, y?}, summary, onPick?(x) }
 */
export function draw(host, chart) {
  const width = Math.max(240, host.clientWidth);
  const height = Math.round(Math.min(0.7 * width, Math.max(220, 0.33 * innerHeight)));
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
  const plain = (value) => format(value, 6);
  const options = {
    width, height,
    legend: { show: lines.some(({ name }) => name), live: false },
    cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
    scales: { x: { time: false, range: xRange }, y: { range: yRange } },
    axes: [axis(chart.x.label, plain), { ...axis(chart.y.label, chart.y.powers ? (exponent) => (Number.isInteger(exponent) ? `10${raised(exponent)}` : "") : plain), size: 58 }],
    series: [{}, ...lines.map(({ name, look }) => ({ label: name ?? "", stroke: color(LOOKS[look][0]), width: LOOKS[look][1], dash: LOOKS[look][2], spanGaps: true, points: { show: false } }))],
    hooks: { draw: [(u) => drawFree(u, chart, paths)] },
  };
  const tables = lines.map(({ x, y }) => [Array.from(x), Array.from(y, (value) => (Number.isFinite(value) ? value : null))]);
  host.replaceChildren();
  const plot = new uPlot(options, tables.length > 1 ? uPlot.join(tables) : (tables[0] ?? [[], []]), host);
  if (chart.cursor) plot.setCursor({ left: plot.valToPos(chart.cursor.x, "x"), top: 0 }, false);
  plot.root.querySelectorAll(".u-series").forEach((entry, i) => (entry.hidden = !options.series[i + 1].label));
  Object.assign(host, { tabIndex: 0, role: "img", ariaLabel: chart.summary });
  if (chart.onPick) plot.over.onpointermove = plot.over.onpointerdown = ({ offsetX }) => pick(plot.posToVal(offsetX, "x"));
  host.onkeydown = (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step || !chart.onPick) return;
    event.preventDefault();
    pick((chart.cursor?.x ?? xRange[0]) + (step * (xRange[1] - xRange[0])) / 40);
  };
}
