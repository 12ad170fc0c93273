//! Several runs and measured curves side by side: numbers, differences beyond their error bars, and pictures.

use super::{run::Silent, verify::Outcome, verify::verify, *};
use crate::assess::{self, FailureMode, error_bars::ErrorBars};
use crate::case::comparison::{ComparedQuantity, Spec};
use crate::plot::{chart::Panel, chart::Series, chart::Style, palette::color, sections};
use crate::results::{comparison::Computed, summary::section_of};
use crate::units::Digits;

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
    /// Letter in tables.
    mark: String,
    /// Letter with its overrides or the name of its case: `B: friction=0.12`.
    pub label: String,
    /// The solved case.
    pub solution: Solution,
    outcome: Outcome,
    /// Worst light of its verdict, with the labels of all red and amber rows.
    light: Cell,
    /// Kind of its end, or where it tears.
    end: String,
}

/// Runs and measured curves side by side; differences are from the first run.
#[derive(Clone, Debug)]
pub struct SideBySide {
    /// The runs.
    pub members: Vec<Member>,
    curves: Vec<Spec>,
}

/// Numbers that differ by less, over their size, are the same \[–\].
const SAME: f64 = 1e-9;

/// Overrides of a variant: `friction=0.12; tools.die.shoulder=5 mm`.
pub fn variant(text: &str) -> Result<Vec<String>> {
    let all: Vec<String> = text.split(';').map(str::trim).filter(|one| !one.is_empty()).map(str::to_owned).collect();
    let is_variant = !all.is_empty() && all.iter().all(|one| split_pair(one).is_some());
    let help = "write KEY=VALUE, several joined by semicolons: \"friction=0.12; tools.die.shoulder=5 mm\"";
    ensure(is_variant, format!("the variant `{}` gives no key a value", text.trim()), help).map(|()| all)
}

impl Candidate {
    fn name(&self) -> String {
        let overrides = joined(self.overrides.iter().map(|text| in_words(text)), ", ");
        if overrides.is_empty() { self.case.name.clone() } else { overrides }
    }
}

/// Checks that cases and curves have something in common.
pub fn check(candidates: &[Candidate], curves: &[Spec]) -> Result<()> {
    let Some(first) = candidates.first().filter(|_| candidates.len() + curves.len() > 1) else {
        let help = "give another case, a variant such as --also \"friction=0.12\", or a curve.csv";
        return fail("there is nothing to compare with: one is not enough", help);
    };
    for (i, one) in candidates.iter().enumerate() {
        let is_same = |other: &Candidate| (&other.case.path, &other.case.text) == (&one.case.path, &one.case.text);
        let help = "leave one out, or change something in it with --also";
        ensure(!candidates[..i].iter().any(is_same), format!("{} is there twice", one.name()), help)?;
        let [own, other] = [first, one].map(|candidate| candidate.case.model().extent());
        let what = format!("{} is {}, {} is {}", first.name(), section_of(own), one.name(), section_of(other));
        let is_alike = (own.geometry(), own.force_unit()) == (other.geometry(), other.force_unit());
        ensure(is_alike, what, "compare sections of one kind; `depth` in [blank] gives forces of the part")?;
    }
    for curve in curves {
        let points = Computed::nothing(first.case.model()).points(curve);
        points.map_err(|error| StudyError::new(error.to_string(), "check the columns and their units"))?;
    }
    Ok(())
}

impl SideBySide {
    /// Solves the cases, but for the first if it is `known`, each with error bars.
    pub fn solve(
        candidates: &[Candidate], curves: Vec<Spec>, known: Option<(Solution, ErrorBars)>, threads: usize,
        watch: &dyn Watch,
    ) -> Result<Self> {
        check(candidates, &curves)?;
        let jobs = &candidates[usize::from(known.is_some())..];
        let mut solved: Vec<(Solution, ErrorBars)> = known.into_iter().collect();
        let one = |i: usize| {
            let solution = BaseCase::solve(jobs[i].case.clone(), watch)?;
            let bars = verify(&solution, &Silent(watch)).bars;
            Ok((solution, bars))
        };
        let ended = parallel_map(jobs.len(), threads, watch, one, |result: Result<_, String>| {
            solved.push(result?);
            watch.ran(solved.len(), candidates.len());
            Ok(())
        });
        let help = "try `stampflow check` on each";
        ended.map_err(|reason: String| StudyError::new(format!("a case cannot be run: {reason}"), help))?;
        let new = |(i, (candidate, solved))| Member::new(i, candidate, solved, watch);
        Ok(Self { members: candidates.iter().zip(solved).enumerate().map(new).collect(), curves })
    }

    /// Labels of runs and measured curves.
    pub fn legend(&self) -> Vec<String> {
        let curves = self.curves.iter().enumerate().map(|(i, curve)| format!("{}: {}", i + 1, curve.file()));
        self.members.iter().map(|member| member.label.clone()).chain(curves).collect()
    }

    /// Headline, table and charts.
    pub fn report(&self) -> StudyReport {
        let charts = self.charts().into_iter().map(|(name, _, chart)| (name.to_owned(), chart));
        let headline = format!("{} runs side by side.", self.members.len());
        let notes = self.legend().into_iter().chain([Self::DIFFERENCES.to_owned()]).collect();
        let tables = vec![ReportTable { printed: Some(Box::new(self.overview())), ..self.table() }];
        StudyReport { headline, notes, tables, found: true, charts: charts.collect() }
    }

    /// Every number of every run with its difference from the first, and the misfit of every curve.
    pub fn table(&self) -> ReportTable {
        let columns = ["Quantity", "Run", "Value", "Difference", "Beyond the error"];
        let mut rows = Vec::new();
        let mut add = |label: &str, member: &Member, value: Cell, change: Cell, beyond: &str| {
            rows.push([label.into(), member.mark.clone().into(), value, change, beyond.into()]);
        };
        self.members.iter().for_each(|member| add("Verdict", member, member.light.clone(), "".into(), ""));
        self.members.iter().for_each(|member| add("End", member, member.end.as_str().into(), "".into(), ""));
        for number in self.numbers() {
            let first = self.members[0].number(number);
            for (i, member) in self.members.iter().enumerate() {
                let own = member.number(number);
                let (mut change, mut beyond) = ("".into(), "");
                if let Some((first, own)) = first.filter(|_| i > 0).zip(own) {
                    let base = first.quantity.amount;
                    let difference = own.quantity.amount.value - base.value;
                    // Runs of one mesh err alike: the sum of the bars is on the safe side.
                    let bars = first.half().zip(own.half()).map(|(a, b)| (SAME * base.value.abs()).max(a + b));
                    change = Amount { value: difference, bar: bars, ..base }.into();
                    beyond = bars.map_or("", |bars| if difference.abs() > bars { "yes" } else { "no" });
                }
                let value = own.map_or_else(|| "–".into(), |own| own.quantity.amount.into());
                add(number.quantity.label, member, value, change, beyond);
            }
        }
        for (i, curve) in self.curves.iter().enumerate() {
            for (member, misfit) in self.members.iter().filter_map(|member| Some((member, member.misfit(curve)?))) {
                add(&format!("Misfit of curve {}, r.m.s.", i + 1), member, misfit.0.into(), misfit.1.into(), "");
            }
        }
        ReportTable::new("differences", &columns, rows)
    }

    /// Remark on the [`overview`](Self::overview).
    pub const DIFFERENCES: &str =
        "in parentheses: differences from the first beyond both error bars, and those without bars";

    /// A row for every quantity, a column for every run: its value, and the difference where it is none of the error bars.
    pub fn overview(&self) -> ReportTable {
        let marks = self.members.iter().map(|member| member.mark.as_str());
        let shown = |cells: &[Cell]| {
            let [value, difference, beyond] = [2, 3, 4].map(|i| cells[i].to_string());
            let is_zero = matches!(&cells[3], Cell::Amount(by) if by.with_value(0.0).to_string() == difference);
            if !is_zero && !difference.is_empty() && beyond != "no" { format!("{value} ({difference})") } else { value }
        };
        let rows = self.table().rows;
        let rows = rows.chunk_by(|a, b| a[0].to_string() == b[0].to_string()).map(|of_quantity| {
            let own = |member: &Member| of_quantity.iter().rfind(|cells| cells[1].to_string() == member.mark);
            let values = self.members.iter().map(|one| own(one).map_or("–".into(), |cells| shown(cells).into()));
            [of_quantity[0][0].clone()].into_iter().chain(values).collect::<Vec<_>>()
        });
        ReportTable::new("overview", &["Quantity"].into_iter().chain(marks).collect::<Vec<_>>(), rows)
    }

    fn numbers(&self) -> Vec<&Number> {
        let mut numbers: Vec<&Number> = Vec::new();
        for number in self.members.iter().flat_map(|member| &member.outcome.numbers) {
            let decides = ["tearing", "forming_limit"].contains(&number.quantity.key);
            let is_new = (decides || number.origin != Origin::Verdict) && !numbers.iter().any(|known| known.is(number));
            numbers.extend(is_new.then_some(number));
        }
        numbers
    }

    /// File name, subject and chart of load, thickness and section.
    pub fn charts(&self) -> Vec<(&'static str, &'static str, Chart)> {
        let (load, thickness) = (ComparedQuantity::PunchForce, ComparedQuantity::ThicknessAtS0);
        let all = [
            ("compare_load", "punch force over the travel", self.curve(load, |outcome| &outcome.load)),
            ("compare_thickness", "thickness over the blank", self.curve(thickness, |outcome| &outcome.thickness)),
            ("compare_sections", "the sections at the end", self.sections()),
        ];
        let chart = |about, panel| Chart::new(format!("Compared: {about}"), vec![panel], Vec::new());
        all.into_iter().filter_map(|(name, about, panel)| Some((name, about, chart(about, panel?)))).collect()
    }

    fn curve(&self, quantity: ComparedQuantity, curve: fn(&Outcome) -> &[(f64, f64)]) -> Option<Panel> {
        let mut series = self.series(|member| curve(&member.outcome).to_vec());
        let model = self.members.first().filter(|_| !series.is_empty())?.solution.case.model();
        let (x, y) = Computed::nothing(model).columns(quantity);
        for (i, measured) in self.curves.iter().enumerate().filter(|(_, curve)| curve.quantity == quantity) {
            let points = Computed::nothing(model).points(measured).unwrap_or_default();
            let points: Vec<(f64, f64)> = points.iter().map(|p| (p.x, p.reference)).collect();
            let style = Style::Circles { color: color(self.members.len() + i) };
            series.push(Series::new(format!("{}: {}", i + 1, measured.file()), points, style));
        }
        Some(Panel::fit(x.axis(), y.axis(), 350.0, 0.0).with(series))
    }

    fn sections(&self) -> Option<Panel> {
        let series = self.series(|member| {
            let frame = member.solution.stages.last().and_then(|stage| stage.frames.last());
            frame.map_or_else(Vec::new, |frame| frame.nodes.iter().map(|node| (node.r, node.z)).collect())
        });
        // The tools are those of the first run.
        let stage = self.members.first()?.solution.stages.last()?;
        let (model, frame) = (&stage.model, stage.frames.last()?);
        let window = sections::window(frame.nodes.iter(), model.blank.thickness);
        let tools = sections::tools(model, Some(frame), window[0].1);
        Some(sections::panel(model.geometry, window).with(tools).with(series))
    }

    fn series(&self, points: impl Fn(&Member) -> Vec<(f64, f64)>) -> Vec<Series> {
        let members = self.members.iter().enumerate();
        let series = members.map(|(i, member)| Series::new(member.label.as_str(), points(member), Style::curve(i)));
        series.filter(|series| !series.points.is_empty()).collect()
    }
}

impl Member {
    fn new(i: usize, candidate: &Candidate, (solution, bars): (Solution, ErrorBars), watch: &dyn Watch) -> Self {
        let (answer, findings) = judge(&solution, Some(&bars), false, &Silent(watch));
        let rows = [Light::Red, Light::Amber].map(|light| assess::by_advice(&findings, light)).into_iter().flatten();
        let light = Cell::Light(answer.light, rows.flatten().map(|row| row.label).collect::<Vec<_>>().join(", "));
        let mark = (b'A'..=b'Z').nth(i).map_or((i + 1).to_string(), |letter| char::from(letter).to_string());
        let outcome = Outcome { numbers: bars.numbers, ..Outcome::of(&solution, None) };
        let tears = answer.failures.first() == Some(&FailureMode::Tears);
        let end = if tears { answer.sentence } else { outcome.end.kind.to_owned() };
        Self { label: format!("{mark}: {}", candidate.name()), mark, solution, outcome, light, end }
    }

    fn number(&self, number: &Number) -> Option<&Number> {
        self.outcome.numbers.iter().find(|own| own.is(number))
    }

    fn misfit(&self, curve: &Spec) -> Option<(Amount, String)> {
        let computed = Computed::of(self.solution.stages.first()?);
        let points = computed.points(curve).ok()?;
        let squares: Vec<f64> = points.iter().filter_map(|p| Some((p.computed? - p.reference).powi(2))).collect();
        let rms = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        let amount = Amount::new(rms, computed.columns(curve.quantity).1.unit, Digits::Significant(3));
        (!squares.is_empty()).then(|| (amount, format!("at {} of {} points", squares.len(), points.len())))
    }
}
