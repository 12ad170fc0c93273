// What the page promises, in a real browser.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, browser, caseText, isSolved, move, opened, pick, set, setAndSettle, settled, slider, stateOf, text, wrongs } from "./browser.mjs";
import { NATIVE, ROOT } from "./solver.mjs";

/** Moves of a slider that may not make the solver's memory grow. */
const MOVES = Number(process.env.MOVES ?? 1000);

const memory = (page) => page.workers()[0].evaluate("solver.memory.buffer.byteLength");

async function everyTemplateAndSlider(page) {
  const names = await page.$$eval("#template option", (all) => all.map(({ value }) => value).filter(Boolean));
  assert.ok(names.length >= 8, `templates: ${names}`);
  for (const name of names) {
    await pick(page, name);
    await isSolved(page, name);
    assert.ok((await page.$$("#section path.sheet")).length > 10, `${name}: no section`);
    const all = await page.$$eval("#controls .slider", (all) => all.map(({ dataset }) => dataset.key));
    // The method's are the same everywhere.
    const keys = all.filter((key) => name === names[0] || !/\./.test(key));
    for (const key of keys) {
      await after(page, () => document.getElementById("reset").click());
      const before = await caseText(page);
      await move(page, key, key === "blank.layers" ? 1.5 : 1.03);
      await isSolved(page, `${name}, ${key}`);
      assert.notEqual(await caseText(page), before, `${name}: the case does not feel ${key}`);
    }
    console.log(`  ${name}: ${keys.length} sliders`);
  }
}

async function errorsStandAtTheirLine(page) {
  await pick(page, "cup");
  const good = await caseText(page);
  const solve = async (written) => {
    await set(page, "#text", written);
    await after(page, () => document.getElementById("solve").click());
  };
  const wrongTexts = [good.replace("friction = 0.08", "friction = 0,08"), good.replace('travel = "', 'travle = "')];
  for (const wrong of wrongTexts) {
    await solve(wrong);
    assert.equal(await stateOf(page), "error");
    const file = join(mkdtempSync(join(tmpdir(), "stampflow-page-")), "cup.toml");
    writeFileSync(file, wrong);
    const { stderr } = spawnSync(NATIVE, ["check", file], { encoding: "utf8" });
    const [, line] = stderr.match(/cup\.toml:(\d+):/);
    const selected = await page.$eval("#text", (area) => area.value.slice(0, area.selectionEnd).split("\n").length);
    assert.equal(String(selected), line, "the line of the error");
    const plain = (message) => message.replaceAll(/[╭╰─│·×]|\S*cup\.toml/g, "").replaceAll(/\s+/g, " ").trim();
    assert.ok(plain(stderr).includes(plain(await text(page, "#error pre"))), "the command line's message");
  }
  assert.ok(await page.$eval("body", (body) => body.classList.contains("stale")), "the last result is grey");
  await solve(good);
  await isSolved(page, "mended");
  assert.ok(await page.$eval("#error", (error) => error.hidden));
}

async function sizesOfATemplateAreGiven(page) {
  await pick(page, "cup");
  const field = '#options [data-option="punch-radius"]';
  await setAndSettle(page, field, "45 mm");
  await isSolved(page, "a punch of 45 mm");
  assert.match(await caseText(page), /Cup Ø 90 mm/);
  await setAndSettle(page, field, "45 parsec");
  assert.equal(await stateOf(page), "error");
  assert.match(await text(page, "#error"), /parsec/);
}

async function thePrintedPageIsAReport(page) {
  await pick(page, "cup");
  await page.emulateMediaType("print");
  const isSeen = (id) => page.$eval(`#${id}`, (part) => part.checkVisibility());
  for (const id of ["answer", "section", "charts", "rows", "printed"]) assert.ok(await isSeen(id), `${id} is not printed`);
  for (const id of ["controls", "text", "print"]) assert.ok(!(await isSeen(id)), `${id} is printed`);
  assert.equal(await text(page, "#printed"), await caseText(page));
  await page.emulateMediaType(null);
}

function drop(name, content) {
  const files = new DataTransfer();
  files.items.add(new File([content], name));
  dispatchEvent(new DragEvent("drop", { dataTransfer: files, cancelable: true }));
}

async function drawingsAreDroppedInAUnit(page) {
  await after(page, drop, "tools.dxf", readFileSync(join(ROOT, "tests/drawings/ezdxf_lines_and_arcs.dxf"), "latin1"));
  await isSolved(page, "drawing");
  assert.match(await caseText(page), /Tools of tools\.dxf/);
  const radius = async () => Number((await caseText(page)).match(/^radius = "([\d.]+)/m)[1]);
  const before = await radius();
  await setAndSettle(page, "#unit", "cm");
  assert.ok(Math.abs((await radius()) / before - 10) < 0.1, "a blank of ten times as many millimetres");
}

async function whatCannotBeOpenedIsExplained(of, page) {
  await page.evaluate(drop, "tools.step", "ISO-10303-21;");
  await page.waitForSelector("#notice:not([hidden])");
  assert.match(await text(page, "#notice"), /tools\.step cannot be opened.*DXF/);
  const other = await opened(of, "#cut-off-in-a-mail");
  assert.match(await text(other, "#notice"), /link is cut/);
  await isSolved(other, "the first example");
  await other.close();
}

/** At 1440 × 900: verdict, numbers, section with its tools' names, load, and nothing too small for a finger. */
async function theFirstScreenHasTheAnswer(page) {
  await pick(page, "cup");
  assert.equal((await page.$$("#answer .numbers b")).length, 6);
  for (const id of ["answer", "section", "load", "travel"]) {
    const bottom = await page.$eval(`#${id}`, (part) => part.getBoundingClientRect().bottom);
    assert.ok(bottom <= 900, `${id} ends at ${bottom} px`);
  }
  assert.deepEqual(await page.$$eval("#section .tool-label", (all) => all.map(({ textContent }) => textContent).sort()), ["die", "holder", "punch"]);
  assert.match(await text(page, "#green summary"), /\d+ checks green/);
  assert.ok(!(await page.$eval("#green table", (table) => table.checkVisibility())), "green rows are folded");
  assert.doesNotMatch(await text(page, "#verdict"), /--\w|`(run|report|check)/);
  const small = await page.$$eval("button, select, summary, input, .button", (all) => all.filter((one) => one.checkVisibility() && one.type !== "file").map((one) => [one.id || one.ariaLabel || one.textContent, one.getBoundingClientRect().height]).filter(([, height]) => height < 24));
  assert.deepEqual(small, [], "targets below 24 px");
  await page.focus(".skip a");
  assert.ok((await page.$eval(".skip a", (link) => link.getBoundingClientRect().left)) >= 0, "a skip link is seen with the keyboard");
}

/** An element picked in a picture has its thickness points; elastic sheets have the return mapping. */
async function pointsOfAnElementAreShown(page) {
  await pick(page, "cup");
  await page.click("#teach");
  await page.waitForSelector("#points tbody tr");
  const [rows, hint] = [await page.$$("#points tbody tr"), await text(page, "#points .hint")];
  assert.ok(rows.length >= 3, "thickness points");
  const box = await (await page.$("#section svg")).boundingBox();
  await page.mouse.click(box.x + 0.25 * box.width, box.y + 0.15 * box.height);
  await page.waitForFunction((old) => document.querySelector("#points .hint").textContent !== old, {}, hint);
  assert.match(await text(page, "#equations"), /μ/);
  await pick(page, "v-bend");
  await page.waitForFunction(() => document.querySelector("#equations").textContent.includes("tr"));
  assert.doesNotMatch(await text(page, "#equations"), /NaN|Infinity/);
  await page.click("#teach");
}

async function linksAreWhatIsShown(of, page) {
  await pick(page, "hat-section");
  await page.click("#keep");
  await move(page, "nose", 0.8);
  await set(page, "#travel", 0.5, "input");
  await page.waitForFunction((old) => location.hash !== old, {}, await page.evaluate(() => location.hash));
  const other = await opened(of, await page.evaluate(() => location.hash));
  const shown = (page) => page.evaluate(() => ["#answer", "#answer-a", "#travel-text"].map((id) => document.querySelector(id).textContent));
  assert.deepEqual(await shown(other), await shown(page));
  assert.equal(await caseText(other), await caseText(page));
  await other.close();
  await page.click("#keep");
}

async function aStepIsSeenIterationByIteration(page) {
  await pick(page, "cup");
  await page.click("#teach");
  await page.waitForSelector("#norms canvas");
  const curves = await page.$$eval("#norms .u-series:not([hidden])", (all) => all.length);
  assert.ok(curves >= 4, "three matrices and the tolerance");
  const largest = () => page.$eval("#residual", (chart) => chart.ariaLabel);
  const before = await largest();
  await set(page, "#iteration", await page.$eval("#iteration", (range) => range.max), "input");
  const force = (label) => Number(label.match(/: ([\d.e+-]+) N/)[1]);
  assert.ok(force(await largest()) < 0.01 * force(before), "the iterations bring the sheet into balance");
  assert.ok((await page.$$("#equations math")).length >= 3);
  await page.click("#teach");
}

/** A lesson's question is open at first, and answered at an end of its slider. */
async function everyLessonIsAnsweredByItsControl(page) {
  await after(page, () => document.getElementById("learn").click());
  const answer = () => text(page, "#lesson-answer");
  for (const { value, label } of await page.$$eval("#lesson option", (all) => all.map(({ value, label }) => ({ value, label })))) {
    if (value !== "0") await setAndSettle(page, "#lesson", value);
    assert.match(await answer(), /^now: /, `${label}: answered before it is asked`);
    const fits = await page.$eval("#lesson-control", (control) => control.getBoundingClientRect().bottom <= 300);
    assert.ok(fits, `${label}: its control is below the panel`);
    const answered = [];
    const values = await page.$$eval("#lesson-control button", (all) => all.length);
    for (let i = 0; i < (values || 4); i++) {
      const range = '#lesson-control input[type="range"]';
      if (values) await after(page, (i) => document.querySelectorAll("#lesson-control button")[i].click(), i);
      else {
        const [low, high, id] = await page.$eval(range, ({ min, max, id }) => [Number(min), Number(max), id]);
        const value = low + [0.02, 0.25, 0.75, 0.98][i] * (high - low);
        if (id === "iteration") await set(page, range, value, "input");
        else await setAndSettle(page, range, value);
      }
      answered.push(await answer());
    }
    assert.ok(answered.some((answer) => answer.startsWith("✓ answered")), `${label}: its control does not answer it: ${answered.join("; ")}`);
    console.log(`  ${label}: ${answered.at(-1)}`);
  }
  await page.click("#learn");
}

async function aLongRunIsEndedByTheNextMove(page) {
  await pick(page, "erichsen");
  let ended = 0;
  const count = () => (ended += 1);
  page.on("workerdestroyed", count);
  // So many elements that the run takes longer than the page waits, on any machine.
  await set(page, "#text", (await caseText(page)).replace(/^elements = \d+/m, "elements = 1500"));
  await page.evaluate(() => document.getElementById("solve").click());
  await page.waitForFunction(() => document.documentElement.dataset.state === "solving");
  await new Promise((rest) => setTimeout(rest, 400));
  await page.evaluate(() => (document.documentElement.dataset.state = "asked"));
  await set(page, slider("friction"), 0.1, "input");
  await settled(page);
  page.off("workerdestroyed", count);
  await isSolved(page, "after the thread was ended");
  assert.equal(ended, 1, "the thread of the run that nobody waits for");
}

async function memoryDoesNotGrow(page) {
  await pick(page, "cup");
  const coarse = async (friction) => {
    await page.evaluate(() => (document.documentElement.dataset.state = "asked"));
    await set(page, slider("friction"), friction, "input");
    await page.waitForFunction(() => document.documentElement.dataset.state === "coarse", { polling: 5 });
  };
  const many = async (count) => {
    for (let i = 0; i < count; i++) await coarse(0.02 + 0.01 * (i % 10));
  };
  await many(20);
  const before = await memory(page);
  await many(MOVES);
  const now = await memory(page);
  assert.ok(now <= before, `${MOVES} moves: from ${before} to ${now} bytes`);
  await settled(page);
  console.log(`  ${MOVES} moves: ${(now / 1e6).toFixed(1)} MB`);
}

const of = await browser();
const page = await opened(of);
const tests = { everyTemplateAndSlider, sizesOfATemplateAreGiven, errorsStandAtTheirLine, drawingsAreDroppedInAUnit, whatCannotBeOpenedIsExplained, theFirstScreenHasTheAnswer, pointsOfAnElementAreShown, thePrintedPageIsAReport, linksAreWhatIsShown, aStepIsSeenIterationByIteration, everyLessonIsAnsweredByItsControl, aLongRunIsEndedByTheNextMove, memoryDoesNotGrow };
try {
  for (const [name, test] of Object.entries(tests).filter(([name]) => !process.argv[2] || name === process.argv[2])) {
    await (test.length === 2 ? test(of, page) : test(page));
    console.log(`passed ${name}`);
  }
  assert.deepEqual(wrongs, []);
  console.log("passed: no error in the console, no request");
} finally {
  await of.close();
}
