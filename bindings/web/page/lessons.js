// Lessons of one screen: a few sentences, and a question that is answered by moving a slider. docs/lessons.md has more on each.
import { format } from "./dom.js";

const lastOf = ({ stages }) => stages.at(-1);
const finding = ({ verdict }, key) => verdict.rows.find((one) => one.key === key);
const peak = ({ stages }) => Math.max(...stages[0].steps.punch_force);

/** Place of the thinnest element on the flat blank [mm]. */
function thinnestAt(result) {
  const { thickness, s0 } = lastOf(result).end;
  return s0[thickness.indexOf(Math.min(...thickness))];
}

/** Angle by which a leg turns back when the tools are taken away [°]. */
function turnsBack({ stages }) {
  const [drawn, released] = stages.map(({ film }) => film.nodes.at(-2));
  return (Math.abs(released - drawn) * 180) / Math.PI;
}

/** Iterations of a step with one of the matrices. */
const iterations = ({ ways }, matrix) => ways.find((one) => one.matrix === matrix).velocity.length;

/**
 * Each begins with a template; the control that answers it, and when it has: by what is solved, by what was solved first, and by
 * the step that is taken apart. The fields stand in lesson_panel.js.
 */
export const LESSONS = [
  {
    title: "Ideal drawing",
    says: "Without friction and bending only the flange takes work: its circles shrink from the blank's rim to the throat, and the wall pulls with F = 2π r t σ ln(R/r). Friction under the holder and round the shoulder, and bending, come on top.",
    question: "Bring the largest punch force below 35 kN with lubricant alone: what is left is nearly the ideal force.",
    template: "cup",
    control: { key: "friction", label: "Friction", from: 0.01, to: 0.24, value: 0.08 },
    answer: ({ result }) => `${format(peak(result) / 1e3)} kN`,
    isAnswered: ({ result }) => peak(result) < 35e3,
  },
  {
    title: "Why a velocity norm",
    says: "Forces out of balance say little: a penalty spring makes them huge where a tool hardly sinks in, and a rigid zone bears any. How far an iteration moves the sheet is a length, the same for all: ‖δȧ‖ / ‖ȧ‖.",
    question: "Go through the iterations until one moves the sheet by less than a thousandth of its step.",
    template: "cup",
    control: { key: "iteration" },
    kind: "step",
    answer: ({ iterate }) => format(iterate.velocity ?? NaN),
    isAnswered: ({ iterate }) => (iterate.velocity ?? 1) < 1e-3,
  },
  {
    title: "Why primal-dual",
    says: "Where the sheet hardly deforms, the flow law σ = σ_y Δε / √(Δε² + Δε₀²) bends sharply. The secant matrix crawls round that bend, Newton's jumps over it. The primal-dual matrix keeps stress and strain as two unknowns, and does neither.",
    question: "Find a step for which the secant takes at least fifteen times as many iterations as the primal-dual matrix.",
    template: "cup",
    control: { key: "step" },
    kind: "step",
    answer: ({ trace }) => `${iterations(trace, "secant")} : ${iterations(trace, "primal_dual")}`,
    isAnswered: ({ trace }) => iterations(trace, "secant") >= 15 * iterations(trace, "primal_dual"),
  },
  {
    title: "Volume constancy and thinning",
    says: "The sheet keeps its volume: t = t₀ exp(−ε_s − ε_θ). Towards the throat the circles of the flange become shorter, ε_θ is negative, and the rim grows thicker although it is pulled.",
    question: "The circles of a smaller blank have less to shrink: find one whose rim stays below 1.20 mm.",
    template: "cup",
    control: { key: "blank.radius", label: "Blank radius", from: 42, to: 64, unit: "mm" },
    answer: ({ result }) => `${format(Math.max(...lastOf(result).end.thickness))} mm`,
    isAnswered: ({ result }) => Math.max(...lastOf(result).end.thickness) < 1.2,
  },
  {
    title: "Friction and the pole",
    says: "A punch stretches a clamped sheet into a dome. Where the sheet lies on the punch, friction holds it, and what is held does not thin any more: the thinnest place wanders from the pole outward.",
    question: "Bring the thinnest place within 8 mm of the pole.",
    template: "stretch-dome",
    control: { key: "friction", label: "Friction", from: 0.01, to: 0.24, value: 0.08 },
    answer: ({ result }) => `${format(thinnestAt(result))} mm`,
    isAnswered: ({ result }) => thinnestAt(result) < 8,
  },
  {
    title: "Draw ratio",
    says: "The wall must pull the whole flange in: the force grows with the blank's diameter over that of the punch, what the wall can bear does not. Their ratio has a limit near 2.",
    question: "Enlarge the blank until the wall comes near the force that it can bear: tearing is no longer green.",
    template: "cup",
    control: { key: "blank.radius", label: "Blank radius", from: 42, to: 64, unit: "mm" },
    answer: ({ result }) => finding(result, "tearing")?.found ?? "",
    isAnswered: ({ result }) => finding(result, "tearing")?.light !== "green",
  },
  {
    title: "Bending and unbending",
    says: "Sheet that runs over a radius is bent and straightened again, and both are paid for: the sharper the radius over the thickness, the larger the force.",
    question: "Sharpen the punch nose until the force exceeds 28 N per millimetre of width.",
    template: "u-bend",
    control: { key: "tools.punch.flat.nose", label: "Punch nose radius", from: 2, to: 8, unit: "mm" },
    answer: ({ result }) => `${format(peak(result))} N/mm`,
    isAnswered: ({ result }) => peak(result) > 28,
  },
  {
    title: "Spring-back",
    says: "Bending leaves a moment in the sheet. When the tools go, it turns back elastically by κ = 12 M (1 − ν²) / (E t³): the stronger and the thinner the sheet, the further.",
    question: "Find a thickness at which each leg turns back by more than 4 degrees.",
    template: "v-bend",
    control: { key: "blank.thickness", label: "Sheet thickness", from: 0.5, to: 1.6, unit: "mm" },
    answer: ({ result }) => `${format(turnsBack(result))}°`,
    isAnswered: ({ result }) => turnsBack(result) > 4,
  },
  {
    title: "Localisation",
    says: "Where a place thins, it hardens, and its neighbours take over: n says how much. When hardening no longer outweighs thinning, one place takes all the stretching, and the sheet tears.",
    question: "Find an n at which the thinnest place is thinner than 0.70 mm.",
    template: "stretch-dome",
    control: { key: "material.hardening.swift.n", label: "Hardening n", from: 0.08, to: 0.3 },
    answer: ({ result }) => `${format(Math.min(...lastOf(result).end.thickness))} mm`,
    isAnswered: ({ result }) => Math.min(...lastOf(result).end.thickness) < 0.7,
  },
  {
    title: "Error bars",
    says: "Every number hangs on the mesh, too. Solved once more with other elements, it says by how much: what moves is not the cup but the arithmetic, and a number without that bar is half a number.",
    question: "Take elements away until the largest punch force is off by more than 1 %.",
    template: "cup",
    control: { key: "blank.elements", label: "Elements", from: 8, to: 80 },
    answer: ({ result, first }) => `${format(100 * Math.abs(peak(result) / peak(first) - 1), 2)} %`,
    isAnswered: ({ result, first }) => Math.abs(peak(result) / peak(first) - 1) > 0.01,
  },
];
