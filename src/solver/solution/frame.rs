//! How an instant becomes a frame.

use super::{ElementRecord, Frame, NodeRecord, PointRecord, ThroughThickness};
use crate::model::Model;
use crate::solver::state::{MaterialPoint, State};

impl State {
    /// What is kept of this instant.
    pub fn frame(&self, model: &Model) -> Frame {
        let layers = model.blank.points();
        let elements = (0..self.thickness.len())
            .map(|e| {
                let points = self.points.row(e);
                let mean = |of: &dyn Fn(&MaterialPoint) -> f64| {
                    points.iter().zip(&layers).map(|(p, l)| l.weight * of(p)).sum()
                };
                let (a, b) = (self.nodes[e], self.nodes[e + 1]);
                ElementRecord {
                    s0: 0.5 * (self.s0[e] + self.s0[e + 1]),
                    r: 0.5 * (a[0] + b[0]),
                    z: 0.5 * (a[1] + b[1]),
                    thickness: self.thickness[e],
                    strain_meridional: self.membrane[e][0],
                    strain_hoop: self.membrane[e][1],
                    strain_thickness: -self.membrane[e][0] - self.membrane[e][1] + self.dilation[e],
                    strain_equivalent: mean(&|p| p.strain),
                    strain_equivalent_max: points.iter().map(|p| p.strain).fold(0.0, f64::max),
                    stress_meridional: mean(&|p| model.cauchy(p.stress)[0]),
                    stress_hoop: mean(&|p| model.cauchy(p.stress)[1]),
                    porosity: mean(&|p| p.porosity),
                    temperature: self.temperature[e],
                    bends: self.bends[e],
                }
            })
            .collect();
        let nodes = (0..self.nodes.len())
            .map(|i| {
                let [r, z, theta] = self.nodes[i];
                NodeRecord { r, z, theta, thickness: self.thickness_at(i) }
            })
            .collect();
        let points = self.points.iter().map(|p| {
            let [stress_meridional, stress_hoop, _] = model.cauchy(p.stress);
            PointRecord { stress_meridional, stress_hoop, strain_equivalent: p.strain }
        });
        Frame {
            time: self.time,
            travel: self.travel,
            elements,
            nodes,
            through: ThroughThickness { points: points.collect(), layers },
            tool_displacement: self.tools.clone(),
        }
    }
}
