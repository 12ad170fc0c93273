//! Damage of ductile fracture after a converged step.
//!
//! ```text
//! D ← D + f(σ) Δε̄,   σ_n(ξ) = −½ ((1 + ξ) p₊ + (1 − ξ) p₋)
//! ```
//!
//! with the plastic strain increment Δε̄ of the step and the stress at its end, which is first order in the step and needs no
//! stress of before where bending turns about: 0.3 % of D with the usual step. σ_n falls in a straight line from the pressure
//! of the tools on one face to that on the other; its mean is the normal stress of the
//! [contact](super::terms::contact). A gas acts on the mid-surface, without one.
//!
//! On the faces D grows by the increment extrapolated from the two outermost points: exact in pure bending.

use super::*;
use crate::material::{Fracture, fracture::FractureStress};

pub(super) fn add(fracture: &Fracture, converged: &Converged, next: &mut State) {
    let (step, rule) = (converged.step, &converged.step.context.rule);
    let (model, criterion) = (step.model, &step.model.material.yield_criterion);
    for (e, (points, faces)) in next.points.rows_mut().zip(&mut next.face_damage).enumerate() {
        let [lower, upper] = pressures(converged, e);
        let before = step.state.points.row(e);
        for ((point, before), at) in points.iter_mut().zip(before).zip(rule) {
            let increment = point.strain - before.strain;
            if increment > 0.0 {
                let normal = -0.5 * ((1.0 + at.xi) * lower + (1.0 - at.xi) * upper);
                let stress = FractureStress::new(criterion, model.cauchy(point.stress), normal);
                point.damage += increment * fracture.at(stress);
            }
        }
        let last = rule.len() - 1;
        for (face, [outer, inner]) in faces.iter_mut().zip([[0, 1.min(last)], [last, last.max(1) - 1]]) {
            let [a, b] = [outer, inner].map(|k| points[k].damage - before[k].damage);
            let beyond = 1.0 - rule[outer].xi.abs();
            let slope = if last > 0 { (a - b) / (rule[outer].xi - rule[inner].xi).abs() } else { 0.0 };
            *face += (a + beyond * slope).max(0.0);
        }
    }
}

/// Mean pressures of the tools on the lower and the upper face of an element \[MPa\].
fn pressures(converged: &Converged, e: usize) -> [f64; 2] {
    let (nodes, mut faces) = (&converged.evaluation.nodes, [0.0; 2]);
    let (along, rise) = (nodes[e + 1][0] - nodes[e][0], nodes[e + 1][1] - nodes[e][1]);
    for contact in converged.evaluation.contacts.rows().flat_map(|row| &row[STATIONS * e..STATIONS * (e + 1)]) {
        let above = contact.facing.y * along < contact.facing.x * rise;
        faces[usize::from(above)] += contact.pressure.value / STATIONS as f64;
    }
    faces
}
