//! Tables that the run does not depend on: `[press]`, `[report]`, `[springback]`, `[[compare]]`.

use super::HolderForce;
use crate::case::comparison::ComparedQuantity;
use crate::measure::Ring;
use crate::units::{Angle, As, Dimensioned, Energy, Length, NonNegative, Number, Positive, Ratio};
use schemars::JsonSchema;
use serde::de::Error;
use serde::{Deserialize, Deserializer};

/// Rating of the press, as on its data sheet.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Press {
    /// Largest force; in plane strain per mm of depth of the whole section, or in all if blank.depth is given.
    #[schemars(example = "1000 kN")]
    pub force: Option<HolderForce>,
    /// Work of one stroke; in plane strain only with blank.depth.
    #[schemars(example = "20 kJ")]
    pub energy: Option<Positive<Energy>>,
}

/// Title block of a report; only given entries are shown.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TitleBlock {
    /// Name of the part.
    #[schemars(example = &"Bearing cup")]
    pub part: Option<String>,
    /// Number of the part or of its drawing.
    #[schemars(example = &"4711-02")]
    pub number: Option<String>,
    /// Revision of the part or of its drawing.
    #[schemars(example = &"C")]
    pub revision: Option<String>,
    /// Person responsible for the report.
    #[schemars(example = &"A. Ito")]
    pub author: Option<String>,
    /// Company of the author.
    #[schemars(example = &"Ito Tools Ltd")]
    pub company: Option<String>,
    /// Day of the report; the program looks at no clock.
    #[serde(default, deserialize_with = "text_or_date")]
    #[schemars(example = &"2026-11-22")]
    pub date: Option<String>,
}

/// Deserializes text, or a TOML date as text.
fn text_or_date<'de, D: Deserializer<'de>>(from: D) -> Result<Option<String>, D::Error> {
    match toml::Value::deserialize(from)? {
        toml::Value::String(text) => Ok(Some(text)),
        toml::Value::Datetime(date) => Ok(Some(date.to_string())),
        other => Err(D::Error::custom(format!("found {}, wanted text in quotes", other.type_str()))),
    }
}

impl TitleBlock {
    /// Names and values of the given entries, in the order of a drawing's title block.
    pub fn entries(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let names = ["Part", "Number", "Revision", "Author", "Company", "Date"];
        let values = [&self.part, &self.number, &self.revision, &self.author, &self.company, &self.date];
        let written = names.into_iter().zip(values).filter_map(|(name, value)| Some((name, value.as_deref()?.trim())));
        written.filter(|(_, value)| !value.is_empty())
    }

    /// Entries of `other`, and of this one where `other` has none.
    pub fn replaced_by(self, other: Self) -> Self {
        Self {
            part: other.part.or(self.part),
            number: other.number.or(self.number),
            revision: other.revision.or(self.revision),
            author: other.author.or(self.author),
            company: other.company.or(self.company),
            date: other.date.or(self.date),
        }
    }
}

/// The part's tolerances on spring-back, for the verdict on a case whose last stage takes the tools away, and the split-ring
/// test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Springback {
    /// Wanted angle between the two legs or walls of the whole section, 0 deg if they are upright \[°\]. Default: that of the
    /// punch's straight wall where the sheet lies against it, else the one under the tools.
    #[serde(deserialize_with = "degrees::<NonNegative<Angle>, _>")]
    #[schemars(with = "Option<NonNegative<Angle>>", example = "90 deg")]
    pub angle: Option<f64>,
    /// Tolerance of that angle, of both walls together \[°\]; instead of `wall_tolerance`.
    #[serde(deserialize_with = "degrees::<Positive<Angle>, _>")]
    #[schemars(with = "Option<Positive<Angle>>", example = "1 deg")]
    pub tolerance: Option<f64>,
    /// Tolerance of the angle of each wall \[°\]: half of that between both.
    #[serde(deserialize_with = "degrees::<Positive<Angle>, _>")]
    #[schemars(with = "Option<Positive<Angle>>", example = "0.5 deg")]
    pub wall_tolerance: Option<f64>,
    /// Tolerance of the turn of each flange from its place under the tools \[°\].
    #[serde(deserialize_with = "degrees::<Positive<Angle>, _>")]
    #[schemars(with = "Option<Positive<Angle>>", example = "1 deg")]
    pub flange_tolerance: Option<f64>,
    /// Tolerance of the move of each edge inward or outward from its place under the tools \[mm\].
    #[serde(with = "As::<Option<Positive<Length>>>")]
    #[schemars(example = "0.5 mm")]
    pub edge_tolerance: Option<f64>,
    /// Ring that is cut from the wall of a drawn cup and slit; its opening is reported.
    pub ring: Option<Ring>,
}

impl Springback {
    /// True if there is a tolerance to judge by.
    pub fn is_given(&self) -> bool {
        [self.tolerance, self.wall_tolerance, self.flange_tolerance, self.edge_tolerance].iter().any(Option::is_some)
    }
}

/// Deserializes an angle in degrees.
fn degrees<'de, Q: Dimensioned + Deserialize<'de>, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    Ok(Option::<Q>::deserialize(from)?.map(|angle| angle.value().to_degrees()))
}

/// One comparison with a reference: a curve (`x`, `y`, `tolerance`) or a band (`band`), depending on the quantity.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "x": ["y"], "y": ["x"], "error": ["band"] }))]
pub struct Compare {
    /// CSV file, looked for in `reference_data` beside the folder of the case, then beside the case.
    #[schemars(example = "woo_load_travel.csv")]
    pub reference: String,
    /// Compared quantity.
    #[schemars(example = &"punch_force")]
    pub quantity: ComparedQuantity,
    /// Column of the CSV along which to compare with a curve.
    #[schemars(example = &"travel_mm")]
    pub x: Option<String>,
    /// Column of the CSV that is compared with a curve. Forces of a plane section are of both halves: per mm of depth, N_per_mm,
    /// or in all if blank.depth is given; a published curve of one half is doubled in the file, with a word on it.
    #[schemars(example = &"punch_force_N")]
    pub y: Option<String>,
    /// Part of the curve that is compared, in units of the x column; default all of it.
    pub range: Option<[Number; 2]>,
    /// Accepted relative difference from a curve.
    #[schemars(example = "5 %")]
    pub tolerance: Option<Positive<Ratio>>,
    /// Columns of the CSV whose values, all rows of them, span the band.
    #[schemars(example = &("diameter_x_mm", "diameter_y_mm"))]
    pub band: Option<Vec<String>>,
    /// Column of the CSV with each row's error of measurement, which widens the band.
    #[schemars(example = &"error_mm")]
    pub error: Option<String>,
    /// Reason of the tolerance, or of a difference.
    #[schemars(example = "reading error of the published graph")]
    pub reason: String,
    /// True if the file may be missing: drop the CSV into `reference_data` to see the overlay.
    #[serde(default)]
    pub optional: bool,
    /// True if the difference is shown without failing a validation, because the input is not that of the reference.
    #[serde(default)]
    pub demonstration: bool,
}
