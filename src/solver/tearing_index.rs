//! Tearing index of every place: the force that it carries along the meridian over the largest that it bears.
//!
//! ```text
//! I = N_s/(N_c f),   N_s = σ_s t,   N_c = max_{x ≥ 0} c σ_y(ε̄ + c x) t e^(−x),   f = (ρ/t) ln(1 + t/ρ)
//! ```
//!
//! N_c is the load maximum of a further stretch x in plane strain (Considère, from the state reached), c the ratio of plane strain
//! to tension by the yield condition. With E = ε̄ + c x it is c t e^(ε̄/c) max σ_y(E) e^(−E/c): one maximum for the whole sheet.
//! σ_y has the place's temperature, and the rate of the place that strains fastest: a tear is no slower. σ_s is the flow law's
//! stress; on a tool the pull is less by half the tool's pressure. Counting it is on the safe side, by t/2ρ over a nose (declared).
//!
//! f is the share of its strength that a sheet carries while it is bent over the radius ρ of its inner face:
//!
//! ```text
//! dσ_r/dr = (σ_s − σ_r)/r,  σ_s − σ_r = σ,  σ_r(ρ + t) = 0     →     N = ∫ σ_s dr = ρ σ ln(1 + t/ρ)
//! ```
//!
//! derived here for a metal that hardens no more; 0.95 at ten thicknesses, 0.91 at five, 0.81 at two. ρ is the smallest radius that
//! the place has had on the punch: a wall beside a nose has slid off it. The mid-surface's curvature gives it, not the drawn
//! tool: a sheet that does not follow a corner is not blamed for it.
//! What bends over a die's shoulder goes on into the wall and is judged there; cups of the cupping test, whose shoulder is
//! sharper than the sheet is thick, tear on their dome. A sheet whose edge is held is stretched by the tools' travel, not
//! by a force that its flange asks for: f is 1, and I comes to 1 only at its load maximum.
//!
//! Places that two tools iron are left out, because half of both pressures is in their stress. Superplastic sheets are held
//! together by their rate and have no index. Voids weaken a sheet besides: they are judged by themselves.

use super::{ironing::is_between_walls, *};

/// Least radius over the thickness, on a corner without one \[–\].
const LEAST_RADIUS: f64 = 0.1;

pub(super) struct PlaneStrainStrength<'a> {
    material: &'a Material,
    /// c \[–\].
    factor: f64,
    /// Load maximum in plane strain of a sheet whose hardening is the same at every temperature: ε̄ \[–\] and σ_y e^(−ε̄/c) \[MPa\].
    peak: Option<[f64; 2]>,
}

impl<'a> PlaneStrainStrength<'a> {
    /// `None` where nothing is formed, and for superplastic sheets.
    pub fn new(model: &'a Model, material: &'a Material) -> Option<Self> {
        let is_superplastic = material.rate.is_some_and(|rate| rate.is_superplastic());
        let factor = material.yield_criterion.plane_strain_factor();
        let peak = material.hardening.temperatures().is_none().then(|| material.load_maximum(factor, ROOM_TEMPERATURE));
        (model.release.is_none() && !is_superplastic).then_some(Self { material, factor, peak })
    }

    /// N_c/t \[MPa\] at a strain and a temperature \[K\], without the rate.
    fn at(&self, strain: f64, temperature: f64) -> f64 {
        let [end, nominal] = self.peak.unwrap_or_else(|| self.material.load_maximum(self.factor, temperature));
        if strain >= end {
            return self.factor * self.material.yield_stress(strain, temperature);
        }
        let warm = self.material.thermal.map_or(1.0, |thermal| thermal.at(temperature));
        self.factor * nominal * (strain / self.factor).exp() * warm
    }
}

/// Adds the tearing index of a step to the next state, and its largest to the record; after [`super::ironing::add`].
pub(super) fn add(converged: &Converged, next: &mut State, record: &mut StepRecord) {
    let Converged { step, evaluation, .. } = converged;
    let (model, rule) = (step.model, &step.context.rule);
    let n = next.thickness.len();
    let rate_factor = model.material.rate.map_or(1.0, |rate| {
        let mean = |e: usize| next.points.row(e).iter().zip(rule).map(|(p, at)| at.weight * p.equivalent_rate).sum();
        rate.at((0..n).map(mean).fold(f64::MIN_POSITIVE, f64::max)).value
    });
    let punch = model.tool_index(Role::Punch).filter(|_| model.blank.edge == Edge::Free);
    for e in 0..n {
        let Some(strength) = &step.context.metal(e).strength else { return };
        let is_pressed = |j: usize, i: usize| evaluation.contacts[(j, i)].is_active(&step.context.penalty);
        if punch.is_some_and(|j| (STATIONS * e..STATIONS * (e + 1)).any(|i| is_pressed(j, i))) {
            next.nose_curvature[e] = next.nose_curvature[e].max(curvature(next, e));
        }
        let (mut stress, mut strain) = (0.0, 0.0);
        for (point, at) in next.points.row(e).iter().zip(rule) {
            stress += at.weight * model.cauchy(point.stress)[0];
            strain += at.weight * point.strain;
        }
        let (t, is_ironed) = (next.thickness[e], next.ironed[e][0] != 0.0 && is_between_walls(step, evaluation, e));
        let bears = strength.at(strain, next.temperature[e]) * rate_factor * bent_strength(next.nose_curvature[e], t);
        let index = if is_ironed { 0.0 } else { (stress / bears).max(0.0) };
        next.tearing_index[e] = [index, index.max(next.tearing_index[e][1])];
        if index > record.tearing_index {
            record.tearing_index = index;
            record.tearing_s0 = next.middle(e);
            record.tearing_forces = [stress * t, bears * t];
        }
    }
}

/// Share f of its strength that a sheet of thickness `t` \[mm\] bears at a curvature of its mid-surface \[1/mm\].
fn bent_strength(curvature: f64, t: f64) -> f64 {
    if curvature == 0.0 {
        return 1.0;
    }
    let ratio = (1.0 / (curvature * t) - 0.5).max(LEAST_RADIUS);
    ratio * ratio.recip().ln_1p()
}

/// Curvature of the mid-surface \[1/mm\]: the mean of both ends of an element, by the angles to its neighbours.
fn curvature(state: &State, e: usize) -> f64 {
    let last = state.thickness.len() - 1;
    let bend = |i: usize| {
        let (a, b) = (state.along(i - 1), state.along(i));
        a.perp(&b).atan2(a.dot(&b)) / (0.5 * (a.norm() + b.norm()))
    };
    // The section goes on beyond the axis as before it, and the edge is straight.
    (0.5 * (bend(e.clamp(1, last)) + if e == last { 0.0 } else { bend(e + 1) })).abs()
}

/// Trust: by hand, ρ ln(1 + 1/ρ) of inner radii of 1.5, 3 and 6 mm on a sheet of 1 mm.
#[cfg(test)]
#[test]
fn a_bent_sheet_bears_less() {
    for (inner, expected) in [(1.5, 0.76624), (3.0, 0.86305), (6.0, 0.92490)] {
        assert!((bent_strength(1.0 / (inner + 0.5), 1.0) - expected).abs() < 1e-5);
    }
}
