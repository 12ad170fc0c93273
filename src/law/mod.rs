//! What all laws share, of whatever family: hardening, rate, thermal softening, friction.
//!
//! A law is one file: a struct of its parameters, whose documentation says equation, range of validity and source. The
//! struct is its own text form: plain numbers in the solver's units, read with units by [`As`](crate::units::As). From it
//! come the JSON schema and the `laws` verb. The law joins its [`family!`](family) by two lines: `mod swift;` and
//! `swift: Swift`. Whatever must hold for all of them is tested over the family's `examples()`.

#[cfg(feature = "case")]
mod named;

#[cfg(feature = "case")]
pub use named::{Named, OfNumber, Readable};

/// Why a set of parameters is not a law.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct LawError {
    /// What is wrong.
    pub message: String,
    /// The key that is wrong, as a path inside the law's table, entries by index from 0; empty for the whole law.
    pub key: String,
    /// What to do about it.
    pub help: &'static str,
}

/// What a law's file uses.
pub(crate) mod prelude {
    pub use super::{Law, LawError};
    pub(crate) use super::{require, require_or};
    #[cfg(feature = "case")]
    pub use crate::units::{As, Energy, Fraction, Length, PerKelvin, Speed, StrainRate, Temperature};
    pub use crate::units::{NonNegative, Number, Positive, Quantity, Stress, ZERO_CELSIUS, rounded};

    /// The default of a factor or an exponent.
    #[cfg(feature = "case")]
    pub fn one() -> f64 {
        1.0
    }
}

/// An error at `key` unless `ok`.
pub(crate) fn require(key: &str, ok: bool, message: impl FnOnce() -> String) -> Result<(), LawError> {
    require_or(key, ok, "check the constants and their units", message)
}

/// The same with what to do about it.
pub(crate) fn require_or(
    key: &str,
    ok: bool,
    help: &'static str,
    message: impl FnOnce() -> String,
) -> Result<(), LawError> {
    if ok { Ok(()) } else { Err(LawError { message: message(), key: key.to_owned(), help }) }
}

/// What every law has.
pub trait Law {
    /// The law with numbers in common use: for tests and lists that must hold for all laws.
    fn examples() -> Vec<Self>
    where
        Self: Sized;

    /// The formula with its numbers, for summaries and plots.
    fn formula(&self) -> String;

    /// Checks the parameters against each other and computes what follows from them: once, after they were read.
    /// `young` is Young's modulus of the sheet where it is known \[MPa\].
    ///
    /// # Errors
    /// When the parameters do not go together; the range of each was checked when it was read.
    fn prepare(&mut self, _young: Option<f64>) -> Result<(), LawError> {
        Ok(())
    }
}

/// Laws of one kind, of which a case names one. Made by [`family!`](family).
pub trait Family: Sized {
    /// What it is called in the schema.
    const TITLE: &'static str;
    /// The laws that a case can name, in the order of the family.
    const NAMES: &'static [&'static str];

    /// What a case calls the law.
    fn name(&self) -> &'static str;

    /// The law as it was read, made ready for use: see [`Law::prepare`].
    ///
    /// # Errors
    /// When its parameters do not go together.
    fn prepared(self, young: Option<f64>) -> Result<Self, LawError>;
}

/// Makes a family of laws: an enum with a variant for each, which hands one method to the law without a virtual call and
/// the others through [`law`]. A law in brackets is not named in cases: a plain number stands for it, as
/// the text says that answers what is neither a number nor a law.
macro_rules! family {
    (
        $(#[doc = $doc:expr])+
        pub enum $family:ident: $trait:ident;
        $(#[$method_doc:meta])*
        fn $method:ident $arguments:tt -> $output:ty;
        $([$plain_name:ident: $plain:ident, $wanted:literal])?
        $($name:ident: $law:ident,)*
    ) => {
        $(pub use $plain_name::$plain;)?
        $(pub use $name::$law;)*

        $(#[doc = $doc])+
        #[derive(Clone, Debug, PartialEq)]
        pub enum $family {
            $(#[doc = concat!("As in [`", stringify!($plain), "`].")] $plain($plain),)?
            $(#[doc = concat!("As in [`", stringify!($law), "`].")] $law($law),)*
        }

        impl $family {
            $crate::law::family! {
                @method $(#[$method_doc])* fn $method $arguments -> $output; $($plain)? $($law)*
            }

            fn law(&self) -> &dyn $trait {
                match self {
                    $(Self::$plain(law) => law,)?
                    $(Self::$law(law) => law,)*
                }
            }

            /// Examples of every law, named: for tests, lists and benchmarks that must hold for all of them.
            pub fn examples() -> Vec<(&'static str, Self)> {
                let mut all = Vec::new();
                $(all.extend(<$plain as $crate::law::Law>::examples().into_iter().map(Self::$plain));)?
                $(all.extend(<$law as $crate::law::Law>::examples().into_iter().map(Self::$law));)*
                all.into_iter().map(|law: Self| ($crate::law::Family::name(&law), law)).collect()
            }
        }

        impl std::fmt::Display for $family {
            /// The formula with its numbers.
            fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str(&self.law().formula())
            }
        }

        impl $crate::law::Family for $family {
            const TITLE: &'static str = stringify!($family);
            const NAMES: &'static [&'static str] = &[$(stringify!($name)),*];

            fn name(&self) -> &'static str {
                match self {
                    $(Self::$plain(_) => stringify!($plain_name),)?
                    $(Self::$law(_) => stringify!($name),)*
                }
            }

            fn prepared(mut self, young: Option<f64>) -> Result<Self, $crate::law::LawError> {
                match &mut self {
                    $(Self::$plain(law) => $crate::law::Law::prepare(law, young)?,)?
                    $(Self::$law(law) => $crate::law::Law::prepare(law, young)?,)*
                }
                Ok(self)
            }
        }

        #[cfg(feature = "case")]
        impl $crate::law::Readable for $family {
            const ABOUT: &'static str = concat!($($doc, "\n"),+);
            const NUMBER: Option<$crate::law::OfNumber<Self>> = $crate::law::family!(@number $($plain $wanted)?);

            fn read<'de, A: serde::de::MapAccess<'de>>(index: usize, map: &mut A) -> Result<Self, A::Error> {
                let laws = [$(|map: &mut A| map.next_value().map(Self::$law)),*];
                laws[index](map)
            }

            #[cfg(feature = "schema")]
            fn schemas(generator: &mut schemars::SchemaGenerator) -> Vec<schemars::Schema> {
                vec![$(generator.subschema_for::<$law>()),*]
            }
        }
    };
    (@method $(#[$doc:meta])* fn $method:ident($($argument:ident: $type:ty),*) -> $output:ty; $($law:ident)*) => {
        $(#[$doc])*
        #[inline]
        pub fn $method(&self, $($argument: $type),*) -> $output {
            $crate::law::family!(@each self; $($law)*; law => law.$method($($argument),*))
        }
    };
    (@each $self:ident; $($variant:ident)*; $law:ident => $call:expr) => {
        match $self {
            $(Self::$variant($law) => $call,)*
        }
    };
    (@number) => { None };
    (@number $plain:ident $wanted:literal) => { Some((|number| Self::$plain($plain::from(number)), $wanted)) };
}
pub(crate) use family;
