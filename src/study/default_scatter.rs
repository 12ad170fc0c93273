//! Default distributions: friction of every tool; thickness and strength of a library sheet, by the standard of its class.

use super::uncertain_variable::STRENGTH;
use crate::case::Case;
use crate::units::Amount;

/// Half width of the friction coefficient \[–\]; declared.
const FRICTION: f64 = 0.02;
/// Least friction over the case's own \[–\]; declared.
const LEAST_FRICTION: f64 = 0.5;
/// Standard deviations from the middle of a standard's strength range to its end; declared.
const STRENGTH_DEVIATIONS: f64 = 2.0;
/// Standard deviations of a thickness tolerance; declared.
const THICKNESS_DEVIATIONS: f64 = 3.0;

/// Default `KEY=DISTRIBUTION` texts of a case, and notes on them.
pub(super) fn default_scatter(case: &Case) -> (Vec<String>, Vec<String>) {
    let (mut vary, mut notes) = friction(case);
    let Some((sheet, class)) = case.sheet().and_then(|sheet| Some((sheet.name, sheet.class?))) else {
        let note = "Strength and thickness do not scatter: the library has no tolerances of this sheet. Give yours, \
                    such as --vary \"strength=normal ± 5 %\".";
        notes.push(note.into());
        return (vary, notes);
    };
    let thickness = case.model().blank.thickness;
    if let Some((standard, tolerance)) = class.thickness.and_then(|by| Some((by, by.tolerance(thickness)?))) {
        let deviation = tolerance / THICKNESS_DEVIATIONS;
        vary.push(format!("blank.thickness=normal {thickness} ± {deviation:.5} mm in ± {tolerance} mm"));
        let (tolerance, source) = (Amount::size(tolerance), standard.source());
        notes.push(format!("Thickness: normal, tolerance {tolerance} at three standard deviations; {source}."));
    }
    if let (Some(share), Some([low, high])) = (class.strength_share(), class.strength()) {
        let deviation = share / STRENGTH_DEVIATIONS;
        vary.push(format!("{STRENGTH}=normal 1 ± {deviation:.4} in {:.4}..{:.4}", 1.0 - share, 1.0 + share));
        let ([low, high], source) = ([low, high].map(Amount::given_stress), class.source);
        notes.push(format!("Strength of {sheet}: normal, {low} to {high} at two standard deviations; {source}."));
    }
    (vary, notes)
}

fn friction(case: &Case) -> (Vec<String>, Vec<String>) {
    let tools = case.written("friction");
    let number = |text: &str| text.parse().ok().filter(|mu: &f64| *mu > 0.0);
    let numbers: Vec<(&str, f64)> =
        tools.iter().filter_map(|(path, text)| Some((path.as_str(), number(text)?))).collect();
    let Some((_, first)) = numbers.first() else { return Default::default() };
    let is_one = numbers.len() == tools.len() && numbers.iter().all(|(_, mu)| mu == first);
    let uniform = |&(key, mu): &(&str, f64)| {
        format!("{key}=uniform {}..{}", (mu - FRICTION).max(LEAST_FRICTION * mu), mu + FRICTION)
    };
    let vary = if is_one { vec![uniform(&("friction", *first))] } else { numbers.iter().map(uniform).collect() };
    (vary, vec![format!("Friction: uniform, ± {FRICTION} about the case's own (declared).")])
}
