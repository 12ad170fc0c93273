// The way into the page's streams, as `page/streams.js` goes back.
import { LOCALS, STREAMS, grow, joined, number, put, toFront, walk } from "./page/streams.js";

/** From the module to its streams. */
class Splitter {
  constructor(module) {
    Object.assign(this, { module, at: 0, streams: Array.from({ length: STREAMS }, () => []) });
    this.taken = { byte: () => this.module[this.at++] };
  }

  atEnd() {
    return this.at === this.module.length;
  }

  byte(stream) {
    const byte = this.module[this.at++];
    this.streams[stream].push(byte);
    return byte;
  }

  /** Its size is not kept: it follows. */
  sized(part) {
    const size = number(this.taken);
    const start = this.at;
    part();
    if (this.at - start !== size) throw new Error(`the module is not understood: ${this.at - start} bytes of ${size} at ${start}`);
  }

  local(recent) {
    const index = number(this.taken);
    grow(recent, index);
    const at = recent.indexOf(index);
    put(at, (byte) => this.streams[LOCALS].push(byte));
    toFront(recent, at);
  }
}

/** The streams of a module: its length, theirs, and they. */
export function split(module) {
  const splitter = new Splitter(module);
  walk(splitter);
  const streams = splitter.streams.map((stream) => Buffer.from(stream));
  const lengths = Uint32Array.of(module.length, ...streams.map((stream) => stream.length));
  const all = Buffer.concat([Buffer.from(lengths.buffer), ...streams]);
  if (!module.equals(joined(Uint8Array.from(all)))) throw new Error("the streams do not give the module back");
  return all;
}
