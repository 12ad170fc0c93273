//! Solved stage with what its pictures and tables need of its case.

use super::{palette::COLORS, svg::text, *};
use crate::assess::{self, Finding, Kind, sentences};
use crate::case::{Case, Solution};
use crate::forming_limit::{Assessment, assess};
use crate::measure::Ring;
use crate::model::{Edge, tool_sizes::extent};
use crate::solver::solution::StopKind;
use std::sync::OnceLock;
use std::time::Duration;

/// Share of an axis of the least span below which a curve looks level \[–\].
const LEVEL: f64 = 0.1;
/// Relative difference below which two numbers are one: round-off of a change to percent and back \[–\].
const SAME: f64 = 1e-12;

/// Solved stage, borrowed, with what its pictures and tables need of its case.
#[derive(Clone, Debug)]
pub struct StageView<'a> {
    /// Name of the case, with several stages that of the stage too: `cup/1-draw`.
    pub name: String,
    /// Case of the stage, if it is known.
    pub case: Option<&'a Case>,
    /// Findings: assumptions and warnings.
    pub findings: Vec<Finding>,
    /// Ring that is cut from the part, of the last stage.
    pub ring: Option<Ring>,
    /// Solution of the stage.
    pub stage: &'a StageSolution,
    /// Wall time of the whole case, if a clock was at hand.
    pub wall: Option<Duration>,
    /// Picture settings.
    pub pictures: Pictures,
    /// Numbers of the case with their error bars, if it was verified.
    pub bars: Vec<Amount>,
    /// Verdict on the whole case as JSON, if it was judged.
    pub verdict: Option<serde_json::Value>,
    assessment: OnceLock<Option<Assessment>>,
}

impl Solution {
    /// Views of every solved stage; the first has the findings from before the run.
    pub fn views(&self) -> Vec<StageView<'_>> {
        self.views_with(&assess::before(&self.case))
    }

    pub(crate) fn views_with(&self, before: &[Finding]) -> Vec<StageView<'_>> {
        let case = &self.case;
        let findings = assess::by_stage(before, &self.stages).into_iter().enumerate();
        let view = |(i, findings): (usize, Vec<Finding>)| {
            let name = case.stage_label(i).map_or_else(|| case.name.clone(), |label| format!("{}/{label}", case.name));
            let ring = case.springback.ring.filter(|_| i + 1 == case.stages.len());
            StageView { case: Some(case), findings, ring, wall: self.wall, ..StageView::alone(&name, &self.stages[i]) }
        };
        let mut views: Vec<_> = findings.map(view).collect();
        if let Some(first) = views.first_mut() {
            first.findings.extend(missing_letters(&first.model().title));
        }
        views
    }
}

fn missing_letters(title: &str) -> Option<Finding> {
    let missing: Vec<String> = text::missing(title).iter().map(|c| format!("{c} (U+{:04X})", u32::from(*c))).collect();
    let text = format!("the built-in font lacks letters of the title, PNG shows boxes: {}", missing.join(", "));
    (!missing.is_empty()).then(|| Finding::warning("letters", "Title", text))
}

impl<'a> StageView<'a> {
    /// Single stage with its findings.
    pub fn alone(name: &str, stage: &'a StageSolution) -> Self {
        let (case, ring, wall, pictures, bars, verdict, assessment) = Default::default();
        let findings = assess::of_stage(0, stage);
        Self { name: name.to_owned(), case, findings, ring, stage, wall, pictures, bars, verdict, assessment }
    }

    /// Opening of the slit ring \[mm\].
    pub(crate) fn ring_opening(&self) -> Option<f64> {
        self.ring?.opening(std::slice::from_ref(self.stage))
    }

    /// Half the error bar of the computed number that an amount is, in its unit.
    pub fn half(&self, amount: Amount) -> Option<f64> {
        let is_computed = matches!(amount.digits, Digits::Decimals(_) | Digits::Significant(_));
        let is_same = |own: &&Amount| {
            own.unit == amount.unit && (own.value - amount.value).abs() <= SAME * own.value.abs() && own.bar.is_some()
        };
        self.bars.iter().filter(|_| is_computed && amount.value != 0.0).find(is_same)?.bar
    }

    pub(crate) fn is_by_gas(&self) -> bool {
        self.model().travel == 0.0 && !self.model().gas.is_empty()
    }

    /// Model of the stage.
    pub fn model(&self) -> &'a Model {
        &self.stage.model
    }

    pub(crate) fn extent(&self) -> Extent {
        self.stage.model.extent()
    }

    /// Assessment against the forming limit, if there is one and a step was taken.
    pub fn forming_limit(&self) -> Option<&Assessment> {
        let assessed = || {
            self.stage.steps.last()?;
            assess(self.model().forming_limit.as_ref()?, &self.stage.paths)
        };
        self.assessment.get_or_init(assessed).as_ref()
    }

    pub(crate) fn chart(&self, of: &str, panels: Vec<Panel>, notes: impl IntoIterator<Item: Into<String>>) -> Chart {
        let is_own = self.pictures.captions == Captions::Own;
        let title = if is_own { capitalised(of) } else { format!("{}: {of}", self.model().title) };
        Chart::new(title, panels, notes.into_iter().map(Into::into).chain(self.notes()).collect())
    }

    pub(crate) fn notes(&self) -> Vec<String> {
        let stop = &self.stage.stop;
        let mut notes = Vec::new();
        if !stop.is_complete() && self.pictures.captions != Captions::Own {
            notes.push(format!("Stopped early: {stop}."));
        }
        if self.pictures.captions == Captions::Full {
            let set = self.case.filter(|case| !case.overrides.is_empty());
            notes.extend(set.map(|case| format!("Set on the command line: {}.", case.overrides.join(", "))));
            let warnings = sentences(&self.findings, Kind::Warning).into_iter();
            notes.extend(warnings.map(|warning| format!("Warning: {warning}.")));
            notes.extend(self.model().notes.iter().cloned());
        }
        notes
    }

    pub(super) fn frames_note(&self) -> Option<String> {
        let kept = self.stage.frames.len();
        (kept > COLORS).then(|| format!("{COLORS} of {kept} kept frames are shown; profile.csv has all."))
    }

    pub(super) fn shown_frames(&self) -> Vec<&'a Frame> {
        spread(&self.stage.frames, COLORS)
    }

    pub(super) fn is_level(&self, flat: f64, values: impl Iterator<Item = f64>, least: f64) -> bool {
        let (low, high) = values.fold((flat, flat), |(low, high), v| (low.min(v), high.max(v)));
        self.model().release.is_some() && high - low < LEVEL * least
    }

    pub(crate) fn progress(&self) -> String {
        let (model, (what, ..)) = (self.model(), self.progress_quantity());
        let worker = model.tool(model.worker()).filter(|_| model.travel > 0.0);
        worker.map_or_else(|| what.to_owned(), |tool| format!("{} {what}", model.name_of(tool.role)))
    }

    pub(super) fn progress_at(&self, frame: &Frame) -> Amount {
        let (value, unit) = self.progress_value(frame);
        Amount::new(value, unit, Digits::Given((2.0 - value.log10().floor().clamp(-12.0, 0.0)) as usize))
    }

    /// Travel \[mm\], released share \[%\], time \[s\], pressure on a die \[MPa\] or dome height \[mm\] of a frame.
    pub(super) fn progress_value(&self, frame: &Frame) -> (f64, Unit) {
        let (_, unit, value) = self.progress_quantity();
        (value(self.model(), frame), unit)
    }

    fn progress_quantity(&self) -> (&'static str, Unit, fn(&Model, &Frame) -> f64) {
        match self.model() {
            model if model.blank.edge == Edge::Fed => ("feed", Unit::Mm, |_, frame| frame.travel),
            model if model.travel > 0.0 => ("travel", Unit::Mm, |_, frame| frame.travel),
            model if model.release.is_some() => ("tools released", Unit::Percent, |m, f| 100.0 * f.time / m.duration),
            model if model.rate_control().is_some() => ("time", Unit::Second, |_, frame| frame.time),
            model
                if model.blank.meridian.is_some() || model.tool(Role::Die).is_some_and(|die| extent(die).0 == 0.0) =>
            {
                ("pressure", Unit::MPa, |model, frame| {
                    model.gas.iter().filter_map(|gas| gas.pressure.prescribed(frame.time)).fold(0.0, f64::max)
                })
            }
            _ => ("dome height", Unit::Mm, |_, frame| frame.nodes.first().map_or(0.0, |pole| pole.z.abs())),
        }
    }
}

pub(super) fn spread<T>(items: &[T], most: usize) -> Vec<&T> {
    let most = most.min(items.len());
    (1..=most).map(|i| &items[i * items.len() / most - 1]).collect()
}

pub(crate) fn stop_text(stage: &StageSolution) -> &'static str {
    let is_timed = stage.stop.kind == StopKind::FullTravel && stage.model.travel == 0.0;
    if is_timed { "full time" } else { stage.stop.kind.name() }
}
