//! The sheet that every template forms.

use super::inputs::{Choice, Inputs, Kind};
use crate::assess::design::tensile_strength;
use crate::author::writer::{Values, forming_limit, mm};
use crate::case::CaseError;
use crate::case::library::{self, Entry};
use crate::material::hardening::Swift;
use crate::material::{Elastic, Hardening, Material};
use crate::units::{parse, rounded};

const K: &str = "520 MPa";
const N: &str = "0.22";
const OFFSET: &str = "0.005";
/// Default of Coulomb's coefficient \[–\].
pub const FRICTION: &str = "0.08";
const SWIFT: &str = "the law of --k, --n and --offset";
const TYPICAL: &str = "hardening typical of mild deep-drawing steel (tensile strength near 300 MPa), not of one coil";
/// Elasticity of steel \[MPa, –\], where the library has none of a sheet.
const STEEL: Elastic = Elastic { young: 206e3, poisson: 0.3 };

const MATERIAL: &str = "\
<if table>
# <elastic>, so that the sheet springs back.
<table>
name = <name>
mode = <mode>
young = <young>
poisson = <poisson>

<if k>
# σ = k (offset + ε)^n
[material.hardening.swift]
k = <k>
n = <n>
offset = <offset>
";

/// Swift's law of mild deep-drawing steel: k \[MPa\], n and offset strain \[–\].
pub fn typical() -> [f64; 3] {
    [K, N, OFFSET].map(|text| parse(text).expect("the law is well written").value)
}

/// Options of the sheet, which every template has.
pub const SHEET: &[Choice] = &[
    Choice::length("thickness", "1 mm", "sheet thickness"),
    Choice::new("material", Kind::NAME, SWIFT, "sheet of the library, see `stampflow materials`"),
    Choice::new("k", Kind::STRESS, K, "k of the hardening law σ = k (offset + ε)^n"),
    Choice::new("n", Kind::NUMBER, N, "its exponent"),
    Choice::new("offset", Kind::NUMBER, OFFSET, "its offset strain"),
    Choice::new("friction", Kind::FRACTION, FRICTION, "Coulomb's coefficient on all tools"),
];

/// Thickness, material and friction.
pub(super) struct Sheet {
    /// \[mm\]
    pub thickness: f64,
    friction: f64,
    /// \[MPa\]
    pub tensile_strength: f64,
    pub metal: Material,
    /// Entry of the library, and the word by which it was named.
    entry: Option<(Entry, String)>,
    /// Swift's law without an entry, and its origin.
    law: [f64; 3],
    origin: &'static str,
}

impl Sheet {
    /// # Errors
    /// When there is no such law or material, or both are given.
    pub fn read(inputs: &Inputs) -> Result<Self, CaseError> {
        const LAW: [&str; 3] = ["k", "n", "offset"];
        let own = LAW.iter().find(|key| inputs.number(key).is_some());
        let law = LAW.map(|key| inputs.value(key));
        let (entry, metal) = match (inputs.name("material"), own) {
            (Some(name), Some(key)) => {
                let what = format!("--material {name} has its own hardening law, and --{key} is of another one");
                return Err(CaseError::bare(what, "give either --material, or --k, --n and --offset".into()));
            }
            (Some(word), None) => {
                let entry = library::material(word)?;
                let metal = entry.material.clone();
                (Some((entry, word.to_owned())), metal)
            }
            (None, _) => {
                let help = "give other values of --k, --n or --offset";
                let swift = Swift::new(law[0], law[1], law[2]);
                let swift = swift.map_err(|error| CaseError::bare(error.to_string(), help.into()))?;
                (None, Material::plain(Hardening::Swift(swift)))
            }
        };
        let origin = if own.is_some() { "hardening as given when the case was made" } else { TYPICAL };
        let [thickness, friction] = ["thickness", "friction"].map(|key| inputs.value(key));
        Ok(Self { thickness, friction, tensile_strength: tensile_strength(&metal), metal, entry, law, origin })
    }

    /// Mean r-value \[–\].
    pub fn r_value(&self) -> f64 {
        self.metal.yield_criterion.ratio()
    }

    /// E and ν: the material's, or those of steel.
    pub fn elastic(&self) -> Elastic {
        self.metal.elastic.unwrap_or(STEEL)
    }

    /// Values of the sheet: thickness, friction, material and forming limit.
    pub fn values(&self, is_elastic: bool) -> Values {
        let mut values = Values::default();
        let entry = self.entry.as_ref().map(|(entry, _)| entry);
        let thickness = entry.and_then(|entry| entry.thickness.as_ref());
        let why = thickness.map_or(String::new(), |of| format!("the material's numbers are of a sheet of {of}"));
        values.set("thickness", mm(self.thickness), &why);
        values.set("friction", rounded(self.friction), "");
        values.set("material", self.material(is_elastic).trim(), "");
        let is_measured = entry.is_some_and(|entry| entry.measured_limit.is_some());
        values.set("forming_limit", forming_limit(&self.metal, self.thickness, is_measured), "");
        if entry.is_none() {
            values.set("law", format!("\"declared: {}\"", self.origin), "");
        }
        values
    }

    fn material(&self, is_elastic: bool) -> String {
        let mut values = Values::default();
        if let Some((entry, word)) = &self.entry {
            let why = if word == entry.name { String::new() } else { format!("named as {word}: ") };
            values.set("table", "[material]", "");
            values.set("name", format!("{:?}", entry.name), &format!("{why}stampflow materials {}", entry.name));
        } else {
            values.swift(self.law.map(rounded));
        }
        if is_elastic {
            values.set("table", "[material]", "");
            values.set("mode", "\"elasto_viscoplastic\"", "");
            values.set("elastic", "Elastic and plastic", "");
        }
        if is_elastic && self.metal.elastic.is_none() {
            values.set("young", format!("\"{} GPa\"", 1e-3 * STEEL.young), "of steel, declared, as is ν");
            values.set("poisson", STEEL.poisson, "");
        }
        values.fill(MATERIAL)
    }
}
