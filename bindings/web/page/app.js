// The page: what is chosen, what is asked of the solver, what is shown.
import { csv, save } from "./downloads.js";
import { Editor } from "./editor.js";
import { compiled, Engine } from "./engine.js";
import { Lessons } from "./lesson_panel.js";
import { drawOptions } from "./options.js";
import { drawSliders } from "./sliders.js";
import { begun, overrides, packed, unpacked } from "./state.js";
import { Steps } from "./steps.js";
import { View } from "./view.js";
import { byId, format } from "./dom.js";

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
const editor = new Editor({ text: byId("text"), lines: byId("lines"), error: byId("error"), printed: byId("printed") });

function question(coarse) {
  const { base, name, files } = state;
  return { do: "solve", text: base, name, files, overrides: overrides(state, plan), coarse };
}

function status(text, kind) {
  byId("status").textContent = text;
  document.documentElement.dataset.state = kind;
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
  editor.clear();
  if (document.activeElement !== byId("text")) editor.set(result.text);
  view.show(result);
  const took = `${format(result.took)} ms`;
  // A newer question is on its way.
  if (mine !== asked) return;
  if (coarse) {
    resting = setTimeout(() => solve(false), REST);
  } else {
    await steps.show(result);
    if (mine !== asked) return;
    lessons.show(result);
    remember();
  }
  status(`${coarse ? "coarse" : "solved"}, ${took}`, coarse ? "coarse" : "solved");
}

function refuse(error) {
  document.body.classList.add("stale");
  editor.refuse(error);
  status(`${error.what} ${view.result ? "The last good result stays grey." : ""}`, "error");
}

async function remember() {
  Object.assign(state, { at: view.at, stage: view.stage });
  history.replaceState(null, "", `#${await packed(state)}`);
}

/** Begins with a case's text: its sliders, nothing moved, then what the link says besides. */
async function begin(next) {
  asked++;
  status("solving …", "solving");
  state = next;
  if (state.template) {
    const filled = await engine.ask({ do: "fill", name: state.template, given: state.given });
    if (filled.error) return refuse(filled.error);
    Object.assign(state, { base: filled.text, name: `${state.template}.toml` });
  }
  plan = await engine.ask({ do: "sliders", text: state.base });
  byId("template").value = state.template;
  byId("sheet").value = state.sheet;
  Object.assign(view, { at: state.at, stage: state.stage, place: NaN });
  byId("travel").value = state.at;
  editor.set(state.base);
  showSliders();
  drawOptions(templates.find(({ name }) => name === state.template), state.given, (given) => begin({ ...state, given, values: {} }));
  await solveA();
  await solve(false);
}

function showSliders() {
  drawSliders(byId("sliders"), plan, { ...state, isRound: !state.base.includes('"plane_strain"') }, (key, value, isLast) => {
    state.values[key] = value;
    solve(!isLast);
  });
}

async function solveA() {
  view.resultOfA = null;
  byId("keep").textContent = (state.a ? "Forget A" : "Keep as A");
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

/** Files that were dropped or chosen: a drawing, or a case with the tables that it names. */
async function open(files) {
  const all = await Promise.all([...files].map(async (file) => [file.name, new Uint8Array(await file.arrayBuffer())]));
  const drawing = all.find(([name]) => /\.dxf$/i.test(name));
  const text = (bytes) => new TextDecoder().decode(bytes);
  const beside = Object.fromEntries(all.filter(([name]) => /\.csv$/i.test(name)).map(([name, bytes]) => [name, text(bytes)]));
  if (drawing) {
    const made = await engine.ask({ do: "drawing", name: drawing[0] }, drawing[1]);
    if (made.error) return refuse(made.error);
    return begin({ ...begun(), template: "", base: made.text, name: drawing[0].replace(/dxf$/i, "toml"), a: state.a });
  }
  const written = all.find(([name]) => /\.toml$/i.test(name));
  const [name, base] = written ? [written[0], text(written[1])] : [state.name, state.base];
  return begin({ ...begun(), template: "", base, name, files: { ...state.files, ...beside }, a: state.a });
}

function listen() {
  byId("template").addEventListener("change", ({ target }) => target.value && begin({ ...begun(), template: target.value, a: state.a }));
  byId("sheet").addEventListener("change", ({ target }) => {
    state.sheet = target.value;
    showSliders();
    solve(false);
  });
  byId("file").addEventListener("change", ({ target }) => open(target.files));
  byId("reset").addEventListener("click", () => begin({ ...state, values: {}, sheet: "" }));
  byId("keep").addEventListener("click", keep);
  byId("link").addEventListener("click", async () => {
    await remember();
    await navigator.clipboard.writeText(location.href).catch(() => {});
    status("copied", document.documentElement.dataset.state);
  });
  const solveText = () => begin({ ...begun(), template: "", base: byId("text").value, name: state.name, files: state.files, a: state.a });
  byId("solve").addEventListener("click", solveText);
  byId("text").addEventListener("keydown", (event) => event.ctrlKey && event.key === "Enter" && solveText());
  byId("save-case").addEventListener("click", () => save(state.name, byId("text").value, "application/toml"));
  const table = (file, key) => () => {
    const stage = view.result.stages[view.stage];
    save(file, csv(stage[key], stage.forceUnit), "text/csv");
  };
  byId("save-curves").addEventListener("click", table("load_travel.csv", "steps"));
  byId("save-profile").addEventListener("click", table("profile.csv", "end"));
  byId("print").addEventListener("click", () => print());
  addEventListener("dragover", (event) => (event.preventDefault(), document.body.classList.add("dropping")));
  addEventListener("dragleave", () => document.body.classList.remove("dropping"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    open(event.dataTransfer.files);
  });
  addEventListener("hashchange", async () => {
    const next = await unpacked(location.hash.slice(1));
    if (next) begin(next);
  });
}

/** A step, iteration by iteration. */
async function takenApart(step) {
  const mine = asked;
  status("solving …", "solving");
  const trace = await engine.ask({ ...question(false), do: "trace", step });
  if (mine === asked) trace?.error ? refuse(trace.error) : status("solved", "solved");
  return trace;
}

async function start() {
  const inlined = (id) => byId(id).textContent;
  engine = new Engine(await compiled(inlined("solver")), inlined("worker"));
  view = new View(() => {
    clearTimeout(remembering);
    remembering = setTimeout(remember, REST);
  });
  steps = new Steps(takenApart, () => lessons.judge());
  lessons = new Lessons((template) => begin({ ...begun(), template }), steps);
  listen();
  const lists = await engine.ask({ do: "templates" });
  templates = lists.templates;
  byId("template").replaceChildren(new Option("–", ""), ...templates.map(({ name, about }) => Object.assign(new Option(name, name), { title: about })));
  byId("sheet").replaceChildren(new Option("as the case says", ""), ...lists.sheets.map((name) => new Option(name, name)));
  await begin((await unpacked(location.hash.slice(1))) ?? begun());
  const first = [question(true), question(false)];
  for (let i = 0; i < WARMING; i++) await engine.ask(first[i % 2]);
  document.documentElement.dataset.warm = "yes";
}

start().catch((error) => status(String(error), "error"));
