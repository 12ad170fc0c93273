//! Small models for unit tests.

use crate::element::{Geometry, Theory};
use crate::material::hardening::Swift;
use crate::material::{Hardening, Material};
use crate::model::{Blank, Edge, Grading, Mode, Model, Settings};

/// A blank of so many elements without tools, solved with Newton's matrix.
pub fn bare(geometry: Geometry, theory: Theory, length: f64, thickness: f64, elements: usize) -> Model {
    Model {
        title: "test".into(),
        notes: vec![],
        geometry,
        depth: None,
        blank: Blank {
            length,
            thickness,
            elements,
            grading: Grading::Uniform,
            theory,
            layers: if theory == Theory::Membrane { 1 } else { 5 },
            rule: Default::default(),
            edge: Edge::Free,
        },
        material: Material::plain(Hardening::Swift(Swift::new(500.0, 0.2, 1e-3).expect("valid"))),
        tools: vec![],
        beads: vec![],
        gas: vec![],
        heat: None,
        travel: 1.0,
        schedule: None,
        speed: 1.0,
        duration: 1.0,
        stop: Default::default(),
        timed: true,
        frames: vec![1.0],
        settings: Settings { iteration: crate::model::Iteration::Newton, ..Settings::default() },
        mode: Mode::default(),
        release: None,
        forming_limit: None,
    }
}
