//! What outputs are made from: a solved stage, borrowed, with what its files say of the case that it belongs to.

use super::chart::COLORS;
use super::{Captions, Pictures, font};
use crate::assess::{self, Finding, Kind, largest_force, sentences};
use crate::case::{Press, Solution};
use crate::forming_limit::{Assessment, assess};
use crate::measure::Ring;
use crate::model::{Extent, Geometry, Model};
use crate::solver::solution::{Frame, StageSolution, Stop};
use crate::study::verify::{Band, Verification};
use crate::table::{Unit, capitalised};
use crate::units::{Amount, Digits};
use std::sync::OnceLock;
use std::time::Duration;

/// What takes less than this share of an axis of the least height looks level \[–\].
const LEVEL: f64 = 0.1;

/// A stage of a solution and the words for it.
#[derive(Clone, Debug)]
pub struct StageView<'a> {
    /// What its results are called: the case, and of several stages the stage too: `cup/1-draw`.
    pub name: String,
    /// Title of the case.
    pub title: &'a str,
    /// The case file's text: its SHA-256 ties results to their input.
    pub case_text: &'a str,
    /// `key=value` settings that replaced what the case file says.
    pub overrides: &'a [String],
    /// Assumptions that the case declares.
    pub declared: &'a [String],
    /// What is told with the results: what was assumed while the case was read, and warnings.
    pub findings: Vec<Finding>,
    /// What the press can give, as far as the case says.
    pub press: Press,
    /// The ring that is cut from the part, of the last stage.
    pub ring: Option<Ring>,
    /// What came out of the stage.
    pub stage: &'a StageSolution,
    /// Time that the solution of the whole case took, where a clock was at hand.
    pub wall: Option<Duration>,
    /// How its pictures are made, and how much they say by themselves.
    pub pictures: Pictures,
    /// How far its numbers can be trusted, where that was looked at.
    pub verification: Option<&'a Verification>,
    /// The verdict on the whole case, for programs, where it was asked for.
    pub verdict: Option<serde_json::Value>,
    /// Around its punch force over the travel, where its is the largest of the case.
    pub(crate) load_band: Option<&'a Band>,
    /// Around its thickness over the blank at its end, of the last stage.
    pub(crate) thickness_band: Option<&'a Band>,
    assessment: OnceLock<Option<Assessment>>,
}

impl Solution {
    /// What outputs are made from, of every stage that was run; what was found before the run is told with the first.
    pub fn views(&self) -> Vec<StageView<'_>> {
        self.views_telling(&assess::before(&self.case))
    }

    /// The same with these findings from before the run.
    pub(crate) fn views_telling(&self, before: &[Finding]) -> Vec<StageView<'_>> {
        let told = assess::told(before, &self.stages).into_iter().enumerate();
        let mut views: Vec<_> = told.map(|(i, findings)| StageView::of(self, i, findings)).collect();
        if let Some(first) = views.first_mut() {
            first.findings.extend(undrawn(first.title));
        }
        views
    }
}

/// What pictures cannot show of the title.
fn undrawn(title: &str) -> Option<Finding> {
    let missing: Vec<String> =
        font::missing(title).into_iter().map(|letter| format!("{letter} (U+{:04X})", u32::from(letter))).collect();
    if missing.is_empty() {
        return None;
    }
    let found = format!(
        "the title has letters that the built-in font has not got, boxes stand for them in PNG and PDF: {letters}",
        letters = missing.join(", ")
    );
    Some(Finding::warning("letters", "Title", found))
}

impl<'a> StageView<'a> {
    /// A stage by itself, with what is found on it.
    pub fn alone(name: &str, stage: &'a StageSolution) -> Self {
        Self { findings: assess::of_stage(0, stage), ..Self::plain(name, stage) }
    }

    fn plain(name: &str, stage: &'a StageSolution) -> Self {
        Self {
            name: name.to_owned(),
            title: &stage.model.title,
            case_text: "",
            overrides: &[],
            declared: &stage.model.notes,
            findings: Vec::new(),
            press: Press::default(),
            ring: None,
            stage,
            wall: None,
            pictures: Pictures::default(),
            verification: None,
            verdict: None,
            load_band: None,
            thickness_band: None,
            assessment: OnceLock::new(),
        }
    }

    /// Stage `i` of a solution, counted from 0, with what is told of it.
    fn of(solution: &'a Solution, i: usize, findings: Vec<Finding>) -> Self {
        let case = &solution.case;
        let name = case.stage_label(i).map_or_else(|| case.name.clone(), |label| format!("{}/{label}", case.name));
        Self {
            case_text: &case.text,
            overrides: &case.overrides,
            findings,
            press: case.press,
            ring: case.springback.ring.filter(|_| i + 1 == case.stages.len()),
            wall: solution.wall,
            ..Self::plain(&name, &solution.stages[i])
        }
    }

    /// By how much the ring of the part opens when it is slit \[mm\].
    pub(crate) fn ring_opening(&self) -> Option<f64> {
        self.ring?.opening(std::slice::from_ref(self.stage))
    }

    /// Gives the views of all of a case's stages its error bars, each the bands that are its own.
    pub(crate) fn verify(views: &mut [Self], stages: &[StageSolution], verification: Option<&'a Verification>) {
        views.iter_mut().for_each(|view| view.verification = verification);
        let heaviest = largest_force(stages).and_then(|(i, _)| views.get_mut(i));
        if let Some(view) = heaviest {
            view.load_band = verification.and_then(|bars| bars.load.as_ref());
        }
        if let Some(view) = views.last_mut() {
            view.thickness_band = verification.and_then(|bars| bars.thickness.as_ref());
        }
    }

    /// The same for a page that has all captions above: charts say only what is their own.
    pub fn without_captions(self) -> Self {
        Self { pictures: Pictures { captions: Captions::Own, ..self.pictures }, ..self }
    }

    /// The model that was solved.
    pub fn model(&self) -> &'a Model {
        &self.stage.model
    }

    pub(crate) fn extent(&self) -> Extent {
        self.stage.model.extent()
    }

    pub(crate) fn geometry(&self) -> Geometry {
        self.stage.model.geometry
    }

    /// The stage held against its forming limit, where it has one and took a step.
    pub fn forming_limit(&self) -> Option<&Assessment> {
        let assessed = || {
            self.stage.steps.last()?;
            assess(self.model().forming_limit.as_ref()?, &self.stage.paths)
        };
        self.assessment.get_or_init(assessed).as_ref()
    }

    /// The title of a chart: `Cup: sections`, or `Sections` where the case's stands above.
    pub(crate) fn titled(&self, what: impl Into<String>) -> String {
        let what: String = what.into();
        match self.pictures.captions {
            Captions::Own => capitalised(&what),
            _ => format!("{}: {what}", self.title),
        }
    }

    /// Whether a picture says where its numbers come from: what is told nowhere else, or all there is.
    pub(crate) fn says_sources(&self) -> bool {
        matches!(self.pictures.captions, Captions::Own | Captions::Full)
    }

    fn says_all(&self) -> bool {
        self.pictures.captions == Captions::Full
    }

    /// Small print of every plot: why an incomplete stage ended, unless it stands above; where all is to be said also what was set and warned of, and
    /// what was assumed.
    pub(crate) fn notes(&self) -> Vec<String> {
        let stop = &self.stage.stop;
        let mut notes = Vec::new();
        if !stop.is_complete() && self.pictures.captions != Captions::Own {
            notes.push(String::from(format!("Stopped early: {why}.", why = stop.to_string())));
        }
        if self.says_all() && !self.overrides.is_empty() {
            notes.push(String::from(format!(
                "Set on the command line: {settings}.",
                settings = self.overrides.join(", ")
            )));
        }
        if self.says_all() {
            let warnings = sentences(&self.findings, Kind::Warning).into_iter();
            notes.extend(warnings.map(|warning| String::from(format!("Warning: {warning}."))));
        }
        notes.extend(self.assumptions());
        notes
    }

    /// The declared assumptions, as far as charts say them.
    pub(crate) fn assumptions(&self) -> impl Iterator<Item = String> {
        self.declared.iter().filter(|_| self.says_all()).cloned()
    }

    /// As [`Self::notes`], after a word on frames that a plot leaves out.
    pub(crate) fn notes_of_frames(&self) -> Vec<String> {
        let kept = self.stage.frames.len();
        let some = format!("{n} of {kept} kept frames are shown; profile.csv has them all.", n = COLORS);
        (kept > COLORS).then(|| String::from(some)).into_iter().chain(self.notes()).collect()
    }

    /// The frames that plots show: all of them, or as many as there are colours, spread evenly up to the last.
    pub(crate) fn shown(&self) -> impl DoubleEndedIterator<Item = &'a Frame> {
        let frames = &self.stage.frames;
        let most = frames.len().min(COLORS);
        (1..=most).map(move |i| &frames[i * frames.len() / most - 1])
    }

    /// Whether a plot with an axis of the least height `least` would show the flat blank's value only: while the tools are
    /// taken away nothing happens to a sheet that forming has left as it was, and the plots of that have shown it.
    pub(crate) fn is_level(&self, flat: f64, values: impl Iterator<Item = f64>, least: f64) -> bool {
        let (low, high) = values.fold((flat, flat), |(low, high), v| (low.min(v), high.max(v)));
        self.model().release.is_some() && high - low < LEVEL * least
    }

    /// What frames are named by.
    pub(crate) fn progress(&self) -> &'static str {
        match self.model().rate_control() {
            _ if self.model().travel > 0.0 => "punch travel",
            _ if self.model().release.is_some() => "tools' forces gone",
            Some(_) => "time",
            None => "dome height",
        }
    }

    /// How plots name a frame.
    pub(crate) fn reached(&self, frame: &Frame) -> Amount {
        let (value, unit) = self.reaches(frame);
        shortened(value, unit)
    }

    /// What a frame is named by: its travel; while the tools are taken away by the share of their forces that is gone;
    /// without a punch the time where a strain rate is held, or else the height of the dome.
    pub(crate) fn reaches(&self, frame: &Frame) -> (f64, Unit) {
        match self.model().rate_control() {
            _ if self.model().travel > 0.0 => (frame.travel, Unit::Mm),
            _ if self.model().release.is_some() => (100.0 * frame.time / self.model().duration, Unit::Percent),
            Some(_) => (frame.time, Unit::Second),
            None => (frame.nodes.first().map_or(0.0, |pole| pole.z.abs()), Unit::Mm),
        }
    }
}

/// How a stage ended, in a few words: one that has no travel to reach ends at its full time.
pub(crate) fn ended(stage: &StageSolution) -> &'static str {
    match &stage.stop {
        Stop::FullTravel if stage.model.travel == 0.0 => "full time",
        stop => stop.kind(),
    }
}

/// A number with as many decimals as it needs, at most two, more below 1.
fn shortened(value: f64, unit: Unit) -> Amount {
    Amount::new(value, unit, Digits::Given((2.0 - value.log10().floor().clamp(-12.0, 0.0)) as usize))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_named_by_as_many_digits_as_tell_them_apart() {
        for (value, text) in
            [(25.0, "25"), (16.75, "16.75"), (6.333_333, "6.33"), (0.000_25, "0.00025"), (600.0, "600")]
        {
            assert_eq!(shortened(value, Unit::Mm).parts().0, text);
        }
    }
}
