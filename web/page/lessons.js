// Lessons of one screen: a few sentences, and a question that is answered by moving a slider.
import { byId, word } from "./words.js";

const lastOf = ({ stages }) => stages.at(-1);
const finding = ({ verdict }, key) => verdict.rows.find((one) => one.key === key);
const peak = ({ stages }) => Math.max(...stages[0].steps.punch_force);

/** Place of the thinnest element on the flat blank [mm]. */
function thinnestAt(result) {
  const { thickness, s0 } = lastOf(result).end;
  return s0[thickness.indexOf(Math.min(...thickness))];
}

/** Each begins with a template; the slider that answers it, and when it has. */
export const LESSONS = [
  {
    title: "Friction and the pole",
    says: "A punch stretches a clamped sheet into a dome. Where the sheet lies on the punch, friction holds it, and what is held does not thin any more: the thinnest place wanders from the pole outward.",
    asks: "Bring the thinnest place within 5 mm of the pole.",
    template: "stretch-dome",
    slider: "friction",
    isAnswered: (result) => thinnestAt(result) < 5,
  },
  {
    title: "Localisation",
    says: "Where a place thins, it hardens, and its neighbours take over: n says how much. When hardening no longer outweighs thinning, one place takes all the stretching, and the sheet tears.",
    asks: "Find an n at which the dome tears before its full travel.",
    template: "stretch-dome",
    slider: "n",
    isAnswered: (result) => finding(result, "forming_limit")?.light === "red",
  },
  {
    title: "Draw ratio",
    says: "The wall must pull the whole flange in: the force grows with the blank's diameter over that of the punch, what the wall can bear does not. Their ratio has a limit near 2.",
    asks: "Enlarge the blank until the wall comes near the force that it can bear: bottom tearing is no longer green.",
    template: "cup",
    slider: "blank",
    isAnswered: (result) => finding(result, "bottom_tearing")?.light !== "green",
  },
  {
    title: "Volume constancy",
    says: "The sheet keeps its volume: t = t₀ exp(−ε_s − ε_θ). Towards the throat the circles of the flange become shorter, ε_θ is negative, and the rim grows thicker although it is pulled.",
    asks: "The circles of a smaller blank have less to shrink: find one whose rim stays below 1.20 mm.",
    template: "cup",
    slider: "blank",
    isAnswered: (result) => Math.max(...lastOf(result).end.thickness) < 1.2,
  },
  {
    title: "What friction costs",
    says: "The tools' work goes into plastic flow and into friction, under the holder and round the die's shoulder, where it multiplies what comes from the flange as a rope on a bollard does.",
    asks: "Bring the largest punch force below 35 kN with lubricant alone.",
    template: "cup",
    slider: "friction",
    isAnswered: (result) => peak(result) < 35e3,
  },
  {
    title: "The holder",
    says: "The flange is compressed round its circumference and would fold. The holder prevents it; an axisymmetric run cannot fold and says by a rule how much pressure is wanted.",
    asks: "Let the holder press so little that the wrinkle index turns red.",
    template: "cup",
    slider: "holder_force",
    isAnswered: (result) => finding(result, "wrinkling")?.light === "red",
  },
  {
    title: "Bending and unbending",
    says: "Sheet that runs over a radius is bent and straightened again, and both are paid for: the sharper the radius over the thickness, the larger the force.",
    asks: "Sharpen the punch nose until the force exceeds 28 N per millimetre of width.",
    template: "u-bend",
    slider: "nose",
    isAnswered: (result) => peak(result) > 28,
  },
];

export class Lessons {
  /** begin(template) puts a template in the place of what is shown. */
  constructor(begin) {
    this.begin = begin;
    this.current = null;
    byId("learn").addEventListener("click", () => this.toggle());
    byId("lesson").addEventListener("change", () => this.open(Number(byId("lesson").value)));
  }

  toggle() {
    const panel = byId("lessons");
    panel.hidden = !panel.hidden;
    byId("learn").setAttribute("aria-pressed", !panel.hidden);
    if (panel.hidden) this.current = null;
    else this.open(0);
  }

  open(number) {
    this.current = LESSONS[number];
    this.tell();
    this.begin(this.current.template);
  }

  /** In the language that is set. */
  tell() {
    const titles = LESSONS.map(({ title }, i) => new Option(`${i + 1}. ${word(title)}`, i, false, LESSONS[i] === this.current));
    byId("lesson").replaceChildren(...titles);
    if (!this.current) return;
    byId("lesson-says").textContent = word(this.current.says);
    byId("lesson-asks").textContent = word(this.current.asks);
    this.mark(false);
  }

  /** A result: whether it answers the question. */
  show(result) {
    if (this.current) this.mark(this.current.isAnswered(result));
    const key = this.current?.slider;
    for (const line of document.querySelectorAll("#sliders .slider")) line.classList.toggle("asked", line.dataset.key === key);
  }

  mark(isAnswered) {
    byId("lesson-answer").textContent = isAnswered ? `✓ ${word("answered")}` : "";
  }
}
