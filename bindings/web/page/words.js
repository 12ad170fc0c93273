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
  "Lessons": "Lektionen",
  "answered": "beantwortet",
  "Friction and the pole": "Reibung und der Pol",
  "A punch stretches a clamped sheet into a dome. Where the sheet lies on the punch, friction holds it, and what is held does not thin any more: the thinnest place wanders from the pole outward.":
    "Ein Stempel streckt ein eingespanntes Blech zur Kuppe. Wo es auf dem Stempel liegt, hält es die Reibung, und was gehalten wird, dünnt nicht weiter aus: die dünnste Stelle wandert vom Pol nach außen.",
  "Bring the thinnest place within 5 mm of the pole.": "Bringen Sie die dünnste Stelle näher als 5 mm an den Pol.",
  "Localisation": "Lokalisierung",
  "Where a place thins, it hardens, and its neighbours take over: n says how much. When hardening no longer outweighs thinning, one place takes all the stretching, and the sheet tears.":
    "Wo eine Stelle ausdünnt, verfestigt sie sich, und ihre Nachbarn übernehmen: n sagt, wie sehr. Wiegt die Verfestigung das Ausdünnen nicht mehr auf, streckt sich nur noch eine Stelle, und das Blech reißt.",
  "Find an n at which the dome tears before its full travel.": "Finden Sie ein n, bei dem die Kuppe vor dem vollen Weg reißt.",
  "Draw ratio": "Ziehverhältnis",
  "The wall must pull the whole flange in: the force grows with the blank's diameter over that of the punch, what the wall can bear does not. Their ratio has a limit near 2.":
    "Die Zarge muss den ganzen Flansch einziehen: die Kraft wächst mit dem Durchmesser des Zuschnitts über dem des Stempels, was die Zarge tragen kann, nicht. Das Verhältnis hat eine Grenze nahe 2.",
  "Enlarge the blank until the wall comes near the force that it can bear: bottom tearing is no longer green.":
    "Vergrößern Sie den Zuschnitt, bis die Zarge der Kraft nahe kommt, die sie trägt: der Bodenreißer ist nicht mehr grün.",
  "The sheet keeps its volume: t = t₀ exp(−ε_s − ε_θ). Towards the throat the circles of the flange become shorter, ε_θ is negative, and the rim grows thicker although it is pulled.":
    "Das Blech behält sein Volumen: t = t₀ exp(−ε_s − ε_θ). Zur Öffnung hin werden die Kreise des Flansches kürzer, ε_θ ist negativ, und der Rand wird dicker, obwohl an ihm gezogen wird.",
  "The circles of a smaller blank have less to shrink: find one whose rim stays below 1.20 mm.":
    "Die Kreise eines kleineren Zuschnitts müssen weniger schrumpfen: finden Sie einen, dessen Rand unter 1,20 mm bleibt.",
  "Bending and unbending": "Biegen und Rückbiegen",
  "Sheet that runs over a radius is bent and straightened again, and both are paid for: the sharper the radius over the thickness, the larger the force.":
    "Blech, das über einen Radius läuft, wird gebogen und wieder gerade gerichtet, und beides kostet: je schärfer der Radius zur Dicke, desto größer die Kraft.",
  "Sharpen the punch nose until the force exceeds 28 N per millimetre of width.": "Schärfen Sie die Stempelkante, bis die Kraft 28 N je Millimeter Breite übersteigt.",
  "Sizes of the template": "Maße der Vorlage",
  "Download report (HTML)": "Bericht speichern (HTML)",
  "Elements": "Elemente",
  "More in the book": "Mehr im Buch (englisch)",
  "now": "jetzt",
  "Ideal drawing": "Ideales Ziehen",
  "Without friction and bending only the flange takes work: its circles shrink from the blank's rim to the throat, and the wall pulls with F = 2π r t σ ln(R/r). Friction under the holder and round the shoulder, and bending, come on top.":
    "Ohne Reibung und Biegung kostet nur der Flansch Arbeit: seine Kreise schrumpfen vom Rand des Zuschnitts zur Öffnung, und die Zarge zieht mit F = 2π r t σ ln(R/r). Reibung unter dem Niederhalter und am Ziehring sowie Biegung kommen hinzu.",
  "Bring the largest punch force below 35 kN with lubricant alone: what is left is nearly the ideal force.":
    "Bringen Sie die größte Stempelkraft allein durch Schmierung unter 35 kN: was bleibt, ist nahezu die ideale Kraft.",
  "Why a velocity norm": "Warum eine Geschwindigkeitsnorm",
  "Forces out of balance say little: a penalty spring makes them huge where a tool hardly sinks in, and a rigid zone bears any. How far an iteration moves the sheet is a length, the same for all: ‖δȧ‖ / ‖ȧ‖.":
    "Unausgeglichene Kräfte sagen wenig: eine Kontaktfeder macht sie riesig, wo ein Werkzeug kaum einsinkt, und eine starre Zone trägt jede. Wie weit eine Iteration das Blech bewegt, ist eine Länge, für alle dieselbe: ‖δȧ‖ / ‖ȧ‖.",
  "Go through the iterations until one moves the sheet by less than a thousandth of its step.":
    "Gehen Sie durch die Iterationen, bis eine das Blech um weniger als ein Tausendstel seines Schritts bewegt.",
  "Why primal-dual": "Warum primal-dual",
  "Where the sheet hardly deforms, the flow law σ = σ_y Δε / √(Δε² + Δε₀²) bends sharply. The secant matrix crawls round that bend, Newton's jumps over it. The primal-dual matrix keeps stress and strain as two unknowns, and does neither.":
    "Wo sich das Blech kaum verformt, hat das Fließgesetz σ = σ_y Δε / √(Δε² + Δε₀²) einen scharfen Knick. Die Sekantenmatrix kriecht um ihn herum, die von Newton springt darüber. Die primal-duale führt Spannung und Dehnung als zwei Unbekannte und tut keines von beiden.",
  "Find a step for which the secant takes at least twenty times as many iterations as the primal-dual matrix.":
    "Finden Sie einen Schritt, für den die Sekante mindestens zwanzigmal so viele Iterationen braucht wie die primal-duale Matrix.",
  "Volume constancy and thinning": "Volumenkonstanz und Ausdünnung",
  "Spring-back": "Rückfederung",
  "Bending leaves a moment in the sheet. When the tools go, it turns back elastically by κ = 12 M (1 − ν²) / (E t³): the stronger and the thinner the sheet, the further.":
    "Biegen lässt ein Moment im Blech zurück. Gehen die Werkzeuge, dreht es elastisch zurück, um κ = 12 M (1 − ν²) / (E t³): je fester und je dünner das Blech, desto weiter.",
  "Find a thickness at which each leg turns back by more than 4 degrees.": "Finden Sie eine Dicke, bei der jeder Schenkel um mehr als 4 Grad zurückfedert.",
  "Error bars": "Fehlerbalken",
  "Every number hangs on the mesh, too. Solved once more with other elements, it says by how much: what moves is not the cup but the arithmetic, and a number without that bar is half a number.":
    "Jede Zahl hängt auch am Netz. Noch einmal mit anderen Elementen gerechnet, sagt sie, wie sehr: was sich bewegt, ist nicht der Napf, sondern die Rechnung, und eine Zahl ohne diesen Balken ist eine halbe Zahl.",
  "Take elements away until the largest punch force is off by more than 1 %.": "Nehmen Sie Elemente weg, bis die größte Stempelkraft um mehr als 1 % abweicht.",
  "One step of the solver": "Ein Schritt des Lösers",
  "Step": "Schritt",
  "Iteration": "Iteration",
  "Sheet as it is tried, contact forces, and forces out of balance": "Blech, wie es versucht wird, Kontaktkräfte und unausgeglichene Kräfte",
  "Velocity norm: how far an iteration moves": "Geschwindigkeitsnorm: wie weit eine Iteration geht",
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
  "Each matrix takes the step from the same state; pick an element in the chart of nodes.": "Jede Matrix geht den Schritt vom selben Zustand an; ein Element wird im Bild der Knoten gewählt.",
  "Matrix": "Matrix",
  "not converged": "nicht konvergiert",
  "contact force": "Kontaktkraft",
  "out of balance": "nicht im Gleichgewicht",
  "points in contact": "Punkte im Kontakt",
  "stick": "haften",
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
