//! Section over the travel, coloured by thinning, with the tools where they were then.

use super::{sections::flat, sections::panel, sections::tools, sections::window, stage_view::spread, *};

const STATES: usize = 6;
/// Width of a small panel \[px\].
const SMALL: f64 = 230.0;

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (model, frames) = (view.model(), &view.stage.frames);
    let window = window(frames.iter().flat_map(|f| &f.nodes), model.blank.reach());
    let width = window[0].1;
    let thinning = Thinning::new(model.blank.thickness, SMALL / width, frames);
    let small = |at: Amount, frame: Option<&Frame>, sheet: Vec<Series>| {
        let section = panel(model.geometry, window).with(tools(model, frame, width)).with(sheet);
        Panel { caption: capitalised(&format!("{} {at}", view.progress())), is_small: true, ..section }
    };
    let shown = spread(frames, STATES);
    let start = view.stage.start.as_ref().filter(|_| (1..STATES).contains(&shown.len()));
    let state = |frame: &Frame| small(view.progress_at(frame), Some(frame), thinning.section(frame, false));
    let mut panels: Vec<Panel> = start.into_iter().chain(shown).map(state).collect();
    if panels.is_empty() {
        panels.push(small(Amount::size(0.0), None, vec![Series::silent(flat(model), Style::area(color(0)))]));
    } else {
        panels.push(thinning.scale());
    }
    Some(view.chart("sections", panels, [Some(thinning.note()), view.frames_note()].into_iter().flatten()))
}
