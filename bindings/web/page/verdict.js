// The verdict: its sentence with the light, the part's numbers, every row, and what should be known besides.

/** Shapes beside the colours. */
const SHAPES = { green: "●", amber: "▲", red: "■", grey: "○" };

function element(name, className, ...children) {
  const made = document.createElement(name);
  if (className) made.className = className;
  made.append(...children);
  return made;
}

function light(name, text) {
  const shape = element("span", `light ${name}`, SHAPES[name]);
  shape.setAttribute("aria-hidden", "true");
  return element("span", "lit", shape, ` ${text}`);
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
  const head = ["Finding", "Found", "Limit", "What to do"].map((text) => {
    const cell = element("th", "", (text));
    cell.scope = "col";
    return cell;
  });
  const body = rows.map(({ light: name, label, found, limit, source, advice }) => {
    const first = element("th", "", light(name, label));
    first.scope = "row";
    const bound = element("td", "", limit);
    bound.title = source;
    return element("tr", "", first, element("td", "", found), bound, element("td", "", advice));
  });
  host.replaceChildren(element("thead", "", element("tr", "", ...head)), element("tbody", "", ...body));
}

export function drawNotes(host, { verdict }) {
  const all = [verdict.end, ...verdict.warnings, ...verdict.notes].filter(Boolean);
  host.replaceChildren(...all.map((text) => element("li", "", text)));
}
