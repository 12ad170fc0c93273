//! Why a run ended.

use crate::model::ModelError;
use crate::units::Unit;
use crate::units::{Amount, joined};

const REFUSED: &str = "refused";
const INTERRUPTED: &str = "interrupted";
const CREEPING: &str = "creeping";
const NO_EQUILIBRIUM: &str = "no equilibrium";

/// Kinds of ends that the numerics or the user made: they say nothing of the part.
pub const LOST: [&str; 4] = [REFUSED, INTERRUPTED, CREEPING, NO_EQUILIBRIUM];

/// Why a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The model is none that can be solved: nothing was tried.
    Refused(ModelError),
    /// The run has come to its end.
    FullTravel,
    /// The load has fallen from its maximum by the share that the case asks for.
    LoadMaximum {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Largest load before \[N, or N/mm\].
        peak: f64,
        /// Its unit.
        unit: Unit,
        /// Share of the peak by which the load has fallen \[–\].
        drop: f64,
    },
    /// As much of the sheet lies on its tools as the case asks for.
    ContactShare {
        /// Reached \[–\].
        share: f64,
        /// Asked for by the case \[–\].
        asked: f64,
        /// Time then \[s\].
        time: f64,
        /// Punch travel then \[mm\].
        travel: f64,
    },
    /// The gas pressure has come to the largest that a free place of the sheet can bear.
    PressureMaximum {
        /// The largest pressure \[MPa\].
        pressure: f64,
        /// Height of that place then above the flat blank, along the punch travel \[mm\].
        height: f64,
        /// Initial distance from the axis of that place \[mm\].
        s0: f64,
    },
    /// A strip of membranes that nothing holds: it bears no load.
    Mechanism {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Initial distance from the symmetry plane of the node that gives way \[mm\].
        s0: f64,
    },
    /// The sheet has left the punch as an arch that snaps through.
    Arched {
        /// Punch travel there \[mm\].
        travel: f64,
        /// How far the sheet's middle is ahead of the punch \[mm\].
        ahead: f64,
    },
    /// One place takes all the stretching while its surroundings stop.
    Localised {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Where, initially from the axis \[mm\].
        s0: f64,
        /// Thickness there over the initial one \[–\].
        share: f64,
        /// Where it is and why, in words.
        why: String,
    },
    /// The voids at a place have grown together through the thickness.
    Coalesced {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Where, initially from the axis \[mm\].
        s0: f64,
        /// Porosity there, mean over the thickness \[–\].
        porosity: f64,
    },
    /// The blank's edge has passed the die's throat.
    DrawnThrough {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Whether the case asks for it: then the rim has left the die's shoulder.
        wished: bool,
    },
    /// The holder has closed with its force.
    HolderClosed {
        /// How far it went \[mm\].
        travel: f64,
    },
    /// Punch and die come closer than the sheet can be squeezed.
    ToolsClosed {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Where they are too close: distance from the axis \[mm\].
        r: f64,
        /// Where they are too close: height \[mm\].
        z: f64,
    },
    /// An observer wanted no more of it.
    Interrupted {
        /// Punch travel reached \[mm\].
        travel: f64,
        /// Time reached \[s\].
        time: f64,
    },
    /// The run takes far more steps than it was meant to, and would not end in sensible time.
    Creeping {
        /// Punch travel of the last accepted step \[mm\].
        travel: f64,
        /// Time of the last accepted step \[s\].
        time: f64,
        /// Steps that were tried, accepted or not.
        tries: usize,
        /// Length of the next one \[s\].
        step: f64,
        /// Initial distance from the axis of the node with the largest residual in the last try that failed, or, where none
        /// did, of the place that strained most \[mm\].
        worst_s0: f64,
        /// What the sheet was doing there, in words; may be empty.
        seen: String,
    },
    /// No equilibrium was found down to the smallest step.
    NoEquilibrium {
        /// Punch travel of the last accepted step \[mm\].
        travel: f64,
        /// Time of the last accepted step \[s\].
        time: f64,
        /// The smallest step that was tried \[s\].
        step: f64,
        /// Relative velocity increment of the last try \[–\].
        velocity_norm: f64,
        /// Relative residual of the last try \[–\].
        residual_norm: f64,
        /// Initial distance from the axis of the node with the largest residual \[mm\].
        worst_s0: f64,
        /// What the sheet was doing there, and what to try.
        diagnosis: String,
    },
}

impl Stop {
    /// Whether the run came to the end it was asked for: its full travel or time, the contact that the part is done with, or
    /// the other side of the die. A fallen load is none, though a case may ask for it: the sheet has failed there.
    pub fn is_complete(&self) -> bool {
        match self {
            Stop::FullTravel | Stop::ContactShare { .. } | Stop::HolderClosed { .. } => true,
            Stop::DrawnThrough { wished, .. } => *wished,
            _ => false,
        }
    }

    /// Whether the sheet or the tools ended the run, not the numerics or the user.
    pub fn is_physical(&self) -> bool {
        let ours = matches!(
            self,
            Stop::Interrupted { .. } | Stop::NoEquilibrium { .. } | Stop::Creeping { .. } | Stop::Refused(_)
        );
        !self.is_complete() && !ours
    }

    /// The kind in a few words.
    pub fn kind(&self) -> &'static str {
        match self {
            Stop::Refused(_) => REFUSED,
            Stop::FullTravel => "full travel",
            Stop::LoadMaximum { .. } => "load maximum passed",
            Stop::ContactShare { .. } => "contact share reached",
            Stop::PressureMaximum { .. } => "pressure maximum reached",
            Stop::Mechanism { .. } => "mechanism",
            Stop::Arched { .. } => "arched",
            Stop::Localised { .. } => "localised",
            Stop::Coalesced { .. } => "voids coalesced",
            Stop::DrawnThrough { .. } => "drawn through",
            Stop::HolderClosed { .. } => "holder closed",
            Stop::ToolsClosed { .. } => "tools closed",
            Stop::Interrupted { .. } => INTERRUPTED,
            Stop::Creeping { .. } => CREEPING,
            Stop::NoEquilibrium { .. } => NO_EQUILIBRIUM,
        }
    }

    /// What happened, in a sentence.
    pub fn message(&self) -> String {
        let place = Amount::place;
        match self {
            Stop::Refused(why) => why.to_string().into(),
            Stop::FullTravel => "full travel reached".into(),
            Stop::LoadMaximum { travel, peak, unit, drop } => format!(
                "load maximum passed: at {travel} of travel the load is {drop} below its peak of {peak}",
                travel = place(*travel),
                drop = Amount::share(*drop),
                peak = Amount::force(*peak, *unit)
            ),
            Stop::ContactShare { share, asked, time, travel } => format!(
                "contact share reached: at {reached} {share} of the sheet lies on its tools ({asked} asked for)",
                reached = reached(*travel, *time),
                share = Amount::share(*share),
                asked = Amount::given_share(*asked)
            ),
            Stop::PressureMaximum { pressure, height, s0 } => format!(
                "pressure maximum reached: no equilibrium beyond {pressure}, where the sheet at s0 = {s0} is at a height of \
                 {height}; it would run away there, to burst or to fold",
                pressure = Amount::stress(*pressure),
                s0 = place(*s0),
                height = place(*height)
            ),
            Stop::Mechanism { travel, s0 } => format!(
                "mechanism: at {travel} of travel nothing holds the strip of membranes, which bears load by tension alone; it \
                 gives way at s0 = {s0}",
                travel = place(*travel),
                s0 = place(*s0)
            ),
            Stop::Arched { travel, ahead } => format!(
                "arched: at {travel} of travel the sheet's middle is {ahead} ahead of the punch, an arch that its legs push up \
                 and that snaps through",
                travel = place(*travel),
                ahead = Amount::thickness(*ahead)
            ),
            Stop::Localised { travel, s0, share, why } => format!(
                "ended at {travel} of travel by a neck at s0 = {s0}, where {left} of its thickness is left; {why}",
                travel = place(*travel),
                s0 = place(*s0),
                left = Amount::share(*share)
            ),
            Stop::Coalesced { travel, s0, porosity } => format!(
                "voids grown together at {travel} of travel: the sheet tears at s0 = {s0}, where {voids} of its volume are \
                 voids",
                travel = place(*travel),
                s0 = place(*s0),
                voids = Amount::share(*porosity)
            ),
            Stop::DrawnThrough { travel, wished: false } => format!(
                "drawn through: the blank's edge has passed the die's throat at {travel} of travel",
                travel = place(*travel)
            ),
            Stop::DrawnThrough { travel, wished: true } => format!(
                "drawn through: at {travel} of travel the rim has left the die's shoulder, the cup is through the die: strip it \
                 off the punch",
                travel = place(*travel)
            ),
            Stop::HolderClosed { travel } => {
                format!("holder closed: it has reached its force after {travel}", travel = place(*travel))
            }
            Stop::ToolsClosed { travel, r, z } => format!(
                "tools closed: at {travel} of travel punch and die come closer than half the sheet's thickness, near r = {r}, \
                 z = {z}",
                travel = place(*travel),
                r = place(*r),
                z = place(*z)
            ),
            Stop::Interrupted { travel, time } => format!(
                "interrupted at {reached}: what was computed up to there is kept, but the run has not come to its end",
                reached = reached(*travel, *time)
            ),
            Stop::Creeping { travel, time, tries, step, worst_s0, seen } => {
                let found = format!(
                    "creeping: {tries} tries of a step have come to {reached}, the next would take {step}; what holds it up is \
                     at s0 = {s0}",
                    tries = *tries,
                    reached = reached(*travel, *time),
                    step = Amount::time(*step),
                    s0 = place(*worst_s0)
                );
                joined([found, seen.clone()], ": ")
            }
            Stop::NoEquilibrium { travel, time, step, velocity_norm, residual_norm, worst_s0, diagnosis } => format!(
                "no equilibrium found at {reached} with steps down to {step} (velocity norm {velocity}, residual norm \
                 {residual}, worst at s0 = {s0}); {diagnosis}",
                reached = reached(*travel, *time),
                step = Amount::time(*step),
                velocity = norm(*velocity_norm),
                residual = norm(*residual_norm),
                s0 = place(*worst_s0)
            ),
        }
    }
}

/// How far a run has come: by its travel, or by its time where there is no travel.
fn reached(travel: f64, time: f64) -> String {
    match travel {
        travel if travel > 0.0 => format!("{travel} of travel", travel = Amount::place(travel)),
        _ => Amount::time(time).into(),
    }
}

/// A norm for readers; there is none where the corrector came to no whole increment.
fn norm(value: f64) -> String {
    if value.is_finite() { Amount::norm(value).into() } else { "not known".into() }
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.message().fmt(f)
    }
}
