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

/// Default `KEY=DISTRIBUTION` texts and notes on them.
pub(super) struct DefaultScatter {
    pub vary: Vec<String>,
    pub notes: Vec<String>,
}

impl DefaultScatter {
    pub fn new(case: &Case) -> Self {
        let mut all = Self { vary: Vec::new(), notes: Vec::new() };
        all.add_friction(case);
        all.add_sheet(case);
        all
    }

    fn add_friction(&mut self, case: &Case) {
        let tools = case.written("friction");
        let number = |text: &str| text.parse().ok().filter(|mu: &f64| *mu > 0.0);
        let numbers: Vec<(&str, f64)> =
            tools.iter().filter_map(|(path, text)| Some((path.as_str(), number(text)?))).collect();
        let Some((_, first)) = numbers.first() else { return };
        let uniform = |key: &str, mu: f64| {
            format!("{key}=uniform {}..{}", (mu - FRICTION).max(LEAST_FRICTION * mu), mu + FRICTION)
        };
        if numbers.len() == tools.len() && numbers.iter().all(|(_, mu)| mu == first) {
            self.vary.push(uniform("friction", *first));
        } else {
            self.vary.extend(numbers.iter().map(|(path, mu)| uniform(path, *mu)));
        }
        self.notes.push(format!("Friction: uniform, ± {FRICTION} about the case's own (declared)."));
    }

    fn add_sheet(&mut self, case: &Case) {
        let Some((sheet, class)) = case.sheet().and_then(|sheet| Some((sheet.name, sheet.class?))) else {
            let note = "Strength and thickness do not scatter: the library has no tolerances of this sheet. Give yours, \
                        such as --vary \"strength=normal ± 5 %\".";
            self.notes.push(note.into());
            return;
        };
        let thickness = case.model().blank.thickness;
        if let Some((standard, tolerance)) = class.thickness.and_then(|by| Some((by, by.tolerance(thickness)?))) {
            let deviation = tolerance / THICKNESS_DEVIATIONS;
            self.vary.push(format!("blank.thickness=normal {thickness} ± {deviation:.5} mm in ± {tolerance} mm"));
            let (tolerance, source) = (Amount::size(tolerance), standard.source());
            self.notes
                .push(format!("Thickness: normal, tolerance {tolerance} at three standard deviations; {source}."));
        }
        if let (Some(share), Some([low, high])) = (class.strength_share(), class.strength()) {
            let deviation = share / STRENGTH_DEVIATIONS;
            self.vary.push(format!("{STRENGTH}=normal 1 ± {deviation:.4} in {:.4}..{:.4}", 1.0 - share, 1.0 + share));
            let [low, high] = [low, high].map(Amount::given_stress);
            self.notes.push(format!(
                "Strength of {sheet}: normal, {low} to {high} at two standard deviations; {}.",
                class.source
            ));
        }
    }
}
