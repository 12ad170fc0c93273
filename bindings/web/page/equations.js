// Equations of a thickness point with their numbers, set by KaTeX: the flow law, or the return mapping of an elastic sheet.
import katex from "katex";

const tex = String.raw;

function number(value, digits = 4) {
  if (value === 0 || (Math.abs(value) >= 0.01 && Math.abs(value) < 1e5)) return String(Number(value.toPrecision(digits)));
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return tex`${mantissa}\cdot 10^{${Number(exponent)}}`;
}

const row = (values) => tex`(${Array.from(values, (value) => number(value)).join(tex`,\; `)})`;
const unit = (name) => tex`\;\mathrm{${name}}`;
const REGULAR = tex`\Delta t\,\dot{\bar\varepsilon}_\mathrm{reg}`;
const G = tex`g\,g^{\mathsf T}`;

/** C of each matrix, with f = σ_y/(Δt ε̄̇_reg), g = A Δε and the carried stress w. */
const TANGENTS = {
  secant: tex`C = f A`,
  newton: tex`C = f A + h\,${G} - \frac{f}{(${REGULAR})^2}\,${G}`,
  primal_dual: tex`C = f A + h\,${G} - \frac{w\,g^{\mathsf T} + g\,w^{\mathsf T}}{2\,(${REGULAR})^2}`,
};

function flow({ equivalent_increment: own, yield_stress: stress, viscosity, stress: sigma }, duration, matrix) {
  const regular = (stress * duration) / (3 * viscosity);
  const cut = Math.sqrt(Math.max(0, regular ** 2 - own ** 2));
  return [
    tex`${REGULAR} = \sqrt{(\Delta t\,\dot{\bar\varepsilon})^2 + \Delta\varepsilon_0^2} = \sqrt{(${number(own)})^2 + (${number(cut)})^2} = ${number(regular)}`,
    tex`\mu = \frac{\sigma_y}{3\,\dot{\bar\varepsilon}_\mathrm{reg}} = \frac{${number(stress)}${unit("MPa")}\cdot ${number(duration)}${unit("s")}}{3\cdot ${number(regular)}} = ${number(viscosity)}${unit("MPa\\,s")}`,
    tex`\sigma = 3\,\mu\,A\,\dot\varepsilon = ${row(sigma)}${unit("MPa")},\quad f = \frac{\sigma_y}{${REGULAR}} = ${number(stress / regular)}${unit("MPa")}`,
    TANGENTS[matrix],
  ];
}

function elastoplastic({ equivalent_increment: own, yield_stress: stress, trial_stress: trial, stress: sigma }) {
  return [
    tex`\sigma^\mathrm{tr} = \sigma_0 + D\,\Delta\varepsilon = ${row(trial)}${unit("MPa")}`,
    own > 0
      ? tex`\bar\sigma(\sigma^\mathrm{tr}) > \sigma_y \;\Rightarrow\; \bar\sigma(\sigma) = \sigma_y(\bar\varepsilon + \Delta p) = ${number(stress)}${unit("MPa")} \;\Rightarrow\; \Delta p = ${number(own)}`
      : tex`\bar\sigma(\sigma^\mathrm{tr}) \le \sigma_y = ${number(stress)}${unit("MPa")} \;\Rightarrow\; \Delta p = 0 \text{: elastic}`,
    tex`\sigma = \sigma^\mathrm{tr} - \Delta p\,D\,\frac{\partial\bar\sigma}{\partial\sigma} = ${row(sigma)}${unit("MPa")}`,
    own > 0 ? tex`C = \frac{\mathrm d\sigma}{\mathrm d\Delta\varepsilon} \text{ with } \mathrm d\Delta p \ne 0` : tex`C = D`,
  ];
}

/** HTML of the equations of a point in an iteration with a matrix of a step of `duration` [s]. */
export function equations(point, duration, matrix, { velocity, residual }) {
  const rows = point.trial_stress ? elastoplastic(point) : flow(point, duration, matrix);
  const tangent = tex`C = \begin{pmatrix}${Array.from(point.tangent, (entries) => Array.from(entries, (entry) => number(entry)).join(" & ")).join(tex`\\`)}\end{pmatrix}${unit("MPa")}`;
  const norm = velocity === null ? "" : tex`,\quad \frac{\lVert\delta\dot a\rVert}{\lVert\dot a\rVert} = ${number(velocity, 3)}`;
  const step = tex`\delta\dot a = -H^{-1} r${norm},\quad \lVert r\rVert = ${number(residual, 3)}`;
  return [...rows, tangent, step].map((row) => `<p>${katex.renderToString(row, { displayMode: true, fleqn: true })}</p>`).join("");
}
