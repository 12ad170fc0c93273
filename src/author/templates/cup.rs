//! A flat-bottomed cup, drawn until no flange is left.

use super::sizes::round_pressure;
use super::*;
use crate::author::writer::joined;
use crate::case::parse;
use crate::measure::part_height;
use crate::solver;

/// Runs that correct the trim; the third is for the flattest cups.
const RUNS: usize = 3;

pub(super) const TRIM: &str = "blank for that much more height: the rim thickens and is trimmed";
pub(super) const RIM_SHOULDER: Choice = Choice { default: "6 thicknesses of the rim", ..SHOULDER };

pub(super) const TEMPLATE: Template = Template {
    name: "cup",
    about: "a flat-bottomed cup of a wanted height, drawn until no flange is left",
    own: &[
        Choice::length("punch-radius", "30 mm", "inner radius of the cup").or_diameter("punch-diameter"),
        Choice::length("height", "30 mm", "overall height of the cup, outside of the bottom to rim"),
        Choice::new("trim", Kind::SHARE, "what a run needs to reach the height", TRIM),
        NOSE,
        RIM_SHOULDER,
        CLEARANCE,
        HOLDER_PRESSURE,
    ],
    text: include_str!("cup.toml"),
    sizes,
};

/// Sizes of a cup \[mm\].
pub(super) struct Cup {
    pub radius: f64,
    pub nose: Picked,
    pub height: f64,
    /// Height that the blank is made for, over the wanted one, less 1 \[–\].
    pub trim: Picked,
}

impl Cup {
    /// # Errors
    /// When nose, radius and height do not fit each other.
    pub fn read(inputs: &Inputs, sheet: &Sheet, trim: Picked) -> Result<Self, CaseError> {
        let [radius, height] = ["punch-radius", "height"].map(|key| inputs.value(key));
        let nose = nose(inputs, sheet, radius)?;
        let least = nose.value + sheet.thickness;
        let what = || format!("a height of {} leaves no wall above nose and bottom, {}", plain(height), plain(least));
        ensure(height > least, what, "make --height larger or --nose smaller")?;
        Ok(Self { radius, nose, height, trim })
    }

    /// Radius of the blank with the area of the mid-surface of a cup and its trim.
    pub fn blank_for(&self, height: f64, t: f64) -> f64 {
        let height = height * (1.0 + self.trim.value) - 0.5 * t;
        rules::blank_of(rules::cup_area(self.radius + 0.5 * t, self.nose.value + 0.5 * t, height))
    }

    pub fn blank(&self, t: f64) -> Picked {
        let trim = format!("h with a trim of {} %", rounded(100.0 * self.trim.value));
        let area = "half of D, D² = d² + 4 d h − 1.72 r d − 0.57 r² (Guldin)";
        Picked::by(self.blank_for(self.height, t), joined(&[area, &trim, &self.trim.why]))
    }
}

pub(super) fn declared_trim() -> Picked {
    Picked { value: rules::TRIM, why: rules::TRIMMED.into() }
}

/// Sizes whose run reaches the wanted height: the height that a run misses is the next one's trim.
///
/// A case that does not run to its end keeps the declared trim.
fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    if let Some(trim) = inputs.number("trim") {
        return with_trim(inputs, sheet, Picked::input(trim));
    }
    let mut trim = declared_trim();
    for _ in 0..RUNS {
        let text = with_trim(inputs, sheet, trim.clone())?.fill(TEMPLATE.text);
        let Ok(case) = parse(&text, "cup.toml", &[]) else { break };
        let run = solver::run(case.model(), &mut ());
        let end = run.frames.last().filter(|_| run.stop.is_complete());
        let Some(height) = end.and_then(part_height) else { return with_trim(inputs, sheet, declared_trim()) };
        let value = trim.value + 1.0 - height / inputs.value("height");
        trim = Picked { value: (1e3 * value).round() / 1e3, why: "as runs of this case need".into() };
    }
    with_trim(inputs, sheet, trim)
}

fn with_trim(inputs: &Inputs, sheet: &Sheet, trim: Picked) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let cup = Cup::read(inputs, sheet, trim)?;
    let blank = cup.blank(t);
    let or = "a smaller --trim; or draw twice: stampflow new redraw";
    let ratio = draw_ratio(|height| cup.blank_for(height, t), cup.height, cup.radius, or)?;
    let throat = throat(cup.radius, &inputs.pick("clearance", || rules::drawing_clearance(t, ratio)));
    let shoulder = inputs.pick("shoulder", || rules::drawn_shoulder(t, ratio, sheet.r_value()));
    let flat = [throat.value + shoulder.value, blank.value];
    let mut sizes = sheet.values(false);
    sizes.elements(blank.value, shoulder.value.min(cup.nose.value), 1);
    sizes.set("wall_height", plain(cup.height), "");
    sizes.set("warning", warning(ratio), "");
    sizes.set("diameter", plain(2.0 * cup.radius), "");
    sizes.lengths([("blank", &blank), ("radius", &Picked::input(cup.radius)), ("nose", &cup.nose)]);
    sizes.lengths([("travel", &rules::drawn_travel(cup.height, shoulder.value, t))]);
    sizes.lengths([("throat", &throat), ("shoulder", &shoulder)]);
    sizes.holder(Geometry::Axisymmetric, flat, &round_pressure(inputs, sheet, ratio, cup.radius, flat))?;
    Ok(sizes)
}
