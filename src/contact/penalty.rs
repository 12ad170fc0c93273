//! Normal contact: a smoothed penalty.

use crate::numerics::ValueAndSlope;

/// p(g) = k δ ln(1 + exp(−g/δ − 3)): a ramp of slope −k beyond some δ of penetration, nothing some δ away, smooth between.
///
/// Smoothing halves the iterations of the bare ramp. The 3 puts the pressures of forming, k δ/20, at a gap of zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty {
    /// k \[N/mm³\].
    pub stiffness: f64,
    /// δ \[mm\].
    pub smoothing: f64,
}

impl Penalty {
    /// Shift of the law in δ: −ln(p/(k δ)) at touch.
    const TOUCH: f64 = 3.0;
    /// Gap in δ beyond which the pressure, below k δ exp(−30), is zero.
    const REACH: f64 = 30.0 - Self::TOUCH;
    /// Gap in δ at which tools wait before the first step, with p = k δ/150.
    pub const WAITING: f64 = 5.0 - Self::TOUCH;
    /// Gap in δ up to which a sheet, as pressed by gas, lies on a tool, with p = k δ/22 000.
    const LYING: f64 = 10.0 - Self::TOUCH;

    /// Gap up to which a sheet lies on a tool \[mm\].
    pub fn lying(&self) -> f64 {
        Self::LYING * self.smoothing
    }

    /// Gap beyond which the pressure is zero \[mm\].
    pub fn reach(&self) -> f64 {
        Self::REACH * self.smoothing
    }

    /// Pressure \[MPa\] and dp/dg \[N/mm³\] at the gap `gap` \[mm\]; zero out of reach.
    pub fn at(&self, gap: f64) -> ValueAndSlope {
        if gap > self.reach() {
            return ValueAndSlope::default();
        }
        let (k, delta) = (self.stiffness, self.smoothing);
        let depth = -gap / delta - Self::TOUCH;
        if depth > Self::REACH {
            return ValueAndSlope { value: k * delta * depth, slope: -k };
        }
        let e = depth.exp();
        ValueAndSlope { value: k * delta * e.ln_1p(), slope: -k * e / (1.0 + e) }
    }

    /// Pressure as [`Self::at`], with the slope of the chord to the gap where the law gives the pressure `carried` \[MPa\].
    ///
    /// Newton's method moves by one δ an iteration along the exponential foot of the law; the chord reaches `carried` at once.
    pub fn towards(&self, gap: f64, carried: f64) -> ValueAndSlope {
        let here = self.at(gap);
        let share = carried / (self.stiffness * self.smoothing);
        if share <= 1e-9 {
            return here;
        }
        let depth = if share > 30.0 { share } else { share.exp_m1().ln() };
        let apart = gap + (depth + Self::TOUCH) * self.smoothing;
        if apart.abs() <= 1e-3 * self.smoothing {
            return here;
        }
        ValueAndSlope { slope: (here.value - carried) / apart, ..here }
    }
}
