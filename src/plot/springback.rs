//! The sheet before and after the tools are taken away.

use super::chart::{BLACK, Chart, Look, Series, color, pale};
use super::{StageView, sections};
use crate::measure::{self, Change, FLANGE_ANGLE, Leg, Shape, ShapeMeasure, WALL_ANGLE};

/// How much farther than they were fitted the measured lines are drawn, over their length.
const LONGER: f64 = 0.25;

/// Both sections, the tools where they last were, and the lines that angles were measured with.
pub fn plot(view: &StageView) -> Option<Chart> {
    let [before, after] = view.stage.released()?;
    let model = view.model();
    let shapes = [Shape::of(before), Shape::of(after)];
    let found = measure::changes(&shapes[0], &shapes[1]);
    let nodes = || before.nodes.iter().chain(&after.nodes);
    let [x, y] = sections::window(nodes(), model.blank.thickness);
    let [first, second] = [before, after].map(|frame| sections::sheet(frame, 0..frame.elements.len(), 1.0));
    let outline = second.iter().chain(second.first()).copied().collect();
    let sheets = [
        Series::new(String::from("Before"), first, Look::Area { fill: pale(color(0)), edge: Some(color(0)) }),
        Series::new(String::from("After"), outline, Look::Line { color: color(1), width: 2.0, dash: &[] }),
    ];
    let measured = |quantity: ShapeMeasure, of: fn(&Shape) -> Option<&Leg>, dash| {
        let look = Look::Line { color: BLACK, width: 1.4, dash };
        let label =
            found.iter().find(|change| change.quantity.key == quantity.key).map(|change| String::from(worded(change)));
        let lines = shapes.iter().filter_map(of).map(|leg| Series::silent(longer(leg), look)).collect::<Vec<_>>();
        lines
            .into_iter()
            .rev()
            .enumerate()
            .map(move |(i, line)| Series { label: label.clone().filter(|_| i == 0), ..line })
    };
    let lines = measured(WALL_ANGLE, |shape| shape.wall.as_ref(), &[7.0, 3.5]).chain(measured(
        FLANGE_ANGLE,
        |shape| shape.flange.as_ref(),
        &[2.0, 3.0],
    ));
    let in_legend = [WALL_ANGLE.key, FLANGE_ANGLE.key];
    let others =
        found.iter().filter(|change| !in_legend.contains(&change.quantity.key)).map(|c| String::from(worded(c)) + ".");
    Some(Chart {
        title: view.titled("spring-back"),
        legend: String::new(),
        panels: vec![sections::panel(
            model.geometry,
            sections::tools(model, Some(before), x.1).chain(sheets).chain(lines),
            [x, y],
        )],
        notes: std::iter::once(String::from(
            "The sheet is true to thickness. Grey: the tools before they were taken away.",
        ))
        .chain(others)
        .chain(view.assumptions())
        .collect(),
    })
}

/// The fitted line, drawn beyond both of its ends.
fn longer(leg: &Leg) -> Vec<(f64, f64)> {
    let [[r0, z0], [r1, z1]] = leg.line;
    let at = |f: f64| (r0 + f * (r1 - r0), z0 + f * (z1 - z0));
    vec![at(-LONGER), at(1.0 + LONGER)]
}

/// `Wall to the punch direction: 0.3° → 8.2°`.
fn worded(change: &Change) -> String {
    format!("{}: {change}", change.quantity.label)
}
