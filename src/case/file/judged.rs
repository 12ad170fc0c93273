//! Tables that the run does not depend on: `[press]`, `[report]`, `[finished]`, `[springback]`.

use super::*;
use crate::measure::Ring;
use crate::units::{Angle, As, Energy, joined};
use serde::{Deserializer, de::Error};
use std::fmt;

/// Rating of the press, as on its data sheet.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Press")]
pub struct WrittenPress {
    /// Largest force; in plane strain per mm of depth of the whole section, or in all if blank.depth is given.
    force: Option<HolderForce>,
    /// Work of one stroke; in plane strain only with blank.depth.
    energy: Option<Positive<Energy>>,
}

/// Rating of the press; `None` if the case has none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Press {
    /// Largest force, of the whole section as [`Extent`] has it \[N, or N/mm of depth\].
    pub force: Option<f64>,
    /// Work of one stroke \[mJ\].
    pub energy: Option<f64>,
}

/// Title block of a report; only given entries are shown.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TitleBlock {
    /// Name of the part.
    pub part: Option<String>,
    /// Number of the part or of its drawing.
    pub number: Option<String>,
    /// Revision of the part or of its drawing.
    pub revision: Option<String>,
    /// Customer of the part.
    pub customer: Option<String>,
    /// Person responsible for the report.
    pub author: Option<String>,
    /// Company of the author.
    pub company: Option<String>,
    /// Day of the report; `stampflow report` takes today without it.
    #[serde(default, deserialize_with = "text_or_date")]
    pub date: Option<String>,
}

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
        let names = ["Part", "Number", "Revision", "Customer", "Author", "Company", "Date"];
        let Self { part, number, revision, customer, author, company, date } = self;
        let values = [part, number, revision, customer, author, company, date];
        let written = names.into_iter().zip(values).filter_map(|(name, value)| Some((name, value.as_deref()?.trim())));
        written.filter(|(_, value)| !value.is_empty())
    }
}

/// Sizes of a round part once its rim or its flange is trimmed, for the verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Finished {
    /// Height from the outside of the bottom to the trimmed rim, or to the flange's other face \[mm\].
    #[serde(with = "As::<Positive<Length>>")]
    pub height: Option<f64>,
    /// Inside diameter of the wall at that height \[mm\].
    #[serde(with = "As::<Positive<Length>>")]
    pub diameter: Option<f64>,
    /// Diameter to which a flange is trimmed \[mm\].
    #[serde(with = "As::<Positive<Length>>")]
    pub flange_diameter: Option<f64>,
}

/// `80 mm high, Ø 50 mm inside`; empty if nothing is given.
impl fmt::Display for Finished {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sizes = [
            (self.height, "", "high"),
            (self.diameter, "Ø ", "inside"),
            (self.flange_diameter, "Ø ", "over the flange"),
        ];
        let all = sizes.into_iter().filter_map(|(size, sign, of)| Some(format!("{sign}{} {of}", Amount::size(size?))));
        f.write_str(&joined(all, ", "))
    }
}

/// The part's tolerances on spring-back, for the verdict on a case whose last stage takes the tools away, and the split-ring
/// test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Springback {
    /// Wanted angle between the two legs or walls of the whole section, 0 deg if they are upright \[°\]. Default: that of the
    /// punch's straight wall where the sheet lies against it, else the one under the tools.
    #[serde(with = "As::<NonNegative<Angle>>")]
    pub angle: Option<f64>,
    /// Tolerance of that angle, of both walls together \[°\]; instead of `wall_tolerance`.
    #[serde(with = "As::<Positive<Angle>>")]
    pub tolerance: Option<f64>,
    /// Tolerance of the angle of each wall \[°\]: half of that between both.
    #[serde(with = "As::<Positive<Angle>>")]
    pub wall_tolerance: Option<f64>,
    /// Wanted angle of each flange to the horizontal, positive with the edge towards the bottom \[°\]. Default: the one under the
    /// tools.
    #[serde(with = "As::<Angle>")]
    pub flange_angle: Option<f64>,
    /// Tolerance of that angle \[°\].
    #[serde(with = "As::<Positive<Angle>>")]
    pub flange_tolerance: Option<f64>,
    /// Tolerance of the move of each edge inward or outward from its place under the tools \[mm\].
    #[serde(with = "As::<Positive<Length>>")]
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

impl CaseFile {
    /// Rating of the press in the units of the run's forces and work.
    pub fn press_rating(&self, source: &Source) -> Result<Press> {
        let (extent, press) = (self.extent(source)?, &self.press);
        let force = press.force.map(|force| force.in_extent("press.force", extent, source)).transpose()?;
        let what = "a press without force forms nothing";
        source.require(force != Some(0.0), "press.force", what, "write its rating, or leave it out")?;
        let known = press.energy.is_none() || extent != Extent::PerDepth;
        let what = "in plane strain the length of the part is not known";
        let help = "give blank.depth, or leave it out: the work per mm of depth is in the summary";
        source.require(known, "press.energy", what, help)?;
        Ok(Press { force, energy: press.energy.map(Dimensioned::value) })
    }

    pub fn springback_tolerances(&self, source: &Source) -> Result<Springback> {
        let Some(mut written) = self.springback else { return Ok(Springback::default()) };
        let Springback { angle, tolerance, wall_tolerance, flange_angle, flange_tolerance, .. } = &mut written;
        let angles = [angle, tolerance, wall_tolerance, flange_angle, flange_tolerance];
        angles.into_iter().flatten().for_each(|angle| *angle = angle.to_degrees());
        if written.ring.is_some() {
            let key = "springback.ring";
            let help = "drop it: a ring is cut from an axisymmetric cup";
            source.require(self.geometry == Geometry::Axisymmetric, key, "a strip has no ring to cut", help)?;
            let released = self.stages.last().is_some_and(|stage| stage.release().is_some());
            let what = "the last stage takes no tools away: the moment that remains in the wall is not known";
            let help = "add [[stages]] with release = true, and mode = \"elasto_viscoplastic\" with young and poisson to \
                        [material]";
            source.require(released, key, what, help)?;
        }
        let what = "an angle of 180° or more between the legs is no bend";
        let help = "write the angle between the legs, such as \"90 deg\"";
        source.require(written.angle.is_none_or(|angle| angle < 180.0), "springback.angle", what, help)?;
        source.one_of("springback", &["tolerance", "wall_tolerance"], "keep one of them")?;
        let no_angle = written.tolerance.or(written.wall_tolerance).is_none();
        let nothing = !written.is_given() && written.ring.is_none();
        let what = "[springback] has no `tolerance`: nothing says how far the angle may miss";
        let help =
            "write tolerance = \"1 deg\" of the angle between both walls, or wall_tolerance = \"0.5 deg\" of each";
        source.require(!no_angle || (written.angle.is_none() && !nothing), "springback", what, help)?;
        Ok(written)
    }
}
