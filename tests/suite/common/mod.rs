//! What several files of tests use.

pub mod cli;
pub mod convergence;
pub mod coverage;
pub mod files;
pub mod page;
pub mod prelude;
#[allow(dead_code, reason = "the benchmark of the campaign also prints the process")]
pub mod random_die;
#[path = "../../../benches/common/random_template.rs"]
pub mod random_template;
#[allow(dead_code, reason = "the benchmark of the campaign also prints the kind")]
pub mod random_work;
pub mod shipped;
pub mod simple;
