// The page: what is chosen, what is asked of the solver, what is shown.
import { csv, save } from "./downloads.js";
import { setText, showError } from "./editor.js";
import { compiled, Engine } from "./engine.js";
import { Lessons } from "./lesson_panel.js";
import { drawOptions } from "./options.js";
import { PATHS, planOf } from "./plan.js";
import { drawSliders } from "./sliders.js";
import { begun, overrides, packed, unpacked } from "./state.js";
import { Steps } from "./steps.js";
import { View } from "./view.js";
import { byId, format, html, render } from "./dom.js";

/** After this long without a move a coarse result is followed by a fine one [ms]. */
const REST = 250;
/** Runs that let the browser optimise the solver while the page is read. */
const WARMING = 6;

let state = begun();
let plan = { sliders: [], writes: [] };
let templates = [];
let engine, view, steps, lessons, resting;
/** Questions so far: an answer to an older one is shown, and no more is made of it. */
let asked = 0;
let remembering;

function question(coarse) {
  const { base, name, files } = state;
  return { do: "solve", text: base, name, files, overrides: overrides(state, plan), coarse };
}

function status(text, kind) {
  byId("status").textContent = text;
  document.documentElement.dataset.state = kind;
}

function notice(text = "") {
  byId("notice").textContent = text;
  byId("notice").hidden = !text;
}

/** Solves what is chosen; what was shown stays, in grey, until there is a better. */
async function solve(coarse) {
  clearTimeout(resting);
  const mine = ++asked;
  status("solving …", "solving");
  const result = await engine.askLatest(question(coarse));
  if (!result) return;
  if (result.error) return refuse(result.error);
  document.body.classList.remove("stale");
  showError(null);
  if (document.activeElement !== byId("text")) setText(result.text);
  view.show(result);
  if (mine !== asked) return;
  if (coarse) {
    resting = setTimeout(() => solve(false), REST);
  } else {
    await steps.show(result);
    if (mine !== asked) return;
    lessons.show(result);
    remember();
  }
  status(`${coarse ? "coarse" : "solved"}, ${format(result.took)} ms`, coarse ? "coarse" : "solved");
}

function refuse(error) {
  document.body.classList.add("stale");
  showError(error);
  status(`${error.what} ${view.result ? "The last good result stays grey." : ""}`, "error");
}

async function remember() {
  Object.assign(state, { at: view.at, stage: view.stage });
  history.replaceState(null, "", `#${await packed(state)}`);
}

/** Begins with a case's text: its sliders, nothing moved, then what the link says besides. */
async function begin(changes) {
  asked++;
  clearTimeout(remembering);
  notice();
  byId("drawing").hidden = true;
  status("solving …", "solving");
  state = { ...begun(), a: state.a, ...changes };
  if (state.template) {
    const filled = await engine.ask({ do: "fill", name: state.template, given: state.given });
    if (filled.error) return refuse(filled.error);
    Object.assign(state, { base: filled.text, name: `${state.template}.toml` });
  }
  const { base: text, name, files, overrides } = state;
  plan = planOf(await engine.ask({ do: "numbers", text, name, files, overrides, paths: PATHS }));
  byId("template").value = state.template;
  byId("sheet").value = state.sheet;
  Object.assign(view, { at: state.at, stage: state.stage, place: NaN });
  byId("travel").value = state.at;
  setText(state.base);
  showSliders();
  drawOptions(templates.find(({ name }) => name === state.template), state.given, (given) => begin({ ...state, given, values: {} }));
  await lessons.enter(state.lesson);
  await solveA();
  await solve(false);
}

function showSliders() {
  drawSliders(plan, { ...state, isRound: !state.base.includes('"plane_strain"') }, (key, value, isLast) => {
    state.values[key] = value;
    showSliders();
    solve(!isLast);
  });
}

async function solveA() {
  view.resultOfA = null;
  byId("keep").textContent = state.a ? "Forget A" : "Keep as A";
  if (!state.a) return;
  const result = await engine.ask({ do: "solve", ...state.a });
  if (!result.error) view.resultOfA = result;
}

async function keep() {
  state.a = state.a ? null : { text: view.result.text, name: state.name, files: state.files };
  await solveA();
  view.draw();
  remember();
}

/** A case around the tools of a drawing, in its own unit or another. */
async function openDrawing([name, bytes], unit) {
  const made = await engine.ask({ do: "drawing", name, unit }, bytes);
  if (made.error) refuse(made.error);
  else await begin({ template: "", base: made.text, name: name.replace(/dxf$/i, "toml") });
  byId("drawing").hidden = false;
  byId("drawing-notes").textContent = (made.notes ?? []).join("; ");
  byId("unit").value = unit ?? "";
  byId("unit").onchange = ({ target }) => openDrawing([name, bytes], target.value || undefined);
}

/** Files that were dropped or chosen: a drawing, or a case with the tables that it names. */
async function open(files) {
  const all = await Promise.all([...files].map(async (file) => [file.name, new Uint8Array(await file.arrayBuffer())]));
  const of = (kind) => all.filter(([name]) => name.toLowerCase().endsWith(kind));
  const text = (bytes) => new TextDecoder().decode(bytes);
  const [[drawing], [written], tables] = [of(".dxf"), of(".toml"), of(".csv")];
  if (drawing) return openDrawing(drawing);
  if (!written && tables.length === 0) {
    return notice(`${all.map(([name]) => name).join(", ") || "This"} cannot be opened. The page opens a case (TOML), its tables (CSV) and a drawing (DXF); save a drawing of another kind as DXF.`);
  }
  const [name, base] = written ? [written[0], text(written[1])] : [state.name, state.base];
  const beside = Object.fromEntries(tables.map(([name, bytes]) => [name, text(bytes)]));
  return begin({ template: "", base, name, files: { ...state.files, ...beside } });
}

async function follow() {
  const hash = location.hash.slice(1);
  // A skip link goes to a part of the page.
  if (hash && byId(hash)) return;
  const next = hash ? await unpacked(hash) : begun();
  await begin(next ?? begun());
  if (!next) notice("This link is cut, or of another version of the page: here is the first example instead.");
}

function listen() {
  const on = (id, kind, listener) => byId(id).addEventListener(kind, listener);
  on("template", "change", ({ target }) => target.value && begin({ template: target.value }));
  on("sheet", "change", ({ target }) => {
    state.sheet = target.value;
    showSliders();
    solve(false);
  });
  on("file", "change", ({ target }) => open(target.files));
  on("reset", "click", () => begin({ ...state, values: {}, sheet: "" }));
  on("keep", "click", keep);
  on("link", "click", async () => {
    await remember();
    await navigator.clipboard.writeText(location.href).catch(() => {});
    status("copied", document.documentElement.dataset.state);
  });
  const solveText = () => begin({ template: "", base: byId("text").value, name: state.name, files: state.files });
  on("solve", "click", solveText);
  on("text", "keydown", (event) => event.ctrlKey && event.key === "Enter" && solveText());
  on("save-case", "click", () => save(state.name, byId("text").value, "application/toml"));
  const table = (file, key) => () => {
    const stage = view.result.stages[view.stage];
    save(file, csv(stage[key], stage.forceUnit), "text/csv");
  };
  on("save-curves", "click", table("load_travel.csv", "steps"));
  on("save-profile", "click", table("profile.csv", "end"));
  on("print", "click", () => print());
  const drop = (isOver, event) => (event.preventDefault(), document.body.classList.toggle("dropping", isOver));
  addEventListener("dragover", (event) => drop(true, event));
  addEventListener("dragleave", (event) => drop(false, event));
  addEventListener("drop", (event) => (drop(false, event), open(event.dataTransfer.files)));
  addEventListener("hashchange", follow);
}

/** An answer on the chosen case that is not its result: a step, or points of one. */
async function askAside(what) {
  const mine = asked;
  if (what.do === "trace") status("solving …", "solving");
  const answer = await engine.ask({ ...question(false), ...what });
  if (what.do === "trace" && mine === asked) answer.error ? refuse(answer.error) : status("solved", "solved");
  return answer;
}

async function start() {
  const inlined = (id) => byId(id).textContent;
  engine = new Engine(await compiled(inlined("solver")), inlined("worker"));
  const onCursor = () => {
    clearTimeout(remembering);
    remembering = setTimeout(remember, REST);
  };
  view = new View(onCursor, (e) => steps.choose(e));
  steps = new Steps(askAside, () => lessons.judge(), (e) => view.pick(e));
  const set = (key, text, isLast) => {
    state.set[key] = text;
    solve(!isLast);
  };
  lessons = new Lessons({ begin, set, steps, view, plan: () => plan });
  listen();
  const lists = await engine.ask({ do: "templates" });
  templates = lists.templates;
  const options = (id, first, names) => render([first, ...names].map((name, i) => html`<option value=${i ? name : ""}>${name}</option>`), byId(id));
  options("template", "–", templates.map(({ name }) => name));
  options("sheet", "as the case says", lists.sheets);
  options("unit", "as it says", lists.units);
  await follow();
  if (!view.result && document.documentElement.dataset.state !== "error") await begin({});
  const first = [question(true), question(false)];
  for (let i = 0; i < WARMING; i++) await engine.ask(first[i % 2]);
  document.documentElement.dataset.warm = "yes";
}

start().catch((error) => status(String(error), "error"));
