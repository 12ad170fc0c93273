//! Studies: many evaluations of one case, and what they say.
//!
//! A [`Study`] is a plan over the variables of a [`BaseCase`]: [`Sweep`], [`LimitSearch`] or [`Scatter`]. [`evaluate()`] runs
//! its [`Design`]s into the rows of a [`RunTable`], which a [`TableFile`] keeps on the disk; its report is a [`StudyReport`].
//! [`verify`] gives error bars from finer runs, [`fit`] laws and keys from measurements, [`compare`] runs side by side.

mod advice;
mod base_case;
mod bracket;
mod charts;
pub mod compare;
mod condition;
mod error;
mod evaluate;
pub mod fit;
mod folder;
mod goals;
mod measured_curve;
mod report;
mod run;
mod run_table;
mod scatter;
mod search;
mod study_file;
mod sweep;
mod table_file;
mod uncertain_variable;
mod variable;
mod verdict;
pub mod verify;

pub use crate::assess::FailureMode;
use crate::assess::{self, Light, error_bars::Number, error_bars::Origin};
use crate::case::{self, Case, Solution, files, files::Disk, files::Files};
pub use crate::numerics::statistics::quantile;
use crate::plot::chart::Chart;
use crate::results::csv::records;
use crate::units::{Amount, Unit, did_you_mean, joined, parse, rounded, significant};
pub use base_case::BaseCase;
use base_case::short_hash;
pub use bracket::{Bracket, Side};
pub use condition::Condition;
pub use error::StudyError;
use error::{Result, ensure, fail};
pub use evaluate::{EarlierRuns, Evaluation, Plan, Study, begin, evaluate, parallel_map};
pub use folder::study_folder;
pub use measured_curve::measured_curve;
pub use report::{Cell, ReportTable, StudyReport};
pub use run::{Design, Evaluated, Run};
pub use run_table::RunTable;
pub use scatter::{Event, Scatter, Spread};
pub use search::{LimitSearch, SearchRequest};
use std::{collections::BTreeMap, collections::BTreeSet, path::Path, path::PathBuf};
use study_file::StudyFile;
pub use sweep::{Sensitivity, Sweep};
pub use table_file::{Shard, TableFile, merge};
use variable::{Variable, in_unit, in_words, number, split_pair, written};
pub use verdict::judge;
pub use verify::Watch;
