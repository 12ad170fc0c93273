//! Error bars of a study.

/// Whether numbers have error bars.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bars {
    /// None.
    Without,
    /// From one coarser run of each design.
    Quick,
}
