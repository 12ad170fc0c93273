//! `[[compare]]`: comparisons with reference curves, point by point, and with bands that values without places span.

use super::{file::Named, *};
use crate::table::Csv;
use crate::units::{Dimensioned, Number, Positive, Ratio};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Kinds of reference, the hardest proof first.
pub const KINDS: [&str; 5] = ["experiment", "producer", "benchmark", "cross-check", "closed form"];

/// Comparison with a reference file: along a curve, or with the band that its values span.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spec {
    /// CSV file of the reference, units at the end of its headers.
    pub reference: PathBuf,
    /// Contents of the file; `None` if it is optional and missing.
    pub data: Option<Csv>,
    /// Source, if the file's folder names one.
    pub source: Option<Source>,
    /// Compared quantity.
    pub quantity: ComparedQuantity,
    /// Headers of a curve's abscissa and ordinate, or of the columns whose values, all rows of them, span a band.
    pub columns: Vec<String>,
    /// Header of each row's error of measurement, which widens a band on either side.
    pub error: Option<String>,
    /// Part of a curve that is judged, in the unit of its abscissa.
    pub range: Option<(f64, f64)>,
    /// Largest difference from a curve over the reference value \[–\].
    pub tolerance: f64,
    /// Reason of the tolerance or the band, or of a difference.
    pub reason: String,
    /// True if the reference file may be missing.
    pub optional: bool,
    /// True if the input is not that of the reference: a difference is shown and is no failure.
    pub demonstration: bool,
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

named! {
    /// Compared quantity.
    #[derive(Default, Deserialize, JsonSchema)]
    #[serde(rename_all = "snake_case")]
    pub enum ComparedQuantity;
    /// Name in case files, tables and file names.
    fn name;
    #[default] PunchForce: "punch_force", "Punch force at equal travel, a curve.";
    Travel: "travel", "Punch travel at equal force, a curve.";
    ThicknessAtS0: "thickness_at_s0", "Thickness over the initial distance from the axis or symmetry plane at the end, a curve.";
    ThicknessAtRadius: "thickness_at_radius", "Thickness over the present radius at the end, a curve.";
    StrainPath: "strain_path", "Minor over major true strain of the place that is thinnest at the end, on its way there, a curve; with `[forming_limit]`.";
    DrawInAtTravel: "draw_in_at_travel", "Draw-in of the edge at equal travel, a curve.";
    EdgeDiameter: "edge_diameter", "Diameter at the blank's edge (in plane strain the width between both edges) at the end, a band.";
    DrawIn: "draw_in", "Inward move of the edge at the end, a band.";
    Thinnest: "thinnest", "Smallest thickness at the end, a band.";
    Thickness: "thickness", "Thickness of the whole section at the end, a band.";
    PeakForce: "peak_force", "Largest punch force of the run, a band.";
    PeakTravel: "peak_travel", "Punch travel at the largest punch force, once the force has fallen from it, a band: the index of a cupping test.";
    RingOpening: "ring_opening", "Opening of the ring of `[springback]` when it is slit, a band.";
}

impl ComparedQuantity {
    /// Short label.
    pub fn label(self) -> &'static str {
        let labels = "force, travel, thickness, thickness, strain, draw-in, diameter, draw-in, thinnest, thickness, peak force, \
                      peak at, ring";
        labels.split(", ").nth(self as usize).unwrap_or_default()
    }

    /// True of a curve, false of a band.
    pub fn is_curve(self) -> bool {
        self as usize <= Self::DrawInAtTravel as usize
    }
}

impl Spec {
    /// Name of the reference file without its folders.
    pub fn file(&self) -> String {
        self.reference.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}

impl Source {
    /// Source of a reference file in the text of a `sources.toml`; `None` if it is not listed.
    /// Fails if the text is not one table per file with citation, kind, grade and, if known, scatter.
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

/// One comparison with a reference: a curve (`x`, `y`, `tolerance`) or a band (`band`), depending on the quantity.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "x": ["y"], "y": ["x"], "error": ["band"] }))]
pub struct Compare {
    /// CSV file, looked for in `reference_data` beside the folder of the case, then beside the case.
    reference: String,
    /// Compared quantity.
    quantity: ComparedQuantity,
    /// Column of the CSV along which to compare with a curve.
    x: Option<String>,
    /// Column of the CSV that is compared with a curve. Forces of a plane section are of both halves: per mm of depth, N_per_mm,
    /// or in all if blank.depth is given; a published curve of one half is doubled in the file, with a word on it.
    y: Option<String>,
    /// Part of the curve that is compared, in units of the x column; default all of it.
    range: Option<[Number; 2]>,
    /// Accepted relative difference from a curve.
    tolerance: Option<Positive<Ratio>>,
    /// Columns of the CSV whose values, all rows of them, span the band.
    band: Option<Vec<String>>,
    /// Column of the CSV with each row's error of measurement, which widens the band.
    error: Option<String>,
    /// Reason of the tolerance, or of a difference.
    reason: String,
    /// True if the file may be missing: drop the CSV into `reference_data` to see the overlay.
    #[serde(default)]
    optional: bool,
    /// True if the difference is shown without failing a validation, because the input is not that of the reference.
    #[serde(default)]
    demonstration: bool,
}

const EXAMPLE: &str = "write for example travel_mm,punch_force_kN in the first line and 12.5,30.1 below it";

fn provenance(path: &Path, key: &str, source: &source::Source) -> Result<Option<Source>> {
    let sources = path.with_file_name("sources.toml");
    let unreadable = |why: &str| {
        let what = format!("cannot read {}: {why}", sources.display());
        source.error(key, what, "one table per reference file with citation, kind, grade and, if known, scatter")
    };
    let text = match source.file(&sources, files::CSV) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        text => text.map_err(|error| unreadable(&error.to_string()))?,
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    Source::of(&name, &text).map_err(|error| unreadable(error.message()))
}

impl Compare {
    pub(super) fn spec(&self, path: &str, limited: bool, source: &source::Source) -> Result<Spec> {
        let Self { reference, quantity, x, y, range, tolerance, band, error, reason, optional, demonstration } =
            self.clone();
        let (key, folder) = (format!("{path}.reference"), source.folder.path);
        let [first, second] = [folder.join("../reference_data").join(&reference), folder.join(&reference)];
        let named = Named { file: &reference, what: "reference", example: EXAMPLE, key: &key };
        let read = named.first(&[&first, &second], source)?;
        let what = format!("the reference file \"{reference}\" is not there");
        let help = format!("put it at {} or {}, or set optional = true", first.display(), second.display());
        source.require(read.is_some() || optional, &key, what, help)?;
        let (key_of_reason, help) = (format!("{path}.reason"), "say what the difference may come from");
        source.require(!reason.trim().is_empty(), &key_of_reason, "a comparison needs its reason", help)?;
        let what = "strain paths are kept of a case with a forming limit, and this one has none";
        let help = "add [forming_limit] with hill = true, or points";
        source.require(limited || quantity != ComparedQuantity::StrainPath, &format!("{path}.quantity"), what, help)?;

        let (along, across) = (["x", "y", "tolerance"], ["band", "error"]);
        let (foreign, needed, help) = if quantity.is_curve() {
            (&across[..], &along[..], "along a curve: give x, y and tolerance")
        } else {
            let help = "with the band that values span: give `band` the columns that hold them, as in \
                        band = [\"low_mm\", \"high_mm\"]";
            (&["x", "y", "range", "tolerance"][..], &across[..1], help)
        };
        let help = format!("`{}` is compared {help}", quantity.name());
        source.refuse(path, foreign, "does not apply here", &help)?;
        if let Some(missing) = needed.iter().find(|key| !source.written(path, needed).contains(key)) {
            return Err(source.error(path, format!("`{missing}` is missing in {path}"), help));
        }
        let range = range.map(|[from, to]| (from.value(), to.value()));
        if let Some((from, to)) = range {
            let what = format!("`range` must rise, found {from} to {to}");
            source.require(from < to, &format!("{path}.range"), what, format!("write range = [{to}, {from}]"))?;
        }
        let columns = band.unwrap_or_else(|| x.into_iter().chain(y).collect());
        source.require(!columns.is_empty(), &format!("{path}.band"), "`band` names no column", &help)?;
        let tolerance = tolerance.map_or(0.0, |tolerance| tolerance.value());
        let spec =
            Spec { quantity, columns, error, range, tolerance, reason, optional, demonstration, ..Spec::default() };
        let Some((file, lines, csv)) = read else { return Ok(Spec { reference: first, ..spec }) };
        if let Some(row) = csv.rows.iter().find(|row| row.fields.len() != csv.header.fields.len()) {
            let what = format!("a row of {} under {} columns", row.fields.len(), csv.header.fields.len());
            return Err(lines.error(row.line, what, "write a comma for each field, empty ones too"));
        }
        Ok(Spec { reference: file.to_owned(), data: Some(csv), source: provenance(file, &key, source)?, ..spec })
    }
}
