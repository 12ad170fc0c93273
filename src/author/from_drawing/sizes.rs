//! Sizes of drawn tools, and placeholders for the sizes that no drawing has.

use crate::assess::size::{THICKNESSES, WIDTHS};
use crate::import::{DrawingUnit, Section};
use crate::model::tool_sizes::{extent, has_room, mouth, shoulder_end, throat};
use crate::model::{Geometry, Motion, Role, Tool};
use crate::rules::Picked;
use crate::table::worded;
use crate::units::{rounded, trimmed};

/// Placeholder thickness \[mm\].
const THICKNESS: f64 = 1.0;
/// Clearance over a placeholder thickness [–].
const CLEARANCE: f64 = 1.25;
/// Clearance over thickness above which thickness and unit are doubted [–].
const WIDE: f64 = 3.0;
/// Largest draw ratio of a placeholder blank [–].
const RATIO: f64 = 1.8;
/// Travel over the punch's size [–], with a die and without.
const TRAVEL: [f64; 2] = [0.5, 0.25];

/// Tools of one operation, and sizes of the sheet and the punch's travel \[mm\].
#[derive(Clone)]
pub(super) struct DrawnTools<'a> {
    pub geometry: Geometry,
    pub sections: Vec<&'a Section>,
    pub thickness: Picked,
    pub blank: Picked,
    pub travel: Option<Picked>,
}

pub(super) fn placeholder(value: f64, why: &str) -> Picked {
    Picked { value, why: why.to_owned() }
}

fn down(mm: f64) -> f64 {
    rounded((mm * 10.0).floor() / 10.0)
}

impl<'a> DrawnTools<'a> {
    pub fn new(geometry: Geometry, sections: Vec<&'a Section>, given: [Option<f64>; 3]) -> Self {
        let (open, [thickness, blank, travel]) = (placeholder(0.0, ""), given);
        let mut tools = Self { geometry, sections, thickness: open.clone(), blank: open, travel: None };
        tools.thickness = Picked::or(thickness, || tools.thickness_for());
        let within = blank.unwrap_or_else(|| tools.reach());
        let punch = tools.tool(Role::Punch);
        tools.travel = punch.as_ref().map(|punch| Picked::or(travel, || tools.travel_for(punch, within)));
        tools.blank = Picked::or(blank, || tools.blank_for());
        tools
    }

    pub fn tool(&self, role: Role) -> Option<Tool> {
        let section = self.sections.iter().find(|section| section.role == role)?;
        Some(Tool { role, profile: section.profile.clone(), friction: 0.0.into(), motion: Motion::Fixed })
    }

    /// Size of the punch where it enters the sheet at its full travel \[mm\].
    pub fn mouth(&self) -> Option<f64> {
        Some(mouth(&self.tool(Role::Punch)?, self.travel.as_ref()?.value))
    }

    /// Throat less punch \[mm\], where the whole punch fits in.
    fn clearance(&self) -> Option<f64> {
        let (punch, die) = (self.tool(Role::Punch)?, self.tool(Role::Die)?);
        Some(throat(&die)? - extent(&punch).1).filter(|clearance| *clearance > 0.0)
    }

    /// Twice the largest r of all tools \[mm\].
    fn width(&self) -> f64 {
        let tools = Role::ALL.iter().filter_map(|role| self.tool(*role));
        2.0 * tools.map(|tool| extent(&tool).1).fold(0.0, f64::max)
    }

    /// Sizes in words, which show a wrong unit: `punch radius 30 mm, die throat radius 31.25 mm, 180 mm wide in all`.
    pub fn size(&self) -> String {
        let half = worded(self.geometry, "radius", "half-width");
        let punch = self.tool(Role::Punch).map(|punch| format!("punch {half} {} mm, ", trimmed(extent(&punch).1, 3)));
        let throat = self.tool(Role::Die).and_then(|die| throat(&die));
        let die = throat.map(|throat| format!("die throat {half} {} mm, ", trimmed(throat, 3)));
        format!("{}{}{} mm wide in all", punch.unwrap_or_default(), die.unwrap_or_default(), trimmed(self.width(), 3))
    }

    /// Sizes that hardly fit a sheet and may come from a wrong unit.
    pub fn doubts(&self, unit: DrawingUnit, has_drawn_thickness: bool) -> Vec<String> {
        let (width, is_given, thickness) = (self.width(), self.thickness.is_given(), self.thickness.value);
        let (mut doubts, t) = (Vec::new(), trimmed(thickness, 3));
        if !WIDTHS.contains(&width) {
            let is_mm = unit == DrawingUnit::MM;
            let (other, name) = if is_mm { (DrawingUnit::INCH, "inches") } else { (DrawingUnit::MM, "mm") };
            let mm = width / unit.1 * other.1;
            let other = WIDTHS.contains(&mm).then(|| format!("is it drawn in {name}, {mm:.0} mm wide? "));
            let what = format!("the tools are {} mm wide in all, which is odd for a stamping", trimmed(width, 1));
            doubts.push(format!("{what}: {}check --unit", other.unwrap_or_default()));
        }
        if has_drawn_thickness && !THICKNESSES.contains(&thickness) {
            doubts.push(format!("a sheet of {t} mm fits the drawing, which is odd: check --unit and --thickness"));
        }
        if let Some(clearance) = self.clearance().filter(|clearance| *clearance > WIDE * thickness) {
            let (gap, times) = (trimmed(clearance, 3), clearance / thickness);
            let placeholder = if is_given { "" } else { ", a placeholder" };
            let times = format!("{times:.1} times the sheet's thickness of {t} mm{placeholder}");
            let what = format!("the drawing leaves {gap} mm between punch and die, {times}");
            doubts.push(format!("{what}: check --unit and --thickness"));
        }
        doubts
    }

    fn thickness_for(&self) -> Picked {
        let fits = self.clearance().map(|clearance| rounded((clearance / CLEARANCE * 100.0).floor() / 100.0));
        match fits.filter(|fits| *fits > 0.0 && *fits < THICKNESS) {
            Some(fits) => placeholder(fits, "what the gap between punch and die has room for"),
            None => placeholder(THICKNESS, "the drawing has no sheet"),
        }
    }

    /// Smaller reach of die and holder from the axis, or else that of the punch \[mm\].
    fn reach(&self) -> f64 {
        let outer = |role| self.tool(role).map(|tool| extent(&tool).1);
        let face = [outer(Role::Die), outer(Role::Holder)].into_iter().flatten().reduce(f64::min);
        face.or_else(|| outer(Role::Punch)).unwrap_or(0.0)
    }

    /// A blank as far as die and holder reach, but no more than one draw takes.
    fn blank_for(&self) -> Picked {
        let punch = self.mouth();
        let Some(die) = self.tool(Role::Die) else {
            return placeholder(rounded(1.2 * punch.unwrap_or(50.0)), "a little more than the punch");
        };
        let reach = self.reach();
        match punch.map(|punch| down(RATIO * punch)) {
            Some(drawn) if drawn < reach && drawn > shoulder_end(&die) => placeholder(drawn, "1.8 times the punch"),
            _ => placeholder(down(reach), "as far as die and holder are drawn"),
        }
    }

    /// A share of the punch's size for which its drawn height and the die leave room.
    fn travel_for(&self, punch: &Tool, blank: f64) -> Picked {
        let (die, thickness) = (self.tool(Role::Die), self.thickness.value);
        let height = (punch.profile.last().y - punch.profile.first().y).abs();
        let size = TRAVEL[usize::from(die.is_none())] * extent(punch).1;
        let most = if height > thickness { size.min(height) } else { size };
        let has_room = |travel: &f64| die.as_ref().is_none_or(|die| has_room(punch, die, [blank, thickness], *travel));
        let digits = |mm: f64| down(mm).max(rounded(mm.min(0.1)));
        let share = (1..=20).rev().map(|i| digits(most * f64::from(i) / 20.0)).find(has_room);
        placeholder(share.unwrap_or_else(|| digits(most)), "a moderate one that the tools have room for")
    }
}
