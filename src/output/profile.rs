//! Shape, thickness, strains and stresses over the blank at the kept frames.

use super::{Subject, worded};
use crate::model::Model;
use crate::solution::{ElementRecord, Frame};
use crate::table::{Column, Table, Unit};
use crate::units::ZERO_CELSIUS;

/// One row per frame and element, from the axis outward; porosity and temperature where the model has them.
pub fn table(model: &Model, frames: &[Frame]) -> Table {
    let geometry = model.geometry;
    let travel = frames.iter().flat_map(|f| std::iter::repeat_n(f.travel, f.elements.len())).collect();
    let column = |key, label, unit, value: fn(&ElementRecord) -> f64| {
        Column::new(key, label, unit, frames.iter().flat_map(|f| &f.elements).map(value).collect())
    };
    let worded = |axisymmetric, plane_strain| worded(geometry, axisymmetric, plane_strain);
    let s0 = worded("Initial distance from the axis", "Initial distance from the symmetry plane");
    let r = worded("Distance from the axis", "Distance from the symmetry plane");
    let along = [worded("Meridional strain", "In-plane strain"), worded("Meridional stress", "In-plane stress")];
    let across = [worded("Hoop strain", "Out-of-plane strain"), worded("Hoop stress", "Out-of-plane stress")];
    let mut columns = vec![
        Column::new("travel", "Punch travel", Unit::Mm, travel),
        column("s0", s0, Unit::Mm, |e| e.s0),
        column("r", r, Unit::Mm, |e| e.r),
        column("z", "z, along punch travel", Unit::Mm, |e| e.z),
        column("thickness", "Thickness", Unit::Mm, |e| e.thickness),
        column("strain_meridional", along[0], Unit::None, |e| e.strain_meridional),
        column("strain_hoop", across[0], Unit::None, |e| e.strain_hoop),
        column("strain_thickness", "Thickness strain", Unit::None, |e| e.strain_thickness),
        column("strain_equivalent", "Equivalent strain", Unit::None, |e| e.strain_equivalent),
        column("stress_meridional", along[1], Unit::MPa, |e| e.stress_meridional),
        column("stress_hoop", across[1], Unit::MPa, |e| e.stress_hoop),
        column("strain_equivalent_max", "Largest equivalent strain", Unit::None, |e| e.strain_equivalent_max),
        column("bending", "Bending (1) or membrane (0)", Unit::None, |e| f64::from(u8::from(e.bends))),
    ];
    if model.material.voids.is_some() {
        columns.push(column("porosity", "Porosity", Unit::None, |e| e.porosity));
    }
    if model.heat.is_some() {
        columns.push(column("temperature", "Temperature", Unit::Celsius, |e| e.temperature - ZERO_CELSIUS));
    }
    Table::new(columns)
}

/// The last frame's rows; none when no frame was kept.
pub fn last(model: &Model, frames: &[Frame]) -> Table {
    table(model, &frames[frames.len().saturating_sub(1)..])
}

pub(super) fn of(subject: &Subject) -> Option<Table> {
    Some(table(subject.model, &subject.run.frames))
}
