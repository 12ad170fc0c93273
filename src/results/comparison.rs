//! Computed curves beside the references of a case: points of a curve, and bands that values without places span.

mod output;

pub(super) use output::{PREFIX, files, is_comparison};

use crate::case::{Case, Solution, comparison::ComparedQuantity as Q, comparison::Spec};
use crate::forming_limit::Paths;
use crate::model::{Extent, Model};
use crate::numerics::interpolated;
use crate::plot::fields::{element, step};
use crate::results::tables::edge_diameter;
use crate::solver::solution::{ElementRecord, StageSolution, StepRecord};
use crate::table::{Column, Csv, Field, Record, Unit};
use crate::units::{Amount, Digits};

/// Reference below which no relative difference is taken \[mm, N, N/mm\]: nobody measures so finely.
const NOTHING: f64 = 1e-9;

/// Reason why a comparison cannot be made: the reference file does not fit the case.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct CompareError(String);

named! {
    /// Agreement of a run with a reference.
    pub enum Verdict;
    /// Name in text.
    fn word;
    In: "in", "Everything lies within the tolerance or the band.";
    Out: "OUT", "Something lies outside.";
    NotReached: "not reached", "The run ended too early; what it reached lies within the tolerance.";
    NoData: "no data", "The reference file is optional and missing.";
}

/// Reference value and its computed counterpart, in solver units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Abscissa.
    pub x: f64,
    /// Ordinate of the reference.
    pub reference: f64,
    /// Computed ordinate; `None` if the run did not reach it.
    pub computed: Option<f64>,
    /// True inside the range that is judged; the others are only drawn.
    pub judged: bool,
    line: usize,
}

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

/// Outcome of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Request of the case.
    pub spec: Spec,
    /// Points of a reference curve with the computed values; else empty.
    pub points: Vec<Point>,
    /// Band with the computed values, if the reference is one.
    pub band: Option<Band>,
    /// Agreement.
    pub verdict: Verdict,
    /// Computed curve that the compared values were taken from.
    x: Column,
    y: Column,
}

impl Solution {
    /// Comparisons with the results of the first stage and with the ring of the last.
    pub fn comparisons(&self) -> Result<Vec<Comparison>, CompareError> {
        let Some(first) = self.stages.first() else { return Ok(Vec::new()) };
        let ring = self.case.springback.ring.and_then(|ring| ring.openings(&self.stages));
        let ring = ring.as_ref().map(|(own, all)| (*own, &all[..]));
        comparisons(&self.case, &Computed { ring, ..Computed::of(first) })
    }
}

/// Comparisons of a case with computed results.
pub fn comparisons(case: &Case, computed: &Computed) -> Result<Vec<Comparison>, CompareError> {
    case.compare.iter().map(|spec| compare(spec, computed)).collect()
}

/// Compares a run with a reference.
///
/// A computed curve is interpolated at the reference's abscissae, each where it is reached first, and held for one interval
/// beyond either end. A band is that of all measured values, each with its error.
pub fn compare(spec: &Spec, computed: &Computed) -> Result<Comparison, CompareError> {
    let (x, y) = computed.columns(spec.quantity);
    let (mut points, mut band) = (Vec::new(), None);
    let verdict = if spec.data.is_none() && spec.optional {
        Verdict::NoData
    } else if spec.quantity.is_curve() {
        let reference = Reference::new(spec)?;
        points = reference.points([&x, &y])?;
        let mut judged = points.iter().filter(|point| point.judged);
        if let Some(Point { x, reference: value, line, .. }) = judged.clone().find(|p| p.reference.abs() < NOTHING) {
            let remedy = "which no relative difference can be taken from; narrow `range`";
            let value = four_digits(*value);
            return reference.refuse(format!(", line {line}: the reference value is {value} at {x}, {remedy}"));
        }
        let is_beyond = |point: &Point| point.difference().is_some_and(|d| d.abs() > spec.tolerance || d.is_nan());
        let needs_all = matches!(spec.quantity, Q::ThicknessAtS0 | Q::ThicknessAtRadius);
        match judged.clone().any(is_beyond) {
            _ if needs_all && !computed.complete => Verdict::NotReached,
            true => Verdict::Out,
            false if judged.all(|point| point.computed.is_some()) => Verdict::In,
            false => Verdict::NotReached,
        }
    } else {
        band = Some(Reference::new(spec)?.band([&x, &y], computed)?);
        let verdict = |outside| if outside == 0.0 { Verdict::In } else { Verdict::Out };
        band.and_then(|band| band.outside()).map_or(Verdict::NotReached, verdict)
    };
    Ok(Comparison { spec: spec.clone(), points, band, verdict, x, y })
}

struct Reference<'a> {
    spec: &'a Spec,
    csv: &'a Csv,
}

impl<'a> Reference<'a> {
    fn new(spec: &'a Spec) -> Result<Self, CompareError> {
        let missing = || CompareError(format!("{} is not there", spec.reference.display()));
        Ok(Self { spec, csv: spec.data.as_ref().ok_or_else(missing)? })
    }

    fn refuse<T>(&self, what: String) -> Result<T, CompareError> {
        Err(CompareError(format!("{}{what}", self.spec.reference.display())))
    }

    fn column(&self, header: &str, computed: &Column) -> Result<(Vec<Option<f64>>, f64), CompareError> {
        let Some(at) = self.csv.column(header) else {
            return self.refuse(format!(" has no column `{header}`; it has {}", self.csv.names()));
        };
        let (unit, factor) = match self.csv.unit(at) {
            // The name of a plain number ends in no unit.
            Err(_) if computed.unit == Unit::None => (Unit::None, 1.0),
            Err(error) => return self.refuse(format!(": {error}")),
            Ok(unit) => unit,
        };
        if unit != computed.unit {
            let with = computed.axis().text();
            return self.refuse(format!(": column `{header}` cannot be compared with the computed {with}"));
        }
        let value = |row: &Record| {
            let place = format!(", line {}, column `{header}`", row.line);
            let value = row.number(at).or_else(|error| self.refuse(format!("{place}: {error}")))?.map(|v| v * factor);
            if value.is_none_or(|value| value.abs() <= unit.largest()) {
                return Ok(value);
            }
            let most = format!("its magnitude must be at most {:e} {}", unit.largest(), unit.symbol());
            let remedy = "check the number and the unit at the end of the header";
            self.refuse(format!("{place}: {} is out of range, {most}: {remedy}", row.quoted(at)))
        };
        Ok((self.csv.rows.iter().map(value).collect::<Result<_, _>>()?, factor))
    }

    fn points(&self, [x, y]: [&Column; 2]) -> Result<Vec<Point>, CompareError> {
        let headers = &self.spec.columns;
        let ((xs, of_x), (ys, _)) = (self.column(&headers[0], x)?, self.column(&headers[1], y)?);
        let (low, high) = self.spec.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let range = low * of_x..=high * of_x;
        let mut rising: Vec<(f64, f64)> = x.values.iter().copied().zip(y.values.iter().copied()).collect();
        rising.dedup_by(|next, last| next.0 <= last.0);
        let point = |((x, y), row): ((Option<f64>, Option<f64>), &Record)| {
            let (x, reference) = x.zip(y)?;
            Some(Point { x, reference, computed: held_at_ends(&rising, x), judged: range.contains(&x), line: row.line })
        };
        let points: Vec<Point> = xs.into_iter().zip(ys).zip(&self.csv.rows).filter_map(point).collect();
        if points.iter().any(|point| point.judged) {
            return Ok(points);
        }
        self.refuse(format!(" has no rows in columns `{}` and `{}` within the range asked for", headers[0], headers[1]))
    }

    fn band(&self, [x, y]: [&Column; 2], computed: &Computed) -> Result<Band, CompareError> {
        let spec = self.spec;
        let errors = spec.error.as_ref().map_or(Ok(Vec::new()), |header| Ok(self.column(header, y)?.0))?;
        if let Some(row) = errors.iter().position(|error| error.is_some_and(|error| error < 0.0)) {
            let (line, column) = (self.csv.rows[row].line, spec.error.as_deref().unwrap_or_default());
            return self.refuse(format!(", line {line}: the error of measurement in column `{column}` is negative"));
        }
        let mut values = Vec::new();
        for header in &spec.columns {
            let column = self.column(header, y)?.0.into_iter().enumerate();
            let error = |row: usize| errors.get(row).copied().flatten().unwrap_or(0.0);
            values.extend(column.filter_map(|(row, value)| Some((value?, error(row)))));
        }
        let measured = interval(values.iter().map(|v| v.0));
        let accepted = interval(values.iter().flat_map(|(value, error)| [value - error, value + error]));
        let Some((measured, accepted)) = measured.zip(accepted) else {
            let columns = spec.columns.join(", ");
            return self.refuse(format!(" has no values in {columns}, which the band should span"));
        };
        let all = || y.values.iter().copied();
        let compared = match spec.quantity {
            Q::Thickness => interval(all()),
            Q::PeakForce => interval(all().reduce(f64::max)),
            Q::PeakTravel => interval(peak(&x.values).map(|at| y.values[at])),
            Q::RingOpening => interval(computed.ring.map(|(opening, _)| opening)),
            _ => interval(all().next_back()),
        };
        // A run may end at its peak.
        let is_known = computed.complete || spec.quantity == Q::PeakTravel;
        Ok(Band { measured, accepted, computed: compared.filter(|_| is_known) })
    }
}

fn held_at_ends(rising: &[(f64, f64)], x: f64) -> Option<f64> {
    let ([first, second, ..], [.., before, last]) = (rising, rising) else { return None };
    (first.0 - x <= second.0 - first.0 && x - last.0 <= last.0 - before.0).then(|| interpolated(rising, x))
}

fn interval(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    values.into_iter().map(|v| [v, v]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

fn four_digits(value: f64) -> String {
    Amount::number(value).to(Digits::Significant(4)).to_string()
}

fn peak(values: &[f64]) -> Option<usize> {
    let at = (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b]))?;
    (at + 1 < values.len()).then_some(at)
}

impl Point {
    /// Computed minus reference, over the reference \[–\]; `None` if not reached or the reference is 0.
    pub fn difference(&self) -> Option<f64> {
        let computed = self.computed.filter(|_| self.reference.abs() >= NOTHING);
        computed.map(|computed| (computed - self.reference) / self.reference.abs())
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
        let end = self.accepted[usize::from(outside >= 0.0)].abs();
        if outside == 0.0 { Some(0.0) } else { (end >= NOTHING).then(|| outside / end) }
    }
}

/// Computed values of a stage for comparison.
#[derive(Clone, Copy, Debug)]
pub struct Computed<'a> {
    /// Extent of the section, which its forces refer to.
    pub extent: Extent,
    /// Length of the undeformed blank from the axis or symmetry plane \[mm\].
    pub length: f64,
    /// Every solved step.
    pub steps: &'a [StepRecord],
    /// Elements of the last frame from the axis outward.
    pub elements: &'a [ElementRecord],
    /// Strain path of every element, if they were kept.
    pub paths: Option<&'a Paths>,
    /// True if the stage came to its end.
    pub complete: bool,
    /// Opening of the ring that is cut from the part, and lower edges and openings of rings along its wall \[mm\].
    pub ring: Option<(f64, &'a [(f64, f64)])>,
}

impl<'a> Computed<'a> {
    /// Values of a solved stage.
    pub fn of(stage: &'a StageSolution) -> Self {
        let elements = stage.frames.last().map_or(&[][..], |frame| &frame.elements);
        let (steps, paths, complete) = (&stage.steps[..], Some(&stage.paths), stage.stop.is_complete());
        Self { steps, elements, paths, complete, ..Self::nothing(&stage.model) }
    }

    /// No values, to check references before anything is solved.
    pub fn nothing(model: &Model) -> Self {
        let (extent, length) = (model.extent(), model.blank.length);
        Self { extent, length, steps: &[], elements: &[], paths: None, complete: true, ring: None }
    }

    /// Judged points of a reference curve with the computed values; a reference may be 0.
    pub fn points(&self, spec: &Spec) -> Result<Vec<Point>, CompareError> {
        let (x, y) = self.columns(spec.quantity);
        Ok(Reference::new(spec)?.points([&x, &y])?.into_iter().filter(|point| point.judged).collect())
    }

    /// Abscissa and ordinate of a quantity; what a band is compared with is in the ordinate.
    pub fn columns(&self, quantity: Q) -> (Column, Column) {
        let step = |field: Field<StepRecord>| field.column(self.extent, self.steps);
        let element = |field: Field<ElementRecord>| field.column(self.extent, self.elements);
        let over_travel = |values| (step(step::TRAVEL), values);
        match quantity {
            Q::PunchForce | Q::PeakForce => over_travel(step(step::PUNCH_FORCE)),
            Q::Travel | Q::PeakTravel => (step(step::PUNCH_FORCE), step(step::TRAVEL)),
            Q::ThicknessAtS0 => (element(element::S0), element(element::THICKNESS)),
            Q::ThicknessAtRadius | Q::Thickness => (element(element::R), element(element::THICKNESS)),
            Q::StrainPath => self.path(),
            Q::DrawInAtTravel | Q::DrawIn => over_travel(step(step::DRAW_IN)),
            Q::Thinnest => over_travel(step(step::THINNEST)),
            Q::EdgeDiameter => over_travel(edge_diameter(self.extent.geometry(), self.length, self.steps)),
            Q::RingOpening => {
                let (from, openings) = self.ring.map_or(&[][..], |(_, all)| all).iter().copied().unzip();
                let from = Column::new("ring_from", "Lower edge of the ring over the bottom", Unit::Mm, from);
                (from, Column::new("ring_opening", "Opening of the slit ring", Unit::Mm, openings))
            }
        }
    }

    fn path(&self) -> (Column, Column) {
        let thinner = |a: &usize, b: &usize| self.elements[*a].thickness.total_cmp(&self.elements[*b].thickness);
        let thinnest = (0..self.elements.len()).min_by(thinner);
        let path = thinnest.zip(self.paths).map_or_else(Vec::new, |(element, paths)| paths.of(element));
        let (minor, major) = path.into_iter().map(|[minor, major]| (minor, major)).unzip();
        let strain = |key, label, values| Column::new(key, label, Unit::None, values);
        (strain("strain_major", "Major true strain", major), strain("strain_minor", "Minor true strain", minor))
    }
}
