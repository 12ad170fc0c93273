// A chart as SVG: axes, curves, points, flags, a cursor. Sizes are pixels, so that letters stay as large on every screen.
import { told } from "./words.js";

const NAMESPACE = "http://www.w3.org/2000/svg";
/** Room beside the curves for words at their marks, over the height [–]. */
const FLAG_ROOM = 0.15;
/** Letters of a page on a usual screen [px], for which the sizes here are meant. */
const LETTERS = 15;
const MARGIN = { left: 58, right: 14, top: 12, bottom: 44 };

export function svg(name, attributes, ...children) {
  const element = document.createElementNS(NAMESPACE, name);
  for (const [key, value] of Object.entries(attributes ?? {})) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** Round numbers from low to high, about `count` of them. */
export function ticks(low, high, count) {
  const rough = (high - low) / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((times) => times * power).find((size) => size >= rough * 0.999);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

function range(values, least) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  }
  if (low > high) return [0, 1];
  const room = Math.max(high - low, least);
  return [low === 0 ? 0 : low - 0.04 * room, high + 0.06 * room];
}

/** The path of points; a gap where a number is missing. */
function path(xs, ys, x, y) {
  let text = "";
  let pen = "M";
  for (let i = 0; i < xs.length; i++) {
    if (!Number.isFinite(ys[i])) {
      pen = "M";
      continue;
    }
    text += `${pen}${x(xs[i]).toFixed(1)} ${y(ys[i]).toFixed(1)}`;
    pen = "L";
  }
  return text;
}

/**
 * Draws into `host`, in the place of what was there.
 * chart: { x: {label, range?}, y: {label, range?, least?, powers?}, series: [{name, x, y, look}], dots: [{x, y, look}],
 *          flags?: [{x, y, label, isBelow?}], cursor?: {x, y?}, summary, onPick?(x) }
 */
export function draw(host, chart) {
  // Letters grow with those of the page.
  const zoom = parseFloat(getComputedStyle(document.documentElement).fontSize) / LETTERS;
  const width = Math.max(240, host.clientWidth / zoom);
  const height = Math.round(Math.min(0.62 * width, Math.max(220, (0.28 * window.innerHeight) / zoom)));
  const all = (key) => [
    ...chart.series.flatMap((series) => Array.from(series[key])),
    ...(chart.dots ?? []).flatMap((dots) => Array.from(dots[key])),
  ];
  const xRange = chart.x.range ?? range(all("x"), 1e-9);
  const [bottom, top] = range(all("y"), chart.y.least ?? 1e-9);
  const room = (isBelow) => (chart.flags?.some((flag) => Boolean(flag.isBelow) === isBelow) ? FLAG_ROOM * (top - bottom) : 0);
  const yRange = chart.y.range ?? [bottom - room(true), top + room(false)];
  const inner = { width: width - MARGIN.left - MARGIN.right, height: height - MARGIN.top - MARGIN.bottom };
  const x = (value) => MARGIN.left + (inner.width * (value - xRange[0])) / (xRange[1] - xRange[0]);
  const y = (value) => MARGIN.top + inner.height * (1 - (value - yRange[0]) / (yRange[1] - yRange[0]));
  const mark = chart.y.powers ? (power) => `10${superscript(power)}` : (value) => told(value, 6);
  const size = { width: width * zoom, height: height * zoom };
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, ...size, role: "img", tabindex: 0, class: "chart" });
  root.append(svg("title", {}, chart.summary));
  root.append(...axes(chart, { x, y, xRange, yRange, width, height, inner, mark }));
  const plot = svg("g", {});
  for (const { x: xs, y: ys, look } of chart.series) plot.append(svg("path", { d: path(xs, ys, x, y), class: `curve ${look}` }));
  for (const { x: xs, y: ys, look } of chart.dots ?? []) {
    for (let i = 0; i < xs.length; i++) {
      const inside = xs[i] >= xRange[0] && xs[i] <= xRange[1] && ys[i] >= yRange[0] && ys[i] <= yRange[1];
      if (inside) plot.append(svg("circle", { cx: x(xs[i]).toFixed(1), cy: y(ys[i]).toFixed(1), r: 3, class: `dot ${look}` }));
    }
  }
  plot.append(...flags(chart.flags ?? [], { x, y, width }));
  if (chart.cursor && chart.cursor.x >= xRange[0] && chart.cursor.x <= xRange[1]) {
    const at = x(chart.cursor.x).toFixed(1);
    plot.append(svg("line", { x1: at, x2: at, y1: MARGIN.top, y2: MARGIN.top + inner.height, class: "cursor" }));
    if (Number.isFinite(chart.cursor.y)) plot.append(svg("circle", { cx: at, cy: y(chart.cursor.y).toFixed(1), r: 4.5, class: "cursor-dot" }));
  }
  root.append(plot);
  if (chart.onPick) follow(root, chart, (pixel) => xRange[0] + ((pixel / zoom - MARGIN.left) / inner.width) * (xRange[1] - xRange[0]), xRange);
  const focused = host.contains(document.activeElement);
  host.replaceChildren(root, legend(chart.series));
  if (focused) root.focus({ preventScroll: true });
}

function axes(chart, { x, y, xRange, yRange, width, height, inner, mark }) {
  const parts = [];
  const bottom = MARGIN.top + inner.height;
  for (const value of ticks(...yRange, inner.height / 45)) {
    parts.push(svg("line", { x1: MARGIN.left, x2: width - MARGIN.right, y1: y(value), y2: y(value), class: "grid" }));
    parts.push(svg("text", { x: MARGIN.left - 7, y: y(value) + 4, class: "tick end" }, mark(value)));
  }
  for (const value of ticks(...xRange, inner.width / 75)) {
    parts.push(svg("line", { x1: x(value), x2: x(value), y1: bottom, y2: bottom + 5, class: "axis" }));
    parts.push(svg("text", { x: x(value), y: bottom + 18, class: "tick middle" }, told(value, 6)));
  }
  parts.push(svg("line", { x1: MARGIN.left, x2: width - MARGIN.right, y1: bottom, y2: bottom, class: "axis" }));
  parts.push(svg("text", { x: MARGIN.left + inner.width / 2, y: height - 7, class: "label middle" }, chart.x.label));
  const turn = `translate(14 ${MARGIN.top + inner.height / 2}) rotate(-90)`;
  parts.push(svg("text", { transform: turn, class: "label middle" }, chart.y.label));
  return parts;
}

function superscript(power) {
  return String(power).replaceAll(/[-\d]/g, (sign) => (sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[sign]));
}

/** Marks with their words, which step down where they would stand on one another. */
function flags(marks, { x, y, width }) {
  const taken = [];
  return marks.flatMap(({ x: at, y: value, label, isBelow }) => {
    const [left, top] = [x(at), y(value)];
    const room = 6.3 * label.length;
    const begin = Math.max(MARGIN.left + 4, Math.min(left - room / 2, width - MARGIN.right - room));
    let line = isBelow || top < 26 ? top + 20 : top - 12;
    while (taken.some((other) => Math.abs(other.line - line) < 15 && begin < other.end && begin + room > other.begin)) line += 15;
    taken.push({ line, begin, end: begin + room });
    return [
      svg("line", { x1: left, x2: left, y1: top, y2: line + (line < top ? 3 : -11), class: "flag-line" }),
      svg("circle", { cx: left, cy: top, r: 3.5, class: "flag-dot" }),
      svg("text", { x: begin, y: line, class: "flag" }, label),
    ];
  });
}

function follow(root, chart, value, [low, high]) {
  const pick = (event) => chart.onPick(Math.min(high, Math.max(low, value(event.offsetX))));
  root.addEventListener("pointermove", pick);
  root.addEventListener("pointerdown", pick);
  root.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    chart.onPick(Math.min(high, Math.max(low, (chart.cursor?.x ?? low) + (step * (high - low)) / 40)));
  });
}

function legend(series) {
  const list = document.createElement("ul");
  list.className = "legend";
  for (const { name, look } of series.filter((one) => one.name)) {
    const entry = document.createElement("li");
    const key = svg("svg", { width: 26, height: 10, "aria-hidden": "true" }, svg("line", { x1: 1, x2: 25, y1: 5, y2: 5, class: `curve ${look}` }));
    entry.append(key, name);
    list.append(entry);
  }
  return list;
}
