// Every broken case of tests/bad_cases in the page's solver: the message that the command line gives.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT, solver } from "./solver.mjs";

const FOLDER = "tests/bad_cases";
const END = "---\n";
/** What differs for a reason: addresses have half the bytes there, so that a run fills less memory. */
const OWN = ["paths_fill_the_memory.txt"];
/** Words alone: the command line breaks lines where a paragraph looks best. */
const words = (told) => told.replaceAll(/[\s│]+/g, " ");
const read = (path) => readFileSync(join(ROOT, path), "utf8");

/** The base with its changes, as tests/suite/bad_cases.rs makes them. */
function patched(base, patch) {
  const rest = base.split("\n").slice(0, -1);
  const text = [];
  for (const change of patch.split("\n").slice(0, -1)) {
    const [kind, line] = [change.slice(0, 2).trimEnd(), change.slice(2)];
    if (kind !== "+") while (rest.length > 0 && rest[0] !== line) text.push(rest.shift());
    if (kind === "+") text.push(line);
    else if (kind === "-") rest.shift();
    else text.push(rest.shift());
  }
  return [...text, ...rest, ""].join("\n");
}

const ask = solver();
const base = read(`${FOLDER}/base/cup.toml`);
const beside = readdirSync(join(ROOT, FOLDER)).filter((name) => /\.(csv|toml)$/.test(name));
const files = Object.fromEntries(beside.map((name) => [`${FOLDER}/${name}`, read(`${FOLDER}/${name}`)]));
const names = readdirSync(join(ROOT, FOLDER)).filter((name) => name.endsWith(".txt"));
const wrong = names.filter((file) => {
  const [stored, name] = [read(`${FOLDER}/${file}`), `${FOLDER}/${file.replace(/txt$/, "toml")}`];
  const at = existsSync(join(ROOT, name)) ? 0 : stored.indexOf(END) + END.length;
  const text = at === 0 ? read(name) : patched(base, stored.slice(0, at - END.length));
  const { answer } = ask({ do: "solve", text, name, files });
  const told = answer.error?.rendered ?? "this case is accepted\n";
  if (words(told) === words(stored.slice(at)) || OWN.includes(file)) return false;
  console.log(`${file}\nin the page:\n${told}by the command line:\n${stored.slice(at)}`);
  return true;
});
console.log(`${names.length - wrong.length} of ${names.length} broken cases are told as by the command line`);
if (wrong.length > 0 || names.length < 200) process.exit(1);
