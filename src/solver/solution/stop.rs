//! End of a run.

named! {
    /// Kind of end.
    pub enum StopKind;
    /// Name in a few words.
    fn name;
    Refused: "refused", "The model cannot be solved.";
    FullTravel: "full travel", "The run has come to its end.";
    LoadMaximum: "load maximum passed", "The load has fallen from its maximum by the requested share.";
    ContactShare: "contact share reached", "The requested share of the sheet lies on its tools.";
    PressureMaximum: "pressure maximum reached", "The gas pressure is the largest that a free place of the sheet can bear.";
    Mechanism: "mechanism", "A strip of membranes has no restraint.";
    Arched: "arched", "The sheet has left the punch as an arch and snaps through.";
    Localised: "localised", "A neck: one place stretches while its surroundings have stopped.";
    Coalesced: "voids coalesced", "Voids have coalesced through the thickness.";
    EdgeLimit: "edge cracked", "The hole's edge has come to its limit of expansion.";
    DrawnThrough: "drawn through", "The blank's edge has passed the die's throat.";
    LeftDie: "drawn through", "The rim has left the die's shoulder, as the case requests.";
    HolderClosed: "holder closed", "The holder has closed with its force.";
    ToolsClosed: "tools closed", "Two tools are too close for the sheet, or squeeze it beyond any equilibrium.";
    Interrupted: "interrupted", "The observer ended the run.";
    Creeping: "creeping", "The run spent its budget of tries.";
    NoEquilibrium: "no equilibrium", "No equilibrium was found down to the smallest step.";
}

/// Reason for the end of a run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{text}")]
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
        use StopKind::{Creeping, Interrupted, NoEquilibrium, Refused};
        !self.is_complete() && !matches!(self.kind, Refused | Interrupted | Creeping | NoEquilibrium)
    }
}
