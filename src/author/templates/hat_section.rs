//! A hat section drawn with a holder.

use super::inputs::{Choice, Inputs, Kind, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{Draw, NOSE, SHOULDER, Tools, drawn, flat_punch, newtons, nose_fits, release, throat};
use crate::author::page::plain;
use crate::case::CaseError;
use crate::model::Geometry;
use crate::units::rounded;

pub(super) const TEMPLATE: Template =
    Template::new("hat-section", "a hat section (plane strain) drawn to a wanted depth under a holder", OPTIONS, write);

const OPTIONS: &[Choice] = &[
    Choice::length("half-width", Value("30 mm"), "half-width of the punch"),
    Choice::length("height", Value("40 mm"), "depth: the punch's travel, up to the flange"),
    Choice::length("flange", Value("20 mm"), "width of flat flange left at the end"),
    NOSE,
    SHOULDER,
    Choice::length("clearance", Rule("1.1 thicknesses"), "gap between punch and die"),
    Choice::new(
        "holder-pressure",
        Kind::Stress,
        Rule("1 % of the tensile strength"),
        "pressure of the holder on the flange",
    ),
    Choice::length("length", Rule("forces per mm of depth"), "length of the part, over which forces are told"),
    Choice::new("press", Kind::Force, Rule("no press"), "force of the press, such as 250 tonf; wants --length"),
    Choice::new(
        "springback",
        Kind::Angle,
        Rule("no spring-back"),
        "tolerance of each wall's angle: the sheet is elastic too and let go, which takes longer",
    ),
];

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let (half_width, height, flange) = (inputs.value("half-width"), inputs.value("height"), inputs.value("flange"));
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    nose_fits(nose.value, half_width)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let least = nose.value + shoulder.value + t;
    if height < least {
        let what = format!("a depth of {} leaves no wall between nose and shoulder, {}", plain(height), plain(least));
        return Err(CaseError::bare(what, "make --height larger, or --nose and --shoulder smaller".into()));
    }
    let clearance = inputs.pick("clearance", || rules::strip_clearance(t));
    let wall = height - least;
    let blank = Picked::by(
        half_width - nose.value
            + rules::quarter_bend(nose.value, t)
            + wall
            + rules::quarter_bend(shoulder.value, t)
            + flange,
        "bottom, two bends, wall and flange along the mid-surface, which keeps its length",
    );
    let pressure = inputs.pick("holder-pressure", || rules::strip_pressure(sheet.strength));
    let tools = Tools {
        geometry: Geometry::PlaneStrain,
        punch: flat_punch("half_width", half_width, &nose),
        travel: Picked::by(height, "the depth that is wanted"),
        throat: throat("punch", half_width, &clearance),
        shoulder,
        holder: None,
    }
    .held(&pressure, blank.value)?;

    let (depth, springback, press) = (inputs.given("length"), inputs.given("springback"), inputs.given("press"));
    if press.is_some() && depth.is_none() {
        let what = "--press is the force of the whole press, and nothing says how long the part is";
        return Err(CaseError::bare(what.into(), "give --length too, such as --length \"60 in\"".into()));
    }

    let about = match springback {
        Some(_) => "One half of a hat section, drawn and then let go.",
        None => {
            "One half of a hat section, drawn. By the flow law, which does not spring back: for that give --springback, which \
                 takes longer."
        }
    };
    let mut page = begin(
        about,
        &format!("Hat section, punch {} wide", plain(2.0 * half_width)),
        Geometry::PlaneStrain,
        &sheet.notes("a made-up section"),
    );
    if springback.is_some() {
        page.table("stage", "");
        page.set("name", "\"draw\"", "");
    }
    let corner = tools.shoulder.value.min(nose.value);
    drawn(&mut page, &sheet, &blank, &Draw { corner, depth, elastic: springback.is_some() }, &tools);
    if springback.is_some() {
        release(&mut page);
    }
    if let Some(force) = press {
        page.table("press", "");
        page.set("force", newtons(force), "of the press: the verdict says how much of it is used");
    }
    if let Some(tolerance) = springback {
        page.table("springback", "How far the part may be from the punch's wall once it is let go.");
        let tolerance = format!("\"{} deg\"", rounded(tolerance.to_degrees()));
        page.set("wall_tolerance", tolerance, "of the angle of each wall");
    }
    Ok(page.text())
}
