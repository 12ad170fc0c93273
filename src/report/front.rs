//! First page: verdict, what to change, key numbers, the part and the load.

use super::{page::in_words, results::PART, sections::warnings, *};
use crate::plot::{chart::Series, chart::Style, chart::bounds, load_travel};
use crate::solver::solution::StepRecord;

const ISSUES: usize = 4;
const WARNINGS: usize = 2;
const PARTS: [&str; 3] = [PART, "shapes.png", "springback.png"];

/// Stage, counted from 0, with file, chart and caption.
pub(super) type FrontPicture = (usize, &'static str, Chart, String);

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
        @if !issues.is_empty() { ul.issues { @for issue in issues.iter().take(ISSUES) { (issue_of(issue)) } } }
        @if left > 0 { p { (left) " more below: see Verdict." } }
        @if !unchecked.is_empty() { p { "Not checked: " (unchecked) "." } }
        @for warning in warnings(report).iter().take(WARNINGS) { p { "Note: " (warning) "." } }
        dl.numbers { @for number in &answer.numbers { div {
            dt { (number.name.as_deref().unwrap_or(number.label)) }
            dd { strong { (number.amount) } @if !number.place.is_empty() { span { (number.place) } } }
        } } }
        div.pictures { @for (_, _, chart, caption) in pictures(report) { (figure_in_column(chart, &caption)) } }
    }
}

fn issue_of(issue: &Finding) -> Markup {
    let found = in_words(&issue.statement());
    let limit = first_clause(&issue.limit);
    html! { li {
        p {
            span.{ (issue.light.name()) } { (word(issue.light)) } " " strong { (issue.label) } ": " (found)
            @if !limit.is_empty() { " (limit: " (limit) ")" }
        }
        @if !issue.advice.is_empty() { p.advice { "What to change: " (in_words(&issue.advice)) } }
    } }
}

pub(super) fn pictures(report: &Report) -> impl Iterator<Item = FrontPicture> {
    let part = report.stages.len().checked_sub(1).and_then(|stage| {
        let (file, (chart, about)) = PARTS.iter().find_map(|f| Some((*f, plot(&report.stages[stage].0, f)?)))?;
        Some(picture(report, stage, file, chart, about))
    });
    let torn = report.stages.iter().position(|(view, _)| tears_at(view.stage).is_some());
    [part, torn.or_else(|| heaviest(report)).and_then(|stage| forces(report, stage))].into_iter().flatten()
}

fn picture(report: &Report, stage: usize, file: &'static str, mut chart: Chart, about: &str) -> FrontPicture {
    // The verdict above says how the stage ended.
    let notes = report.stages[stage].0.notes();
    chart.notes.retain(|note| !notes.contains(note));
    (stage, file, chart, report.stage(stage) + about)
}

fn forces(report: &Report, stage: usize) -> Option<FrontPicture> {
    let (view, _) = &report.stages[stage];
    let mut about = if view.is_by_gas() { "pressure over the height of the dome" } else { "forces over the travel" };
    let mut chart = load_travel::plot(view)?;
    let panel = chart.panels.first_mut()?;
    let forming = report.stages.iter().enumerate().filter(|(_, (view, _))| view.model().release.is_none());
    for (i, (view, _)) in forming.filter(|(i, _)| *i != stage) {
        let points: Vec<_> = view.stage.steps.iter().map(|step| (step.travel, step.punch_force)).collect();
        if bounds(points.iter().map(|point| point.1)).1 > 0.0 {
            panel.series.push(Series::new(report.stage(i) + "punch force", points, Style::curve(panel.series.len())));
            about = "forces over the travel, and the punch forces of the other stages";
        }
    }
    Some(picture(report, stage, "load_travel.png", chart.displayed(), about))
}

fn heaviest(report: &Report) -> Option<usize> {
    let peak = |i: usize, load: fn(&StepRecord) -> f64| bounds(report.stages[i].0.stage.steps.iter().map(load)).1;
    let forming = (0..report.stages.len()).filter(|i| report.stages[*i].0.model().release.is_none());
    let force = |i: usize| report.stages[i].0.stage.working_force().into_iter().fold(0.0, f64::max);
    let loads = forming.map(|i| (i, force(i), peak(i, |step| step.pressure.abs())));
    loads.max_by(|a, b| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2))).map(|(i, ..)| i)
}
