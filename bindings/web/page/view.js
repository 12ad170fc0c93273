// All that shows a result: section, charts, verdict, and the cursor that they share.
import { drawLimit, drawLoad, drawThickness } from "./charts.js";
import { drawSection, nearest } from "./section.js";
import { drawAnswer, drawRows } from "./verdict.js";
import { byId, format, html, render } from "./dom.js";

/** Time of a picture while the travel is played [ms]. */
const PICTURE = 75;

export class View {
  /** onCursor() hears of every move of the cursor, onElement(e) of every element that is picked. */
  constructor(onCursor, onElement) {
    Object.assign(this, { onCursor, onElement, result: null, resultOfA: null });
    /** Share of the pictures that is shown [–], the stage, and the place on the flat blank [mm]. */
    Object.assign(this, { at: 1, stage: 0, place: NaN });
    byId("travel").addEventListener("input", ({ target }) => this.moveTo(target.valueAsNumber));
    byId("play").addEventListener("click", () => this.play());
    byId("colour").addEventListener("change", () => this.drawMoving());
    byId("stage").addEventListener("change", ({ target }) => this.set({ stage: Number(target.value) }));
    new ResizeObserver(() => this.draw()).observe(byId("main"));
  }

  get chosen() {
    return nearest(this.result.stages[this.stage].end.s0, this.place);
  }

  show(result) {
    this.result = result;
    this.stage = Math.min(this.stage, result.stages.length - 1);
    this.draw();
  }

  set(cursor) {
    Object.assign(this, cursor);
    this.drawMoving();
    this.onCursor();
  }

  moveTo(at) {
    byId("travel").value = at;
    this.set({ at: Math.min(1, Math.max(0, at)) });
  }

  pick(e) {
    this.set({ place: this.result.stages[this.stage].end.s0[e] });
    this.onElement(e);
  }

  toTravel(travel) {
    const all = this.result.stages[this.stage].film.travel;
    this.moveTo(nearest(all, travel) / (all.length - 1));
  }

  play() {
    clearInterval(this.playing);
    const isBegun = byId("play").textContent === "Play";
    byId("play").textContent = isBegun ? "Stop" : "Play";
    if (!isBegun) return;
    if (this.at >= 1) this.moveTo(0);
    const step = 1 / (this.result.stages[this.stage].film.travel.length - 1);
    this.playing = setInterval(() => (this.at >= 1 ? this.play() : this.moveTo(this.at + step)), PICTURE);
  }

  draw() {
    if (!this.result) return;
    byId("result-title").textContent = this.result.title;
    drawAnswer(byId("answer"), this.result, false);
    byId("answer-a").hidden = !this.resultOfA;
    if (this.resultOfA) drawAnswer(byId("answer-a"), this.resultOfA, true);
    drawRows(this.result);
    render(this.result.stages.map(({ name }, i) => html`<option value=${i} .selected=${i === this.stage}>${i + 1} ${name}</option>`), byId("stage"));
    byId("stages").hidden = this.result.stages.length < 2;
    this.drawMoving();
  }

  drawMoving() {
    if (!this.result) return;
    const stage = this.result.stages[this.stage];
    const pictureOf = ({ film }) => Math.round(this.at * (film.travel.length - 1));
    const picture = pictureOf(stage);
    const stageOfA = this.resultOfA?.stages[this.stage];
    const other = stageOfA && { stage: stageOfA, picture: pictureOf(stageOfA) };
    const shown = { stage, picture, other, chosen: this.chosen, isRound: this.result.isRound };
    const onPlace = (place) => this.pick(nearest(stage.end.s0, place));
    const most = Math.max(200, (document.body.classList.contains("learning") ? 0.3 : 0.45) * innerHeight);
    drawSection(byId("section"), { ...shown, most, isViscosity: byId("colour").value === "viscosity", onElement: (e) => this.pick(e) });
    drawLoad(byId("load"), { ...shown, onTravel: (travel) => this.toTravel(travel) });
    drawThickness(byId("thickness"), { ...shown, onPlace });
    drawLimit(byId("limit"), { ...shown, onPlace });
    byId("travel-text").textContent = byId("travel").ariaValueText = `${format(stage.film.travel[picture])} mm`;
  }
}
