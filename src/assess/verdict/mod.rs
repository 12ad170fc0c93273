//! The verdict on a run: what a die designer asks, each answer with its limit, where that comes from and what to change.
//!
//! One question, one file; a new one is a file here and a line in [`judge`]. Limits that the solver or `check` warn by are
//! those constants; what has no source that could be read is called a declared rule of thumb.

mod bend;
mod clearance;
mod forming_limit;
mod friction;
mod hardening;
mod holder;
mod neck;
mod nose;
mod numerics;
mod press;
mod redraw;
mod springback;
mod stop;
mod tearing;
mod thinning;
mod wrinkling;

use crate::case::Case;
use crate::solution::StageSolution;
use crate::solution::StepRecord;
use crate::table::Unit;
use forming_limit::Nearest;
use serde::{Serialize, Serializer};

/// How a finding stands to its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Light {
    /// Not judged: the case does not hold what it would be held against.
    Grey,
    /// Within the limit.
    Green,
    /// Near it, or a guess that matters.
    Amber,
    /// Beyond it.
    Red,
}

impl Light {
    /// The word that stands for it without colours.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grey => "grey",
            Self::Green => "green",
            Self::Amber => "amber",
            Self::Red => "red",
        }
    }

    /// Green up to the first limit, amber up to the second, red beyond.
    fn of(value: f64, limits: [f64; 2]) -> Self {
        match value {
            v if v <= limits[0] => Self::Green,
            v if v <= limits[1] => Self::Amber,
            _ => Self::Red,
        }
    }

    /// Green up to a limit, amber beyond.
    fn within(value: f64, limit: f64) -> Self {
        Self::of(value, [limit, f64::INFINITY])
    }

    /// The advice of a finding that needs one.
    fn advice(self, text: impl Into<String>) -> String {
        if self == Self::Green { String::new() } else { text.into() }
    }
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
    /// In JSON as at the end of a header: `percent`; empty for plain numbers.
    #[serde(serialize_with = "spelled")]
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

fn spelled<S: Serializer>(unit: &Unit, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(unit.spelled())
}

/// What a limit without a source that could be read is called.
const DECLARED: &str = "declared rule of thumb";

/// One sentence on all findings, the worst first: `2 amber (Holder, Friction), 1 not judged (Energy), 14 green`.
pub fn headline(findings: &[Finding]) -> String {
    let of = |light: Light, word: &str, named: bool| {
        let labels: Vec<&str> = findings.iter().filter(|f| f.light == light).map(|f| f.label).collect();
        let names = if named { format!(" ({})", labels.join(", ")) } else { String::new() };
        (!labels.is_empty()).then(|| format!("{} {word}{names}", labels.len()))
    };
    let parts = [
        of(Light::Red, "red", true),
        of(Light::Amber, "amber", true),
        of(Light::Grey, "not judged", true),
        of(Light::Green, "green", false),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The advice on findings of a light, findings of one advice together: their labels, and what to change.
pub fn advice(findings: &[Finding], is: impl Fn(Light) -> bool) -> Vec<(String, &str)> {
    let mut given: Vec<(String, &str)> = Vec::new();
    for finding in findings.iter().filter(|f| is(f.light) && !f.advice.is_empty()) {
        match given.iter_mut().find(|(_, advice)| *advice == finding.advice) {
            Some((labels, _)) => *labels += &format!(", {}", finding.label),
            None => given.push((finding.label.to_owned(), &finding.advice)),
        }
    }
    given
}

/// Every finding on a case's run, in the order of the questions: tears, wrinkles, press, tools, trust.
pub fn judge(case: &Case, passes: &[StageSolution]) -> Vec<Finding> {
    let nearest = Nearest::of(passes);
    let nearest = nearest.as_ref();
    let single = [
        stop::judge(case, passes),
        thinning::judge(case, passes, nearest),
        neck::judge(passes),
        forming_limit::margin(nearest, passes),
        forming_limit::path(nearest),
        tearing::judge(passes),
        redraw::judge(passes),
        wrinkling::judge(passes),
        wrinkling::wall(passes),
        press::force(case, passes),
        press::energy(case, passes),
        holder::judge(passes),
        clearance::gap(case, passes),
        clearance::ironing(passes),
        springback::judge(passes),
        bend::judge(passes),
        hardening::judge(passes),
        friction::judge(case),
    ];
    single.into_iter().flatten().chain(numerics::judge(passes)).collect()
}

/// `, stage 2` where there are several.
fn of_stage(passes: &[StageSolution], i: usize) -> String {
    if passes.len() > 1 { format!(", stage {}", i + 1) } else { String::new() }
}

/// Every step of every stage.
fn steps(passes: &[StageSolution]) -> impl Iterator<Item = &StepRecord> {
    passes.iter().flat_map(|pass| &pass.steps)
}

/// The largest of a figure over all stages; 0 where there is none.
fn largest(passes: &[StageSolution], value: impl Fn(&StepRecord) -> f64) -> f64 {
    steps(passes).map(value).fold(0.0, f64::max)
}
