//! Computed tables beside the references of a case: curves point by point, and bands.

mod band;
mod chart;
mod computed;
mod curve;

pub use band::Band;
use band::interval_text;
pub(super) use chart::{PREFIX, files, is_comparison};
pub use computed::Computed;
pub use curve::{Point, Points};

use crate::case::comparison::{Against, Source, Spec};
use crate::case::{Case, Solution};
use crate::table::{Column, Csv, Table, Unit};
use crate::units::{Amount, Digits, rounded};
use std::path::Path;

/// Reference below which no relative difference is taken \[mm, N, N/mm\]: nobody measures so finely.
const NOTHING: f64 = 1e-9;

/// Reason why a comparison cannot be made: the reference file does not fit the case.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct CompareError(String);

/// Agreement of a run with a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Everything lies within the tolerance or the band.
    In,
    /// Something lies outside.
    Out,
    /// The run ended too early; what it reached lies within the tolerance.
    NotReached,
    /// The reference file is optional and missing.
    NoData,
}

/// Reference with the computed values.
#[derive(Clone, Debug, PartialEq)]
pub enum Compared {
    /// The reference file is missing.
    NoData,
    /// Points of a curve.
    Points(Points),
    /// Band.
    Band(Band),
}

/// Outcome of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Request of the case.
    pub spec: Spec,
    /// Reference with the computed values.
    pub compared: Compared,
    /// Computed curve that the compared values were taken from.
    pub curve: Vec<(f64, f64)>,
    /// Agreement.
    pub verdict: Verdict,
    x: Column,
    y: Column,
}

impl Solution {
    /// Comparisons with the results of the first stage and with the ring of the last.
    ///
    /// # Errors
    /// If a reference cannot be read or does not fit.
    pub fn comparisons(&self) -> Result<Vec<Comparison>, CompareError> {
        let Some(first) = self.stages.first() else { return Ok(Vec::new()) };
        let ring = self.case.springback.ring.and_then(|ring| ring.test(&self.stages));
        comparisons(&self.case, &Computed { ring: ring.as_ref(), ..Computed::of(first) })
    }
}

/// Comparisons of a case with computed results.
///
/// # Errors
/// If a reference cannot be read or does not fit.
pub fn comparisons(case: &Case, computed: &Computed) -> Result<Vec<Comparison>, CompareError> {
    case.compare.iter().map(|spec| compare(spec, computed)).collect()
}

/// Compares a run with a reference.
///
/// A computed curve is interpolated at the reference's abscissae, each where it is reached first, and held for one interval
/// beyond either end. A band is that of all measured values, each with its error.
///
/// # Errors
/// If the reference does not fit the quantity, or is missing and not optional.
pub fn compare(spec: &Spec, computed: &Computed) -> Result<Comparison, CompareError> {
    let (x, y) = computed.columns(spec.against.quantity());
    let path = spec.reference.as_path();
    let (compared, is_inside) = match (&spec.data, &spec.against) {
        (None, _) if !spec.optional => return Err(CompareError(format!("{} is not there", path.display()))),
        (None, _) => (Compared::NoData, None),
        (Some(data), Against::Curve(against)) => {
            let points = Points::compared(against, (path, &data.csv), [&x, &y])?;
            let is_inside = points.is_inside(against, computed.complete);
            (Compared::Points(points), is_inside)
        }
        (Some(data), Against::Band(against)) => {
            let band = Band::compared(against, (path, &data.csv), [&x, &y], computed)?;
            (Compared::Band(band), band.outside().map(|outside| outside == 0.0))
        }
    };
    let verdict = match (&compared, is_inside) {
        (Compared::NoData, _) => Verdict::NoData,
        (_, Some(true)) => Verdict::In,
        (_, Some(false)) => Verdict::Out,
        (_, None) => Verdict::NotReached,
    };
    let curve = x.values.iter().copied().zip(y.values.iter().copied()).collect();
    let [x, y] = [x, y].map(|column| Column { values: Vec::new(), ..column });
    Ok(Comparison { spec: spec.clone(), compared, curve, verdict, x, y })
}

/// Values of a reference's column in the unit of the computed one, `None` where empty, and the factor to that unit.
fn read_column(
    path: &Path,
    csv: &Csv,
    header: &str,
    computed: &Column,
) -> Result<(Vec<Option<f64>>, f64), CompareError> {
    let refused = |what: String| CompareError(format!("{}{what}", path.display()));
    let at = csv.column(header).ok_or_else(|| refused(format!(" has no column `{header}`; it has {}", csv.names())))?;
    let (unit, factor) = match csv.unit(at) {
        // The name of a plain number ends in no unit.
        Err(_) if computed.unit == Unit::None => (Unit::None, 1.0),
        unit => unit.map_err(|error| refused(format!(": {error}")))?,
    };
    if unit != computed.unit {
        let with = computed.axis();
        let with = with.text();
        return Err(refused(format!(": column `{header}` cannot be compared with the computed {with}")));
    }
    let largest = unit.largest();
    let values = csv.rows.iter().map(|row| {
        let place = format!(", line {}, column `{header}`", row.line);
        let value = row.number(at).map_err(|error| refused(format!("{place}: {error}")))?.map(|value| value * factor);
        if value.is_none_or(|value| value.abs() <= largest) {
            return Ok(value);
        }
        Err(refused(format!(
            "{place}: {} is out of range, its magnitude must be at most {largest:e} {}: check the number and the unit at the \
             end of the header",
            row.quoted(at),
            unit.symbol()
        )))
    });
    Ok((values.collect::<Result<_, _>>()?, factor))
}

/// Computed minus reference, over the reference \[%\].
fn difference(values: Vec<f64>) -> Column {
    Column::new("difference", "Difference", Unit::Percent, values)
}

impl Comparison {
    /// Source of the reference, if its folder names one.
    pub fn source(&self) -> Option<&Source> {
        self.spec.data.as_ref()?.source.as_ref()
    }

    /// True if a validation must fail; a demonstration is never a failure.
    pub fn is_failure(&self) -> bool {
        matches!(self.verdict, Verdict::Out | Verdict::NotReached) && !self.spec.demonstration
    }

    /// Verdict in words: `in`, `OUT`, `OUT, demonstration`.
    pub fn outcome(&self) -> String {
        let word = match self.verdict {
            Verdict::In => "in",
            Verdict::Out => "OUT",
            Verdict::NotReached => "not reached",
            Verdict::NoData => "no data",
        };
        if self.spec.demonstration { format!("{word}, demonstration") } else { word.to_owned() }
    }

    /// Place of a point in words: `punch travel = 12.5 mm`.
    fn place(&self, point: &Point) -> String {
        let x = (1e3 * point.x).round() / 1e3;
        let unit = if self.x.unit == Unit::None { "" } else { self.x.unit.symbol() };
        format!("{} = {x} {unit}", self.x.label.to_lowercase()).trim_end().to_owned()
    }

    /// Largest difference, in short: `+2.1 %`, `3.4 mm above (+0.7 %)`.
    pub fn worst(&self) -> Option<String> {
        match &self.compared {
            Compared::NoData => None,
            Compared::Points(points) => points.worst()?.difference().map(|d| format!("{:+.1} %", 100.0 * d)),
            Compared::Band(band) => band.text(self.y.unit),
        }
    }

    /// Accepted range: `5 %` of a curve, `467.3 to 468.5 mm`.
    pub fn accepted(&self) -> String {
        match (&self.spec.against, &self.compared) {
            (Against::Curve(curve), _) => format!("{} %", rounded(100.0 * curve.tolerance)),
            (_, Compared::Band(band)) => interval_text(band.accepted, self.y.unit),
            _ => "–".to_owned(),
        }
    }

    /// Outcome in a sentence: `punch_force against osu.csv: in, worst +2.1 % at punch travel = 20 mm (tolerance 5 %)`.
    pub fn sentence(&self) -> String {
        let file = self.spec.reference.file_name().unwrap_or_default().to_string_lossy();
        let worst = match (&self.compared, self.worst()) {
            (Compared::Points(points), Some(worst)) => {
                let place = points.worst().map_or(String::new(), |point| self.place(point));
                format!(", worst {worst} at {place} (tolerance {})", self.accepted())
            }
            (Compared::Band(Band { computed: Some(computed), .. }), Some(worst)) => {
                format!(", {}, {worst} of {}", interval_text(*computed, self.y.unit), self.accepted())
            }
            _ => String::new(),
        };
        format!("{} against {file}: {}{worst}", self.spec.against.quantity().name(), self.outcome())
    }

    /// Computed value with the largest difference.
    pub fn farthest(&self) -> Option<Amount> {
        let value = match &self.compared {
            Compared::NoData => None,
            Compared::Points(points) => points.worst()?.computed,
            Compared::Band(band) => band.farthest(),
        };
        value.map(|value| self.amount(value))
    }

    /// Target of that value: `24.3 mm ± 5 %`, `5.93–6.07 mm`.
    pub fn target(&self) -> Option<String> {
        match (&self.spec.against, &self.compared) {
            (Against::Curve(curve), Compared::Points(points)) => points
                .worst()
                .map(|point| format!("{} ± {}", self.amount(point.reference), Amount::given_share(curve.tolerance))),
            (_, Compared::Band(band)) => {
                let [low, high] = band.accepted.map(|end| self.amount(end));
                let ((number, unit), (other, of_high)) = (low.parts(), high.parts());
                Some(match (number == other, unit == of_high) {
                    (true, true) => high.to_string(),
                    (_, true) => format!("{number}–{high}"),
                    _ => format!("{low}–{high}"),
                })
            }
            _ => None,
        }
    }

    /// Value of the compared quantity, to three digits.
    fn amount(&self, value: f64) -> Amount {
        Amount::new(value, self.y.unit, Digits::Significant(3))
    }

    /// Result as a table; no columns without data.
    pub fn table(&self) -> Table {
        match &self.compared {
            Compared::NoData => Table::new(vec![]),
            Compared::Points(points) => points.table(&self.x, &self.y),
            Compared::Band(band) => band.table(&self.y),
        }
    }
}
