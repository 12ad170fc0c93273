// The solver's thread: started, asked, and ended and begun anew where an answer is no longer wanted or never comes.

/** How long an answer that nobody waits for any more may still take [ms]; then its thread is ended. */
const PATIENCE = 300;

export class Engine {
  /** @param module the compiled solver  @param source text of the worker */
  constructor(module, source) {
    this.module = module;
    this.url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.waiting = [];
    this.running = null;
    this.count = 0;
    this.restarts = -1;
    this.begin();
  }

  begin() {
    this.restarts += 1;
    this.worker = new Worker(this.url);
    this.worker.postMessage({ module: this.module });
    this.worker.onmessage = ({ data }) => this.answered(data);
    this.worker.onerror = (event) => this.answered({ id: this.running?.id, trap: event.message });
  }

  /** Ends the thread in the midst of whatever it does; its question is answered with null. */
  restart() {
    this.worker.terminate();
    const { running } = this;
    this.running = null;
    this.begin();
    running?.resolve(null);
    this.next();
  }

  /** Answers one after the other. */
  ask(question, file) {
    return new Promise((resolve) => {
      this.waiting.push({ id: ++this.count, question, file, resolve });
      this.next();
    });
  }

  /** As ask; what was asked this way before and is not answered yet is dropped, and answered with null. */
  askLatest(question) {
    for (const job of this.waiting.filter((job) => job.dropped)) job.resolve(null);
    this.waiting = this.waiting.filter((job) => !job.dropped);
    const { running } = this;
    if (running?.dropped && !running.question.coarse) {
      setTimeout(() => this.running === running && this.restart(), Math.max(0, PATIENCE - (performance.now() - running.since)));
    }
    const answer = this.ask(question);
    const job = this.waiting.at(-1) ?? this.running;
    job.dropped = true;
    return answer;
  }

  next() {
    if (this.running || this.waiting.length === 0) return;
    this.running = this.waiting.shift();
    this.running.since = performance.now();
    const { id, question, file } = this.running;
    this.worker.postMessage({ id, question, file });
  }

  answered({ id, answer, took, trap }) {
    const { running } = this;
    if (!running || running.id !== id) return;
    this.running = null;
    if (trap === undefined) {
      running.resolve(Object.assign(answer, { took }));
    } else {
      this.worker.terminate();
      this.begin();
      running.resolve({ error: { what: trap, help: "", rendered: trap } });
    }
    this.next();
  }
}

/** The solver out of the page: gzip in base64. */
export async function compiled(base64) {
  const packed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
