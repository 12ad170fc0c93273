//! Table of a superplastic forming cycle: the gas pressure that holds the strain rate.

use super::StageView;
use crate::model::PressureCap;
use crate::plot::pressure_cycle::{CONTACT_SHARE, HEIGHT, PRESSURE, STRAIN_RATE};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::{Field, Table, Unit};

const TIME: Field<StepRecord> = Field::new("time", "Time", Unit::Second, |s| s.time);
const FIELDS: [Field<StepRecord>; 7] = [
    TIME,
    PRESSURE,
    STRAIN_RATE,
    HEIGHT,
    crate::table::fields::step::THINNEST,
    CONTACT_SHARE,
    Field::new("cap", "Cap in force: 0 none, 1 largest pressure, 2 its fastest rise", Unit::None, |s| match s.on_cap {
        None => 0.0,
        Some(PressureCap::Largest) => 1.0,
        Some(PressureCap::Rise) => 2.0,
    }),
];

/// Time on a cap of the pressure \[s\].
pub(super) fn time_on_a_cap(stage: &StageSolution) -> f64 {
    let before = std::iter::once(0.0).chain(stage.steps.iter().map(|s| s.time));
    stage.steps.iter().zip(before).filter(|(s, _)| s.on_cap.is_some()).map(|(s, before)| s.time - before).sum()
}

/// One row per accepted step.
pub(super) fn of(view: &StageView) -> Option<Table> {
    view.stage.steps.first().and(view.model().rate_control())?;
    Some(Table::new(FIELDS.iter().map(|field| field.column(view.extent(), &view.stage.steps)).collect()))
}
