//! Shape, thickness, strains and stresses over the blank at the kept frames.

use super::StageView;
use crate::model::Model;
use crate::solver::solution::{ElementRecord, Frame};
use crate::table::fields::element::{
    BENDING, POROSITY, R, S0, STRAIN_EQUIVALENT, STRAIN_EQUIVALENT_MAX, STRAIN_HOOP, STRAIN_MERIDIONAL,
    STRAIN_THICKNESS, STRESS_HOOP, STRESS_MERIDIONAL, TEMPERATURE, THICKNESS, Z,
};
use crate::table::fields::step::TRAVEL;
use crate::table::{Field, Table};

/// Fields of an element apart from its place; porosity and temperature if the model has them.
pub(super) fn fields(model: &Model) -> Vec<Field<ElementRecord>> {
    let mut fields = vec![
        THICKNESS,
        STRAIN_MERIDIONAL,
        STRAIN_HOOP,
        STRAIN_THICKNESS,
        STRAIN_EQUIVALENT,
        STRESS_MERIDIONAL,
        STRESS_HOOP,
        STRAIN_EQUIVALENT_MAX,
        BENDING,
    ];
    fields.extend(model.material.gtn.map(|_| POROSITY));
    fields.extend(model.heat.as_ref().map(|_| TEMPERATURE));
    fields
}

/// One row per frame and element, from the axis outward.
pub fn table(model: &Model, frames: &[Frame]) -> Table {
    let travel = frames.iter().flat_map(|f| std::iter::repeat_n(f.travel, f.elements.len())).collect();
    let column =
        |field: Field<ElementRecord>| field.column(model.extent(), frames.iter().flat_map(|frame| &frame.elements));
    let columns = [S0, R, Z].into_iter().chain(fields(model)).map(column);
    Table::new(std::iter::once(TRAVEL.filled(model.extent(), travel)).chain(columns).collect())
}

pub(super) fn of(view: &StageView) -> Option<Table> {
    Some(table(view.model(), &view.stage.frames))
}
