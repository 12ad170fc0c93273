//! What scatters where nothing is said: the friction of every tool, and of a sheet of the library thickness and strength, by
//! the standard of its class. All of it is declared.

use super::factor::STRENGTH;
use crate::case::Case;
use crate::units::Amount;

/// Coefficient of friction to either side \[–\]: what the verdict advises to try, for no lubricant is known better without a
/// test. Declared.
const FRICTION: f64 = 0.02;

/// Least friction over the case's own \[–\]: none is without. Declared.
const LEAST_FRICTION: f64 = 0.5;

/// Standard deviations from the middle of a standard's range of strength to its end. Declared: mills deliver most coils within.
const STRENGTH_DEVIATIONS: f64 = 2.0;

/// The same of thickness, which is rolled under control. Declared.
const THICKNESS_DEVIATIONS: f64 = 3.0;

/// What scatters, as `--vary` would have it, and what is told of it.
pub(super) struct Declared {
    pub vary: Vec<(String, String)>,
    pub told: Vec<String>,
}

impl Declared {
    /// Of a case.
    pub fn of(case: &Case) -> Self {
        let mut all = Self { vary: Vec::new(), told: Vec::new() };
        all.friction(case);
        all.sheet(case);
        all
    }

    fn friction(&mut self, case: &Case) {
        let tools = case.written("friction");
        let numbers: Vec<(String, f64)> = tools
            .iter()
            .filter_map(|(path, text)| Some((path.clone(), text.parse().ok().filter(|mu: &f64| *mu > 0.0)?)))
            .collect();
        let Some((_, first)) = numbers.first() else { return };
        let ends = |mu: f64| format!("uniform {}..{}", (mu - FRICTION).max(LEAST_FRICTION * mu), mu + FRICTION);
        if numbers.len() == tools.len() && numbers.iter().all(|(_, mu)| mu == first) {
            self.vary.push(("friction".into(), ends(*first)));
        } else {
            self.vary.extend(numbers.iter().map(|(path, mu)| (path.clone(), ends(*mu))));
        }
        self.told.push(format!("friction: uniform, {half} to either side of the case's own, declared: what no lubricant is known better than \
             without a test", half = Amount::number(FRICTION)));
    }

    fn sheet(&mut self, case: &Case) {
        let Some(sheet) = case.sheet() else {
            self.told.push(
                "strength and thickness are kept: the sheet is none of the library, whose classes have a scatter; give yours, \
                 --vary \"strength=normal ± 5 %\""
                    .into(),
            );
            return;
        };
        let Some(class) = sheet.class else {
            self.told.push(format!("strength and thickness are kept: the library has no scatter of {name}; give yours, --vary \"strength=normal ± 5 \
                 %\"", name = sheet.name));
            return;
        };
        let thickness = case.model().blank.thickness;
        if let Some((standard, tolerance)) = class.thickness.and_then(|by| Some((by, by.tolerance(thickness)?))) {
            let deviation = tolerance / THICKNESS_DEVIATIONS;
            let scatter = format!("normal {thickness} ± {deviation:.5} mm in ± {tolerance} mm");
            self.vary.push(("blank.thickness".into(), scatter));
            self.told.push(format!("thickness: normal, cut off at the tolerance of {tolerance}, which is declared to be {n} standard deviations; \
                 {source}", tolerance = Amount::size(tolerance), n = Amount::number(THICKNESS_DEVIATIONS), source = standard.source()));
        }
        if let (Some(share), Some([low, high])) = (class.strength_share(), class.strength()) {
            let deviation = share / STRENGTH_DEVIATIONS;
            self.vary.push((
                STRENGTH.into(),
                format!("normal 1 ± {deviation:.4} in {:.4}..{:.4}", 1.0 - share, 1.0 + share),
            ));
            self.told.push(format!("strength: all stresses of the hardening law together, normal about the sheet's own, as wide as {low} to {high}, \
                 of which each end is declared to be {n} standard deviations from the middle; {source}", low = Amount::given_stress(low), high = Amount::given_stress(high), n = Amount::number(STRENGTH_DEVIATIONS), source = class.source));
        }
    }
}
