//! `stampflow materials`: the built-in library.

use super::code::Code;
use super::options::Json;
use super::place;
use super::say::{Shown, say, say_json};
use super::suggested::Suggested;
use super::table::{Cell, table};
use anyhow::Result;
use serde_json::{Value, json};
use stampflow::case::library::{self, Class, Entry, Fit};
use stampflow::case::thickness_tolerance::Standard;
use stampflow::forming_limit::{Curve, Hill, Kind, MarciniakKuczynski};
use stampflow::material::BackStress;
use stampflow::results::{Chart, flow_curve, png, write};
use stampflow::units::rounded;
use std::path::PathBuf;

pub const HELP: &str = "\
A case takes one by its name, [material] name = \"aa6016-t4\", or a grade such as DC04, and may replace any part of it;
--material NAME puts one in the place of a case's own sheet for one check, run or report. Every number names its
source; forming limits that are drawn are computed from the law, not measured.

Examples:
  stampflow materials
  stampflow materials aa6016-t4 --plot aa6016-t4.png";

/// What stands below the list.
const NOTES: &str = "
Computed from each law: Rp0.2 at a plastic strain of 0.2 %; Rm, Ag (uniform
elongation) and n (uniform true strain) at Considère's load maximum.
stampflow materials NAME says all of one: law, source, and a table to paste.
";

/// Bytes by which a picture of this kind is known.
const PNG: usize = 8;

/// What no source says.
const UNKNOWN: &str = "–";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Material to say all of: its name, a grade that it stands for, or the beginning of one
    #[arg(value_parser = Suggested::SHEETS, hide_possible_values = true)]
    name: Option<String>,
    /// Also draw its flow curve, with the points it is fitted to, and the limits that follow from it
    #[arg(long, value_name = "FILE.png", requires = "name")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    json: Json,
}

pub fn materials(args: &Args) -> Result<Code> {
    let Some(name) = &args.name else {
        return match args.json.json {
            true => say_json(&library::materials()?.iter().map(of).collect::<Vec<_>>()),
            false => say(list(&library::materials()?)),
        };
    };
    let entry = library::material(name)?;
    let mut text = describe(&entry);
    if let Some(path) = &args.plot {
        let picture = png(&chart(&entry));
        place::replaced(path, &picture[..PNG], "--plot")?;
        place::file(path, &[], "--plot")?;
        write(path, &picture)?;
        text = text + format!("\n{} written\n", path.display()).into();
    }
    if args.json.json { say_json(&of(&entry)) } else { say(text) }
}

/// A table of materials, within 80 columns.
fn list(entries: &[Entry]) -> Shown {
    let or_unknown =
        |value: Option<f64>, decimals: usize| value.map_or(UNKNOWN.to_owned(), |value| format!("{value:.decimals$}"));
    let row = |entry: &Entry| {
        let cells = [
            entry.name.to_owned(),
            entry
                .stands_for
                .as_ref()
                .and_then(|stands| stands.grades.first())
                .map_or(UNKNOWN, |grade| grade)
                .to_owned(),
            format!("{:.0}", entry.proof_stress()),
            or_unknown(entry.tensile_strength(), 0),
            or_unknown(entry.uniform_elongation().map(|share| 100.0 * share), 0),
            entry.material.yield_criterion.ratio().to_string(),
            or_unknown(entry.n(), 3),
            or_unknown(entry.material.elastic.map(|elastic| 1e-3 * elastic.young), 0),
            entry.thickness.clone().unwrap_or(UNKNOWN.to_owned()).replace(" to ", "–"),
        ];
        cells.map(Cell::plain)
    };
    let headers = ["name", "grade", "Rp0.2", "Rm", "Ag", "r̄", "n", "E", "thickness"];
    let units = ["", "", "MPa", "MPa", "%", "–", "–", "GPa", ""].map(str::to_owned);
    let rows = [units.map(Cell::plain)].into_iter().chain(entries.iter().map(row)).collect();
    table(Some(headers), rows) + Shown::from(NOTES)
}

/// Everything that is known of a material, and the table to paste.
fn describe(entry: &Entry) -> Shown {
    let Entry { name, title, material, .. } = entry;
    let n = entry.n().map_or(UNKNOWN.to_owned(), |n| format!("{n:.4}, the uniform strain of the law"));
    let limit = entry.forming_limit().map_or(UNKNOWN.to_owned(), |curve| {
        format!("{:.4} in plane strain, true strain: computed from the law (Hill), not measured", curve.plane_strain())
    });
    let measured = entry.measured_limit.as_ref().map_or(UNKNOWN.to_owned(), |curve| {
        format!(
            "{:.3} in plane strain, true strain: measured; [forming_limit] measured = true takes them",
            curve.plane_strain()
        )
    });
    let elastic = material.elastic.map_or(UNKNOWN.to_owned(), |e| format!("{} MPa, {}", e.young, e.poisson));
    let stands = entry.stands_for.as_ref();
    let tested =
        entry.tensile_strength().zip(entry.uniform_elongation()).map_or(UNKNOWN.to_owned(), |(strength, ag)| {
            format!("{strength:.0} MPa, {:.1} %, at Considère's load maximum of the law", 100.0 * ag)
        });
    let known = [
        ("stands for", stands.map_or(UNKNOWN.to_owned(), |s| format!("{}; {}", s.grades.join(", "), s.because))),
        ("law", material.describe()),
        ("Rp0.2", format!("{:.0} MPa, the law's stress at a plastic strain of 0.2 %", entry.proof_stress())),
        ("Rm, Ag", tested),
        ("n", n),
        ("yields by", material.yield_criterion.to_string()),
        ("FLC", limit),
        ("FLC points", measured),
        ("E, ν", elastic),
        ("thickness", entry.thickness.clone().unwrap_or(UNKNOWN.to_owned())),
        ("scatter", entry.class.as_ref().map_or(UNKNOWN.to_owned(), of_class)),
        ("source", entry.source.clone()),
        ("read", entry.grade.clone() + grade(&entry.grade)),
        ("licence", entry.licence.clone()),
    ];
    let known = known.into_iter().chain(fitted(entry)).chain(entry.notes.iter().map(|note| ("note", note.clone())));
    let rows = known.map(|(label, value)| [Cell::plain(format!("  {label}")), Cell::plain(value)]);
    let paste = format!("\nIn a case:\n\n[material]\nname = \"{name}\"\n\nor all of it:\n\n{}", entry.text);
    Shown::from(format!("{name}: {title}\n\n")) + table(None, rows.collect()) + paste.into()
}

/// How much sheets of a class scatter.
fn of_class(class: &Class) -> String {
    let strength = class.strength().map(|[low, high]| format!("Rm {low} to {high} MPa ({})", class.source));
    let thickness = class.thickness.map(|standard| format!("thickness by {}", standard.source()));
    strength.into_iter().chain(thickness).collect::<Vec<_>>().join("; ")
}

/// What a grade means.
fn grade(grade: &str) -> &'static str {
    match grade {
        "A" => ", in that source",
        "B" => ", where that is quoted",
        _ => ", hardening assumed from another sheet",
    }
}

/// The range of the fit, how far the laws are from what they are fitted to, and the back-stresses, where they are known.
fn fitted(entry: &Entry) -> Vec<(&'static str, String)> {
    let Entry { material, measured, elastoplastic, .. } = entry;
    let mut rows = Vec::new();
    rows.extend(
        material.fitted_up_to.map(|end| ("fitted", format!("up to a true strain of {end}; a run beyond says so"))),
    );
    if let Some((measured, fit)) = measured.as_ref().and_then(|m| Some((m, m.fit(material)?))) {
        let Fit { points, rms, largest, at, range: [from, to] } = fit;
        let scatter = measured.points().map(|point| point.scatter).fold(0.0, f64::max);
        rows.push((
            "measured",
            format!(
                "{points} points from a strain of {from} to {to}: law less point {rms:.1} MPa rms, {largest:+.1} MPa at most, at \
                 {at}; their scatter is {scatter:.1} MPa at most. {}",
                measured.of
            ),
        ));
    }
    let rates = measured.as_ref().and_then(|m| Some((m.rates.as_ref()?, m.rate_fit(material)?)));
    if let Some((rates, Fit { points, rms, largest, at, range: [from, to] })) = rates {
        rows.push((
            "rates",
            format!(
                "{points} ratios from {from} to {to} /s: law less ratio {rms:.3} rms, {largest:+.3} at most, at {at} /s. {}",
                rates.of
            ),
        ));
    }
    rows.extend(elastoplastic.as_ref().map(|shifting| {
        let of = |law: &BackStress| format!("C {} MPa, γ {}", law.modulus, law.dynamic_recovery);
        let laws: Vec<String> = shifting.chaboche.iter().map(of).collect();
        ("back-stresses", format!("{}, in mode = \"elasto_viscoplastic\"", laws.join("; ")))
    }));
    rows
}

/// A fit for programs; strains have no unit, rates are in 1/s.
fn of_fit(fit: Fit) -> Value {
    json!({
        "points": fit.points,
        "rms": rounded(fit.rms),
        "largest": rounded(fit.largest),
        "at": fit.at,
        "from": fit.range[0],
        "to": fit.range[1],
    })
}

/// What the laws are fitted to, for programs: stresses in MPa, rates in 1/s.
fn of_measured(entry: &Entry) -> Option<Value> {
    let measured = entry.measured.as_ref()?;
    let points = measured.points().map(|point| [point.strain, point.stress, point.scatter]);
    Some(json!({
        "of": measured.of,
        "rate_1_per_s": measured.rate(),
        "strain_stress_scatter_MPa": points.collect::<Vec<_>>(),
        "fit_MPa": measured.fit(&entry.material).map(of_fit),
        "rate_and_ratio": measured.rates.as_ref().map(|rates| rates.ratios().into_iter().map(|(rate, ratio)| [rate, rounded(ratio)]).collect::<Vec<_>>()),
        "fit_of_ratios": measured.rate_fit(&entry.material).map(of_fit),
    }))
}

/// An entry for programs; the table to paste says the law with its units.
fn of(entry: &Entry) -> Value {
    json!({
        "name": entry.name,
        "title": entry.title,
        "stands_for": entry.stands_for.as_ref().map(|stands| json!({ "grades": stands.grades, "because": stands.because })),
        "proof_stress_MPa": rounded(entry.proof_stress()),
        "tensile_strength_MPa": entry.tensile_strength().map(rounded),
        "uniform_elongation": entry.uniform_elongation().map(rounded),
        "law": entry.material.describe(),
        "n": entry.n().map(rounded),
        "flc_measured": entry.measured_limit.as_ref().map(|curve| curve.points().to_vec()),
        "flc_computed_by_hill": entry.forming_limit().map(|curve| curve.points().to_vec()),
        "r": entry.material.yield_criterion.ratio(),
        "young_MPa": entry.material.elastic.map(|elastic| elastic.young),
        "poisson": entry.material.elastic.map(|elastic| elastic.poisson),
        "fitted_up_to": entry.material.fitted_up_to,
        "measured": of_measured(entry),
        "back_stresses": entry.elastoplastic.as_ref().map(|shifting| {
            let of = |law: &BackStress| json!({ "modulus_MPa": law.modulus, "recall": law.dynamic_recovery });
            shifting.chaboche.iter().map(of).collect::<Vec<_>>()
        }),
        "thickness": entry.thickness,
        "scatter": entry.class.as_ref().map(|class| {
            json!({
                "tensile_strength_MPa": class.strength(),
                "thickness": class.thickness.map(Standard::name),
                "source": class.source,
            })
        }),
        "source": entry.source,
        "grade": entry.grade,
        "licence": entry.licence,
        "notes": entry.notes,
        "case": entry.text,
    })
}

/// The flow curve, and the limits of the law where they can be computed.
fn chart(entry: &Entry) -> Chart {
    let groove = MarciniakKuczynski {
        imperfection: MarciniakKuczynski::IMPERFECTION,
        strain_rate: MarciniakKuczynski::STRAIN_RATE,
    };
    let mut notes = vec![format!("Source: {}.", entry.source)];
    let residuals = fitted(entry).into_iter().filter(|(label, _)| ["measured", "rates"].contains(label));
    notes.extend(residuals.map(|(label, said)| format!("Fit, {label}: {}.", said.trim_end_matches('.'))));
    notes.extend(entry.notes.iter().cloned());
    let mut limits: Vec<Curve> = entry.measured_limit.iter().cloned().collect();
    for kind in [Kind::Hill(Hill { n: None }), Kind::MarciniakKuczynski(groove)] {
        match kind.curve(&entry.sheet()) {
            Ok(curve) => {
                notes.extend(curve.notes.iter().map(ToString::to_string));
                limits.push(curve);
            }
            Err(error) => notes.push(format!("A forming limit is left out: {error}.")),
        }
    }
    let title = format!("{}: {}", entry.name, entry.title);
    flow_curve::chart(&title, &entry.material, entry.measured.as_ref(), &limits, notes)
}
