//! What was done to the sheet before the first step of a stage.

/// A holder that closed on the die over the sheet before the punch came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closing {
    /// From where it touched the flat sheet to where it is one thickness from the die \[mm\].
    pub way: f64,
    /// What of the way was left where its force was reached: how far it stands open \[mm\].
    pub gap: f64,
    /// Its force at the end of closing \[N, or N/mm of depth\].
    pub force: f64,
}

/// A rim that was cut off before a stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trimmed {
    /// Distance from the axis or symmetry plane that was asked for \[mm\].
    pub asked: f64,
    /// Where the edge is: whole elements go \[mm\].
    pub edge: f64,
    /// Elements that were cut off.
    pub elements: usize,
}
