//! `[material]` of a case from fitted laws.

use super::estimate::Estimate;
use super::law_fit::{LawFit, LawFits};
use crate::material::rate::Rate;
use crate::units::{rounded, significant, trimmed};

/// Poisson's ratio, which a tension test without a width does not give \[–\].
const POISSON: f64 = 0.3;
/// Moduli of metals; another slope is that of the machine \[MPa\].
const METALS: std::ops::RangeInclusive<f64> = 40_000.0..=240_000.0;

/// Material table of a law: range, elastic line, rate law and r-values.
pub fn material_text(fits: &LawFits, law: &LawFit) -> String {
    let files: Vec<&str> = fits.tests.iter().map(|test| test.short_name()).collect();
    let (files, label, end) = (files.join(", "), law.kind.label(), trimmed(rounded(fits.end()), 4));
    let source = format!("fitted by stampflow to {files}: {label} up to a plastic strain of {end}");
    let mut lines = vec!["[material]".to_owned(), format!("source = {source:?}")];
    if let Some(young) = fits.fitted().find_map(|test| test.young.filter(|young| METALS.contains(young))) {
        lines.push(format!("young = \"{} GPa\"", trimmed(1e-3 * young, 1)));
        lines.push(format!("poisson = {POISSON}                       # declared"));
    }
    lines.push(format!("fitted_up_to = {end}"));
    match (fits.r_values(), fits.directions.iter().find_map(|d| d.r)) {
        (Some(r), _) => {
            let [r0, r45, r90] = r.map(|r| trimmed(r, 3));
            lines.push(format!("anisotropy = {{ r0 = {r0}, r45 = {r45}, r90 = {r90} }}"));
        }
        (None, Some((r, _))) => {
            lines.push(format!("anisotropy = {}                   # of one direction", trimmed(r, 3)));
        }
        (None, None) => {}
    }
    let (of_rate, own): (Vec<&Estimate>, Vec<_>) = law.estimates.iter().partition(|e| e.key.starts_with("rate."));
    lines.push(format!("\n[material.hardening.{}]", law.kind.name().replace('-', "_")));
    for estimate in own {
        let error = estimate.error.map_or_else(String::new, |error| format!("    # ± {}", significant(error, 2)));
        lines.push(format!("{} = {}{error}", estimate.key, quoted(estimate)));
    }
    let rate = match law.rate {
        Some(Rate::PowerRate(power)) => Some(("power", Some(power.reference))),
        Some(Rate::JohnsonCook(law)) => Some(("johnson_cook", Some(law.reference))),
        Some(Rate::CowperSymonds(_)) => Some(("cowper_symonds", None)),
        _ => None,
    };
    if let Some((name, reference)) = rate {
        lines.push(format!("\n[material.rate.{name}]"));
        lines.extend(of_rate.iter().map(|e| format!("{} = {}", e.key.trim_start_matches("rate."), quoted(e))));
        lines.extend(reference.map(|reference| format!("reference = \"{reference} /s\"")));
    }
    lines.join("\n") + "\n"
}

fn quoted(estimate: &Estimate) -> String {
    match estimate.unit.as_str() {
        "" => estimate.written(),
        unit => format!("\"{} {unit}\"", estimate.written()),
    }
}
