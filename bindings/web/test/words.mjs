// Every word of the page is told in German, and no German is left over.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { LESSONS } from "../page/lessons.js";

const folder = join(import.meta.dirname, "..", "page");
const sources = Object.fromEntries(readdirSync(folder).map((name) => [name, readFileSync(join(folder, name), "utf8")]));
const { "words.js": table, ...others } = sources;
const all = Object.values(others).join("\n");
const german = [...table.matchAll(/^ {2}"((?:[^"\\]|\\.)*)":/gm)].map(([, key]) => key);
const called = [...all.matchAll(/\bword\("([^"]*)"\)/g), ...all.matchAll(/data-(?:word|label)="([^"]*)"/g)].map(([, text]) => text);
const lessons = LESSONS.flatMap(({ title, says, asks }) => [title, says, asks]);
/** The texts in quotes of all modules: what tables of labels hold. */
const quoted = new Set([...all.matchAll(/"([^"\n]+)"/g)].map(([, text]) => text));

assert.deepEqual([...called, ...lessons].filter((text) => !german.includes(text)), [], "without German");
assert.deepEqual(german.filter((key) => !quoted.has(key) && !called.includes(key)), [], "German of nothing");
console.log(`${german.length} words in German`);
