//! How large what was drawn is, and the sizes of the placeholders beside it.

use super::draft::Draft;
use crate::assess::design::Picked;
use crate::assess::size::WIDTHS;
use crate::model::tool_sizes::{across, extent, gap, mouth, shoulder_end, throat};
use crate::model::{Motion, Role, Tool};
use crate::units::{mm, rounded};
use std::ops::RangeInclusive;

/// Thickness where nothing else is said \[mm\].
const THICKNESS: f64 = 1.0;
/// Clearance over thickness that a placeholder thickness leaves [–].
const CLEARANCE: f64 = 1.25;
/// Clearance over thickness above which the thickness, or the drawing's unit, is doubted [–].
const WIDE: f64 = 3.0;
/// Width of a drawing below which its unit is doubted \[mm\]: inches that are read as mm make most parts smaller.
const NARROW: f64 = 10.0;
/// Thicknesses of sheets for which a gap is drawn, outside of which the unit is doubted \[mm\].
const THICKNESSES: RangeInclusive<f64> = 0.2..=6.0;
/// Largest draw ratio of a placeholder blank [–].
const RATIO: f64 = 1.8;
/// Travel over the punch's size [–], of a sheet that is drawn in and of one that is clamped and only stretched.
const TRAVEL: [f64; 2] = [0.5, 0.25];

/// Sizes of the sheet and the punch's travel \[mm\], placeholders where nobody gave them; once the tools are known.
pub(super) struct Sizes {
    pub thickness: Picked,
    pub blank: Picked,
    pub travel: Option<Picked>,
}

/// A placeholder \[mm\], and where it comes from.
fn placeholder(value: f64, from: &str) -> Picked {
    Picked { value, why: from.to_owned() }
}

impl Draft<'_> {
    /// Throat less punch \[mm\], where all of the punch would go in.
    fn clearance(&self) -> Option<f64> {
        let (punch, die) = (self.tool(Role::Punch)?, self.tool(Role::Die)?);
        Some(throat(&die)? - extent(&punch).1).filter(|clearance| *clearance > 0.0)
    }

    /// Twice the largest r of all tools \[mm\].
    fn width(&self) -> f64 {
        let tools = Role::ALL.iter().filter_map(|role| self.tool(*role));
        2.0 * tools.map(|tool| extent(&tool).1).fold(0.0, f64::max)
    }

    /// How large the tools are, which shows a wrong unit at once: `punch radius 30 mm, die throat 31.25 mm, 180 mm wide in all`.
    pub fn size(&self) -> String {
        let half = across(self.geometry);
        let tools: Vec<Tool> = Role::ALL.iter().filter_map(|role| self.tool(*role)).collect();
        let mut said: Vec<String> = tools
            .iter()
            .filter_map(|tool| match tool.role {
                Role::Punch => Some(format!("punch {half} {} mm", mm(extent(tool).1))),
                Role::Die => throat(tool).map(|throat| format!("die throat {half} {} mm", mm(throat))),
                Role::Holder => None,
            })
            .collect();
        said.push(format!("{} mm wide in all", mm(self.width())));
        said.join(", ")
    }

    /// What hardly fits a sheet, and may come from a wrong unit: the drawing's width, the thickness that its gap has room
    /// for, a gap that is wide for the sheet.
    pub fn doubts(&self) -> Vec<String> {
        [self.odd_width(), self.odd_thickness(), self.wide_gap()].into_iter().flatten().collect()
    }

    fn odd_width(&self) -> Option<String> {
        let width = self.width();
        (!(NARROW..=*WIDTHS.end()).contains(&width))
            .then(|| format!("the tools are {} mm wide in all, which is odd for a stamping: check --units", mm(width)))
    }

    fn odd_thickness(&self) -> Option<String> {
        let thickness = self.sizes().thickness;
        (!thickness.is_given() && !THICKNESSES.contains(&thickness.value)).then(|| {
            let mm = mm(thickness.value);
            format!("the gap between punch and die has room for a sheet of {mm} mm, which is odd: check --units and --thickness")
        })
    }

    fn wide_gap(&self) -> Option<String> {
        let (clearance, thickness) = (self.clearance()?, self.sizes().thickness);
        let placeholder = if thickness.is_given() { "" } else { ", a placeholder" };
        (clearance > WIDE * thickness.value).then(|| {
            format!(
                "the drawing leaves {} mm between punch and die, {:.1} times the sheet's thickness of {} mm{placeholder}: check \
                 --units and --thickness",
                mm(clearance),
                clearance / thickness.value,
                mm(thickness.value)
            )
        })
    }

    pub(super) fn tool(&self, role: Role) -> Option<Tool> {
        let (_, profile, _) = self.tools.iter().find(|(tool, ..)| *tool == role)?;
        Some(Tool { role, profile: (*profile).clone(), friction: 0.0.into(), motion: Motion::Fixed })
    }

    pub(super) fn sizes(&self) -> Sizes {
        let (punch, die) = (self.tool(Role::Punch), self.tool(Role::Die));
        let thickness = Picked::or(self.thickness, || {
            match self.clearance().map(|clearance| rounded((clearance / CLEARANCE * 100.0).floor() / 100.0)) {
                Some(fits) if fits > 0.0 && fits < THICKNESS => {
                    placeholder(fits, "what the gap between punch and die has room for")
                }
                _ => placeholder(THICKNESS, "the drawing has no sheet"),
            }
        });
        let within = self.blank.unwrap_or_else(|| self.reach());
        let travel = punch
            .as_ref()
            .map(|punch| Picked::or(self.travel, || travel_for(punch, die.as_ref(), thickness.value, within)));
        let drawn = punch.as_ref().zip(travel.as_ref()).map(|(punch, travel)| mouth(punch, travel.value));
        let blank = Picked::or(self.blank, || self.blank_for(drawn, die.as_ref()));
        Sizes { thickness, blank, travel }
    }

    /// How far from the axis die and holder both are drawn, or else the punch \[mm\].
    fn reach(&self) -> f64 {
        let outer = |role| self.tool(role).map(|tool| extent(&tool).1);
        let face = [outer(Role::Die), outer(Role::Holder)].into_iter().flatten().reduce(f64::min);
        face.or_else(|| outer(Role::Punch)).unwrap_or(0.0)
    }

    /// As far as all of die and holder reach, but no more than is drawn in one draw.
    fn blank_for(&self, size: Option<f64>, die: Option<&Tool>) -> Picked {
        let Some(die) = die else {
            return placeholder(rounded(1.2 * size.unwrap_or(50.0)), "a little more than the punch");
        };
        let reach = self.reach();
        let down = |mm: f64| rounded((mm * 10.0).floor() / 10.0);
        match size.map(|size| down(RATIO * size)) {
            Some(drawn) if drawn < reach && drawn > shoulder_end(die) => placeholder(drawn, "1.8 times the punch"),
            _ => placeholder(down(reach), "as far as die and holder are drawn"),
        }
    }
}

/// A share of the punch's size, or what its drawn height and the die's bottom leave room for.
fn travel_for(punch: &Tool, die: Option<&Tool>, thickness: f64, blank: f64) -> Picked {
    let height = (punch.profile.last().y - punch.profile.first().y).abs();
    let size = TRAVEL[usize::from(die.is_none())] * extent(punch).1;
    let most = if height > thickness { size.min(height) } else { size };
    // Both where they touch the flat sheet.
    let placed = |tool: &Tool, highest: bool, z: f64| {
        let touching = tool.profile.extreme(highest, blank).map_or(0.0, |p| p.y);
        Tool { profile: tool.profile.shifted(z - touching), ..tool.clone() }
    };
    let punch = placed(punch, true, -0.5 * thickness);
    let free = |travel: &f64| {
        die.is_none_or(|die| gap(&punch, &placed(die, false, 0.5 * thickness), *travel).distance >= thickness)
    };
    let digits = |mm: f64| rounded((mm * 10.0).floor() / 10.0).max(rounded(mm.min(0.1)));
    let share = (1..=20).rev().map(|i| digits(most * f64::from(i) / 20.0)).find(free);
    placeholder(share.unwrap_or_else(|| digits(most)), "a moderate one that the tools have room for")
}
