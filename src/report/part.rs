//! Second page: stages with their peaks, sections at the start, thickness and forming limit.

use super::{sizes::dimensions, sizes::section, *};
use crate::assess::estimate::draw_ratio;

const COLUMNS: [(&str, &str); 8] = [
    ("Travel", "travel"),
    ("Force, peak", "peak_punch_force"),
    ("Holder, peak", "peak_holder_force"),
    ("Pressure, peak", "peak_pressure"),
    ("Thinnest", "thinnest"),
    ("Draw-in", "draw_in"),
    ("Limit used", "forming_ratio"),
    ("Tearing", "tearing_index"),
];

const TOOLS: [(&str, &str); 4] = [
    ("Punch", "Punch"),
    ("Punch radius", "Punch nose radius"),
    ("Die", "Die throat"),
    ("Die radius", "Die shoulder radius"),
];

const RESULTS: [(&str, &str); 2] = [("thickness.png", "thickness"), ("forming_limit.png", "forming limit")];
const SECTIONS: usize = 4;

pub(super) fn content(report: &Report) -> Markup {
    let sections: Vec<usize> = with_new_tools(report).take(SECTIONS).collect();
    let views = report.stages.iter().enumerate().rev();
    let picture = |(file, about): &(&str, &str)| {
        let (i, mut chart) = views.clone().find_map(|(i, (view, _))| Some((i, plot(view, file)?.0)))?;
        chart.panels.truncate(1);
        chart.notes.clear();
        Some(figure_in_column(chart, &format!("{}{about}", report.stage(i))))
    };
    let released = picture(&("springback.png", "spring-back"));
    html! {
        (tools(report))
        (stages(report))
        div.pictures.{ "of-" (sections.len() + usize::from(released.is_some())) } {
            @for i in &sections { (start(report, *i)) }
            @if let Some(picture) = released { (picture) }
        }
        div.pictures { @for picture in RESULTS.iter().filter_map(picture) { (picture) } }
    }
}

/// Draw ratio of the first stage, and the ratios of the punches of those after it that bring tools \[–\].
pub(super) fn ratios(report: &Report) -> Vec<Option<f64>> {
    let models: Vec<&Model> = with_new_tools(report).map(|i| begun(report, i).0).collect();
    let punch = |model: &Model| Some(extent(model.tool(Role::Punch)?).1);
    let redraws = models.windows(2).map(|pair| Some(punch(pair[0])? / punch(pair[1])?).filter(|ratio| *ratio > 1.0));
    models.first().map(|first| draw_ratio(first)).into_iter().chain(redraws).collect()
}

fn tools(report: &Report) -> Markup {
    let stages: Vec<usize> = with_new_tools(report).collect();
    let sizes: Vec<_> = stages.iter().map(|i| begun(report, *i).2).collect();
    let find = |k: usize, of| Some(sizes[k].iter().find(|size| size.name.starts_with(of))?.amount.to_string());
    let ratios = ratios(report).into_iter().map(|ratio| Some(Amount::ratio(ratio?).to_string()));
    let sizes = TOOLS.map(|(label, of)| (label, (0..stages.len()).map(|k| find(k, of)).collect()));
    let heights = stages.iter().map(|i| value(report, *i, "part_height")).collect();
    let before = |i: &usize| {
        let begin = &report.solution.case.stages[*i].begin;
        let does = [(begin.turn_over, "turned over"), (begin.anneal, "annealed")];
        let does = does.into_iter().filter(|(is, _)| *is).map(|(_, what)| what.to_owned());
        Some(joined(does, ", ")).filter(|text| !text.is_empty())
    };
    let columns = [("Ratio", ratios.collect())].into_iter().chain(sizes);
    let columns = columns.chain([("Height", heights), ("Before", stages.iter().map(before).collect())]);
    by_stage(report, &stages, columns.collect())
}

fn stages(report: &Report) -> Markup {
    let all: Vec<usize> = (0..report.stages.len()).collect();
    let of = |key: &str| all.iter().map(|i| value(report, *i, key)).collect();
    by_stage(report, &all, COLUMNS.map(|(label, key)| (label, of(key))).into())
}

fn value(report: &Report, i: usize, key: &str) -> Option<String> {
    report.stages.get(i)?.1.numbers().find(|(own, ..)| *own == key).map(|(_, _, amount)| amount.to_string())
}

fn by_stage(report: &Report, stages: &[usize], columns: Vec<(&str, Vec<Option<String>>)>) -> Markup {
    let columns: Vec<_> = columns.into_iter().filter(|(_, values)| values.iter().any(Option::is_some)).collect();
    let rows = stages.iter().enumerate().map(|(k, i)| {
        let label = report.stage(*i);
        let label = if label.is_empty() { "1".to_owned() } else { label.trim_end_matches(": ").to_owned() };
        let values = columns.iter().map(|(_, values)| values[k].clone().unwrap_or_else(|| "–".to_owned()));
        Row { cells: std::iter::once(label).chain(values).collect(), ..Row::default() }
    });
    table(&std::iter::once("Stage").chain(columns.iter().map(|(label, _)| *label)).collect::<Vec<_>>(), rows)
}

fn with_new_tools<'a>(report: &'a Report) -> impl Iterator<Item = usize> + 'a {
    let stages = &report.solution.stages;
    (0..report.stages.len()).filter(|i| {
        let earlier = stages[..*i].iter().flat_map(|stage| &stage.model.tools);
        let is_known = |tool: &Tool| earlier.clone().any(|other| other.profile == tool.profile);
        *i == 0 || stages[*i].model.release.is_none() && !stages[*i].model.tools.iter().all(is_known)
    })
}

fn start(report: &Report, i: usize) -> Markup {
    let (model, start, mut sizes) = begun(report, i);
    // The table of stages has it, and the end of it is far below.
    sizes.retain(|size| size.name != "Travel");
    let mut chart = dimensioned(String::new(), model, start, &sizes);
    chart.notes.clear();
    let sheet = if i == 0 { "blank" } else { "sheet" };
    figure_in_column(chart, &format!("{}section at the start: {sheet} blue, tools grey", report.stage(i)))
}

fn begun<'a>(report: &'a Report, i: usize) -> (&'a Model, Option<&'a Frame>, Vec<Dimension>) {
    let stage = &report.solution.stages[i];
    let start = stage.start.as_ref().filter(|_| i > 0);
    (&stage.model, start, dimensions(&stage.model, start))
}

pub(super) fn sections<'a>(report: &'a Report) -> impl Iterator<Item = Section> + 'a {
    with_new_tools(report).map(|i| {
        let (model, start, sizes) = begun(report, i);
        section(if i == 0 { "Section".to_owned() } else { report.stage(i) + "section" }, model, start, &sizes)
    })
}
