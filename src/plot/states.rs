//! The section of the sheet over the travel, coloured by thinning, and the tools where they were then.

use super::StageView;
use super::chart::{Chart, Look, Panel, Scale, Series, color};
use super::sections::{flat, panel, tools, window};
use super::thinning::{Thinning, said, times};
use crate::solver::solution::Frame;
use crate::table::capitalised;
use crate::units::Amount;

/// As many states as are shown.
const STATES: usize = 6;
/// Width of the section in a small panel \[px of a picture 800 wide\].
const SMALL: f64 = 230.0;

/// The states of a stage in small panels, each with the tools where they were then.
pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (model, frames) = (view.model(), &view.stage.frames);
    let window = window(frames.iter().flat_map(|f| &f.nodes), model.blank.length);
    let width = window[0].1;
    let thinning = Thinning::of(model.blank.thickness, frames.iter());
    let times = times(model.blank.thickness, SMALL / width);
    let small = |caption: String, at: Option<&Frame>, sheet: Vec<Series>| {
        let caption = Series::new(caption, Vec::new(), Look::Text);
        let [x, y] = window;
        let series = tools(model, at, width).chain(sheet).chain([caption]);
        Panel { scale: Scale::Small { x, y }, ..panel(model.geometry, series, window) }
    };
    let states = states(view);
    let caption = |at: Amount| {
        let caption = format!("{progress} {at}", progress = view.progress());
        capitalised(&String::from(caption))
    };
    let shown =
        states.iter().map(|frame| small(caption(view.reached(frame)), Some(frame), thinning.section(frame, times)));
    // A run that never started shows where it would have.
    let flat = || vec![Series::silent(flat(model), Look::Area { fill: color(0), edge: None })];
    let unsolved = states.is_empty().then(|| small(caption(Amount::size(0.0)), None, flat()));
    let scale = (!states.is_empty()).then(|| thinning.scale());
    Some(Chart {
        title: view.titled("sections"),
        legend: String::new(),
        panels: shown.chain(unsolved).chain(scale).collect(),
        notes: std::iter::once(String::from(said(times))).chain(view.notes_of_frames()).collect(),
    })
}

/// The start where there is room for it, and frames spread evenly up to the last.
fn states<'a>(view: &StageView<'a>) -> Vec<&'a Frame> {
    let frames = &view.stage.frames;
    let most = frames.len().min(STATES);
    let start = view.stage.start.as_ref().filter(|_| (1..STATES).contains(&most));
    start.into_iter().chain((1..=most).map(|i| &frames[i * frames.len() / most - 1])).collect()
}
