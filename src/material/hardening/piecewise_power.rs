//! Offset power law in branches, as Woo (1968) gives it.

use super::{FlowStress, LawError, power, require};
use crate::units::rounded;

/// One branch σ = σ₀ + K ε̄^n, valid up to a strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    /// The branch ends here; infinite for the last one.
    pub up_to: f64,
    /// σ₀ \[MPa\].
    pub initial: f64,
    /// K \[MPa\].
    pub k: f64,
    pub n: f64,
}

/// σ_y = σ₀ + K ε̄^n with other constants on each range of strain.
///
/// Branches must meet within [`PiecewisePower::LARGEST_JUMP`]; the gap that is left by rounded constants is closed by
/// shifting the later branch, so that σ_y is continuous.
///
/// # References
/// D. M. Woo, On the complete solution of the deep drawing problem, Int. J. Mech. Sci. 10 (1968) 83–94;
/// Sosnowski (1994) equations 14 and 15, where the second exponent is misprinted.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewisePower {
    branches: Vec<Branch>,
}

impl PiecewisePower {
    /// Largest accepted relative jump of the stress between two branches: rounded constants leave about 0.1 %.
    pub const LARGEST_JUMP: f64 = 0.005;

    /// Joins branches, in order of strain; the last must have no end.
    ///
    /// # Errors
    /// When a parameter is out of range, the ends do not rise, or two branches do not meet.
    pub fn new(mut branches: Vec<Branch>) -> Result<Self, LawError> {
        require("branches", !branches.is_empty(), || "needs at least one branch".into())?;
        let last = branches.len() - 1;
        let mut start = 0.0;
        for (i, b) in branches.iter().enumerate() {
            let key = format!("branches.{i}");
            require(&key, b.initial > 0.0 && b.k >= 0.0 && b.n > 0.0 && b.n <= 1.0, || {
                format!(
                    "branch {}: needs initial > 0, k >= 0 and 0 < n <= 1, found {} MPa, {} MPa, {}",
                    i + 1,
                    rounded(b.initial),
                    rounded(b.k),
                    b.n
                )
            })?;
            require(&format!("{key}.up_to"), b.up_to > start, || {
                format!("branch {}: its end {} must lie above {start}", i + 1, b.up_to)
            })?;
            require(&format!("{key}.up_to"), i < last || b.up_to.is_infinite(), || {
                "the last branch must have no end (no `up_to`)".into()
            })?;
            start = b.up_to;
        }
        for i in 0..last {
            let strain = branches[i].up_to;
            let stress = |b: &Branch| b.initial + b.k * strain.powf(b.n);
            let (before, after) = (stress(&branches[i]), stress(&branches[i + 1]));
            let jump = after / before - 1.0;
            require(&format!("branches.{}", i + 1), jump.abs() <= Self::LARGEST_JUMP, || {
                format!(
                    "branches {} and {} do not meet at a strain of {strain}: {before:.2} and {after:.2} MPa, a jump of {:+.1} %; \
                     check the exponents (more than {:.1} % is not rounding)",
                    i + 1,
                    i + 2,
                    100.0 * jump,
                    100.0 * Self::LARGEST_JUMP
                )
            })?;
            branches[i + 1].initial -= after - before;
        }
        Ok(Self { branches })
    }

    /// Woo's law in MPa (1 ton/in² = 15.4443 MPa).
    pub(super) fn woo() -> Self {
        const TON: f64 = 15.444_256;
        let branch = |up_to, k, n| Branch { up_to, initial: 5.4 * TON, k: k * TON, n };
        Self::new(vec![branch(0.36, 27.8, 0.504), branch(f64::INFINITY, 24.4, 0.375)]).expect("Woo's branches meet")
    }

    #[inline]
    pub(super) fn at(&self, strain: f64) -> FlowStress {
        let last = self.branches.len() - 1;
        let branch = self.branches[..last].iter().find(|b| strain < b.up_to).unwrap_or(&self.branches[last]);
        let (value, slope) = power(strain, branch.n);
        FlowStress { stress: branch.initial + branch.k * value, slope: branch.k * slope }
    }

    pub(super) fn describe(&self) -> String {
        let branches: Vec<String> = self
            .branches
            .iter()
            .map(|b| {
                let end = if b.up_to.is_finite() { format!(" (ε < {:.4})", b.up_to) } else { String::new() };
                format!("{:.2} + {:.2} ε^{:.4}{end}", b.initial, b.k, b.n)
            })
            .collect();
        format!("power law in branches, σ = {} MPa", branches.join("; "))
    }
}
