// What a template may be given beside what it picks by its rules: one field for each, empty where the rule holds.
import { byId, html } from "./dom.js";

/** onGive(given) after every field that is left with another value. */
export function drawOptions(template, given, onGive) {
  const panel = byId("options");
  panel.hidden = !template;
  const fields = (template?.options ?? []).map(({ key, default: picked, about }) => {
    const field = html("input", { type: "text", placeholder: picked, value: given[key] ?? "" });
    field.dataset.option = key;
    field.addEventListener("change", () => {
      const { [key]: _, ...others } = given;
      const value = field.value.trim();
      onGive(value ? { ...others, [key]: value } : others);
    });
    return html("label", {}, key.replaceAll("-", " "), field, html("small", {}, about));
  });
  panel.querySelector("div").replaceChildren(...fields);
}
