//! Every iteration of the corrector, for studying convergence.

use crate::solution::IterationRecord;
use crate::table::{Column, Table, Unit};

/// One row per iteration, of rejected steps too.
pub fn table(iterations: &[IterationRecord]) -> Table {
    let column = |key, label, unit, value: fn(&IterationRecord) -> f64| {
        Column::new(key, label, unit, iterations.iter().map(value).collect())
    };
    Table::new(vec![
        column("step", "Step", Unit::None, |i| i.step as f64),
        column("travel", "Punch travel", Unit::Mm, |i| i.travel),
        column("iteration", "Iteration", Unit::None, |i| i.iteration as f64),
        column("velocity_norm", "Relative velocity increment", Unit::None, |i| i.velocity_norm),
        column("residual_norm", "Relative residual", Unit::None, |i| i.residual_norm),
        column("cut", "Share of the increment taken", Unit::None, |i| i.cut),
        column("active_contacts", "Active contacts", Unit::None, |i| i.active_contacts as f64),
    ])
}
