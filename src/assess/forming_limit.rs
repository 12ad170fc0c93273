//! Distance to the forming limit.

use super::{tear::place, *};
use crate::case::file::YieldCondition;
use crate::forming_limit::{Assessment, Curve, Judged};
use crate::rules::THIN;

/// Share of the limit strain above which scatter of metal and process may reach it \[–\].
pub const CAREFUL: f64 = 0.9;
/// Tensile strength up to which steel bears an inside radius of its thickness \[MPa\].
const WEAK: f64 = 390.0;

pub(super) struct Nearest<'a> {
    pub curve: &'a Curve,
    pub stage: &'a StageSolution,
    pub assessment: Assessment,
}

impl<'a> Nearest<'a> {
    /// `None` without a forming limit.
    pub fn of(stages: &'a [StageSolution]) -> Option<Self> {
        let all = stages.iter().filter_map(|stage| {
            let curve = stage.model.forming_limit.as_ref()?;
            Some(Self { curve, stage, assessment: assess(curve, &stage.paths)? })
        });
        // A limit that is reached, or not known, comes before one that is near.
        all.min_by(|a, b| {
            let margin = |it: &Self| it.assessment.worst().margin();
            a.assessment.is_kept().cmp(&b.assessment.is_kept()).then(margin(a).total_cmp(&margin(b)))
        })
    }
}

/// Share of the forming limit that a run uses, in the stage that comes nearest to it.
pub struct Used {
    /// Initial distance from the axis of the place that the verdict judges \[mm\].
    pub worst: f64,
    /// Major strain over the limit's \[%\] over the initial distance from the axis \[mm\], from the axis outward.
    pub shares: Vec<(f64, f64)>,
}

/// Share of the forming limit; `None` without one.
pub fn used(stages: &[StageSolution]) -> Option<Used> {
    let Nearest { assessment, .. } = Nearest::of(stages)?;
    let shares = assessment.elements.iter().map(|judged| (judged.s0, 100.0 * judged.ratio()));
    Some(Used { worst: assessment.worst().s0, shares: shares.collect() })
}

fn judged(text: impl Into<String>) -> Finding {
    Finding::judged("forming_limit", "Forming limit", text)
}

pub(super) fn margin(run: &Run) -> Option<Finding> {
    let Some(Nearest { curve, stage, assessment, .. }) = &run.nearest else {
        let advice =
            "write `[forming_limit]` with points measured on the coil, or a computed curve such as hill = true";
        let limit = "a forming limit, which this case has not";
        return Some(judged("no forming limit").light(Light::Grey).limit(limit).advice(advice));
    };
    let name = if curve.is_usual { format!("{}, computed, not measured", curve.name) } else { curve.name.to_owned() };
    if let (Some(open), None) = (assessment.open(), assessment.reached) {
        return Some(unjudged(&name, open, &place(run.stages, open.s0)));
    }
    let worst = assessment.worst();
    let text = match assessment.reached {
        None => {
            let (at, margin) = (place(run.stages, worst.s0), Amount::ratio(worst.margin().abs()));
            format!("uses {{}} of the limit; {at}, {margin} of major true strain left")
        }
        Some(reached) => {
            let when = instant(stage, reached.travel, reached.time);
            format!("uses {{}} of the limit; first reached at {when}, {}", place(run.stages, reached.s0))
        }
    };
    let bend = run.largest(|step| step.sharpest_bend).unwrap_or(0.0);
    let faces = Amount::ratio((1.0 + 0.5 * bend).ln());
    let faces = (bend * THIN > 1.0).then(|| format!("of the mid-surface: bends strain the faces by up to {faces}"));
    let judged = judged(joined([text, faces.unwrap_or_default()], "; ")).number(Amount::share(worst.ratio()));
    let judged = judged.at_most(100.0 * CAREFUL, 100.0);
    let light = if assessment.reached.is_some() { Light::Red } else { judged.light.min(Light::Amber) };
    let source = match curve.is_usual {
        true => "declared: the case gives no curve, points of the coil replace it; the share is a rule of thumb",
        false => "the case's curve; the share is a declared rule of thumb",
    };
    Some(judged.light(light).limit(format!("below {}; of {name}", Amount::given_share(CAREFUL))).source(source))
}

/// Inside radius of the sharpest bend against the least of DIN 6935, about t for each 390 MPa of tensile strength (not read).
pub(super) fn bend(run: &Run) -> Option<Finding> {
    let bend = run.largest(|step| step.sharpest_bend).filter(|bend| *bend > 0.0 && run.fold.is_none())?;
    let least = (estimate::flange_strength(run.case.model()) / WEAK).max(1.0);
    let text = "bent to {} inside: cracks may open on the outer face, which the forming limit does not judge";
    let judged = Finding::judged("bend_radius", "Bend radius", text).number(Amount::thicknesses(1.0 / bend - 0.5));
    let judged =
        judged.at_least(least, None).source("1 t up to 390 MPa of tensile strength, in proportion above: declared");
    judged.advice("a larger radius, or a bending test of the coil").if_beyond()
}

fn unjudged(name: &str, open: &Judged, at: &str) -> Finding {
    let [major, minor, level] = [open.major, open.minor, open.limit].map(Amount::ratio);
    let text = format!(
        "not judged {at}: the curve ends before a minor strain of {minor}, at {level}, below the major strain of {major}"
    );
    let judged = judged(text).light(Light::Amber).limit(format!("{name}, which ends in plane strain"));
    let judged = judged.source("by Hill 1948 with r̄ below 1 limits of biaxial stretching come out too high");
    judged.advice(format!("{}, or give measured points of the coil in [forming_limit]", other_condition()))
}

pub(super) fn other_condition() -> String {
    format!("write {} in [material] (bcc for steel)", YieldCondition::FCC)
}
