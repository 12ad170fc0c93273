//! The first page: what was asked, answered.

use super::document::{Block, Issue, KeyNumber, Picture};
use super::plots::plot;
use super::solved::Report;
use crate::assess::{Answer, Finding, Light, judgements};
use crate::message::{Form, message};
use crate::output::chart::Scale;
use crate::solution::StepRecord;
use crate::table::capitalised;

/// More rows than that leave no room for the pictures on the first page: the full verdict has them all.
const ISSUES: usize = 5;

/// The pictures of the first page by the files that they are in a result folder, the first that there is of each line: the
/// part, coloured, and the load.
const PICTURES: [&[&str]; 2] =
    [&["part.png", "shapes.png", "springback.png"], &["load_travel.png", "pressure_cycle.png"]];

/// Largest height of curves on the first page \[px of a picture 800 wide\].
const CURVES: f64 = 230.0;

/// The verdict's sentence, what is red and amber, the numbers that are asked for first, the part and the load.
pub(super) fn blocks(report: &Report, form: Form) -> Vec<Block> {
    let answer = &report.answer;
    let sentence = format!("{}.", capitalised(&answer.sentence.told(form)));
    let mut blocks = vec![Block::Sentence(answer.light, sentence)];
    let (issues, left) = issues(&report.findings, form);
    if !issues.is_empty() {
        blocks.push(Block::Issues(issues));
    }
    if left > 0 {
        blocks.push(Block::Paragraph(form.tell(message!("{n} more below: see Verdict.", n = left))));
    }
    blocks.push(Block::Numbers(numbers(answer, form)));
    blocks.extend(pictures(report).map(|(_, _, picture)| Block::Picture(picture)));
    blocks
}

/// The numbers that a part is known by; its blank is among the inputs.
fn numbers(answer: &Answer, form: Form) -> Vec<KeyNumber> {
    let known = answer.numbers.iter().filter(|number| number.key != "blank");
    let told = known.map(|number| KeyNumber {
        label: form.tell(number.label),
        value: number.amount.told(form),
        detail: number.about.told(form),
    });
    told.collect()
}

/// Reds, then ambers, as many as there is room for; and how many more there are.
fn issues(findings: &[Finding], form: Form) -> (Vec<Issue>, usize) {
    let of = |light| judgements(findings).filter(move |finding| finding.light == light);
    let all: Vec<&Finding> = of(Light::Red).chain(of(Light::Amber)).collect();
    let shown = all.iter().take(ISSUES).map(|finding| Issue {
        light: finding.light,
        label: form.tell(finding.label),
        found: finding.found.told(form),
        limit: finding.limit.told(form),
        advice: finding.advice.told(form),
    });
    (shown.collect(), all.len().saturating_sub(ISSUES))
}

/// Each with its stage and its file: the part as it is at the end, and the load of the stage that takes most of it.
pub(super) fn pictures<'a>(report: &'a Report) -> impl Iterator<Item = (usize, &'static str, Picture)> + 'a {
    let stages = [report.stages.len().checked_sub(1), heaviest(report)];
    PICTURES.iter().zip(stages).filter_map(|(files, stage)| {
        let view = &report.stages.get(stage?)?.0;
        files.iter().find_map(|file| Some((stage?, *file, low(plot(view, file)?))))
    })
}

/// The stage with the largest punch force or pressure, counted from 0.
fn heaviest(report: &Report) -> Option<usize> {
    let stages = report.stages.iter().enumerate().filter(|(_, (view, _))| view.model().release.is_none());
    let load = |step: &StepRecord| (step.punch_force, step.pressure.abs());
    let peaks = stages.filter_map(|(i, (view, _))| {
        let (force, pressure) = view.stage.steps.iter().map(load).reduce(|a, b| (a.0.max(b.0), a.1.max(b.1)))?;
        Some((i, force, pressure))
    });
    peaks.max_by(|a, b| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2))).map(|(i, ..)| i)
}

/// The picture with curves no higher than there is room for.
fn low(mut picture: Picture) -> Picture {
    for panel in &mut picture.chart.panels {
        if let Scale::Fit { height, .. } = &mut panel.scale {
            *height = height.min(CURVES);
        }
    }
    picture
}
