//! Computed tables against references: curves point by point, and bands that values without places span.

mod band;
mod comparison;
mod computed;
mod curve;
mod error;
mod reference;
mod source;
mod spec;
mod verdict;

pub use band::{Band, BandQuantity, BandSpec, Interval};
pub use comparison::{Comparison, Found, compare};
pub use computed::Computed;
pub use curve::{CurveSpec, Point, Points, Quantity};
pub use error::CompareError;
pub use source::{KINDS, SOURCES, Source};
pub use spec::{Against, Data, Spec};
pub use verdict::Verdict;
