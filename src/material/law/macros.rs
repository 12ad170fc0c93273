//! Laws of one kind as one type, and their parameters with quantities and examples.

/// Makes a family of laws: the interface of a law, an enum with a variant for each, which hands one method to the law without
/// a virtual call and the others through `law`, and the table of a case that names one. A law in brackets is not in that table.
macro_rules! family {
    (
        $(#[$doc:meta])+
        pub enum $family:ident: $trait:ident, named in $table:ident as $title:tt;
        $(#[$method_doc:meta])*
        fn $method:ident($($argument:ident: $type:ty),*) -> $output:ty;
        $({ $($more:tt)* })?
        $([$plain_name:ident: $plain:ident])?
        $($name:ident: $law:ident,)*
    ) => {
        $(pub use $plain_name::$plain;)?
        $(pub use $name::$law;)*

        trait $trait {
            /// Formula with its numbers, for summaries and plots.
            fn formula(&self) -> String;

            /// Checks parameters and computes what follows, after they were read; `young` is Young's modulus \[MPa\].
            fn prepare(&mut self, _young: Option<f64>) -> Result<(), $crate::material::law::LawError> {
                Ok(())
            }

            $(#[$method_doc])*
            fn $method(&self, $($argument: $type),*) -> $output;

            $($($more)*)?
        }

        $(#[$doc])+
        #[derive(Clone, Debug, PartialEq)]
        pub enum $family {
            $(#[doc = concat!("As in [`", stringify!($plain), "`].")] $plain($plain),)?
            $(#[doc = concat!("As in [`", stringify!($law), "`].")] $law($law),)*
        }

        $(#[$doc])+
        #[derive(Clone, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        #[schemars(rename = $title, transform = $crate::material::law::one_of)]
        pub struct $table {
            $($name: Option<$law>,)*
        }

        impl $family {
            $(#[$method_doc])*
            #[inline]
            pub fn $method(&self, $($argument: $type),*) -> $output {
                $crate::material::law::family!(@each self; $($plain)? $($law)*; law => law.$method($($argument),*))
            }

            fn law(&self) -> &dyn $trait {
                $crate::material::law::family!(@each self; $($plain)? $($law)*; law => law)
            }

            /// Example of every law with its name: for tests, lists and benchmarks that must hold for all of them.
            pub fn examples() -> Vec<(&'static str, Self)> {
                use $crate::material::law::Example;
                vec![
                    $((stringify!($plain_name), Self::$plain($plain::example())),)?
                    $((stringify!($name), Self::$law($law::example())),)*
                ]
            }
        }

        impl std::fmt::Display for $family {
            fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str(&self.law().formula())
            }
        }

        impl $crate::material::law::Family for $family {
            type Table = $table;
            const NAMES: &'static [&'static str] = &[$(stringify!($name)),*];

            fn name(&self) -> &'static str {
                match self {
                    $(Self::$plain(_) => stringify!($plain_name),)?
                    $(Self::$law(_) => stringify!($name),)*
                }
            }

            fn named(table: $table) -> Vec<Self> {
                [$(table.$name.map(Self::$law)),*].into_iter().flatten().collect()
            }

            fn prepared(mut self, young: Option<f64>) -> Result<Self, $crate::material::law::LawError> {
                $crate::material::law::family!(@each &mut self; $($plain)? $($law)*; law => law.prepare(young)?);
                Ok(self)
            }
        }
    };
    (@each $self:expr; $($variant:ident)*; $law:ident => $call:expr) => {
        match $self {
            $(Self::$variant($law) => $call,)*
        }
    };
}

/// Makes a struct of numbers in the solver's units, read with their units: `k: "As::<Positive<Stress>>" = "520 MPa"`, where
/// the last text is the schema's example. `as HardeningLaw` gives the law a `new`.
macro_rules! parameters {
    (
        $(#[$attribute:meta])+
        pub struct $law:ident $(as $trait:ident)? {
            $($(#[$field_attribute:meta])+ $visible:vis $field:ident: $quantity:tt = $example:expr,)+
        }
    ) => {
        #[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        $(#[$attribute])+
        pub struct $law {
            $(
                $(#[$field_attribute])+
                #[serde(with = $quantity)]
                #[schemars(example = $example)]
                $visible $field: f64,
            )+
        }

        $crate::material::law::parameters!(@new $law $($trait)?; $($field),+);

        impl $crate::material::law::Example for $law {
            fn example() -> Self {
                let written = serde_json::json!({ $(stringify!($field): $example),+ });
                serde_json::from_value(written).expect("examples are valid")
            }
        }
    };
    (@new $law:ident; $($field:ident),+) => {};
    (@new $law:ident $trait:ident; $($field:ident),+) => {
        impl $law {
            /// Law with these parameters, in MPa and 1. Fails when they do not go together.
            pub fn new($($field: f64),+) -> Result<Self, LawError> {
                let mut law = Self { $($field),+ };
                $trait::prepare(&mut law, None).map(|()| law)
            }
        }
    };
}
pub(crate) use {family, parameters};
