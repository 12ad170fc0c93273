//! Events that explain kinks and jumps of a load curve.
//!
//! Events are exact to one step of the travel; the forming limit and the leaving of a tool are known more finely. A contact that
//! lasts from the start, or comes back before the sheet has gone a thickness away, is no event.

use crate::forming_limit;
use crate::model::{Edge, Model, Motion, Role};
use crate::solver::solution::{StageSolution, StepRecord, StopKind};

/// Gaps over the thickness above which the sheet is off a tool, and below which it is on it \[–\].
const OFF: f64 = 1.0;
const ON: f64 = 0.05;
/// Slope over that of the start where the die's shoulder begins, and slope of its throat \[rad\].
const STEEPER: f64 = 5.0 * std::f64::consts::PI / 180.0;
const UPRIGHT: f64 = std::f64::consts::FRAC_PI_2 - std::f64::consts::PI / 180.0;
/// Largest reduction that does not count as ironing \[–\].
const RUBBED: f64 = 1e-3;
/// Share of the holder's force on its blocks from which it rests on them \[–\].
const BORNE: f64 = 0.5;

/// Kind of event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum EventKind {
    /// The sheet's edge, which was off the die, comes to it.
    RimMeetsDie,
    /// The sheet's edge runs onto the die's shoulder: the flange is used up.
    RimOnShoulder,
    /// The sheet's edge enters the die's throat.
    RimInThroat,
    /// The sheet's middle comes to this tool.
    BottomMeets(Role),
    /// The sheet leaves this tool.
    SheetLeaves(Role),
    /// The holder comes to rest on its distance blocks.
    HolderOnBlocks,
    /// Punch and die begin to iron the sheet.
    IroningBegins,
    /// A place of the sheet reaches its forming limit.
    LimitReached,
    /// The sheet tears by a neck or by voids.
    Tears,
}

impl EventKind {
    /// Name in files.
    pub fn key(self, model: &Model) -> String {
        let (key, _, role) = self.names();
        key.to_owned() + &role.map_or("", |role| model.name_of(role)).replace(' ', "_")
    }

    /// Label in tables and on curves.
    pub fn label(self, model: &Model) -> String {
        let (_, label, role) = self.names();
        label.to_owned() + role.map_or("", |role| model.name_of(role))
    }

    /// Key and label, which end in the role.
    fn names(self) -> (&'static str, &'static str, Option<Role>) {
        match self {
            Self::RimMeetsDie => ("rim_meets_die", "rim meets the die", None),
            Self::RimOnShoulder => ("rim_on_shoulder", "rim runs onto the die's shoulder", None),
            Self::RimInThroat => ("rim_in_throat", "rim enters the die's throat", None),
            Self::BottomMeets(role) => ("bottom_meets_", "bottom meets the ", Some(role)),
            Self::SheetLeaves(role) => ("sheet_leaves_", "sheet leaves the ", Some(role)),
            Self::HolderOnBlocks => ("holder_on_blocks", "holder comes to rest on its distance blocks", None),
            Self::IroningBegins => ("ironing_begins", "ironing begins", None),
            Self::LimitReached => ("limit_reached", "forming limit reached", None),
            Self::Tears => ("tears", "sheet tears", None),
        }
    }
}

/// Event of a stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Kind.
    pub kind: EventKind,
    /// Punch travel of the stage \[mm\].
    pub travel: f64,
    /// Time of the stage \[s\].
    pub time: f64,
    /// Punch force of the whole part \[N, or N/mm of depth\].
    pub force: f64,
}

/// Events of a stage in the order of travel, the first of each kind; empty for a release.
pub fn events(stage: &StageSolution) -> Vec<Event> {
    let steps = &stage.steps[..];
    if stage.model.release.is_some() {
        return Vec::new();
    }
    let mut found = Vec::new();
    let mut at = |kind: EventKind, step: Option<&StepRecord>| {
        found.extend(step.map(|s| Event { kind, travel: s.travel, time: s.time, force: s.punch_force }));
    };
    let is_flat = stage.model.blank.meridian.is_none();
    if is_flat && stage.model.blank.edge == Edge::Free {
        let gap = |step: &StepRecord| step.edge_gap[Role::Die.index()];
        let near = |step: &StepRecord| gap(step) < OFF * stage.model.blank.thickness;
        // A rim off the die is on neither its shoulder nor in its throat, however steep the nearest place is.
        let first = steps.iter().find(|step| near(step)).map_or(0.0, |step| step.die_slope);
        let steeper = |step: &StepRecord, by: f64| step.die_slope > by && step.die_slope > first + STEEPER;
        let on_shoulder = steps.iter().position(|step| near(step) && steeper(step, STEEPER));
        at(EventKind::RimMeetsDie, comes(stage, gap));
        at(EventKind::RimOnShoulder, on_shoulder.map(|k| &steps[k]));
        at(EventKind::RimInThroat, on_shoulder.and_then(|k| steps[k..].iter().find(|step| steeper(step, UPRIGHT))));
    }
    for role in Role::ALL.into_iter().filter(|_| is_flat) {
        at(EventKind::BottomMeets(role), comes(stage, |step| step.middle_gap[role.index()]));
    }
    if stage.model.tools.iter().any(|tool| matches!(tool.motion, Motion::Pressed(_))) {
        at(EventKind::HolderOnBlocks, steps.iter().find(|step| rests_on_blocks(step)));
    }
    at(EventKind::IroningBegins, steps.iter().find(|step| step.ironing > RUBBED));
    if matches!(stage.stop.kind, StopKind::Localised | StopKind::Coalesced) {
        at(EventKind::Tears, steps.last());
    }
    for (tool, left) in stage.model.tools.iter().zip(&stage.left_at) {
        found.extend(left.map(|travel| between(steps, EventKind::SheetLeaves(tool.role), travel)));
    }
    let limit = stage.model.forming_limit.as_ref();
    let reached = limit.and_then(|curve| forming_limit::assess(curve, &stage.paths)?.reached);
    let at_limit = |travel| between(steps, EventKind::LimitReached, travel);
    found.extend(reached.map(|first| Event { time: first.time, ..at_limit(first.travel) }));
    found.sort_by(|a, b| a.travel.total_cmp(&b.travel).then(a.time.total_cmp(&b.time)));
    found
}

/// True if the holder rests on its blocks.
pub fn rests_on_blocks(step: &StepRecord) -> bool {
    step.block_force > BORNE * (step.block_force + step.holder_force)
}

/// First step with the sheet on a tool that it was off, by their gap \[mm\].
fn comes(stage: &StageSolution, gap: impl Fn(&StepRecord) -> f64) -> Option<&StepRecord> {
    let thickness = stage.model.blank.thickness;
    let off = stage.steps.iter().position(|step| gap(step) > OFF * thickness)?;
    stage.steps[off..].iter().find(|step| gap(step) < ON * thickness)
}

fn between(steps: &[StepRecord], kind: EventKind, travel: f64) -> Event {
    let after = steps.partition_point(|step| step.travel < travel).min(steps.len().saturating_sub(1));
    let now = steps.get(after).copied().unwrap_or_default();
    let before = after.checked_sub(1).map_or(StepRecord::default(), |before| steps[before]);
    let way = now.travel - before.travel;
    let share = if way > 0.0 { ((travel - before.travel) / way).clamp(0.0, 1.0) } else { 1.0 };
    let of = |from: f64, to: f64| from + share * (to - from);
    Event { kind, travel, time: of(before.time, now.time), force: of(before.punch_force, now.punch_force) }
}
