//! `stampflow materials`: the built-in library.

use super::*;
use stampflow::case::library::{Description, Entry};

const NOTES: &str = "
Computed from each law: Rp0.2 at a plastic strain of 0.2 %; Rm, Ag (uniform
elongation) and n (uniform true strain) at Considère's load maximum; MPa, %, GPa.
stampflow materials NAME shows one: band, law, source, and a table to paste.
";

const HEADERS: [&str; 9] = ["name", "grade", "Rp0.2", "Rm", "Ag", "r̄", "n", "E", "thickness"];

options! {
    /// List the built-in materials, or show one
    Args {
        name: Option<String> [] "Material to show: its name, a grade that it stands for, or the beginning of one",
    } json: Json;
}

pub fn materials(args: &Args) -> Result<Code> {
    let Some(name) = &args.name else {
        let all = library::materials()?;
        let group = |is_made, title: &str| {
            wrapped(title) + table(&HEADERS, all.iter().filter(|entry| entry.about.is_made() == is_made).map(row))
        };
        return emit(args.json.json, all.iter().map(as_json).collect(), || {
            let fitted = group(false, "Fitted to a measured curve, or a law as printed:\n\n");
            fitted + group(true, "\nMade from the band of a standard, not fitted:\n\n") + NOTES
        });
    };
    let entry = library::material(name)?;
    let Entry { name, text, about, material, .. } = &entry;
    let Description { title, notes, licence, stands_for, band, .. } = about;
    let stands_for = stands_for.iter().map(|s| format!("stands for {}; {}", s.grades.join(", "), s.because));
    let notes = stands_for.chain(notes.iter().cloned()).chain([format!("licence: {licence}")]);
    let band =
        band.iter().fold(wrapped(format!("\nLaw: {}; {}\n", material.hardening, about.source())), |text, band| {
            let (rows, sources) = band.rows();
            text + wrapped(format!("\nBand of {}\n\n", band.standard))
                + table(&["", "least", "largest", "kind", "grade", "source"], rows)
                + "\n"
                + list(sources)
        });
    let paste = format!("\nIn a case:\n\n[material]\nname = \"{name}\"\n\nor all of it:\n\n{text}");
    emit(args.json.json, as_json(&entry), || wrapped(format!("{name}: {title}\n\n")) + list(notes) + band + paste)
}

fn row(entry: &Entry) -> [String; 9] {
    let number = |value: Option<f64>, decimals: usize| value.map(|value| format!("{value:.decimals$}"));
    [
        Some(entry.name.to_owned()),
        entry.about.stands_for.as_ref().and_then(|stands| stands.grades.first()).cloned(),
        number(Some(entry.proof_stress()), 0),
        number(entry.tensile_strength(), 0),
        number(entry.uniform_elongation().map(|share| 100.0 * share), 0),
        Some(entry.material.yield_criterion.ratio().to_string()),
        number(entry.n(), 3),
        number(entry.material.elastic.map(|elastic| 1e-3 * elastic.young), 0),
        entry.about.thickness.as_ref().map(|thickness| thickness.replace(" to ", "–")),
    ]
    .map(|value| value.unwrap_or("–".to_owned()))
}

fn as_json(entry: &Entry) -> Value {
    let Entry { about, text, .. } = entry;
    let (Description { title, notes, licence, .. }, source) = (about, about.source());
    let band = about.band.as_ref().map(|band| band.rows());
    let mut value = json!({ "made": about.is_made(), "band": band, "title": title, "notes": notes, "source": source, "licence": licence, "case": text });
    HEADERS.into_iter().zip(row(entry)).for_each(|(key, cell)| value[key] = cell.into());
    value
}
