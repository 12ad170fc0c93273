// The verdict: its sentence with the light, the part's numbers, every row, and what should be known besides.
import { html } from "./dom.js";

/** Shapes beside the colours. */
const SHAPES = { green: "●", amber: "▲", red: "■", grey: "○" };

const element = (name, className, ...children) => html(name, { className }, ...children);

function light(name, text) {
  return element("span", "lit", html("span", { className: `light ${name}`, ariaHidden: "true" }, SHAPES[name]), ` ${text}`);
}

export function drawAnswer(host, { verdict }, isA) {
  const sentence = element("p", "sentence", light(verdict.light, `${isA ? "A: " : ""}${verdict.sentence}`));
  const numbers = verdict.numbers.map(({ label, text, about }) =>
    element("div", "", element("dt", "", label), element("dd", "", element("b", "", text), " ", about)),
  );
  host.replaceChildren(sentence, element("dl", "numbers", ...numbers));
}

export function drawRows(host, { verdict }) {
  const order = ["red", "amber", "grey", "green"];
  const rows = [...verdict.rows].sort((a, b) => order.indexOf(a.light) - order.indexOf(b.light));
  const head = ["Finding", "Found", "Limit", "What to do"].map((text) => html("th", { scope: "col" }, text));
  const body = rows.map(({ light: name, label, found, limit, source, advice }) => {
    const bound = html("td", { title: source }, limit);
    return element("tr", "", html("th", { scope: "row" }, light(name, label)), element("td", "", found), bound, element("td", "", advice));
  });
  host.replaceChildren(element("thead", "", element("tr", "", ...head)), element("tbody", "", ...body));
}

export function drawNotes(host, { verdict }) {
  const all = [verdict.end, ...verdict.warnings, ...verdict.notes].filter(Boolean);
  host.replaceChildren(...all.map((text) => element("li", "", text)));
}
