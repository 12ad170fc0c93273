//! A comparison's outcome, in numbers and in words.

use super::band::{self, Band, Interval};
use super::computed::Computed;
use super::curve::{self, Point, Points};
use super::error::CompareError;
use super::source::Source;
use super::spec::{Against, Spec};
use super::verdict::Verdict;
use crate::table::{Axis, Column, Table, Unit};
use crate::units::rounded;
use crate::units::{Amount, Digits};

/// Digits of a value in a table of many comparisons.
const DIGITS: usize = 3;

/// Result beside the reference.
#[derive(Clone, Debug, PartialEq)]
pub enum Found {
    /// The reference file is not there.
    NoData,
    /// The points of a curve.
    Points(Points),
    /// A band.
    Band(Band),
}

/// The outcome of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Request of the case.
    pub spec: Spec,
    /// Source of the reference, if its folder names one.
    pub source: Option<Source>,
    /// Result beside the reference.
    pub found: Found,
    /// The computed curve that the compared values were taken from.
    pub curve: Vec<(f64, f64)>,
    /// Whether they agree.
    pub verdict: Verdict,
    x: Column,
    y: Column,
}

impl Comparison {
    /// Whether a validation must fail: a demonstration never lets it.
    pub fn is_failure(&self) -> bool {
        matches!(self.verdict, Verdict::Out | Verdict::NotReached) && !self.spec.demonstration
    }

    /// The verdict in words: `in`, `OUT`, `OUT, demonstration`.
    pub fn outcome(&self) -> String {
        let word = self.verdict.name();
        if self.spec.demonstration { format!("{word}, demonstration") } else { word.to_owned() }
    }

    /// Place of a point in words: `punch travel = 12.5 mm`.
    pub fn place(&self, point: &Point) -> String {
        let x = (1e3 * point.x).round() / 1e3;
        let unit = if self.x.unit == Unit::None { "" } else { self.x.unit.symbol() };
        format!("{} = {x} {unit}", self.x.label.to_lowercase()).trim_end().to_owned()
    }

    /// The largest difference, in short: `+2.1 %`, `3.4 mm above (+0.7 %)`.
    pub fn worst(&self) -> Option<String> {
        match &self.found {
            Found::NoData => None,
            Found::Points(points) => points.worst()?.difference().map(|d| format!("{:+.1} %", 100.0 * d)),
            Found::Band(band) => band.text(self.y.unit),
        }
    }

    /// Accepted range: `5 %` of a curve, `467.3 to 468.5 mm`.
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

    /// The computed value that misses most, as a table of many comparisons has it.
    pub fn farthest(&self) -> Option<Amount> {
        match &self.found {
            Found::NoData => None,
            Found::Points(points) => points.worst()?.computed.map(|value| self.amount(value)),
            Found::Band(band) => band.farthest().map(|value| self.amount(value)),
        }
    }

    /// Target of that value: `24.3 mm ± 5 %`, `5.93–6.07 mm`.
    pub fn target(&self) -> Option<String> {
        match (&self.spec.against, &self.found) {
            (Against::Curve(curve), Found::Points(points)) => points.worst().map(|point| {
                let tolerance = Amount::given_share(curve.tolerance);
                format!("{} ± {}", self.amount(point.reference), tolerance)
            }),
            (_, Found::Band(Band { accepted, .. })) => {
                let [low, high] = [accepted.low, accepted.high].map(|end| self.amount(end));
                let ((number, unit), (other, of_high)) = (low.parts(), high.parts());
                Some(match (number == other, unit == of_high) {
                    (true, true) => high.to_string(),
                    (_, true) => format!("{number}–{}", high),
                    _ => format!("{}–{}", low, high),
                })
            }
            _ => None,
        }
    }

    fn amount(&self, value: f64) -> Amount {
        Amount::new(value, self.y.unit, Digits::Significant(DIGITS))
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

    /// Result as a table; no rows without data.
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
    let (found, verdict) = match (spec.reference()?, &spec.against) {
        (None, _) => (Found::NoData, Verdict::NoData),
        (Some(reference), Against::Curve(against)) => {
            let points = curve::compare(against, reference, (&x, &y), &curve)?;
            let verdict = points.verdict(against, computed.complete);
            (Found::Points(points), verdict)
        }
        (Some(reference), Against::Band(against)) => {
            let band = band::compare(against, reference, (&x, &y), computed)?;
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
