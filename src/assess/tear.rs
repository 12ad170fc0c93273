//! Thinning, necks and tears: their light, their place and their instant.

use super::estimate::{draw_ratio, tensile_strength};
use super::forming_limit::Nearest;
use super::{Finding, Light, Run, at_event, fracture};
use crate::geometry::Arc;
use crate::measure::place_on_part;
use crate::model::{Edge, Geometry, Role, Tool};
use crate::solver::solution::neck::{Neck, neck};
use crate::solver::solution::{StageSolution, StepRecord, StopKind};
use crate::units::{Amount, Unit, joined};
use std::f64::consts::PI;

/// Thinning from which a designer looks twice \[–\].
pub(super) const CAREFUL: f64 = 0.20;
/// Thinning that is refused unless a forming limit is kept \[–\].
const REFUSED: f64 = 0.30;
/// Thickness over the initial one below which a sheet that is not superplastic has torn \[–\].
const TORN: f64 = 0.5;

/// Largest thinning of the last stage. A forming limit that is kept, or a superplastic metal, allows more.
pub(super) fn thinning(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?.steps.last()?;
    let model = run.case.model();
    let thinning = 1.0 - last.thinnest / model.blank.thickness;
    let allowed = run.nearest.as_ref().is_some_and(Nearest::is_kept)
        || model.material.rate.is_some_and(|rate| rate.is_superplastic());
    let [careful, refused] = [CAREFUL, REFUSED].map(Amount::share);
    let refused = if allowed { String::new() } else { format!("at most {refused} unless a forming limit is kept") };
    Finding::judged("thinning", "Thinning", format!("{{}} at s0 = {}", Amount::place(last.thinnest_s0)))
        .number(Amount::share(thinning))
        .at_most(100.0 * CAREFUL, (!allowed).then_some(100.0 * REFUSED))
        .limit(joined([format!("below {careful}"), refused], ", "))
        .into()
}

/// Neck, or a sheet too thin to be whole.
pub(super) fn localisation(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    last.steps.last()?;
    let judged = |text: String| Finding::judged("localisation", "Neck", text);
    let finding = match (last.stop.kind, torn(last)) {
        (kind @ (StopKind::Localised | StopKind::Coalesced), _) => {
            judged(format!("it ended the run: {}", kind.name())).light(Light::Red)
        }
        (_, Some(Neck { s0, stands_out, share, .. })) => {
            let s0 = Amount::place(s0);
            let text = match stands_out {
                true => {
                    format!("it necks at s0 = {s0}, down to {{}} of the thickness; what follows depends on the mesh")
                }
                false => format!("the sheet is down to {{}} of its thickness at s0 = {s0}: it has torn before"),
            };
            judged(text).number(Amount::share(share)).light(Light::Red)
        }
        (_, None) => judged("none".into()),
    };
    Some(finding.limit("no place thins alone").source("the solver's watch for necks; declared thresholds"))
}

/// Thinnest place of a stage that has taken a step, if it is a neck or too thin to be whole.
pub(super) fn torn(stage: &StageSolution) -> Option<Neck> {
    let neck = neck(&stage.model, &stage.end, None);
    let superplastic = stage.model.material.rate.is_some_and(|rate| rate.is_superplastic());
    (neck.stands_out || neck.share < TORN && !superplastic).then_some(neck)
}

pub(super) struct Tear<'a> {
    stage: usize,
    on: &'a StageSolution,
    /// \[mm\]; `None` in a stage without travel.
    travel: Option<f64>,
    /// Initial distance from the axis or symmetry plane \[mm\].
    s0: Option<f64>,
}

/// Tear where the forming limit is first reached, else where the run ended by one.
pub(super) fn tear(stages: &[StageSolution]) -> Option<Tear<'_>> {
    let nearest = Nearest::of(stages);
    if let Some((nearest, reached)) = nearest.and_then(|nearest| nearest.assessment.reached.map(|it| (nearest, it))) {
        let travel = (nearest.stage.model.travel > 0.0).then_some(reached.travel);
        return Some(Tear { stage: nearest.index, on: nearest.stage, travel, s0: Some(reached.s0) });
    }
    stages.iter().enumerate().find_map(|(stage, on)| {
        let (travel, s0) = match on.stop.kind {
            StopKind::Localised | StopKind::Coalesced => (Some(on.end.travel), on.stop.s0),
            StopKind::LoadMaximum => (Some(on.end.travel), on.steps.last().map(|step| step.thinnest_s0)),
            StopKind::PressureMaximum => (None, on.stop.s0),
            _ => return None,
        };
        Some(Tear { stage, on, travel, s0 })
    })
}

impl Tear<'_> {
    /// `it tears in the wall, next to the punch radius, in stage 2, after 18.2 mm of 32.0 mm of travel`
    pub fn sentence(&self, stages: usize) -> String {
        let place = self.s0.map_or_else(String::new, |s0| on_part(self.on, s0));
        let stage = if stages > 1 { format!("in stage {}", self.stage + 1) } else { String::new() };
        let [travel, whole] = [self.travel.unwrap_or(0.0), self.on.model.travel].map(Amount::place);
        let instant = self.travel.map_or_else(String::new, |_| format!("after {travel} of {whole} of travel"));
        joined([joined(["it tears".into(), place], " "), stage, instant], ", ")
    }
}

/// Initial distance of a stage's tear from the axis \[mm\], also where the sheet is too thin to be whole.
pub fn tears_at(stage: &StageSolution) -> Option<f64> {
    stage.steps.last()?;
    let tear = tear(std::slice::from_ref(stage)).and_then(|tear| tear.s0);
    let broken = || fracture::reached(std::slice::from_ref(stage)).map(|(_, step)| step.damage_s0);
    tear.or_else(broken).or_else(|| torn(stage).map(|neck| neck.s0))
}

/// Location by its name on the part, as the last stage with a name has it, and on the flat blank.
pub(super) fn place(stages: &[StageSolution], s0: f64) -> String {
    let named = stages.iter().rev().find(|stage| place_on_part(stage, s0).is_some());
    named.or(stages.last()).map_or_else(String::new, |stage| on_part(stage, s0))
}

/// Location on a stage's sheet by its name on the part, and on the flat blank.
fn on_part(stage: &StageSolution, s0: f64) -> String {
    let from = match stage.model.geometry {
        Geometry::Axisymmetric => "from the axis on the flat blank",
        Geometry::PlaneStrain => "from the middle of the flat blank",
    };
    let blank = format!("{} {from}", Amount::place(s0));
    match place_on_part(stage, s0) {
        Some(place) => format!("{place} ({blank})"),
        None => blank,
    }
}

/// Tear-off factor a_R \[–\]: 1 for a metal and an edge that nothing is known of, 1.6 the largest measured.
const FACTORS: [f64; 2] = [1.0, 1.6];
/// Share of the force from which on it is near the limit \[–\].
const NEAR_TEARING: f64 = 0.9;

/// Peak punch force over what a wall carries past the punch's nose, π (d₁ + s₀) s₀ R_m. If the nose ends in a leaning wall,
/// d₁ is the diameter there, and of the wall's force the part along the axis counts.
///
/// For the stage of a flat-bottomed cup, drawn cold without gas, that comes nearest; other punches tear elsewhere.
///
/// # References
/// 4ming, Forming handbook, "Tearing force", equations 1 and 2 (4ming.de/en/forming-handbook/tearing-force):
/// F_BR = π (d₁ + s₀) s₀ R_m a_R with a_R = 1 … 1.6. The works that it quotes were not read.
pub(super) fn bottom<'a>(run: &Run<'a>) -> Option<Finding> {
    let share = |(peak, tears): (&'a StepRecord, f64)| (peak.punch_force / tears, (peak, tears));
    let (i, factor, (peak, tears)) = run.peak(|i, stage| forces(stage, i).map(share))?;
    let stage = &run.stages[i];
    let force = format!("punch force up to {}", Amount::force(peak.punch_force, Unit::N));
    let force = joined([force, at_event(stage, peak)], " ");
    let [near, least, most] = [NEAR_TEARING, FACTORS[0], FACTORS[1]].map(Amount::given_share);
    let limit = format!(
        "{} = π (d₁ + s₀) s₀ R_m at the end of the nose, near it from {near} on; between {least} and {most} it may or may not \
         tear",
        Amount::force(tears, Unit::N)
    );
    Finding::judged("bottom_tearing", "Bottom tearing", run.of_stage(format!("{force}, {{}} of the limit"), i))
        .number(Amount::share(factor))
        .at_most(100.0 * NEAR_TEARING * FACTORS[0], 100.0 * FACTORS[1])
        .limit(limit)
        .source("4ming, Forming handbook, Tearing force, eqs. 1 and 2")
        .into()
}

/// Step of a stage with the peak force, and the force that tears its wall off \[N\].
fn forces(solved: &StageSolution, stage: usize) -> Option<(&StepRecord, f64)> {
    let model = &solved.model;
    let cold = model.geometry == Geometry::Axisymmetric && model.heat.is_none() && model.gas.is_empty();
    let drawn = if stage == 0 { draw_ratio(model).is_some() } else { model.blank.edge == Edge::Free };
    let nose = NoseEnd::of(solved).filter(|_| cold && drawn && model.release.is_none())?;
    let thickness = model.blank.thickness;
    let tears = PI * (2.0 * nose.radius + thickness) * thickness * tensile_strength(&model.material) * nose.cosine;
    let peak = solved.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force))?;
    Some((peak, tears))
}

/// Cosine of a wall's lean up to which it counts as upright, to a degree.
const UPRIGHT: f64 = 0.9998;

#[derive(Clone, Copy, Debug)]
pub(super) struct NoseEnd {
    /// \[mm\]
    pub radius: f64,
    /// Cosine of the wall's lean to the axis \[–\].
    pub cosine: f64,
}

impl NoseEnd {
    /// `None` without a punch, and for one without a flat bottom as wide as the sheet is thick.
    pub fn of(stage: &StageSolution) -> Option<Self> {
        let nose = nose(stage.model.tool(Role::Punch)?)?;
        let end = [nose.at(0.0), nose.at(1.0)].into_iter().max_by(|a, b| a.x.total_cmp(&b.x))?;
        let flat = inner(&nose) > stage.model.blank.thickness;
        flat.then(|| Self { radius: end.x, cosine: (end.x - nose.center.x) / nose.radius })
    }

    /// Whether the wall above is upright.
    pub fn is_upright(self) -> bool {
        self.cosine > UPRIGHT
    }
}

pub(super) fn nose(punch: &Tool) -> Option<Arc> {
    punch.profile.corners().min_by(|a, b| inner(a).total_cmp(&inner(b)))
}

fn inner(arc: &Arc) -> f64 {
    arc.at(0.0).x.min(arc.at(1.0).x)
}
