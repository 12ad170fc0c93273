//! Numbers of known dimension and range: as text, in case files, and in their JSON schema.

use super::{QuantityError, dimension::Dimension, parse, thicknesses};
use schemars::JsonSchema;
use serde::Serializer;
use serde::de::{self, Deserialize, Deserializer, Visitor};
use std::{fmt, marker::PhantomData};

/// Number whose dimension and range have been checked.
pub trait Dimensioned: Copy {
    /// Name, unit and range.
    const KIND: &'static Kind;

    /// Bounds of the type for schemas: JSON-schema keywords with their values.
    const BOUNDS: &'static [(&'static str, f64)] = &[];

    /// Checks a number in solver units. Fails when not finite or out of range; `found` is quoted in the message.
    fn checked(value: f64, found: &str) -> Result<Self, QuantityError>;

    /// Number in the solver's unit ([`Kind::unit`]).
    fn value(self) -> f64;
}

/// Name, unit and range of a type of quantity.
#[derive(Debug, PartialEq)]
pub struct Kind {
    /// With its article, as in "a length".
    pub name: &'static str,
    /// The solver's unit; empty for a plain number.
    pub unit: &'static str,
    /// Largest magnitude that makes sense, in `unit`; beyond it a unit is wrong.
    pub largest: f64,
    /// Examples of texts.
    pub examples: &'static [&'static str],
}

impl Kind {
    /// Dimension of the unit.
    pub fn dimension(&self) -> Dimension {
        Dimension::of_unit(self.unit)
    }

    /// Name and unit: `length, mm`.
    pub(crate) fn measured(&self) -> String {
        format!("{}, {}", self.name.trim_start_matches("a ").trim_start_matches("an "), self.unit)
    }

    fn written(&self) -> String {
        let quoted = |text: &&str| if self.unit.is_empty() { (*text).into() } else { format!("{text:?}") };
        self.examples.iter().map(quoted).collect::<Vec<_>>().join(" or ")
    }

    fn missing_unit(&self, found: &str) -> QuantityError {
        let is_unusual = self.unit == "rad" || self.unit.contains('K') || self.unit.contains("s^2");
        let usual = self.examples[0].split_once(' ').filter(|_| is_unusual).map_or(self.unit, |(_, unit)| unit);
        let number = match found.parse::<f64>() {
            Ok(share) if self.unit == "%" && share < 1.0 => ((1e6 * share).round() / 1e4).to_string(),
            _ => found.to_owned(),
        };
        let help = format!("write \"{number} {usual}\"; {} may also be written {}", self.name, self.written());
        QuantityError::new(format!("{found} needs a unit"), help)
    }
}

fn read<Q: Dimensioned>(text: &str) -> Result<Q, QuantityError> {
    let (kind, found, parsed) = (Q::KIND, text.trim(), parse(text)?);
    // A bare 8 would be 800 %.
    if parsed.dimension == kind.dimension() && (kind.unit != "%" || parsed.has_unit) {
        return Q::checked(parsed.value, found);
    }
    if !parsed.has_unit {
        return Err(kind.missing_unit(found));
    }
    let is = thicknesses(found).map_or_else(|| parsed.dimension.describe(), |_| "a force or thicknesses of the sheet");
    let what = format!("{found:?} is {is}, wanted {}", kind.name);
    Err(QuantityError::new(what, format!("write for example {}", kind.written())))
}

/// `FromStr`, `Deserialize` and `JsonSchema` of a quantity type.
macro_rules! implement {
    ([$($generic:tt)*] $type:ty) => {
        impl<$($generic)*> std::str::FromStr for $type {
            type Err = QuantityError;

            fn from_str(text: &str) -> Result<Self, Self::Err> {
                read(text)
            }
        }

        impl<'de, $($generic)*> Deserialize<'de> for $type {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                from.deserialize_any(Written(PhantomData))
            }
        }

        impl<$($generic)*> JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                Self::KIND.name.into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let Kind { name, unit, examples, .. } = Self::KIND;
                let note = format!("{name} with its unit; solved in {unit}");
                let mut schema = match *unit {
                    "" => schemars::json_schema!({ "type": "number" }),
                    _ => schemars::json_schema!({
                        "type": "string", "description": note, "examples": examples, "x-quantity": Self::KIND.measured()
                    }),
                };
                Self::BOUNDS.iter().for_each(|(key, bound)| drop(schema.insert((*key).into(), (*bound).into())));
                schema
            }
        }
    };
}

macro_rules! quantities {
    ($($type:ident: $name:literal, $unit:literal, $largest:literal, $examples:expr;)*) => {
        pub(super) const KINDS: &[&Kind] = &[$($type::KIND),*];
        $(
        #[doc = concat!("Number in the solver's unit that is ", $name, ": `", $unit, "`.")]
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $type(f64);

        impl Dimensioned for $type {
            const KIND: &'static Kind = &Kind { name: $name, unit: $unit, largest: $largest, examples: &$examples };

            fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
                let Kind { name, unit, largest, .. } = Self::KIND;
                if value.is_finite() && value.abs() <= *largest {
                    return Ok(Self(value));
                }
                let help = format!("its magnitude must be at most {largest} {unit}: check the unit");
                Err(QuantityError::new(format!("{found} is out of range for {name}"), help))
            }

            fn value(self) -> f64 {
                self.0
            }
        }
        implement!([] $type);
        )*
    };
}

// A thermal conductivity in N/(s K) is one in W/(m K), a heat transfer in N/(mm s K) one in kW/(m² K).
quantities! {
    Length: "a length", "mm", 1e5, ["0.9 mm", "0.035 in"];
    Stress: "a stress", "MPa", 1e7, ["20 MPa", "5.4 tonf_uk/in^2"];
    Force: "a force", "N", 1e9, ["80 kN", "5000 N"];
    LineForce: "a force per length", "N/mm", 1e7, ["1300 N/mm", "1300 kN/m"];
    Angle: "an angle", "rad", 100.0, ["90 deg", "1.57 rad"];
    Time: "a time", "s", 1e9, ["2 s", "30 ms"];
    Speed: "a speed", "mm/s", 1e6, ["1 mm/s", "0.2 m/s"];
    StrainRate: "a strain rate", "/s", 1e9, ["0.001 /s", "40 /s"];
    Temperature: "a temperature", "K", 1e4, ["20 °C", "493 K"];
    PerKelvin: "a share per kelvin", "/K", 1.0, ["0.003 /K"];
    Density: "a density", "N s^2/mm^4", 1e-7, ["2700 kg/m^3", "7.85 g/cm^3"];
    SpecificHeat: "a specific heat", "mm^2/s^2/K", 1e11, ["900 J/kg/K", "0.46 kJ/kg/K"];
    Conductivity: "a thermal conductivity", "N/s/K", 1e4, ["130 W/m/K"];
    HeatTransfer: "a heat-transfer coefficient", "N/mm/s/K", 1e4, ["1.4 kW/m^2/K", "1400 W/m^2/K"];
    Energy: "an energy", "N mm", 1e12, ["150 kJ/mol"];
    StressRate: "a pressure per time", "MPa/s", 1e9, ["0.01 MPa/s", "0.5 MPa/min"];
    Ratio: "a percentage", "%", 1e3, ["5 %", "2.5 %"];
    Number: "a plain number", "", 1e12, ["0.1"];
}

macro_rules! bounded {
    ($($(#[$doc:meta])* $type:ident: $is_outside:expr, $must:literal, $help:literal, $bounds:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $type<Q>(Q);

        impl<Q: Dimensioned> Dimensioned for $type<Q> {
            const KIND: &'static Kind = Q::KIND;
            const BOUNDS: &'static [(&'static str, f64)] = &$bounds;

            fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
                let is_outside: fn(f64) -> bool = $is_outside;
                if is_outside(value) {
                    let help = format!($help, Q::KIND.written());
                    return Err(QuantityError::new(format!("must {}, found {found}", $must), help));
                }
                Q::checked(value, found).map(Self)
            }

            fn value(self) -> f64 {
                self.0.value()
            }
        }
        implement!([Q: Dimensioned] $type<Q>);
    )*};
}

bounded! {
    /// Quantity above zero.
    Positive: |value| value <= 0.0, "be positive", "write for example {}", [("exclusiveMinimum", 0.0)];
    /// Quantity of zero or above.
    NonNegative: |value| value < 0.0, "not be negative", "write for example {}", [("minimum", 0.0)];
    /// Quantity in 0..=1.
    UpToOne: |value| !(0.0..=1.0).contains(&value), "lie between 0 and 1", "it is a fraction, such as {}",
        [("minimum", 0.0), ("maximum", 1.0)];
}

/// Plain number in 0..=1.
pub type Fraction = UpToOne<Number>;

struct Written<Q>(PhantomData<Q>);

impl<Q: Dimensioned> Visitor<'_> for Written<Q> {
    type Value = Q;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let unit = if Q::KIND.unit.is_empty() { "" } else { " with its unit" };
        write!(f, "{}{unit}, such as {}", Q::KIND.name, Q::KIND.written())
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Q, E> {
        if Q::KIND.unit.is_empty() {
            return Err(E::invalid_type(de::Unexpected::Str(text), &self));
        }
        read(text).map_err(E::custom)
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Q, E> {
        self.visit_f64(value as f64)
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Q, E> {
        let found = format!("{value:?}");
        let found = found.strip_suffix(".0").unwrap_or(&found);
        let missing = || Err(E::custom(Q::KIND.missing_unit(found)));
        if Q::KIND.unit.is_empty() { Q::checked(value, found).map_err(E::custom) } else { missing() }
    }
}

/// Reads a number as a quantity: `#[serde(with = "As::<Positive<Stress>>")] k: f64`, or an `Option<f64>` with a default.
pub struct As<Q>(PhantomData<Q>);

impl<Q: Dimensioned> As<Q> {
    /// Reads the number. Fails when it is not such a quantity.
    pub fn deserialize<'de, N: From<f64>, D: Deserializer<'de>>(from: D) -> Result<N, D::Error> {
        from.deserialize_any(Written::<Q>(PhantomData)).map(|quantity| quantity.value().into())
    }

    /// Writes the number with its unit. Fails where the serializer does.
    pub fn serialize<N: Copy + Into<Option<f64>>, S: Serializer>(number: &N, to: S) -> Result<S::Ok, S::Error> {
        match ((*number).into(), Q::KIND.unit) {
            (None, _) => to.serialize_none(),
            (Some(number), "") => to.serialize_f64(number),
            (Some(number), unit) => to.collect_str(&format_args!("{number} {unit}")),
        }
    }
}

impl<Q: JsonSchema> JsonSchema for As<Q> {
    fn inline_schema() -> bool {
        Q::inline_schema()
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        Q::schema_name()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        Q::json_schema(generator)
    }
}
