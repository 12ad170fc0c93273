//! Studies: one case, run with many settings.
//!
//! ```text
//! Vary        a key and its values: tools.die.shoulder=4..10 mm/7
//! Plan        the case, what is varied, and every design by its index
//! run         designs on all cores → rows, in order
//! Row         a design, its numbers and lights, how it ended
//! Columns     its line in study.csv
//! Journal     study.csv on its way; goes on after any end
//! Shard       a part of a study that runs by itself; merge puts them together
//! file        a study as TOML
//! ```

mod error;
pub mod file;
mod hash;
mod journal;
mod plan;
mod row;
mod run;
mod shards;
mod vary;

pub use error::StudyError;
pub use journal::{Begun, Earlier, Journal};
pub use plan::{Design, Plan};
pub use row::{Columns, Row, Solved};
pub use run::{base, one, run};
pub use shards::{Shard, merge};
pub use vary::{Value, Vary};
