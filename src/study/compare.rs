//! Several runs and measured curves side by side: numbers, differences beyond their error bars, and pictures.

use super::measured_curve::MeasuredCurve;
use super::parallel_map::parallel_map;
use super::report::{Cell, ReportTable, StudyReport};
use super::run::Silent;
use super::{BaseCase, StudyError};
use crate::assess::{self, Light};
use crate::case::comparison::ComparedQuantity;
use crate::case::{Case, Solution};
use crate::model::Geometry;
use crate::plot::chart::{Chart, Panel, Scale, Series, Style};
use crate::plot::palette::color;
use crate::results::comparison::Computed;
use crate::table::Axis;
use crate::table::fields::{element, step};
use crate::units::{Amount, Unit};
use crate::verification::{Number, Origin, Outcome, Verification, Watch, answered, quick};
use std::convert::Infallible;

/// A case to compare.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// The case.
    pub case: Case,
    /// Overrides that set it apart; none of a case as it stands.
    pub overrides: Vec<String>,
}

/// A run of a comparison.
#[derive(Clone, Debug)]
pub struct Member {
    /// Letter in tables and legends.
    pub mark: String,
    /// Its overrides, or the name of its case.
    pub name: String,
    /// The solved case.
    pub solution: Solution,
    /// Error bars of its numbers.
    pub verification: Verification,
    /// Worst light of its verdict.
    pub light: Light,
    /// Labels of the rows with that light.
    pub rows: Vec<&'static str>,
}

/// Runs and measured curves side by side; differences are from the first run.
#[derive(Clone, Debug)]
pub struct SideBySide {
    /// The runs.
    pub members: Vec<Member>,
    /// The measured curves.
    pub curves: Vec<MeasuredCurve>,
}

/// Numbers that differ by less, over their size, are the same \[–\].
const SAME: f64 = 1e-9;
/// Measured points that are drawn as circles; more become a line.
const CIRCLES: usize = 60;

/// Overrides of a variant: `friction=0.12; tools.die.shoulder=5 mm`.
///
/// # Errors
/// When one gives no key a value.
pub fn variant(text: &str) -> Result<Vec<String>, StudyError> {
    let all: Vec<String> = text.split(';').map(str::trim).filter(|one| !one.is_empty()).map(str::to_owned).collect();
    let is_setting = |one: &String| super::variable::split_pair(one).is_some();
    if all.is_empty() || !all.iter().all(is_setting) {
        let help = "write KEY=VALUE, several joined by semicolons: \"friction=0.12; tools.die.shoulder=5 mm\"";
        return Err(StudyError::new(format!("the variant `{}` gives no key a value", text.trim()), help));
    }
    Ok(all)
}

/// Checks that cases and curves have something in common.
///
/// # Errors
/// When there is nothing to compare, a case is there twice, forces differ in kind, or a curve does not fit.
pub fn check(candidates: &[Candidate], curves: &[MeasuredCurve]) -> Result<(), StudyError> {
    let Some(first) = candidates.first().filter(|_| candidates.len() + curves.len() > 1) else {
        let help = "give another case, a variant such as --also \"friction=0.12\", or a curve.csv";
        return Err(StudyError::new("there is nothing to compare with: one is not enough", help));
    };
    let kind = |candidate: &Candidate| {
        let extent = candidate.case.model().extent();
        let geometry = match extent.geometry() {
            Geometry::Axisymmetric => "axisymmetric",
            Geometry::PlaneStrain => "plane strain",
        };
        format!("{geometry}, forces in {}", extent.force_unit().symbol())
    };
    for (i, one) in candidates.iter().enumerate() {
        let is_same = |other: &Candidate| (&other.case.path, &other.case.text) == (&one.case.path, &one.case.text);
        if candidates[..i].iter().any(is_same) {
            let help = "leave one out, or change something in it with --also";
            return Err(StudyError::new(format!("{} is there twice", name(one)), help));
        }
        if kind(one) != kind(first) {
            let what = format!("{} is {}, {} is {}", name(first), kind(first), name(one), kind(one));
            return Err(StudyError::new(
                what,
                "compare sections of one kind; `depth` in [blank] gives forces of the part",
            ));
        }
    }
    for curve in curves {
        let nothing = Computed::nothing(first.case.model());
        curve
            .points(&nothing)
            .map_err(|error| StudyError::new(error.to_string(), "check the columns and their units"))?;
    }
    Ok(())
}

fn name(candidate: &Candidate) -> String {
    if candidate.overrides.is_empty() { candidate.case.name.clone() } else { candidate.overrides.join(", ") }
}

impl SideBySide {
    /// Solves the cases, but for the first if it is `known`, each with quick error bars.
    ///
    /// # Errors
    /// When [`check`] fails, or a mistake of this program ends a run.
    pub fn solve(
        candidates: &[Candidate],
        curves: Vec<MeasuredCurve>,
        known: Option<(Solution, Verification)>,
        threads: usize,
        watch: &dyn Watch,
    ) -> Result<Self, StudyError> {
        check(candidates, &curves)?;
        let begun = usize::from(known.is_some());
        let mut solved: Vec<(Solution, Verification)> = known.into_iter().collect();
        let mut wrong = None;
        let one = |candidate: &Candidate| {
            let solution = BaseCase::solve(candidate.case.clone(), watch)?;
            let verification = quick(&solution, &Silent(watch));
            Ok((solution, verification))
        };
        let Ok(()) = parallel_map(&candidates[begun..], threads, watch, one, |result: Result<_, String>| {
            match result {
                Ok(pair) => solved.push(pair),
                Err(why) => wrong = wrong.take().or(Some(why)),
            }
            Ok::<_, Infallible>(())
        });
        if let Some(why) = wrong {
            return Err(StudyError::new(format!("a case cannot be run: {why}"), "try `stampflow check` on each"));
        }
        let members = candidates.iter().zip(solved).enumerate().map(|(i, (candidate, (solution, verification)))| {
            let (_, findings) = answered(&solution, Some(&verification));
            let light = assess::judgements(&findings).map(|row| row.light).max().unwrap_or(Light::Grey);
            let rows = assess::judgements(&findings).filter(|row| row.light == light && light >= Light::Amber);
            let rows = rows.map(|row| row.label).collect();
            let letter = (b'A'..=b'Z').nth(i).map(|letter| char::from(letter).to_string());
            let mark = letter.unwrap_or_else(|| (i + 1).to_string());
            Member { mark, name: name(candidate), solution, verification, light, rows }
        });
        Ok(Self { members: members.collect(), curves })
    }

    /// Labels of runs and measured curves.
    pub fn legend(&self) -> Vec<String> {
        let curves = self.curves.iter().enumerate().map(|(i, curve)| format!("{}: {}", i + 1, curve.name()));
        self.members.iter().map(Member::label).chain(curves).collect()
    }

    /// Headline, table and charts.
    pub fn report(&self) -> StudyReport {
        let charts = self.charts().into_iter().map(|(name, _, chart)| (name.to_owned(), chart));
        StudyReport {
            headline: format!("{} runs side by side.", self.members.len()),
            notes: self.legend(),
            tables: vec![self.table()],
            found: true,
            charts: charts.collect(),
        }
    }

    /// Every number of every run with its difference from the first, and the misfit of every curve.
    pub fn table(&self) -> ReportTable {
        let mut table =
            ReportTable::new("differences", &["Quantity", "Run", "Value", "Difference", "Beyond the error"]);
        let mut put = |label: &str, member: &Member, value: Cell, change: Cell, beyond: &str| {
            table.rows.push(vec![label.into(), member.mark.clone().into(), value, change, beyond.into()]);
        };
        for member in &self.members {
            let light = Cell::Light(member.light, member.rows.join(", "));
            put("Verdict", member, light, "".into(), "");
        }
        for member in &self.members {
            put("End", member, member.outcome().end.why.to_string().into(), "".into(), "");
        }
        for number in self.numbers() {
            let first = self.members.first().and_then(|member| member.number(&number));
            for (i, member) in self.members.iter().enumerate() {
                let own = member.number(&number);
                let change =
                    first.as_ref().filter(|_| i > 0).zip(own.as_ref()).map(|(first, own)| Change::new(first, own));
                let value = own.map_or_else(|| "–".into(), |amount| amount.into());
                let (cell, beyond) = match change {
                    Some(change) => (change.by.into(), if change.is_beyond { "yes" } else { "no" }),
                    None => ("".into(), ""),
                };
                put(number.quantity.label, member, value, cell, beyond);
            }
        }
        for (i, curve) in self.curves.iter().enumerate() {
            for member in &self.members {
                if let Some((misfit, used, all)) = member.misfit(curve) {
                    let note = format!("at {used} of {all} points");
                    put(&format!("Misfit of curve {}, r.m.s.", i + 1), member, misfit.into(), note.into(), "");
                }
            }
        }
        table
    }

    /// Numbers of all runs, but those that only the verdict has.
    fn numbers(&self) -> Vec<Number> {
        let mut numbers: Vec<Number> = Vec::new();
        for number in self.members.iter().flat_map(|member| &member.outcome().numbers) {
            if number.origin != Origin::Verdict && !numbers.iter().any(|known| known.is(number)) {
                numbers.push(number.clone());
            }
        }
        numbers
    }

    /// File name, subject and chart of load, thickness and section.
    pub fn charts(&self) -> Vec<(&'static str, &'static str, Chart)> {
        let Some(first) = self.members.first() else { return Vec::new() };
        let extent = first.solution.case.model().extent();
        let load = [step::TRAVEL.axis(extent), step::PUNCH_FORCE.axis(extent)];
        let thickness = [element::S0.axis(extent), element::THICKNESS.axis(extent)];
        let curve = |curve: fn(&Outcome) -> &[(f64, f64)], quantity: ComparedQuantity, axes: [Axis; 2]| {
            let runs = self
                .members
                .iter()
                .enumerate()
                .map(|(i, member)| Series::new(member.label(), curve(member.outcome()).to_vec(), Style::curve(i)));
            let mut series: Vec<Series> = runs.filter(|series| !series.points.is_empty()).collect();
            if series.is_empty() {
                return None;
            }
            let measured = self.curves.iter().enumerate().filter(|(_, curve)| curve.spec.quantity == quantity);
            for (i, measured) in measured {
                let points = measured.points(&Computed::nothing(first.solution.case.model())).unwrap_or_default();
                let points: Vec<(f64, f64)> = points.iter().map(|p| (p.x, p.reference)).collect();
                let place = self.members.len() + i;
                let is_line = points.len() > CIRCLES;
                let look = if is_line { Style::curve(place) } else { Style::Circles { color: color(place) } };
                series.push(Series::new(format!("{}: {}", i + 1, measured.name()), points, look));
            }
            let [x, y] = axes;
            Some(Chart::new("", vec![Panel::fit(x, y, 350.0, 0.0).with(series)], Vec::new()))
        };
        let sections = self.sections();
        let all = [
            ("compare_load", "punch force over the travel", curve(|o| &o.load, ComparedQuantity::PunchForce, load)),
            (
                "compare_thickness",
                "thickness over the blank",
                curve(|o| &o.thickness, ComparedQuantity::ThicknessAtS0, thickness),
            ),
            ("compare_sections", "the sections at the end", sections),
        ];
        all.into_iter().filter_map(|(name, about, chart)| Some((name, about, chart?))).collect()
    }

    /// Mid-surfaces of all runs at the end.
    fn sections(&self) -> Option<Chart> {
        let line = |(i, member): (usize, &Member)| {
            let frame = member.solution.stages.last()?.frames.last()?;
            let points = frame.nodes.iter().map(|node| (node.r, node.z)).collect();
            Some(Series::new(member.label(), points, Style::curve(i)))
        };
        let series: Vec<Series> = self.members.iter().enumerate().filter_map(line).collect();
        let all = || series.iter().flat_map(|series| &series.points);
        let range = |of: fn(&(f64, f64)) -> f64| {
            all().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
        };
        all().next()?;
        let scale = Scale::Section { x: range(|p| p.0), y: range(|p| p.1) };
        let (x, y) = (Axis::named("r", Unit::Mm), Axis::named("z", Unit::Mm));
        Some(Chart::new("", vec![Panel::new(x, y, scale).with(series)], Vec::new()))
    }
}

/// Difference of a number between two runs.
struct Change {
    by: Amount,
    /// Whether it exceeds both error bars together.
    is_beyond: bool,
}

impl Change {
    fn new(first: &Amount, other: &Amount) -> Self {
        let by = other.value - first.value;
        // Runs of one mesh err alike: the sum of the bars is on the safe side.
        let open = first.bar().unwrap_or(0.0) + other.bar().unwrap_or(0.0);
        let is_beyond = by.abs() > SAME * first.value.abs() && by.abs() > open;
        Self { by: Amount::new(by, first.unit, first.digits), is_beyond }
    }
}

impl Member {
    /// Mark and name: `B: friction=0.12`.
    pub fn label(&self) -> String {
        format!("{}: {}", self.mark, self.name)
    }

    /// Numbers, curves and end of the run.
    pub fn outcome(&self) -> &Outcome {
        &self.verification.outcomes[0]
    }

    /// A number with its error bar.
    fn number(&self, number: &Number) -> Option<Amount> {
        self.verification.numbers.iter().find(|own| own.is(number)).map(|own| own.quantity.amount)
    }

    /// Root mean square of computed less measured, the number of points that the run has, and of all points.
    fn misfit(&self, curve: &MeasuredCurve) -> Option<(Amount, usize, usize)> {
        let computed = Computed::of(self.solution.stages.first()?);
        let points = curve.points(&computed).ok()?;
        let squares: Vec<f64> = points.iter().filter_map(|p| Some((p.computed? - p.reference).powi(2))).collect();
        let rms = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        let unit = computed.columns(curve.spec.quantity).1.unit;
        let amount = Amount::new(rms, unit, crate::units::Digits::Significant(3));
        (!squares.is_empty()).then_some((amount, squares.len(), points.len()))
    }
}
