// Panel of a lesson: its question, its one control and its answer. A lesson of lessons.js is
//
//   { title, question, says, statement, template or text, given?, overrides?: ["key=value"], kind: "result" or "step", step?: its number,
//     control: { key, label, from and to or values, value?, unit? }, shows?: "load", "thickness", "limit" or "viscosity",
//     answer({ result, first, trace, iterate }): text, isAnswered(the same) }
//
// with a key of the case file, or "step", "iteration" or "matrix" of the step by step.
import { LESSONS } from "./lessons.js";
import { row } from "./sliders.js";
import { byId, html, render, scientific } from "./dom.js";

/** Controls of the step by step, which come into the panel. */
const OF_STEP = ["step", "iteration", "matrix"];

export class Lessons {
  /** begin(state) puts a case in the place of what is shown, set(key, text, isLast) a value in it; `steps` takes a step of it apart, `view` shows it. */
  constructor({ begin, set, steps, view, plan }) {
    Object.assign(this, { begin, set, steps, view, plan, current: null });
    byId("learn").addEventListener("click", () => (this.current ? this.begin({ lesson: null }) : this.open(0)));
    byId("lesson").addEventListener("change", ({ target }) => this.open(Number(target.value)));
    render(LESSONS.map(({ title }, i) => html`<option value=${i}>${i + 1}. ${title}</option>`), byId("lesson"));
  }

  open(number) {
    const { template = "", given = {}, text = "", overrides = [] } = LESSONS[number];
    return this.begin({ template, given, base: text, name: "lesson.toml", overrides, lesson: number });
  }

  async enter(number) {
    const before = this.current;
    this.current = LESSONS[number] ?? null;
    Object.assign(this, { result: null, first: null, value: undefined });
    byId("lessons").hidden = !this.current;
    byId("learn").setAttribute("aria-pressed", Boolean(this.current));
    document.body.classList.toggle("learning", Boolean(this.current));
    document.body.classList.toggle("by-step", this.current?.kind === "step" && this.current.shows !== "viscosity");
    byId("step-controls").append(...document.querySelectorAll("[data-control]"));
    const { question = "", says = "", kind, shows = "load", step, control } = this.current ?? {};
    byId("beside").append(byId(`figure-${shows === "viscosity" ? "load" : shows}`));
    byId("charts").append(...["load", "thickness", "limit"].map((name) => byId(`figure-${name}`)).filter((figure) => shows !== "viscosity" && figure.id !== `figure-${shows}`));
    byId("colour").value = shows === "viscosity" ? shows : "thickness";
    if (!this.current) return before && this.steps.toggle(false);
    byId("lesson").value = number;
    byId("lesson-question").textContent = question;
    byId("lesson-says").textContent = says;
    byId("lesson-answer").textContent = byId("lesson-statement").textContent = "";
    if (step) byId("step").value = step;
    if (OF_STEP.includes(control.key)) byId("lesson-control").append(document.querySelector(`[data-control="${control.key}"]`));
    this.drawControl();
    await this.steps.toggle(kind === "step");
  }

  /** A slider, or a button for each value; of the step by step the control itself is in the panel. */
  drawControl() {
    const { key, label, from, to, values, unit = "", value: begun } = this.current.control;
    const given = this.plan().sliders.find((slider) => slider.key === key || slider.path === key);
    const now = this.value ?? begun ?? given?.value ?? values?.[0] ?? from;
    const move = (_, value, isLast) => {
      this.value = value;
      this.drawControl();
      this.set(key, unit ? `"${value} ${unit}"` : value, isLast);
    };
    const named = (value) => (typeof value === "number" ? scientific(value) : String(value).replaceAll("_", "-"));
    const button = (value) => html`<button aria-pressed=${value === now} @click=${() => move(key, value, true)}>${named(value)} ${unit}</button> `;
    const chosen = values ? html`<p role="group" aria-label=${label}>${label}: ${values.map(button)}</p>` : row({ key, label, value: begun ?? now, unit, low: from, high: to }, now, false, move);
    render(OF_STEP.includes(key) ? "" : chosen, byId("lesson-slider"));
  }

  show(result) {
    if (!this.current) return;
    this.first ??= result;
    this.result = result;
    this.judge();
  }

  judge() {
    const { trace, iterate } = this.steps;
    if (!this.current || !this.result || (this.current.kind === "step" && !trace)) return;
    if (this.current.kind === "step" && this.travel !== trace.travel) this.view.toTravel((this.travel = trace.travel));
    const seen = { result: this.result, first: this.first, trace, iterate };
    const isAnswered = this.current.isAnswered(seen);
    byId("lesson-answer").textContent = isAnswered ? `✓ answered: ${this.current.answer(seen)}` : `now: ${this.current.answer(seen)}`;
    byId("lesson-statement").textContent = isAnswered ? (this.current.statement ?? "") : "";
    byId("lesson-answer").classList.toggle("answered", isAnswered);
  }
}
