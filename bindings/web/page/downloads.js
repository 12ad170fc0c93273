// Files of what is shown, made in the page.

export function save(name, text, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

function header(key, forceUnit) {
  if (/force/.test(key)) return `${key}_${forceUnit === "N" ? "N" : "N_per_mm"}`;
  if (/^stress|^pressure$/.test(key)) return `${key}_MPa`;
  if (/^strain|^penetration$|^iterations$/.test(key)) return key;
  return key === "time" ? "time_s" : `${key}_mm`;
}

/** One row per step or element, as the command line's tables have them. */
export function csv(columns, forceUnit) {
  const keys = Object.keys(columns);
  const rows = Array.from(columns[keys[0]], (_, i) => keys.map((key) => columns[key][i]).map((value) => (Number.isFinite(value) ? Number(value.toPrecision(9)) : "")));
  return [keys.map((key) => header(key, forceUnit)), ...rows].map((row) => row.join(",")).join("\n") + "\n";
}
