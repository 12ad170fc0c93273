// Ten lessons on the method: their texts, cases and controls are those of lessons.json, with what each reads off a result.
import TEXTS from "../../lessons.json";
import { format } from "./dom.js";

const lastOf = ({ stages }) => stages.at(-1);
const steps = ({ stages }) => stages[0].steps;
const peak = (result) => Math.max(...steps(result).punch_force);
const sum = (values) => values.reduce((sum, value) => sum + value, 0);
const percent = (value, of) => 100 * (value / of - 1);

/** A column of the steps at a travel [mm], in between by a straight line. */
function at(result, travel, key) {
  const { travel: travels, [key]: values } = steps(result);
  const i = Math.max(1, travels.findIndex((one) => one >= travel * (1 - 1e-9)));
  return values[i - 1] + ((values[i] - values[i - 1]) * (travel - travels[i - 1])) / (travels[i] - travels[i - 1]);
}

/** Work of the punch up to a travel, the force between two steps by a straight line [J]. */
function work(result, end) {
  const { travel, punch_force: force } = steps(result);
  const last = travel.findIndex((one) => one >= end * (1 - 1e-9));
  return 1e-3 * sum(Array.from(travel.slice(1, last + 1), (now, i) => ((now - travel[i]) * (force[i + 1] + force[i])) / 2));
}

/** Punch force of ideal drawing by Tresca's condition, at the largest force of the cup [N]; its law, blank and wall in mm and MPa. */
function byHand(result) {
  const { punch_force, draw_in } = steps(result);
  const { length: blank, thickness } = result.stages[0];
  const stress = (strain) => 520 * (0.005 + strain) ** 0.22;
  const [wall, rim] = [30 + thickness / 2, blank - draw_in[punch_force.indexOf(peak(result))]];
  const mean = (stress(Math.log(blank / rim)) + stress(Math.log(Math.sqrt(wall ** 2 + blank ** 2 - rim ** 2) / wall))) / 2;
  return 2 * Math.PI * wall * thickness * mean * Math.log(rim / wall);
}

/** Volume of the sheet at the end over that of the blank [–]. */
function volume({ stages: [{ film, end, length, thickness }] }) {
  const count = end.thickness.length;
  const nodes = film.nodes.slice(-4 * (count + 1));
  const ring = (t, e) => {
    const [r, z, next, beside] = [nodes[4 * e], nodes[4 * e + 1], nodes[4 * e + 4], nodes[4 * e + 5]];
    return t * (r + next) * Math.hypot(next - r, beside - z);
  };
  return sum(Array.from(end.thickness, ring)) / (length ** 2 * thickness);
}

function thinnestAt(result) {
  const { thickness, s0 } = lastOf(result).end;
  return s0[thickness.indexOf(Math.min(...thickness))];
}

/** Angle by which a leg turns back when the tools are taken away [°]. */
function turnsBack({ stages }) {
  const [drawn, released] = stages.map(({ film }) => film.nodes.at(-2));
  return (Math.abs(released - drawn) * 180) / Math.PI;
}

const rigid = ({ ways }) => ways[0].iterates.at(-1).cutOff.filter(Boolean).length;
const shrunk = (result) => 1 - steps(result).draw_in.at(-1) / result.stages[0].length;
const iterations = ({ ways }, matrix) => {
  const { converged, velocity } = ways.find((one) => one.matrix === matrix);
  return converged ? String(velocity.length) : "fails";
};

/** Of each lesson, in the order of the texts: what it shows of a result, of the first one, and of a step; and when it is answered. */
const READ = [
  {
    answer: ({ trace }) => `${rigid(trace)} of ${trace.ways[0].iterates[0].cutOff.length} elements nearly rigid`,
    isAnswered: ({ trace }) => 2 * rigid(trace) > trace.ways[0].iterates[0].cutOff.length,
  },
  {
    answer: ({ result }) => `${format(peak(result) / 1e3)} kN, by hand ${format(byHand(result) / 1e3)} kN: ${format(percent(peak(result), byHand(result)), 2)} % above`,
    isAnswered: ({ result }) => peak(result) < 1.1 * byHand(result),
  },
  {
    answer: ({ result }) => `radius × ${format(shrunk(result))}; ${format(lastOf(result).end.thickness.at(-1), 4)} mm, by hand ${format(Math.exp(-lastOf(result).end.strain_hoop.at(-1) / 2), 4)} mm; volume × ${volume(result).toFixed(9)}`,
    isAnswered: ({ result }) => shrunk(result) < 0.8,
  },
  {
    answer: ({ result }) => `${format(Math.min(...lastOf(result).end.thickness), 4)} mm, ${format(thinnestAt(result), 4)} mm from the axis on the flat blank`,
    isAnswered: ({ result, first }) => thinnestAt(result) !== thinnestAt(first),
  },
  {
    answer: ({ result }) => `${sum(steps(result).iterations)} iterations, ${format(peak(result) / 1e3, 4)} kN`,
    isAnswered: ({ result, first }) => sum(steps(result).iterations) > 2 * sum(steps(first).iterations),
  },
  {
    answer: ({ trace }) => `primal-dual ${iterations(trace, "primal_dual")}, Newton ${iterations(trace, "newton")}, secant ${iterations(trace, "secant")}`,
    isAnswered: ({ trace }) => iterations(trace, "newton") === "fails" && iterations(trace, "primal_dual") !== "fails",
  },
  {
    answer: ({ iterate }) => `velocity norm ${iterate.velocity?.toExponential(1) ?? "–"}, residual norm ${format(iterate.residual)}`,
    isAnswered: ({ iterate }) => (iterate.velocity ?? 1) < 2e-3,
  },
  {
    answer: ({ result }) => `sinks in by ${format(100 * Math.max(...steps(result).penetration))} % of the thickness, ${format(peak(result) / 1e3, 4)} kN, ${sum(steps(result).iterations)} iterations`,
    isAnswered: ({ result, first }) => Math.abs(percent(peak(result), peak(first))) > 0.5,
  },
  {
    answer: ({ result }) => `${format(at(result, 0.2, "punch_force"))} N/mm at 0.2 mm, at most ${format(peak(result))} N/mm; each leg turns back by ${format(turnsBack(result), 2)}°`,
    isAnswered: ({ result, first }) => at(result, 0.2, "punch_force") > 2 * at(first, 0.2, "punch_force"),
  },
  {
    answer: ({ result }) => `until 34 mm ${format(work(result, 34), 5)} J; thinnest ${format(at(result, 34, "thinnest"), 4)} mm at 34 mm, ${format(steps(result).thinnest.at(-1))} mm at 38 mm`,
    isAnswered: ({ result, first }) => Math.abs(percent(work(result, 34), work(first, 34))) < 0.2 && steps(result).thinnest.at(-1) > 1.2 * steps(first).thinnest.at(-1),
  },
];

export const LESSONS = TEXTS.map((text, i) => ({ ...text, ...READ[i] }));
