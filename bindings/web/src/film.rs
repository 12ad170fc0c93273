//! Pictures of the sheet and its tools as they move.

use serde::Serialize;
use stampflow::solver::solution::Frame;
use stampflow::{Model, Observer, Stage, State};

/// Pictures of a stage, evenly over its travel.
const PICTURES: f64 = 40.0;

/// Observer that keeps frames of every stage.
#[derive(Default)]
pub struct Recorder(pub Vec<Vec<Frame>>);

impl Observer for Recorder {
    fn stage(&mut self, _: &Stage) {
        self.0.push(Vec::new());
    }

    fn restart(&mut self, _: &Model, state: &State, _: usize) {
        self.0.last_mut().into_iter().for_each(|frames| frames.retain(|frame| frame.time <= state.time));
    }

    fn state(&mut self, model: &Model, state: &State) {
        let Some(frames) = self.0.last_mut() else { return };
        let due = frames.last().map_or(0.0, |last| model.progress(last.time) + 1.0 / PICTURES);
        let progress = model.progress(state.time);
        // The end is added once the stage has come there.
        if progress >= due && progress < 1.0 {
            frames.push(state.frame(model));
        }
    }
}

/// Pictures of a stage, one after the other.
#[derive(Default, Serialize)]
pub struct Film {
    elements: usize,
    /// Punch travel \[mm\].
    travel: Vec<f64>,
    /// r, z \[mm\], θ \[rad\] and thickness \[mm\] of each node.
    nodes: Vec<f64>,
    /// Thickness of each element \[mm\].
    thickness: Vec<f64>,
    /// Minor strain of each element \[–\].
    minor: Vec<f64>,
    /// Major strain of each element \[–\].
    major: Vec<f64>,
    /// Major strain of the forming limit at each element's minor strain \[–\]; not a number where it is not known.
    limit: Vec<f64>,
    /// Displacement of each tool in r and z \[mm\].
    tools: Vec<f64>,
}

impl Film {
    /// Film of the frames of a stage.
    pub fn new(model: &Model, frames: &[Frame]) -> Self {
        let mut film = Self::default();
        let curve = model.forming_limit.as_ref();
        for frame in frames {
            film.elements = frame.elements.len();
            film.travel.push(frame.travel);
            film.nodes.extend(frame.nodes.iter().flat_map(|node| [node.r, node.z, node.theta, node.thickness]));
            for element in &frame.elements {
                let minor = element.strain_meridional.min(element.strain_hoop);
                film.thickness.push(element.thickness);
                film.minor.push(minor);
                film.major.push(element.strain_meridional.max(element.strain_hoop));
                let limit = curve.filter(|curve| curve.knows(minor));
                film.limit.push(limit.map_or(f64::NAN, |curve| curve.major_at(minor)));
            }
            film.tools.extend(frame.tool_displacement.iter().flat_map(|tool| [tool.x, tool.y]));
        }
        film
    }
}
