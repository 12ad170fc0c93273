//! Whether two tools press on the sheet at once, which a shell does not feel as a solid does.

use super::run::{Run, largest};
use super::{Finding, Light};
use crate::solution::StageSolution;
use crate::table::Unit;

/// Share of the thickness by which the sheet is too thick for its gap from which it is ironed, and ironed in earnest, which no
/// shell describes \[–\].
const IRONED: f64 = 0.01;
const REFUSED: f64 = 0.1;

/// By how much the sheet was too thick for its gap.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let ironing = run.largest(|step| step.ironing)?;
    let light = Light::of(ironing, [IRONED, REFUSED]);
    let first = run.steps().find(|step| step.ironing > IRONED);
    let from = first.map_or(String::new(), |step| format!(", from {:.2} mm of travel", step.travel));
    let found = format!("thicker than its gap by up to {:.1} %{from}", 100.0 * ironing);
    Some(
        Finding::judged("ironing", "Ironing", light, found)
            .against(
                100.0 * ironing,
                Unit::Percent,
                format!("{:.0} %, refused above {:.0} %: a shell is not ironed", 100.0 * IRONED, 100.0 * REFUSED),
            )
            .advice("a clearance of t √β, the thickness of the rim (4ming), or forces there as an indication only"),
    )
}

/// From where on the sheet was ironed in a stage, and by how much.
pub(super) fn begins(stage: &StageSolution) -> Option<Finding> {
    let first = stage.steps.iter().find(|step| step.ironing > IRONED)?;
    let ironing = 100.0 * largest(stage, |step| step.ironing);
    let found = format!(
        "ironing from {:.2} mm of travel: the sheet is up to {ironing:.1} % thicker than the gap between two tools; it is \
         pressed with a stiffness of {:.0} MPa over half its thickness on either face and not thinned by it, so forces there \
         are an indication only",
        first.travel, stage.model.settings.contact_stiffness
    );
    let limit = format!("{:.0} %", 100.0 * IRONED);
    Some(Finding::warning("ironed", "Ironing", found).against(ironing, Unit::Percent, limit))
}
