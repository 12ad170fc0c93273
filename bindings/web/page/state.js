// What is looked at, and its link: all of it in the address, deflated and in base64, so that a link is the example.

export function begun() {
  return { template: "cup", given: {}, base: "", name: "cup.toml", files: {}, sheet: "", values: {}, overrides: [], set: {}, lesson: null, a: null, at: 1, stage: 0 };
}

async function through(stream, bytes) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

/** The link's part behind `#`; a template's text is not in it. */
export async function packed(state) {
  const kept = { ...state, base: state.template ? "" : state.base };
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify(kept)));
  return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** What a link says; null where it is none. */
export async function unpacked(hash) {
  try {
    const letters = atob(hash.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    const json = new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
    return { ...begun(), ...JSON.parse(json) };
  } catch {
    return null;
  }
}

/** The settings that replace what the base text says: the sheet, every path whose sliders were moved, and what a lesson sets. */
export function overrides(state, { sliders, writes }) {
  const value = (key) => state.values[key] ?? sliders.find((slider) => slider.key === key)?.value ?? 0;
  const set = writes
    .filter(({ terms }) => terms.some((key) => state.values[key] !== undefined))
    .map(({ path, unit, terms, plus }) => {
      // No more digits than anyone means.
      const number = Number(terms.reduce((sum, key) => sum + value(key), plus).toPrecision(6));
      return unit ? `${path}="${number} ${unit}"` : `${path}=${number}`;
    });
  const ofLesson = Object.entries(state.set).map(([key, value]) => `${key}=${value}`);
  return [...state.overrides, ...(state.sheet ? [`material=${state.sheet}`] : []), ...set, ...ofLesson];
}
