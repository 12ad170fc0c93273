//! Parameters of a law with their quantities and examples.

/// Makes a struct of numbers in the solver's units, read with their units: `k: Positive<Stress> = "520 MPa"`, where the text
/// is the schema's example; `exponent: Fraction = 0.9; default 1.0` may be left out. Attributes of serde and schemars hold
/// for the text of the case.
macro_rules! parameters {
    (
        $(#[doc $($doc:tt)*])+
        $(#[schemars $($attribute:tt)*])?
        $(#[derive $($derive:tt)*])?
        pub struct $law:ident {
            $(
                $(#[doc $($field_doc:tt)*])+
                $(#[serde $($key:tt)*])?
                $visible:vis $field:ident: $quantity:ty = $example:expr $(; default $default:expr)?,
            )+
        }
    ) => {
        $(#[doc $($doc)*])+
        $(#[derive $($derive)*])?
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $law {
            $($(#[doc $($field_doc)*])+ $visible $field: f64,)+
        }

        const _: () = {
            $(#[doc $($doc)*])+
            #[derive(serde::Deserialize, schemars::JsonSchema)]
            $(#[schemars $($attribute)*])?
            #[serde(deny_unknown_fields)]
            struct $law {
                $(
                    $(#[doc $($field_doc)*])+
                    $(#[serde $($key)*])?
                    $(#[schemars(extend("default" = $default))])?
                    #[schemars(example = $example)]
                    $field: $crate::material::law::parameters!(@type $quantity $(, $default)?),
                )+
            }

            impl<'de> serde::Deserialize<'de> for self::$law {
                fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                    let written = <$law as serde::Deserialize>::deserialize(from)?;
                    Ok(Self { $($field: $crate::material::law::parameters!(@value written.$field $(, $default)?)),+ })
                }
            }

            impl $crate::material::law::Example for self::$law {
                fn example() -> Self {
                    Self { $($field: $crate::material::law::read::<$quantity>($example)),+ }
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
    (@type $quantity:ty) => { $quantity };
    (@type $quantity:ty, $default:expr) => { Option<$quantity> };
    (@value $written:expr) => { $written.value() };
    (@value $written:expr, $default:expr) => { $written.map_or($default, |written| written.value()) };
}
pub(crate) use parameters;
