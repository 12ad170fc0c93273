//! Sheet nodes against rigid tools: gap, pressure, friction, tangent, in that order.
//!
//! ```text
//! g = d(x) − t/2               gap between the tool and the sheet's face (current thickness)
//! N = a p(g)                   normal force of the tributary area a, smoothed penalty p
//! T = −a τ(p, s)               friction against the slip s relative to the tool
//! F = N n + T τ                on the sheet; n points from the tool to the sheet
//! ```
//!
//! An augmented Lagrangian shifts the gap that the penalty sees by λ ≤ 0, step by step of its own iteration, until the
//! pressure stands at a gap of nothing: N = a p(g + λ).

pub mod friction;
pub mod penalty;

use crate::geometry::{Closest, Point, turned};
use friction::{Friction, Sliding};
use nalgebra::Matrix2;
use penalty::{Penalty, ValueAndSlope};

/// A node as a tool sees it.
#[derive(Clone, Copy, Debug)]
pub struct ContactNode {
    /// Position in the tool's own frame: the node's less the tool's displacement \[mm\].
    pub position: Point,
    /// Displacement in the step, relative to the tool \[mm\].
    pub relative: Point,
    /// Current thickness at the node \[mm\].
    pub thickness: f64,
    /// Tributary area \[mm², or mm per mm of depth\].
    pub area: f64,
    /// Pressure carried from the last iteration \[MPa\]; zero gives the consistent tangent.
    pub carried: f64,
    /// λ ≤ 0 of the augmented Lagrangian \[mm\].
    pub shift: f64,
    /// Regularisation s₀ of the slip \[mm\].
    pub slip_scale: f64,
    /// Duration of the step \[s\].
    pub duration: f64,
    /// Shear yield stress of the sheet \[MPa\].
    pub shear_yield: f64,
}

/// Force of a tool on a node, and its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct ContactForce {
    /// Force on the sheet \[N, or N/mm\].
    pub force: Point,
    /// ∂F/∂x with x the node's position; ∂F/∂(tool displacement) is its negative times e_z. Not symmetric.
    pub by_position: Matrix2<f64>,
    /// ∂F/∂t \[N/mm\].
    pub by_thickness: Point,
    /// Gap between tool and sheet face \[mm\]; negative when the sheet penetrates.
    pub gap: f64,
    /// Pressure \[MPa\] and the slope dp/dg of the matrix \[N/mm³\].
    pub pressure: ValueAndSlope,
    /// Normal force N ≥ 0 \[N, or N/mm\].
    pub normal: f64,
    /// Friction T, positive along the normal turned by +90° \[N, or N/mm\].
    pub tangential: f64,
    /// Slip s of the step, along the same direction \[mm\].
    pub slip: f64,
}

/// The force of one tool on one node whose closest point of the tool is `closest`; `None` when it is out of reach.
#[inline]
pub fn touch(closest: &Closest, penalty: &Penalty, friction: &Friction, node: &ContactNode) -> Option<ContactForce> {
    let gap = closest.distance - 0.5 * node.thickness;
    let pressure = penalty.towards(gap + node.shift, node.carried)?;
    let n = closest.normal;
    let tau = turned(n);

    let normal = node.area * pressure.value;
    let stiffness = node.area * pressure.slope; // dN/dg, negative
    let slip = tau.dot(&node.relative);
    let drag = friction.at(&Sliding {
        pressure: pressure.value,
        slip,
        scale: node.slip_scale,
        duration: node.duration,
        shear_yield: node.shear_yield,
    });
    let tangential = -node.area * drag.value;

    // dn = c τ (τ·dx), dτ = −c n (τ·dx): the frame turns along a curved tool.
    let c = closest.curvature;
    let slip_row = tau * (1.0 - c * n.dot(&node.relative));
    let force_row = n * (-drag.by_pressure * stiffness) - slip_row * (node.area * drag.by_slip);
    let by_position =
        n * n.transpose() * stiffness + tau * tau.transpose() * (normal * c) + tau * force_row.transpose()
            - n * tau.transpose() * (tangential * c);
    let by_thickness = (n - tau * drag.by_pressure) * (-0.5 * stiffness);

    Some(ContactForce {
        force: n * normal + tau * tangential,
        by_position,
        by_thickness,
        gap,
        pressure,
        normal,
        tangential,
        slip,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Profile;
    use approx::assert_relative_eq;

    /// Trust: central differences, h = 1e-7 mm on forces that change over 2e-3 mm: truncation near 1e-8 of the entries.
    #[test]
    fn tangent_is_the_derivative_on_every_shape_and_thickness() {
        let t = 1.0;
        let penalty = Penalty { stiffness: 1e4, smoothing: 2e-3 };
        let h = 1e-7;
        for ((_, friction), (profile, position)) in Friction::examples().into_iter().cycle().zip([
            (Profile::hemispherical_punch(25.0, t), Point::new(10.0, -2.086)),
            (Profile::die(51.25, 7.0, t), Point::new(53.04, 1.7)),
            (Profile::die(51.25, 7.0, t).faceted(4), Point::new(53.04, 1.4)),
            (Profile::holder(60.0, t), Point::new(70.0, 0.001)),
        ]) {
            let contact = profile.closest(position);
            // Put the node at three gaps around touching, with a step that slides both ways.
            for gap in [-4e-3, 0.0, 3e-3] {
                for slip in [-0.2, 1e-3, 0.05] {
                    let x = position + contact.normal * (gap + 0.5 * t - contact.distance);
                    let at = |x: Point, moved: Point, thickness: f64| {
                        let node = ContactNode {
                            position: x,
                            relative: moved,
                            thickness,
                            area: 3.0,
                            carried: 0.0,
                            shift: -1e-3,
                            slip_scale: 3e-3,
                            duration: 0.1,
                            shear_yield: 150.0,
                        };
                        touch(&profile.closest(x), &penalty, &friction, &node).expect("within reach")
                    };
                    let step = turned(contact.normal) * slip + contact.normal * 0.01;
                    let base = at(x, step, t);
                    for (j, d) in [Point::new(h, 0.0), Point::new(0.0, h)].into_iter().enumerate() {
                        let difference = (at(x + d, step + d, t).force - at(x - d, step - d, t).force) / (2.0 * h);
                        let scale = base.by_position.norm();
                        assert!((difference - base.by_position.column(j)).norm() < 1e-4 * scale);
                    }
                    let difference = (at(x, step, t + h).force - at(x, step, t - h).force) / (2.0 * h);
                    assert_relative_eq!(difference, base.by_thickness, max_relative = 1e-4);
                }
            }
        }
    }
}
