//! The verdict on a run: what a die designer asks, each answer with its limit, where that comes from and what to change.

mod stop;
mod thinning;

use crate::case::Case;
use crate::solver::Pass;
use crate::table::Unit;
use serde::Serialize;

/// How a finding stands to its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Light {
    /// Within the limit.
    Green,
    /// Near it, or a guess that matters.
    Amber,
    /// Beyond it.
    Red,
}

/// One line of the verdict.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Name in JSON: `thinning`.
    pub key: &'static str,
    /// Name in tables: `Thinning`.
    pub label: &'static str,
    pub light: Light,
    /// The number, in `unit`; `None` where words say it.
    pub value: Option<f64>,
    #[serde(skip)]
    pub unit: Unit,
    /// The number or the words, with the unit, and where.
    pub found: String,
    /// The limit in words, with its unit.
    pub limit: String,
    /// Where the limit comes from; a declared rule of thumb is called so.
    pub source: &'static str,
    /// What to change; empty where all is well.
    pub advice: String,
}

/// Every finding on a case's run, in the order of the questions: tears, wrinkles, press, tools, trust.
pub fn judge(case: &Case, passes: &[Pass]) -> Vec<Finding> {
    [stop::judge(passes), thinning::judge(case, passes)].into_iter().flatten().collect()
}
