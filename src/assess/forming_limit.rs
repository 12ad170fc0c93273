//! How near the sheet comes to its forming limit.

use super::nearest::Nearest;
use super::{Finding, Light, run::Run, thinning};
use crate::assess::design::THIN;
use crate::case::file::YieldCondition;
use crate::forming_limit::{CROOKED, Judged};
use crate::solver::solution::StageSolution;
use crate::table::Unit;
use crate::units::{Amount, joined};

/// Share of the limit strain above which scatter of metal and process may reach it \[–\].
pub const CAREFUL: f64 = 0.9;

/// Share of the limit that a path which is not straight may use: its own limit may be far lower \[–\].
const BENT: f64 = 0.5;

/// How much of the forming limit a run uses, of the stage that comes nearest to it.
pub struct Used {
    /// Initial distance from the axis of the place that the verdict judges \[mm\].
    pub worst: f64,
    /// Major strain over the limit's \[%\] over the initial distance from the axis \[mm\], from the axis outward.
    pub shares: Vec<(f64, f64)>,
}

/// Of solved stages; `None` without a limit.
pub fn used(stages: &[StageSolution]) -> Option<Used> {
    let Nearest { assessment, .. } = Nearest::of(stages)?;
    let shares = assessment.elements.iter().map(|judged| (judged.s0, 100.0 * judged.ratio()));
    Some(Used { worst: assessment.worst().s0, shares: shares.collect() })
}

/// The least margin, where, and when the limit was first reached; not judged where no limit is given.
pub(super) fn margin(run: &Run) -> Option<Finding> {
    let Some(Nearest { name, stage, assessment }) = &run.nearest else { return Some(missing()) };
    let worst = assessment.worst();
    let bend = run.largest(|step| step.sharpest_bend).unwrap_or(0.0);
    let open = assessment.open();
    let light = match assessment.reached {
        Some(_) => Light::Red,
        None if open.is_some() => Light::Amber,
        None => Light::within(worst.ratio(), CAREFUL),
    };
    // What speaks against the bend itself is said by its radius.
    let faces = (bend * THIN > 1.0).then(|| {
        let strain = Amount::strain((1.0 + 0.5 * bend).ln());
        format!("of the mid-surface: bends strain the faces by up to {strain}")
    });
    let reached = assessment.reached.map(|reached| {
        let when = match stage.model.travel > 0.0 {
            true => format!("{travel} of travel", travel = Amount::place(reached.travel)),
            false => Amount::time(reached.time).into(),
        };
        format!("first reached at {when}, s0 = {s0}", s0 = Amount::place(reached.s0))
    });
    if let (Some(open), None) = (open, assessment.reached) {
        return Some(unjudged(name, open, light));
    }
    let (used, s0) = (Amount::share(worst.ratio()), Amount::place(worst.s0));
    let margin = Amount::strain(worst.margin().abs());
    let used = match worst.margin() < 0.0 {
        true => format!("uses {used} of the limit at s0 = {s0}, {margin} of major true strain beyond it"),
        false => format!("uses {used} of the limit at s0 = {s0}, {margin} of major true strain left"),
    };
    let found = joined([Some(used), reached, faces].into_iter().flatten(), "; ");
    let limit =
        format!("{curve}: not reached, below {share} of it", curve = *name, share = Amount::given_share(CAREFUL));
    Some(
        Finding::judged("forming_limit", "Forming limit", light, found)
            .against(100.0 * worst.ratio(), Unit::Percent, limit)
            .at_most(100.0 * CAREFUL, 100.0)
            .source("the case's curve; the share is a declared rule of thumb")
            .advice(thinning::advice(run, stage, worst.s0)),
    )
}

/// A place that is strained more than anywhere the curve ends: there it may be whole or torn, and no rule that a kept limit
/// lets off is let off.
fn unjudged(name: &'static str, open: &Judged, light: Light) -> Finding {
    let [major, minor, level] = [open.major, open.minor, open.limit].map(Amount::strain);
    let found = format!(
        "not judged at s0 = {s0}: the curve ends before a minor strain of {minor}, and its end, {level}, is below the major \
         strain of {major}",
        s0 = Amount::place(open.s0)
    );
    Finding::judged("forming_limit", "Forming limit", light, found)
        .limit(format!("{name}, which ends in plane strain"))
        .source("by Hill 1948 with r̄ below 1 limits of biaxial stretching come out too high")
        .advice(joined([other_condition(), "or give measured points of the coil in [forming_limit]".into()], ", "))
}

/// What to write where Hill's condition says too little.
pub(super) fn other_condition() -> String {
    format!("write {line} in [material] (bcc for steel)", line = YieldCondition::FCC)
}

fn missing() -> Finding {
    Finding::judged("forming_limit", "Forming limit", Light::Grey, "no forming limit given")
        .limit("the strains are held against one")
        .advice("write [forming_limit] with hill = true (computed from the law), or the measured points of the coil")
}

/// Whether the curve can be taken at its word: it holds for straight strain paths.
pub(super) fn path(run: &Run) -> Option<Finding> {
    let assessment = &run.nearest.as_ref()?.assessment;
    let crooked = assessment.crooked();
    let used = assessment.elements.iter().filter(|judged| judged.is_crooked()).map(Judged::ratio).fold(0.0, f64::max);
    let found = match crooked {
        0 => "all straight".into(),
        n => format!(
            "{n} of {all} elements not straight, they use up to {used} of the limit",
            all = assessment.elements.len(),
            used = Amount::share(used)
        ),
    };
    let limit = format!(
        "within {crooked} of a straight line, or below {bent} of the limit",
        crooked = Amount::given_share(CROOKED),
        bent = Amount::given_share(BENT)
    );
    Some(
        Finding::judged("strain_paths", "Strain paths", Light::within(used, BENT), found)
            .against(100.0 * used, Unit::Percent, limit)
            .at_most(100.0 * BENT, None)
            .source("limit curves are measured on straight paths; the shares are declared rules of thumb")
            .advice("keep more margin there: look at strain_paths.csv of `run`"),
    )
}
