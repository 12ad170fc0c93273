//! Enums that are told apart by the kind of TOML value: text, number, list or table.

/// Implements `Deserialize` for an enum with one variant per kind of value; errors inside a variant keep their place.
macro_rules! untagged {
    (
        $type:ident, $expecting:literal
        $(, switch($switch:ident) => $of_switch:expr)?
        $(, text($text:ident) => $of_text:expr)?
        $(, number($number:ident) => $of_number:expr)?
        $(, list => $of_list:expr)?
        $(, table => $of_table:expr)?
    ) => {
        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                struct Kinds;
                impl<'de> serde::de::Visitor<'de> for Kinds {
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
                from.deserialize_any(Kinds)
            }
        }
    };
}
pub(super) use untagged;
