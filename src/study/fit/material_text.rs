//! `[material]` of a case from fitted laws.

use super::law_fit::{LawFit, LawFits};
use crate::material::rate::Rate;
use crate::units::{rounded, significant, trimmed};
use std::fmt::Write;

/// Poisson's ratio, which a tension test without a width does not give \[–\].
const POISSON: f64 = 0.3;
/// Moduli that are those of metals; another slope is that of the machine \[MPa\].
const METALS: std::ops::RangeInclusive<f64> = 40_000.0..=240_000.0;

/// Material table of a law: range, elastic line, rate law and r-values.
pub fn material_text(fits: &LawFits, law: &LawFit) -> String {
    let files: Vec<&str> = fits.tests.iter().map(|test| test.short_name()).collect();
    let end = rounded(fits.end());
    let source = format!(
        "fitted by stampflow to {}: {} up to a plastic strain of {}",
        files.join(", "),
        law.kind.label(),
        trimmed(end, 4)
    );
    let mut text = format!("[material]\nsource = {source:?}\n");
    let young = fits.fitted().find_map(|test| test.young.filter(|young| METALS.contains(young)));
    if let Some(young) = young {
        let _ = writeln!(
            text,
            "young = \"{} GPa\"\npoisson = {POISSON}                       # declared",
            trimmed(1e-3 * young, 1)
        );
    }
    let _ = writeln!(text, "fitted_up_to = {}", trimmed(end, 4));
    match (fits.r_values(), fits.directions.iter().find_map(|d| d.r)) {
        (Some([r0, r45, r90]), _) => {
            let [r0, r45, r90] = [r0, r45, r90].map(|r| trimmed(r, 3));
            let _ = writeln!(text, "anisotropy = {{ r0 = {r0}, r45 = {r45}, r90 = {r90} }}");
        }
        (None, Some(r)) => {
            let _ = writeln!(text, "anisotropy = {}                   # of one direction", trimmed(r, 3));
        }
        (None, None) => {}
    }
    let name = law.kind.name().replace('-', "_");
    let _ = writeln!(text, "\n[material.hardening.{name}]");
    for parameter in law.kind.parameters() {
        let error = law.estimate(parameter.key).and_then(|estimate| estimate.error);
        let error = error.map_or_else(String::new, |error| format!("    # ± {}", significant(error, 2)));
        let _ = writeln!(text, "{} = {}{error}", parameter.key, written(law, parameter.key));
    }
    let rate = |key| written(law, key);
    match law.rate {
        Some(Rate::PowerRate(power)) => {
            let _ = writeln!(
                text,
                "\n[material.rate.power]\nexponent = {}\nreference = \"{} /s\"",
                rate("rate.exponent"),
                power.reference
            );
        }
        Some(Rate::JohnsonCook(law)) => {
            let _ = writeln!(
                text,
                "\n[material.rate.johnson_cook]\ncoefficient = {}\nreference = \"{} /s\"",
                rate("rate.coefficient"),
                law.reference
            );
        }
        Some(Rate::CowperSymonds(_)) => {
            let _ = writeln!(
                text,
                "\n[material.rate.cowper_symonds]\nrate = {}\nexponent = {}",
                rate("rate.rate"),
                rate("rate.exponent")
            );
        }
        _ => {}
    }
    text
}

fn written(law: &LawFit, key: &str) -> String {
    let Some(estimate) = law.estimate(key) else { return String::new() };
    match estimate.unit.as_str() {
        "" => estimate.written(),
        unit => format!("\"{} {unit}\"", estimate.written()),
    }
}
