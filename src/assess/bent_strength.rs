//! What a sheet carries where noses and shoulders bend it.

use super::{Finding, Light, bending_radius::ADVICE, nose::nose, run::Run};
use crate::assess::design::{SHARP, THIN, bent_strength};
use crate::geometry::Arc;
use crate::model::{Role, Tool};
use crate::solver::solution::StageSolution;
use crate::table::Unit;
use crate::units::Amount;

/// A corner that the sheet is bent over as soon as the punch moves.
struct Corner {
    /// What it is called.
    name: &'static str,
    /// \[mm\]
    radius: f64,
    /// Of the blank \[mm\].
    thickness: f64,
    /// Of the stage, counted from 0.
    stage: usize,
}

impl Corner {
    fn ratio(&self) -> f64 {
        self.radius / self.thickness
    }
}

/// The sharpest of the punches' noses and the dies' shoulders, and the tension that the sheet carries over it.
///
/// # References
/// 4ming, Forming handbook, "Punch radius", equation 1 (4ming.de/en/forming-handbook/punch-radius): the nose ≥ 4 to 5
/// thicknesses. For the shoulder, and [`SHARP`], a declared rule of thumb; the strength is derived at [`bent_strength`].
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let corners = run.stages.iter().enumerate().flat_map(|(i, stage)| corners(stage, i));
    let sharpest = corners.min_by(|a, b| a.ratio().total_cmp(&b.ratio()))?;
    let ratio = sharpest.ratio();
    let light = match ratio {
        r if r < SHARP => Light::Red,
        r if r < THIN => Light::Amber,
        _ => Light::Green,
    };
    let share = bent_strength(ratio);
    let found = format!(
        "the sheet carries {share} of its strength over the {corner} of {radius}, {ratio}",
        share = Amount::share(share),
        corner = sharpest.name,
        radius = Amount::size(sharpest.radius),
        ratio = Amount::thicknesses(ratio)
    );
    let [asked, least] = [bent_strength(THIN), bent_strength(SHARP)];
    let limit = format!(
        "{asked} = ρ ln(1 + 1/ρ) at ρ = {thin}, red below {sharp}",
        asked = Amount::share(asked),
        thin = Amount::given_thicknesses(THIN),
        sharp = Amount::given_thicknesses(SHARP)
    );
    Some(
        Finding::judged("bent_strength", "Strength over radii", light, run.of_stage(found, sharpest.stage))
            .against(100.0 * share, Unit::Percent, limit)
            .at_least(100.0 * asked, 100.0 * least)
            .source("4ming, Forming handbook, Punch radius: 4 to 5 thicknesses; the share: equilibrium of a bent strip")
            .advice(ADVICE),
    )
}

/// The nose and the shoulder of a stage that forms.
fn corners(solved: &StageSolution, stage: usize) -> impl Iterator<Item = Corner> {
    let model = &solved.model;
    let formed = model.release.is_none() && !solved.steps.is_empty();
    let named = |role, name, corner: fn(&Tool) -> Option<Arc>| {
        let arc = model.tool(role).filter(|_| formed).and_then(corner)?;
        Some(Corner { name, radius: arc.radius, thickness: model.blank.thickness, stage })
    };
    [named(Role::Punch, "punch's nose", nose), named(Role::Die, "die's shoulder", shoulder)].into_iter().flatten()
}

/// The outermost corner of a die.
fn shoulder(die: &Tool) -> Option<Arc> {
    die.profile.corners().max_by(|a, b| a.center.x.total_cmp(&b.center.x))
}
