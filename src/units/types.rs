//! The quantities of a case, each a type of its own.

use super::dimensioned::{Dimensioned, implement};
use super::error::QuantityError;
use super::kind::Kind;
use super::unit::{ANGLE, FORCE, LENGTH, MASS, NONE, POWER, STRESS, TEMPERATURE, TIME};

macro_rules! quantities {
    ($($(#[$doc:meta])* $type:ident = $kind:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $type(f64);

        impl Dimensioned for $type {
            const KIND: &'static Kind = &$kind;

            fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
                let kind = Self::KIND;
                if value.is_finite() && value.abs() <= kind.largest {
                    Ok(Self(value))
                } else {
                    Err(QuantityError::too_large(found, kind))
                }
            }

            fn value(self) -> f64 {
                self.0
            }
        }
        implement!([] $type);
    )*};
}

quantities! {
    /// Signed length \[mm\].
    Length = Kind { name: "a length", dimension: LENGTH, unit: "mm", examples: &["0.9 mm", "0.035 in"], largest: 1e5 };
    /// Stress \[MPa\].
    Stress = Kind {
        name: "a stress", dimension: STRESS, unit: "MPa", examples: &["210 GPa", "5.4 tonf_uk/in^2"], largest: 1e7,
    };
    /// Force \[N\].
    Force = Kind { name: "a force", dimension: FORCE, unit: "N", examples: &["80 kN", "5000 N"], largest: 1e9 };
    /// Force per length of depth \[N/mm\].
    LineForce = Kind {
        name: "a force per length", dimension: FORCE.over(LENGTH), unit: "N/mm",
        examples: &["1300 N/mm", "1300 kN/m"], largest: 1e7,
    };
    /// Angle \[rad\].
    Angle = Kind { name: "an angle", dimension: ANGLE, unit: "rad", examples: &["90 deg", "1.57 rad"], largest: 100.0 };
    /// Time \[s\].
    Time = Kind { name: "a time", dimension: TIME, unit: "s", examples: &["2 s", "30 ms"], largest: 1e9 };
    /// Speed \[mm/s\].
    Speed = Kind {
        name: "a speed", dimension: LENGTH.over(TIME), unit: "mm/s", examples: &["1 mm/s", "0.2 m/s"], largest: 1e6,
    };
    /// Strain rate \[1/s\].
    StrainRate = Kind {
        name: "a strain rate", dimension: NONE.over(TIME), unit: "/s", examples: &["0.001 /s", "40 /s"], largest: 1e9,
    };
    /// Temperature above absolute zero \[K\]; it may be written in °C.
    Temperature = Kind {
        name: "a temperature", dimension: TEMPERATURE, unit: "K", examples: &["20 °C", "493 K"], largest: 1e4,
    };
    /// Share per kelvin \[1/K\].
    PerKelvin = Kind {
        name: "a share per kelvin", dimension: NONE.over(TEMPERATURE), unit: "/K", examples: &["0.003 /K"], largest: 1.0,
    };
    /// Density \[t/mm³\].
    Density = Kind {
        name: "a density", dimension: MASS.over(LENGTH).over(LENGTH).over(LENGTH), unit: "N s^2/mm^4",
        examples: &["2700 kg/m^3", "7.85 g/cm^3"], largest: 1e-7,
    };
    /// Specific heat \[mJ/(t K)\].
    SpecificHeat = Kind {
        name: "a specific heat", dimension: POWER.times(TIME, 1).over(MASS).over(TEMPERATURE), unit: "mm^2/s^2/K",
        examples: &["900 J/kg/K", "0.46 kJ/kg/K"], largest: 1e11,
    };
    /// Thermal conductivity \[N/(s K)\], which is W/(m K).
    Conductivity = Kind {
        name: "a thermal conductivity", dimension: POWER.over(LENGTH).over(TEMPERATURE), unit: "N/s/K",
        examples: &["130 W/m/K"], largest: 1e4,
    };
    /// Heat-transfer coefficient \[N/(mm s K)\], which is kW/(m² K).
    HeatTransfer = Kind {
        name: "a heat-transfer coefficient", dimension: POWER.over(LENGTH).over(LENGTH).over(TEMPERATURE),
        unit: "N/mm/s/K", examples: &["1.4 kW/m^2/K", "1400 W/m^2/K"], largest: 1e4,
    };
    /// Energy, or energy per mole \[N mm\].
    Energy = Kind {
        name: "an energy", dimension: POWER.times(TIME, 1), unit: "N mm", examples: &["150 kJ/mol"], largest: 1e12,
    };
    /// Rise of a pressure with time \[MPa/s\].
    StressRate = Kind {
        name: "a pressure per time", dimension: STRESS.over(TIME), unit: "MPa/s", examples: &["0.01 MPa/s", "0.5 MPa/min"],
        largest: 1e9,
    };
    /// Relative number, written in percent \[–\].
    Ratio = Kind { name: "a percentage", dimension: NONE, unit: "%", examples: &["5 %", "2.5 %"], largest: 1e3 };
    /// Plain number \[–\], written without quotes.
    Number = Kind { name: "a plain number", dimension: NONE, unit: "", examples: &["0.1"], largest: 1e12 };
}

macro_rules! bounds {
    ($($(#[$doc:meta])* $type:ident: $ok:expr, $error:literal, $keyword:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $type<Q>(Q);

        impl<Q: Dimensioned> Dimensioned for $type<Q> {
            const KIND: &'static Kind = Q::KIND;
            const BOUND: &'static [(&'static str, f64)] = &[($keyword, 0.0)];

            fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
                let inner = Q::checked(value, found)?;
                let ok: fn(f64) -> bool = $ok;
                if ok(value) {
                    Ok(Self(inner))
                } else {
                    Err(QuantityError::wrong_sign($error, found, Q::KIND))
                }
            }

            fn value(self) -> f64 {
                self.0.value()
            }
        }
        implement!([Q: Dimensioned] $type<Q>);
    )*};
}

bounds! {
    /// Quantity above zero.
    Positive: |value| value > 0.0, "be positive", "exclusiveMinimum";
    /// Quantity of zero or above.
    NonNegative: |value| value >= 0.0, "not be negative", "minimum";
}

/// Plain number in 0..=1.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Fraction(f64);

impl Dimensioned for Fraction {
    const KIND: &'static Kind = Number::KIND;
    const BOUND: &'static [(&'static str, f64)] = &[("minimum", 0.0), ("maximum", 1.0)];

    fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
        if (0.0..=1.0).contains(&value) {
            Ok(Self(value))
        } else {
            Err(QuantityError::new(format!("must lie between 0 and 1, found {found}"), "it is a fraction, such as 0.1"))
        }
    }

    fn value(self) -> f64 {
        self.0
    }
}
implement!([] Fraction);
