//! What a bent section does when its tools are taken away.

use super::{Finding, Light, run::Run};
use crate::measure::{Shape, changes};
use crate::model::{Geometry, Mode};
use crate::table::Unit;
use crate::units::four_digits;

/// The angles' changes of a stage that takes the tools away, which only the wanted part can judge; and of a section in plane
/// strain by the flow law, that there are none.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let (found, advice) = match last.released() {
        Some([before, after]) => (
            angles(&Shape::of(before), &Shape::of(after))?,
            "hold the angles after release against the part's tolerance, and bend as much further",
        ),
        None if last.model.geometry == Geometry::PlaneStrain && last.model.mode == Mode::Flow => (
            "not computed: the flow law has no elasticity".to_owned(),
            "[material] mode = \"elasto_viscoplastic\" with young and poisson, and a stage with release = true",
        ),
        None => return None,
    };
    Some(
        Finding::judged("springback", "Spring-back", Light::Grey, found)
            .limit("the part's tolerance, not in the case")
            .advice(advice),
    )
}

/// `wall to the punch direction 44.98° → 47.43°`; `None` where no angle was found.
fn angles(before: &Shape, after: &Shape) -> Option<String> {
    let said: Vec<String> = changes(before, after)
        .iter()
        .filter(|change| change.quantity.unit == Unit::Degree)
        .filter_map(|change| {
            let label = change.quantity.label;
            Some(format!("{label} {}° → {}°", four_digits(change.before?), four_digits(change.after?)))
        })
        .collect();
    (!said.is_empty()).then(|| said.join(", "))
}
