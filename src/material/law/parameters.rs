//! Parameters of a law with their quantities and examples.

/// Makes a struct of numbers in the solver's units, read with their units: `k: Positive<Stress> = "520 MPa"`, where the text
/// is the schema's example.
macro_rules! parameters {
    (
        $(#[doc $($doc:tt)*])+
        pub struct $law:ident {
            $($(#[doc $($field_doc:tt)*])+ $visible:vis $field:ident: $quantity:ty = $example:expr,)+
        }
    ) => {
        $(#[doc $($doc)*])+
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $law {
            $($(#[doc $($field_doc)*])+ $visible $field: f64,)+
        }

        const _: () = {
            $(#[doc $($doc)*])+
            #[derive(serde::Deserialize, schemars::JsonSchema)]
            #[serde(deny_unknown_fields)]
            struct $law {
                $($(#[doc $($field_doc)*])+ #[schemars(example = $example)] $field: $quantity,)+
            }

            impl<'de> serde::Deserialize<'de> for self::$law {
                fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                    let written = <$law as serde::Deserialize>::deserialize(from)?;
                    Ok(Self { $($field: written.$field.value()),+ })
                }
            }

            impl schemars::JsonSchema for self::$law {
                fn schema_name() -> std::borrow::Cow<'static, str> {
                    <$law as schemars::JsonSchema>::schema_name()
                }

                fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                    <$law as schemars::JsonSchema>::json_schema(generator)
                }
            }
        };
    };
}
pub(crate) use parameters;
