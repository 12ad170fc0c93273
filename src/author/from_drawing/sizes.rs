//! Sizes of drawn tools, and placeholders for the sizes that no drawing has.

use super::Import;
use crate::geometry::Point;
use crate::import::{ImportError, Operation, Result, Sections};
use crate::material::Material;
use crate::model::tool_sizes::{extent, gap, has_room, met, mouth, shoulder_end, throat};
use crate::model::{Geometry, Motion, Role, Tool, operation_in};
use crate::rules::{Metal, Picked, drawn_travel, filling_pressure, siebel, strip_pressure, tensile_strength};
use crate::table::worded;
use crate::units::{joined, rounded, trimmed};

/// Placeholder thickness \[mm\].
const THICKNESS: f64 = 1.0;
/// Clearance over a placeholder thickness [–].
const CLEARANCE: f64 = 1.25;
/// Clearance over thickness above which thickness and unit are doubted [–].
const WIDE: f64 = 3.0;
/// Largest draw ratio of a placeholder blank [–].
const RATIO: f64 = 1.8;
/// Placeholder travel over the punch's size [–].
const TRAVEL: f64 = 0.5;

/// Tools of one operation, and sizes of the sheet and the punch's travel \[mm\].
pub(super) struct DrawnTools {
    pub geometry: Geometry,
    /// `None` where oil presses the sheet into the die.
    pub punch: Option<Tool>,
    /// `None` where a tube is formed without one.
    pub die: Option<Tool>,
    pub holder: Option<Tool>,
    /// Least and largest z of a tube \[mm\], whose outside radius is the blank's; in the case the largest is 0.
    pub tube: Option<[f64; 2]>,
    pub thickness: Picked,
    pub blank: Picked,
    pub travel: Picked,
    /// Travel after which the tools stand as drawn \[mm\]; `None` if they are drawn open.
    pub drawn: Option<f64>,
    /// True if the formed sheet lies wholly beyond the die's shoulder.
    pub is_through: bool,
}

pub(super) fn placeholder(value: f64, why: &str) -> Picked {
    Picked::by(value, format!("placeholder: {why}; change it"))
}

fn down(mm: f64) -> f64 {
    rounded((mm * 10.0).floor() / 10.0)
}

impl DrawnTools {
    /// Tools of an operation. Fails without a punch, but of a blank that oil presses, and without a die, but of a tube.
    pub fn new(import: &Import, sections: &Sections, operation: &Operation, before: Option<&Self>) -> Result<Self> {
        let tool = |role: Role| {
            let profile = operation.tool(role)?.profile.clone();
            Some(Tool { role, profile, friction: 0.0.into(), motion: Motion::Fixed })
        };
        let missing = |role: Role| {
            let is_own = |layer: &&String| operation.number.is_some() && operation_in(layer) == operation.number;
            let layer = sections.others.iter().find(is_own).map_or("NAME", String::as_str);
            let what = format!("{} has no {}: there are {}", operation.name(), role.name(), sections.layers);
            let help = format!("draw its side towards the sheet, or name its layer: --layer {layer}={}", role.name());
            ImportError { what, help, line: None }
        };
        let ([punch, die, holder], tube) = ([Role::Punch, Role::Die, Role::Holder].map(tool), sections.tube);
        let is_pressed = die.is_some() && sections.blank.is_some() && sections.operations.len() == 1;
        let lacks = [(Role::Punch, punch.is_none() && !is_pressed), (Role::Die, die.is_none() && tube.is_none())];
        lacks.into_iter().find(|(_, lacks)| *lacks).map_or(Ok(()), |(role, _)| Err(missing(role)))?;
        let drawn_die = die.as_ref().filter(|_| tube.is_none() && punch.is_some());
        let shoulder = drawn_die.and_then(|die| die.profile.extreme(false, [0.0, throat(die)? + 1e-6]));
        let is_beyond = |end| shoulder.is_some_and(|shoulder| end >= shoulder.y);
        let is_pushed = || import.overrides.iter().any(|set| set == "stop.drawn_through=true");
        let is_through = operation.sheet_end.map_or_else(is_pushed, is_beyond);
        let geometry = import.geometry.unwrap_or(sections.geometry);
        let [thickness, blank, travel] = [(); 3].map(|()| Picked::input(0.0));
        let mut tools = Self { geometry, punch, die, holder, tube, thickness, blank, travel, drawn: None, is_through };
        let drawn = |i: usize| sections.blank.map(|sizes| sizes[i]);
        let thickness = before.map(|before| before.thickness.value).or(import.thickness).or(drawn(2));
        tools.thickness = Picked::or(thickness, || tools.thickness_for());
        let edge = before.map(|before| before.blank.value).or(import.blank).or(drawn(1));
        let within = [drawn(0).unwrap_or(0.0), edge.unwrap_or_else(|| tools.reach())];
        let direct = before.filter(|before| !tools.is_reverse(before));
        let has_sheet = operation.sheet_end.is_some();
        let into_tube = tools.travel_into(within[1], has_sheet).filter(|_| before.is_none());
        tools.drawn = into_tube.or_else(|| tools.drawn_travel(within, direct, has_sheet));
        tools.travel = Picked::or(import.travel.filter(|_| before.is_none()), || tools.travel_for(within[1]));
        tools.blank = Picked::or(edge, || tools.blank_for());
        Ok(tools)
    }

    /// True if the die stands inside the part before, which is turned over.
    pub fn is_reverse(&self, before: &Self) -> bool {
        self.die.iter().zip(&before.punch).any(|(die, punch)| extent(die).1 < extent(punch).1)
    }

    /// Travel from where the punch touches the tube of this radius outside \[mm\].
    fn travel_into(&self, outside: f64, has_sheet: bool) -> Option<f64> {
        let (thickness, punch, [low, high]) = (self.thickness.value, self.punch.as_ref()?, self.tube?);
        let wall = |share: f64| (Point::new(outside - 0.5 * thickness, low + share * (high - low)), 0.5 * thickness);
        let wall: Vec<_> = (0..=100).map(|i| wall(0.01 * f64::from(i))).collect();
        let travel = -met(&punch.profile, punch.role.side(), &wall, [thickness, 0.0]);
        (travel > if has_sheet { 0.0 } else { thickness }).then_some(travel)
    }

    /// From the flat sheet, a part turned over, or the punch before. Without a sheet, tools leave room.
    fn drawn_travel(&self, within: [f64; 2], before: Option<&Self>, has_sheet: bool) -> Option<f64> {
        let (punch, die) = (self.punch.as_ref()?, self.die.as_ref().filter(|_| self.tube.is_none())?);
        let top = |tools: &Self| Some(tools.punch.as_ref()?.profile.extreme(true, within)?.y);
        let (thickness, end) = (self.thickness.value, top(self)?);
        let flat = die.profile.extreme(false, within)?.y - thickness;
        let travel = end - before.map_or(Some(flat), |before| before.drawn.and_then(|_| top(before)))?;
        let height = (punch.profile.last().y - punch.profile.first().y).abs();
        let has_room = || travel <= height && gap(punch, die, 0.0).0 >= thickness;
        (travel.min(end - flat) > 0.0 && (has_sheet || travel > thickness && has_room())).then_some(travel)
    }

    /// Size of the punch where it enters the sheet at its full travel \[mm\]; the blank's without one.
    pub fn mouth(&self) -> f64 {
        self.punch.as_ref().map_or(self.blank.value, |punch| mouth(punch, self.travel.value))
    }

    /// Throat less punch \[mm\], where the whole punch fits in.
    fn clearance(&self) -> Option<f64> {
        Some(throat(self.die.as_ref()?)? - extent(self.punch.as_ref()?).1).filter(|clearance| *clearance > 0.0)
    }

    /// Sizes in words, which show a wrong unit: `punch radius 30 mm, die throat radius 31.25 mm, 180 mm wide in all`.
    pub fn size(&self) -> String {
        let half = worded(self.geometry, "radius", "half-width");
        let punch = self.punch.as_ref().map(|punch| ("punch", extent(punch).1));
        let throat = self.die.as_ref().and_then(|die| Some(("die throat", throat(die)?)));
        let sizes = punch.into_iter().chain(throat).map(|(what, mm)| format!("{what} {half} {} mm", trimmed(mm, 3)));
        let tools = [&self.punch, &self.die, &self.holder].into_iter().flatten();
        let reach = tools.map(|tool| extent(tool).1).fold(0.0, f64::max);
        joined(sizes.chain([format!("{} mm wide in all", trimmed(2.0 * reach, 3))]), ", ")
    }

    /// Clearance that hardly fits the sheet's thickness and may come from a wrong unit.
    pub fn gap_doubt(&self) -> Option<String> {
        let thickness = self.thickness.value;
        let clearance = self.clearance().filter(|clearance| *clearance > WIDE * thickness)?;
        let [gap, t, times] = [(clearance, 3), (thickness, 3), (clearance / thickness, 1)].map(|(n, d)| trimmed(n, d));
        let placeholder = if self.thickness.is_given() { "" } else { ", a placeholder" };
        let what = format!("punch and die are drawn {gap} mm apart, {times} times the sheet's thickness of {t} mm");
        Some(format!("{what}{placeholder}: check --unit and --thickness"))
    }

    /// The holder's pressure \[MPa\] and its rule.
    pub fn pressure(&self, metal: &Material) -> (f64, &'static str) {
        let (strength, ratio) = (tensile_strength(metal), self.blank.value / self.mouth());
        let (pressure, rule) = if self.geometry == Geometry::Axisymmetric && ratio > 1.0 {
            let siebel = siebel(ratio, 2.0 * self.mouth(), self.thickness.value, strength);
            (siebel.max(Metal::of(metal).pressure), "usual pressure of the metal, Siebel's if more")
        } else {
            (strip_pressure(strength).value, "1 % of the tensile strength")
        };
        (Picked::up(pressure, 0.01, "").value, rule)
    }

    /// Pressure of the oil that forms the sheet without a punch \[MPa\].
    pub fn oil(&self, metal: &Material) -> Option<Picked> {
        let (die, t) = (self.die.as_ref().filter(|_| self.punch.is_none())?, self.thickness.value);
        // Filled corners turn to the left.
        let cavity = die.profile.reversed();
        let filled = cavity.corners().map(|arc| [arc.radius, arc.at(0.0).x.max(arc.at(1.0).x)]);
        let [r, wide] = filled.min_by(|a, b| a[0].total_cmp(&b[0])).unwrap_or([self.blank.value; 2]);
        // Through an open die rises a dome as high as that of `new bulge`.
        let depth = throat(die).map_or((die.profile.last().y - die.profile.first().y).abs(), |throat| 0.4 * throat);
        let strain = self.tube.map_or((1.0 + 2.0 * depth / wide).ln(), |_| (extent(die).1 / self.blank.value).ln());
        let why = format!("σ t/r of the die's sharpest corner or the sheet, r = {} mm", trimmed(r, 3));
        Some(placeholder(filling_pressure(metal, strain, t, r), &why))
    }

    fn thickness_for(&self) -> Picked {
        let fits = self.clearance().map(|clearance| rounded((clearance / CLEARANCE * 100.0).floor() / 100.0));
        match fits.filter(|fits| *fits > 0.0 && *fits < THICKNESS) {
            Some(fits) => placeholder(fits, "what the gap between punch and die has room for"),
            None => placeholder(THICKNESS, "the drawing has no sheet"),
        }
    }

    /// Smaller reach of die and holder from the axis \[mm\].
    fn reach(&self) -> f64 {
        self.die.iter().chain(&self.holder).map(|tool| extent(tool).1).fold(f64::INFINITY, f64::min)
    }

    fn blank_for(&self) -> Picked {
        let (drawn, reach) = (down(RATIO * self.mouth()), self.reach());
        match drawn < reach && drawn > self.die.as_ref().map_or(0.0, shoulder_end) {
            true => placeholder(drawn, "1.8 times the punch"),
            false => placeholder(down(reach), "as far as die and holder are drawn"),
        }
    }

    fn travel_for(&self, blank: f64) -> Picked {
        let (thickness, die) = (self.thickness.value, self.die.as_ref().filter(|_| self.tube.is_none()));
        let Some(punch) = &self.punch else { return Picked::input(0.0) };
        if let Some(travel) = self.drawn {
            let shoulder = die.and_then(|die| Some(shoulder_end(die) - throat(die)?)).unwrap_or(0.0);
            let through = self.is_through.then(|| drawn_travel(travel, shoulder, thickness));
            return through.unwrap_or_else(|| Picked::by(travel, "as drawn"));
        }
        let height = (punch.profile.last().y - punch.profile.first().y).abs();
        let size = TRAVEL * self.tube.map_or(extent(punch).1, |_| blank);
        let most = if height > thickness { size.min(height) } else { size };
        let has_room = |travel: &f64| die.is_none_or(|die| has_room(punch, die, [blank, thickness], *travel));
        let digits = |mm: f64| down(mm).max(rounded(mm.min(0.1)));
        let share = (1..=20).rev().map(|i| digits(most * f64::from(i) / 20.0)).find(has_room);
        placeholder(share.unwrap_or_else(|| digits(most)), "a moderate one that the tools have room for")
    }
}
