// Sliders of a case, and the paths that they write: a die's throat goes with the punch, because the clearance stays.

/** Numbers with a slider: key, label, the paths where it may stand, and its range over the number of the case [–]. */
const KNOWN = [
  ["blank", "Blank", "blank.radius blank.half_length blank.diameter blank.length", [0.8, 1.25]],
  ["thickness", "Sheet thickness", "blank.thickness", [0.5, 1.6]],
  ["punch_radius", "Punch", "tools.punch.flat.radius tools.punch.flat.half_width tools.punch.hemispherical.radius tools.punch.flat.diameter tools.punch.hemispherical.diameter", [0.8, 1.2]],
  ["nose", "Punch nose radius", "tools.punch.flat.nose", [0.5, 2]],
  ["throat", "Die opening", "tools.die.throat tools.die.throat_diameter", [0.95, 1.2]],
  ["shoulder", "Die shoulder radius", "tools.die.shoulder", [0.5, 2]],
  ["inner_radius", "Holder opening", "tools.holder.inner_radius tools.holder.inner_half_width", [0.95, 1.2]],
  ["holder_force", "Holder force", "tools.holder.force", [0, 4]],
  ["holder_pressure", "Holder pressure", "tools.holder.pressure", [0, 4]],
  ["travel", "Punch travel", "tools.punch.travel", [0.2, 1.2]],
  ["friction", "Friction", "tools.punch.friction tools.die.friction", [0, 3]],
  ["k", "Hardening k", "material.hardening.swift.k material.hardening.hollomon.k", [0.5, 2]],
  ["n", "Hardening n", "material.hardening.swift.n material.hardening.hollomon.n", [0.4, 1.6]],
];
/** Numbers of the method: label, path, unit, and range over the number of the case [–]. */
const METHOD = [
  ["Elements", "blank.elements", "", [0.15, 2]],
  ["Points through the thickness", "blank.layers", "", [0.6, 5]],
  ["Largest step over the travel", "solver.max_step", "", [0.1, 10]],
  ["Cut-off strain", "solver.cutoff_strain", "", [0.01, 1000]],
  ["Contact stiffness times thickness", "solver.contact_stiffness", "GPa", [0.001, 10]],
  ["Contact smoothing over thickness", "solver.contact_smoothing", "", [0.1, 30]],
];
/** Range of the clearance over its value, its largest over the punch's radius [–], and lengths that are one [mm]. */
const [GAP, WIDEST, SAME] = [[0.8, 2], 0.25, 1e-6];

export const PATHS = KNOWN.flatMap(([, , paths]) => paths.split(" "));

function slider(key, label, path, value, unit, [low, high], isOfMethod = false) {
  return { key, label, path, value, unit, low: low * value, high: high * value, isOfMethod };
}

/** Sliders of a case by its numbers at the paths, and the paths that are set to the sum of some sliders and a constant. */
export function planOf({ numbers, method }) {
  const stands = Object.fromEntries(PATHS.map((path, i) => [path, numbers[i]]));
  const known = KNOWN.flatMap(([key, label, paths, range]) => {
    const path = paths.split(" ").find((path) => parseFloat(stands[path]) > 0);
    return path ? [slider(key, label, path, parseFloat(stands[path]), String(stands[path]).split(/\s+/)[1] ?? "", range)] : [];
  });
  const byKey = Object.fromEntries(known.map((one) => [one.key, one]));
  const { blank, punch_radius: punch, throat, shoulder, inner_radius: hole } = byKey;
  const share = (...all) => all.every((one) => one && one.unit === all[0].unit);
  const writes = [];
  const write = ({ path, unit }, terms, plus = 0) => writes.push({ path, unit, terms, plus });
  let edge = ["throat"];
  const gap = share(punch, throat) && ![punch, throat].some(({ path }) => path.endsWith("diameter")) ? throat.value - punch.value : 0;
  if (gap > 0 && gap <= WIDEST * punch.value) {
    byKey.throat = slider("clearance", "Clearance", "", gap, throat.unit, GAP);
    edge = ["punch_radius", "clearance"];
    write(throat, edge);
    if (share(throat, hole, shoulder)) {
      write(hole, [...edge, "shoulder"], hole.value - throat.value - shoulder.value);
      delete byKey.inner_radius;
    }
  }
  // A blank that ends where the die's shoulder does goes with it.
  if (share(blank, throat, shoulder) && Math.abs(blank.value - throat.value - shoulder.value) < SAME) {
    write(blank, [...edge, "shoulder"]);
    delete byKey.blank;
  }
  const ofMethod = METHOD.filter(() => method).map(([label, path, unit, range]) => slider(path, label, path, method[path], unit, range, true));
  const sliders = [...Object.values(byKey), ...ofMethod];
  for (const one of sliders.filter(({ path }) => path)) {
    // The key `friction` sets every tool's.
    if (!writes.some(({ path }) => path === one.path)) write(one.key === "friction" ? { ...one, path: "friction" } : one, [one.key]);
  }
  return { sliders, writes };
}
