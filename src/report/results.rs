//! Results of every stage: lines of the summary, spring-back, and the pictures.

use super::*;
use crate::results::{OUTPUTS, tables};
use crate::table::Unit;

pub(super) const PART: &str = "part.png";
const TORN: &str = "the part coloured by thinning, its thinnest place and where it tears";

pub(super) fn sections(report: &Report) -> Vec<Section> {
    let on_front: Vec<(usize, &str)> = front::pictures(report).map(|(stage, file, ..)| (stage, file)).collect();
    let section = |(i, (view, summary)): (usize, &(StageView, Summary))| {
        let files = OUTPUTS.iter().map(|output| output.file).filter(|file| !on_front.contains(&(i, *file)));
        let content = html! {
            (figures(summary, Group::Part))
            @if let Some(changes) = changes(view) { (changes) }
            @for (chart, caption) in files.filter_map(|file| plot(view, file)) { (figure(&chart, caption)) }
        };
        (report.stage(i) + "Results", content)
    };
    report.stages.iter().enumerate().map(section).collect()
}

pub(super) fn figures(summary: &Summary, group: Group) -> Markup {
    let row = |[label, value, unit]: [String; 3]| Row {
        belongs: label.starts_with(' '),
        ..Row::from([label.trim_start().to_owned(), value, unit])
    };
    table(&["Quantity", "Value", "Unit"], summary.figures(group).map(row))
}

pub(super) fn plot(view: &StageView, file: &str) -> Option<(Chart, &'static str)> {
    let output = OUTPUTS.iter().find(|output| output.file == file)?;
    Some((output.chart(view)?, if file == PART && tears_at(view.stage).is_some() { TORN } else { output.about }))
}

fn changes(view: &StageView) -> Option<Markup> {
    let rows = tables::springback_changes(view.stage)?.into_iter().map(|change| {
        let unit = change.quantity.unit;
        let amount = |value: f64| if unit == Unit::Degree { Amount::angle(value) } else { Amount::place(value) };
        let bar = change.after.and_then(|after| view.half(amount(after)));
        let text = |value: Option<f64>, bar: Option<f64>| {
            let amount = |value| bar.map_or(amount(value), |bar| amount(value).with_bar(bar));
            value.map_or_else(|| "none".to_owned(), |value| amount(value).parts().0)
        };
        let [before, after, by] = [text(change.before, None), text(change.after, bar), text(change.change(), None)];
        [change.quantity.label.to_string(), before, after, by, amount(0.0).parts().1.to_owned()]
    });
    Some(table(&["Spring-back", "Before", "After", "Change", "Unit"], rows))
}
