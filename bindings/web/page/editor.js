// The case file as text, with the numbers of its lines; an error stands at its line, as the command line prints it.
import { html } from "./dom.js";

export class Editor {
  constructor({ text, lines, error, printed }) {
    Object.assign(this, { text, lines, error, printed });
    text.addEventListener("input", () => this.number());
    text.addEventListener("scroll", () => (lines.scrollTop = text.scrollTop));
  }

  set(value) {
    this.text.value = value;
    this.printed.textContent = value;
    this.number();
  }

  /** The numbers of the lines; the line of an error stands out. */
  number(wrong) {
    const count = this.text.value.split("\n").length;
    const numbers = Array.from({ length: count }, (_, i) => html("div", { className: i + 1 === wrong ? "wrong" : "" }, i + 1));
    this.lines.replaceChildren(...numbers);
    this.lines.scrollTop = this.text.scrollTop;
  }

  clear() {
    this.error.hidden = true;
    this.number();
  }

  /** Shows what is wrong; of an error with a place, its line too. */
  refuse({ what, help, line, column, rendered }) {
    const place = line ? `line ${line}, column ${column}: ` : "";
    this.error.replaceChildren(html("p", {}, `${place}${what}`), html("pre", {}, rendered || help || ""));
    this.error.hidden = false;
    this.number(line);
    if (line) this.text.scrollTop = Math.max(0, (line - 4) * parseFloat(getComputedStyle(this.text).lineHeight));
  }
}
