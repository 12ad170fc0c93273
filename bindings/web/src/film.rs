//! Pictures of the sheet and its tools as they move.

use serde_json::{Value, json};
use stampflow::solver::solution::{ElementRecord, Frame};
use stampflow::solver::state::MaterialPoint;
use stampflow::{Model, Observer, Stage, State};

/// Pictures of a stage, evenly over its travel.
const PICTURES: f64 = 40.0;

/// A frame, and the viscosity of each element \[MPa s\].
pub type Picture = (Frame, Vec<f64>);

/// Observer that keeps pictures of every stage.
#[derive(Default)]
pub struct Recorder(pub Vec<Vec<Picture>>);

/// Picture of a state, with μ = σ̄/(3 ε̄̇) as the mean through the thickness.
pub fn picture(model: &Model, state: &State) -> Picture {
    let (layers, metal) = (model.blank.points(), model.material.yield_criterion);
    let own = |point: &MaterialPoint| metal.equivalent_stress(point.stress) / (3.0 * point.equivalent_rate);
    let mean = |points: &[MaterialPoint]| points.iter().zip(&layers).map(|(point, at)| at.weight * own(point)).sum();
    (state.frame(model), state.points.rows().map(mean).collect())
}

impl Observer for Recorder {
    fn stage(&mut self, _: &Stage) {
        self.0.push(Vec::new());
    }

    fn restart(&mut self, _: &Model, state: &State, _: usize) {
        self.0.last_mut().into_iter().for_each(|frames| frames.retain(|(frame, _)| frame.time <= state.time));
    }

    fn state(&mut self, model: &Model, state: &State) {
        let Some(frames) = self.0.last_mut() else { return };
        let due = frames.last().map_or(0.0, |last| model.progress(last.0.time) + 1.0 / PICTURES);
        let progress = model.progress(state.time);
        // The end is added once the stage has come there.
        if progress >= due && progress < 1.0 {
            frames.push(picture(model, state));
        }
    }
}

/// Pictures one after the other: nodes as r, z \[mm\], θ \[rad\] and thickness \[mm\], of each element thickness \[mm\], strains \[–\],
/// the limit of the major strain at its minor strain \[–\] (not a number where it is not known) and viscosity \[MPa s\].
pub fn film(model: &Model, pictures: &[Picture]) -> Value {
    let frames = || pictures.iter().map(|(frame, _)| frame);
    let elements = |number: &dyn Fn(&ElementRecord) -> f64| -> Vec<f64> {
        frames().flat_map(|frame| frame.elements.iter().map(number)).collect()
    };
    let minor = |element: &ElementRecord| element.strain_meridional.min(element.strain_hoop);
    let limit = |element: &ElementRecord| {
        let curve = model.forming_limit.as_ref().filter(|curve| curve.knows(minor(element)));
        curve.map_or(f64::NAN, |curve| curve.major_at(minor(element)))
    };
    let nodes = frames().flat_map(|frame| &frame.nodes).flat_map(|node| [node.r, node.z, node.theta, node.thickness]);
    let tools = frames().flat_map(|frame| &frame.tool_displacement).flat_map(|tool| [tool.x, tool.y]);
    json!({
        "elements": pictures.last().map_or(0, |(frame, _)| frame.elements.len()),
        "travel": frames().map(|frame| frame.travel).collect::<Vec<_>>(),
        "nodes": nodes.collect::<Vec<_>>(),
        "thickness": elements(&|element| element.thickness),
        "minor": elements(&minor),
        "major": elements(&|element| element.strain_meridional.max(element.strain_hoop)),
        "limit": elements(&limit),
        "viscosity": pictures.iter().flat_map(|(_, viscosity)| viscosity).collect::<Vec<_>>(),
        "tools": tools.collect::<Vec<_>>(),
    })
}
