//! Studies: many evaluations of one case, and what they say.
//!
//! ```text
//! BaseCase      the case, read once; a design is the case with further overrides
//! Variable      a key and its values: tools.die.shoulder=4..10 mm/7
//! Design        a point of a study; Run: its row; RunTable: all rows, as CSV
//! Study         a kind of study: the next designs, and the report of all runs
//! evaluate      the engine; TableFile: its rows on the disk, resumed after any end
//! Shard         a share of a study that runs by itself; merge joins the tables
//! StudyReport   headline, notes, tables, charts
//! Sweep LimitSearch Scatter        the kinds of study
//! verify        error bars of all numbers, from finer runs
//! fit           hardening laws and keys of a case from measurements
//! compare       several runs and measured curves side by side
//! ```

mod base_case;
mod bracket;
mod charts;
pub mod compare;
mod condition;
mod error;
mod evaluate;
pub mod fit;
mod goals;
mod measured_curve;
mod report;
mod run;
mod run_table;
mod scatter;
mod search;
mod statistics;
mod study_file;
mod sweep;
mod table_file;
mod uncertain_variable;
mod variable;
pub mod verify;

pub use crate::assess::FailureMode;
pub use base_case::BaseCase;
use base_case::short_hash;
pub use bracket::{Bracket, Side};
pub use condition::Condition;
pub use error::StudyError;
use error::fail;
pub use evaluate::{EarlierRuns, Evaluation, Plan, Study, begin, evaluate, parallel_map};
pub use measured_curve::measured_curve;
pub use report::{Cell, ReportTable, StudyReport};
pub use run::{Design, Evaluated, Run};
pub use run_table::RunTable;
pub use scatter::{Event, Scatter, Spread, UncertaintyResult};
pub use search::{LimitSearch, SearchRequest};
pub use statistics::quantile;
use study_file::StudyFile;
pub use sweep::{Sensitivity, Sweep};
pub use table_file::{Shard, TableFile, merge};
use variable::Variable;
pub use verify::Watch;
