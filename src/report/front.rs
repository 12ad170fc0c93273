//! First page: verdict, what to change, key numbers, the part and the load.

use super::Report;
use super::page::{figure, in_words, word};
use super::results::{PART, plot};
use crate::assess::{Finding, Light, first_clause, judgements, tears_at};
use crate::plot::chart::{Scale, bounds};
use crate::plot::{Chart, axis::capitalised};
use crate::solver::solution::StepRecord;
use crate::units::joined;
use maud::{Markup, html};

/// Most issues that leave room for the pictures.
const ISSUES: usize = 4;

/// Pictures of the part and of the load: the first of each that there is.
const PICTURES: [&[&str]; 2] = [&[PART, "shapes.png", "springback.png"], &["load_travel.png", "pressure_cycle.png"]];

/// Largest height of curves \[px of a picture 800 wide\].
const CURVES: f64 = 230.0;

/// Picture of the first page.
pub(super) struct FrontPicture {
    /// Counted from 0.
    pub stage: usize,
    pub file: &'static str,
    chart: Chart,
    caption: String,
}

pub(super) fn content(report: &Report) -> Markup {
    let answer = &report.answer;
    let with = |light| judgements(&report.findings).filter(move |finding| finding.light == light);
    let issues: Vec<&Finding> = with(Light::Red).chain(with(Light::Amber)).collect();
    let left = issues.len().saturating_sub(ISSUES);
    let unchecked = joined(with(Light::Grey).map(|row| row.label.to_lowercase()), ", ");
    html! {
        p.sentence.{ "on-" (answer.light.name()) } {
            span.{ (answer.light.name()) } { (word(answer.light)) } " " (capitalised(&answer.sentence)) "."
        }
        @if !issues.is_empty() {
            ul.issues { @for issue in issues.iter().take(ISSUES) { (issue_of(issue)) } }
        }
        @if left > 0 { p { (left) " more below: see Verdict." } }
        @if !unchecked.is_empty() { p { "Not checked: " (unchecked) "." } }
        dl.numbers {
            @for number in &answer.numbers {
                div {
                    dt { (number.label) }
                    dd { strong { (number.amount) } @if !number.place.is_empty() { span { (number.place) } } }
                }
            }
        }
        @for picture in pictures(report) { (figure(&picture.chart, &picture.caption)) }
    }
}

fn issue_of(issue: &Finding) -> Markup {
    let found = in_words(&issue.statement());
    let limit = first_clause(&issue.limit);
    html! {
        li {
            p {
                span.{ (issue.light.name()) } { (word(issue.light)) } " " strong { (issue.label) } ": " (found)
                @if !limit.is_empty() { " (limit: " (limit) ")" }
            }
            @if !issue.advice.is_empty() { p.advice { "What to change: " (in_words(&issue.advice)) } }
        }
    }
}

/// The part at the end, and the load of the stage that tears or takes most of it.
pub(super) fn pictures<'a>(report: &'a Report) -> impl Iterator<Item = FrontPicture> + 'a {
    let torn = report.stages.iter().position(|(view, _)| tears_at(view.stage).is_some());
    let stages = [report.stages.len().checked_sub(1), torn.or_else(|| heaviest(report))];
    PICTURES.iter().zip(stages).filter_map(|(files, stage)| {
        let stage = stage?;
        let view = &report.stages[stage].0;
        let (file, (mut chart, caption)) = files.iter().find_map(|file| Some((*file, plot(view, file)?)))?;
        for panel in &mut chart.panels {
            if let Scale::Fit { height, .. } = &mut panel.scale {
                *height = height.min(CURVES);
            }
        }
        // The verdict above says how the stage ended.
        let notes = view.notes();
        chart.notes.retain(|note| !notes.contains(note));
        Some(FrontPicture { stage, file, chart, caption: report.stage(stage) + caption })
    })
}

/// Stage with the largest punch force or pressure, counted from 0.
fn heaviest(report: &Report) -> Option<usize> {
    let peak = |i: usize, load: fn(&StepRecord) -> f64| bounds(report.stages[i].0.stage.steps.iter().map(load)).1;
    let forming = (0..report.stages.len()).filter(|i| report.stages[*i].0.model().release.is_none());
    let loads = forming.map(|i| (i, peak(i, |step| step.punch_force), peak(i, |step| step.pressure.abs())));
    loads.max_by(|a, b| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2))).map(|(i, ..)| i)
}
