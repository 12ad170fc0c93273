// The section as it stands at a picture of the film: true thickness, coloured by how much thinner it is; the tools around it.
import { format, html, svg } from "./dom.js";

/** Change of thickness at the ends of the colours [–]. */
const FULL = 0.25;
/** From thicker to thinner, apart for colour-blind readers and in grey at its ends. */
const COLOURS = [[0, 90, 160], [120, 180, 215], [224, 224, 216], [236, 165, 80], [165, 45, 10]];

function colour(thinning) {
  const at = (COLOURS.length - 1) * Math.min(1, Math.max(0, 0.5 + thinning / (2 * FULL)));
  const i = Math.min(COLOURS.length - 2, Math.floor(at));
  const mix = COLOURS[i].map((from, k) => Math.round(from + (at - i) * (COLOURS[i + 1][k] - from)));
  return `rgb(${mix.join(",")})`;
}

/** Both faces of the sheet at every node of a picture: [r, z] of the lower and of the upper one. */
function faces({ film }, picture) {
  const count = film.elements + 1;
  const at = 4 * count * picture;
  return Array.from({ length: count }, (_, i) => {
    const [r, z, theta, thickness] = film.nodes.subarray(at + 4 * i, at + 4 * i + 4);
    const [dr, dz] = [(-Math.sin(theta) * thickness) / 2, (Math.cos(theta) * thickness) / 2];
    return [[r - dr, z - dz], [r + dr, z + dz]];
  });
}

/** What is shown of a stage, the same for all of its pictures [mm]. */
function shownOf(stages) {
  let [right, low, high] = [0, Infinity, -Infinity];
  for (const { film, thickness } of stages) {
    for (let i = 0; i < film.nodes.length; i += 4) {
      right = Math.max(right, film.nodes[i]);
      low = Math.min(low, film.nodes[i + 1] - thickness);
      high = Math.max(high, film.nodes[i + 1] + thickness);
    }
  }
  const room = 0.1 * right;
  const left = -0.02 * right;
  return { left, right: right + 0.05 * right, low: low - room, high: high + room };
}

/** The body of a tool: its line, closed far away on the side where no sheet is. */
function body({ role, outline }, [dr, dz], { x, y }) {
  const points = [];
  for (let i = 0; i < outline.length; i += 2) points.push([outline[i] + dr, outline[i + 1] + dz]);
  const far = role === "die" ? 1e4 : -1e4;
  points.push([points.at(-1)[0], far], [points[0][0], far]);
  return `M${points.map(([r, z]) => `${x(r).toFixed(1)} ${y(z).toFixed(1)}`).join("L")}Z`;
}

/** Draws a stage's picture; `other` is the same of design A, dashed. */
export function drawSection(host, { stage, picture, other, place }) {
  const shown = shownOf([stage, other?.stage].filter(Boolean));
  const width = Math.max(240, host.clientWidth);
  const most = Math.max(240, 0.42 * window.innerHeight);
  const scale = Math.min(width / (shown.right - shown.left), most / (shown.high - shown.low));
  const height = Math.round(scale * (shown.high - shown.low));
  const offset = (width - scale * (shown.right - shown.left)) / 2;
  const map = { x: (r) => offset + scale * (r - shown.left), y: (z) => height - scale * (z - shown.low) };
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", class: "section" });
  root.append(svg("title", {}, summary(stage, picture)));
  const tools = stage.film.tools;
  stage.tools.forEach((tool, j) => {
    const at = 2 * (picture * stage.tools.length + j);
    root.append(svg("path", { d: body(tool, [tools[at], tools[at + 1]], map), class: `tool ${tool.role}` }));
  });
  root.append(svg("line", { x1: map.x(0), x2: map.x(0), y1: 0, y2: height, class: "middle-line" }));
  root.append(...sheet(stage, picture, map));
  if (other) root.append(svg("path", { d: outline(faces(other.stage, other.picture), map), class: "sheet-a" }));
  if (Number.isFinite(place)) root.append(...marked(stage, picture, place, map));
  host.replaceChildren(root, scaleBar());
}

function sheet(stage, picture, { x, y }) {
  const sides = faces(stage, picture);
  const thickness = stage.film.thickness.subarray(stage.film.elements * picture);
  return sides.slice(1).map((end, e) => {
    const corners = [sides[e][0], end[0], end[1], sides[e][1]];
    const d = `M${corners.map(([r, z]) => `${x(r).toFixed(2)} ${y(z).toFixed(2)}`).join("L")}Z`;
    const fill = colour(1 - thickness[e] / stage.thickness);
    return svg("path", { d, fill, stroke: fill, class: "sheet" });
  });
}

function outline(sides, { x, y }) {
  const round = [...sides.map((side) => side[0]), ...sides.map((side) => side[1]).reverse()];
  return `M${round.map(([r, z]) => `${x(r).toFixed(1)} ${y(z).toFixed(1)}`).join("L")}Z`;
}

function marked(stage, picture, place, { x, y }) {
  const e = nearest(stage.end.s0, place);
  const [a, b] = [4 * ((stage.film.elements + 1) * picture + e), 4];
  const [r, z] = [0, 1].map((k) => (stage.film.nodes[a + k] + stage.film.nodes[a + b + k]) / 2);
  return [svg("circle", { cx: x(r), cy: y(z), r: 7, class: "place" })];
}

/** Index of the element whose place on the flat blank is nearest. */
export function nearest(s0, place) {
  let best = 0;
  for (let e = 1; e < s0.length; e++) if (Math.abs(s0[e] - place) < Math.abs(s0[best] - place)) best = e;
  return best;
}

function summary(stage, picture) {
  const { film, thickness } = stage;
  const least = Math.min(...film.thickness.subarray(film.elements * picture, film.elements * (picture + 1)));
  return `The section at travel ${format(film.travel[picture])} mm: thinnest ${format(least)} mm, −${format(100 * (1 - least / thickness))} %`;
}

function scaleBar() {
  const bar = html("span", { className: "bar" });
  bar.style.background = `linear-gradient(to right, ${COLOURS.map((mix) => `rgb(${mix.join(",")})`).join(",")})`;
  const percent = format(100 * FULL);
  return html("p", { className: "scale" }, `${percent} % thicker `, bar, ` ${percent} % thinner`);
}
