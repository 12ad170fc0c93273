// All that shows a result: section, charts, verdict, and the cursor that they share.
import { drawLimit, drawLoad, drawThickness } from "./charts.js";
import { drawSection } from "./section.js";
import { drawAnswer, drawNotes, drawRows } from "./verdict.js";
import { byId, format } from "./dom.js";

/** Time that the whole travel is played in [ms]. */
const PLAYED = 3000;

export class View {
  constructor(onCursor) {
    this.result = null;
    this.resultOfA = null;
    /** Share of the pictures that is shown [–], the stage, and the place on the flat blank [mm]. */
    this.at = 1;
    this.stage = 0;
    this.place = NaN;
    this.onCursor = onCursor;
    byId("travel").addEventListener("input", (event) => this.moveTo(event.target.valueAsNumber));
    byId("play").addEventListener("click", () => this.play());
    byId("stage").addEventListener("change", (event) => {
      this.stage = Number(event.target.value);
      this.drawMoving();
      this.onCursor();
    });
    new ResizeObserver(() => this.draw()).observe(byId("main"));
  }

  show(result) {
    this.result = result;
    this.stage = Math.min(this.stage, result.stages.length - 1);
    this.draw();
  }

  moveTo(at) {
    this.at = Math.min(1, Math.max(0, at));
    byId("travel").value = this.at;
    this.drawMoving();
    this.onCursor();
  }

  /** To the picture nearest to a travel [mm]. */
  toTravel(travel) {
    const { film } = this.result.stages[this.stage];
    let best = 0;
    for (let i = 1; i < film.travel.length; i++) if (Math.abs(film.travel[i] - travel) < Math.abs(film.travel[best] - travel)) best = i;
    this.moveTo(best / (film.travel.length - 1));
  }

  play() {
    this.isPlaying = !this.isPlaying;
    byId("play").textContent = this.isPlaying ? "Stop" : "Play";
    if (!this.isPlaying) return;
    const from = performance.now() - PLAYED * (this.at >= 1 ? 0 : this.at);
    const next = (now) => {
      if (!this.isPlaying) return;
      this.moveTo((now - from) / PLAYED);
      if (this.at < 1) return requestAnimationFrame(next);
      this.play();
    };
    requestAnimationFrame(next);
  }

  draw() {
    if (!this.result) return;
    byId("result-title").textContent = this.result.title;
    drawAnswer(byId("answer"), this.result, false);
    byId("answer-a").hidden = !this.resultOfA;
    if (this.resultOfA) drawAnswer(byId("answer-a"), this.resultOfA, true);
    drawRows(byId("rows"), this.result);
    drawNotes(byId("notes"), this.result);
    const stages = this.result.stages.map(({ name }, i) => new Option(`${i + 1} ${name}`, i, false, i === this.stage));
    byId("stage").replaceChildren(...stages);
    byId("stages").hidden = stages.length < 2;
    this.drawMoving();
  }

  /** What the cursor moves. */
  drawMoving() {
    if (!this.result) return;
    const stage = this.result.stages[this.stage];
    const pictureOf = ({ film }) => Math.round(this.at * (film.travel.length - 1));
    const picture = pictureOf(stage);
    const stageOfA = this.resultOfA?.stages[this.stage];
    const other = stageOfA && { stage: stageOfA, picture: pictureOf(stageOfA) };
    const shown = { stage, picture, other, place: this.place, isRound: this.result.isRound };
    const onPlace = (place) => {
      this.place = place;
      this.drawMoving();
    };
    drawSection(byId("section"), shown);
    drawLoad(byId("load"), { ...shown, onTravel: (travel) => this.toTravel(travel) });
    drawThickness(byId("thickness"), { ...shown, onPlace });
    drawLimit(byId("limit"), { ...shown, onPlace });
    byId("travel-text").textContent = byId("travel").ariaValueText = `${format(stage.film.travel[picture])} mm`;
  }
}
