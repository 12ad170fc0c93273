//! Tables that the run does not depend on: `[press]`, `[report]`, `[finished]`, `[springback]`.

use super::*;
use crate::measure::Ring;
use crate::press::{Drive, Linkage, Pace, from_below};
use crate::units::{Angle, As, Energy, Number, joined};
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
    /// Drive of a mechanical press: the force that it permits at every travel, and the punch's speed if that has none of its own.
    drive: Option<PressDrive>,
}

/// Drive of a mechanical press, a crank or a link drive. The punch's full travel ends at the bottom dead centre.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PressDrive {
    /// Stroke of a crank, twice its radius.
    stroke: Option<Positive<Length>>,
    /// Length of the crank's connecting rod; infinite when not given.
    rod: Option<Positive<Length>>,
    /// Heights of the slide of a link drive over the angle before the bottom dead centre, from 0 mm at 0 deg; instead of `stroke`.
    heights: Option<Vec<(NonNegative<Angle>, NonNegative<Length>)>>,
    /// Strokes per minute, of a crank that turns evenly.
    strokes_per_minute: Option<Positive<Number>>,
    /// Heights of the slide of a servo press over time, down to 0 mm; instead of `strokes_per_minute`.
    motion: Option<Vec<(NonNegative<Time>, NonNegative<Length>)>>,
    /// Height above the bottom dead centre down from which the press bears its force.
    nominal_height: Option<Positive<Length>>,
    /// Angle before the bottom dead centre at which that height is reached; instead of it.
    nominal_angle: Option<Positive<Angle>>,
}

/// Rating of the press; `None` if the case has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Press {
    /// Largest force, of the whole section as [`Extent`] has it \[N, or N/mm of depth\].
    pub force: Option<f64>,
    /// Work of one stroke \[mJ\].
    pub energy: Option<f64>,
    /// Drive.
    pub drive: Option<Drive>,
}

impl Press {
    /// Permitted force with so much of the travel left \[mm\], as [`force`](Self::force).
    pub fn permitted(&self, left: f64) -> Option<f64> {
        Some(self.force? * self.drive.as_ref().map_or(1.0, |drive| drive.permitted(left)))
    }
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
        let Self { height, diameter, flange_diameter } = *self;
        let sizes = [(height, "", "high"), (diameter, "Ø ", "inside"), (flange_diameter, "Ø ", "over the flange")];
        let all = sizes.into_iter().filter_map(|(size, sign, of)| Some(format!("{sign}{} {of}", Amount::size(size?))));
        f.write_str(&joined(all, ", "))
    }
}

/// Tolerances on spring-back, for a case whose last stage takes the tools away, and the split-ring test.
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
    /// Wanted angle of each flange to the horizontal, positive towards the bottom \[°\]. Default: the one under the tools.
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

/// Travel over time by a press; `None` if it has no drive, or no motion in time.
pub fn stroke_of(drive: Option<&Drive>, travel: f64, source: &Source) -> Result<Option<PiecewiseLinear>> {
    let Some(drive) = drive else { return Ok(None) };
    let what = format!("the slide comes from {} mm, the punch goes {} mm", rounded(drive.reach()), rounded(travel));
    source.require(travel <= drive.reach(), "press.drive", what, "a longer stroke, or less travel")?;
    Ok(drive.schedule(travel))
}

impl CaseFile {
    /// Rating of the press in the units of the run's forces and work.
    pub fn press_rating(&self, source: &Source) -> Result<Press> {
        let (extent, press) = (self.extent(source)?, &self.press);
        let force = press.force.map(|force| force.in_extent("press.force", extent, source)).transpose()?;
        let what = "a press without force forms nothing";
        source.require(force != Some(0.0), "press.force", what, "write its rating, or leave it out")?;
        let known = press.energy.is_none() || extent != Extent::PerDepth;
        let help = "give blank.depth, or leave it out: the work per mm of depth is in the summary";
        source.require(known, "press.energy", "in plane strain the length of the part is not known", help)?;
        Ok(Press { force, energy: press.energy.map(Dimensioned::value), drive: self.press_drive(source)? })
    }

    pub fn press_drive(&self, source: &Source) -> Result<Option<Drive>> {
        const PATH: &str = "press.drive";
        let Some(written) = &self.press.drive else { return Ok(None) };
        let pairs = [["stroke", "heights"], ["strokes_per_minute", "motion"], ["nominal_height", "nominal_angle"]];
        pairs.iter().try_for_each(|pair| source.one_of(PATH, pair, "keep one of them"))?;
        let curve = |points: Vec<(f64, f64)>, key: &str, help: &str| {
            let what = "the slide does not change its height from each point to the next, down to 0 mm";
            from_below(points).ok_or_else(|| source.error(&format!("{PATH}.{key}"), what, format!("such as {help}")))
        };
        let linkage = if let Some(heights) = &written.heights {
            source.refuse(PATH, &["rod"], "is of a crank, and `heights` of a link drive are given", "drop it")?;
            let points = heights.iter().map(|(angle, height)| (angle.value(), height.value())).collect();
            Linkage::Link(curve(points, "heights", "[[\"0 deg\", \"0 mm\"], [\"30 deg\", \"9 mm\"]]")?)
        } else {
            let radius = 0.5 * written.stroke.ok_or_else(|| source.missing(PATH, "stroke"))?.value();
            let ratio = written.rod.map_or(0.0, |rod| radius / rod.value());
            let what = format!("a rod no longer than the crank's radius of {} mm", rounded(radius));
            source.require(ratio < 1.0, "press.drive.rod", what, "write its length, or leave it out")?;
            Linkage::Crank { radius, ratio }
        };
        let pace = match (&written.motion, written.strokes_per_minute) {
            (Some(points), _) => {
                let end = points.last().map_or(0.0, |(time, _)| time.value());
                let points = points.iter().rev().map(|(time, height)| (end - time.value(), height.value())).collect();
                Some(Pace::Servo(curve(points, "motion", "[[\"0 s\", \"80 mm\"], [\"1 s\", \"0 mm\"]]")?))
            }
            (None, rate) => rate.map(|rate| Pace::Strokes(rate.value())),
        };
        let angle = written.nominal_angle.map(|angle| linkage.height(angle.value()));
        let height = written.nominal_height.map(Dimensioned::value);
        let nominal_height = height.or(angle).ok_or_else(|| source.missing(PATH, "nominal_height"))?;
        let what = format!("the stroke of {} mm ends below the nominal height", rounded(linkage.stroke()));
        source.require(nominal_height < linkage.stroke(), PATH, what, "a few mm are usual")?;
        Ok(Some(Drive { linkage, pace, nominal_height }))
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
            let what = "the last stage takes no tools away: the moment that remains in the wall is not known";
            let help = "add [[stages]] with release = true, and mode = \"elasto_viscoplastic\" with young and poisson to \
                        [material]";
            source.require(self.stages.last().is_some_and(|stage| stage.release().is_some()), key, what, help)?;
        }
        let what = "an angle of 180° or more between the legs is no bend";
        let help = "write the angle between the legs, such as \"90 deg\"";
        source.require(written.angle.is_none_or(|angle| angle < 180.0), "springback.angle", what, help)?;
        source.one_of("springback", &["tolerance", "wall_tolerance"], "keep one of them")?;
        let no_angle = written.tolerance.or(written.wall_tolerance).is_none();
        let nothing = !written.is_given() && written.ring.is_none();
        let what = "[springback] has no `tolerance`: nothing says how far the angle may miss";
        let help = "write tolerance = \"1 deg\" of the angle of both walls, or wall_tolerance = \"0.5 deg\" of each";
        source.require(!no_angle || (written.angle.is_none() && !nothing), "springback", what, help)?;
        Ok(written)
    }
}
