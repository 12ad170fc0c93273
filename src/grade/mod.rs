//! Grades of sheet: limits of delivery with their sources, the law made from them, and tolerances of thickness.

mod texts;
mod thickness;

pub use texts::{SheetText, texts, toml_files, use_folder};
pub use thickness::tolerance;

use crate::numerics::bisect;
use crate::units::{Amount, Dimensioned, Number, Ratio, Stress};
use schemars::JsonSchema;
use serde::Deserialize;
use std::fmt;

/// Plastic strain of the proof stress \[–\].
pub const PROOF: f64 = 0.002;
/// Uniform elongation over elongation after fracture, where neither it nor n is known \[–\].
///
/// Declared: the least of shop sheets with A80 and n (DC04 0.52, DX57D, DX56D and DC06 0.60, HCT780X 0.83), rounded.
pub const UNIFORM_SHARE: f64 = 0.6;
/// Least and largest offset strain of a law made from a band \[–\].
const OFFSETS: [f64; 2] = [1e-4, 1.0];

/// Coil within the band of its grade; the middle if none is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Coil {
    /// Rp0.2 and Rm at their upper ends.
    Strong,
    /// Rp0.2 and Rm at their lower ends.
    Weak,
}

/// Origin of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Limit of delivery.
    Limit,
    /// Typical or measured value.
    Typical,
    /// Declared assumption, for want of a source.
    Assumed,
}

/// Statement of one source on one property.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limit<T> {
    /// Lower end.
    pub min: Option<T>,
    /// Upper end.
    pub max: Option<T>,
    /// Single value.
    pub value: Option<T>,
    /// Gauge length of an elongation.
    pub gauge: Option<String>,
    /// Origin.
    pub kind: Kind,
    /// A, the source speaks of its own product; B, second hand; C, assumed.
    pub grade: String,
    /// Source, or the reason of an assumption.
    pub source: String,
}

/// Band of a grade: what each source says of its properties; the first that has an end is taken.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Band {
    /// Standard, or what was read in its place.
    pub standard: String,
    /// Standard and class of the tolerance of thickness.
    pub thickness_tolerance: Option<String>,
    /// 0.2 % proof stress, or lower yield stress.
    #[serde(default)]
    pub rp02: Vec<Limit<Stress>>,
    /// Tensile strength.
    pub rm: Vec<Limit<Stress>>,
    /// Uniform elongation.
    #[serde(default)]
    pub ag: Vec<Limit<Ratio>>,
    /// Elongation after fracture.
    #[serde(default)]
    pub a: Vec<Limit<Ratio>>,
    /// r-value.
    #[serde(default)]
    pub r: Vec<Limit<Number>>,
    /// Hardening exponent.
    #[serde(default)]
    pub n: Vec<Limit<Number>>,
}

/// Swift's law made from a band, σ = k (offset + ε)^n, and the strain up to which it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MadeLaw {
    /// K \[MPa\].
    pub k: f64,
    /// Exponent \[–\].
    pub n: f64,
    /// Offset strain \[–\].
    pub offset: f64,
    /// True uniform strain \[–\].
    pub uniform: f64,
}

fn ends<T: Dimensioned>(limits: &[Limit<T>]) -> Option<[f64; 2]> {
    let low = limits.iter().find_map(|limit| limit.min.or(limit.value));
    let high = limits.iter().find_map(|limit| limit.max.or(limit.value));
    Some([low.or(high)?.value(), high.or(low)?.value()])
}

fn at<T: Dimensioned>(limits: &[Limit<T>], coil: Option<Coil>) -> Option<f64> {
    let [low, high] = ends(limits)?;
    Some(match coil {
        None => 0.5 * (low + high),
        Some(Coil::Weak) => low,
        Some(Coil::Strong) => high,
    })
}

impl Band {
    /// Tensile strength \[MPa\].
    pub fn strength(&self, coil: Option<Coil>) -> Option<f64> {
        at(&self.rm, coil)
    }

    /// r-value, the lower end where there is no upper one \[–\].
    pub fn r_value(&self) -> Option<f64> {
        at(&self.r, None)
    }

    /// True uniform strain: of the uniform elongation, else n, else [`UNIFORM_SHARE`] of the elongation \[–\].
    pub fn uniform_strain(&self) -> Option<f64> {
        let n = || at(&self.n, None);
        at(&self.ag, None).map(f64::ln_1p).or_else(n).or_else(|| Some((UNIFORM_SHARE * at(&self.a, None)?).ln_1p()))
    }

    /// Swift's law by tensile strength, uniform strain and proof stress, or the least it has; `None` if one is not known.
    ///
    /// Considère's load maximum at the uniform strain ε_u makes n = ε₀ + ε_u; the ratio of both stresses gives ε₀.
    pub fn law(&self, coil: Option<Coil>) -> Option<MadeLaw> {
        let (proof, strength, uniform) = (at(&self.rp02, coil)?, self.strength(coil)?, self.uniform_strain()?);
        let ratio = |offset: f64| ((offset + PROOF) / (offset + uniform)).powf(offset + uniform) * uniform.exp();
        let [low, high] = OFFSETS.map(f64::ln);
        let [offset, _] = bisect(low, high, 50, |log| ratio(log.exp()) < proof / strength);
        let digits = |x: f64| format!("{x:.5e}").parse().unwrap_or(x);
        let (offset, n) = (offset.exp(), offset.exp() + uniform);
        let k = strength * uniform.exp() / n.powf(n);
        Some(MadeLaw { k: digits(k), n: digits(n), offset: digits(offset), uniform: digits(uniform) })
    }

    /// Origin of the law in one line; a strong or weak coil with its share over the middle.
    pub fn origin(&self, coil: Option<Coil>) -> String {
        let origin = format!("law made from the band of {}, not fitted to a measured curve", self.standard);
        let over = self.strength(coil).zip(self.strength(None)).map_or(0.0, |(own, middle)| own / middle - 1.0);
        origin + &coil.map_or(String::new(), |coil| format!("; {coil} coil {:+.0} %", 100.0 * over))
    }

    /// Rows of a table, each with the number of its source: property, least, largest, origin, grade; and the sources.
    pub fn rows(&self) -> (Vec<[String; 6]>, Vec<String>) {
        let mut sources = Vec::new();
        let mut rows = rows("Rp0.2", &self.rp02, Amount::stress, &mut sources);
        rows.extend(self::rows("Rm", &self.rm, Amount::stress, &mut sources));
        rows.extend(self::rows("Ag", &self.ag, Amount::share, &mut sources));
        rows.extend(self::rows("A", &self.a, Amount::share, &mut sources));
        rows.extend(self::rows("r", &self.r, Amount::number, &mut sources));
        rows.extend(self::rows("n", &self.n, Amount::number, &mut sources));
        (rows, sources)
    }
}

fn rows<T: Dimensioned>(
    name: &str, limits: &[Limit<T>], amount: fn(f64) -> Amount, sources: &mut Vec<String>,
) -> Vec<[String; 6]> {
    let row = |limit: &Limit<T>| {
        let end = |end: Option<T>| end.or(limit.value).map_or("–".into(), |end| amount(end.value()).to_string());
        let gauge = limit.gauge.as_ref().map_or_else(String::new, |gauge| format!(" ({gauge})"));
        let kind = format!("{:?}", limit.kind).to_lowercase();
        let is_known = |known: &String| known.split_once(": ").is_some_and(|(_, source)| source == limit.source);
        let place = sources.iter().position(is_known).unwrap_or(sources.len());
        if place == sources.len() {
            sources.push(format!("{}: {}", place + 1, limit.source));
        }
        [name.to_owned() + &gauge, end(limit.min), end(limit.max), kind, limit.grade.clone(), (place + 1).to_string()]
    };
    limits.iter().map(row).collect()
}

impl fmt::Display for Coil {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(if *self == Self::Strong { "strong" } else { "weak" })
    }
}

impl fmt::Display for MadeLaw {
    /// Keys of a `[material]` table.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { k, n, offset, uniform } = self;
        write!(f, "fitted_up_to = {uniform}\nhardening.swift = {{ k = \"{k} MPa\", n = {n}, offset = {offset} }}\n")
    }
}
