//! The sheet that every template forms.

use super::*;
use crate::case::{file::Crystal, library, library::Entry};
use crate::material::{Hardening, Hosford, Material, hardening::Swift};
use crate::rules::tensile_strength;
use crate::writer::forming_limit;

const TYPICAL: &str = "hardening typical of mild deep-drawing steel (tensile strength near 300 MPa), not of one coil";
pub(in crate::author) const LAW: [&str; 3] = ["k", "n", "offset"];

pub(in crate::author) struct Sheet {
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
    pub fn read(inputs: &Inputs) -> Result<Self, CaseError> {
        let own = LAW.iter().find(|key| inputs.number(key).is_some());
        let (law, [thickness, friction]) = (inputs.values(LAW), inputs.values(["thickness", "friction"]));
        let entry = match (inputs.name("material"), own) {
            (Some(name), Some(key)) => {
                let what = format!("--material {name} has its own hardening law, and --{key} is of another one");
                return Err(CaseError::bare(what, "give either --material, or --k, --n and --offset".into()));
            }
            (word, _) => word.map(|word| Ok((library::material(word)?, word.to_owned()))).transpose()?,
        };
        let metal = match &entry {
            Some((entry, _)) => entry.material.clone(),
            None if own.is_none() => mild_steel(),
            None => swift(law)
                .map_err(|error| CaseError::bare(error, "give other values of --k, --n or --offset".into()))?,
        };
        let origin = if own.is_some() { "hardening as given when the case was made" } else { TYPICAL };
        Ok(Self { thickness, friction, tensile_strength: tensile_strength(&metal), metal, entry, law, origin })
    }

    /// Mean r-value \[–\].
    pub fn r_value(&self) -> f64 {
        self.metal.yield_criterion.ratio()
    }

    pub fn values(&self, is_elastic: bool) -> Values {
        let (mut values, mut material) = (Values::default(), Values::default());
        let of = self.entry.as_ref().and_then(|(entry, _)| entry.about.thickness.as_ref());
        let why = of.map_or_else(String::new, |of| format!("the material's numbers are of a sheet of {of}"));
        material.set_text("table", if self.origin == TYPICAL || is_elastic { "[material]" } else { "" });
        if let Some((entry, word)) = &self.entry {
            let named = if word == entry.name { String::new() } else { format!("named as {word}: ") };
            material.set("name", format!("{:?}", entry.name), &format!("{named}stampflow materials {}", entry.name));
        } else {
            material.swift(self.law.map(rounded));
            values.set("law", format!("\"declared: {}\"", self.origin), "");
        }
        if self.entry.is_none() && self.origin == TYPICAL {
            material.set("yield_condition", "{ hosford = { crystal = \"bcc\" } }", "ferritic steel");
        }
        if is_elastic {
            material.set("elastic", "Elastic and plastic", "");
            elastic(&mut material, &self.metal);
        }
        let is_measured = self.entry.as_ref().is_some_and(|(entry, _)| entry.measured_limit.is_some());
        values.set("thickness", mm(self.thickness), &why);
        values.set("friction", rounded(self.friction), "");
        values.set("material", material.fill(SHEET.1).trim(), "");
        values.set("forming_limit", forming_limit(&self.metal, self.thickness, is_measured), "");
        values
    }
}

pub(in crate::author) fn elastic(values: &mut Values, metal: &Material) {
    values.set("mode", "\"elasto_viscoplastic\"", "");
    if metal.elastic.is_none() {
        values.set("young", "\"206 GPa\"", "of steel, declared, as is ν");
        values.set("poisson", 0.3, "");
    }
}

pub(in crate::author) fn mild_steel() -> Material {
    let metal = swift(Inputs::of_sheet().values(LAW)).expect("the law is one");
    Material { yield_criterion: Hosford::new(1.0, Crystal::Bcc.exponent()).into(), ..metal }
}

/// Material of Swift's law: k \[MPa\], n and offset strain \[–\].
fn swift([k, n, offset]: [f64; 3]) -> Result<Material, String> {
    Ok(Material::plain(Hardening::Swift(Swift::new(k, n, offset).map_err(|error| error.to_string())?)))
}
