//! Studies: one case, run with many settings.
//!
//! ```text
//! Subject       the case, read once; a design is it with overrides
//! Vary          a key and its values: tools.die.shoulder=4..10 mm/7
//! Designs       every design of a study by its index; Plan: every combination of what is varied
//! side_by_side  many runs on all cores, handed on in order
//! run           designs on all cores → rows, in order
//! Row           a design, its numbers and lights, how it ended
//! Columns       its line in study.csv
//! Journal       study.csv on its way; goes on after any end
//! Shard         a part of a study that runs by itself; merge puts them together
//! file          a study as TOML
//! versus        several runs, and what was measured, side by side
//! ```

mod error;
pub mod file;
mod hash;
mod journal;
mod plan;
mod row;
mod run;
mod shards;
mod side_by_side;
mod subject;
mod vary;
pub mod versus;

pub use error::StudyError;
pub use journal::{Begun, Earlier, Journal};
pub use plan::{Design, Designs, Plan};
pub use row::{Columns, Row, Solved};
pub use run::{base, one, run};
pub use shards::{Shard, merge};
pub use side_by_side::side_by_side;
pub use subject::Subject;
pub use vary::{Value, Vary};
