// The solver out of the built page, in node.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { unpackedLzma } from "../page/lzma.js";
import { asBytes } from "../page/question.js";
import { joined } from "../page/streams.js";

export const ROOT = join(import.meta.dirname, "..", "..");
export const PAGE = join(ROOT, "web", "dist", "page.html");
/** The command line that the page is held against. */
export const NATIVE = process.env.STAMPFLOW ?? join(ROOT, "target", "release", "stampflow");

export function solver() {
  const [, base64] = readFileSync(PAGE, "utf8").match(/id="solver">([^<]+)</);
  const module = new WebAssembly.Module(joined(unpackedLzma(new Uint8Array(Buffer.from(base64, "base64")))));
  const own = new WebAssembly.Instance(module, {}).exports;
  const bytes = (at, length) => new Uint8Array(own.memory.buffer, at, length);
  return (question) => {
    const asked = asBytes(question);
    bytes(own.input(asked.length), asked.length).set(asked);
    own.call(asked.length);
    const answer = JSON.parse(new TextDecoder().decode(bytes(own.text(), own.text_length())));
    const numbers = new Float64Array(own.memory.buffer, own.numbers(), own.numbers_length()).slice();
    return { answer, array: ({ at, of }) => numbers.subarray(at, at + of) };
  };
}
