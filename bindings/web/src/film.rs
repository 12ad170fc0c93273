//! The sheet and its tools as they move.

use serde_json::{Value, json};
use stampflow::model::Stage;
use stampflow::{Model, Observer, State};

/// Pictures of a stage, evenly over its travel: as many as a slider shows.
const PICTURES: f64 = 40.0;

/// An observer that keeps pictures.
#[derive(Default)]
pub struct Film(pub Vec<Strip>);

/// The pictures of a stage, one after the other.
#[derive(Default)]
pub struct Strip {
    /// Share of the run at which the next one is taken \[–\].
    next: f64,
    /// Punch travel \[mm\].
    travel: Vec<f64>,
    /// r, z \[mm\], θ \[rad\] and thickness \[mm\] of each node.
    nodes: Vec<f64>,
    /// One per element \[mm\].
    thickness: Vec<f64>,
    /// Meridional and hoop of each element \[–\].
    strains: Vec<f64>,
    /// Move of each tool away from the axis and along z \[mm\].
    tools: Vec<f64>,
}

impl Strip {
    fn take(&mut self, state: &State) {
        self.travel.push(state.travel);
        for (i, [r, z, theta]) in state.nodes.iter().enumerate() {
            self.nodes.extend([*r, *z, *theta, state.thickness_at(i)]);
        }
        self.thickness.extend(&state.thickness);
        self.strains.extend(state.membrane.iter().flatten());
        self.tools.extend(state.tools.iter().flat_map(|tool| [tool.x, tool.y]));
    }

    /// With the end of the stage, as arrays.
    pub fn json(mut self, end: &State) -> Value {
        self.take(end);
        let elements = end.thickness.len();
        json!({
            "elements": elements,
            "travel": self.travel,
            "nodes": self.nodes,
            "thickness": self.thickness,
            "strains": self.strains,
            "tools": self.tools,
        })
    }
}

impl Observer for Film {
    fn stage(&mut self, _: &Stage) {
        self.0.push(Strip::default());
    }

    fn state(&mut self, model: &Model, state: &State) {
        let Some(strip) = self.0.last_mut() else { return };
        let progress = model.progress(state.time);
        // The end is added when the stage is known to have come there.
        if progress >= strip.next && progress < 1.0 {
            strip.take(state);
            strip.next = progress + 1.0 / PICTURES;
        }
    }
}
