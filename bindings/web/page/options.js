// What a template may be given beside what it picks by its rules: one field for each, empty where the rule holds.
import { byId, html, render } from "./dom.js";

/** onGive(given) after every field that is left with another value. */
export function drawOptions(template, given, onGive) {
  byId("options").hidden = !template;
  const give = (key, value) => onGive(Object.fromEntries(Object.entries({ ...given, [key]: value.trim() }).filter(([, text]) => text)));
  const fields = (template?.options ?? []).map(({ key, default: picked, about }) => html`<label>${key.replaceAll("-", " ")}
    <input type="text" data-option=${key} placeholder=${picked} .value=${given[key] ?? ""} @change=${({ target }) => give(key, target.value)}>
    <small>${about}</small></label>`);
  render(fields, byId("options-fields"));
}
