//! Normal contact: a smoothed penalty.

use crate::numerics::{Real, elementary};

/// p(g) = k δ ln(1 + exp(−g/δ − 3)): a ramp of slope −k beyond some δ of penetration, nothing some δ away, smooth between.
///
/// The smooth law halves the iterations of the bare ramp, whose kink Newton's method keeps stepping over. The 3 puts the
/// pressures of forming, which are k δ/20 rather than k δ, at a gap of nothing: the sheet neither stands off nor sinks in by
/// more than δ or two, and δ may be as large as smooth load curves need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty {
    /// k \[N/mm³\].
    pub stiffness: f64,
    /// δ \[mm\].
    pub smoothing: f64,
}

/// A value and its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ValueAndSlope<T = f64> {
    /// f(x).
    pub value: T,
    /// df/dx.
    pub slope: T,
}

impl Penalty {
    /// Where tool and sheet just touch, −ln(p/(k δ)).
    const TOUCH: f64 = 3.0;

    /// Beyond this many δ the pressure, below k δ exp(−30), is nothing.
    const REACH: f64 = 30.0 - Self::TOUCH;

    /// Gap, in δ, at which tools wait before the first step: p is then k δ/150.
    pub const WAITING: f64 = 5.0 - Self::TOUCH;

    /// Gap, in δ, up to which a sheet lies on a tool: lightly pressed sheet, as gas presses it, stands off by some δ; p is
    /// then k δ/22 000, hundredths of a MPa.
    const LYING: f64 = 10.0 - Self::TOUCH;

    /// Gap up to which a sheet lies on a tool \[mm\].
    pub fn lying(&self) -> f64 {
        Self::LYING * self.smoothing
    }

    /// Gap beyond which the pressure is nothing \[mm\].
    #[inline]
    pub fn reach(&self) -> f64 {
        Self::REACH * self.smoothing
    }

    /// Pressure where tool and sheet just touch \[MPa\]: k δ/20.
    #[inline]
    pub fn at_touch(&self) -> f64 {
        self.stiffness * self.smoothing * (-Self::TOUCH).exp().ln_1p()
    }

    /// Pressure \[MPa\] and dp/dg \[N/mm³\] at the gap `gap` \[mm\]; nothing out of reach.
    #[inline(always)]
    pub fn at<T: Real>(&self, gap: T) -> ValueAndSlope<T> {
        let (zero, one, most) = (gap.constant(0.0), gap.constant(1.0), gap.constant(Self::REACH));
        let beyond = gap.exceeds(gap.constant(self.reach()));
        let u = zero - gap * (1.0 / self.smoothing) - Self::TOUCH;
        let deep = u.exceeds(most);
        let e = elementary::exp(most.where_or(deep, zero.where_or(beyond, u)));
        // Of small ones 1 + e has lost digits.
        let value = elementary::ln(e + 1.0).where_or(e.exceeds(gap.constant(SMALL)), e - e * e * 0.5);
        let (value, share) = (u.where_or(deep, value), one.where_or(deep, e / (e + 1.0)));
        let (value, slope) = (value * (self.stiffness * self.smoothing), share * -self.stiffness);
        ValueAndSlope { value: zero.where_or(beyond, value), slope: zero.where_or(beyond, slope) }
    }

    /// As [`Self::at`], with the slope replaced by the chord to the point where the law gives the pressure `carried` \[MPa\].
    ///
    /// Newton's method creeps along the exponential foot of the law, one δ an iteration. The chord to a pressure that
    /// is carried from iteration to iteration, as the primal-dual flow law carries its stress, goes there at once; the
    /// pressure itself, and so the answer, is the law's.
    #[inline(always)]
    pub fn towards<T: Real>(&self, gap: T, carried: T) -> ValueAndSlope<T> {
        let here = self.at(gap);
        let (share, most, small) =
            (carried * (1.0 / (self.stiffness * self.smoothing)), gap.constant(30.0), gap.constant(SMALL));
        let carries = share.exceeds(gap.constant(1e-9));
        if !gap.anywhere(carries) {
            return here;
        }
        let deep = share.exceeds(most);
        let power = elementary::exp(most.where_or(deep, share)) - 1.0;
        // The logarithm of nothing is asked for where nothing is carried, and not used.
        let least = share.where_or(carries, small);
        let there = elementary::ln(power.where_or(share.exceeds(small), least + least * least * 0.5));
        let apart = gap + (share.where_or(deep, there) + Self::TOUCH) * self.smoothing;
        let chord = (here.value - carried) / apart;
        let far = (apart * apart).exceeds(gap.constant((1e-3 * self.smoothing).powi(2)));
        ValueAndSlope { slope: chord.where_or(far, here.slope).where_or(carries, here.slope), ..here }
    }
}

/// Below it e − ½e² is ln(1 + e) to more digits than ln has of 1 + e \[–\].
const SMALL: f64 = 1e-6;
