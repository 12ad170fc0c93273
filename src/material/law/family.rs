//! Laws of one kind as one type.

/// Makes a family of laws: an enum with a variant for each, which hands one method to the law without a virtual call and
/// the others through `law`, and the table of a case that names one. A law in brackets is not named in that table.
macro_rules! family {
    (
        $(#[$doc:meta])+
        pub enum $family:ident: $trait:ident, named in $table:ident as $title:tt;
        $(#[$method_doc:meta])*
        fn $method:ident $arguments:tt -> $output:ty;
        $([$plain_name:ident: $plain:ident])?
        $($name:ident: $law:ident,)*
    ) => {
        $(pub use $plain_name::$plain;)?
        $(pub use $name::$law;)*

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
            $crate::material::law::family! {
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
                $(all.extend(<$plain as $crate::material::law::Law>::examples().into_iter().map(Self::$plain));)?
                $(all.extend(<$law as $crate::material::law::Law>::examples().into_iter().map(Self::$law));)*
                all.into_iter().map(|law: Self| ($crate::material::law::Family::name(&law), law)).collect()
            }
        }

        impl std::fmt::Display for $family {
            /// The formula with its numbers.
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
                match &mut self {
                    $(Self::$plain(law) => $crate::material::law::Law::prepare(law, young)?,)?
                    $(Self::$law(law) => $crate::material::law::Law::prepare(law, young)?,)*
                }
                Ok(self)
            }
        }
    };
    (@method $(#[$doc:meta])* fn $method:ident($($argument:ident: $type:ty),*) -> $output:ty; $($law:ident)*) => {
        $(#[$doc])*
        #[inline]
        pub fn $method(&self, $($argument: $type),*) -> $output {
            $crate::material::law::family!(@each self; $($law)*; law => law.$method($($argument),*))
        }
    };
    (@each $self:ident; $($variant:ident)*; $law:ident => $call:expr) => {
        match $self {
            $(Self::$variant($law) => $call,)*
        }
    };
}
pub(crate) use family;
