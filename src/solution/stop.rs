//! Why a run ended.

use crate::model::ModelError;

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
            Stop::Refused(_) => "refused",
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
            Stop::Interrupted { .. } => "interrupted",
            Stop::Creeping { .. } => "creeping",
            Stop::NoEquilibrium { .. } => "no equilibrium",
        }
    }
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Stop::Refused(why) => write!(f, "{why}"),
            Stop::FullTravel => write!(f, "full travel reached"),
            Stop::LoadMaximum { travel, peak, drop } => write!(
                f,
                "load maximum passed: at {travel:.2} mm of travel the load is {:.1} % below its peak of {peak:.0}",
                100.0 * drop
            ),
            Stop::ContactShare { share, asked, time, travel } => {
                write!(
                    f,
                    "contact share reached: at {} {:.1} % of the sheet lies on its tools ({:.1} % asked for)",
                    place(*travel, *time, 2),
                    100.0 * share,
                    100.0 * asked
                )
            }
            Stop::PressureMaximum { pressure, height, s0 } => write!(
                f,
                "pressure maximum reached: no equilibrium beyond {pressure:.4} MPa, where the sheet at s0 = {s0:.1} mm is at a \
                 height of {height:.2} mm; it would run away there, to burst or to fold"
            ),
            Stop::Mechanism { travel, s0 } => write!(
                f,
                "mechanism: at {travel:.2} mm of travel nothing holds the strip of membranes, which bears load by tension \
                 alone; it gives way at s0 = {s0:.1} mm"
            ),
            Stop::Arched { travel, ahead } => write!(
                f,
                "arched: at {travel:.2} mm of travel the sheet's middle is {ahead:.2} mm ahead of the punch, an arch that its \
                 legs push up and that snaps through"
            ),
            Stop::Localised { travel, s0, share, why } => write!(
                f,
                "localised at {travel:.2} mm of travel: the sheet tears at s0 = {s0:.1} mm, where {:.0} % of its thickness \
                 is left; {why}",
                100.0 * share
            ),
            Stop::Coalesced { travel, s0, porosity } => write!(
                f,
                "voids coalesced at {travel:.2} mm of travel: the sheet tears at s0 = {s0:.1} mm, where {:.1} % of its volume \
                 are voids",
                100.0 * porosity
            ),
            Stop::DrawnThrough { travel, wished: false } => {
                write!(f, "drawn through: the blank's edge has passed the die's throat at {travel:.2} mm of travel")
            }
            Stop::DrawnThrough { travel, wished: true } => {
                write!(
                    f,
                    "drawn through: at {travel:.2} mm of travel the rim has left the die's shoulder, the cup is through the die: strip it \
                 off the punch"
                )
            }
            Stop::HolderClosed { travel } => {
                write!(f, "holder closed: it has reached its force after {travel:.2} mm")
            }
            Stop::ToolsClosed { travel, r, z } => write!(
                f,
                "travel limit by geometry: at {travel:.2} mm of travel punch and die come closer than half the sheet's \
                 thickness, near r = {r:.2} mm, z = {z:.2} mm"
            ),
            Stop::Interrupted { travel, time } => write!(
                f,
                "interrupted at {}: what was computed up to there is kept, but the run has not come to its end",
                place(*travel, *time, 2)
            ),
            Stop::Creeping { travel, time, tries, step, worst_s0, seen } => write!(
                f,
                "creeping: {tries} tries of a step have come to {}, the next would take {step:.2e} s; what holds it up is at \
                 s0 = {worst_s0:.2} mm{}{seen}",
                place(*travel, *time, 3),
                if seen.is_empty() { "" } else { ": " }
            ),
            Stop::NoEquilibrium { travel, time, step, velocity_norm, residual_norm, worst_s0, diagnosis } => write!(
                f,
                "no equilibrium found at {} with steps down to {step:.2e} s (velocity norm {}, residual norm {}, worst at s0 = \
                 {worst_s0:.2} mm); {diagnosis}",
                place(*travel, *time, 3),
                norm(*velocity_norm),
                norm(*residual_norm)
            ),
        }
    }
}

/// How far a run has come: by its travel, or by its time where there is no travel.
fn place(travel: f64, time: f64, decimals: usize) -> String {
    if travel > 0.0 { format!("{travel:.decimals$} mm of travel") } else { format!("{time:.4} s") }
}

/// A norm for readers; there is none where the corrector came to no whole increment.
fn norm(value: f64) -> String {
    if value.is_finite() { format!("{value:.1e}") } else { "not known".into() }
}
