//! What came out, stage by stage: the summary's lines, of a release its spring-back, and every plot of a stage.

use super::document::{Block, Row, Section};
use super::front;
use super::plots::plot;
use super::solved::Report;
use super::solver::figures;
use crate::results::summary::Group;
use crate::results::{OUTPUTS, StageView, springback};
use crate::table::Unit;
use crate::units::Amount;

/// A section for each stage; the pictures of the first page are not repeated.
pub(super) fn sections(report: &Report) -> Vec<Section> {
    let shown: Vec<(usize, &str)> = front::pictures(report).map(|(stage, file, _)| (stage, file)).collect();
    let stages = report.stages.iter().enumerate();
    stages
        .map(|(i, (view, summary))| {
            let part = figures(summary, |group| matches!(group, Group::End | Group::Part));
            let files = OUTPUTS.iter().map(|output| output.file).filter(|file| !shown.contains(&(i, *file)));
            let plots = files.filter_map(|file| plot(view, file)).map(Block::Picture);
            let blocks = std::iter::once(part).chain(released(view)).chain(plots);
            Section { heading: report.stage(i) + &String::from("Results"), blocks: blocks.collect() }
        })
        .collect()
}

/// What was measured before and after, of a stage that takes its tools away.
fn released(view: &StageView) -> Option<Block> {
    let rows = springback::changes(view.stage)?.into_iter().map(|change| {
        let unit = change.quantity.unit;
        let amount = |value: f64| if unit == Unit::Degree { Amount::angle(value) } else { Amount::place(value) };
        let told = |amount: Option<Amount>| amount.map_or_else(|| String::from("none"), |amount| amount.parts().0);
        let [before, after, by] = [change.before, change.after, change.change()].map(|value| value.map(amount));
        // The bar is that of the part as it comes out.
        let bar = after.and_then(|after| view.verification?.half(after));
        let barred = |amount: Option<Amount>| amount.map(|amount| bar.map_or(amount, |bar| amount.with_bar(bar)));
        let within = |amount: Option<Amount>| amount.map(|amount| bar.map_or(amount, |bar| amount.within_bar(bar)));
        let [before, after, by] = [within(before), barred(after), within(by)].map(told);
        Row::plain([String::from(change.quantity.label), before, after, by, amount(0.0).parts().1.to_owned()])
    });
    Some(Block::table(["Spring-back", "Before", "After", "Change", "Unit"], rows.collect()))
}
