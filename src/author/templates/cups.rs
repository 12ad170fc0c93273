//! Cups: flat-bottomed and drawn until no flange is left, or hemispherical or conical with a flange.

use super::sizes::Draw;
use super::*;
use crate::case::parse;
use crate::measure::part_height;
use crate::solver;
use rules::TWO_DRAWS;
use std::f64::consts::{FRAC_PI_2, PI};

/// Runs that correct the trim; the third is for the flattest cups.
pub(super) const RUNS: usize = 3;

/// Sizes of a cup \[mm\].
pub(super) struct Cup {
    pub radius: f64,
    pub nose: Picked,
    pub height: f64,
    /// Height that the blank is made for, over the wanted one, less 1 \[–\].
    pub trim: Picked,
}

impl Cup {
    pub fn read(inputs: &Inputs, sheet: &Sheet, trim: Picked) -> Result<Self, CaseError> {
        let [radius, height] = inputs.values(["punch-radius", "height"]);
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
pub(super) fn cup(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    if let Some(trim) = inputs.number("trim") {
        return with_trim(inputs, sheet, Picked::input(trim));
    }
    let mut trim = declared_trim();
    for _ in 0..RUNS {
        let text = with_trim(inputs, sheet, trim.clone())?.fill(find("cup")?.text);
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
    let or = match cup.blank_for(cup.height, t) > TWO_DRAWS * cup.radius {
        true => "a smaller --trim or a larger --punch-radius",
        false => "a smaller --trim; or draw twice: stampflow new redraw",
    };
    let ratio = draw_ratio(|height| cup.blank_for(height, t), cup.height, cup.radius, 1, or)?;
    let shoulder = inputs.pick("shoulder", || rules::drawn_shoulder(t, ratio, sheet.r_value()));
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let travel = rules::drawn_travel(cup.height, shoulder.value, t);
    let draw = Draw { punch: cup.radius, corner: cup.nose.value, ratio, clearance, shoulder, blank: cup.blank(t) };
    let (mut sizes, _) = draw.values(inputs, sheet, ratio)?;
    sizes.set("wall_height", plain(cup.height), "");
    sizes.lengths([("radius", &Picked::input(cup.radius)), ("nose", &cup.nose), ("travel", &travel)]);
    Ok(sizes)
}

pub(super) fn hemispherical(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [radius, height, flange] = inputs.values(["punch-radius", "height", "flange"]);
    let what = || format!("a depth of {} is less than half the punch's radius: no cup, but a dome", plain(height));
    ensure(height >= 0.5 * radius, what, "make --height larger, or stretch it: stampflow new stretch-dome")?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let middle = radius + 0.5 * t;
    let blank_for = |height: f64, clearance: f64| {
        let edge = radius + clearance + shoulder.value + flange;
        rules::blank_of(2.0 * PI * middle * height + PI * (edge * edge - middle * middle))
    };
    // The blank and the clearance depend on each other: the ratio is that of a clearance t.
    let ratio = draw_ratio(|height| blank_for(height, t), height, radius, 1, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let why = "half of D, D² = 4 d h + D_f² − d²: the mid-surface keeps its area (Guldin), flange diameter D_f";
    let blank = Picked::by(blank_for(height, clearance.value), why);
    let pressure_ratio = blank.value / radius;
    let draw = Draw { punch: radius, corner: f64::INFINITY, ratio, clearance, shoulder, blank };
    let (mut sizes, _) = draw.values(inputs, sheet, pressure_ratio)?;
    sizes.lengths([("radius", &Picked::input(radius)), ("travel", &Picked::by(height, "the depth that is wanted"))]);
    Ok(sizes)
}

pub(super) fn conical(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [mouth, angle, height, flange] = inputs.values(["punch-radius", "angle", "height", "flange"]);
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    let bottom = mouth - height * angle.tan();
    let nose_width = nose.value * (0.5 * (FRAC_PI_2 - angle)).tan();
    let what = || {
        let (degrees, [height, mouth, bottom, nose]) =
            (angle.to_degrees(), [height, mouth, bottom, nose_width].map(plain));
        format!(
            "a wall at {degrees:.1}° to the axis and {height} deep narrows from {mouth} at the mouth to {bottom} at the bottom, \
             where the nose takes {nose}"
        )
    };
    let help = "make --height, --angle or --nose smaller, or --punch-radius larger";
    ensure(angle < 80f64.to_radians() && bottom >= nose_width, what, help)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let blank_for = |height: f64, clearance: f64| {
        let bottom = mouth - height * angle.tan();
        let edge = mouth + clearance + shoulder.value + flange;
        let side = height / angle.cos();
        rules::blank_of(PI * bottom * bottom + PI * side * (bottom + mouth) + PI * (edge * edge - mouth * mouth))
    };
    let ratio = draw_ratio(|height| blank_for(height, t), height, mouth, 1, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let why =
        "half of D, D² = d₁² + 2 s (d₁ + d₂) + D_f² − d₂²: bottom, cone of side s and flange keep their area (Guldin)";
    let blank = Picked::by(blank_for(height, clearance.value), why);
    let pressure_ratio = blank.value / mouth;
    let draw = Draw { punch: mouth, corner: nose.value, ratio, clearance, shoulder, blank };
    let (mut sizes, _) = draw.values(inputs, sheet, pressure_ratio)?;
    let punch = cone(bottom - nose_width, mouth, height, nose.value, angle);
    sizes.set("profile", punch, &nose.reason("nose: "));
    sizes.lengths([("travel", &Picked::by(height, "the depth that is wanted"))]);
    Ok(sizes)
}

/// Punch: flat, nose, cone up to the mouth, and a straight wall below it.
fn cone(flat: f64, mouth: f64, depth: f64, nose: f64, angle: f64) -> String {
    let nose_end = Point::new(flat + nose * angle.cos(), -nose + nose * angle.sin());
    let steps = [
        (Point::new(flat, 0.0), None),
        (nose_end, Some((Point::new(flat, -nose), false))),
        (Point::new(mouth, -depth), None),
        (Point::new(mouth, -4.0 * depth), None),
    ];
    profile_text(Point::zeros(), &steps, mm)
}
