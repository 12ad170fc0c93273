use super::*;

/// A law times a factor: a stronger or weaker coil; with `beyond`, only its hardening beyond that strain.
#[derive(Clone, Debug, PartialEq)]
pub struct Scaled {
    factor: f64,
    beyond: Option<f64>,
    pub(super) law: Box<Hardening>,
}

impl Example for Scaled {
    fn example() -> Self {
        Self { factor: 1.08, beyond: None, law: Box::new(Hardening::Swift(Swift::example())) }
    }
}

impl HardeningLaw for Scaled {
    fn formula(&self) -> String {
        let of = self.beyond.map_or(String::new(), |beyond| format!(" the hardening beyond {} of", rounded(beyond)));
        format!("{} times{of} {}", rounded(self.factor), self.law)
    }

    fn at_temperature(&self, strain: f64, temperature: f64) -> FlowStress {
        let law = self.law.at_temperature(strain, temperature);
        match self.beyond {
            None => law.times(self.factor),
            Some(beyond) if strain <= beyond => law,
            Some(beyond) => {
                FlowStress { slope: 0.0, ..self.law.at_temperature(beyond, temperature) }.towards(law, self.factor)
            }
        }
    }
}

impl Hardening {
    /// The law with its stresses times a factor.
    pub fn scaled(self, factor: f64) -> Self {
        Self::Scaled(Scaled { factor, beyond: None, law: Box::new(self) })
    }

    /// The law with its hardening beyond a strain times a factor.
    pub fn weakened(self, factor: f64, beyond: f64) -> Self {
        Self::Scaled(Scaled { factor, beyond: Some(beyond), law: Box::new(self) })
    }
}
