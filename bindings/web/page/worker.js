// The solver in a thread of its own: questions come in, answers go out, one after the other.
let solver;
const decoder = new TextDecoder();

function bytesAt(address, length) {
  return new Uint8Array(solver.memory.buffer, address, length);
}

function answerText() {
  return decoder.decode(bytesAt(solver.text(), solver.text_length()));
}

function call(question, file) {
  const extra = file ?? new Uint8Array(0);
  const room = bytesAt(solver.input(question.length + extra.length), question.length + extra.length);
  room.set(question);
  room.set(extra, question.length);
  solver.call(question.length);
  const numbers = new Float64Array(solver.memory.buffer, solver.numbers(), solver.numbers_length()).slice();
  return { answer: JSON.parse(answerText()), numbers };
}

onmessage = async ({ data }) => {
  if (data.module) {
    solver = (await WebAssembly.instantiate(data.module, {})).exports;
    return;
  }
  const start = performance.now();
  try {
    const { answer, numbers } = call(data.question, data.file);
    postMessage({ id: data.id, answer, numbers, took: performance.now() - start }, [numbers.buffer]);
  } catch (trap) {
    // A panic leaves its words; this instance is not to be asked again.
    postMessage({ id: data.id, trap: answerText() || String(trap) });
  }
};
