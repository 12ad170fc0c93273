// The solver in a thread of its own: questions come in, answers go out, one after the other.
let [instance, solver] = [];

function textOf(address, length) {
  return new TextDecoder().decode(new Uint8Array(solver.memory.buffer, address, length));
}

/** Lists of numbers as typed arrays; null stands for a number that is not finite. */
function typed(value) {
  if (Array.isArray(value)) {
    const isNumeric = value.length > 0 && value.every((entry) => entry === null || typeof entry === "number");
    return isNumeric ? Float64Array.from(value, (entry) => entry ?? NaN) : value.map(typed);
  }
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, entry]) => [key, typed(entry)]));
}

function call(question, file) {
  const text = new TextEncoder().encode(JSON.stringify(question));
  const extra = file ?? new Uint8Array(0);
  // Making room may move the memory.
  const address = solver.input(text.length + extra.length);
  const room = new Uint8Array(solver.memory.buffer, address, text.length + extra.length);
  room.set(text);
  room.set(extra, text.length);
  solver.call(text.length);
  return typed(JSON.parse(textOf(solver.text(), solver.text_length())));
}

onmessage = async ({ data }) => {
  if (data.module) return void (instance = WebAssembly.instantiate(data.module, {}));
  solver = (await instance).exports;
  const start = performance.now();
  try {
    const answer = call(data.question, data.file);
    postMessage({ id: data.id, answer, took: performance.now() - start });
  } catch (trap) {
    // A panic leaves its message; this instance is not to be asked again.
    postMessage({ id: data.id, trap: textOf(solver.text(), solver.text_length()) || String(trap) });
  }
};
