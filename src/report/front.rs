//! The first page: what was asked, answered.

use super::answers;
use super::document::{Block, Issue, Picture};
use super::results::plot;
use super::solved::Report;
use crate::assess::{Finding, Light, headline, judgements};
use crate::message::{Form, Message};
use crate::output::chart::Scale;

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
    let worst = judgements(&report.findings).map(|finding| finding.light).max().unwrap_or(Light::Grey);
    let mut blocks = vec![Block::Sentence(worst, format!("{}.", headline(&report.findings).told(form)))];
    let (issues, left) = issues(&report.findings, form);
    if !issues.is_empty() {
        blocks.push(Block::Issues(issues));
    }
    if left > 0 {
        blocks.push(Block::Paragraph(format!("{left} more below: see Verdict.")));
    }
    blocks.push(Block::Numbers(answers::told(&report.answers, form)));
    blocks.extend(pictures(report).map(|(_, _, picture)| Block::Picture(picture)));
    blocks
}

/// Reds, then ambers, as many as there is room for; and how many more there are.
fn issues(findings: &[Finding], form: Form) -> (Vec<Issue>, usize) {
    let of = |light| judgements(findings).filter(move |finding| finding.light == light);
    let all: Vec<&Finding> = of(Light::Red).chain(of(Light::Amber)).collect();
    let shown = all.iter().take(ISSUES).map(|finding| Issue {
        light: finding.light,
        label: Message::from(finding.label).told(form),
        found: finding.found.told(form),
        limit: finding.limit.told(form),
        advice: finding.advice.told(form),
    });
    (shown.collect(), all.len().saturating_sub(ISSUES))
}

/// Each with its stage and its file: the part as it is at the end, and the load of the stage that takes most of it.
pub(super) fn pictures<'a>(report: &'a Report) -> impl Iterator<Item = (usize, &'static str, Picture)> + 'a {
    let stages = [report.stages.len().checked_sub(1), report.answers.heaviest];
    PICTURES.iter().zip(stages).filter_map(|(files, stage)| {
        let view = &report.stages.get(stage?)?.0;
        files.iter().find_map(|file| Some((stage?, *file, low(plot(view, file)?))))
    })
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
