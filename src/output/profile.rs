//! Shape, thickness, strains and stresses over the blank at the kept frames.

use super::Subject;
use crate::record::{ElementRecord, Frame};
use crate::table::{Column, Table, Unit};

/// One row per frame and element, from the axis outward.
pub fn table(frames: &[Frame]) -> Table {
    let travel = frames.iter().flat_map(|f| std::iter::repeat_n(f.travel, f.elements.len())).collect();
    let column = |key, label, unit, value: fn(&ElementRecord) -> f64| {
        Column::new(key, label, unit, frames.iter().flat_map(|f| &f.elements).map(value).collect())
    };
    Table::new(vec![
        Column::new("travel", "Punch travel", Unit::Mm, travel),
        column("s0", "Initial distance from the axis", Unit::Mm, |e| e.s0),
        column("r", "Distance from the axis", Unit::Mm, |e| e.r),
        column("z", "z, along punch travel", Unit::Mm, |e| e.z),
        column("thickness", "Thickness", Unit::Mm, |e| e.thickness),
        column("strain_meridional", "Meridional strain", Unit::None, |e| e.strain_meridional),
        column("strain_hoop", "Hoop strain", Unit::None, |e| e.strain_hoop),
        column("strain_thickness", "Thickness strain", Unit::None, |e| e.strain_thickness),
        column("strain_equivalent", "Equivalent strain", Unit::None, |e| e.strain_equivalent),
        column("stress_meridional", "Meridional stress", Unit::MPa, |e| e.stress_meridional),
        column("stress_hoop", "Hoop stress", Unit::MPa, |e| e.stress_hoop),
        column("strain_equivalent_max", "Largest equivalent strain", Unit::None, |e| e.strain_equivalent_max),
    ])
}

/// The last frame's rows; none when no frame was kept.
pub fn last(frames: &[Frame]) -> Table {
    table(&frames[frames.len().saturating_sub(1)..])
}

pub(super) fn of(subject: &Subject) -> Table {
    table(&subject.run.frames)
}
