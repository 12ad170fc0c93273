//! `FromStr`, `Display`, and by feature serde and schema of a quantity.

/// `FromStr`, `Display`, and by feature serde and schema of a quantity type.
macro_rules! implement {
    ([$($generic:tt)*] $type:ty) => {
        impl<$($generic)*> std::str::FromStr for $type {
            type Err = $crate::units::QuantityError;

            fn from_str(text: &str) -> Result<Self, Self::Err> {
                $crate::units::dimensioned::read(text)
            }
        }

        impl<$($generic)*> std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                let (value, unit) = ($crate::units::Dimensioned::value(*self), <Self as $crate::units::Dimensioned>::KIND.unit);
                match unit {
                    "" => write!(f, "{value}"),
                    "%" => write!(f, "{} %", $crate::units::rounded(100.0 * value)),
                    unit => write!(f, "{value} {unit}"),
                }
            }
        }

        impl<'de, $($generic)*> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                $crate::units::serde::deserialize(from)
            }
        }

        impl<$($generic)*> schemars::JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                <Self as $crate::units::Dimensioned>::KIND.name.into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $crate::units::schema::of::<Self>()
            }
        }
    };
}
pub(super) use implement;
