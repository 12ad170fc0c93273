//! The sheet that every template forms.

use super::inputs::{Choice, Default, Inputs, Kind};
use super::page::{Page, mm};
use super::rules;
use crate::case::CaseError;
use crate::material::Hardening;
use crate::material::hardening::Swift;
use crate::quantity::rounded;

/// The options of the sheet, which every template has.
pub const SHEET: &[Choice] = &[
    Choice::new("thickness", Kind::Length, Default::Value("1 mm"), "sheet thickness"),
    Choice::new("k", Kind::Stress, Default::Value("520 MPa"), "k of the hardening law σ = k (offset + ε)^n"),
    Choice::new("n", Kind::Number, Default::Value("0.22"), "its exponent"),
    Choice::new("offset", Kind::Number, Default::Value("0.005"), "its offset strain"),
    Choice::new("friction", Kind::Number, Default::Value("0.08"), "Coulomb's coefficient on all tools"),
];

/// Thickness, hardening and friction.
pub(super) struct Sheet {
    /// \[mm\]
    pub thickness: f64,
    /// k \[MPa\], n and offset strain \[–\] of Swift's law.
    law: [f64; 3],
    /// Whether any of them was given.
    own: bool,
    pub friction: f64,
    /// Tensile strength \[MPa\].
    pub strength: f64,
}

impl Sheet {
    /// # Errors
    /// When there is no such law.
    pub fn read(inputs: &Inputs) -> Result<Self, CaseError> {
        let law = ["k", "n", "offset"].map(|key| inputs.value(key));
        let swift = Swift::new(law[0], law[1], law[2])
            .map_err(|error| CaseError::bare(error.to_string(), "give other values of --k, --n or --offset".into()))?;
        Ok(Self {
            thickness: inputs.value("thickness"),
            law,
            own: ["k", "n", "offset"].iter().any(|key| inputs.given(key).is_some()),
            friction: inputs.value("friction"),
            strength: rules::tensile_strength(&Hardening::Swift(swift)),
        })
    }

    /// Yield stress at an equivalent plastic strain \[MPa\].
    pub fn stress(&self, strain: f64) -> f64 {
        let [k, n, offset] = self.law;
        k * (offset + strain).powf(n)
    }

    /// What is declared: the part, and where the hardening comes from.
    pub fn notes(&self, part: &str) -> Vec<String> {
        let law = match self.own {
            true => "declared: hardening as given when the case was made".to_owned(),
            false => "declared: hardening typical of mild deep-drawing steel (tensile strength near 300 MPa), not of one coil".to_owned(),
        };
        vec![format!("declared: {part}, not a published one; sizes by the rules that stand beside them"), law]
    }

    /// `[blank]` but for its keys after the thickness.
    pub fn blank(&self, page: &mut Page, key: &str, size: &rules::Picked) {
        page.table("blank", "");
        page.length(key, size);
        page.set("thickness", mm(self.thickness), "");
    }

    /// `[material]`, of the elastic twin where `elastic`.
    pub fn material(&self, page: &mut Page, elastic: bool) {
        if elastic {
            page.table("material", "Elastic and plastic, so that the sheet springs back; E and ν of steel, declared.");
            page.set("mode", "\"elasto_viscoplastic\"", "");
            page.set("young", "\"206 GPa\"", "");
            page.set("poisson", 0.3, "");
        }
        let [k, n, offset] = self.law.map(rounded);
        page.table("material.hardening.swift", "σ = k (offset + ε)^n");
        page.set("k", format!("\"{k} MPa\""), "");
        page.set("n", n, "");
        page.set("offset", offset, "");
    }
}
