//! Laws of one kind as one type.

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
            const TITLE: &'static str = stringify!($family);
            const NAMES: &'static [&'static str] = &[$(stringify!($name)),*];

            fn name(&self) -> &'static str {
                match self {
                    $(Self::$plain(_) => stringify!($plain_name),)?
                    $(Self::$law(_) => stringify!($name),)*
                }
            }

            fn prepared(mut self, young: Option<f64>) -> Result<Self, $crate::material::law::LawError> {
                match &mut self {
                    $(Self::$plain(law) => $crate::material::law::Law::prepare(law, young)?,)?
                    $(Self::$law(law) => $crate::material::law::Law::prepare(law, young)?,)*
                }
                Ok(self)
            }
        }

        impl $crate::material::law::Readable for $family {
            const ABOUT: &'static str = concat!($($doc, "\n"),+);
            const NUMBER: Option<$crate::material::law::OfNumber<Self>> = $crate::material::law::family!(@number $($plain $wanted)?);

            fn read<'de, A: serde::de::MapAccess<'de>>(index: usize, map: &mut A) -> Result<Self, A::Error> {
                let laws = [$(|map: &mut A| map.next_value().map(Self::$law)),*];
                laws[index](map)
            }

            fn schemas(generator: &mut schemars::SchemaGenerator) -> Vec<schemars::Schema> {
                vec![$(generator.subschema_for::<$law>()),*]
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
    (@number) => { None };
    (@number $plain:ident $wanted:literal) => { Some((|number| Self::$plain($plain::from(number)), $wanted)) };
}
pub(crate) use family;
