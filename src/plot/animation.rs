//! Animation: the section coloured by thinning, its tools, and the load.

use super::*;

/// Number of pictures of a run.
pub const PICTURES: usize = 50;

/// Duration of the whole run and of its last picture \[hundredths of a second\].
const LENGTH: f64 = 400.0;
const LAST: u16 = 150;
/// Shortest duration that viewers show \[hundredths of a second\].
const SHORTEST: f64 = 2.0;
/// Width of the section and height of the load panel \[px\].
const WIDTH: f64 = 680.0;
const LOAD_HEIGHT: f64 = 130.0;

pub(crate) fn files(view: &StageView, frames: &[&Frame]) -> Vec<(String, Vec<u8>)> {
    let pictures = frames.iter().map(|frame| svg::svg(&picture(view, frames, frame)));
    let done: Vec<f64> = frames.iter().map(|frame| view.model().progress(frame.time)).collect();
    let whole = done[done.len() - 1] - done[0];
    let until_next = done.windows(2).map(|pair| LENGTH * (pair[1] - pair[0]) / whole);
    let delays: Vec<u16> = until_next.map(|hundredths| hundredths.max(SHORTEST).round() as u16).chain([LAST]).collect();
    vec![("shapes.gif".to_owned(), raster::gif(pictures, &delays))]
}

fn picture(view: &StageView, frames: &[&Frame], frame: &Frame) -> Chart {
    let model = view.model();
    let window = sections::window(frames.iter().flat_map(|f| &f.nodes), model.blank.reach());
    let (value, unit) = view.progress_value(frame);
    let largest = frames.iter().map(|frame| view.progress_value(frame).0).fold(0.0, f64::max);
    let decimals = if largest > 0.0 { (2.0 - largest.log10().floor()).clamp(0.0, 6.0) as usize } else { 0 };
    let at = Amount::new(value, unit, Digits::Decimals(decimals));
    let thinning = Thinning::new(model.blank.thickness, WIDTH / window[0].1, frames.iter().copied());
    let tools = sections::tools(model, Some(frame), window[0].1);
    let section = sections::panel(model.geometry, window).with(tools).with(thinning.section(frame, false));
    let panels = [section, thinning.scale()].into_iter().chain(load(view, frame.time)).collect();
    Chart { title: format!("{}: {} {at}", model.title, view.progress()), ..view.chart("", panels, [thinning.note()]) }
}

fn load(view: &StageView, time: f64) -> Option<Panel> {
    let mut panel = load_travel::panel(view, LOAD_HEIGHT)?;
    let acts = panel.series.iter().flat_map(|series| &series.points).any(|point| point.1 != 0.0);
    let steps = view.stage.steps.iter().take_while(|step| step.time <= time).count();
    let faint = |series: &Series| Series::silent(series.points.clone(), series.style.faint());
    panel.series.iter_mut().for_each(|series| series.points.truncate(steps));
    panel.series.splice(..0, panel.series.iter().map(faint).collect::<Vec<_>>());
    acts.then_some(panel)
}
