//! What came out, stage by stage: the summary's lines, every plot of a run, and of a release its spring-back.

use super::Report;
use super::document::{Block, Picture, Row, Section};
use super::solver::{figures, is_ours};
use crate::measure::{Shape, changes};
use crate::model::Model;
use crate::output::{Chart, Make, OUTPUTS, Subject, Summary, residual_stress, springback, svg};
use crate::table::four_digits;

/// Lines that the section on the case has.
const SAID: [&str; 3] = ["case", "title", "section"];

pub(super) fn sections(report: &Report) -> Vec<Section> {
    let subjects = report.subjects().enumerate();
    subjects
        .map(|(i, subject)| {
            let lines = Summary::of(&subject);
            let lines = lines.figures().filter(|figure| !is_ours(figure) && !SAID.contains(&figure.key));
            let mut blocks = vec![figures(lines)];
            blocks.extend(release(report, i));
            blocks.extend(plots(&subject));
            Section { heading: format!("{}Results", report.stage(i)), blocks }
        })
        .collect()
}

/// Every plot that a run writes. What the report lists elsewhere (assumptions, warnings, settings) is not repeated below
/// each.
fn plots(subject: &Subject) -> Vec<Block> {
    let model = Model { notes: Vec::new(), ..subject.model.clone() };
    let bare = Subject { model: &model, findings: &[], overrides: &[], ..*subject };
    let plots = OUTPUTS.iter().filter_map(|output| match output.make {
        Make::Plot(make) => Some((output, make(&bare)?)),
        Make::Table(_) | Make::Text(_) => None,
    });
    plots.map(|(output, chart)| picture(output.file.trim_end_matches(".png"), output.about, chart, &model)).collect()
}

/// Spring-back and residual stress of a stage that takes its tools away.
fn release(report: &Report, i: usize) -> Vec<Block> {
    let Some(pass) = report.passes.get(i) else { return Vec::new() };
    let Some([from, to]) = pass.released() else { return Vec::new() };
    let model = Model { notes: Vec::new(), ..pass.model.clone() };
    let number = |value: Option<f64>| value.map_or_else(|| "none".to_owned(), four_digits);
    let rows = changes(&Shape::of(from), &Shape::of(to)).into_iter().map(|c| {
        let [a, b, d] = [c.before, c.after, c.change()].map(number);
        Row::plain([c.quantity.label.to_owned(), a, b, d, c.quantity.unit.symbol().to_owned()])
    });
    let table = Block::Table { head: vec!["Spring-back", "Before", "After", "Change", "Unit"], rows: rows.collect() };
    let plot = springback::plot(from, to, &model);
    let shapes = picture("springback", "the section before and after release", plot, &model);
    let stress = residual_stress::plot(to, &model)
        .map(|chart| picture("residual_stress", "residual stress through the thickness", chart, &model));
    [table, shapes].into_iter().chain(stress).collect()
}

/// A picture whose title leaves out the case's, which the report has above all.
fn picture(name: &str, about: &str, chart: Chart, model: &Model) -> Block {
    let title = chart.title.strip_prefix(&format!("{}: ", model.title)).unwrap_or(&chart.title);
    let svg = svg(&Chart { title: crate::table::capitalised(title), ..chart });
    Block::Picture(Picture { name: name.to_owned(), caption: about.to_owned(), svg })
}
