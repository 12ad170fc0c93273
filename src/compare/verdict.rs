//! Whether a run agrees with a reference.

/// Whether a run agrees with a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Everything lies within the tolerance or the band.
    In,
    /// Something lies outside.
    Out,
    /// The run ended too early; what it reached lies within the tolerance.
    NotReached,
    /// The reference file is optional and not there.
    NoData,
}

impl Verdict {
    /// `in`, `OUT`, `not reached`, `no data`.
    pub fn name(self) -> &'static str {
        match self {
            Self::In => "in",
            Self::Out => "OUT",
            Self::NotReached => "not reached",
            Self::NoData => "no data",
        }
    }

    /// Word for readers: `inside`, `outside`.
    pub fn told(self) -> &'static str {
        match self {
            Self::In => "inside",
            Self::Out => "outside",
            Self::NotReached | Self::NoData => self.name(),
        }
    }
}
