//! Comparisons in words, as tables and as pictures.

use super::{Band, Compared, Comparison, Point, Verdict, four_digits};
use crate::case::comparison::{Against, ComparedQuantity as Q, Source};
use crate::plot::StageView;
use crate::plot::chart::Chart;
use crate::plot::comparison::{band_panel, curve_panels};
use crate::results::{Files, Format, Results, csv};
use crate::table::{Column, Table, Unit};
use crate::units::{Amount, Digits, joined, rounded, without_zeros};

/// Beginning of the names of files.
pub(in crate::results) const PREFIX: &str = "compare_";

/// Largest drawn difference in tolerances, if half of the points lie within.
const DRAWN: f64 = 6.0;

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

    /// Points of the reference; empty of a band.
    pub fn points(&self) -> &[Point] {
        if let Compared::Points(points) = &self.compared { points } else { &[] }
    }

    /// Judged point with the largest relative difference.
    pub fn worst_point(&self) -> Option<&Point> {
        let size = |p: &Point| p.difference().map_or(-1.0, f64::abs);
        let judged = self.points().iter().filter(|point| point.judged);
        judged.max_by(|a, b| size(a).total_cmp(&size(b))).filter(|p| p.computed.is_some())
    }

    /// Largest difference, in short: `+2.1 %`, `3.4 mm above (+0.7 %)` with as many decimals as the band's end.
    pub fn worst(&self) -> Option<String> {
        let Compared::Band(band) = &self.compared else {
            return self.worst_point()?.difference().map(|d| format!("{:+.1} %", 100.0 * d));
        };
        let outside = band.outside()?;
        if outside == 0.0 {
            return Some("inside".to_owned());
        }
        let decimals = four_digits(band.end_left(outside)).split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let side = if outside < 0.0 { "below" } else { "above" };
        let percent = band.difference().map_or(String::new(), |share| format!(" ({:+.1} %)", 100.0 * share));
        Some(format!("{:.decimals$} {} {side}{percent}", outside.abs(), self.y.unit.symbol()))
    }

    /// Largest difference with the place of a point: `+2.1 % at punch travel = 12.5 mm`.
    fn worst_at(&self) -> Option<String> {
        let x = (1e3 * self.worst_point()?.x).round() / 1e3;
        let unit = if self.x.unit == Unit::None { "" } else { self.x.unit.symbol() };
        let place = format!("{} = {x} {unit}", self.x.label.to_lowercase());
        Some(format!("{} at {}", self.worst()?, place.trim_end()))
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
        let worst = match (&self.compared, self.worst()) {
            (Compared::Band(Band { computed: Some(computed), .. }), Some(worst)) => {
                format!(", {}, {worst} of {}", interval_text(*computed, self.y.unit), self.accepted())
            }
            _ => self.worst_at().map_or(String::new(), |at| format!(", worst {at} (tolerance {})", self.accepted())),
        };
        format!("{} against {}: {}{worst}", self.spec.against.quantity().name(), self.file(), self.outcome())
    }

    fn file(&self) -> String {
        self.spec.reference.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Computed value with the largest difference: of a band the one farthest out of it, or nearest to its end.
    pub fn farthest(&self) -> Option<Amount> {
        let value = match &self.compared {
            Compared::Band(Band { computed, accepted: [least, most], .. }) => {
                computed.map(|[low, high]| if least - low > high - most { low } else { high })
            }
            _ => self.worst_point()?.computed,
        };
        value.map(|value| self.amount(value))
    }

    /// Target of that value: `24.3 mm ± 5 %`, `5.93–6.07 mm`.
    pub fn target(&self) -> Option<String> {
        match (&self.spec.against, &self.compared) {
            (Against::Curve(curve), Compared::Points(_)) => self
                .worst_point()
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

    /// Result as a table, NaN where the run did not get: a row per point of a curve, or one of a band; no columns without data.
    pub fn table(&self) -> Table {
        let unit = self.y.unit;
        let mut columns = Vec::new();
        let mut add = |key, label, unit, values: Vec<f64>| columns.push(Column::new(key, label, unit, values));
        let differences: Vec<Option<f64>> = match &self.compared {
            Compared::NoData => return Table::new(columns),
            Compared::Points(points) => {
                add(self.x.key, self.x.label, self.x.unit, points.iter().map(|p| p.x).collect());
                add("reference", "Reference", unit, points.iter().map(|p| p.reference).collect());
                add("computed", "Computed", unit, points.iter().map(|p| p.computed.unwrap_or(f64::NAN)).collect());
                points.iter().map(Point::difference).collect()
            }
            Compared::Band(band) => {
                let computed = band.computed.unwrap_or([f64::NAN; 2]);
                add("measured_low", "Least measured", unit, vec![band.measured[0]]);
                add("measured_high", "Largest measured", unit, vec![band.measured[1]]);
                add("accepted_low", "Least accepted", unit, vec![band.accepted[0]]);
                add("accepted_high", "Largest accepted", unit, vec![band.accepted[1]]);
                add("computed_low", "Least computed", unit, vec![computed[0]]);
                add("computed_high", "Largest computed", unit, vec![computed[1]]);
                add("outside", "Outside the band", unit, vec![band.outside().unwrap_or(f64::NAN)]);
                vec![band.difference()]
            }
        };
        let percent = differences.iter().map(|share| 100.0 * share.unwrap_or(f64::NAN)).collect();
        add("difference", "Difference", Unit::Percent, percent);
        Table::new(columns)
    }

    fn chart(&self, view: &StageView) -> Option<Chart> {
        let axes = [self.x.axis(), self.y.axis()];
        let (panels, columns, text) = match (&self.spec.against, &self.compared) {
            (Against::Curve(spec), Compared::Points(points)) => {
                let end = DRAWN * spec.tolerance;
                let beyond = points.iter().filter_map(Point::difference).filter(|d| d.abs() > end).count();
                let largest = if 2 * beyond > points.len() { f64::INFINITY } else { end };
                let differences = points.iter().filter_map(|p| Some((p.x, p.difference()?)));
                let differences = differences.filter(|d| d.1.abs() <= largest).map(|(x, d)| (x, 100.0 * d)).collect();
                let reference = points.iter().map(|p| (p.x, p.reference)).collect();
                let tolerance = rounded(100.0 * spec.tolerance);
                let panels = curve_panels(axes, self.curve.clone(), reference, differences, tolerance);
                let judged: Vec<&Point> = points.iter().filter(|point| point.judged).collect();
                let missed = judged.iter().filter(|point| point.computed.is_none()).count();
                let missed = format!("{missed} of {} reference points were not reached", judged.len());
                let worst = self.worst_at().map(|worst| format!("largest difference {worst}"));
                (panels, spec.y.clone(), joined([worst.unwrap_or_default(), missed], "; "))
            }
            (Against::Band(spec), Compared::Band(band)) => {
                let unit = self.y.unit;
                let which = which(spec.quantity);
                let compared = band.computed.map_or_else(Default::default, |computed| {
                    let compared = self.curve.iter().copied().filter(|p| computed.contains(&p.1));
                    let points = match computed[0] == computed[1] {
                        true => compared.rev().take(1).collect(),
                        false => compared.collect(),
                    };
                    (format!("Computed {which}, {}", interval_text(computed, unit)), points)
                });
                let legend = |name: &str, ends| (format!("{name}, {}", interval_text(ends, unit)), ends);
                let measured = legend(&format!("Reference {which}"), band.measured);
                let is_wider = band.accepted != band.measured;
                let widened = is_wider.then(|| legend("Reference with its error", band.accepted));
                let text = band.computed.zip(self.worst());
                let text = text.map(|(ends, worst)| format!("computed {}: {worst}", interval_text(ends, unit)));
                let text = text.unwrap_or_else(|| "the run ended before the compared value".to_owned());
                let panel = band_panel(axes, self.curve.clone(), compared, measured, widened);
                (vec![panel], spec.columns.join(", "), text)
            }
            _ => return None,
        };
        let from = self.source().map_or_else(|| "source not stated".to_owned(), ToString::to_string);
        let notes = [
            format!("Reference: {}, {columns}: {from}.", self.file()),
            format!("Accepted: {}; {text}.", self.accepted()),
            format!("Reason: {}.", self.spec.reason.trim_end_matches('.')),
        ];
        let demonstration = self.spec.demonstration.then(|| "A demonstration, not a validation.".to_owned());
        Some(view.chart("computed and reference", panels, demonstration.into_iter().chain(notes)))
    }
}

/// Text such as `467.3 to 468.5 mm`, or one value if both ends are alike.
fn interval_text(ends: [f64; 2], unit: Unit) -> String {
    let ([low, high], unit) = (ends.map(|end| without_zeros(&four_digits(end)).to_owned()), unit.symbol());
    if low == high { format!("{low} {unit}") } else { format!("{low} to {high} {unit}") }
}

/// Compared values of a quantity, to follow "reference" or "computed".
fn which(quantity: Q) -> &'static str {
    match quantity {
        Q::RingOpening => "of the ring",
        Q::Thickness => "least and largest",
        Q::PeakForce => "at its peak",
        Q::PeakTravel => "at the peak",
        _ => "at the end",
    }
}

/// Table and picture `compare_<n>_<quantity>` of every comparison with data, counted from 1.
pub(in crate::results) fn files(results: &Results) -> Files {
    let mut files = Vec::new();
    let Some(view) = results.views.first() else { return files };
    for (i, comparison) in results.comparisons.iter().enumerate() {
        let stem = format!("{PREFIX}{}_{}", i + 1, comparison.spec.against.quantity().name());
        if let Some(chart) = comparison.chart(view) {
            files.push((format!("{stem}.csv"), csv(&comparison.table())));
            files.extend(view.pictures.files(&stem, &chart));
        }
    }
    files
}

/// True if a file's name is one that [`files`] gives.
pub(in crate::results) fn is_comparison(name: &str) -> bool {
    let stem = name.strip_suffix(".csv").or(Format::stem(name));
    let parts = stem.and_then(|stem| stem.strip_prefix(PREFIX)).and_then(|rest| rest.split_once('_'));
    let is_quantity = |name: &str| Q::names().any(|known| known == name);
    parts.is_some_and(|(n, quantity)| n.parse::<usize>().is_ok() && is_quantity(quantity))
}
