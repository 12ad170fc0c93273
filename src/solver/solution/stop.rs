//! Reasons for the end of a run.

use crate::model::ModelError;
use crate::units::{Amount, Unit};
use std::fmt;

/// Reason for the end of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The model cannot be solved.
    Refused(ModelError),
    /// The run has come to its end.
    FullTravel,
    /// The load has fallen from its maximum by the requested share.
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
    /// The requested share of the sheet lies on its tools.
    ContactShare {
        /// Reached \[–\].
        share: f64,
        /// Requested \[–\].
        asked: f64,
        /// Time then \[s\].
        time: f64,
        /// Punch travel then \[mm\].
        travel: f64,
    },
    /// The gas pressure is the largest that a free place of the sheet can bear.
    PressureMaximum {
        /// Pressure \[MPa\].
        pressure: f64,
        /// Height of that place above the flat blank \[mm\].
        height: f64,
        /// Initial distance of that place from the axis \[mm\].
        s0: f64,
    },
    /// A strip of membranes has no restraint.
    Mechanism {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Initial distance of the moving node from the symmetry plane \[mm\].
        s0: f64,
    },
    /// The sheet has left the punch as an arch and snaps through.
    Arched {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Distance of the sheet's middle ahead of the punch \[mm\].
        ahead: f64,
    },
    /// A neck: one place stretches while its surroundings have stopped.
    Localised {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Initial distance of the neck from the axis \[mm\].
        s0: f64,
        /// Thickness there over the initial one \[–\].
        share: f64,
        /// Location and cause in words.
        why: String,
    },
    /// Voids have coalesced through the thickness.
    Coalesced {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Initial distance from the axis \[mm\].
        s0: f64,
        /// Mean porosity over the thickness there \[–\].
        porosity: f64,
    },
    /// The blank's edge has passed the die's throat.
    DrawnThrough {
        /// Punch travel there \[mm\].
        travel: f64,
        /// True if the case requests it: then the rim has left the die's shoulder.
        wished: bool,
    },
    /// The holder has closed with its force.
    HolderClosed {
        /// Travel of the holder \[mm\].
        travel: f64,
    },
    /// Punch and die are too close for the sheet.
    ToolsClosed {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Distance of the closest place from the axis \[mm\].
        r: f64,
        /// Height of the closest place \[mm\].
        z: f64,
    },
    /// The observer ended the run.
    Interrupted {
        /// Punch travel reached \[mm\].
        travel: f64,
        /// Time reached \[s\].
        time: f64,
    },
    /// The run spent its budget of tries.
    Creeping {
        /// Punch travel of the last accepted step \[mm\].
        travel: f64,
        /// Time of the last accepted step \[s\].
        time: f64,
        /// Tries of steps, accepted or not.
        tries: usize,
        /// Length of the next step \[s\].
        step: f64,
        /// Initial distance of the worst place from the axis \[mm\].
        worst_s0: f64,
        /// State of the sheet there in words; may be empty.
        seen: String,
    },
    /// No equilibrium was found down to the smallest step.
    NoEquilibrium {
        /// Punch travel of the last accepted step \[mm\].
        travel: f64,
        /// Time of the last accepted step \[s\].
        time: f64,
        /// Smallest step that was tried \[s\].
        step: f64,
        /// Relative velocity increment of the last try \[–\].
        velocity_norm: f64,
        /// Relative residual of the last try \[–\].
        residual_norm: f64,
        /// Initial distance of the node with the largest residual from the axis \[mm\].
        worst_s0: f64,
        /// State of the sheet there and what to try.
        diagnosis: String,
    },
}

impl Stop {
    /// True if the run came to its requested end. A fallen load is a failure even if the case asks for it.
    pub fn is_complete(&self) -> bool {
        match self {
            Stop::FullTravel | Stop::ContactShare { .. } | Stop::HolderClosed { .. } => true,
            Stop::DrawnThrough { wished, .. } => *wished,
            _ => false,
        }
    }

    /// True if the sheet or the tools ended the run, not the numerics or the user.
    pub fn is_physical(&self) -> bool {
        let is_lost = matches!(
            self,
            Stop::Refused(_) | Stop::Interrupted { .. } | Stop::Creeping { .. } | Stop::NoEquilibrium { .. }
        );
        !self.is_complete() && !is_lost
    }

    /// Kind in a few words.
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

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (mm, share) = (|length: &f64| Amount::place(*length), |share: &f64| Amount::share(*share));
        let text = match self {
            Stop::Refused(why) => why.to_string(),
            Stop::FullTravel => "full travel reached".into(),
            Stop::LoadMaximum { travel, peak, unit, drop } => {
                let (travel, drop, peak) = (mm(travel), share(drop), Amount::force(*peak, *unit));
                format!("load maximum passed: at {travel} of travel the load is {drop} below its peak of {peak}")
            }
            Stop::ContactShare { share: reached_share, asked, time, travel } => {
                let (at, lies, asked) = (reached(*travel, *time), share(reached_share), Amount::given_share(*asked));
                format!("contact share reached: at {at} {lies} of the sheet lies on its tools ({asked} asked for)")
            }
            Stop::PressureMaximum { pressure, height, s0 } => {
                let (pressure, s0, height) = (Amount::stress(*pressure), mm(s0), mm(height));
                format!(
                    "pressure maximum reached: no equilibrium beyond {pressure}, where the sheet at s0 = {s0} is at a height \
                     of {height}; it would run away there, to burst or to fold"
                )
            }
            Stop::Mechanism { travel, s0 } => {
                let (travel, s0) = (mm(travel), mm(s0));
                format!(
                    "mechanism: at {travel} of travel nothing holds the strip of membranes; it gives way at s0 = {s0}"
                )
            }
            Stop::Arched { travel, ahead } => {
                let (travel, ahead) = (mm(travel), Amount::thickness(*ahead));
                format!(
                    "arched: at {travel} of travel the sheet's middle is {ahead} ahead of the punch, an arch that snaps through"
                )
            }
            Stop::Localised { travel, s0, share: left, why } => {
                let (travel, s0, left) = (mm(travel), mm(s0), share(left));
                format!(
                    "ended at {travel} of travel by a neck at s0 = {s0}, where {left} of its thickness is left; {why}"
                )
            }
            Stop::Coalesced { travel, s0, porosity } => {
                let (travel, s0, voids) = (mm(travel), mm(s0), share(porosity));
                format!(
                    "voids grown together at {travel} of travel: the sheet tears at s0 = {s0}, where {voids} of its volume \
                     are voids"
                )
            }
            Stop::DrawnThrough { travel, wished: false } => {
                format!("drawn through: the blank's edge has passed the die's throat at {} of travel", mm(travel))
            }
            Stop::DrawnThrough { travel, wished: true } => {
                let travel = mm(travel);
                format!(
                    "drawn through: at {travel} of travel the rim has left the die's shoulder: strip it off the punch"
                )
            }
            Stop::HolderClosed { travel } => format!("holder closed: it has reached its force after {}", mm(travel)),
            Stop::ToolsClosed { travel, r, z } => {
                let (travel, r, z) = (mm(travel), mm(r), mm(z));
                format!(
                    "tools closed: at {travel} of travel punch and die are half the sheet's thickness apart, near r = {r}, \
                     z = {z}"
                )
            }
            Stop::Interrupted { travel, time } => {
                format!("interrupted at {}: the results up to there are kept", reached(*travel, *time))
            }
            Stop::Creeping { travel, time, tries, step, worst_s0, seen } => {
                let (at, step, worst) = (reached(*travel, *time), Amount::time(*step), mm(worst_s0));
                let seen = if seen.is_empty() { String::new() } else { format!(": {seen}") };
                format!(
                    "creeping: {tries} tries of a step have come to {at}, the next would take {step}; worst at s0 = {worst}{seen}"
                )
            }
            Stop::NoEquilibrium { travel, time, step, velocity_norm, residual_norm, worst_s0, diagnosis } => {
                let (at, step, worst) = (reached(*travel, *time), Amount::time(*step), mm(worst_s0));
                let [velocity, residual] = [velocity_norm, residual_norm].map(|value| norm(*value));
                format!(
                    "no equilibrium found at {at} with steps down to {step} (velocity norm {velocity}, residual norm \
                     {residual}, worst at s0 = {worst}); {diagnosis}"
                )
            }
        };
        f.write_str(&text)
    }
}

/// Travel reached, or the time where there is no travel.
fn reached(travel: f64, time: f64) -> String {
    if travel > 0.0 { format!("{} of travel", Amount::place(travel)) } else { Amount::time(time).to_string() }
}

/// A norm, unless no whole increment was taken.
fn norm(value: f64) -> String {
    if value.is_finite() { Amount::norm(value).to_string() } else { "not known".into() }
}
