//! A reference that is an interval: values of one quantity without places, such as the diameters of a drawn part
//! along two lines, or thicknesses measured at points whose positions are not known.

use super::computed::Computed;
use super::curve::difference;
use super::error::CompareError;
use super::reference::{NOTHING, Reference};
use super::verdict::Verdict;
use crate::table::fields::{element, step};
use crate::table::{Column, Table, Unit};
use crate::units::{four_digits, without_zeros};

/// Quantity that is compared with a band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BandQuantity {
    /// Diameter at the blank's edge at the end; in plane strain the width between both edges.
    EdgeDiameter,
    /// How far the edge has moved inward at the end.
    DrawIn,
    /// Smallest thickness at the end.
    Thinnest,
    /// Thickness of the whole section at the end.
    Thickness,
    /// Largest punch force of the run.
    PeakForce,
    /// Travel at the largest punch force, once the force has fallen from it: the index of a cupping test.
    PeakTravel,
    /// Opening of a slit ring of the released cup's wall.
    RingOpening,
}

/// A comparison with the interval that measured values span.
#[derive(Clone, Debug, PartialEq)]
pub struct BandSpec {
    /// Compared quantity.
    pub quantity: BandQuantity,
    /// Headers of the columns whose values, all rows of them, span the band.
    pub columns: Vec<String>,
    /// Header of the column with each row's error of measurement, by which the band is widened on either side.
    pub error: Option<String>,
}

/// From the least to the largest of some values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The least.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

/// Measured and computed intervals, in solver units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Interval of the reference's values.
    pub measured: Interval,
    /// Interval with the errors of measurement, in which computed values must lie.
    pub accepted: Interval,
    /// Interval of the computed values; `None` without a whole run.
    pub computed: Option<Interval>,
}

enum Of {
    All,
    Last,
    Largest,
    Peak,
    Ring,
}

impl BandQuantity {
    /// Every quantity that is compared with a band.
    pub const ALL: [Self; 7] = [
        Self::EdgeDiameter,
        Self::DrawIn,
        Self::Thinnest,
        Self::Thickness,
        Self::PeakForce,
        Self::PeakTravel,
        Self::RingOpening,
    ];

    /// The word used in case files, tables and file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::EdgeDiameter => "edge_diameter",
            Self::DrawIn => "draw_in",
            Self::Thinnest => "thinnest",
            Self::Thickness => "thickness",
            Self::PeakForce => "peak_force",
            Self::PeakTravel => "peak_travel",
            Self::RingOpening => "ring_opening",
        }
    }

    pub(super) fn label(self) -> &'static str {
        match self {
            Self::EdgeDiameter => "diameter",
            Self::DrawIn => "draw-in",
            Self::Thinnest => "thinnest",
            Self::Thickness => "thickness",
            Self::PeakForce => "peak force",
            Self::PeakTravel => "peak at",
            Self::RingOpening => "ring",
        }
    }

    pub(super) fn columns(self, computed: &Computed) -> (Column, Column) {
        let over_travel = |values| (computed.step(step::TRAVEL), values);
        match self {
            Self::EdgeDiameter => {
                over_travel(step::edge_diameter(computed.extent.geometry(), computed.length, computed.steps))
            }
            Self::DrawIn => over_travel(computed.step(step::DRAW_IN)),
            Self::Thinnest => over_travel(computed.step(step::THINNEST)),
            Self::Thickness => (computed.element(element::R), computed.element(element::THICKNESS)),
            Self::PeakForce => over_travel(computed.step(step::PUNCH_FORCE)),
            Self::PeakTravel => (computed.step(step::PUNCH_FORCE), computed.step(step::TRAVEL)),
            Self::RingOpening => {
                let places = computed.ring.map_or(&[][..], |test| &test.places);
                let (from, openings) = places.iter().copied().unzip();
                let from = Column::new("ring_from", "Lower edge of the ring over the bottom", Unit::Mm, from);
                (from, Column::new("ring_opening", "Opening of the slit ring", Unit::Mm, openings))
            }
        }
    }

    /// Compared values, in words that follow "reference" or "computed".
    pub fn which(self) -> &'static str {
        match self.of() {
            Of::All => "least and largest",
            Of::Last => "at the end",
            Of::Largest => "at its peak",
            Of::Peak => "at the peak",
            Of::Ring => "of the ring",
        }
    }

    fn of(self) -> Of {
        match self {
            Self::RingOpening => Of::Ring,
            Self::EdgeDiameter | Self::DrawIn | Self::Thinnest => Of::Last,
            Self::Thickness => Of::All,
            Self::PeakForce => Of::Largest,
            Self::PeakTravel => Of::Peak,
        }
    }
}

impl Interval {
    /// The least interval that holds all values; `None` without values.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        values.into_iter().fold(None, |all: Option<Self>, v| {
            Some(all.map_or(Self { low: v, high: v }, |i| Self { low: i.low.min(v), high: i.high.max(v) }))
        })
    }

    /// `467.3 to 468.5 mm`, or one value where both ends are the same.
    pub fn text(self, unit: Unit) -> String {
        let (low, high, unit) = (short(self.low), short(self.high), unit.symbol());
        if low == high { format!("{low} {unit}") } else { format!("{low} to {high} {unit}") }
    }
}

/// Four digits without zeros at the end of the decimals.
fn short(value: f64) -> String {
    without_zeros(&four_digits(value)).to_owned()
}

impl Band {
    /// How far the computed values leave the accepted band: above it positive, below it negative, 0 inside; the
    /// larger of the two where they leave it on both sides.
    pub fn outside(&self) -> Option<f64> {
        let Interval { low, high } = self.computed?;
        let (below, above) = ((self.accepted.low - low).max(0.0), (high - self.accepted.high).max(0.0));
        Some(if above >= below { above } else { -below })
    }

    /// [`Self::outside`] over the end of the band that is left \[–\]; `None` where that end is nothing.
    pub fn difference(&self) -> Option<f64> {
        let outside = self.outside()?;
        let end = self.end_left(outside).abs();
        if outside == 0.0 { Some(0.0) } else { (end >= NOTHING).then(|| outside / end) }
    }

    /// The computed value that is farthest out of the accepted band; the one nearest its end where none is out.
    pub(super) fn farthest(&self) -> Option<f64> {
        let Interval { low, high } = self.computed?;
        let is_low = self.accepted.low - low > high - self.accepted.high;
        Some(if is_low { low } else { high })
    }

    fn end_left(&self, outside: f64) -> f64 {
        if outside < 0.0 { self.accepted.low } else { self.accepted.high }
    }

    /// `3.4 mm above (+0.7 %)`, as many decimals as the band's end has; `inside`.
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

    /// One row: what was measured, what is accepted and what was computed.
    pub(super) fn table(&self, y: &Column) -> Table {
        let computed = self.computed.unwrap_or(Interval { low: f64::NAN, high: f64::NAN });
        let column = |key, label, value| Column::new(key, label, y.unit, vec![value]);
        Table::new(vec![
            column("measured_low", "Least measured", self.measured.low),
            column("measured_high", "Largest measured", self.measured.high),
            column("accepted_low", "Least accepted", self.accepted.low),
            column("accepted_high", "Largest accepted", self.accepted.high),
            column("computed_low", "Least computed", computed.low),
            column("computed_high", "Largest computed", computed.high),
            column("outside", "Outside the band", self.outside().unwrap_or(f64::NAN)),
            difference(vec![100.0 * self.difference().unwrap_or(f64::NAN)]),
        ])
    }

    pub(super) fn verdict(&self) -> Verdict {
        match self.outside() {
            None => Verdict::NotReached,
            Some(0.0) => Verdict::In,
            Some(_) => Verdict::Out,
        }
    }
}

/// The band of the reference with what was computed; an unfinished run has no value at the end.
pub(super) fn compare(
    spec: &BandSpec,
    reference: Reference,
    (x, y): (&Column, &Column),
    computed: &Computed,
) -> Result<Band, CompareError> {
    let path = || reference.path.to_owned();
    let errors = spec.error.as_ref().map(|header| reference.column(header, y)).transpose()?;
    let errors = errors.map(|column| column.values).unwrap_or_default();
    let negative = errors.iter().position(|e| e.is_some_and(|e| e < 0.0));
    if let (Some(row), Some(column)) = (negative, &spec.error) {
        let line = reference.csv.rows[row].line;
        return Err(CompareError::NegativeError { path: path(), line, column: column.clone() });
    }
    let mut values = Vec::new();
    for header in &spec.columns {
        for (row, value) in reference.column(header, y)?.values.into_iter().enumerate() {
            let error = errors.get(row).copied().flatten().unwrap_or(0.0);
            values.extend(value.map(|value| (value, error)));
        }
    }
    let measured = Interval::of(values.iter().map(|v| v.0));
    let accepted = Interval::of(values.iter().flat_map(|(value, error)| [value - error, value + error]));
    let (Some(measured), Some(accepted)) = (measured, accepted) else {
        return Err(CompareError::NoBand { path: path(), columns: spec.columns.join(", ") });
    };
    let all = || y.values.iter().copied();
    let compared = match spec.quantity.of() {
        Of::All => Interval::of(all()),
        Of::Last => Interval::of(all().next_back()),
        Of::Largest => Interval::of(all().reduce(f64::max)),
        Of::Peak => Interval::of(peak(&x.values).map(|at| y.values[at])),
        Of::Ring => Interval::of(computed.ring.map(|test| test.opening)),
    };
    // What ends a run at its peak is what is compared there.
    let is_known = computed.complete || matches!(spec.quantity.of(), Of::Peak);
    Ok(Band { measured, accepted, computed: compared.filter(|_| is_known) })
}

/// The index of the largest value; `None` where it is the last: it may rise further.
fn peak(values: &[f64]) -> Option<usize> {
    let at = (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b]))?;
    (at + 1 < values.len()).then_some(at)
}
