//! Pressure on a face against thick shells.

use super::tests::{NEWTON, bare, with_step};
use super::*;
use crate::geometry::{Piece, Profile};
use crate::material::{Hardening, hardening::Swift};
use crate::model::{Face, Gas};
use std::f64::consts::FRAC_PI_2;

/// Yield stress of a metal that does not harden \[MPa\].
const YIELD: f64 = 300.0;
/// Radius of the mid-surface \[mm\].
const RADIUS: f64 = 40.0;
const ELEMENTS: usize = 160;
/// Angle from the pole to the edge \[rad\].
const SWEEP: f64 = 1.2;

/// A cap of a sphere, or half an arch of a tube.
fn shell(geometry: Geometry, thickness: f64) -> Model {
    let mut model = bare(geometry, Theory::Bending, RADIUS, thickness, ELEMENTS);
    model.material = Material::plain(Hardening::Swift(Swift::new(YIELD, 1e-9, 1e-3).expect("valid")));
    model.settings = Settings { cutoff_strain: 1e-9, ..model.settings };
    model
}

fn curved(model: &Model) -> State {
    let angle = |i: usize| SWEEP * i as f64 / ELEMENTS as f64;
    let mut state = State::initial(model, (0..=ELEMENTS).map(|i| RADIUS * angle(i)).collect());
    for (i, node) in state.nodes.iter_mut().enumerate() {
        *node = [RADIUS * angle(i).sin(), RADIUS * angle(i).cos(), -angle(i)];
    }
    for (volume, pair) in state.volume.iter_mut().zip(state.nodes.windows(2)) {
        *volume = model.blank.thickness * Reference::new(model.geometry, Theory::Bending, pair[0], pair[1]).area();
    }
    state.tools.fill(Point::zeros());
    state
}

/// Strain of a step in which the shell grows about its centre \[–\]: far above the cut-off, and next to nothing.
const GROWTH: f64 = 1e-5;

/// Force along the normal on a node half-way, and the pressure on its face \[MPa\], as the shell grows.
fn on_a_node(model: &Model) -> (f64, f64) {
    let state = curved(model);
    with_step(model, &state, (0.01, true), |step, trial, evaluation| {
        trial.moves.iter_mut().zip(&state.nodes).for_each(|(u, x)| *u = [GROWTH * x[0], GROWTH * x[1], 0.0]);
        assert!(evaluate(step, trial, &NEWTON, evaluation));
        let [r, z, _] = state.nodes[ELEMENTS / 2];
        let pressure = evaluation.contacts.get(ELEMENTS).map_or(0.0, |contact| contact.pressure.value);
        (evaluation.system.rhs[ELEMENTS / 2].xy().dot(&Point::new(r, z)), pressure)
    })
}

/// Trust: the closed forms of the thick sphere and the thick tube in plane strain, which flow through. What a shell with a
/// face and a normal stress misses is of second order in t/R: (t/R)²/3 by hand for the sphere, (t/R)²/12 for the tube.
#[test]
fn thick_shells_flow_at_the_pressure_of_the_closed_form_but_for_second_order() {
    for slender in [0.02, 0.1, 1.0 / 3.0] {
        for (geometry, factor) in [(Geometry::Axisymmetric, 2.0), (Geometry::PlaneStrain, 2.0 / 3f64.sqrt())] {
            let exact = factor * YIELD * f64::ln((1.0 + 0.5 * slender) / (1.0 - 0.5 * slender));
            let (thickness, bound) = (slender * RADIUS, 0.4 * slender * slender + 5e-5);
            let plain = shell(geometry, thickness);
            let gas = |pressure: f64| {
                let gas = vec![Gas { face: Face::Lower, pressure: pressure.into(), within: RADIUS }];
                on_a_node(&Model { gas, ..plain.clone() }).0
            };
            let tool = |deep: f64| {
                let arc = Piece::arc(Point::zeros(), RADIUS - 0.5 * thickness + deep, FRAC_PI_2 + 0.1, -1.5);
                let profile = Profile::new(vec![arc]).expect("one arc");
                let tool = Tool { role: Role::Punch, profile, friction: 0.0.into(), motion: Motion::Fixed };
                on_a_node(&Model { tools: vec![tool], ..plain.clone() })
            };
            let deep = bisect(-0.1 * thickness, 0.1 * thickness, 60, |deep| tool(deep).0 < 0.0)[0];
            for limit in [bisect(0.0, 2.0 * YIELD, 60, |pressure| gas(pressure) < 0.0)[0], tool(deep).1] {
                let error = limit / exact - 1.0;
                assert!(error.abs() < bound, "{geometry:?}, t/R {slender}: {error:.2e} of at most {bound:.2e}");
            }
        }
    }
}
