//! Balances of work and heat.

/// Mean powers of a step, or the work since the start \[mW or mJ, or per mm of depth\].
///
/// external = plastic + elastic + friction + contact, where `contact` is what the penalty springs store.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Work of the driven tools and edges on the sheet.
    pub external: f64,
    /// Plastic work.
    pub plastic: f64,
    /// Stored elastic energy; 0 by the flow law.
    pub elastic: f64,
    /// Work of friction on tools and beads.
    pub friction: f64,
    /// Energy stored in the penalty springs of contact.
    pub contact: f64,
    /// The part of `plastic` in points whose strain rate is below ten times the cut-off.
    pub cutoff: f64,
}

impl Energy {
    /// Round-off over the largest entry \[–\].
    const ROUND_OFF: f64 = 1e-9;

    pub(in crate::solver) fn combined(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            external: of(self.external, other.external),
            plastic: of(self.plastic, other.plastic),
            elastic: of(self.elastic, other.elastic),
            friction: of(self.friction, other.friction),
            contact: of(self.contact, other.contact),
            cutoff: of(self.cutoff, other.cutoff),
        }
    }

    /// Multiplies every entry.
    pub fn scaled(self, factor: f64) -> Self {
        self.combined(self, |energy, _| energy * factor)
    }

    /// Sets entries below 1e-9 of the largest to 0.
    pub fn without_round_off(self) -> Self {
        let Self { external, plastic, elastic, friction, contact, .. } = self;
        let largest = [external, plastic, elastic, friction, contact].map(f64::abs).into_iter().fold(0.0, f64::max);
        self.combined(self, |energy, _| if energy.abs() < Self::ROUND_OFF * largest { 0.0 } else { energy })
    }

    /// Imbalance.
    pub fn missing(&self) -> f64 {
        self.external - self.plastic - self.elastic - self.friction - self.contact
    }

    /// Imbalance over the external work \[–\].
    pub fn imbalance(&self) -> f64 {
        if self.external == 0.0 { 0.0 } else { self.missing() / self.external.abs() }
    }
}

/// Heat since the start \[mJ, or per mm of depth\]: stored = plastic + tools.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heat {
    /// Heat of the plastic work.
    pub plastic: f64,
    /// Heat from the tools; negative when they cool the sheet.
    pub tools: f64,
    /// Heat stored in the sheet.
    pub stored: f64,
}
