// The page's own words; whatever the solver tells comes from its table of messages.

const GERMAN = {
  "Step by step": "Schritt für Schritt",
  "Begin with": "Beginnen mit",
  "Open a case or a drawing": "Fall oder Zeichnung öffnen",
  "Drop a case (TOML), its tables (CSV) or a drawing (DXF) anywhere.": "Fall (TOML), seine Tabellen (CSV) oder eine Zeichnung (DXF) irgendwo ablegen.",
  "Language": "Sprache",
  "Colours": "Farben",
  "as the system": "wie das System",
  "light": "hell",
  "dark": "dunkel",
  "What to change": "Was zu ändern ist",
  "Sheet": "Blech",
  "as the case says": "wie im Fall",
  "Reset": "Zurücksetzen",
  "Keep as A": "Als A merken",
  "Forget A": "A vergessen",
  "Stage": "Stufe",
  "Travel": "Weg",
  "Play": "Abspielen",
  "Stop": "Anhalten",
  "Load": "Kraft",
  "Thickness": "Dicke",
  "Thickness on the part": "Dicke am Teil",
  "Forming limit": "Grenzformänderung",
  "Punch force": "Stempelkraft",
  "Holder force": "Niederhalterkraft",
  "Edge force": "Kraft am Rand",
  "Gas pressure": "Gasdruck",
  "Punch travel": "Stempelweg",
  "Height of the middle": "Höhe der Mitte",
  "Initial distance from the axis": "Abstand von der Achse im Zuschnitt",
  "Initial distance from the middle": "Abstand von der Mitte im Zuschnitt",
  "Minor strain": "Nebenformänderung",
  "Major strain": "Hauptformänderung",
  "limit": "Grenze",
  "peak": "Spitze",
  "thinner": "dünner",
  "thicker": "dicker",
  "Verdict": "Urteil",
  "Finding": "Frage",
  "Found": "Gefunden",
  "Limit": "Grenze",
  "What to do": "Was zu tun ist",
  "Case file": "Falldatei",
  "Solve this text": "Diesen Text rechnen",
  "Download case": "Fall speichern",
  "Download curves (CSV)": "Kurven speichern (CSV)",
  "Download profile (CSV)": "Profil speichern (CSV)",
  "Copy link": "Link kopieren",
  "copied": "kopiert",
  "line": "Zeile",
  "column": "Spalte",
  "solving …": "rechnet …",
  "solved": "gerechnet",
  "coarse": "grob",
  "The last good result stays grey.": "Das letzte gute Ergebnis bleibt grau.",
  "no forming limit in this case": "dieser Fall hat keine Grenzformänderung",
  "no force in this stage": "keine Kraft in dieser Stufe",
  "Blank": "Zuschnitt",
  "Sheet thickness": "Blechdicke",
  "Punch": "Stempel",
  "Punch nose radius": "Stempelkantenradius",
  "Die opening": "Ziehringöffnung",
  "Die shoulder radius": "Ziehringradius",
  "Clearance": "Ziehspalt",
  "Holder opening": "Niederhalteröffnung",
  "Holder pressure": "Niederhalterdruck",
  "Friction": "Reibung",
  "Hardening k": "Verfestigung k",
  "Hardening n": "Verfestigung n",
  "Warnings and notes": "Warnungen und Anmerkungen",
  "at": "bei",
  "thinnest": "dünnste Stelle",
  "nearest to the limit": "der Grenze am nächsten",
  "The section at travel": "Der Schnitt beim Weg",
  "One step of the solver": "Ein Schritt des Lösers",
  "Step": "Schritt",
  "Iteration": "Iteration",
  "Sheet as it is tried, and the forces that are not in balance": "Blech, wie es versucht wird, und die Kräfte, die nicht im Gleichgewicht sind",
  "Velocity norm: how far the next iteration moves": "Geschwindigkeitsnorm: wie weit die nächste Iteration geht",
  "Force out of balance at each node": "Unausgeglichene Kraft an jedem Knoten",
  "Power of the step": "Leistung des Schritts",
  "Node": "Knoten",
  "primal-dual": "primal-dual",
  "Newton": "Newton",
  "secant": "Sekante",
  "tolerance": "Toleranz",
  "tools": "Werkzeuge",
  "plastic flow": "plastisch",
  "elastic": "elastisch",
  "friction": "Reibung",
  "contact springs": "Kontaktfedern",
  "flows": "fließt",
  "nearly rigid": "fast starr",
  "Force": "Kraft",
  "Each matrix runs from the start of the case; pick an element in the chart of nodes.": "Jede Matrix rechnet den Fall von Anfang an; ein Element wird im Bild der Knoten gewählt.",
  "Element": "Element",
};

/** An element of the page. */
export const byId = (id) => document.getElementById(id);

let language = "en";

export function setLanguage(code) {
  language = code;
  document.documentElement.lang = code;
}

export function currentLanguage() {
  return language;
}

/** A word of the page in the language that is set; English is the key. */
export function word(text) {
  return language === "de" ? (GERMAN[text] ?? text) : text;
}

/** Fills every element that names its word. */
export function tellWords(root) {
  for (const element of root.querySelectorAll("[data-word]")) element.textContent = word(element.dataset.word);
  for (const element of root.querySelectorAll("[data-label]")) element.setAttribute("aria-label", word(element.dataset.label));
}

/** A number with so many significant digits in the language's writing. */
export function told(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  return value.toLocaleString(language, { maximumSignificantDigits: digits, useGrouping: false });
}
