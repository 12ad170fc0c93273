// One step of the solver, iteration by iteration: the sheet as it is tried, norms with each matrix, equations with their numbers.
import { draw } from "./plot.js";
import { byId, format, html, svg } from "./dom.js";

const MATRICES = { primal_dual: "primal-dual", newton: "Newton", secant: "secant" };
const POWERS = { external: "tools", plastic: "plastic flow", elastic: "elastic", friction: "friction", contact: "contact springs" };
/** Numbers below are drawn as it: nothing is left there. */
const LEAST = 1e-12;
/** Of the longest arrow over the width of the sheet [–]. */
const ARROW = 0.12;

const log = (values) => Array.from(values, (value) => Math.log10(Math.max(LEAST, value)));

export class Steps {
  /** ask(step) answers with the trace of a step; onShow() hears of every iteration that is shown. */
  constructor(ask, onShow) {
    Object.assign(this, { ask, onShow, trace: null, element: 0 });
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

  /** History of the chosen matrix. */
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

  /** Another result: as many steps as its first stage has. */
  show({ stages }) {
    const { length } = stages[0].steps.travel;
    byId("step").max = length;
    if (this.isShown) this.load();
    else byId("step").value = Math.round(0.4 * length);
  }

  async load() {
    const trace = await this.ask(byId("step").valueAsNumber);
    if (!trace || trace.error) return;
    this.trace = trace;
    const chosen = Math.max(0, byId("matrix").selectedIndex);
    byId("matrix").replaceChildren(...trace.ways.map(({ matrix }, i) => new Option((MATRICES[matrix]), matrix, false, i === chosen)));
    this.begin();
  }

  /** From the predictor of a matrix, at the node that is most out of balance. */
  begin() {
    const { iterates } = this.way;
    byId("iteration").max = iterates.length - 1;
    byId("iteration").value = 0;
    const forces = sizes(iterates[0].forces, 2, 0);
    this.element = Math.min(forces.indexOf(Math.max(...forces)), iterates[0].increments.length - 1);
    this.draw();
  }

  draw() {
    if (!this.trace || !this.isShown) return;
    const { trace, iterate, way } = this;
    const at = byId("iteration").valueAsNumber;
    byId("step-text").textContent = `${trace.step}: ${format(trace.travel)} mm`;
    byId("iteration-text").textContent = `${at} / ${way.iterates.length - 1}`;
    const pick = (node) => {
      this.element = Math.min(Math.round(node), iterate.increments.length - 1);
      this.draw();
    };
    drawTried(byId("tried"), iterate, this.element);
    drawNorms(byId("norms"), trace, at);
    drawResidual(byId("residual"), iterate, this.element, pick);
    drawPower(byId("power"), trace.power);
    drawEquations(byId("equations"), trace, iterate, this.element);
    this.onShow();
  }
}

/** Sizes of vectors that stand in an array, every `stride` numbers, from `first` on. */
function sizes(array, stride, first) {
  return Array.from({ length: array.length / stride }, (_, i) => Math.hypot(array[stride * i + first], array[stride * i + first + 1]));
}

/** The sheet with two kinds of arrows, each kind over its largest. */
function drawTried(host, { nodes, forces, contacts, cutOff, sticking }, element) {
  const count = nodes.length / 2;
  const of = (k) => Array.from({ length: count }, (_, i) => nodes[2 * i + k]);
  const [rs, zs] = [of(0), of(1)];
  const [right, low, high] = [Math.max(...rs), Math.min(...zs), Math.max(...zs)];
  const width = Math.max(240, host.clientWidth);
  const room = 0.14 * right;
  const scale = width / (right + 2 * room);
  const height = Math.max(120, scale * (high - low + 2 * room));
  const x = (r) => scale * (r + room);
  const y = (z) => height - scale * (z - low + room);
  const rigid = cutOff.filter(Boolean).length;
  const touching = contacts.length / 4;
  const summary = `${cutOff.length - rigid} flows, ${rigid} nearly rigid; ${touching} points in contact, ${sticking} stick`;
  const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img" }, svg("title", {}, summary));
  cutOff.forEach((is, e) => {
    root.append(svg("line", { x1: x(rs[e]), y1: y(zs[e]), x2: x(rs[e + 1]), y2: y(zs[e + 1]), class: `tried ${is ? "rigid" : "flows"}` }));
  });
  const arrow = (r, z, [dr, dz], look) => {
    if (scale * Math.hypot(dr, dz) < 2) return;
    const [from, to] = [[x(r), y(z)], [x(r + dr), y(z + dz)]];
    const along = [0, 1].map((k) => (to[k] - from[k]) / Math.hypot(to[0] - from[0], to[1] - from[1]));
    const barb = (side) => `${(to[0] - 5 * along[0] + side * 2.5 * along[1]).toFixed(1)} ${(to[1] - 5 * along[1] - side * 2.5 * along[0]).toFixed(1)}`;
    const tip = to.map((at) => at.toFixed(1)).join(" ");
    root.append(svg("path", { d: `M${from.map((at) => at.toFixed(1)).join(" ")}L${tip}M${barb(1)}L${tip}L${barb(-1)}`, class: `force ${look}` }));
  };
  const [most, pressed] = [Math.max(...sizes(forces, 2, 0), LEAST), Math.max(...sizes(contacts, 4, 2), LEAST)];
  const long = (force, largest) => (ARROW * right * force) / largest;
  for (let i = 0; i < contacts.length; i += 4) {
    arrow(contacts[i], contacts[i + 1], [long(contacts[i + 2], pressed), long(contacts[i + 3], pressed)], "contact");
  }
  for (let i = 0; i < count; i++) arrow(rs[i], zs[i], [long(forces[2 * i], most), long(forces[2 * i + 1], most)], "");
  root.append(svg("circle", { cx: x((rs[element] + rs[element + 1]) / 2), cy: y((zs[element] + zs[element + 1]) / 2), r: 7, class: "place" }));
  const key = (look, text) => html("span", { className: `force-key ${look}` }, `→ ${text}`);
  const keys = [key("contact", `contact force: ${format(pressed)} N`), "  ", key("", `out of balance: ${format(most)} N`)];
  host.replaceChildren(root, html("p", { className: "hint" }, `${summary}. `, ...keys));
}

function drawNorms(host, trace, at) {
  const name = ({ matrix, converged }) => `${(MATRICES[matrix])}${converged ? "" : ` (not converged)`}`;
  const series = trace.ways.map((way, i) => ({ name: name(way), x: Array.from(way.velocity, (_, k) => k + 1), y: log(way.velocity), look: `c${i}` }));
  const longest = Math.max(2, ...series.map(({ x }) => x.length));
  const bound = Math.log10(trace.tolerance);
  series.push({ name: "tolerance", x: [0, longest], y: [bound, bound], look: "flat" });
  const counts = trace.ways.map((way) => `${name(way)}: ${way.velocity.length}`).join("; ");
  draw(host, { x: { label: "Iteration" }, y: { label: "‖δȧ‖ / ‖ȧ‖", powers: true }, series, cursor: { x: at }, summary: counts });
}

function drawResidual(host, iterate, element, onPick) {
  const forces = log(sizes(iterate.forces, 2, 0));
  const nodes = forces.map((_, i) => i);
  draw(host, {
    x: { label: "Node" },
    y: { label: `Force [N]`, powers: true },
    series: [{ name: "", x: nodes, y: forces, look: "c0" }],
    cursor: { x: element },
    summary: `Force out of balance at each node: ${format(10 ** Math.max(...forces))} N`,
    onPick,
  });
}

function drawPower(host, power) {
  const all = Object.entries(POWERS).filter(([key]) => power[key] !== 0);
  const largest = Math.max(...all.map(([key]) => Math.abs(power[key])), LEAST);
  const rows = all.map(([key, name]) => {
    const share = power[key] / largest;
    const cells = [name, html("meter", { value: Math.abs(share), ariaLabel: name }), `${format(100 * share)} %`];
    return html("tr", {}, ...cells.map((cell) => html("td", {}, cell)));
  });
  host.replaceChildren(html("table", { className: "power" }, ...rows));
}

/** MathML of plain parts. */
const math = (inner) => `<math display="block"><mrow>${inner}</mrow></math>`;
const mi = (name) => `<mi>${name}</mi>`;
const mo = (sign) => `<mo>${sign}</mo>`;
const mn = (value, digits = 4) => `<mn>${format(value, digits)}</mn>`;
const rate = `<mover>${mi("ε")}${mo("¯")}</mover>`;
const increment = `<mrow>${mi("Δ")}${rate}</mrow>`;
const sub = (base, index) => `<msub>${base}<mn>${index}</mn></msub>`;
const squared = (base) => `<msup><mrow>${base}</mrow><mn>2</mn></msup>`;

function drawEquations(host, trace, iterate, element) {
  const [own, yieldStress] = [iterate.increments[element], iterate.yieldStresses[element]];
  const regular = Math.hypot(own, trace.cutoff ?? 0);
  const cut = `${mi("Δ")}${sub(mi("ε"), 0)}`;
  const velocity = iterate.velocity;
  const rows = [
    math(`<msub>${increment}<mi>reg</mi></msub>${mo("=")}<msqrt>${squared(increment)}${mo("+")}${squared(cut)}</msqrt>${mo("=")}<msqrt>${squared(mn(own))}${mo("+")}${squared(mn(trace.cutoff ?? 0))}</msqrt>${mo("=")}${mn(regular)}`),
    math(`${mi("σ")}${mo("=")}<mfrac><msub>${mi("σ")}<mi>y</mi></msub><msub>${increment}<mi>reg</mi></msub></mfrac>${mi("A")}${mi("Δ")}${mi("ε")}${mo(",")}<mfrac><mrow>${mn(yieldStress)}<mtext> MPa</mtext></mrow>${mn(regular)}</mfrac>${mo("=")}${mn(yieldStress / regular)}<mtext> MPa</mtext>`),
    math(`${mi("δ")}<mover>${mi("a")}${mo("˙")}</mover>${mo("=")}${mo("−")}<msup>${mi("H")}<mrow>${mo("−")}<mn>1</mn></mrow></msup>${mi("r")}${velocity === null ? "" : `${mo(",")}<mfrac><mrow>${mo("‖")}${mi("δ")}<mover>${mi("a")}${mo("˙")}</mover>${mo("‖")}</mrow><mrow>${mo("‖")}<mover>${mi("a")}${mo("˙")}</mover>${mo("‖")}</mrow></mfrac>${mo("=")}${mn(velocity, 3)}`}`),
  ];
  const state = iterate.cutOff[element] ? "nearly rigid" : "flows";
  const note = `Element ${element}: ${state}. Each matrix takes the step from the same state; pick an element in the chart of nodes.`;
  host.innerHTML = rows.map((row) => `<p>${row}</p>`).join("");
  host.prepend(html("p", { className: "hint" }, note));
}
