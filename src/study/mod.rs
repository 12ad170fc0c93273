//! Studies: one case, run with many settings.
//!
//! ```text
//! Vary        a key and its values: tools.die.shoulder=4..10 mm/7
//! Plan        the case, what is varied, and every design by its index
//! run         designs on all cores → rows, in order
//! Row         a design, its numbers and lights, how it ended
//! Columns     its line in study.csv
//! ```

mod error;
mod plan;
mod row;
mod run;
mod vary;

pub use error::StudyError;
pub use plan::{Design, Plan};
pub use row::{Columns, Row, Solved};
pub use run::{one, run};
pub use vary::{Value, Vary};
