//! Rigid tools: sections, friction and what moves them.

use super::Friction;
use crate::geometry::{Point, Profile};
use crate::numerics::PiecewiseLinear;

/// A rigid tool, drawn where it touches the flat blank (whose mid-surface is z = 0).
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    /// Which tool it is.
    pub role: Role,
    /// Its section, the sheet on its left \[mm\].
    pub profile: Profile,
    /// Friction between it and the sheet.
    pub friction: Friction,
    /// What moves it.
    pub motion: Motion,
}

/// Which tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[derive(schemars::JsonSchema)]
pub enum Role {
    /// Below the sheet, forms it towards +z.
    Punch,
    /// Above the sheet.
    Die,
    /// Below the sheet, holds its flange against the die.
    Holder,
}

impl Role {
    /// All tools, in the order of tables.
    pub const ALL: [Role; 3] = [Role::Punch, Role::Die, Role::Holder];

    /// The word used in tables, plots and case files.
    pub fn name(self) -> &'static str {
        match self {
            Role::Punch => "punch",
            Role::Die => "die",
            Role::Holder => "holder",
        }
    }
}

/// What moves a tool.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// Stands still.
    Fixed,
    /// Moves along z with the travel.
    Travel,
    /// Displaced by this vector (away from the axis, along z) over the run \[mm\], in proportion to its travel, or to its
    /// time where there is no travel.
    Path(Point),
    /// Stands still at this distance between its face and the die's \[mm\]: a holder on distance blocks.
    Gap(f64),
    /// Pressed towards the die; its position is an unknown.
    Pressed(Press),
}

/// How a holder is pressed: F = F₀(travel) − c w, with w its move towards the die.
#[derive(Clone, Debug, PartialEq)]
pub struct Press {
    /// F₀ over the punch travel, of the whole section as [`Extent`](super::Extent) has it \[N, or N/mm, over mm\].
    pub force: PiecewiseLinear,
    /// Stiffness c of the springs or the cushion, likewise \[N/mm, or N/mm²\]; 0 for a force that does not feel the
    /// position.
    pub stiffness: f64,
}

impl Press {
    /// A force that stays.
    pub fn constant(force: f64) -> Self {
        Self { force: force.into(), stiffness: 0.0 }
    }

    /// Whether nothing ever presses.
    pub fn is_idle(&self) -> bool {
        self.force.largest() <= 0.0 && self.stiffness == 0.0
    }
}
