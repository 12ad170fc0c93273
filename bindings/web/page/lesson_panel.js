// Panel of a lesson: its question, its control and its answer.
import { LESSONS } from "./lessons.js";
import { byId } from "./dom.js";

export class Lessons {
  /** begin(template) puts a template in the place of what is shown; `steps` takes a step of it apart. */
  constructor(begin, steps) {
    Object.assign(this, { begin, steps, current: null, result: null, first: null });
    byId("learn").addEventListener("click", () => this.toggle());
    byId("lesson").addEventListener("change", () => this.open(Number(byId("lesson").value)));
  }

  toggle() {
    const isShown = byId("lessons").hidden;
    byId("lessons").hidden = !isShown;
    byId("learn").setAttribute("aria-pressed", isShown);
    if (isShown) return this.open(0);
    this.current = null;
    this.highlight();
  }

  async open(number) {
    Object.assign(this, { current: LESSONS[number], result: null, first: null });
    const { title, says, asks, template, isOfStep } = this.current;
    byId("lesson").replaceChildren(...LESSONS.map((lesson, i) => new Option(`${i + 1}. ${lesson.title}`, i, false, i === number)));
    byId("lesson-says").textContent = says;
    byId("lesson-asks").textContent = asks;
    byId("lesson-book").textContent = `More in the book: docs/lessons.md, “${title}”`;
    byId("lesson-answer").textContent = "";
    await this.begin(template);
    await this.steps.toggle(Boolean(isOfStep));
  }

  /** A result: whether it answers the question. */
  show(result) {
    if (!this.current) return;
    this.first ??= result;
    this.result = result;
    this.judge();
  }

  judge() {
    this.highlight();
    const { trace, iterate } = this.steps;
    if (!this.current || !this.result || (this.current.isOfStep && !trace)) return;
    const seen = { result: this.result, first: this.first, trace, iterate };
    const now = this.current.answer(seen);
    byId("lesson-answer").textContent = this.current.isAnswered(seen) ? `✓ answered: ${now}` : `now: ${now}`;
    byId("lesson-answer").classList.toggle("answered", this.current.isAnswered(seen));
  }

  /** The slider that the question is about stands out. */
  highlight() {
    const key = this.current?.slider;
    for (const line of document.querySelectorAll("[data-key]")) line.classList.toggle("asked", line.dataset.key === key);
  }
}
