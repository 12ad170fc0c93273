use super::*;

/// A law times a factor: a stronger or weaker coil.
#[derive(Clone, Debug, PartialEq)]
pub struct Scaled {
    factor: f64,
    pub(super) law: Box<Hardening>,
}

impl Example for Scaled {
    fn example() -> Self {
        Self { factor: 1.08, law: Box::new(Hardening::Swift(Swift::example())) }
    }
}

impl HardeningLaw for Scaled {
    fn formula(&self) -> String {
        format!("{} times {}", rounded(self.factor), self.law)
    }

    fn at_temperature(&self, strain: f64, temperature: f64) -> FlowStress {
        self.law.at_temperature(strain, temperature).times(self.factor)
    }
}

impl Hardening {
    /// The law with its stresses times a factor.
    pub fn scaled(self, factor: f64) -> Self {
        Self::Scaled(Scaled { factor, law: Box::new(self) })
    }
}
