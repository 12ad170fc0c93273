//! Rigid tools: sections, friction and motion.

use super::Friction;
use crate::geometry::{Point, Profile};
use crate::numerics::PiecewiseLinear;

/// Rigid tool, drawn where it touches the flat blank with its mid-surface at z = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    /// Role.
    pub role: Role,
    /// Section, the sheet on its left \[mm\].
    pub profile: Profile,
    /// Friction between it and the sheet.
    pub friction: Friction,
    /// Motion.
    pub motion: Motion,
}

/// Role of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Below the sheet, forms it towards +z.
    Punch,
    /// Above the sheet.
    Die,
    /// Below the sheet, holds its flange against the die.
    Holder,
    /// Above the sheet, holds its bottom against the punch.
    Pad,
    /// Further tool above the sheet, by its number among all further ones.
    #[serde(skip)]
    Upper(u8),
    /// Further tool below the sheet.
    #[serde(skip)]
    Lower(u8),
}

impl Role {
    /// The common tools, in the order of tables.
    pub const ALL: [Role; 4] = [Role::Punch, Role::Die, Role::Holder, Role::Pad];

    /// Name in tables, plots and case files; a further tool has [its own](super::Model::name_of).
    pub fn name(self) -> &'static str {
        ["punch", "die", "holder", "pad", "further tool"][self.index().min(Self::ALL.len())]
    }

    /// Place in the order of tables; further tools come after the common ones.
    pub fn index(self) -> usize {
        match self {
            Self::Punch => 0,
            Self::Die => 1,
            Self::Holder => 2,
            Self::Pad => 3,
            Self::Upper(number) | Self::Lower(number) => Self::ALL.len() + usize::from(number),
        }
    }

    /// Number of a further tool.
    pub fn further(self) -> Option<usize> {
        self.index().checked_sub(Self::ALL.len())
    }

    /// Side of the sheet on which it lies: 1 above, −1 below.
    pub fn side(self) -> f64 {
        if matches!(self, Role::Die | Role::Pad | Role::Upper(_)) { 1.0 } else { -1.0 }
    }
}

/// Motion of a tool.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// Stands still.
    Fixed,
    /// Moves along z with the travel.
    Travel,
    /// Displaced along z by this curve over the punch travel \[mm over mm\], which begins at 0.
    Course(PiecewiseLinear),
    /// Displaced by this vector over the run \[mm\], in proportion to its travel, or to time without travel.
    Path(Point),
    /// Stands still at this distance from the die's face \[mm\]: a holder on distance blocks.
    Gap(f64),
    /// Pressed towards the sheet; its position is an unknown.
    Pressed(Press),
}

impl Motion {
    /// Displacement at a travel of the `whole` one \[mm\]; none of a tool that stands or is pressed.
    pub fn displacement(&self, travel: f64, whole: f64) -> Point {
        match self {
            Self::Travel => Point::new(0.0, travel),
            Self::Course(course) => Point::new(0.0, course.at(travel)),
            Self::Path(way) => *way * (travel / whole),
            Self::Fixed | Self::Gap(_) | Self::Pressed(_) => Point::zeros(),
        }
    }
}

/// Force of a pressed holder or pad: F = F₀(travel) − c w, with w its move towards the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Press {
    /// F₀ over the punch travel, of the whole part \[N, or N/mm, over mm\].
    pub force: PiecewiseLinear,
    /// Stiffness c of springs or cushion \[N/mm, or N/mm²\]; 0 for a force independent of position.
    pub stiffness: f64,
}

impl Press {
    /// Constant force \[N, or N/mm\].
    pub fn constant(force: f64) -> Self {
        Self { force: force.into(), stiffness: 0.0 }
    }

    /// True if it never presses.
    pub fn is_idle(&self) -> bool {
        self.force.largest() <= 0.0 && self.stiffness == 0.0
    }
}
