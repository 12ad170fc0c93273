// The section as it stands at a picture of the film: true thickness, coloured; the labelled tools around it.
import { format, html, nothing, raised, render, svg } from "./dom.js";

/** Change of thickness at the ends of the colours [–]. */
const FULL = 0.25;
/** From thicker to thinner, apart for colour-blind readers and in grey at its ends; from low to high viscosity (viridis). */
const CHANGE = [[0, 90, 160], [120, 180, 215], [224, 224, 216], [236, 165, 80], [165, 45, 10]];
const VIRIDIS = [[253, 231, 37], [94, 201, 98], [33, 145, 140], [59, 82, 139], [68, 1, 84]];

const css = (mix) => `rgb(${mix.map(Math.round).join(",")})`;

function colour(colours, share) {
  const at = (colours.length - 1) * Math.min(1, Math.max(0, share));
  const i = Math.min(colours.length - 2, Math.floor(at));
  return css(colours[i].map((from, k) => from + (at - i) * (colours[i + 1][k] - from)));
}

function colouring({ film, thickness }, picture, isViscosity) {
  const own = (key) => Array.from(film[key].subarray(film.elements * picture, film.elements * (picture + 1)));
  if (!isViscosity) {
    const percent = format(100 * FULL);
    return [own("thickness").map((t) => colour(CHANGE, 0.5 + (1 - t / thickness) / (2 * FULL))), key(`${percent} % thicker`, CHANGE, `${percent} % thinner`)];
  }
  const decades = own("viscosity").map(Math.log10);
  const finite = decades.filter(Number.isFinite);
  if (finite.length === 0) return [decades.map(() => css(CHANGE[2])), html`<p class="scale">nothing flows yet</p>`];
  const [low, high] = [Math.floor(Math.min(...finite)), Math.ceil(Math.max(...finite))];
  const shares = decades.map((at) => (Number.isFinite(at) ? (at - low) / Math.max(1, high - low) : 1));
  return [shares.map((share) => colour(VIRIDIS, share)), key(`flows: μ = 10${raised(low)} MPa s`, VIRIDIS, `10${raised(high)} MPa s: nearly rigid`)];
}

function key(low, colours, high) {
  return html`<p class="scale">${low} <span class="bar" style="background:linear-gradient(to right,${colours.map(css).join(",")})"></span> ${high}</p>`;
}

/** Both faces of the sheet at nodes [r, z, θ, thickness]: [r, z] of the lower and of the upper one. */
export function faces(nodes) {
  return nodes.map(([r, z, theta, thickness]) => {
    const [dr, dz] = [(-Math.sin(theta) * thickness) / 2, (Math.cos(theta) * thickness) / 2];
    return [[r - dr, z - dz], [r + dr, z + dz]];
  });
}

/** Nodes of a picture: [r, z, θ, thickness] of each. */
export function nodesOf({ film }, picture) {
  const at = 4 * (film.elements + 1) * picture;
  return Array.from({ length: film.elements + 1 }, (_, i) => film.nodes.subarray(at + 4 * i, at + 4 * i + 4)).map((node) => Array.from(node));
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
  return { left: -0.02 * right, right: 1.05 * right, low: low - 0.1 * right, high: high + 0.1 * right };
}

/** The way from millimetres to pixels of a picture that shows `window`. */
export function mapOf(host, most, { left, right, low, high }) {
  const width = Math.max(240, host.clientWidth);
  const scale = Math.min(width / (right - left), most / (high - low));
  const [height, offset] = [Math.round(scale * (high - low)), (width - scale * (right - left)) / 2];
  const map = { width, height, scale, x: (r) => offset + scale * (r - left), y: (z) => height - scale * (z - low) };
  const line = (points) => `M${points.map(([r, z]) => `${map.x(r).toFixed(2)} ${map.y(z).toFixed(2)}`).join("L")}`;
  return Object.assign(map, { line, window: { left, right, low, high } });
}

/** Tools that have moved by `moved` [mm], with their names; each is closed far away on the side where no sheet is. */
export function drawTools(tools, moved, { x, line, width, height, window }) {
  const bodies = tools.map(({ role, outline }, j) => {
    const points = Array.from({ length: outline.length / 2 }, (_, i) => [outline[2 * i] + moved[2 * j], outline[2 * i + 1] + moved[2 * j + 1]]);
    const [isAbove, ends] = [role === "die", [points.at(-1)[0], points[0][0]]];
    const [from, to] = [Math.max(window.left, Math.min(...ends)), Math.min(window.right, Math.max(...ends))];
    const label = svg`<text class="tool-label" x=${Math.min(width - 24, x((from + to) / 2))} y=${isAbove ? 16 : height - 6}>${role}</text>`;
    return [svg`<path class="tool ${role}" d="${line([...points, ...ends.map((r) => [r, isAbove ? 1e4 : -1e4])])}Z"/>`, to - from > 0 ? label : nothing];
  });
  return [bodies.map(([body]) => body), bodies.map(([, label]) => label)];
}

export function sheetOf(sides, fills, { line }) {
  return fills.map((fill, e) => svg`<path class="sheet" fill=${fill} stroke=${fill} d="${line([sides[e][0], sides[e + 1][0], sides[e + 1][1], sides[e][1]])}Z"/>`);
}

/** A picture that a click or a tap picks an element in. */
export function drawing({ width, height, x, y }, summary, nodes, onPick, ...content) {
  const middle = (e) => [0, 1].map((k) => (nodes[e][k] + nodes[e + 1][k]) / 2);
  const pick = ({ currentTarget, clientX, clientY }) => {
    const { left, top } = currentTarget.getBoundingClientRect();
    const away = nodes.slice(1).map((_, e) => middle(e)).map(([r, z]) => Math.hypot(x(r) - clientX + left, y(z) - clientY + top));
    onPick(away.indexOf(Math.min(...away)));
  };
  return html`<svg viewBox="0 0 ${width} ${height}" width=${width} height=${height} role="img" aria-label=${summary} @click=${pick}>${content}</svg>`;
}

export function place(nodes, e, { x, y }) {
  return svg`<circle class="place" cx=${x((nodes[e][0] + nodes[e + 1][0]) / 2)} cy=${y((nodes[e][1] + nodes[e + 1][1]) / 2)} r="7"/>`;
}

export function drawSection(host, { stage, picture, other, chosen, isViscosity, onElement, most }) {
  const map = mapOf(host, most, shownOf([stage, other?.stage].filter(Boolean)));
  const nodes = nodesOf(stage, picture);
  const count = 2 * stage.tools.length;
  const [bodies, labels] = drawTools(stage.tools, stage.film.tools.subarray(count * picture, count * (picture + 1)), map);
  const [fills, key] = colouring(stage, picture, isViscosity);
  const before = other && faces(nodesOf(other.stage, other.picture));
  const dashed = before ? svg`<path class="sheet-a" d="${map.line([...before.map(([low]) => low), ...before.map(([, high]) => high).reverse()])}Z"/>` : nothing;
  const axis = svg`<line class="middle-line" x1=${map.x(0)} x2=${map.x(0)} y1="0" y2=${map.height}/>`;
  const mark = chosen >= 0 ? place(nodes, chosen, map) : nothing;
  render([drawing(map, summary(stage, picture), nodes, onElement, bodies, axis, sheetOf(faces(nodes), fills, map), dashed, labels, mark), key], host);
}

/** Index of the element whose place on the flat blank is nearest; −1 where none is chosen. */
export function nearest(s0, place) {
  if (!Number.isFinite(place)) return -1;
  return s0.reduce((best, at, e) => (Math.abs(at - place) < Math.abs(s0[best] - place) ? e : best), 0);
}

function summary({ film, thickness }, picture) {
  const least = Math.min(...film.thickness.subarray(film.elements * picture, film.elements * (picture + 1)));
  return `The section at travel ${format(film.travel[picture])} mm: thinnest ${format(least)} mm, −${format(100 * (1 - least / thickness))} %`;
}
