//! Offset power law in branches, as Woo (1968) gives it: a gap that rounded constants leave is closed by shifting the later
//! branch. Sosnowski (1994), equations 14 and 15, misprints the second exponent.

use super::*;

/// σ = initial + k ε^n with other constants on each range of strain.
///
/// Valid where the branches were fitted; they must meet within 0.5 %.
/// Source: D. M. Woo, Int. J. Mech. Sci. 10 (1968) 83–94.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PiecewisePower {
    /// In order of strain.
    branches: Vec<Branch>,
}

parameters! {
    /// One branch; it must meet the next one.
    pub struct Branch {
        /// Strain where the branch ends; left out in the last one.
        #[serde(default = "endless")]
        pub up_to: "As::<Positive<Number>>" = 0.36,
        /// Yield stress σ₀ of the branch at ε = 0 \[MPa\].
        pub initial: "As::<Positive<Stress>>" = "5.4 tonf_uk/in^2",
        /// K \[MPa\].
        pub k: "As::<NonNegative<Stress>>" = "27.8 tonf_uk/in^2",
        /// Exponent, above 0 and up to 1.
        pub n: "As::<Fraction>" = 0.504,
    }
}

fn endless() -> f64 {
    f64::INFINITY
}

/// Largest relative jump of the stress between two branches \[–\]: rounded constants leave about 0.1 %.
const LARGEST_JUMP: f64 = 0.005;

impl PiecewisePower {
    /// Joins branches in order of strain, the last without end. Fails out of range, or where ends do not rise or meet.
    pub fn new(branches: Vec<Branch>) -> Result<Self, LawError> {
        let mut law = Self { branches };
        law.prepare(None).map(|()| law)
    }
}

impl Example for PiecewisePower {
    /// Woo's law (1 ton/in² = 15.4443 MPa).
    fn example() -> Self {
        let branch = |up_to, k, n| Branch { up_to, initial: 5.4 * 15.444_256, k: k * 15.444_256, n };
        Self::new(vec![branch(0.36, 27.8, 0.504), branch(f64::INFINITY, 24.4, 0.375)]).expect("Woo's branches meet")
    }
}

impl HardeningLaw for PiecewisePower {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        few("branches", self.branches.len(), 100)?;
        let branches = &mut self.branches;
        require("branches", !branches.is_empty(), || "needs at least one branch".into())?;
        let last = branches.len() - 1;
        let mut start = 0.0;
        for (i, b) in branches.iter().enumerate() {
            let key = format!("branches.{i}");
            require(&key, b.n > 0.0, || format!("branch {}: needs 0 < n <= 1, found {}", i + 1, b.n))?;
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
            let [before, after] = [i, i + 1].map(|i| branches[i].initial + branches[i].k * strain.powf(branches[i].n));
            let jump = after / before - 1.0;
            require(&format!("branches.{}", i + 1), jump.abs() <= LARGEST_JUMP, || {
                let (this, next, jump, most) = (i + 1, i + 2, 100.0 * jump, 100.0 * LARGEST_JUMP);
                format!(
                    "branches {this} and {next} do not meet at a strain of {strain}: {before:.2} and {after:.2} MPa, a jump \
                     of {jump:+.1} %; check the exponents (more than {most:.1} % is not rounding)"
                )
            })?;
            branches[i + 1].initial -= after - before;
        }
        Ok(())
    }

    fn formula(&self) -> String {
        let branches = self.branches.iter().map(|b| {
            let end = if b.up_to.is_finite() { format!(" (ε < {:.4})", b.up_to) } else { String::new() };
            format!("{:.2} + {:.2} ε^{:.4}{end}", b.initial, b.k, b.n)
        });
        format!("power law in branches, σ = {} MPa", branches.collect::<Vec<_>>().join("; "))
    }

    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        let last = self.branches.last().expect("checked where the law is made");
        let Branch { initial, k, n, .. } = *self.branches.iter().find(|branch| strain < branch.up_to).unwrap_or(last);
        let (value, slope) = power(strain, n);
        FlowStress { stress: initial + k * value, slope: k * slope }
    }
}
