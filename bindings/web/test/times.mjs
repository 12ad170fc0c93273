// How long the page takes, over what the command line takes in the same minute.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { spawnSync } from "node:child_process";
import { after, browser, opened } from "./browser.mjs";
import { NATIVE, ROOT, solver } from "./solver.mjs";

const RUNS = 15;

function median(values) {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
}

/** Processor time of the solution itself, of a warm solver [ms]. */
function inThePage(text) {
  const ask = solver();
  const once = () => {
    const before = process.cpuUsage();
    ask({ do: "solve", text, name: "cases/woo.toml" });
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1e3;
  };
  for (let i = 0; i < RUNS; i++) once();
  return Math.min(...Array.from({ length: RUNS }, once));
}

/** Processor time of a run that solves and tells its verdict, as the page does [ms]. */
function native(path) {
  const command = `TIMEFORMAT=%U; time "${NATIVE}" check "${path}" --run --quiet --no-error-bars > /dev/null`;
  const once = () => 1e3 * Number(spawnSync("bash", ["-c", command], { encoding: "utf8" }).stderr.trim());
  return Math.min(...Array.from({ length: RUNS }, once));
}

async function latencies() {
  const of = await browser();
  const page = await opened(of);
  await page.waitForFunction(() => document.documentElement.dataset.warm === "yes", { timeout: 120_000 });
  const moved = (state) => page.evaluate(async (state) => {
    const range = document.querySelector('.slider[data-key="friction"] input[type="range"]');
    range.value = Number(range.max) * (0.2 + 0.5 * Math.random());
    const start = performance.now();
    document.documentElement.dataset.state = "asked";
    range.dispatchEvent(new Event(state === "coarse" ? "input" : "change"));
    while (document.documentElement.dataset.state !== state) await new Promise((next) => setTimeout(next, 0));
    await new Promise(requestAnimationFrame);
    return performance.now() - start;
  }, state);
  const taken = {};
  for (const state of ["coarse", "solved"]) {
    const all = [];
    for (let i = 0; i < RUNS; i++) all.push(await moved(state));
    taken[state] = [Math.min(...all), median(all)];
  }
  await after(page, () => document.getElementById("solve").click());
  await of.close();
  return taken;
}

const path = join(ROOT, "cases/woo_hemispherical.toml");
const [page, own] = [inThePage(readFileSync(path, "utf8")), native(path)];
console.log(`woo_hemispherical: ${page.toFixed(1)} ms in the page's solver, ${own.toFixed(1)} ms native: ${(page / own).toFixed(2)} times`);
const { coarse, solved } = await latencies();
const text = ([least, middle]) => `${least.toFixed(0)} ms at best, ${middle.toFixed(0)} ms in the middle`;
console.log(`slider to picture: coarse ${text(coarse)}; fine ${text(solved)}`);
