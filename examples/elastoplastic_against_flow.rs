//! The elastoplastic law against the flow law on one case: both load curves, and their difference below.
//!
//! `cargo run --release --example elastoplastic_against_flow -- cases/woo_hemispherical.toml elastoplastic.png`

use stampflow::case;
use stampflow::output::chart::{BLACK, Chart, Look, Panel, Scale, Series};
use stampflow::output::{png, write};
use stampflow::table::fields::step::{PUNCH_FORCE, TRAVEL};
use stampflow::table::{Column, Unit};
use std::path::Path;
use std::process::ExitCode;

/// Points through the thickness, for both: what the elastoplastic law needs (its moment grows in jumps with few).
const LAYERS: usize = 15;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, picture] = &arguments[..] else {
        eprintln!("error: give a case that has young and poisson in [material], and a picture to write");
        return ExitCode::from(2);
    };
    match compare(path, Path::new(picture)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

fn compare(path: &str, picture: &Path) -> Result<(), String> {
    let [flow, elastoplastic] = ["flow", "elasto_viscoplastic"].map(|mode| {
        let settings = [format!("material.mode={mode}"), format!("blank.layers={LAYERS}")];
        let case = case::load(path, &settings).map_err(|error| error.to_string())?;
        let run = stampflow::run(case.model(), &mut ());
        Ok::<_, String>((case, run))
    });
    let ((case, flow), (_, elastoplastic)) = (flow?, elastoplastic?);
    let [by_flow, by_elastoplastic] = [&flow, &elastoplastic].map(|stage| TRAVEL.against(&PUNCH_FORCE, &stage.steps));
    let difference =
        by_elastoplastic.iter().filter(|p| p.1 > 0.0).map(|&(x, force)| (x, 100.0 * (at(&by_flow, x) / force - 1.0)));
    // The first tenth is off the scale: the flow law has no elastic part to go through.
    let difference = difference.filter(|p| p.0 > 0.1 * case.model().travel).collect();
    let [x, y] = [TRAVEL, PUNCH_FORCE].map(|field| field.axis(case.model().extent()));
    let chart = Chart {
        title: format!("{}, elastoplastic and flow", case.model().title),
        legend: String::new(),
        panels: vec![
            Panel {
                x: x.clone(),
                y,
                series: vec![
                    Series::new("Flow law", by_flow, Look::curve(0)),
                    Series::new("Elastoplastic", by_elastoplastic, Look::curve(1)),
                ],
                scale: Scale::Fit { height: 270.0, least: 0.0 },
            },
            Panel {
                x,
                y: Column::new("difference", "Flow over elastoplastic", Unit::Percent, vec![]).axis(),
                series: vec![Series::silent(difference, Look::Line { color: BLACK, width: 1.6, dash: &[] })],
                scale: Scale::Fit { height: 150.0, least: 0.0 },
            },
        ],
        notes: case.model().notes.clone(),
    };
    write(picture, &png(&chart)).map_err(|error| error.to_string())
}

/// A curve's value at `x`, in between linearly.
fn at(curve: &[(f64, f64)], x: f64) -> f64 {
    let after = curve.partition_point(|p| p.0 < x).clamp(1, curve.len() - 1);
    let (a, b) = (curve[after - 1], curve[after]);
    a.1 + (x - a.0) / (b.0 - a.0) * (b.1 - a.1)
}
