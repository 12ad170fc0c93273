// The page in a real browser without a window: opened from the disk, its console and its requests watched.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import puppeteer from "puppeteer-core";
import { PAGE } from "./solver.mjs";

export async function browser() {
  const installed = execFileSync("sh", ["-c", "command -v chromium || command -v chromium-browser || command -v google-chrome"], { encoding: "utf8" });
  return puppeteer.launch({ defaultViewport: { width: 1440, height: 900 }, executablePath: installed.trim(), headless: true, args: ["--no-sandbox", "--disable-gpu"] });
}

/** What the page did that it never may: errors in the console, requests to anywhere. */
export const wrongs = [];

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

export async function settled(page) {
  await page.waitForFunction(() => ["solved", "error"].includes(document.documentElement.dataset.state), { timeout: 120_000, polling: 20 });
}

export async function after(page, what, ...of) {
  await page.evaluate(() => (document.documentElement.dataset.state = "asked"));
  await page.evaluate(what, ...of);
  await settled(page);
}

export function set(page, selector, value, ...events) {
  return page.$eval(selector, (control, value, events) => {
    control.value = value;
    for (const event of events) control.dispatchEvent(new Event(event, { bubbles: true }));
  }, value, events);
}

export async function setAndSettle(page, selector, value) {
  await page.evaluate(() => (document.documentElement.dataset.state = "asked"));
  await set(page, selector, value, "input", "change");
  await settled(page);
}

export const slider = (key) => `.slider[data-key="${key}"] input[type="range"]`;

export async function move(page, key, share) {
  await setAndSettle(page, slider(key), share * (await page.$eval(slider(key), (range) => range.valueAsNumber)));
}

export const text = (page, selector) => page.$eval(selector, (element) => element.textContent);
export const caseText = (page) => page.$eval("#text", (element) => element.value);

export const pick = (page, template) => setAndSettle(page, "#template", template);

export async function isSolved(page, what) {
  assert.equal(await stateOf(page), "solved", `${what}: ${await text(page, "#status")}`);
}
