//! `stampflow materials`: the built-in library.

use super::*;
use stampflow::case::library::{self, Class, Entry};
use stampflow::forming_limit::{Curve, Hill, Kind, MarciniakKuczynski};
use stampflow::plot::{Chart, flow_curve, png};

const NOTES: &str = "
Computed from each law: Rp0.2 at a plastic strain of 0.2 %; Rm, Ag (uniform
elongation) and n (uniform true strain) at Considère's load maximum.
stampflow materials NAME shows one: law, source, and a table to paste.
";

/// First bytes of a PNG file, by which a picture may be replaced.
const PNG: usize = 8;

options! {
    /// List the built-in materials, or show one
    #[command(after_long_help = "\
In a case write [material] name = \"aa6016-t4\", or a grade such as DC04; you may replace any part of it.

Examples:
  stampflow materials
  stampflow materials aa6016-t4 --plot aa6016-t4.png")]
    Args {
        name: Option<String> [value_parser = Suggested::SHEETS, hide_possible_values = true]
            "Material to show: its name, a grade that it stands for, or the beginning of one",
        plot: Option<PathBuf> = "FILE.png" [long, requires = "name"]
            "Also draw its flow curve and forming limits, which are computed from the law",
    } json: Json;
}

pub fn materials(args: &Args) -> Result<Code> {
    let Some(name) = &args.name else {
        return match args.json.json {
            true => print_json(&library::materials()?.iter().map(as_json).collect::<Vec<_>>()),
            false => print(overview(&library::materials()?)),
        };
    };
    let entry = library::material(name)?;
    let mut more = String::new();
    if let Some(path) = &args.plot {
        let picture = png(&chart(&entry));
        place::replaced(path, &picture[..PNG], &[], "--plot")?;
        write(path, &picture)?;
        more = format!("\n{} is written\n", path.display());
    }
    if args.json.json {
        return print_json(&as_json(&entry));
    }
    let Entry { name, title, text, .. } = &entry;
    let known = properties(&entry).into_iter().map(|(label, value)| [format!("  {label}"), value]);
    let paste = format!("\nIn a case:\n\n[material]\nname = \"{name}\"\n\nor all of it:\n\n{text}{more}");
    print(ScreenText::from(format!("{name}: {title}\n\n")) + rows(known) + paste)
}

fn or_unknown(value: Option<impl ToString>) -> String {
    value.map_or("–".to_owned(), |value| value.to_string())
}

/// A table of materials, within 80 columns.
fn overview(entries: &[Entry]) -> ScreenText {
    let number = |value: Option<f64>, decimals: usize| or_unknown(value.map(|value| format!("{value:.decimals$}")));
    let row = |entry: &Entry| {
        [
            entry.name.to_owned(),
            or_unknown(entry.stands_for.as_ref().and_then(|stands| stands.grades.first())),
            format!("{:.0}", entry.proof_stress()),
            number(entry.tensile_strength(), 0),
            number(entry.uniform_elongation().map(|share| 100.0 * share), 0),
            entry.material.yield_criterion.ratio().to_string(),
            number(entry.n(), 3),
            number(entry.material.elastic.map(|elastic| 1e-3 * elastic.young), 0),
            or_unknown(entry.thickness.clone()).replace(" to ", "–"),
        ]
    };
    let headers = ["name", "grade", "Rp0.2", "Rm", "Ag", "r̄", "n", "E", "thickness"];
    let units = ["", "", "MPa", "MPa", "%", "–", "–", "GPa", ""].map(str::to_owned);
    table(&headers, [units].into_iter().chain(entries.iter().map(row))) + NOTES
}

/// All properties of a material as labels and texts.
fn properties(entry: &Entry) -> Vec<(&'static str, String)> {
    let material = &entry.material;
    let limit = |curve: Option<&Curve>, source: &str| {
        or_unknown(curve.map(|curve| format!("{:.4} in plane strain, true strain: {source}", curve.plane_strain())))
    };
    let tested = entry.tensile_strength().zip(entry.uniform_elongation());
    let tested =
        tested.map(|(rm, ag)| format!("{rm:.0} MPa, {:.1} %, at Considère's load maximum of the law", 100.0 * ag));
    let meaning = match entry.grade.as_str() {
        "A" => ", in that source",
        "B" => ", where that is quoted",
        _ => ", hardening assumed from another sheet",
    };
    let stands_for = entry.stands_for.as_ref().map(|s| format!("{}; {}", s.grades.join(", "), s.because));
    let mut rows = vec![
        ("stands for", or_unknown(stands_for)),
        ("law", material.describe()),
        ("Rp0.2", format!("{:.0} MPa, the law's stress at a plastic strain of 0.2 %", entry.proof_stress())),
        ("Rm, Ag", or_unknown(tested)),
        ("n", or_unknown(entry.n().map(|n| format!("{n:.4}, the uniform strain of the law")))),
        ("yields by", material.yield_criterion.to_string()),
        ("FLC", limit(entry.forming_limit().as_ref(), "computed from the law (Hill), not measured")),
        ("FLC points", limit(entry.measured_limit.as_ref(), "measured; [forming_limit] measured = true takes them")),
        ("E, ν", or_unknown(material.elastic.map(|e| format!("{} MPa, {}", e.young, e.poisson)))),
        ("thickness", or_unknown(entry.thickness.clone())),
        ("scatter", or_unknown(entry.class.as_ref().map(scatter))),
        ("source", entry.source.clone()),
        ("read", entry.grade.clone() + meaning),
        ("licence", entry.licence.clone()),
    ];
    let fitted = material.fitted_up_to.map(|end| format!("up to a true strain of {end}; a run beyond says so"));
    rows.extend(fitted.map(|range| ("fitted", range)));
    rows.extend(entry.elastoplastic.as_ref().map(|law| {
        let terms = law.chaboche.iter().map(|term| format!("C {} MPa, γ {}", term.modulus, term.dynamic_recovery));
        let terms = terms.collect::<Vec<_>>().join("; ");
        ("back-stresses", format!("{terms}, in mode = \"elasto_viscoplastic\""))
    }));
    rows.extend(entry.notes.iter().map(|note| ("note", note.clone())));
    rows
}

/// Scatter of a class of sheets.
fn scatter(class: &Class) -> String {
    let strength = class.strength().map(|[low, high]| format!("Rm {low} to {high} MPa ({})", class.source));
    let thickness = class.thickness().map(|standard| format!("thickness by {}", standard.source));
    strength.into_iter().chain(thickness).collect::<Vec<_>>().join("; ")
}

/// Name, title, the properties as they are printed, and the table to paste.
fn as_json(entry: &Entry) -> Value {
    let texts = [("name", entry.name), ("title", &entry.title), ("case", entry.text)];
    let texts = texts.map(|(key, value)| (key, value.to_owned())).into_iter().chain(properties(entry));
    Value::Object(texts.map(|(key, value)| (key.to_owned(), value.into())).collect())
}

/// The flow curve, and the limits of the law where they can be computed.
fn chart(entry: &Entry) -> Chart {
    let (imperfection, strain_rate) = (MarciniakKuczynski::IMPERFECTION, MarciniakKuczynski::STRAIN_RATE);
    let mut notes = vec![format!("Source: {}.", entry.source)];
    notes.extend(entry.notes.iter().cloned());
    let mut limits: Vec<Curve> = entry.measured_limit.iter().cloned().collect();
    let groove = Kind::MarciniakKuczynski(MarciniakKuczynski { imperfection, strain_rate });
    for kind in [Kind::Hill(Hill { n: None }), groove] {
        match kind.curve(&entry.sheet()) {
            Ok(curve) => {
                notes.extend(curve.notes.iter().map(ToString::to_string));
                limits.push(curve);
            }
            Err(error) => notes.push(format!("A forming limit is left out: {error}.")),
        }
    }
    let title = format!("{}: {}", entry.name, entry.title);
    flow_curve::chart(&title, &entry.material, &limits, notes)
}
