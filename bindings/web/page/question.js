// A question as the solver reads it: a key and its value, another key and its value, each with a zero behind it.

/** Pairs of a question: a list is its key several times, an object a table of keys. */
function pairs(question) {
  return Object.entries(question).flatMap(([key, value]) => {
    if (Array.isArray(value)) return value.map((entry) => [key, entry]);
    if (value !== null && typeof value === "object") return Object.entries(value).map(([inner, entry]) => [`${key}.${inner}`, entry]);
    return [[key, value]];
  });
}

export function asBytes(question) {
  return new TextEncoder().encode(pairs(question).flat().map((part) => `${String(part).replaceAll("\0", "")}\0`).join(""));
}
