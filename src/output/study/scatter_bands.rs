//! Bands of a scatter's curves: where nine of ten parts are.

use crate::plot::chart::{Chart, Look, Panel, Scale, Series, color};
use crate::study::scatter::Band;
use crate::table::{Axis, Column, Unit};

/// Punch force over the travel.
pub(super) fn load(band: &Band, force: Unit, name: &str) -> Chart {
    let axes = [
        Column::new("travel", "Punch travel", Unit::Mm, Vec::new()).axis(),
        Column::new("punch_force", "Punch force", force, Vec::new()).axis(),
    ];
    chart(band, axes, 0.0, format!("{name}: load of nine parts in ten"))
}

/// Thickness over the initial distance from the axis.
pub(super) fn thickness(band: &Band, name: &str) -> Chart {
    let axes = [
        Column::new("s0", "Initial distance from the axis", Unit::Mm, Vec::new()).axis(),
        Column::new("thickness", "Thickness", Unit::Mm, Vec::new()).axis(),
    ];
    let title = format!("{name}: thickness of nine parts in ten");
    chart(band, axes, 0.02, title)
}

fn chart(band: &Band, [x, y]: [Axis; 2], least: f64, title: String) -> Chart {
    let [low, median, high] = &band.quantiles;
    let curve: Vec<(f64, f64)> = band.x.iter().copied().zip(median.iter().copied()).collect();
    let series = vec![Series::new(String::from("Median"), curve, Look::curve(0))];
    let panel = Panel { x, y, series, scale: Scale::Fit { height: 350.0, least } };
    let panel = panel.with_band(String::from("5 to 95 % of the parts"), &band.x, [low, high], color(0));
    let [fewest, most] = [band.runs.iter().min(), band.runs.iter().max()].map(|n| n.copied().unwrap_or_default());
    let notes = if fewest < most {
        let few = format!("At each place of the runs that come there: {most} at the beginning, {fewest} at the end.");
        vec![few.to_string()]
    } else {
        Vec::new()
    };
    Chart { title, legend: String::new(), panels: vec![panel], notes }
}
