//! Comparisons that a case requests: reference curves, point by point, and bands that values without places span.

use crate::table::Csv;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

/// File of a folder that names the sources of the others, one table per file name.
pub const SOURCES: &str = "sources.toml";

/// Kinds of reference, the hardest proof first.
pub const KINDS: [&str; 5] = ["experiment", "producer", "benchmark", "cross-check", "closed form"];

/// Comparison with a reference file.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// CSV file of the reference, units at the end of its headers.
    pub reference: PathBuf,
    /// Contents; `None` if the file is optional and missing.
    pub data: Option<Data>,
    /// Quantity and tolerance.
    pub against: Against,
    /// Reason of the tolerance or the band, or of a difference.
    pub reason: String,
    /// True if the reference file may be missing.
    pub optional: bool,
    /// True if the input is not that of the reference: a difference is shown and is no failure.
    pub demonstration: bool,
}

/// Contents of a reference file.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    /// Rows.
    pub csv: Csv,
    /// Source, if its folder names one.
    pub source: Option<Source>,
}

/// Kind of reference.
#[derive(Clone, Debug, PartialEq)]
pub enum Against {
    /// Points, each compared at its abscissa.
    Curve(CurveSpec),
    /// Interval that values without places span.
    Band(BandSpec),
}

/// Comparison along a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveSpec {
    /// Compared quantity.
    pub quantity: ComparedQuantity,
    /// Header of the abscissa.
    pub x: String,
    /// Header of the compared column.
    pub y: String,
    /// Part of the curve that is judged, in the unit of the x column.
    pub range: Option<(f64, f64)>,
    /// Largest difference over the reference value \[–\].
    pub tolerance: f64,
}

/// Comparison with the interval that measured values span.
#[derive(Clone, Debug, PartialEq)]
pub struct BandSpec {
    /// Compared quantity.
    pub quantity: ComparedQuantity,
    /// Headers of the columns whose values, all rows of them, span the band.
    pub columns: Vec<String>,
    /// Header of the column with each row's error of measurement, which widens the band on either side.
    pub error: Option<String>,
}

/// Provenance of a reference file.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Author, title, year, figure.
    pub citation: String,
    /// One of [`KINDS`], a benchmark and a cross-check with "numerical" before it, a producer's rule; or another word.
    pub kind: String,
    /// A: read in the named source; B: one source and an arithmetic check; C: assumption.
    pub grade: String,
    /// Error of the values themselves, in words.
    pub scatter: Option<String>,
}

macro_rules! quantities {
    ($($(#[doc = $doc:literal])+ $quantity:ident $name:literal $label:literal)+) => {
        /// Compared quantity.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
        pub enum ComparedQuantity {
            $($(#[doc = $doc])+ #[serde(rename = $name)] $quantity,)+
        }

        const NAMES: [&str; [$($name),+].len()] = [$($name),+];
        const LABELS: [&str; NAMES.len()] = [$($label),+];
    };
}

quantities! {
    /// Punch force at equal travel, a curve.
    PunchForce "punch_force" "force"
    /// Punch travel at equal force, a curve.
    Travel "travel" "travel"
    /// Thickness over the initial distance from the axis or symmetry plane at the end, a curve.
    ThicknessAtS0 "thickness_at_s0" "thickness"
    /// Thickness over the present radius at the end, a curve.
    ThicknessAtRadius "thickness_at_radius" "thickness"
    /// Minor over major true strain of the place that is thinnest at the end, on its way there, a curve; with `[forming_limit]`.
    StrainPath "strain_path" "strain"
    /// Draw-in of the edge at equal travel, a curve.
    DrawInAtTravel "draw_in_at_travel" "draw-in"
    /// Diameter at the blank's edge (in plane strain the width between both edges) at the end, a band.
    EdgeDiameter "edge_diameter" "diameter"
    /// Inward move of the edge at the end, a band.
    DrawIn "draw_in" "draw-in"
    /// Smallest thickness at the end, a band.
    Thinnest "thinnest" "thinnest"
    /// Thickness of the whole section at the end, a band.
    Thickness "thickness" "thickness"
    /// Largest punch force of the run, a band.
    PeakForce "peak_force" "peak force"
    /// Punch travel at the largest punch force, once the force has fallen from it, a band: the index of a cupping test.
    PeakTravel "peak_travel" "peak at"
    /// Opening of the ring of `[springback]` when it is slit, a band.
    RingOpening "ring_opening" "ring"
}

impl ComparedQuantity {
    /// Names of all quantities, as in case files.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.into_iter()
    }

    /// Name in case files, tables and file names.
    pub fn name(self) -> &'static str {
        NAMES[self as usize]
    }

    /// Short label.
    pub fn label(self) -> &'static str {
        LABELS[self as usize]
    }

    /// True of a curve, false of a band.
    pub fn is_curve(self) -> bool {
        self as usize <= Self::DrawInAtTravel as usize
    }
}

impl Against {
    /// Compared quantity.
    pub fn quantity(&self) -> ComparedQuantity {
        match self {
            Self::Curve(curve) => curve.quantity,
            Self::Band(band) => band.quantity,
        }
    }

    /// Headers of the reference file that are read.
    pub fn headers(&self) -> Vec<&str> {
        match self {
            Self::Curve(curve) => vec![&curve.x, &curve.y],
            Self::Band(band) => band.columns.iter().chain(&band.error).map(String::as_str).collect(),
        }
    }
}

impl fmt::Display for Against {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.quantity().name();
        match self {
            Self::Curve(curve) => write!(f, "{name} within {} %", 100.0 * curve.tolerance),
            Self::Band(_) => write!(f, "{name} within the band of the values"),
        }
    }
}

impl Source {
    /// Source of a reference file in the text of a `sources.toml`; `None` if it is not listed.
    ///
    /// # Errors
    /// If the text is not one table per file with citation, kind, grade and, if known, scatter.
    pub fn of(file: &str, sources: &str) -> Result<Option<Self>, toml::de::Error> {
        toml::from_str(sources).map(|mut sources: BTreeMap<String, Self>| sources.remove(file))
    }

    /// Kind without "numerical" and "'s rule".
    pub fn kind(&self) -> &str {
        let short = self.kind.strip_prefix("numerical ").unwrap_or(&self.kind);
        short.strip_suffix("'s rule").unwrap_or(short)
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}, grade {}", self.citation.trim_end_matches('.'), self.kind, self.grade)?;
        if let Some(scatter) = &self.scatter {
            write!(f, ", scatter {scatter}")?;
        }
        f.write_str(")")
    }
}
