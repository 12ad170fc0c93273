//! How far a number can be trusted.

use crate::units::rounded;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// The error bar that belongs to a number. Serialises as `error_bar`, null with an `error_bar_reason` where there is none,
/// and as nothing where none was asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ErrorBar {
    /// None was asked for.
    #[default]
    Unasked,
    /// The truth lies within this of the number, in its unit.
    Half(f64),
    /// There is none, and why.
    Missing(String),
}

impl Serialize for ErrorBar {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_map(None)?;
        match self {
            Self::Unasked => {}
            Self::Half(half) => fields.serialize_entry("error_bar", &rounded(*half))?,
            Self::Missing(why) => {
                fields.serialize_entry("error_bar", &None::<f64>)?;
                fields.serialize_entry("error_bar_reason", why)?;
            }
        }
        fields.end()
    }
}
