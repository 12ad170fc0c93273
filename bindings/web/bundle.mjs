// One file of the page: `node bundle.mjs SOLVER.wasm PAGE.html`. The scripts are bundled by esbuild, the solver is gzip in base64.
import { buildSync } from "esbuild";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { gzipSync } from "node:zlib";

const [solver, page] = process.argv.slice(2);
const here = (...parts) => join(import.meta.dirname, ...parts);
const read = (...parts) => readFileSync(here(...parts), "utf8");
const inlined = (text) => text.replaceAll("</script", "<\\/script");
const built = buildSync({ entryPoints: [here("page/app.js")], bundle: true, minify: true, format: "esm", charset: "utf8", write: false });
const scripts = [
  `<script type="text/plain" id="solver">${gzipSync(readFileSync(solver), { level: 9 }).toString("base64")}</script>`,
  `<script type="text/plain" id="worker">${inlined(read("page/worker.js"))}</script>`,
  `<script type="module">${inlined(built.outputFiles[0].text)}</script>`,
];
/** Fonts of the equations that are in the page: Latin and Greek letters, and the sizes of roots and brackets. */
const FONTS = /KaTeX_(Main-Regular|Math-Italic|Size[1-4]-Regular)\.woff2/;
const katex = read("node_modules/katex/dist/katex.min.css").replaceAll(/@font-face\{[^}]*\}/g, (face) => {
  const [file] = face.match(FONTS) ?? [];
  if (!file) return "";
  const letters = readFileSync(here("node_modules/katex/dist/fonts", file)).toString("base64");
  return face.replace(/src:.*\}/, `src:url(data:font/woff2;base64,${letters})}`);
});
const whole = read("page/index.html")
  .replace("<!-- style -->", () => `<style>${read("node_modules/uplot/dist/uPlot.min.css")}\n${katex}\n${read("page/style.css")}</style>`)
  .replace("<!-- scripts -->", () => scripts.join("\n"));
mkdirSync(dirname(page), { recursive: true });
writeFileSync(page, whole);
console.log(`${page}: ${(gzipSync(whole, { level: 9 }).length / 1e3).toFixed(0)} kB gzipped`);
