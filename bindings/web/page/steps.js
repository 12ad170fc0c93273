// One step of the solver, iteration by iteration: the sheet as it is tried, norms with each matrix, points with their equations.
import { equations } from "./equations.js";
import { draw } from "./plot.js";
import { drawing, drawTools, faces, mapOf, nearest, nodesOf, place, sheetOf } from "./section.js";
import { byId, format, html, nothing, render, scientific, svg } from "./dom.js";

const MATRICES = { primal_dual: "primal-dual", newton: "Newton", secant: "secant" };
const POWERS = { external: "tools", plastic: "plastic flow", elastic: "elastic", friction: "friction", contact: "contact springs" };
/** Numbers below are drawn as it: nothing is left there. */
const LEAST = 1e-12;
/** Of the longest arrow over the width of the picture, and half the width of a zoom over the thickness [–]. */
const [ARROW, ZOOM] = [0.12, 5];
const ARROWS = { contact: ["contact force", "N"], balance: ["out of balance", "N"], correction: ["δȧ", "mm/s"] };

const log = (values) => Array.from(values, (value) => Math.log10(Math.max(LEAST, value)));
const size = ([r, z]) => Math.hypot(r, z);

export class Steps {
  /** ask(question) answers a question on the case; onShow() hears of every iteration that is shown, pick(e) picks an element. */
  constructor(ask, onShow, pick) {
    Object.assign(this, { ask, onShow, pick, trace: null, element: 0, point: 0 });
    byId("teach").addEventListener("click", () => this.toggle(!this.isShown));
    byId("step").addEventListener("change", () => this.load());
    byId("step").addEventListener("input", () => (byId("step-text").textContent = byId("step").value));
    byId("iteration").addEventListener("input", () => this.draw());
    byId("matrix").addEventListener("change", () => this.begin());
    new ResizeObserver(() => this.draw()).observe(byId("main"));
  }

  get isShown() {
    return !byId("steps").hidden;
  }

  get way() {
    return this.trace.ways[Math.max(0, byId("matrix").selectedIndex)];
  }

  get iterate() {
    return this.trace && this.way.iterates[byId("iteration").valueAsNumber];
  }

  async toggle(isShown) {
    byId("steps").hidden = !isShown;
    byId("teach").setAttribute("aria-pressed", isShown);
    if (isShown) await this.load();
  }

  async show({ stages: [stage] }) {
    this.next = stage;
    byId("step").max = stage.steps.travel.length;
    if (this.isShown) await this.load();
    else byId("step").value = Math.round(0.4 * stage.steps.travel.length);
  }

  async load() {
    const trace = await this.ask({ do: "trace", step: byId("step").valueAsNumber });
    if (!trace || trace.error) return;
    Object.assign(this, { trace, stage: this.next });
    render(trace.ways.map(({ matrix }) => html`<option value=${matrix}>${MATRICES[matrix]}</option>`), byId("matrix"));
    this.begin();
  }

  /** From the predictor of a matrix, at the node that is most out of balance. */
  begin() {
    const { iterates } = this.way;
    Object.assign(byId("iteration"), { max: iterates.length - 1, value: 0 });
    const forces = iterates[0].forces.map(size);
    this.choose(Math.min(forces.indexOf(Math.max(...forces)), iterates[0].cutOff.length - 1));
  }

  choose(element) {
    Object.assign(this, { element, point: 0 });
    this.draw();
  }

  async draw() {
    if (!this.trace || !this.isShown) return;
    const { trace, iterate, way, element, stage } = this;
    const at = byId("iteration").valueAsNumber;
    byId("step-text").textContent = `${trace.step}: ${format(trace.travel)} mm`;
    byId("iteration-text").textContent = `${at} / ${way.iterates.length - 1}`;
    drawSheet(iterate, element, stage, trace.travel, this.pick);
    drawNorms(byId("norms"), trace, way, at);
    drawResidual(byId("residual"), iterate, element, (node) => this.pick(Math.min(Math.round(node), iterate.cutOff.length - 1)));
    drawPower(byId("power"), trace.power);
    this.onShow();
    const { points } = await this.ask({ do: "points", way: trace.ways.indexOf(way), iteration: at, element });
    if (points && iterate === this.iterate && element === this.element) this.drawPoints(points);
  }

  /** Numbers of the points through the thickness, and the equations of the one that is chosen. */
  drawPoints(points) {
    const { trace, way, iterate, element } = this;
    this.point = Math.min(this.point, points.length - 1);
    const inner = trace.isElastic ? ["Δp", "σ_tr,s", "σ_tr,θ"] : ["Δt ε̄̇", "μ [MPa s]"];
    const columns = ["Point", "Δε_s", "Δε_θ", "Δγ", "ε̄", ...inner, "σ_y", "σ_s", "σ_θ", "τ", "C_ss", "C_sθ", "C_θθ", "C_γγ"];
    const numbers = ({ strain_increment: e, equivalent_strain, equivalent_increment, yield_stress, stress, viscosity, trial_stress: trial, tangent: c }) =>
      [...e, equivalent_strain, equivalent_increment, ...(trial ? [trial[0], trial[1]] : [viscosity]), yield_stress, ...stress, c[0][0], c[0][1], c[1][1], c[2][2]];
    const choose = (k) => () => ((this.point = k), this.drawPoints(points));
    const rows = points.map((point, k) => html`<tr class=${k === this.point ? "chosen" : ""}>
      <th scope="row"><button aria-pressed=${k === this.point} @click=${choose(k)}>${k + 1}</button></th>${numbers(point).map((value) => html`<td>${scientific(value)}</td>`)}</tr>`);
    const state = iterate.cutOff[element] ? " is nearly rigid" : trace.isElastic ? "" : " flows";
    render(html`<p class="hint">Element ${element + 1}${state}. Points from the die's face to the punch's; stresses and C in MPa. Pick another element in a picture or chart, another point here.</p>
      <div class="scroll"><table class="points"><thead><tr>${columns.map((name) => html`<th scope="col">${name}</th>`)}</tr></thead><tbody>${rows}</tbody></table></div>`, byId("points"));
    byId("equations").innerHTML = equations(points[this.point], trace.duration, way.matrix, iterate);
  }
}

/** The whole sheet with its arrows, and the tools around the element that is picked. */
function drawSheet(iterate, element, stage, travel, pick) {
  const thickness = nodesOf(stage, nearest(stage.film.travel, travel)).map((node) => node[3]);
  const nodes = iterate.nodes.map((node, i) => [...node, thickness[i]]);
  const [rs, zs] = [0, 1].map((k) => nodes.map((node) => node[k]));
  const [right, low, high] = [Math.max(...rs), Math.min(...zs), Math.max(...zs)];
  const room = 0.14 * right;
  const [r, z] = [rs, zs].map((all) => (all[element] + all[element + 1]) / 2);
  const half = ZOOM * stage.thickness;
  const { contacts, forces, correction, cutOff } = iterate;
  const fills = cutOff.map((isRigid) => (isRigid ? "var(--tool-edge)" : "var(--c1)"));
  const at = { contact: contacts.map(({ position }) => position), balance: nodes, correction: nodes };
  const vectors = { contact: contacts.map(({ force }) => force), balance: forces, correction };
  const largest = Object.fromEntries(Object.entries(vectors).map(([look, all]) => [look, Math.max(LEAST, ...all.map(size))]));
  const show = (host, window, looks, tools, summary, under) => {
    const map = mapOf(host, 0.32 * innerHeight, window);
    const long = ARROW * (window.right - window.left);
    const arrows = looks.map((look) => vectors[look].map((vector, i) => arrow(map, at[look][i], vector.map((part) => (long * part) / largest[look]), look)));
    const keys = looks.filter((look) => largest[look] > LEAST).map((look) => html`<span class="key ${look}">→ ${ARROWS[look][0]}: ${scientific(largest[look])} ${ARROWS[look][1]}</span> `);
    render([drawing(map, summary, nodes, pick, tools(map), sheetOf(faces(nodes), fills, map), arrows, place(nodes, element, map)), html`<p class="hint">${under} ${keys}</p>`], host);
  };
  const rigid = cutOff.filter(Boolean).length;
  const summary = `${cutOff.length - rigid} elements flow, ${rigid} are nearly rigid; ${contacts.length} points in contact, ${contacts.filter(({ sticks }) => sticks).length} stick`;
  show(byId("tried"), { left: -room, right: right + room, low: low - room, high: high + room }, Object.keys(ARROWS), () => nothing, summary, `${summary}.`);
  const near = contacts.filter(({ position }) => size([position[0] - r, position[1] - z]) < half);
  const gaps = near.map(({ gap }) => 1e3 * gap);
  const under = near.length > 0 ? `${near.length} contact points here: gap ${format(Math.min(...gaps))} to ${format(Math.max(...gaps))} µm, pressure up to ${format(Math.max(...near.map(({ pressure }) => pressure)))} MPa.` : "No contact here.";
  const dots = (map) => near.map(({ position, sticks }) => svg`<circle class="touch ${sticks ? "sticks" : ""}" cx=${map.x(position[0])} cy=${map.y(position[1])} r="4"/>`);
  const tools = (map) => [drawTools(stage.tools, iterate.tools.flatMap((moved) => [...moved]), map)[0], dots(map)];
  show(byId("zoom"), { left: r - half, right: r + half, low: z - 0.6 * half, high: z + 0.6 * half }, ["contact", "correction"], tools, under, under);
}

function arrow({ x, y, scale }, [r, z], [dr, dz], look) {
  if (scale * Math.hypot(dr, dz) < 2) return nothing;
  const to = [x(r + dr), y(z + dz)];
  const along = [dr, -dz].map((part) => part / Math.hypot(dr, dz));
  const barb = (side) => `${to[0] - 5 * along[0] + side * 2.5 * along[1]} ${to[1] - 5 * along[1] - side * 2.5 * along[0]}`;
  return svg`<path class="force ${look}" d="M${x(r)} ${y(z)}L${to.join(" ")}M${barb(1)}L${to.join(" ")}L${barb(-1)}"/>`;
}

function drawNorms(host, trace, way, at) {
  const name = ({ matrix, converged }) => `${MATRICES[matrix]}${converged ? "" : " (not converged)"}`;
  const curve = (values) => ({ x: Array.from(values, (_, k) => k + 1), y: log(values) });
  const series = trace.ways.map((one, i) => ({ name: name(one), ...curve(one.velocity), look: `c${i}` }));
  series.push({ name: `‖r‖, ${MATRICES[way.matrix]}`, ...curve(way.residual), look: "a" });
  const [longest, bound] = [Math.max(2, ...series.map(({ x }) => x.length)), Math.log10(trace.tolerance)];
  series.push({ name: "tolerance", x: [0, longest], y: [bound, bound], look: "flat" });
  const before = way.velocity.length - way.iterates.length + 1;
  const counts = trace.ways.map((one) => `${name(one)}: ${one.velocity.length}`).join("; ");
  draw(host, { x: { label: "Iteration" }, y: { label: "‖δȧ‖ / ‖ȧ‖ [–]", powers: true }, series, cursor: { x: before + at }, summary: counts });
}

function drawResidual(host, iterate, element, onPick) {
  const forces = log(iterate.forces.map(size));
  const summary = `Force out of balance at each node: ${format(10 ** Math.max(...forces))} N`;
  draw(host, { x: { label: "Node" }, y: { label: "Force [N]", powers: true }, series: [{ x: forces.map((_, i) => i), y: forces, look: "c0" }], cursor: { x: element }, summary, onPick });
}

function drawPower(host, power) {
  const all = Object.entries(POWERS).filter(([key]) => power[key] !== 0);
  const largest = Math.max(...all.map(([key]) => Math.abs(power[key])), LEAST);
  const rows = all.map(([key, name]) => html`<tr><td>${name}</td><td><meter value=${Math.abs(power[key] / largest)} aria-label=${name}></meter></td><td>${format((100 * power[key]) / largest)} %</td></tr>`);
  render(html`<table class="power">${rows}</table>`, host);
}
