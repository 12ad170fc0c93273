//! Keeler and Brazier's empirical curve of steels: a point at plane strain by thickness and exponent, and a fixed shape.
//!
//! ```text
//! FLC₀ = (23.3 + 14.13 t) n/0.21   engineering strain in percent, t in mm, n at most 0.21
//! left    ε₁ + ε₂ = ln(1 + FLC₀)   constant thickness strain
//! right   ε₁ = ln(1 + FLC₀) + 0.6 ε₂   up to an engineering minor strain of 20 % at least
//!         beyond, up to 50 %, parallel to ε₁ = ln(1 + FLC₀) + 0.5 ε₂, which is (1 + FLC₀) √(1 + e₂) − 1
//! ```
//!
//! # References
//! S. P. Keeler, W. G. Brazier, Relationship between laboratory material characterization and press-shop formability,
//! Micro Alloying 75 (1977) 517–530 (not read). The shape on both sides: AHSS Insights, Forming Limit Curves, WorldAutoSteel
//! (ahssinsights.org), which has the slope of 0.6 "at least through minor (engineering) strains of 20 %"; the formula, the cap
//! of n, the range of t and the branch of slope 0.5 up to 50 % as public programs quote them (PredictFLC.m,
//! github.com/ThiagoFK/MatLab-DissertationThesis).

use super::*;
use crate::material::law::prelude::*;

/// FLC₀ = (23.3 + 14.13 t/mm) n/0.21 percent (engineering) at plane strain; left ε₁ + ε₂ = const, right a slope of 0.6, of 0.5 beyond 20 %.
///
/// Valid for mild and conventional high-strength steel up to 3.1 mm, not for aluminium; n counts as 0.21 at most.
/// Source: S. P. Keeler, W. G. Brazier, Micro Alloying 75 (1977) 517–530 (not read; as AHSS Insights and programs quote it).
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KeelerBrazier {
    /// Hardening exponent; `None` takes the uniform strain of the sheet's law \[–\].
    #[serde(skip)]
    pub n: Option<f64>,
    /// Thickness that counts, 3.1 mm at most; that of the blank when not given \[mm\].
    #[serde(default, with = "As::<Positive<Length>>")]
    pub thickness: Option<f64>,
}

impl KeelerBrazier {
    /// Largest n that it counts with \[–\], and largest thickness it was given for \[mm\].
    const N: f64 = 0.21;
    pub(super) const THICKNESS: f64 = 3.1;

    pub(super) fn curve(&self, sheet: &Sheet) -> Result<Curve, LawError> {
        let thickness = self.thickness.unwrap_or(sheet.thickness);
        if thickness > Self::THICKNESS {
            let what = format!("keeler_brazier holds up to {} mm of thickness, found {thickness} mm", Self::THICKNESS);
            return Err(LawError::new(what, "use measured points, hill or marciniak_kuczynski"));
        }
        let (n, origin) = match self.n {
            Some(n) => (n, "given"),
            None => (uniform_strain(sheet)?, "the uniform strain of the hardening law"),
        };
        let flc0 = ((0.233 + 0.1413 * thickness) * n.min(Self::N) / Self::N).ln_1p();
        let capped = if n > Self::N { format!(", counted as {}", Amount::number(Self::N)) } else { String::new() };
        let (right, end) = (0.2_f64.ln_1p(), 0.5_f64.ln_1p());
        let shoulder = flc0 + 0.6 * right;
        let notes = vec![format!(
            "Forming limit: Keeler and Brazier, for steel, with n = {n} ({origin}{capped}) and t = {thickness}; FLC₀ = {flc0}.",
            n = Amount::ratio(n).to(Digits::Decimals(4)),
            thickness = Amount::size(thickness),
            flc0 = Amount::ratio(flc0).to(Digits::Decimals(4))
        )];
        let points =
            vec![[-0.5 * flc0, 1.5 * flc0], [0.0, flc0], [right, shoulder], [end, shoulder + 0.5 * (end - right)]];
        Curve::new("Keeler-Brazier", points, notes)
    }
}
