//! The draw as a moving picture: the section, coloured by thinning, with its tools, and how far the load has come.

use super::chart::{Chart, Panel, Series};
use super::draw::{Drawing, WIDTH};
use super::gif::gif;
use super::thinning::{Thinning, said, times};
use super::{StageView, load_travel, sections};
use crate::results::Files;
use crate::solver::solution::Frame;
use crate::units::{Amount, Digits};

/// How many pictures are wanted of a run: every second of its steps, which are at most a hundredth of it by default.
pub const PICTURES: usize = 50;

/// How long the whole run is shown, and its last picture after it \[hundredths of a second\].
const LENGTH: f64 = 400.0;
const LAST: u16 = 150;
/// What viewers show at all; several take less for a tenth of a second \[hundredths of a second\].
const SHORTEST: f64 = 2.0;

/// Width of the section \[px of a picture 800 wide\].
const WIDE: f64 = 680.0;
/// Height of the load's panel \[px of a picture 800 wide\].
const LOAD_HEIGHT: f64 = 130.0;

/// `shapes.gif`: each picture is shown for as long as its frame lasts, so that the tools move evenly.
pub(crate) fn files(view: &StageView, frames: &[&Frame]) -> Files {
    let drawings = (0..frames.len()).map(|i| Drawing::of(&picture(view, frames, i), WIDTH));
    vec![("shapes.gif".to_owned(), gif(drawings, &delays(view, frames)))]
}

/// Some pictures of the moving section, `most` or fewer, spread over the frames, the last among them.
pub fn pictures(view: &StageView, frames: &[&Frame], most: usize) -> Vec<Chart> {
    let some = most.min(frames.len());
    (1..=some).map(|i| picture(view, frames, i * frames.len() / some - 1)).collect()
}

/// How long each picture is shown \[hundredths of a second\].
fn delays(view: &StageView, frames: &[&Frame]) -> Vec<u16> {
    let done = |frame: &Frame| view.model().progress(frame.time);
    let whole = done(frames[frames.len() - 1]) - done(frames[0]);
    let until_next = frames.windows(2).map(|pair| LENGTH * (done(pair[1]) - done(pair[0])) / whole);
    until_next.map(|hundredths| hundredths.max(SHORTEST).round() as u16).chain([LAST]).collect()
}

/// The `i`-th frame; the window and the axes are those of the whole animation.
fn picture(view: &StageView, frames: &[&Frame], i: usize) -> Chart {
    let (model, frame) = (view.model(), frames[i]);
    let window = sections::window(frames.iter().flat_map(|f| &f.nodes), model.blank.length);
    let (value, unit) = view.reaches(frame);
    let decimals = decimals(frames.iter().map(|frame| view.reaches(frame).0).fold(0.0, f64::max));
    let at = Amount::new(value, unit, Digits::Decimals(decimals));
    let reached = format!("{progress} {at}", progress = view.progress());
    let thinning = Thinning::of(model.blank.thickness, frames.iter().copied());
    let times = times(model.blank.thickness, WIDE / window[0].1);
    let sheet = thinning.section(frame, times);
    let tools = sections::tools(model, Some(frame), window[0].1);
    let section = sections::panel(model.geometry, tools.chain(sheet), window);
    let chart = Chart {
        title: format!("{}: {reached}", view.title),
        legend: String::new(),
        panels: [section, thinning.scale()].into_iter().chain(load(view, frame.time)).collect(),
        notes: std::iter::once(String::from(said(times))).chain(view.notes()).collect(),
    };
    chart.displayed()
}

/// The load up to a time, on what it comes to; nothing where nothing loads the sheet.
fn load(view: &StageView, time: f64) -> Option<Panel> {
    let mut panel = load_travel::panel(view, LOAD_HEIGHT)?;
    let acts = panel.series.iter().flat_map(|series| &series.points).any(|point| point.1 != 0.0);
    let steps = view.stage.steps.iter().take_while(|step| step.time <= time).count();
    let whole: Vec<Series> =
        panel.series.iter().map(|series| Series::silent(series.points.clone(), series.look.faint())).collect();
    for series in &mut panel.series {
        series.points.truncate(steps);
    }
    panel.series.splice(..0, whole);
    acts.then_some(panel)
}

/// As many decimals as show three digits of `largest`, at most 6.
fn decimals(largest: f64) -> usize {
    if largest > 0.0 { (2.0 - largest.log10().floor()).clamp(0.0, 6.0) as usize } else { 0 }
}
