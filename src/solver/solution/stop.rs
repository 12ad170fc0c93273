//! End of a run.

use std::fmt;

/// Kind of end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopKind {
    /// The model cannot be solved.
    Refused,
    /// The run has come to its end.
    FullTravel,
    /// The load has fallen from its maximum by the requested share.
    LoadMaximum,
    /// The requested share of the sheet lies on its tools.
    ContactShare,
    /// The gas pressure is the largest that a free place of the sheet can bear.
    PressureMaximum,
    /// A strip of membranes has no restraint.
    Mechanism,
    /// The sheet has left the punch as an arch and snaps through.
    Arched,
    /// A neck: one place stretches while its surroundings have stopped.
    Localised,
    /// Voids have coalesced through the thickness.
    Coalesced,
    /// The hole's edge has come to its limit of expansion.
    EdgeLimit,
    /// The blank's edge has passed the die's throat.
    DrawnThrough,
    /// The rim has left the die's shoulder, as the case requests.
    LeftDie,
    /// The holder has closed with its force.
    HolderClosed,
    /// Punch and die are too close for the sheet, or squeeze it beyond any equilibrium.
    ToolsClosed,
    /// The observer ended the run.
    Interrupted,
    /// The run spent its budget of tries.
    Creeping,
    /// No equilibrium was found down to the smallest step.
    NoEquilibrium,
}

impl StopKind {
    /// Name in a few words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Refused => "refused",
            Self::FullTravel => "full travel",
            Self::LoadMaximum => "load maximum passed",
            Self::ContactShare => "contact share reached",
            Self::PressureMaximum => "pressure maximum reached",
            Self::Mechanism => "mechanism",
            Self::Arched => "arched",
            Self::Localised => "localised",
            Self::Coalesced => "voids coalesced",
            Self::EdgeLimit => "edge cracked",
            Self::DrawnThrough | Self::LeftDie => "drawn through",
            Self::HolderClosed => "holder closed",
            Self::ToolsClosed => "tools closed",
            Self::Interrupted => "interrupted",
            Self::Creeping => "creeping",
            Self::NoEquilibrium => "no equilibrium",
        }
    }
}

/// Reason for the end of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// Kind.
    pub kind: StopKind,
    /// Initial distance of the deciding place from the axis \[mm\]; `None` where no single place decides.
    pub s0: Option<f64>,
    /// Place, amount and remedy in words.
    pub text: String,
}

impl Stop {
    pub(crate) fn full_travel() -> Self {
        Self::new(StopKind::FullTravel, "full travel reached")
    }

    pub(in crate::solver) fn new(kind: StopKind, text: impl ToString) -> Self {
        Self { kind, s0: None, text: text.to_string() }
    }

    pub(in crate::solver) fn at(kind: StopKind, s0: f64, text: String) -> Self {
        Self { kind, s0: Some(s0), text }
    }

    /// True if the run came to its requested end. A fallen load is a failure even if the case asks for it.
    pub fn is_complete(&self) -> bool {
        matches!(self.kind, StopKind::FullTravel | StopKind::ContactShare | StopKind::HolderClosed | StopKind::LeftDie)
    }

    /// True if the sheet or the tools ended the run, not the numerics or the user.
    pub fn is_physical(&self) -> bool {
        let is_lost = matches!(
            self.kind,
            StopKind::Refused | StopKind::Interrupted | StopKind::Creeping | StopKind::NoEquilibrium
        );
        !self.is_complete() && !is_lost
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
