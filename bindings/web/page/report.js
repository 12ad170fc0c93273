// The report: what is shown, as a page of its own that needs nothing else, for a mail or a printer.
import { byId } from "./dom.js";

/** The parts of the page that a reader of the report wants, in their order. */
const PARTS = ["answer", "answer-a", "section", "charts", "rows", "notes"];

function heading(text) {
  return Object.assign(document.createElement("h2"), { textContent: text });
}

/** A copy in which every canvas is a picture. */
function copied(part) {
  const copy = part.cloneNode(true);
  const canvases = part.querySelectorAll("canvas");
  copy.querySelectorAll("canvas").forEach((canvas, i) => {
    const { width, height } = canvases[i].getBoundingClientRect();
    canvas.replaceWith(Object.assign(document.createElement("img"), { src: canvases[i].toDataURL(), width, height }));
  });
  return copy;
}

/** HTML of a result as it is drawn now. */
export function report(title, text) {
  const body = document.createElement("main");
  body.className = "report";
  body.append(Object.assign(document.createElement("h1"), { textContent: title }));
  for (const part of PARTS.map(byId).filter((part) => !part.hidden)) {
    if (part.id === "rows") body.append(heading("Verdict"));
    if (part.id === "notes") body.append(heading("Warnings and notes"));
    body.append(copied(part));
  }
  body.append(heading("Case file"), Object.assign(document.createElement("pre"), { textContent: text }));
  for (const focusable of body.querySelectorAll("[tabindex]")) focusable.removeAttribute("tabindex");
  const page = document.implementation.createHTMLDocument(title);
  page.documentElement.lang = document.documentElement.lang;
  page.documentElement.dataset.theme = "light";
  page.head.prepend(Object.assign(page.createElement("meta"), { name: "viewport", content: "width=device-width" }));
  page.head.prepend(Object.assign(page.createElement("meta"), { httpEquiv: "content-type", content: "text/html; charset=utf-8" }));
  page.head.append(document.querySelector("style").cloneNode(true));
  page.body.append(page.importNode(body, true));
  return `<!doctype html>\n${page.documentElement.outerHTML}\n`;
}
