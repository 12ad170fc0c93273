// What a template may be given beside what it picks by its rules: one field for each, empty where the rule holds.
import { byId } from "./dom.js";

/** onGive(given) after every field that is left with another value. */
export function drawOptions(template, given, onGive) {
  const panel = byId("options");
  panel.hidden = !template;
  const fields = (template?.options ?? []).map(({ key, default: picked, about }) => {
    const label = document.createElement("label");
    const field = Object.assign(document.createElement("input"), { type: "text", placeholder: picked, value: given[key] ?? "" });
    const explained = document.createElement("small");
    explained.textContent = about;
    field.dataset.option = key;
    field.addEventListener("change", () => {
      const { [key]: _, ...others } = given;
      const value = field.value.trim();
      onGive(value ? { ...others, [key]: value } : others);
    });
    label.append(key.replaceAll("-", " "), field, explained);
    return label;
  });
  panel.querySelector("div").replaceChildren(...fields);
}
