// One file of the page: `node bundle.mjs SOLVER.wasm PAGE.html`. Modules are written one after the other into one script, which
// is why each name at their top may be there once; the solver is streams (`page/streams.js`) in LZMA in base64.
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { gzipSync } from "node:zlib";
import { split } from "./split.mjs";

const [solver, page] = process.argv.slice(2);
const here = (name) => join(import.meta.dirname, "page", name);
const read = (name) => readFileSync(here(name), "utf8");

const IMPORT = /^import \{[^}]*\} from "\.\/([^"]+)";\n/gm;
const COMMENT = /^ *(?:\/\/.*|\/\*\*.*\*\/)\n/gm;
const TOP = /^(?:async )?(?:function|class|const|let) (?:\[([\w, ]+)\]|(\w+))/gm;

/** A module behind all that it imports, each once. */
function modules(name, seen = new Set()) {
  if (seen.has(name)) return "";
  seen.add(name);
  const text = read(name);
  const before = [...text.matchAll(IMPORT)].map(([, other]) => modules(other, seen)).join("");
  return before + text.replaceAll(IMPORT, "").replaceAll(COMMENT, "").replaceAll(/^export /gm, "");
}

/** Names that several modules have at their top would hide one another. */
function checked(script) {
  const names = [...script.matchAll(TOP)].flatMap(([, several, one]) => several?.split(", ") ?? [one]);
  const twice = names.filter((name, i) => names.indexOf(name) !== i);
  if (twice.length > 0) throw new Error(`several modules have ${twice.join(", ")}`);
  return script;
}

/** Text that a script may hold. */
function inlined(text) {
  return text.replaceAll("</script", "<\\/script");
}

/** A module without its custom sections, which name its functions. */
function stripped(module) {
  const kept = [module.subarray(0, 8)];
  for (let at = 8; at < module.length; ) {
    const [begin, id] = [at, module[at++]];
    let size = 0;
    for (let shift = 0, more = true; more; shift += 7) {
      size += (module[at] & 0x7f) * 2 ** shift;
      more = module[at++] >= 0x80;
    }
    at += size;
    if (id !== 0) kept.push(module.subarray(begin, at));
  }
  return Buffer.concat(kept);
}

/** The table of German is in the solver whole; of texts that it never tells the lines are blanked, which packs to nothing. */
function withoutForeign(module) {
  const table = readFileSync(join(import.meta.dirname, "..", "src", "message", "de.toml"));
  const at = module.indexOf(table);
  if (at < 0) throw new Error("the solver does not hold src/message/de.toml");
  const others = Buffer.concat([module.subarray(0, at), module.subarray(at + table.length)]).toString("latin1");
  const isTold = (line) => {
    const [, key] = line.match(/^"((?:[^"\\]|\\.)*)" = ".*"$/) ?? [];
    return key === undefined || others.includes(key.replaceAll(/\\(.)/g, "$1"));
  };
  const blanked = (line) => (isTold(line) && !line.startsWith("#") ? line : " ".repeat(line.length));
  const kept = Buffer.from(module);
  kept.write(table.toString("latin1").split("\n").map(blanked).join("\n"), at, "latin1");
  return kept;
}

/** LZMA with its length in the header, as the page reads it. */
function packed(streams) {
  const options = ["--format=lzma", "--lzma1=preset=9e,lc=2,pb=0,nice=273", "-c"];
  const bytes = execFileSync("xz", options, { input: streams, maxBuffer: 1e8 });
  bytes.writeBigUInt64LE(BigInt(streams.length), 5);
  return bytes;
}

const script = checked(modules("app.js"));
const module = withoutForeign(stripped(readFileSync(solver)));
const scripts = [
  `<script type="text/plain" id="solver">${packed(split(module)).toString("base64")}</script>`,
  `<script type="text/plain" id="worker">${inlined(read("worker.js"))}</script>`,
  `<script type="module">\n${inlined(script)}</script>`,
];
const whole = read("index.html")
  .replace("<!-- style -->", () => `<style>\n${read("style.css")}</style>`)
  .replace("<!-- scripts -->", () => scripts.join("\n"));
mkdirSync(dirname(page), { recursive: true });
// The program that has it with it is not built anew for the same page.
if (!existsSync(page) || readFileSync(page, "utf8") !== whole) writeFileSync(page, whole);
console.log(`${page}: ${(gzipSync(whole, { level: 9 }).length / 1e3).toFixed(0)} kB gzipped, ${(whole.length / 1e3).toFixed(0)} kB`);
