//! Powers of an exponent that stays.

/// x^a and its like for x ≥ 0: by products and square roots where the exponent allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    /// a.
    pub exponent: f64,
    /// The exponent where it is whole.
    whole: Option<i32>,
}

impl Power {
    /// Power with an exponent of 2 to 1000.
    pub fn new(exponent: f64) -> Self {
        Self { exponent, whole: (exponent.fract() == 0.0).then_some(exponent as i32) }
    }

    /// x^(a − 2).
    pub fn less_two(&self, x: f64) -> f64 {
        let square = x * x;
        match self.whole {
            Some(8) => square * square * square,
            Some(6) => square * square,
            Some(a) => x.powi(a - 2),
            None => x.powf(self.exponent - 2.0),
        }
    }

    /// y^(1/a).
    pub fn root(&self, y: f64) -> f64 {
        match self.whole {
            Some(8) => y.sqrt().sqrt().sqrt(),
            Some(2) => y.sqrt(),
            _ => y.powf(1.0 / self.exponent),
        }
    }

    /// y^(−2/a).
    pub fn inverse_square(&self, y: f64) -> f64 {
        match self.whole {
            Some(8) => 1.0 / y.sqrt().sqrt(),
            Some(2) => 1.0 / y,
            _ => y.powf(-2.0 / self.exponent),
        }
    }
}
