//! Summary of a stage: one list of lines, printed as text and written as JSON.

mod lines;

use super::{StageView, stages, tables};
use crate::assess::{Kind, check, draws, holder_lift, largest, sentences};
use crate::case::{Solution, files::sha256};
use crate::measure::{Change, Event, Shape, events, moment_error, part_height, stretch, thickest};
use crate::model::{Edge, Extent, Grading, Mode, Model, Role, Theory};
use crate::plot::{axis::capitalised, stop_text};
use crate::solver::solution::{StageSolution, StepRecord, StopKind};
use crate::table::{JOULES, Unit, worded};
use crate::units::{Amount, Digits, ZERO_CELSIUS, joined, rounded};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use serde_json::{Value as Json, json};
use std::fmt;

/// Subject of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// The case that was solved, and warnings.
    Case,
    /// The part, the load that formed it, and the end of the stage.
    Part,
    /// The numerical solution.
    Solution,
}

#[derive(Clone, Debug)]
struct Line {
    group: Group,
    key: &'static str,
    /// Indented where the line belongs to the one above; empty in lines for programs only.
    label: String,
    value: Value,
}

#[derive(Clone, Debug)]
enum Value {
    Number(Amount),
    /// Count, flag or text.
    Plain(Json),
    /// Rows with labels, and their JSON.
    Rows(Vec<[String; 2]>, Json),
}

/// Lines in the order of printing; displays as aligned text, serialises with units in the keys.
#[derive(Clone, Debug)]
pub struct Summary(Vec<Line>);

impl Summary {
    /// Sums up a stage.
    pub fn of(view: &StageView) -> Self {
        Self(lines::lines(view))
    }

    /// Label, value and unit of the lines of a group that have one value.
    pub fn figures(&self, group: Group) -> impl Iterator<Item = [String; 3]> {
        self.printed().filter(move |line| line.group == group).filter_map(|Line { label, value, .. }| {
            let (value, unit) = if let Value::Number(amount) = value { amount.parts() } else { (value.text()?, "") };
            Some([label.clone(), value, unit.to_owned()])
        })
    }

    /// Key, label and amount of every number; an indented label stands behind that of the line above.
    pub fn numbers(&self) -> impl Iterator<Item = (&'static str, String, Amount)> {
        let mut head = "";
        self.0.iter().filter_map(move |Line { key, label, value, .. }| {
            let part = label.strip_prefix("  ").map(|part| format!("{head}, {}", part.trim()));
            head = if part.is_none() { label } else { head };
            let Value::Number(amount) = value else { return None };
            Some((*key, part.unwrap_or_else(|| label.clone()), *amount))
        })
    }

    /// Labels and values of all printed lines; the entries of a list stand below each other.
    pub fn rows(&self) -> impl Iterator<Item = [String; 2]> {
        self.printed().flat_map(|Line { label, value, .. }| match value {
            Value::Rows(rows, _) => {
                let mut rows = rows.clone();
                rows.iter_mut().take(1).for_each(|[first, _]| first.insert_str(0, label));
                rows
            }
            value => vec![[label.clone(), value.text().unwrap_or_default()]],
        })
    }

    fn printed(&self) -> impl Iterator<Item = &Line> {
        self.0.iter().filter(|line| !line.label.is_empty())
    }

    pub(super) fn json(view: &StageView) -> Option<String> {
        let mut summary = Self::of(view);
        let verdict = view.verdict.clone().map(Value::Plain);
        summary.0.extend(verdict.map(|value| Line { group: Group::Case, key: "verdict", label: String::new(), value }));
        serde_json::to_string_pretty(&summary).ok().map(|text| text + "\n")
    }
}

impl Value {
    fn text(&self) -> Option<String> {
        match self {
            Self::Number(amount) => Some(amount.to_string()),
            Self::Plain(Json::Bool(flag)) => Some(if *flag { "yes" } else { "no" }.to_owned()),
            Self::Plain(Json::String(text)) => Some(text.clone()),
            Self::Plain(count) => Some(count.to_string()),
            Self::Rows(..) => None,
        }
    }

    /// `44.1 mm, 48.3 kN: rim meets the die`; the time in place of travel and force where a gas works.
    fn events(run: &StageSolution) -> Self {
        let (events, force) = (events(run), run.model.extent().force_unit());
        let row = |event: &Event| {
            let (way, load) = (Amount::place(event.travel), Amount::force(event.force, force));
            let at = if event.travel == 0.0 { Amount::time(event.time).to_string() } else { format!("{way}, {load}") };
            [String::new(), format!("{at}: {}", event.kind.label(&run.model))]
        };
        let entry = |event: &Event| {
            let [travel, time, load] = [event.travel, event.time, event.force].map(rounded);
            json!({
                "key": event.kind.key(&run.model), "what": event.kind.label(&run.model), force.keyed("punch_force"): load,
                Unit::Mm.keyed("travel"): travel, Unit::Second.keyed("time"): time,
            })
        };
        Self::Rows(events.iter().map(row).collect(), events.iter().map(entry).collect())
    }

    /// `coin: 2.0 kN at most; Ø 24 mm above, goes 4 mm by its path, R 4 mm (4.0 t), friction 0.1`
    fn further(run: &StageSolution) -> Self {
        let unit = run.model.extent().force_unit();
        let line = |(tool, _, peak)| {
            let check::Line { label, value, meaning, .. } = check::of_tool(&run.model, tool);
            let text = format!("{label}: {} at most; {value} {meaning}", Amount::force(peak, unit));
            let peak = (unit.keyed("peak_force"), rounded(peak));
            ([String::new(), text], json!({ "name": label, "size": value, "about": meaning, peak.0: peak.1 }))
        };
        let (rows, tools): (_, Vec<Json>) = run.further_peaks().map(line).unzip();
        Self::Rows(rows, tools.into())
    }

    /// `Wall to the punch direction  0.3° → 8.2° (+7.9°)`
    fn changes(changes: &[Change]) -> Self {
        let row = |change: &Change| {
            let by = change.change().map_or_else(String::new, |by| format!(" ({})", change.quantity.signed_text(by)));
            [format!("  {}", change.quantity.label), format!("{change}{by}")]
        };
        let entry = |change: &Change| {
            let [before, after, by] = [change.before, change.after, change.change()].map(|value| value.map(rounded));
            let (key, unit) = (change.quantity.key, change.quantity.unit.spelled());
            json!({ "key": key, "unit": unit, "before": before, "after": after, "change": by })
        };
        let head = [String::new(), "before → after (change)".to_owned()];
        Self::Rows(std::iter::once(head).chain(changes.iter().map(row)).collect(), changes.iter().map(entry).collect())
    }
}

impl Serialize for Summary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for Line { key, value, .. } in &self.0 {
            match value {
                Value::Number(amount) => {
                    map.serialize_entry(&amount.unit.keyed(key), &rounded(amount.value))?;
                    if let Some(bar) = amount.bar {
                        map.serialize_entry(&amount.unit.keyed(&format!("{key}_error_bar")), &rounded(bar))?;
                    }
                }
                Value::Plain(json) | Value::Rows(_, json) => map.serialize_entry(key, json)?,
            }
        }
        map.end()
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.rows().map(|[label, _]| label.chars().count()).max().unwrap_or(0);
        self.rows().try_for_each(|[label, value]| writeln!(f, "{label:<width$}  {value}"))
    }
}

/// Summary of a case: displays as aligned text; serialises as its one stage, or with a list of them.
#[derive(Clone, Debug)]
pub struct CaseSummary {
    case: String,
    complete: bool,
    /// Summaries of the stages that were run.
    pub stages: Vec<Summary>,
    /// A line for every stage; empty in a case of one stage.
    pub lines: String,
}

impl Solution {
    /// Sums up every stage.
    pub fn summary(&self) -> CaseSummary {
        CaseSummary::of(self, &self.views())
    }
}

impl CaseSummary {
    /// Sums up every stage by its view.
    pub fn of(solution: &Solution, views: &[StageView]) -> Self {
        let (case, complete) = (solution.case.name.clone(), solution.is_complete());
        Self { case, complete, stages: views.iter().map(Summary::of).collect(), lines: stages::printed(solution) }
    }
}

impl Serialize for CaseSummary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.stages.as_slice() {
            [stage] if self.lines.is_empty() => stage.serialize(serializer),
            stages => json!({"case": self.case, "complete": self.complete, "stages": stages}).serialize(serializer),
        }
    }
}

impl fmt::Display for CaseSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stages: Vec<String> = self.stages.iter().map(Summary::to_string).collect();
        let lines = if self.lines.is_empty() { String::new() } else { format!("\nStages\n{}\n", self.lines) };
        write!(f, "{}{lines}", stages.join("\n"))
    }
}

/// Geometry, and the extent that forces refer to.
pub fn section_of(extent: Extent) -> String {
    joined([worded(extent.geometry(), "axisymmetric", "plane strain").into(), extent.described()], "; ")
}
