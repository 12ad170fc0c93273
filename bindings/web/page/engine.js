// The solver in a worker, which is ended and begun anew when nobody waits for its answer any more, or when it fails.

/** Time that an answer may take after a newer question [ms]; then its worker is ended. */
const PATIENCE = 300;

export class Engine {
  constructor(module, source) {
    Object.assign(this, { module, url: URL.createObjectURL(new Blob([source], { type: "text/javascript" })), waiting: [], running: null, count: 0 });
    this.begin();
  }

  begin() {
    this.worker?.terminate();
    this.worker = Object.assign(new Worker(this.url), {
      onmessage: ({ data }) => this.answered(data),
      onerror: ({ message }) => this.answered({ id: this.running?.id, trap: message }),
    });
    this.worker.postMessage({ module: this.module });
  }

  ask(question, file, isLatest = false) {
    return new Promise((resolve) => {
      this.waiting.push({ id: ++this.count, question, file, resolve, isLatest });
      this.next();
    });
  }

  /** Like `ask`; answers earlier questions of this kind with null, and ends one that takes long. */
  askLatest(question) {
    for (const job of this.waiting.filter(({ isLatest }) => isLatest)) job.resolve(null);
    this.waiting = this.waiting.filter(({ isLatest }) => !isLatest);
    const { running } = this;
    if (running?.isLatest && !running.question.coarse) {
      setTimeout(() => this.running === running && this.finish(null, true), Math.max(0, PATIENCE - (performance.now() - running.since)));
    }
    return this.ask(question, undefined, true);
  }

  next() {
    if (this.running || this.waiting.length === 0) return;
    this.running = Object.assign(this.waiting.shift(), { since: performance.now() });
    const { id, question, file } = this.running;
    this.worker.postMessage({ id, question, file });
  }

  answered({ id, answer, took, trap }) {
    if (this.running?.id !== id) return;
    const failed = { error: { what: trap, help: "", rendered: trap } };
    this.finish(trap === undefined ? Object.assign(answer, { took }) : failed, trap !== undefined);
  }

  finish(answer, isBegunAnew) {
    if (isBegunAnew) this.begin();
    this.running.resolve(answer);
    this.running = null;
    this.next();
  }
}

export async function compiled(base64) {
  const packed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
