//! Comparisons in words, as tables and as pictures.

use super::{Band, Comparison, Point, Verdict, four_digits};
use crate::case::comparison::ComparedQuantity;
use crate::plot::chart::{Chart, Panel, Series, Style, bounds, thinned};
use crate::plot::{Axis, StageView, palette::BLACK, palette::GREY, palette::color};
use crate::results::{Files, Format, Results, csv};
use crate::table::{Column, Table, Unit};
use crate::units::{Amount, Digits, joined, rounded, without_zeros};

pub(in crate::results) const PREFIX: &str = "compare_";

const DRAWN: f64 = 6.0;
const TOLERANCE: Style = Style::Line { color: GREY, width: 1.6, dash: &[6.0, 4.0] };
/// Tints of the reference's colour for its band, and for the band widened by its measurement error.
const MEASURED: Style = Style::Area { fill: (238, 174, 132), edge: Some((213, 94, 0)) };
const WIDENED: Style = Style::Area { fill: (249, 224, 206), edge: Some((213, 94, 0)) };

impl Comparison {
    /// True if a validation must fail; a demonstration is never a failure.
    pub fn is_failure(&self) -> bool {
        matches!(self.verdict, Verdict::Out | Verdict::NotReached) && !self.spec.demonstration
    }

    /// Verdict in words: `in`, `OUT`, `OUT, demonstration`.
    pub fn outcome(&self) -> String {
        let word = self.verdict.word();
        if self.spec.demonstration { format!("{word}, demonstration") } else { word.to_owned() }
    }

    /// Judged point with the largest relative difference.
    pub fn worst_point(&self) -> Option<&Point> {
        let size = |p: &Point| p.difference().map_or(-1.0, f64::abs);
        let judged = self.points.iter().filter(|point| point.judged);
        judged.max_by(|a, b| size(a).total_cmp(&size(b))).filter(|p| p.computed.is_some())
    }

    /// Largest difference, in short: `+2.1 %`, `3.4 mm above (+0.7 %)` with as many decimals as the band's end.
    pub fn worst(&self) -> Option<String> {
        let Some(band) = self.band else {
            return self.worst_point()?.difference().map(|d| format!("{:+.1} %", 100.0 * d));
        };
        let outside = band.outside()?;
        if outside == 0.0 {
            return Some("inside".to_owned());
        }
        let (end, side) = if outside < 0.0 { (band.accepted[0], "below") } else { (band.accepted[1], "above") };
        let decimals = four_digits(end).split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let percent = band.difference().map_or(String::new(), |share| format!(" ({:+.1} %)", 100.0 * share));
        Some(format!("{:.decimals$} {} {side}{percent}", outside.abs(), self.y.unit.symbol()))
    }

    fn worst_at(&self) -> Option<String> {
        let x = (1e3 * self.worst_point()?.x).round() / 1e3;
        let unit = if self.x.unit == Unit::None { "" } else { self.x.unit.symbol() };
        Some(format!("{} at {}", self.worst()?, format!("{} = {x} {unit}", self.x.label.to_lowercase()).trim_end()))
    }

    /// Accepted range: `5 %` of a curve, `467.3 to 468.5 mm`.
    pub fn accepted(&self) -> String {
        match self.band {
            Some(band) => interval_text(band.accepted, self.y.unit),
            None if self.spec.quantity.is_curve() => format!("{} %", rounded(100.0 * self.spec.tolerance)),
            None => "–".to_owned(),
        }
    }

    /// Outcome in a sentence: `punch_force against osu.csv: in, worst +2.1 % at punch travel = 20 mm (tolerance 5 %)`.
    pub fn sentence(&self) -> String {
        let worst = match (self.band.and_then(|band| band.computed), self.worst()) {
            (Some(computed), Some(worst)) => {
                format!(", {}, {worst} of {}", interval_text(computed, self.y.unit), self.accepted())
            }
            _ => self.worst_at().map_or(String::new(), |at| format!(", worst {at} (tolerance {})", self.accepted())),
        };
        format!("{} against {}: {}{worst}", self.spec.quantity.name(), self.spec.file(), self.outcome())
    }

    /// Computed value with the largest difference: of a band the one farthest out of it, or nearest to its end.
    pub fn farthest(&self) -> Option<Amount> {
        let Some(Band { computed, accepted: [least, most], .. }) = self.band else {
            return Some(self.amount(self.worst_point()?.computed?));
        };
        computed.map(|[low, high]| self.amount(if least - low > high - most { low } else { high }))
    }

    /// Target of that value: `24.3 mm ± 5 %`, `5.93–6.07 mm`.
    pub fn target(&self) -> Option<String> {
        let Some(band) = self.band else {
            let reference = self.amount(self.worst_point()?.reference);
            return Some(format!("{reference} ± {}", Amount::given_share(self.spec.tolerance)));
        };
        let [low, high] = band.accepted.map(|end| self.amount(end));
        let ((number, unit), (of_high, unit_of_high)) = (low.parts(), high.parts());
        Some(match (number == of_high, unit == unit_of_high) {
            (true, true) => high.to_string(),
            (_, true) => format!("{number}–{high}"),
            _ => format!("{low}–{high}"),
        })
    }

    fn amount(&self, value: f64) -> Amount {
        Amount::new(value, self.y.unit, Digits::Significant(3))
    }

    /// Result as a table, NaN where the run did not get: a row per point of a curve, or one of a band; no columns without data.
    pub fn table(&self) -> Table {
        let unit = self.y.unit;
        let (mut columns, differences) = match self.band {
            None if self.points.is_empty() => return Table::new(Vec::new()),
            None => {
                let values = |value: fn(&Point) -> f64| self.points.iter().map(value).collect();
                let columns = vec![
                    Column::new(self.x.key.clone(), self.x.label.clone(), self.x.unit, values(|p| p.x)),
                    Column::new("reference", "Reference", unit, values(|p| p.reference)),
                    Column::new("computed", "Computed", unit, values(|p| p.computed.unwrap_or(f64::NAN))),
                ];
                (columns, self.points.iter().map(Point::difference).collect())
            }
            Some(band) => {
                let ([low, high], outside) = (band.computed.unwrap_or([f64::NAN; 2]), band.outside());
                let columns = [
                    ("measured_low", "Least measured", band.measured[0]),
                    ("measured_high", "Largest measured", band.measured[1]),
                    ("accepted_low", "Least accepted", band.accepted[0]),
                    ("accepted_high", "Largest accepted", band.accepted[1]),
                    ("computed_low", "Least computed", low),
                    ("computed_high", "Largest computed", high),
                    ("outside", "Outside the band", outside.unwrap_or(f64::NAN)),
                ];
                let columns = columns.map(|(key, label, value)| Column::new(key, label, unit, vec![value]));
                (columns.to_vec(), vec![band.difference()])
            }
        };
        let percent = differences.iter().map(|share: &Option<f64>| 100.0 * share.unwrap_or(f64::NAN)).collect();
        columns.push(Column::new("difference", "Difference", Unit::Percent, percent));
        Table::new(columns)
    }

    fn chart(&self, view: &StageView) -> Option<Chart> {
        let (x, y) = (self.x.axis(), self.y.axis());
        let curve: Vec<(f64, f64)> = self.x.values.iter().copied().zip(self.y.values.iter().copied()).collect();
        let computed = Series::new("Computed", curve.clone(), Style::curve(0));
        let reference = self.compared_points(|point| Some(point.reference));
        let (low, high) = bounds(curve.iter().chain(&reference).map(|point| point.0));
        let (panels, text) = match self.band {
            None if self.points.is_empty() => return None,
            None => {
                let all = self.compared_points(|point| Some(100.0 * point.difference()?));
                let end = 100.0 * DRAWN * self.spec.tolerance;
                let drawn: Vec<_> = all.iter().copied().filter(|point| point.1.abs() <= end).collect();
                let differences = thinned(if 2 * (all.len() - drawn.len()) > self.points.len() { all } else { drawn });
                let tolerance = rounded(100.0 * self.spec.tolerance);
                let level = |value: f64| vec![(low, value), (high, value)];
                let below = [
                    Series::new(format!("Tolerance ±{tolerance} %"), level(tolerance), TOLERANCE),
                    Series::silent(level(-tolerance), TOLERANCE),
                    Series::silent(differences.clone(), Style::solid(BLACK, 1.6)),
                    Series::silent(differences, Style::Circles { color: BLACK }),
                ];
                let circles = Series::new("Reference", reference, Style::Circles { color: color(1) });
                let below = Panel::fit(x.clone(), Axis::named("Difference", Unit::Percent), 150.0, 0.0).with(below);
                let judged = self.points.iter().filter(|point| point.judged);
                let missed = judged.filter(|point| point.computed.is_none()).count();
                let worst = self.worst_at().map(|worst| format!("largest difference {worst}"));
                let text = joined(worst.into_iter().chain([format!("{missed} points not reached")]), "; ");
                (vec![Panel::fit(x, y, 270.0, 0.0).with([computed, circles]), below], text)
            }
            Some(band) => {
                let area = |name: &str, ends: [f64; 2], style| {
                    let corners = [(low, ends[0]), (high, ends[0]), (high, ends[1]), (low, ends[1])];
                    Series::new(format!("{name}, {}", interval_text(ends, self.y.unit)), corners.to_vec(), style)
                };
                let widened = area("Reference with its error", band.accepted, WIDENED);
                let widened = (band.accepted != band.measured).then_some(widened);
                let circles = band.computed.map(|ends| {
                    let inside = curve.iter().rev().copied().filter(|point| ends.contains(&point.1));
                    let points = inside.take(if ends[0] == ends[1] { 1 } else { usize::MAX }).collect();
                    let label = format!("Compared, {}", interval_text(ends, self.y.unit));
                    Series::new(label, points, Style::Circles { color: BLACK })
                });
                let series = widened.into_iter().chain([area("Reference", band.measured, MEASURED), computed]);
                let series = series.chain(circles.filter(|circles| !circles.points.is_empty()));
                let text = self.worst().unwrap_or_else(|| "the run ended before the compared value".to_owned());
                (vec![Panel::fit(x, y, 350.0, 0.0).with(series)], text)
            }
        };
        let columns = &self.spec.columns[usize::from(self.band.is_none())..].join(", ");
        let from = self.spec.source.as_ref().map_or_else(|| "source not stated".to_owned(), ToString::to_string);
        let notes = [
            format!("Reference: {}, {columns}: {from}.", self.spec.file()),
            format!("Accepted: {}; {text}.", self.accepted()),
            format!("Reason: {}.", self.spec.reason.trim_end_matches('.')),
        ];
        let demonstration = self.spec.demonstration.then(|| "A demonstration, not a validation.".to_owned());
        Some(view.chart("computed and reference", panels, demonstration.into_iter().chain(notes)))
    }

    fn compared_points(&self, y: impl Fn(&Point) -> Option<f64>) -> Vec<(f64, f64)> {
        self.points.iter().filter_map(|point| Some((point.x, y(point)?))).collect()
    }
}

fn interval_text(ends: [f64; 2], unit: Unit) -> String {
    let ([low, high], unit) = (ends.map(|end| without_zeros(&four_digits(end)).to_owned()), unit.symbol());
    if low == high { format!("{low} {unit}") } else { format!("{low} to {high} {unit}") }
}

pub(in crate::results) fn files(results: &Results) -> Files {
    let mut files = Vec::new();
    let Some(view) = results.views.first() else { return files };
    for (i, comparison) in results.comparisons.iter().enumerate() {
        let stem = format!("{PREFIX}{}_{}", i + 1, comparison.spec.quantity.name());
        if let Some(chart) = comparison.chart(view) {
            files.push((format!("{stem}.csv"), csv(&comparison.table())));
            files.extend(view.pictures.files(&stem, &chart));
        }
    }
    files
}

pub(in crate::results) fn is_comparison(name: &str) -> bool {
    let stem = name.strip_suffix(".csv").or(Format::stem(name));
    stem.and_then(|stem| stem.strip_prefix(PREFIX)).and_then(|rest| rest.split_once('_')).is_some_and(
        |(n, quantity)| n.parse::<usize>().is_ok() && ComparedQuantity::ALL.iter().any(|own| own.name() == quantity),
    )
}
