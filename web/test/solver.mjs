// The solver out of the built page, in node.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { unpackedLzma } from "../page/lzma.js";

export const ROOT = join(import.meta.dirname, "..", "..");
export const PAGE = join(ROOT, "web", "dist", "page.html");
/** The command line that the page is held against. */
export const NATIVE = process.env.STAMPFLOW ?? join(ROOT, "target", "release", "stampflow");

export function solver() {
  const [, base64] = readFileSync(PAGE, "utf8").match(/id="solver">([^<]+)</);
  const module = new WebAssembly.Module(unpackedLzma(new Uint8Array(Buffer.from(base64, "base64"))));
  const own = new WebAssembly.Instance(module, {}).exports;
  const bytes = (at, length) => new Uint8Array(own.memory.buffer, at, length);
  return (question) => {
    const json = new TextEncoder().encode(JSON.stringify(question));
    bytes(own.input(json.length), json.length).set(json);
    own.call(json.length);
    const answer = JSON.parse(new TextDecoder().decode(bytes(own.text(), own.text_length())));
    const numbers = new Float64Array(own.memory.buffer, own.numbers(), own.numbers_length()).slice();
    return { answer, array: ({ at, of }) => numbers.subarray(at, at + of) };
  };
}
