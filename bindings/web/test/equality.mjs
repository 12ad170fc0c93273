// Every case of cases/ in the page's solver and by the command line: the same numbers.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { NATIVE, ROOT, solver } from "./solver.mjs";

/** What both may differ by, of the largest number of a column [–]: 1e-9, and half of the ninth digit of the tables. */
const SAME = 6e-9;
/**
 * Stages that come to the same end in another number of steps, because the last digits of exp and ln, which are the system's
 * there and those of Rust's own library here, decide whether a step is halved: they are compared by their end.
 */
const OTHER_STEPS = ["brite_four_steps withdraw"];

const TABLES = { "load_travel.csv": "steps", "profile.csv": "end" };

function columns(text, keys) {
  const [head, ...rows] = text.trim().split("\n").map((line) => line.split(","));
  const at = (key) => head.findIndex((header) => header === key || header.replace(/_(mm|N|N_per_mm|MPa|s)$/, "") === key);
  return Object.fromEntries(keys.filter((key) => at(key) >= 0).map((key) => [key, rows.map((row) => Number(row[at(key)]))]));
}

const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

function files(folder) {
  const all = readdirSync(join(ROOT, folder)).filter((name) => /\.(csv|toml)$/.test(name));
  return Object.fromEntries(all.map((name) => [`${folder}/${name}`, readFileSync(join(ROOT, folder, name), "utf8")]));
}

/** The largest difference of a case, and its place. */
function compared(name, answer, folder) {
  let worst = [0, ""];
  /** Sizes of the stage before: what a release leaves of stresses is the difference of numbers of that size. */
  let sizes = {};
  answer.stages.forEach((stage, i) => {
    const own = answer.stages.length > 1 ? join(folder, `${i + 1}-${stage.name}`) : folder;
    for (const [file, key] of Object.entries(TABLES)) {
      if (key === "steps" && OTHER_STEPS.includes(`${name} ${stage.name}`)) continue;
      for (const [column, all] of Object.entries(columns(readFileSync(join(own, file), "utf8"), Object.keys(stage[key])))) {
        const values = stage[key][column];
        // The profile has a row for each element of every kept frame; the page has the last.
        const native = key === "end" ? all.slice(all.length - values.length) : all;
        const size = Math.max(1e-300, largest(native), stage.isRelease ? (sizes[file + column] ?? 0) : 0);
        sizes[file + column] = largest(native);
        const off = native.length === values.length ? largest(native.map((value, row) => value - values[row])) / size : Infinity;
        if (!(off <= worst[0])) worst = [off, `${stage.name} ${file} ${column}: ${values.length} and ${native.length} rows`];
      }
    }
  });
  return worst;
}

const ask = solver();
const out = mkdtempSync(join(tmpdir(), "stampflow-page-"));
const beside = { ...files("cases"), ...files("reference_data") };
let failed = 0;
try {
  for (const name of readdirSync(join(ROOT, "cases")).filter((file) => file.endsWith(".toml"))) {
    const path = `cases/${name}`;
    const folder = join(out, basename(name, ".toml"));
    try {
      execFileSync(NATIVE, ["run", path, "--out", folder, "--quiet"], { cwd: ROOT, stdio: "ignore" });
    } catch (ended) {
      if (ended.status !== 3) throw ended;
    }
    const answer = ask({ do: "solve", text: readFileSync(join(ROOT, path), "utf8"), name: path, files: beside });
    const [off, where] = answer.error ? [Infinity, answer.error.what] : compared(basename(name, ".toml"), answer, folder);
    const isSame = off <= SAME;
    failed += !isSame;
    console.log(`${isSame ? "same  " : "DIFFERS"} ${name}: ${off.toExponential(1)} ${where}`);
  }
} finally {
  rmSync(out, { recursive: true });
}
if (failed > 0) {
  console.log(`${failed} cases differ by more than ${SAME}`);
  process.exit(1);
}
