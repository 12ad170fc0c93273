//! A flat-bottomed cup, drawn until no flange is left.

use super::inputs::{Choice, Inputs, Kind, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{HOLDER_PRESSURE, NOSE, Tools, careful, draw, flat_punch, nose_fits, throat};
use crate::author::page::plain;
use crate::case::{CaseError, parse};
use crate::measure::part_height;
use crate::model::Geometry;
use crate::solver;
use crate::units::rounded;

/// Runs that correct the trim: after two it is settled to its last digit or nearly so, of the flattest cups after three.
const RUNS: usize = 3;

pub(super) const TEMPLATE: Template =
    Template::new("cup", "a flat-bottomed cup of a wanted height, drawn until no flange is left", OPTIONS, write);

const OPTIONS: &[Choice] = &[
    Choice::radius(
        "punch-radius",
        "punch-diameter",
        Value("30 mm"),
        "radius of the punch, half the inner diameter of the cup",
    ),
    Choice::length("height", Value("30 mm"), "overall height of the cup, outside of the bottom to rim"),
    Choice::new(
        "trim",
        Kind::Share,
        Rule("what a run needs to reach the height"),
        "blank for that much more height: the rim thickens and is trimmed",
    ),
    NOSE,
    Choice::length("shoulder", Rule("6 thicknesses of the rim"), "radius of the die's corner"),
    Choice::length("clearance", Rule("t √β"), "gap between punch and die"),
    HOLDER_PRESSURE,
];

/// Sizes of a cup and its tools \[mm\].
pub(super) struct Cup {
    pub radius: f64,
    pub nose: Picked,
    pub height: f64,
    /// Height that the blank is made for, over the wanted one, less 1 \[–\].
    pub trim: Picked,
}

impl Cup {
    /// # Errors
    /// When nose, radius and height do not go together.
    pub fn read(inputs: &Inputs, sheet: &Sheet, trim: Picked) -> Result<Self, CaseError> {
        let (radius, height) = (inputs.value("punch-radius"), inputs.value("height"));
        let nose = inputs.pick("nose", || rules::tool_radius(sheet.thickness));
        nose_fits(nose.value, radius)?;
        let least = nose.value + sheet.thickness;
        if height <= least {
            let what = format!("a height of {} leaves no wall above nose and bottom, {}", plain(height), plain(least));
            return Err(CaseError::bare(what, "make --height larger or --nose smaller".into()));
        }
        Ok(Self { radius, nose, height, trim })
    }

    /// Radius of the blank that keeps the area of the mid-surface of a cup of a height, and of what is trimmed off.
    pub fn blank_for(&self, height: f64, t: f64) -> f64 {
        let height = height * (1.0 + self.trim.value) - 0.5 * t;
        rules::blank_of(rules::cup_area(self.radius + 0.5 * t, self.nose.value + 0.5 * t, height))
    }

    /// The blank of this cup.
    pub fn blank(&self, t: f64) -> Picked {
        let Picked { value, why } = &self.trim;
        Picked::by(
            self.blank_for(self.height, t),
            format!(
                "half of D, D² = d² + 4 d h − 1.72 r d − 0.57 r²: the mid-surface keeps its area (Guldin), with h for {} and {} % \
                 {}{}{why}",
                plain(self.height),
                rounded(100.0 * value.abs()),
                if *value < 0.0 { "less" } else { "more" },
                if why.is_empty() { "" } else { ", " },
            ),
        )
    }
}

/// The case whose run reaches the wanted height, by its trim unless that is given.
///
/// How much the rim thickens hangs on the draw ratio, the radii and the friction: the missing height of a run is the next
/// one's trim. A case that does not run to its end keeps the declared one.
fn write(inputs: &Inputs) -> Result<String, CaseError> {
    if let Some(trim) = inputs.given("trim") {
        return page(inputs, Picked::given(trim));
    }
    let declared = Picked { value: rules::TRIM, why: rules::TRIMMED.into() };
    let mut trim = declared.clone();
    for _ in 0..RUNS {
        let text = page(inputs, trim.clone())?;
        // What is refused is shown as it is.
        let Ok(case) = parse(&text, "cup.toml", &[]) else { return Ok(text) };
        let run = solver::run(case.model(), &mut ());
        let end = run.frames.last().filter(|_| run.stop.is_complete());
        let Some(height) = end.and_then(part_height) else { return page(inputs, declared) };
        let value = trim.value + 1.0 - height / inputs.value("height");
        trim = Picked { value: (1e3 * value).round() / 1e3, why: "as runs of this case need".into() };
    }
    page(inputs, trim)
}

fn page(inputs: &Inputs, trim: Picked) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let cup = Cup::read(inputs, &sheet, trim)?;
    let blank = cup.blank(t);
    let or = "a smaller --trim; or draw twice: stampflow new redraw";
    let ratio = rules::draw_ratio(|height| cup.blank_for(height, t), cup.height, cup.radius, or)?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let shoulder = inputs.pick("shoulder", || rules::drawn_shoulder(t, ratio, sheet.anisotropy()));
    let throat = throat("punch", cup.radius, &clearance);
    let flat = [throat.value + shoulder.value, blank.value];
    let pressure =
        inputs.pick("holder-pressure", || rules::holder_pressure(ratio, 2.0 * cup.radius, flat, t, sheet.strength));
    let tools = Tools {
        geometry: Geometry::Axisymmetric,
        punch: flat_punch("radius", cup.radius, &cup.nose),
        travel: rules::drawn_travel(cup.height, shoulder.value, t),
        throat,
        shoulder,
        holder: None,
    }
    .held(&pressure, blank.value)?;

    let page = begin(
        &format!("A cup, {} high from the outside of its bottom to its rim.{}", plain(cup.height), careful(ratio)),
        &format!("Cup, punch diameter {}", plain(2.0 * cup.radius)),
        Geometry::Axisymmetric,
        &sheet.notes("a made-up cup"),
    );
    Ok(draw(page, &sheet, &blank, tools.shoulder.value.min(cup.nose.value), &tools))
}
