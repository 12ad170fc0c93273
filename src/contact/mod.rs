//! Contact of the sheet's faces with rigid tools: gap, pressure, friction, tangent.
//!
//! ```text
//! g = d(x) − t/2               gap between the tool and the sheet's face (current thickness)
//! N = a p(g + λ)               normal force on the area a of a contact point, smoothed penalty p
//! T = −a τ(p, s)               friction against the slip s relative to the tool
//! F = N n + T τ                on the sheet; n points from the tool to the sheet
//! Q = −N/2                     on its thickness: the virtual work is F·δx + Q δt
//! ```
//!
//! Q is the mean normal stress of the pressure on one face. The augmented Lagrangian shifts the gap by λ ≤ 0.

pub mod friction;
pub mod penalty;

use crate::geometry::{Point, turned};
use friction::{Friction, Sliding};
use penalty::{Penalty, ValueAndSlope};

/// Point of the mid-surface in contact with a tool.
#[derive(Clone, Copy, Debug)]
pub struct ContactPoint {
    /// Normal n from the tool to the sheet.
    pub facing: Point,
    /// Curvature c of the distance \[1/mm\].
    pub curvature: f64,
    /// Gap between the tool and the sheet's face \[mm\].
    pub gap: f64,
    /// Displacement in the step relative to the tool \[mm\].
    pub relative: Point,
    /// Area of the point \[mm², or mm per mm of depth\].
    pub area: f64,
    /// Pressure carried from the last iteration \[MPa\]; zero gives the consistent tangent.
    pub carried: f64,
    /// Shift λ ≤ 0 of the augmented Lagrangian \[mm\].
    pub shift: f64,
    /// Shear yield stress of the sheet \[MPa\].
    pub shear_yield: f64,
}

/// Normal and friction law of a tool in a step.
#[derive(Clone, Copy, Debug)]
pub struct ContactLaw<'a> {
    /// Normal law.
    pub penalty: &'a Penalty,
    /// Friction law.
    pub friction: &'a Friction,
    /// Regularisation s₀ of the slip \[mm\].
    pub slip_scale: f64,
    /// Duration of the step \[s\].
    pub duration: f64,
}

/// Force of a tool on a point of the sheet, F = N n + T τ, and its derivatives.
///
/// ```text
/// dg = n·dx − dt/2     ds = slip_turn τ·dx     dn = c τ (τ·dx)     dτ = −c n (τ·dx)
/// dN = by_gap dg       dT = friction_by_gap dg + friction_by_slip ds
/// ```
///
/// with dx of the point's position less the tool's displacement. The frame turns along a curved tool.
#[derive(Clone, Copy, Debug)]
pub struct ContactForce {
    /// Normal n from the tool to the sheet; τ is n turned by +90°.
    pub facing: Point,
    /// Curvature c of the distance \[1/mm\].
    pub curvature: f64,
    /// Slip s of the step along τ \[mm\].
    pub slip: f64,
    /// Derivative of s by a move along τ \[–\].
    pub slip_turn: f64,
    /// Pressure \[MPa\] and the slope dp/dg of the matrix \[N/mm³\].
    pub pressure: ValueAndSlope,
    /// Normal force N ≥ 0 \[N, or N/mm\].
    pub normal: f64,
    /// dN/dg < 0 \[N/mm\].
    pub by_gap: f64,
    /// Friction T along τ \[N, or N/mm\].
    pub tangential: f64,
    /// ∂T/∂g \[N/mm\].
    pub friction_by_gap: f64,
    /// ∂T/∂s \[N/mm\].
    pub friction_by_slip: f64,
}

impl ContactForce {
    /// Tangent τ.
    pub fn along(&self) -> Point {
        turned(self.facing)
    }

    /// F on the sheet \[N, or N/mm\].
    pub fn force(&self) -> Point {
        self.facing * self.normal + self.along() * self.tangential
    }
}

impl ContactLaw<'_> {
    /// Force on a point; zero out of reach.
    pub fn force(&self, point: &ContactPoint) -> ContactForce {
        let ContactPoint { facing, curvature, gap, relative, area, carried, shift, shear_yield } = *point;
        let pressure = self.penalty.towards(gap + shift, carried);
        let slip = facing.perp(&relative);
        let (scale, duration) = (self.slip_scale, self.duration);
        let friction = self.friction.at(&Sliding { pressure: pressure.value, slip, scale, duration, shear_yield });
        let by_gap = area * pressure.slope;
        ContactForce {
            facing,
            curvature,
            slip,
            slip_turn: 1.0 - curvature * facing.dot(&relative),
            pressure,
            normal: area * pressure.value,
            by_gap,
            tangential: -(area * friction.value),
            friction_by_gap: -(by_gap * friction.by_pressure),
            friction_by_slip: -(area * friction.by_slip),
        }
    }
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
            // Put the point at three gaps around touching, with a step that slides both ways.
            for gap in [-4e-3, 0.0, 3e-3] {
                for slip in [-0.2, 1e-3, 0.05] {
                    let x = position + contact.normal * (gap + 0.5 * t - contact.distance);
                    let law = ContactLaw { penalty: &penalty, friction: &friction, slip_scale: 3e-3, duration: 0.1 };
                    let at = |x: Point, moved: Point, thickness: f64| {
                        let closest = profile.closest(x);
                        law.force(&ContactPoint {
                            facing: closest.normal,
                            curvature: closest.curvature,
                            gap: closest.distance - 0.5 * thickness,
                            relative: moved,
                            area: 3.0,
                            carried: 0.0,
                            shift: -1e-3,
                            shear_yield: 150.0,
                        })
                    };
                    let force = |x: Point, moved: Point| at(x, moved, t).force();
                    let step = turned(contact.normal) * slip + contact.normal * 0.01;
                    let base = at(x, step, t);
                    let (n, tau) = (base.facing, base.along());
                    for d in [Point::new(h, 0.0), Point::new(0.0, h)] {
                        let difference = (force(x + d, step + d) - force(x - d, step - d)) / (2.0 * h);
                        let (dg, dx) = (n.dot(&d) / h, tau.dot(&d) / h);
                        let friction = base.friction_by_gap * dg + base.friction_by_slip * base.slip_turn * dx;
                        let turning = (tau * base.normal - n * base.tangential) * (base.curvature * dx);
                        let expected = n * (base.by_gap * dg) + tau * friction + turning;
                        assert!((difference - expected).norm() < 1e-4 * base.by_gap.abs());
                    }
                    let [thick, thin] = [t + h, t - h].map(|t| at(x, step, t).force());
                    let expected = (n * base.by_gap + tau * base.friction_by_gap) * -0.5;
                    assert_relative_eq!((thick - thin) / (2.0 * h), expected, max_relative = 1e-4);
                }
            }
        }
    }
}
