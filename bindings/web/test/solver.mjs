// The solver out of the built page, in node.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";

export const ROOT = join(import.meta.dirname, "..", "..", "..");
export const PAGE = join(import.meta.dirname, "..", "dist", "page.html");
/** The command line that the page is held against. */
export const NATIVE = process.env.STAMPFLOW ?? join(ROOT, "target", "release", "stampflow");

export function solver() {
  const [, base64] = readFileSync(PAGE, "utf8").match(/id="solver">([^<]+)</);
  const module = new WebAssembly.Module(gunzipSync(Buffer.from(base64, "base64")));
  const own = new WebAssembly.Instance(module, {}).exports;
  const bytes = (at, length) => new Uint8Array(own.memory.buffer, at, length);
  return (request) => {
    const text = Buffer.from(JSON.stringify(request));
    bytes(own.input(text.length), text.length).set(text);
    own.call(text.length);
    return JSON.parse(new TextDecoder().decode(bytes(own.text(), own.text_length())));
  };
}
