// The verdict: its sentence with the light, the part's numbers, every row, and what should be known besides.
import { byId, html, render } from "./dom.js";

const SHAPES = { green: "●", amber: "▲", red: "■", grey: "○" };

/** Advice that names a command of the command line, and the words of the page. */
const OURS = [
  ["without `--no-advice` it is solved with less and more friction", "move the slider Friction down and up, and look at what changes"],
  ["without `--no-advice` it is solved with half the hardening", "only the command line does it: download the case and run it there"],
  [/`stampflow search [^`]*`/, "change it, and look at the next result"],
  ["--material NAME", "choose it under Sheet"],
  ["(strain_paths.csv of `run`)", "(chart Forming limit)"],
];
const ours = (text) => OURS.reduce((text, [theirs, own]) => text.replace(theirs, own), text);

const light = (name, text) => html`<span class="lit"><span class="light ${name}" aria-hidden="true">${SHAPES[name]}</span> ${text}</span>`;

export function drawAnswer(host, { verdict }, isA) {
  const numbers = verdict.numbers.map(({ label, text, about }) => html`<div><dt>${label}</dt><dd><b>${text}</b> ${about}</dd></div>`);
  render(html`<p class="sentence">${light(verdict.light, `${isA ? "A: " : ""}${verdict.sentence}`)}</p><dl class="numbers">${numbers}</dl>`, host);
}

function row({ light: name, label, found, limit, source, advice }) {
  return html`<tr><th scope="row">${light(name, label)}</th><td>${found}</td><td title=${source}>${limit}</td><td>${ours(advice)}</td></tr>`;
}

export function drawRows({ verdict }) {
  const of = (lights) => lights.flatMap((name) => verdict.rows.filter((one) => one.light === name));
  const head = ["Finding", "Found", "Limit", "What to do"].map((text) => html`<th scope="col">${text}</th>`);
  const table = (rows) => html`<table><thead><tr>${head}</tr></thead><tbody>${rows.map(row)}</tbody></table>`;
  const [open, green] = [of(["red", "amber", "grey"]), of(["green"])];
  const folded = html`<details id="green"><summary>${light("green", `${green.length} checks green`)}</summary>${table(green)}</details>`;
  render([open.length > 0 ? table(open) : "", folded], byId("rows"));
  render([verdict.end, ...verdict.warnings, ...verdict.notes].filter(Boolean).map((text) => html`<li>${ours(text)}</li>`), byId("notes"));
}
