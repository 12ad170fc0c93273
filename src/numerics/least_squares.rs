//! Least squares with bounds: Levenberg and Marquardt's method, with differences of points that may be computed in parallel.
//!
//! ```text
//! S(x) = Σ rᵢ(x)²                            J = ∂r/∂x by central differences, one-sided at a bound
//! (D⁻¹JᵀJD⁻¹ + λ I) D d = −D⁻¹ Jᵀ r          D = diag ‖Jⱼ‖; steps beyond a bound end there
//! C = s² (JᵀJ)⁻¹,  s² = S/(n − p)            covariance of what is free
//! ```
//!
//! Source: D. W. Marquardt, J. Soc. Indust. Appl. Math. 11 (1963) 431–441 (not read; in common use).

use nalgebra::{DMatrix, DVector};

/// A fitted parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Start value.
    pub start: f64,
    /// Least value; where it is the largest too, the parameter stays.
    pub low: f64,
    /// Largest value.
    pub high: f64,
    /// Half of a central difference.
    pub step: f64,
}

/// Residuals at some points, as many at each; `None` where there are none. Empty where no more are wanted.
pub type Residuals<'a> = dyn FnMut(&[Vec<f64>]) -> Vec<Option<Vec<f64>>> + 'a;

/// Reason of the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// At a minimum.
    Found,
    /// After as many steps as were allowed.
    Steps,
    /// There are no residuals on either side of this parameter, counted from 0.
    Blind(usize),
    /// Nobody wanted more.
    Stopped,
}

/// The best point that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Minimum {
    /// Its parameters.
    pub values: Vec<f64>,
    /// Its residuals.
    pub residuals: Vec<f64>,
    /// Their derivatives: a row a residual, a column a parameter; of the step before if stopped.
    pub jacobian: DMatrix<f64>,
    /// Whether each parameter is free: neither given nor pushed against a bound.
    pub free: Vec<bool>,
    /// Why it ended.
    pub ended: Ended,
}

/// First damping, and the one beyond which no step is left to try.
const FIRST: f64 = 1e-3;
const LAST: f64 = 1e8;
/// Dampings that are tried at once.
const LADDER: [f64; 2] = [1.0, 30.0];

/// Goes downhill by at most `steps` Jacobians, until all change by less than `change` \[–\]; `None` without residuals.
pub fn minimise(parameters: &[Parameter], residuals: &mut Residuals, steps: usize, change: f64) -> Option<Minimum> {
    let start: Vec<f64> = parameters.iter().map(|p| p.start.clamp(p.low, p.high)).collect();
    let first = residuals(std::slice::from_ref(&start)).pop().flatten()?;
    let jacobian = DMatrix::zeros(first.len(), start.len());
    let free = vec![false; start.len()];
    let mut best = Minimum { values: start, residuals: first, jacobian, free, ended: Ended::Steps };
    let mut damping = FIRST;
    for _ in 0..steps {
        if let Err(ended) = best.linearise(parameters, residuals) {
            return Some(Minimum { ended, ..best });
        }
        if best.sum() == 0.0 || !best.free.contains(&true) {
            return Some(Minimum { ended: Ended::Found, ..best });
        }
        let moved = loop {
            let trials = LADDER.map(|times| best.stepped(parameters, times * damping));
            let found = residuals(&trials);
            if found.is_empty() {
                return Some(Minimum { ended: Ended::Stopped, ..best });
            }
            let found = found.into_iter().zip(trials).zip(LADDER);
            let lower = found.filter_map(|((r, x), times)| r.map(|r| (square(&r), r, x, times)));
            let lower = lower.filter(|(sum, ..)| *sum < best.sum()).min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((_, r, x, times)) = lower {
                damping = (damping * times / 10.0).max(1e-12);
                let size = |p: &Parameter, x: f64| x.abs().max(1e-3 * (p.high - p.low).min(1.0)).max(f64::MIN_POSITIVE);
                let moves = best.values.iter().zip(&x).zip(parameters).map(|((a, b), p)| (a - b).abs() / size(p, *b));
                let moved = moves.fold(0.0, f64::max);
                (best.residuals, best.values) = (r, x);
                break moved;
            }
            damping *= LADDER[1] * LADDER[1];
            if damping > LAST {
                break 0.0;
            }
        };
        if moved <= change {
            // The matrix of the step before serves where this one is refused.
            let _ = best.linearise(parameters, residuals);
            return Some(Minimum { ended: Ended::Found, ..best });
        }
    }
    Some(best)
}

impl Minimum {
    /// S.
    pub fn sum(&self) -> f64 {
        square(&self.residuals)
    }

    /// s², with a denominator n − p of at least 1.
    pub fn variance(&self) -> f64 {
        self.sum() / (self.residuals.len() as f64 - self.free.iter().filter(|free| **free).count() as f64).max(1.0)
    }

    /// C for residuals of that variance; zero of what is not free, `None` where the residuals cannot tell parameters apart.
    pub fn covariance(&self, variance: f64) -> Option<DMatrix<f64>> {
        let (weights, normal) = self.normal(0.0);
        let all = &weights * normal.try_inverse()? * &weights * variance;
        all.diagonal().iter().all(|c| *c >= 0.0 && c.is_finite()).then_some(all)
    }

    /// Jacobian by central differences, one-sided at a bound and where one side has no residuals, and the free parameters.
    fn linearise(&mut self, parameters: &[Parameter], residuals: &mut Residuals) -> Result<(), Ended> {
        let moving: Vec<usize> = (0..parameters.len()).filter(|&j| parameters[j].low < parameters[j].high).collect();
        let at = |j: usize, side: f64| {
            let mut point = self.values.clone();
            point[j] = (point[j] + side * parameters[j].step).clamp(parameters[j].low, parameters[j].high);
            point
        };
        let points: Vec<Vec<f64>> = moving.iter().flat_map(|&j| [at(j, -1.0), at(j, 1.0)]).collect();
        let found = residuals(&points);
        if found.len() < points.len() {
            return Err(Ended::Stopped);
        }
        let mut jacobian = DMatrix::zeros(self.residuals.len(), parameters.len());
        for (&j, (points, found)) in moving.iter().zip(points.chunks(2).zip(found.chunks(2))) {
            let side = |k: usize| found[k].as_ref().map_or((self.values[j], &self.residuals), |r| (points[k][j], r));
            let ((a, low), (b, high)) = (side(0), side(1));
            if a == b {
                return Err(Ended::Blind(j));
            }
            let difference = low.iter().zip(high).map(|(low, high)| (high - low) / (b - a));
            jacobian.set_column(j, &DVector::from_iterator(self.residuals.len(), difference));
        }
        self.jacobian = jacobian;
        let gradient = self.gradient();
        let is_free = |(j, p): (usize, &Parameter)| {
            let (x, slope) = (self.values[j], gradient[j]);
            p.low < p.high && !(x <= p.low && slope > 0.0 || x >= p.high && slope < 0.0)
        };
        self.free = parameters.iter().enumerate().map(is_free).collect();
        Ok(())
    }

    fn gradient(&self) -> DVector<f64> {
        self.jacobian.tr_mul(&DVector::from_column_slice(&self.residuals))
    }

    /// D⁻¹, zero of what is not free, and D⁻¹JᵀJD⁻¹ + λ I.
    fn normal(&self, damping: f64) -> (DMatrix<f64>, DMatrix<f64>) {
        let columns = self.jacobian.column_iter().zip(&self.free);
        let weights = columns.map(|(j, free)| if *free { 1.0 / j.norm().max(f64::MIN_POSITIVE) } else { 0.0 });
        let weights = DMatrix::from_diagonal(&DVector::from_iterator(self.free.len(), weights));
        let scaled = &self.jacobian * &weights;
        let shift = self.free.iter().map(|free| if *free { damping } else { 1.0 });
        (weights, scaled.tr_mul(&scaled) + DMatrix::from_diagonal(&DVector::from_iterator(self.free.len(), shift)))
    }

    fn stepped(&self, parameters: &[Parameter], damping: f64) -> Vec<f64> {
        let (weights, normal) = self.normal(damping);
        let step = normal.cholesky().map(|factors| -&weights * factors.solve(&(&weights * self.gradient())));
        let to = |j: usize| step.as_ref().map_or(0.0, |step| step[j]);
        let moved = |(j, p): (usize, &Parameter)| (self.values[j] + to(j)).clamp(p.low, p.high);
        parameters.iter().enumerate().map(moved).collect()
    }
}

fn square(residuals: &[f64]) -> f64 {
    let sum: f64 = residuals.iter().map(|r| r * r).sum();
    if sum.is_finite() { sum } else { f64::INFINITY }
}
