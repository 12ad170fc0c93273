//! Reference bands: the interval that values of one quantity without places span, such as diameters of a drawn part.

use super::{CompareError, Computed, NOTHING, difference, read_column};
use crate::case::comparison::{BandSpec, ComparedQuantity as Q};
use crate::table::{Column, Csv, Table, Unit};
use crate::units::{four_digits, without_zeros};
use std::path::Path;

/// Measured and computed intervals from the least to the largest value, in solver units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Interval of the reference's values.
    pub measured: [f64; 2],
    /// Interval with the errors of measurement, in which computed values must lie.
    pub accepted: [f64; 2],
    /// Interval of the computed values; `None` without a whole run.
    pub computed: Option<[f64; 2]>,
}

/// Least and largest of some values; `None` without values.
fn interval(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    values
        .into_iter()
        .fold(None, |all: Option<[f64; 2]>, v| Some(all.map_or([v, v], |[low, high]| [low.min(v), high.max(v)])))
}

/// Text such as `467.3 to 468.5 mm`, or one value if both ends are alike.
pub(super) fn interval_text(ends: [f64; 2], unit: Unit) -> String {
    let ([low, high], unit) = (ends.map(|end| without_zeros(&four_digits(end)).to_owned()), unit.symbol());
    if low == high { format!("{low} {unit}") } else { format!("{low} to {high} {unit}") }
}

/// Compared values of a quantity, to follow "reference" or "computed".
pub(super) fn which(quantity: Q) -> &'static str {
    match quantity {
        Q::RingOpening => "of the ring",
        Q::Thickness => "least and largest",
        Q::PeakForce => "at its peak",
        Q::PeakTravel => "at the peak",
        _ => "at the end",
    }
}

impl Band {
    /// Excess of the computed values: above the accepted band positive, below it negative, the larger of both; 0 inside.
    pub fn outside(&self) -> Option<f64> {
        let ([low, high], [least, most]) = (self.computed?, self.accepted);
        let (below, above) = ((least - low).max(0.0), (high - most).max(0.0));
        Some(if above >= below { above } else { -below })
    }

    /// [`Self::outside`] over the end of the band that is left \[–\]; `None` if that end is 0.
    pub fn difference(&self) -> Option<f64> {
        let outside = self.outside()?;
        let end = self.end_left(outside).abs();
        if outside == 0.0 { Some(0.0) } else { (end >= NOTHING).then(|| outside / end) }
    }

    /// Computed value that is farthest out of the accepted band, or nearest to its end.
    pub(super) fn farthest(&self) -> Option<f64> {
        let ([low, high], [least, most]) = (self.computed?, self.accepted);
        Some(if least - low > high - most { low } else { high })
    }

    fn end_left(&self, outside: f64) -> f64 {
        self.accepted[usize::from(outside >= 0.0)]
    }

    /// Text such as `3.4 mm above (+0.7 %)`, with as many decimals as the band's end; `inside`.
    pub(super) fn text(&self, unit: Unit) -> Option<String> {
        let outside = self.outside()?;
        if outside == 0.0 {
            return Some("inside".to_owned());
        }
        let decimals = four_digits(self.end_left(outside)).split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let side = if outside < 0.0 { "below" } else { "above" };
        let percent = self.difference().map_or(String::new(), |share| format!(" ({:+.1} %)", 100.0 * share));
        Some(format!("{:.decimals$} {} {side}{percent}", outside.abs(), unit.symbol()))
    }

    /// One row: measured, accepted and computed interval.
    pub(super) fn table(&self, y: &Column) -> Table {
        let computed = self.computed.unwrap_or([f64::NAN; 2]);
        let column = |key, label, value| Column::new(key, label, y.unit, vec![value]);
        Table::new(vec![
            column("measured_low", "Least measured", self.measured[0]),
            column("measured_high", "Largest measured", self.measured[1]),
            column("accepted_low", "Least accepted", self.accepted[0]),
            column("accepted_high", "Largest accepted", self.accepted[1]),
            column("computed_low", "Least computed", computed[0]),
            column("computed_high", "Largest computed", computed[1]),
            column("outside", "Outside the band", self.outside().unwrap_or(f64::NAN)),
            difference(vec![100.0 * self.difference().unwrap_or(f64::NAN)]),
        ])
    }

    /// Compares the band of a reference with computed columns; an unfinished run has no value at the end.
    pub(super) fn compared(
        spec: &BandSpec,
        (path, csv): (&Path, &Csv),
        [x, y]: [&Column; 2],
        computed: &Computed,
    ) -> Result<Self, CompareError> {
        let errors = match &spec.error {
            Some(header) => read_column(path, csv, header, y)?.0,
            None => Vec::new(),
        };
        if let Some(row) = errors.iter().position(|error| error.is_some_and(|error| error < 0.0)) {
            let (line, column) = (csv.rows[row].line, spec.error.as_deref().unwrap_or_default());
            let what = format!("line {line}: the error of measurement in column `{column}` is negative");
            return Err(CompareError(format!("{}, {what}", path.display())));
        }
        let mut values = Vec::new();
        for header in &spec.columns {
            let column = read_column(path, csv, header, y)?.0.into_iter().enumerate();
            let error = |row: usize| errors.get(row).copied().flatten().unwrap_or(0.0);
            values.extend(column.filter_map(|(row, value)| Some((value?, error(row)))));
        }
        let measured = interval(values.iter().map(|v| v.0));
        let accepted = interval(values.iter().flat_map(|(value, error)| [value - error, value + error]));
        let (Some(measured), Some(accepted)) = (measured, accepted) else {
            let columns = spec.columns.join(", ");
            let what = format!("{} has no values in {columns}, which the band should span", path.display());
            return Err(CompareError(what));
        };
        let all = || y.values.iter().copied();
        let compared = match spec.quantity {
            Q::Thickness => interval(all()),
            Q::PeakForce => interval(all().reduce(f64::max)),
            Q::PeakTravel => interval(peak(&x.values).map(|at| y.values[at])),
            Q::RingOpening => interval(computed.ring.map(|test| test.opening)),
            _ => interval(all().next_back()),
        };
        // A run may end at its peak.
        let is_known = computed.complete || spec.quantity == Q::PeakTravel;
        Ok(Self { measured, accepted, computed: compared.filter(|_| is_known) })
    }
}

/// Index of the largest value; `None` if it is the last, which may rise further.
fn peak(values: &[f64]) -> Option<usize> {
    let at = (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b]))?;
    (at + 1 < values.len()).then_some(at)
}
