//! Hardening laws: the yield stress σ_y(ε̄) of uniaxial tension over the equivalent plastic strain ε̄ ≥ 0.
//!
//! One law, one file. A new law is a file here and a line in [`Hardening`]; the compiler then names every other
//! place, and the property tests below run over [`Hardening::examples`].

mod hollomon;
mod isotherms;
mod ludwik;
mod piecewise_power;
mod swift;
mod table;
mod voce;

pub use hollomon::Hollomon;
pub use isotherms::Isotherms;
pub use ludwik::Ludwik;
pub use piecewise_power::{Branch, PiecewisePower};
pub use swift::Swift;
pub use table::{Extrapolation, Table};
pub use voce::Voce;

/// Why a set of parameters is not a hardening law.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct LawError {
    pub message: String,
    /// The key that is wrong, as a path inside the law's table, entries by index from 0; empty for the whole law.
    pub key: String,
}

/// Yield stress and its slope at one strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowStress {
    /// σ_y \[MPa\].
    pub stress: f64,
    /// dσ_y/dε̄ \[MPa\].
    pub slope: f64,
}

/// A hardening law, parameters in MPa.
#[derive(Clone, Debug, PartialEq)]
pub enum Hardening {
    PiecewisePower(PiecewisePower),
    Hollomon(Hollomon),
    Swift(Swift),
    Ludwik(Ludwik),
    Voce(Voce),
    Table(Table),
    Isotherms(Isotherms),
}

impl Hardening {
    /// σ_y and dσ_y/dε̄ at the equivalent plastic strain `strain` ≥ 0 \[–\] and a temperature \[K\].
    #[inline]
    pub fn at_temperature(&self, strain: f64, temperature: f64) -> FlowStress {
        if let Self::Isotherms(law) = self { law.at_temperature(strain, temperature) } else { self.at(strain) }
    }

    /// σ_y and dσ_y/dε̄ at the equivalent plastic strain `strain` ≥ 0 \[–\]; of the coldest curve where there are several.
    #[inline]
    pub fn at(&self, strain: f64) -> FlowStress {
        match self {
            Self::PiecewisePower(law) => law.at(strain),
            Self::Hollomon(law) => law.at(strain),
            Self::Swift(law) => law.at(strain),
            Self::Ludwik(law) => law.at(strain),
            Self::Voce(law) => law.at(strain),
            Self::Table(law) => law.at(strain),
            Self::Isotherms(law) => law.at(strain),
        }
    }

    /// The formula with its numbers, in MPa, for summaries and plots.
    pub fn describe(&self) -> String {
        match self {
            Self::PiecewisePower(law) => law.describe(),
            Self::Hollomon(law) => law.describe(),
            Self::Swift(law) => law.describe(),
            Self::Ludwik(law) => law.describe(),
            Self::Voce(law) => law.describe(),
            Self::Table(law) => law.describe(),
            Self::Isotherms(law) => law.describe(),
        }
    }

    /// Largest strain the law was given for, where it says so (tables).
    pub fn valid_up_to(&self) -> Option<f64> {
        match self {
            Self::Table(law) => Some(law.last_strain()),
            Self::Isotherms(law) => Some(law.last_strain()),
            _ => None,
        }
    }

    /// The coldest and the hottest temperature the law was given for, where it depends on it \[K\].
    pub fn temperatures(&self) -> Option<[f64; 2]> {
        match self {
            Self::Isotherms(law) => Some(law.range()),
            _ => None,
        }
    }

    /// One example of every law, for tests and benchmarks that must hold for the whole list.
    pub fn examples() -> Vec<(&'static str, Hardening)> {
        vec![
            ("piecewise_power", Self::PiecewisePower(PiecewisePower::woo())),
            ("hollomon", Self::Hollomon(Hollomon::from_elastic_line(547.0, 0.18, 210_000.0).expect("valid"))),
            ("swift", Self::Swift(Swift::new(589.0, 0.216, 1e-4).expect("valid"))),
            ("ludwik", Self::Ludwik(Ludwik::new(150.0, 400.0, 0.5).expect("valid"))),
            ("voce", Self::Voce(Voce::new(180.0, 400.0, 9.0, 1.0).expect("valid"))),
            ("voce with exponent", Self::Voce(Voce::new(125.0, 320.0, 7.5, 0.97).expect("valid"))),
            ("table", Self::Table(Table::example(1.0))),
            (
                "isotherms",
                Self::Isotherms(
                    Isotherms::new(vec![293.15, 503.15], vec![Table::example(1.0), Table::example(0.6)])
                        .expect("valid"),
                ),
            ),
        ]
    }
}

/// Strain below which ε^n is replaced by its chord from the origin.
///
/// With n < 1 the power has an infinite slope at ε = 0, which no iteration matrix can carry. The stress changes by
/// less than K (1e-6)^n on the first 1e-6 of strain and not at all beyond.
const CHORD_UP_TO: f64 = 1e-6;

/// ε^n and its derivative, finite at ε = 0 (see [`CHORD_UP_TO`]).
#[inline]
fn power(strain: f64, n: f64) -> (f64, f64) {
    if strain > CHORD_UP_TO {
        let value = strain.powf(n);
        (value, n * value / strain)
    } else {
        let slope = CHORD_UP_TO.powf(n - 1.0);
        (slope * strain, slope)
    }
}

fn require(key: &str, ok: bool, message: impl FnOnce() -> String) -> Result<(), LawError> {
    if ok { Ok(()) } else { Err(LawError { message: message(), key: key.to_owned() }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: central differences, h = 1e-4 ε: truncation near 1e-8 of the slope, cancellation below 1e-6.
    #[test]
    fn slope_is_the_derivative_of_the_stress_for_every_law() {
        for (name, law) in Hardening::examples() {
            for strain in [1e-7, 3e-5, 1e-3, 0.013, 0.09, 0.21, 0.37, 0.75, 1.4] {
                let h = 1e-4 * strain;
                let difference = (law.at(strain + h).stress - law.at(strain - h).stress) / (2.0 * h);
                assert_relative_eq!(law.at(strain).slope, difference, max_relative = 1e-5, epsilon = 1e-4);
                assert!(law.at(strain).stress.is_finite(), "{name}");
            }
        }
    }

    /// Trust: by hand, the mean of the two curves half-way between them, the outer ones beyond.
    #[test]
    fn isotherms_are_interpolated_and_held() {
        let [cold, hot] = [1.0, 0.6].map(|factor| Table::example(factor).at(0.07));
        let law = Isotherms::new(vec![300.0, 400.0], [1.0, 0.6].map(Table::example).to_vec()).expect("valid");
        let law = Hardening::Isotherms(law);
        assert_relative_eq!(
            law.at_temperature(0.07, 350.0).stress,
            0.5 * (cold.stress + hot.stress),
            max_relative = 1e-14
        );
        assert_relative_eq!(
            law.at_temperature(0.07, 350.0).slope,
            0.5 * (cold.slope + hot.slope),
            max_relative = 1e-14
        );
        assert_eq!(law.at_temperature(0.07, 200.0), cold);
        assert_eq!(law.at_temperature(0.07, 300.0), cold);
        assert_eq!(law.at_temperature(0.07, 500.0), hot);
        assert_eq!(law.temperatures(), Some([300.0, 400.0]));
        assert!(Isotherms::new(vec![300.0, 300.0], [1.0, 0.6].map(Table::example).to_vec()).is_err());
    }

    #[test]
    fn every_law_is_positive_continuous_and_never_softens() {
        for (name, law) in Hardening::examples() {
            let mut last = law.at(0.0).stress;
            assert!(last >= 0.0, "{name}");
            for i in 1..40_000 {
                let now = law.at(i as f64 * 5e-5);
                assert!(now.stress >= last - 1e-9 && now.slope >= -1e-9, "{name} softens at {}", i as f64 * 5e-5);
                assert!(i < 20 || now.stress - last < 0.05 * now.stress, "{name} jumps at {}", i as f64 * 5e-5);
                last = now.stress;
            }
        }
    }
}
