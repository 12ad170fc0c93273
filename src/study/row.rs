//! What came of one design, and its line in a table.

use super::plan::{Design, Designs};
use super::zone::Zone;
use crate::assess::{self, Finding, Light};
use crate::case::Solution;
use crate::study::verify::{Number, Of, Outcome, Watch, quick};
use crate::units::rounded;
use crate::units::{Limits, Sense};

/// A design, and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What was run.
    pub design: Design,
    /// SHA-256 of the case's text with its settings and of the files beside it, the first 16 digits; empty where it is no case.
    pub inputs: String,
    /// What came out, or why nothing did.
    pub result: Result<Solved, String>,
    /// Time that it took \[s\].
    pub seconds: f64,
}

/// What came of a design that is a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// Its numbers, its curves, and how it ended.
    pub outcome: Outcome,
    /// The worst light of its verdict.
    pub light: Light,
    /// The verdict's rows that are red, and those that are amber.
    pub red: Vec<&'static str>,
    /// See `red`.
    pub amber: Vec<&'static str>,
    /// Every way in which it fails; empty where it is sound.
    pub fails: Vec<Zone>,
    /// Half the error bar of each number, in its unit; `None` where it has none. Empty where none were asked for.
    pub bars: Vec<Option<f64>>,
    /// Whether the sheet tears.
    pub tears: bool,
    /// The verdict's rows.
    pub judged: Vec<Judged>,
}

/// A row of the verdict, as numbers have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// The row.
    pub key: &'static str,
    /// What tables call it.
    pub label: &'static str,
    /// Its number, where it has one.
    pub value: Option<f64>,
    /// Where that turns amber, and where red.
    pub limits: Option<Limits>,
}

impl Judged {
    fn of(finding: &Finding) -> Self {
        Self { key: finding.key, label: finding.label, value: finding.value(), limits: finding.limits() }
    }

    /// How far it is from red, over the limit: below 0 where it is red, 0 at the limit \[–\]; `None` where no number says it.
    pub fn to_red(&self) -> Option<f64> {
        self.to(|limits| limits.red)
    }

    /// From amber, likewise.
    pub fn to_amber(&self) -> Option<f64> {
        self.to(|limits| limits.amber.or(limits.red))
    }

    fn to(&self, limit: fn(&Limits) -> Option<f64>) -> Option<f64> {
        let (value, limits) = self.value.zip(self.limits)?;
        let limit = limit(&limits).filter(|limit| *limit != 0.0)?;
        let inside = if limits.sense == Sense::AtMost { limit - value } else { value - limit };
        Some(inside / limit.abs())
    }
}

impl Solved {
    /// From a solved case.
    pub fn of(solution: &Solution) -> Self {
        let findings = assess::after_one_of_many(&solution.case, &solution.stages);
        let of = |light: Light| assess::judgements(&findings).filter(|f| f.light == light).map(|f| f.key).collect();
        let outcome = Outcome::found(solution, None, &findings);
        Self {
            fails: Zone::all(&solution.stages, &findings),
            bars: Vec::new(),
            outcome,
            light: assess::judgements(&findings).map(|finding| finding.light).max().unwrap_or(Light::Grey),
            red: of(Light::Red),
            amber: of(Light::Amber),
            tears: solution.stages.iter().any(|stage| assess::tears_at(stage).is_some()),
            judged: assess::judgements(&findings).map(Judged::of).collect(),
        }
    }

    /// The same with error bars, from one coarser run.
    pub fn with_bars(solution: &Solution, watch: &dyn Watch) -> Self {
        let found = Self::of(solution);
        let verification = quick(solution, &Stopped(watch));
        let bar = |number: &Number| verification.bar(number.of, number.key).and_then(|bar| bar.half);
        Self { bars: found.outcome.numbers.iter().map(bar).collect(), ..found }
    }

    /// What tables call a row of its verdict.
    pub fn label(&self, row: &'static str) -> &'static str {
        self.judged.iter().find(|judged| judged.key == row).map_or(row, |judged| judged.label)
    }

    /// Its numbers by their columns: `thinnest_mm`.
    pub fn named(&self) -> Vec<(String, f64)> {
        self.outcome.numbers.iter().map(|number| (header(number), number.amount.value)).collect()
    }

    /// Half the error bars of its numbers by their columns, `thinnest_mm_error`; none where none were asked for.
    pub fn errors(&self) -> impl Iterator<Item = (String, Option<f64>)> {
        self.outcome.numbers.iter().map(|number| keyed(number, "_error")).zip(self.bars.iter().copied())
    }

    /// A number by its column: `thinnest_mm`.
    pub fn number(&self, header: &str) -> Option<f64> {
        self.outcome.numbers.iter().find(|number| self::header(number) == header).map(|number| number.amount.value)
    }
}

/// The columns of a study's table.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Of what is varied.
    pub varied: Vec<String>,
    /// Of the numbers that the case as it stands has; those of other designs besides go into the last column.
    pub numbers: Vec<String>,
    /// Of their error bars; empty where none are asked for.
    pub bars: Vec<String>,
}

/// A watch that ends a coarser run with the study, and does not count it.
struct Stopped<'a>(&'a dyn Watch);

impl Watch for Stopped<'_> {
    fn wants_to_stop(&self) -> bool {
        self.0.wants_to_stop()
    }
}

/// Before what is varied, and after the numbers.
const FIRST: [&str; 4] = ["study", "designs", "index", "inputs_sha256"];
const LAST: [&str; 8] = ["verdict", "fails", "red", "amber", "end", "reason", "version", "other_numbers"];

/// The version that every row names.
const VERSION: &str = env!("CARGO_PKG_VERSION");

impl Columns {
    /// For designs whose case as it stands came to `base`; with error bars where that has them.
    pub fn of(designs: &dyn Designs, base: &Solved) -> Self {
        let numbers = || base.outcome.numbers.iter();
        let barred = numbers().filter(|_| !base.bars.is_empty());
        Self {
            varied: designs.headers(),
            numbers: numbers().map(header).collect(),
            bars: barred.map(|number| keyed(number, "_error")).collect(),
        }
    }

    /// The first line.
    pub fn header(&self) -> Vec<String> {
        let own = self.varied.iter().chain(&self.numbers).chain(&self.bars).cloned();
        FIRST.into_iter().map(str::to_owned).chain(own).chain(LAST.into_iter().map(str::to_owned)).collect()
    }

    /// The line of a row.
    pub fn line(&self, designs: &dyn Designs, row: &Row) -> Vec<String> {
        let mut line = vec![
            designs.key().to_owned(),
            designs.count().to_string(),
            row.design.index.to_string(),
            row.inputs.clone(),
        ];
        line.extend(row.design.values.iter().map(|value| value.text.clone()));
        let named = row.result.as_ref().map_or_else(|_| Vec::new(), Solved::named);
        let value = |column: &String| named.iter().find(|(header, _)| header == column).map(|(_, value)| *value);
        line.extend(self.numbers.iter().map(|column| value(column).map_or_else(String::new, written)));
        let errors: Vec<_> = row.result.iter().flat_map(Solved::errors).collect();
        let half = |column: &String| errors.iter().find(|(header, _)| header == column).and_then(|(_, half)| *half);
        line.extend(self.bars.iter().map(|column| half(column).map_or_else(String::new, written)));
        line.extend(match &row.result {
            Ok(Solved { outcome, light, red, amber, fails, .. }) => {
                let others = named.iter().filter(|(header, _)| !self.numbers.contains(header));
                let others: Vec<String> =
                    others.map(|(header, value)| format!("{header}={}", written(*value))).collect();
                let end = &outcome.end;
                let reason = if end.complete { String::new() } else { end.why.to_string() };
                [
                    light.name().into(),
                    fails.iter().map(|zone| zone.key()).collect::<Vec<_>>().join(" "),
                    red.join(" "),
                    amber.join(" "),
                    end.kind.into(),
                    reason,
                    VERSION.into(),
                    others.join(" "),
                ]
            }
            Err(why) => {
                let nothing = String::new;
                let lost = Zone::NoResult.key().into();
                [nothing(), lost, nothing(), nothing(), "not run".into(), why.clone(), VERSION.into(), nothing()]
            }
        });
        line
    }
}

/// A number's column; what a row of the verdict judges may have the name of another number.
pub(super) fn header(number: &Number) -> String {
    keyed(number, "")
}

/// The same with more words before its unit.
fn keyed(number: &Number, more: &str) -> String {
    let judged = if number.of == Of::Verdict { "_judged" } else { "" };
    number.amount.unit.keyed(&format!("{}{judged}{more}", number.key))
}

fn written(value: f64) -> String {
    if value.is_finite() { rounded(value).to_string() } else { String::new() }
}
