// The page in a real browser without a window: opened from the disk, its console and its requests watched.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import puppeteer from "puppeteer-core";
import { PAGE } from "./solver.mjs";

const NAMES = ["chromium", "chromium-browser", "google-chrome"];

function executable() {
  for (const name of NAMES) {
    try {
      return execFileSync("which", [name], { encoding: "utf8" }).trim();
    } catch {
      // The next name.
    }
  }
  throw new Error(`none of ${NAMES.join(", ")} is installed`);
}

export async function browser() {
  return puppeteer.launch({ executablePath: executable(), headless: true, args: ["--no-sandbox", "--disable-gpu"] });
}

/** What the page did that it never may: errors in the console, requests to anywhere. */
export const wrongs = [];

/** A page that has come to its first result, or to what the link says. */
export async function opened(of, hash = "") {
  const page = await of.newPage();
  page.on("console", (message) => message.type() === "error" && wrongs.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => wrongs.push(`error: ${error.message}`));
  page.on("request", (request) => !/^(file|blob|data):/.test(request.url()) && wrongs.push(`request: ${request.url()}`));
  await page.goto(`file://${PAGE}${hash}`);
  await settled(page);
  return page;
}

export const stateOf = (page) => page.evaluate(() => document.documentElement.dataset.state);

/** Until nothing is solved any more. */
export async function settled(page) {
  await page.waitForFunction(() => ["solved", "error"].includes(document.documentElement.dataset.state), { timeout: 120_000, polling: 20 });
}

/** What is done, and then until it has led to a fine result. */
export async function after(page, what, ...of) {
  await page.evaluate(() => (document.documentElement.dataset.state = "asked"));
  await page.evaluate(what, ...of);
  await settled(page);
}

/** Moves a slider to a share of what it stands at, as a pointer would. */
export async function move(page, key, times, isLast = true) {
  const moved = (key, times, isLast) => {
    const range = document.querySelector(`.slider[data-key="${key}"] input[type="range"]`);
    range.value = range.valueAsNumber * times;
    range.dispatchEvent(new Event("input", { bubbles: true }));
    if (isLast) range.dispatchEvent(new Event("change", { bubbles: true }));
  };
  if (isLast) await after(page, moved, key, times, true);
  else await page.evaluate(moved, key, times, false);
}

export const text = (page, selector) => page.$eval(selector, (element) => element.textContent);
export const caseText = (page) => page.$eval("#text", (element) => element.value);

export async function pick(page, name) {
  await after(page, (name) => {
    const list = document.getElementById("template");
    list.value = name;
    list.dispatchEvent(new Event("change", { bubbles: true }));
  }, name);
}

export async function isSolved(page, what) {
  assert.equal(await stateOf(page), "solved", `${what}: ${await text(page, "#status")}`);
}
