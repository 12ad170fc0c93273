//! Enums that are told apart by the kind of TOML value: text, number, list or table.

/// Implements `Deserialize` for an enum with one variant per kind of value; errors inside a variant keep their place.
macro_rules! untagged {
    (
        [$($generic:ident: $bound:ident),*] $type:ty, $expecting:expr
        $(, switch($switch:ident) => $of_switch:expr)?
        $(, text($text:ident) => $of_text:expr)?
        $(, number($number:ident) => $of_number:expr)?
        $(, list => $of_list:expr)?
        $(, table => $of_table:expr)?
    ) => {
        impl<'de, $($generic: $bound + serde::Deserialize<'de>),*> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                struct Kinds<T>(std::marker::PhantomData<T>);
                impl<'de, $($generic: $bound + serde::Deserialize<'de>),*> serde::de::Visitor<'de> for Kinds<$type> {
                    type Value = $type;

                    fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                        f.write_str($expecting)
                    }
                    $(
                    fn visit_bool<E: serde::de::Error>(self, $switch: bool) -> Result<$type, E> {
                        $of_switch
                    }
                    )?
                    $(
                    fn visit_str<E: serde::de::Error>(self, $text: &str) -> Result<$type, E> {
                        $of_text
                    }
                    )?
                    $(
                    fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<$type, E> {
                        self.visit_f64(number as f64)
                    }

                    fn visit_f64<E: serde::de::Error>(self, $number: f64) -> Result<$type, E> {
                        $of_number
                    }
                    )?
                    $(
                    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, list: A) -> Result<$type, A::Error> {
                        serde::Deserialize::deserialize(serde::de::value::SeqAccessDeserializer::new(list)).map($of_list)
                    }
                    )?
                    $(
                    fn visit_map<A: serde::de::MapAccess<'de>>(self, table: A) -> Result<$type, A::Error> {
                        serde::Deserialize::deserialize(serde::de::value::MapAccessDeserializer::new(table)).map($of_table)
                    }
                    )?
                }
                from.deserialize_any(Kinds::<$type>(std::marker::PhantomData))
            }
        }
    };
}
pub(super) use untagged;

/// Implements an inlined `JsonSchema` by one expression.
macro_rules! inline_schema {
    ([$($generic:ident: $bound:ident),*] $type:ty, $name:expr, |$generator:ident| $schema:expr) => {
        impl<$($generic: $bound),*> schemars::JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                $name.into()
            }

            fn json_schema($generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $schema
            }
        }
    };
}
pub(super) use inline_schema;
