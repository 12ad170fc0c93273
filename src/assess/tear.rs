//! Thinning, necks and tears: their light, their place and their instant.

use super::*;
use crate::geometry::Arc;
use crate::measure::{bottom, element_at, place_on_part};
use crate::model::tool_sizes::embosses;

/// Thinning from which a designer looks twice \[–\].
pub(super) const CAREFUL: f64 = 0.20;
/// Thinning that is refused without a forming limit \[–\].
const REFUSED: f64 = 0.30;

pub(super) fn thinning(run: &Run) -> Option<Finding> {
    let (elements, model) = (&run.stages.last()?.frames.last()?.elements, run.case.model());
    let most = elements.iter().min_by(|a, b| a.strain_thickness.total_cmp(&b.strain_thickness))?;
    let thinning = -most.strain_thickness.exp_m1();
    let is_judged = run.nearest.as_ref().is_some_and(|nearest| nearest.assessment.open().is_none());
    let judge = match [is_judged, model.material.rate.is_some_and(|rate| rate.is_superplastic())] {
        [true, _] => "the forming limit judges",
        [_, true] => "a superplastic metal bears more than any rule of thumb: compare with your drawing",
        _ => "",
    };
    let text = joined(["{}".into(), place(run.stages, most.s0), judge.into()], "; ");
    let finding = Finding::judged("thinning", "Thinning", text).number(Amount::share(thinning));
    let [careful, refused] = [CAREFUL, REFUSED].map(Amount::share);
    let limit = format!("below {careful}; at most {refused} without a forming limit");
    Some(match judge {
        "" => finding.at_most(careful.value, refused.value).limit(limit),
        _ => finding.limit("none but the forming limit"),
    })
}

pub(super) fn localisation(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    last.steps.last()?;
    let judged = |text: String| Finding::judged("localisation", "Neck", text);
    let finding = match (last.stop.kind, run.stages.iter().find_map(|stage| stage.neck)) {
        (kind @ (StopKind::Localised | StopKind::Coalesced), _) => {
            judged(format!("it ended the run: {}", kind.name())).light(Light::Red)
        }
        (_, Some(neck)) => {
            let (at, when) = (place(run.stages, neck.s0), instant(last, neck.travel, neck.time));
            let text = format!("it necks {at}, after {when}; what follows depends on the mesh");
            judged(text).light(Light::Red)
        }
        (_, None) => judged("none".into()),
    };
    let source = "one place goes on thinning where its neighbours have stopped; declared thresholds";
    Some(finding.limit("no neck").source(source))
}

/// Tearing index from which scatter of sheet and friction may tear it, and at which it tears \[–\].
pub(super) const TEARING: [f64; 2] = [0.9, 1.0];

pub(super) fn remedy(model: &Model) -> &'static str {
    match (estimate::draw_ratio(model), model.tool(Role::Holder)) {
        _ if estimate::has_land(model) => "one ring more, or a thicker wall",
        _ if model.blank.is_open() => "less widening, larger radii, or less friction",
        _ if model.geometry == Geometry::PlaneStrain && model.blank.edge != Edge::Free => {
            "less stretch, a shallower part, or larger radii"
        }
        _ if !model.beads.is_empty() => {
            "lower beads or larger radii of theirs; then larger radii of punch and die, less friction"
        }
        (Some(_), Some(_)) => "one draw more, larger radii, or less friction of die and holder",
        (Some(_), None) => "one draw more, larger radii, or less friction of the die",
        (None, Some(_)) => "less holder force, larger radii, or less friction of die and holder",
        (None, None) => "a shallower part, larger radii, or less friction",
    }
}

/// Largest meridional force of all stages over the one at which the place tears; see `solver::tearing_index`.
///
/// A sheet whose edge is held is stretched by the travel, whose limit is a strain: near its load maximum the force hardly rises.
pub(super) fn tearing(run: &Run) -> Option<Finding> {
    let (i, _, step) = run.peak(|_, stage| {
        let step = stage.steps.iter().max_by(|a, b| a.tearing_index.total_cmp(&b.tearing_index))?;
        Some((step.tearing_index, step))
    })?;
    let stage = &run.stages[i];
    let model = &stage.model;
    // What comes after a tear is another sheet.
    let first = stage.steps.iter().find(|step| step.tearing_index > TEARING[1]);
    let (step, lead) = first.map_or((step, ""), |first| (first, "it tears "));
    let [carries, bears] = step.tearing_forces.map(|force| Amount::force(force, Unit::NPerMm));
    let place = on_part(stage, step.tearing_s0);
    let instant =
        if model.travel > 0.0 { format!(", after {} of travel", Amount::place(step.travel)) } else { String::new() };
    let text = format!("{{}} of what it bears; {lead}{place}{instant}: {carries} of {bears}");
    let [near, tears] = TEARING.map(|limit| 100.0 * limit);
    let near = if model.blank.edge == Edge::Free { near } else { tears };
    let judged = Finding::judged("tearing", "Tearing", run.of_stage(text, i)).number(Amount::share(step.tearing_index));
    let mut judged = judged.at_most(near, tears).advice(remedy(model));
    if model.blank.edge != Edge::Free && model.forming_limit.is_some() && judged.light == Light::Green {
        judged = judged.passed("100 % at most; short of it the forming limit judges a held sheet");
    }
    let judged = judged.source("Considère in plane strain, bent over the punch; 90 %: declared");
    (step.tearing_index > 0.0).then_some(judged)
}

pub(super) struct Tear<'a> {
    stage: usize,
    on: &'a StageSolution,
    /// Time \[s\] and travel \[mm\].
    instant: [f64; 2],
    /// Initial distance from the axis or symmetry plane \[mm\].
    s0: Option<f64>,
    verb: &'static str,
}

pub(super) fn tear(stages: &[StageSolution]) -> Option<Tear<'_>> {
    let mut tears = formed(stages).filter_map(|(stage, on)| {
        let event = |verb, instant, s0| Tear { stage, on, instant, s0, verb };
        let at = |verb, step: &StepRecord, s0| event(verb, [step.time, step.travel], Some(s0));
        let curve = on.model.forming_limit.as_ref();
        let reached = curve.and_then(|curve| assess(curve, &on.paths)?.reached);
        let all = [
            fracture::reached(on).map(|step| at("breaks", step, step.damage_s0)),
            edge::reached(on).map(|instant| event("cracks at the edge of its hole", instant, None)),
            reached.map(|limit| event("tears", [limit.time, limit.travel], Some(limit.s0))),
            on.steps.iter().find(|step| step.tearing_index > TEARING[1]).map(|step| at("tears", step, step.tearing_s0)),
            on.neck.map(|neck| event("tears", [neck.time, neck.travel], Some(neck.s0))),
            match on.stop.kind {
                StopKind::Localised | StopKind::Coalesced | StopKind::PressureMaximum => Some(on.stop.s0),
                StopKind::LoadMaximum => Some(on.steps.last().map(|step| step.thinnest_s0)),
                _ => None,
            }
            .map(|s0| event("tears", [on.end.time, on.end.travel], s0)),
        ];
        all.into_iter().flatten().min_by(|a, b| a.instant[0].total_cmp(&b.instant[0]))
    });
    tears.next()
}

impl Tear<'_> {
    /// `time` \[s\]
    pub fn is_before(&self, stage: usize, time: f64) -> bool {
        (self.stage, self.instant[0]) < (stage, time)
    }

    /// `it tears in the wall, next to the punch radius, in stage 2, after 18.2 mm of 32.0 mm of travel`
    pub fn sentence(&self, stages: usize) -> String {
        let place = self.s0.map_or_else(String::new, |s0| on_part(self.on, s0));
        let stage = if stages > 1 { format!("in stage {}", self.stage + 1) } else { String::new() };
        let [travel, all] = [self.instant[1], self.on.model.travel].map(Amount::place);
        let at = if self.on.model.travel > 0.0 { format!("after {travel} of {all} of travel") } else { String::new() };
        joined([joined([format!("it {}", self.verb), place], " "), stage, at], ", ")
    }
}

/// Initial distance of a stage's tear from the axis \[mm\].
pub fn tears_at(stage: &StageSolution) -> Option<f64> {
    tear(std::slice::from_ref(stage))?.s0
}

pub(super) fn place(stages: &[StageSolution], s0: f64) -> String {
    let named = stages.iter().rev().find(|stage| place_on_part(stage, s0).is_some());
    named.or(stages.last()).map_or_else(String::new, |stage| on_part(stage, s0))
}

fn on_part(stage: &StageSolution, s0: f64) -> String {
    let from = worded(stage.model.geometry, "axis", "middle");
    let at = stage.frames.last().and_then(|frame| {
        let element = &frame.elements[element_at(frame, s0)?];
        Some((element.r, Some(bottom(frame)? - element.z).filter(|above| *above > element.thickness)))
    });
    let (r, above) = at.unwrap_or((s0, None));
    let above = above.filter(|_| stage.model.tool(Role::Punch).is_some());
    let end = match stage.model.blank.is_open() {
        true => "from the far end",
        false if embosses(&stage.model) => "below the boss",
        false => "above the bottom",
    };
    let above = above.map_or_else(String::new, |above| format!("{} {end}", Amount::place(above)));
    let measures = joined([format!("{} from the {from}", Amount::place(r)), above], ", ");
    place_on_part(stage, s0).map_or_else(|| measures.clone(), |place| format!("{place} ({measures})"))
}

const UPRIGHT: f64 = 0.9998;
const LEVEL: f64 = 0.342;

/// Nose of a punch, its innermost corner that begins level, and whether it ends in an upright wall.
pub(super) fn nose(stage: &StageSolution) -> Option<(Arc, bool)> {
    let inner = |arc: &Arc| arc.at(0.0).x.min(arc.at(1.0).x);
    let outward = |arc: &Arc, x: f64| (x - arc.center.x) / arc.radius;
    let corners = stage.model.tool(Role::Punch)?.profile.corners();
    let corners =
        corners.filter(|arc| inner(arc) > stage.model.blank.thickness && outward(arc, inner(arc)).abs() < LEVEL);
    let nose = corners.min_by(|a, b| inner(a).total_cmp(&inner(b)))?;
    Some((nose, outward(&nose, nose.at(0.0).x.max(nose.at(1.0).x)) > UPRIGHT))
}
