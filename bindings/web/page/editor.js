// The case file as text; an error is shown as the command line prints it, and its line is selected.
import { byId, html, nothing, render } from "./dom.js";

const text = byId("text");

export function setText(value) {
  text.value = value;
  byId("printed").textContent = value;
}

export function showError(error) {
  byId("error").hidden = !error;
  const { what, help, line, column, rendered } = error ?? {};
  render(error ? html`<p>${line ? `line ${line}, column ${column}: ` : nothing}${what}</p><pre>${rendered || help}</pre>` : nothing, byId("error"));
  if (!line) return;
  const before = text.value.split("\n").slice(0, line);
  const end = before.join("\n").length;
  text.setSelectionRange(end - before.at(-1).length, end);
  text.scrollTop = Math.max(0, (line - 4) * parseFloat(getComputedStyle(text).lineHeight));
}
