//! The first page: what was asked, answered.

use super::document::{Block, Issue, KeyNumber, Picture};
use super::plots::{PART, plot};
use super::solved::Report;
use crate::assess::{Answer, Finding, Light, judgements, tears_at};
use crate::plot::chart::Scale;
use crate::solver::solution::StepRecord;
use crate::table::capitalised;

/// More rows than that leave no room for the pictures on the first page: the full verdict has them all.
const ISSUES: usize = 4;

/// The pictures of the first page by the files that they are in a result folder, the first that there is of each line: the
/// part, coloured, and the load.
const PICTURES: [&[&str]; 2] = [&[PART, "shapes.png", "springback.png"], &["load_travel.png", "pressure_cycle.png"]];

/// Largest height of curves on the first page \[px of a picture 800 wide\].
const CURVES: f64 = 230.0;

/// The verdict's sentence, what is red and amber, the numbers that are asked for first, the part and the load.
pub(super) fn blocks(report: &Report) -> Vec<Block> {
    let answer = &report.answer;
    let sentence = format!("{}.", capitalised(&answer.sentence.to_string()));
    let mut blocks = vec![Block::Sentence(answer.light, sentence)];
    let (issues, left) = issues(&report.findings);
    if !issues.is_empty() {
        blocks.push(Block::Issues(issues));
    }
    if left > 0 {
        blocks.push(Block::Paragraph(format!("{left} more below: see Verdict.")));
    }
    blocks.push(Block::Numbers(numbers(answer)));
    blocks.extend(pictures(report).map(|(_, _, picture)| Block::Picture(picture)));
    blocks
}

/// The numbers that a part is known by.
fn numbers(answer: &Answer) -> Vec<KeyNumber> {
    let told = answer.numbers.iter().map(|number| KeyNumber {
        label: String::from(number.label),
        value: number.amount.to_string(),
        detail: number.place.clone(),
    });
    told.collect()
}

/// Reds, then ambers, as many as there is room for, those with the same advice after each other; and how many more there are.
fn issues(findings: &[Finding]) -> (Vec<Issue>, usize) {
    let of = |light| judgements(findings).filter(move |finding| finding.light == light);
    let all: Vec<&Finding> = of(Light::Red).chain(of(Light::Amber)).collect();
    let shown = all.iter().take(ISSUES).map(|finding| Issue {
        light: finding.light,
        label: String::from(finding.label),
        found: brief(finding.found()),
        limit: brief(finding.limit.to_string()),
        advice: finding.advice.to_string(),
    });
    (advised_once(shown.collect()), all.len().saturating_sub(ISSUES))
}

/// What is told up to the first semicolon: the full verdict has the rest.
fn brief(told: String) -> String {
    told.split_once("; ").map_or_else(|| told.clone(), |(first, _)| first.to_owned())
}

/// Issues with the same advice after each other, where the first of them stood, and the advice with the last of them.
fn advised_once(mut issues: Vec<Issue>) -> Vec<Issue> {
    let first = |of: &str, among: &[String]| among.iter().position(|advice| advice == of);
    let advice: Vec<String> = issues.iter().map(|issue| issue.advice.clone()).collect();
    issues.sort_by_key(|issue| first(&issue.advice, &advice));
    for i in 1..issues.len() {
        if issues[i - 1].advice == issues[i].advice {
            issues[i - 1].advice.clear();
        }
    }
    issues
}

/// Each with its stage and its file: the part as it is at the end, and the load of the stage that tears, or else of that
/// which takes most of it. Of several stages the caption says which.
pub(super) fn pictures<'a>(report: &'a Report) -> impl Iterator<Item = (usize, &'static str, Picture)> + 'a {
    let torn = report.stages.iter().position(|(view, _)| tears_at(view.stage).is_some());
    let stages = [report.stages.len().checked_sub(1), torn.or_else(|| heaviest(report))];
    PICTURES.iter().zip(stages).filter_map(|(files, stage)| {
        let view = &report.stages.get(stage?)?.0;
        let mut picture = files.iter().find_map(|file| Some((stage?, *file, low(plot(view, file)?))))?;
        // The rows above say how it ended.
        let said = view.notes();
        picture.2.chart.notes.retain(|note| !said.contains(note));
        picture.2.caption.insert_str(0, &report.stage(picture.0));
        Some(picture)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_told_in_one_clause() {
        assert_eq!(brief("80 % of it; first at 20 mm; more".into()), "80 % of it");
        assert_eq!(brief("80 %, at 20 mm".into()), "80 %, at 20 mm");
    }

    #[test]
    fn rows_with_the_same_advice_have_it_once() {
        let issue = |label: &str, advice: &str| Issue {
            light: Light::Red,
            label: label.into(),
            found: String::new(),
            limit: String::new(),
            advice: advice.into(),
        };
        let all =
            [("a", "x"), ("b", "y"), ("c", "x"), ("d", ""), ("e", "x")].map(|(label, advice)| issue(label, advice));
        let once = advised_once(all.to_vec());
        let told: Vec<_> = once.iter().map(|issue| (issue.label.as_str(), issue.advice.as_str())).collect();
        assert_eq!(told, [("a", ""), ("c", ""), ("e", "x"), ("b", "y"), ("d", "")]);
    }
}
