//! Travel of a blade that bends a strip in air over a V, by the shape of the strip between blade and shoulder.
//!
//! The strip wraps the nose up to an angle φ and ends at the slope α of the wanted angle on the shoulder, whose force F
//! alone acts on this free leg (friction is left out): M = F ξ with the distance ξ along the end's tangent. With ψ the
//! slope that is missing to α, and the law M(κ) of fibres in plane strain, σ = min(E' ε, 2/√3 σ_y(2/√3 ε)),
//!
//! ```text
//! sin ψ(ξ) = ∫ κ dξ = ∫ κ dM/F = (κ M − ∫ M dκ)/F
//! ```
//!
//! A strip that is bent less than the nose touches it in one line, φ = 0. Derived here; the V-bend's test measures it.

use crate::material::{Elastic, Hardening};
use crate::numerics::bisect;

/// Stress and strain in plane strain over their equivalents, 2/√3 [–].
const PLANE: f64 = 1.154_700_538_379_251_5;
/// Steps from a straight strip to the largest curvature, closer where it is elastic.
const CURVATURES: u32 = 200;
/// Fibres from the middle to the face.
const FIBRES: u32 = 24;
/// Halvings of an interval: to a millionth of a degree.
const HALVINGS: usize = 40;

pub(super) struct Strip<'a> {
    /// \[mm\]
    pub thickness: f64,
    pub elastic: Elastic,
    pub hardening: &'a Hardening,
}

/// Moment per depth \[N\], and κ M less the work ∫ M dκ \[N/mm\].
type Bent = [f64; 2];

impl Strip<'_> {
    /// Moment at a curvature \[N mm per mm\].
    fn moment(&self, curvature: f64) -> f64 {
        let plane = self.elastic.young / (1.0 - self.elastic.poisson.powi(2));
        let step = 0.5 * self.thickness / f64::from(FIBRES);
        let fibres = (0..FIBRES).map(|i| {
            let y = (f64::from(i) + 0.5) * step;
            let strain = curvature * y;
            (plane * strain).min(PLANE * self.hardening.at(PLANE * strain).stress) * y
        });
        2.0 * step * fibres.sum::<f64>()
    }

    fn bent_to(&self, curvature: f64) -> Vec<Bent> {
        let (mut last, mut work) = ([0.0; 2], 0.0);
        let points = (0..=CURVATURES).map(|i| {
            let k = curvature * (f64::from(i) / f64::from(CURVATURES)).powi(2);
            let moment = self.moment(k);
            work += 0.5 * (moment + last[1]) * (k - last[0]);
            last = [k, moment];
            [moment, k * moment - work]
        });
        points.collect()
    }
}

/// Reach and rise \[mm\] of a free leg, from where it leaves the nose at the slope `from` to its end at the slope `to` \[rad\].
fn leg(bent: &[Bent], from: f64, to: f64) -> [f64; 2] {
    let [moment, turned] = bent[bent.len() - 1];
    let force = turned / (to - from).sin();
    let tangent = |sine: f64| sine / (1.0 - sine * sine).sqrt();
    let aside: f64 = bent
        .windows(2)
        .map(|w| 0.5 * (tangent(w[0][1] / force) + tangent(w[1][1] / force)) * (w[1][0] - w[0][0]) / force)
        .sum();
    let along = moment / force;
    [along * to.cos() + aside * to.sin(), along * to.sin() - aside * to.cos()]
}

/// Value in an interval where a condition ceases to hold.
fn end_of(low: f64, high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let [low, high] = bisect(low, high, HALVINGS, holds);
    0.5 * (low + high)
}

/// Travel at which each leg has turned by `turn` \[rad\] on shoulders whose centres are `reach` from the middle.
///
/// Radii are those of the tools \[mm\]; they fit: nose, shoulder and sheet together are no wider than the reach.
pub(super) fn travel(strip: &Strip, turn: f64, reach: f64, nose: f64, shoulder: f64) -> f64 {
    let [nose, shoulder] = [nose, shoulder].map(|radius| radius + 0.5 * strip.thickness);
    let wanted = reach - shoulder * turn.sin();
    let tight = strip.bent_to(1.0 / nose);
    let [across, rise] = if leg(&tight, 0.0, turn)[0] < wanted {
        let reaches = |curvature: f64| leg(&strip.bent_to(curvature), 0.0, turn)[0] > wanted;
        let curvature = end_of(0.0, 1.0 / nose, reaches);
        leg(&strip.bent_to(curvature), 0.0, turn)
    } else {
        let end = |wrap: f64| {
            let [across, rise] = leg(&tight, wrap, turn);
            [nose * wrap.sin() + across, nose * (1.0 - wrap.cos()) + rise]
        };
        end(end_of(0.0, turn, |wrap| end(wrap)[0] > wanted))
    };
    debug_assert!((across - wanted).abs() < 1e-3 * reach);
    rise + shoulder * (1.0 - turn.cos())
}
