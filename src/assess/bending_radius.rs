//! Whether the sheet is bent over radii that a thin shell follows.

use super::{Finding, Light, run::Run};
use crate::assess::design::{SHARP, THIN, bent_strength};
use crate::model::{Model, Theory, Tool};
use crate::table::Unit;
use crate::units::Amount;

/// What to change where a bend is sharp, and what a shell leaves out of it, of the radius R of its mid-surface.
pub(super) const ADVICE: &str = "larger radii; else take strains and spring-back there with care: the shell's normal stress is right to second order in t/R \
     only while the whole section is stretched, how the stress falls off through the thickness is not in it, nor that the \
     neutral fibre of a bend lies t²/8R inside the middle";

/// A tool's smallest radius over the thickness.
pub(super) fn small(model: &Model, tool: &Tool) -> Option<Finding> {
    let smallest = tool.profile.corners().min_by(|a, b| a.radius.total_cmp(&b.radius))?;
    let ratio = smallest.radius / model.blank.thickness;
    let what = match model.blank.theory {
        Theory::Bending | Theory::Selective => "beyond thin-shell theory",
        Theory::Membrane => "bending, which membrane theory leaves out, matters there",
    };
    (smallest.radius < THIN * model.blank.thickness).then(|| {
        let found = format!(
            "the {tool}'s radius of {radius} is {ratio}, over which the sheet carries {share} of its strength: {what}",
            tool = tool.role.name(),
            radius = Amount::size(smallest.radius),
            ratio = Amount::thicknesses(ratio),
            share = Amount::share(bent_strength(ratio))
        );
        Finding::warning("tool_radius", "Tool radius", found)
            .against(ratio, Unit::None, format!("{thin} at least", thin = Amount::given_thicknesses(THIN)))
            .at_least(THIN, None)
    })
}

/// Smallest bending radius of the mid-surface over the thickness.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let sharpest = run.largest(|step| step.sharpest_bend).filter(|sharpest| *sharpest > 0.0)?;
    let ratio = 1.0 / sharpest;
    let light = match ratio {
        r if r < SHARP => Light::Red,
        r if r < THIN => Light::Amber,
        _ => Light::Green,
    };
    let found = format!("{radius} at the sharpest", radius = Amount::thicknesses(ratio));
    Some(
        Finding::judged("bend_radius", "Bending radius", light, found)
            .against(
                ratio,
                Unit::None,
                format!(
                    "{thin} at least, red below {sharp}: thin-shell theory",
                    thin = Amount::given_thicknesses(THIN),
                    sharp = Amount::given_thicknesses(SHARP)
                ),
            )
            .at_least(THIN, SHARP)
            .advice(ADVICE),
    )
}
