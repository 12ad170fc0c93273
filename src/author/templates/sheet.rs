//! The sheet that every template forms.

use super::inputs::{self, Choice, Default, Inputs};
use super::rules::{self, Picked};
use crate::author::page::{Page, mm, size_key};
use crate::case::CaseError;
use crate::case::library::{self, Entry};
use crate::material::hardening::Swift;
use crate::material::{Elastic, Hardening, Material};
use crate::model::Geometry;
use crate::units::{parse, rounded};

/// The law of a sheet that is not named, as an option has it.
const K: &str = "520 MPa";
const N: &str = "0.22";
const OFFSET: &str = "0.005";
/// Coulomb's coefficient where nothing is known of it \[–\].
pub const FRICTION: &str = "0.08";

/// k \[MPa\], n and offset strain \[–\] of the law of a sheet that is not named.
pub fn typical() -> [f64; 3] {
    [K, N, OFFSET].map(|text| parse(text).expect("the law is well written").value)
}

/// The options of the sheet, which every template has.
pub const SHEET: &[Choice] = &[
    Choice::new("thickness", inputs::Kind::Length, Default::Value("1 mm"), "sheet thickness"),
    Choice::new(
        "material",
        inputs::Kind::Name,
        Default::Rule("the law of --k, --n and --offset"),
        "sheet of the library, see `stampflow materials`",
    ),
    Choice::new("k", inputs::Kind::Stress, Default::Value(K), "k of the hardening law σ = k (offset + ε)^n"),
    Choice::new("n", inputs::Kind::Number, Default::Value(N), "its exponent"),
    Choice::new("offset", inputs::Kind::Number, Default::Value(OFFSET), "its offset strain"),
    Choice::new("friction", inputs::Kind::Fraction, Default::Value(FRICTION), "Coulomb's coefficient on all tools"),
];

/// Those of [`SHEET`] that write a hardening law.
const LAW: [&str; 3] = ["k", "n", "offset"];
/// Of steel, declared where the material does not say it \[MPa, –\].
const STEEL: Elastic = Elastic { young: 206e3, poisson: 0.3 };
/// What is said of the law that is taken where none is given.
const TYPICAL: &str =
    "declared: hardening typical of mild deep-drawing steel (tensile strength near 300 MPa), not of one coil";
/// Where the hardening comes from.
enum Origin {
    Library {
        name: &'static str,
        /// The word that it was asked for by: its name, or a grade that it stands for.
        word: String,
        /// Of the sheet that the library's numbers are of.
        thickness: Option<String>,
        /// Whether the library has a measured forming limit of it.
        measured: bool,
    },
    /// k \[MPa\], n and offset strain \[–\] of Swift's law, and whether any of them was given.
    Swift { law: [f64; 3], own: bool },
}

/// Thickness, material and friction.
pub(super) struct Sheet {
    /// \[mm\]
    pub thickness: f64,
    origin: Origin,
    material: Material,
    pub friction: f64,
    /// Tensile strength \[MPa\].
    pub strength: f64,
}

impl Sheet {
    /// # Errors
    /// When there is no such law or material, or both are given.
    pub fn read(inputs: &Inputs) -> Result<Self, CaseError> {
        let own = LAW.iter().find(|key| inputs.given(key).is_some());
        let (origin, material) = match (inputs.name("material"), own) {
            (Some(name), Some(key)) => {
                let what = format!("--material {name} has its own hardening law, and --{key} is of another one");
                return Err(CaseError::bare(what, "give either --material, or --k, --n and --offset".into()));
            }
            (Some(word), None) => {
                let Entry { name, thickness, material, measured_limit, .. } = library::material(word)?;
                let measured = measured_limit.is_some();
                (Origin::Library { name, word: word.to_owned(), thickness, measured }, material)
            }
            (None, own) => {
                let law = LAW.map(|key| inputs.value(key));
                let swift = Swift::new(law[0], law[1], law[2]).map_err(|error| {
                    CaseError::bare(error.to_string(), "give other values of --k, --n or --offset".into())
                })?;
                (Origin::Swift { law, own: own.is_some() }, Material::plain(Hardening::Swift(swift)))
            }
        };
        let strength = rules::tensile_strength(&material);
        let [thickness, friction] = ["thickness", "friction"].map(|key| inputs.value(key));
        Ok(Self { thickness, origin, material, friction, strength })
    }

    /// Yield stress at an equivalent plastic strain \[MPa\].
    pub fn stress(&self, strain: f64) -> f64 {
        self.material.hardening.at(strain).stress
    }

    /// Mean r-value \[–\].
    pub fn anisotropy(&self) -> f64 {
        self.material.yield_criterion.ratio()
    }

    /// Stress over yield stress in even biaxial tension \[–\].
    pub fn biaxial_factor(&self) -> f64 {
        self.material.yield_criterion.biaxial_factor()
    }

    /// E and ν: the material's, or those of steel.
    pub fn elastic(&self) -> Elastic {
        self.material.elastic.unwrap_or(STEEL)
    }

    /// What is declared: the part, and where hardening and friction come from; a case says that of the library's itself.
    pub fn notes(&self, part: &str) -> Vec<String> {
        let law = match self.origin {
            Origin::Library { .. } => None,
            Origin::Swift { own: true, .. } => Some("declared: hardening as given when the case was made"),
            Origin::Swift { own: false, .. } => Some(TYPICAL),
        };
        let part = format!("declared: {part}, not a published one; sizes by the rules that stand beside them");
        let friction = format!("declared: friction {} on all tools, not measured", rounded(self.friction));
        std::iter::once(part).chain(law.map(str::to_owned)).chain([friction]).collect()
    }

    /// `[blank]` but for its keys after the thickness.
    pub fn blank(&self, page: &mut Page, geometry: Geometry, size: &Picked) {
        page.table("blank", "");
        page.length(size_key(geometry), size);
        let of = match &self.origin {
            Origin::Library { thickness: Some(of), .. } => format!("the material's numbers are of a sheet of {of}"),
            _ => String::new(),
        };
        page.set("thickness", mm(self.thickness), &of);
    }

    /// `[material]`, of elastoplastic metal where `elastic`.
    pub fn material(&self, page: &mut Page, elastic: bool) {
        let named = match &self.origin {
            Origin::Library { name, word, .. } => Some((name, word)),
            Origin::Swift { .. } => None,
        };
        if elastic || named.is_some() {
            page.table("material", if elastic { "Elastic and plastic, so that the sheet springs back." } else { "" });
        }
        if let Some((name, word)) = named {
            let why = match word == name {
                true => "of the library: stampflow materials".to_owned(),
                false => format!("of the library, asked for as {word}: stampflow materials {name}"),
            };
            page.set("name", format!("{name:?}"), &why);
        }
        if elastic {
            page.set("mode", "\"elasto_viscoplastic\"", "");
        }
        if elastic && self.material.elastic.is_none() {
            page.set("young", format!("\"{} GPa\"", 1e-3 * STEEL.young), "of steel, declared, as is ν");
            page.set("poisson", STEEL.poisson, "");
        }
        if let Origin::Swift { law, .. } = self.origin {
            page.swift(law.map(rounded), "σ = k (offset + ε)^n");
        }
    }

    /// `[forming_limit]` of a part that is drawn or stretched, where the hardening law gives one.
    pub fn forming_limit(&self, page: &mut Page) {
        let measured = matches!(self.origin, Origin::Library { measured: true, .. });
        page.forming_limit(&self.material, self.thickness, measured);
    }
}
