//! Where the work of forming goes, and the heat.

/// Mean powers of a step, or the work done since the start \[mW or mJ, or per mm of depth\].
///
/// external = plastic + elastic + friction + contact, where `contact` is what the penalty springs store.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Of the driven tools and edges on the sheet.
    pub external: f64,
    /// Of the plastic flow in the sheet.
    pub plastic: f64,
    /// What the sheet's elasticity stores; 0 by the flow law.
    pub elastic: f64,
    /// Of the friction on tools and beads.
    pub friction: f64,
    /// What the penalty springs of the contact store.
    pub contact: f64,
    /// The part of `plastic` in points whose strain rate is below ten times the cut-off.
    pub cutoff: f64,
}

impl Energy {
    /// What of the largest entry is round-off \[–\].
    const ROUND_OFF: f64 = 1e-9;

    /// `of` of the entries of both, one by one.
    fn joined(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            external: of(self.external, other.external),
            plastic: of(self.plastic, other.plastic),
            elastic: of(self.elastic, other.elastic),
            friction: of(self.friction, other.friction),
            contact: of(self.contact, other.contact),
            cutoff: of(self.cutoff, other.cutoff),
        }
    }

    /// Every entry times `factor`: power from work, work from power.
    pub fn scaled(self, factor: f64) -> Self {
        self.joined(self, |energy, _| energy * factor)
    }

    /// The sum, entry by entry.
    pub fn plus(self, other: Self) -> Self {
        self.joined(other, |a, b| a + b)
    }

    /// As it is written: entries below 1e-9 of the largest are round-off, and 0.
    pub fn without_round_off(self) -> Self {
        let Self { external, plastic, elastic, friction, contact, .. } = self;
        let largest = [external, plastic, elastic, friction, contact].map(f64::abs).into_iter().fold(0.0, f64::max);
        self.joined(self, |energy, _| if energy.abs() < Self::ROUND_OFF * largest { 0.0 } else { energy })
    }

    /// What the balance misses.
    pub fn missing(&self) -> f64 {
        self.external - self.plastic - self.elastic - self.friction - self.contact
    }

    /// What the balance misses, over the external work \[–\].
    pub fn imbalance(&self) -> f64 {
        if self.external == 0.0 { 0.0 } else { self.missing() / self.external.abs() }
    }
}

/// Heat since the start \[mJ, or per mm of depth\]: stored = plastic + tools.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heat {
    /// What the plastic work has left in the sheet.
    pub plastic: f64,
    /// What the tools have given to it; negative when they cool it.
    pub tools: f64,
    /// What warms it.
    pub stored: f64,
}

impl Heat {
    /// Every entry times `factor`.
    pub fn scaled(self, factor: f64) -> Self {
        Self { plastic: factor * self.plastic, tools: factor * self.tools, stored: factor * self.stored }
    }

    /// The sum, entry by entry.
    pub fn plus(self, other: Self) -> Self {
        Self {
            plastic: self.plastic + other.plastic,
            tools: self.tools + other.tools,
            stored: self.stored + other.stored,
        }
    }
}
