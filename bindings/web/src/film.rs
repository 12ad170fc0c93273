//! Pictures of the sheet and its tools as they move.

use serde::Serialize;
use stampflow::model::Stage;
use stampflow::{Model, Observer, State};

/// Pictures of a stage, evenly over its travel.
const PICTURES: f64 = 40.0;

/// Observer that keeps pictures.
#[derive(Default)]
pub struct Film(pub Vec<Strip>);

/// Pictures of a stage, one after the other.
#[derive(Default, Serialize)]
pub struct Strip {
    /// Progress of the run at which the next picture is due \[–\].
    #[serde(skip)]
    next: f64,
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

impl Strip {
    /// Adds a picture.
    pub fn take(&mut self, model: &Model, state: &State) {
        self.elements = state.thickness.len();
        self.travel.push(state.travel);
        for (i, [r, z, theta]) in state.nodes.iter().enumerate() {
            self.nodes.extend([*r, *z, *theta, state.thickness_at(i)]);
        }
        self.thickness.extend(&state.thickness);
        let curve = model.forming_limit.as_ref();
        for [meridional, hoop] in &state.membrane {
            let minor = meridional.min(*hoop);
            self.minor.push(minor);
            self.major.push(meridional.max(*hoop));
            self.limit.push(curve.filter(|curve| curve.knows(minor)).map_or(f64::NAN, |curve| curve.major_at(minor)));
        }
        self.tools.extend(state.tools.iter().flat_map(|tool| [tool.x, tool.y]));
    }
}

impl Observer for Film {
    fn stage(&mut self, _: &Stage) {
        self.0.push(Strip::default());
    }

    fn state(&mut self, model: &Model, state: &State) {
        let Some(strip) = self.0.last_mut() else { return };
        let progress = model.progress(state.time);
        // The end is added once the stage has come there.
        if progress >= strip.next && progress < 1.0 {
            strip.take(model, state);
            strip.next = progress + 1.0 / PICTURES;
        }
    }
}
