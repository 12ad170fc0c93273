//! Sections without pictures: verdict, error bars, inputs, assumptions, warnings, solver, case.

use super::{results::figures, *};
use crate::assess::{check::Line, error_bars::Number, error_bars::Origin};
use crate::case::files::sha256;
use crate::results::summary::section_of;
use crate::study::{Cell, compare::SideBySide};

const WORST_FIRST: [Light; 4] = [Light::Red, Light::Amber, Light::Grey, Light::Green];

pub(super) fn verdict(report: &Report) -> Section {
    let with = |light| judgements(&report.findings).filter(move |finding| finding.light == light);
    let rows = WORST_FIRST.into_iter().flat_map(with).map(|one| {
        let limit = format!("{} ({})", one.limit, one.source);
        let cells = [word(one.light), one.label.to_owned(), one.statement(), limit, one.advice.clone()];
        Row { light: Some(one.light), ..Row::from(cells) }
    });
    ("Verdict".to_owned(), table(&["Light", "Question", "Found", "Limit (source)", "What to change"], rows))
}

pub(super) fn error_bars(report: &Report) -> Option<Section> {
    let bars = report.bars?;
    let numbers: Vec<&Number> = bars.numbers.iter().filter(|own| own.origin != Origin::Verdict).collect();
    let row = |own: &Number| {
        let (value, unit) = own.quantity.amount.parts();
        [own.quantity.label.to_owned(), value, unit.to_owned(), own.made_of()]
    };
    let head = ["Quantity", "Value", "Unit", "Made of (observed order)"];
    let content = html! {
        (list(&bars.sentences(), ""))
        @if numbers.iter().any(|own| own.half().is_some()) { (table(&head, numbers.into_iter().map(row))) }
    };
    Some(("Error bars".to_owned(), content))
}

/// Bytes that fill the third page in the largest letters, and the sizes of letters \[pt\].
const PAGE: f64 = 8000.0;
const SIZES: [f64; 2] = [5.5, 8.0];

/// Third page in two columns: inputs, the verdict with its limits and their sources, assumptions, warnings, case.
pub(super) fn inputs(report: &Report) -> Markup {
    let input = |line: &Line| [line.label.clone(), joined([line.value.clone(), line.meaning.clone()], " ")];
    let found = |one: &Finding| format!("{}; limit: {}", first_clause(&one.statement()), one.sourced_limit());
    let row = |one: &Finding| [one.label.to_owned(), found(one)];
    let parts = html! {
        h3 { "Inputs" } (table(&["Input", "Value"], report.check.lines.iter().map(input)))
        h3 { "Assumptions" } (list(&report.check.notes, "None are declared."))
        h3 { "Warnings" } (list(&warnings(report), "None."))
        h3 { "Verdict" } (table(&["Question", "Found; limit (source)"], judgements(&report.findings).map(row)))
        h3 { "Case" } (case(report))
    };
    let letters = parts.0.len() as f64;
    html! { div.columns style=(format!("font-size: {size:.2}pt", size = (SIZES[1] * (PAGE / letters).sqrt()).clamp(SIZES[0], SIZES[1]))) { (parts) } }
}

pub(super) fn warnings(report: &Report) -> Vec<String> {
    let warnings = report.findings.iter().filter(|finding| finding.kind == Kind::Warning);
    let stage = |i: Option<usize>| i.map_or_else(String::new, |i| report.stage(i));
    warnings.map(|f| format!("{}{}", stage(f.stage), f.sentence())).collect()
}

pub(super) fn solver(report: &Report) -> Section {
    let row = |line: &Line| [line.label.clone(), line.value.clone(), line.meaning.clone()];
    let content = html! {
        (table(&["Sheet, mesh and solver", "Value", "Meaning"], report.check.details.iter().map(row)))
        @for (i, (_, summary)) in report.stages.iter().enumerate() {
            @if let Some(name) = report.stage(i).strip_suffix(": ") { p { "Stage " (name) } }
            (figures(summary, Group::Solution))
        }
        p { "SHA-256 of the case, settings applied: " (sha256([&report.solution.case.text])) }
    };
    ("Solver".to_owned(), content)
}

fn case(report: &Report) -> Markup {
    let case = &report.solution.case;
    let stages = joined(case.stages.iter().map(|stage| stage.name.as_str()), ", ");
    let ended = match report.solution.stages.last() {
        Some(_) if report.solution.is_complete() => "complete".to_owned(),
        Some(last) => format!("stopped early: {}", last.stop),
        None => "not begun".to_owned(),
    };
    // The title block stands on the first page.
    let overrides = case.overrides.iter().filter(|set| !set.starts_with("report"));
    let rows = [
        ("Case file", case.path.display().to_string()),
        ("Set on the command line", joined(overrides.cloned(), ", ")),
        ("Section", section_of(case.model().extent())),
        ("Stages", if case.later().is_empty() { String::new() } else { stages }),
        ("Run", ended),
        ("Program", PROGRAM.to_owned()),
    ];
    let rows = rows.into_iter().filter(|(_, value)| !value.is_empty());
    table(&["What", "Which"], rows.map(|(label, value)| [label.to_owned(), value]))
}

pub(super) fn versus(all: &SideBySide) -> Section {
    let legend = all.legend();
    let head = ["Quantity"].into_iter().chain(legend.iter().map(String::as_str)).take(1 + all.members.len());
    let rows = all.overview().rows.into_iter().map(|row| row.iter().map(Cell::to_string).collect());
    let content = html! {
        (table(&head.collect::<Vec<_>>(), rows.map(|cells| Row { cells, ..Row::default() })))
        p { (capitalised(SideBySide::DIFFERENCES)) "." }
        div.pictures {
            @for (_, about, chart) in all.charts() { (figure_in_column(Chart { title: String::new(), ..chart }, about)) }
        }
    };
    ("Compared".to_owned(), content)
}
