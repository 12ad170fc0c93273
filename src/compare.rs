//! Computed tables against references: curves point by point, and bands that values without places span.

mod band;
mod curve;
mod error;
mod reference;
mod source;

pub use band::{Band, BandQuantity, BandSpec, Interval};
pub use curve::{CurveSpec, Point, Points, Quantity};
pub use error::CompareError;
pub use source::{SOURCES, Source};

use crate::model::{Geometry, Model};
use crate::solution::{ElementRecord, StageSolution, StepRecord};
use crate::table::{Axis, Column, Csv, Field, Table};
use crate::units::rounded;
use reference::Reference;
use std::fmt;
use std::path::PathBuf;

/// A comparison that a case asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// CSV file of the reference, units at the end of its headers.
    pub reference: PathBuf,
    /// What stands in it; `None` where it is optional and not there.
    pub data: Option<Data>,
    pub against: Against,
    /// Why the tolerance or the band is what it is, or what a difference comes from.
    pub reason: String,
    /// Whether the reference file may be missing.
    pub optional: bool,
    /// Whether the difference is shown without being held against the program: the input is not that of the reference.
    pub demonstration: bool,
}

/// What a reference file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    pub csv: Csv,
    /// Where it comes from, if its folder says so.
    pub source: Option<Source>,
}

/// The kind of reference.
#[derive(Clone, Debug, PartialEq)]
pub enum Against {
    Curve(CurveSpec),
    Band(BandSpec),
}

/// What a stage offers for comparison.
#[derive(Clone, Copy, Debug)]
pub struct Computed<'a> {
    pub geometry: Geometry,
    /// Length of the undeformed blank from the axis or symmetry plane \[mm\].
    pub length: f64,
    pub steps: &'a [StepRecord],
    /// The elements of the last frame from the axis outward.
    pub elements: &'a [ElementRecord],
    /// Whether the stage came to its end.
    pub complete: bool,
}

impl<'a> Computed<'a> {
    /// What a solved stage offers.
    pub fn of(stage: &'a StageSolution) -> Self {
        Self {
            steps: &stage.steps,
            elements: stage.frames.last().map_or(&[], |frame| &frame.elements),
            complete: stage.stop.is_complete(),
            ..Self::nothing(&stage.model)
        }
    }

    /// Nothing yet, to find out whether references fit before anything is solved.
    pub fn nothing(model: &Model) -> Self {
        Self { geometry: model.geometry, length: model.blank.length, steps: &[], elements: &[], complete: true }
    }

    fn step(&self, field: Field<StepRecord>) -> Column {
        field.column(self.geometry, self.steps)
    }

    fn element(&self, field: Field<ElementRecord>) -> Column {
        field.column(self.geometry, self.elements)
    }
}

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

/// What was found beside the reference.
#[derive(Clone, Debug, PartialEq)]
pub enum Found {
    NoData,
    Points(Points),
    Band(Band),
}

/// The outcome of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    pub spec: Spec,
    /// Where the reference comes from, if its folder says so.
    pub source: Option<Source>,
    pub found: Found,
    /// The computed curve that the compared values were taken from.
    pub curve: Vec<(f64, f64)>,
    pub verdict: Verdict,
    x: Column,
    y: Column,
}

impl Against {
    /// The word for the compared quantity in case files, tables and file names.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Curve(curve) => curve.quantity.name(),
            Self::Band(band) => band.quantity.name(),
        }
    }

    /// Headers of the reference file that are read.
    pub fn headers(&self) -> Vec<&str> {
        match self {
            Self::Curve(curve) => vec![&curve.x, &curve.y],
            Self::Band(band) => band.columns.iter().chain(&band.error).map(String::as_str).collect(),
        }
    }

    /// The computed columns that are compared: abscissa and ordinate.
    fn columns(&self, computed: &Computed) -> (Column, Column) {
        match self {
            Self::Curve(curve) => curve.quantity.columns(computed),
            Self::Band(band) => band.quantity.columns(computed),
        }
    }
}

impl fmt::Display for Against {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Curve(curve) => write!(f, "{} within {} %", self.name(), 100.0 * curve.tolerance),
            Self::Band(_) => write!(f, "{} within the band of the values", self.name()),
        }
    }
}

impl Comparison {
    /// Whether a validation must fail: a demonstration never lets it.
    pub fn is_failure(&self) -> bool {
        matches!(self.verdict, Verdict::Out | Verdict::NotReached) && !self.spec.demonstration
    }

    /// The verdict in words: `in`, `OUT`, `OUT, demonstration`.
    pub fn outcome(&self) -> String {
        let word = match self.verdict {
            Verdict::In => "in",
            Verdict::Out => "OUT",
            Verdict::NotReached => "not reached",
            Verdict::NoData => "no data",
        };
        if self.spec.demonstration { format!("{word}, demonstration") } else { word.to_owned() }
    }

    /// Where a point is, in words: `punch travel = 12.5 mm`.
    pub fn place(&self, point: &Point) -> String {
        let x = (1e3 * point.x).round() / 1e3;
        format!("{} = {x} {}", self.x.label.to_lowercase(), self.x.unit.symbol())
    }

    /// The largest difference, in short: `+2.1 %`, `3.4 mm above (+0.7 %)`.
    pub fn worst(&self) -> Option<String> {
        match &self.found {
            Found::NoData => None,
            Found::Points(points) => points.worst()?.difference().map(|d| format!("{:+.1} %", 100.0 * d)),
            Found::Band(band) => band.text(self.y.unit),
        }
    }

    /// What is accepted: `5 %` of a curve, `467.3 to 468.5 mm`.
    pub fn accepted(&self) -> String {
        match (&self.spec.against, &self.found) {
            (Against::Curve(curve), _) => format!("{} %", rounded(100.0 * curve.tolerance)),
            (Against::Band(_), Found::Band(band)) => band.accepted.text(self.y.unit),
            (Against::Band(_), _) => "–".to_owned(),
        }
    }

    /// The outcome in a sentence: `punch_force against osu.csv: in, worst +2.1 % at punch travel = 20 mm`.
    pub fn sentence(&self) -> String {
        let file = self.spec.reference.file_name().unwrap_or_default().to_string_lossy();
        let worst = match (&self.found, self.worst()) {
            (Found::Points(points), Some(worst)) => {
                let place = points.worst().map_or(String::new(), |point| self.place(point));
                format!(", worst {worst} at {place} (tolerance {})", self.accepted())
            }
            (Found::Band(Band { computed: Some(computed), .. }), Some(worst)) => {
                format!(", {}, {worst} of {}", computed.text(self.y.unit), self.accepted())
            }
            _ => String::new(),
        };
        format!("{} against {file}: {}{worst}", self.spec.against.name(), self.outcome())
    }

    /// Axes of the compared quantities.
    pub fn axes(&self) -> (Axis, Axis) {
        (self.x.axis(), self.y.axis())
    }

    /// Axis of the relative difference.
    pub fn difference_axis() -> Axis {
        curve::difference(Vec::new()).axis()
    }

    /// An interval of the compared quantity in words, with its unit.
    pub fn text(&self, interval: Interval) -> String {
        interval.text(self.y.unit)
    }

    /// What was found, in numbers; no rows without data.
    pub fn table(&self) -> Table {
        match &self.found {
            Found::NoData => Table::new(vec![]),
            Found::Points(points) => points.table(&self.x, &self.y),
            Found::Band(band) => band.table(&self.y),
        }
    }
}

/// Compares a run with a reference.
///
/// Along a curve, the computed one is interpolated linearly at the reference's abscissae. Where it turns back (force
/// after its peak, radius along a bulging wall), each abscissa counts where it is reached first; so travel at equal
/// force is taken on the rise to the peak. Either end is held for one interval. A band is that of all the values that
/// were measured, each with its error; the computed values lie inside or outside by so much.
///
/// # Errors
/// When the reference does not fit the quantity, or is not there and not optional.
pub fn compare(spec: &Spec, computed: &Computed) -> Result<Comparison, CompareError> {
    let (x, y) = spec.against.columns(computed);
    let curve: Vec<_> = x.values.iter().copied().zip(y.values.iter().copied()).collect();
    let (found, verdict) = match (Reference::of(spec)?, &spec.against) {
        (None, _) => (Found::NoData, Verdict::NoData),
        (Some(reference), Against::Curve(against)) => {
            let points = curve::compare(against, reference, (&x, &y), &curve)?;
            let verdict = points.verdict(against, computed.complete);
            (Found::Points(points), verdict)
        }
        (Some(reference), Against::Band(against)) => {
            let band = band::compare(against, reference, &y, computed.complete)?;
            (Found::Band(band), band.verdict())
        }
    };
    Ok(Comparison {
        spec: spec.clone(),
        source: spec.data.as_ref().and_then(|data| data.source.clone()),
        found,
        curve,
        verdict,
        x: Column { values: Vec::new(), ..x },
        y: Column { values: Vec::new(), ..y },
    })
}

#[cfg(test)]
mod tests;
