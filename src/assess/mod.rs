//! Assessment of a case, before and after it is solved: [`Finding`]s, made here and nowhere else.
//!
//! A new finding is a file here and a line in `BEFORE` or `AFTER`. Each rule has one constant with its source; a rule without
//! a source that could be read is called a declared rule of thumb.

mod answer;
mod bends;
mod bottom_tearing;
pub mod check;
mod clearance;
mod closing;
pub mod design;
mod draw;
pub mod estimate;
mod failure_mode;
mod finding;
mod forming_limit;
mod friction;
mod holder;
mod key_number;
mod material;
mod press;
mod run;
pub mod size;
mod solution_quality;
mod springback;
mod stop;
mod tear;
mod thinning;
mod wrinkling;
mod yield_condition;

pub use answer::Answer;
pub use failure_mode::FailureMode;
pub use finding::{Finding, Kind, Light, When, advice, by_advice, headline, judgements, sentences};
pub use forming_limit::{CAREFUL, Used, used as forming_limit_used};
pub use holder::holder_lift;
pub use key_number::largest_force;
pub use size::{SIZE_CHECKS, size_doubts};
pub use tear::tears_at;

use crate::case::Case;
use crate::model::{Model, Tool};
use crate::solver::solution::StageSolution;
use forming_limit::Nearest;
use run::Run;

/// Finding before the run.
enum Before {
    /// On the case.
    Case(fn(&Case) -> Option<Finding>),
    /// On the first stage.
    Model(fn(&Model) -> Option<Finding>),
    /// On each of its tools.
    Tool(fn(&Model, &Tool) -> Option<Finding>),
}

/// Finding after the run.
enum After {
    /// On all stages together.
    Run(fn(&Run) -> Option<Finding>),
    /// On each stage.
    Stage(fn(&StageSolution) -> Option<Finding>),
}

/// Findings on a case, in the order of output.
const BEFORE: &[Before] = &[
    Before::Case(material::mixed),
    Before::Case(material::thickness),
    Before::Model(material::strength),
    Before::Model(closing::closes),
    Before::Model(closing::bead),
    Before::Model(holder::idle),
    Before::Model(holder::crushing),
    Before::Tool(bends::tool_radius),
    Before::Tool(friction::dry),
    Before::Tool(bends::sharp_corner),
    Before::Tool(solution_quality::line_end),
    Before::Model(clearance::narrow),
    Before::Model(solution_quality::mesh),
    Before::Model(draw::ratio),
    Before::Model(draw::blank_area),
    Before::Model(material::short),
];

/// Findings on a run, in the order of output: tears, wrinkles, press, tools, trust.
const AFTER: &[After] = &[
    After::Stage(draw::trim),
    After::Run(stop::judge),
    After::Run(thinning::judge),
    After::Run(thinning::localisation),
    After::Stage(thinning::neck_seen),
    After::Run(forming_limit::margin),
    After::Run(forming_limit::paths),
    After::Run(bottom_tearing::judge),
    After::Run(draw::redraw),
    After::Run(wrinkling::judge),
    After::Run(wrinkling::wall),
    After::Run(press::force),
    After::Run(press::energy),
    After::Run(holder::judge),
    After::Run(clearance::judge),
    After::Run(clearance::ironing),
    After::Run(springback::judge),
    After::Run(draw::ears),
    After::Run(bends::radius),
    After::Run(bends::strength),
    After::Run(yield_condition::judge),
    After::Run(material::hardening),
    After::Run(friction::judge),
    After::Run(solution_quality::judge),
    After::Stage(solution_quality::poor),
    After::Stage(material::extrapolated),
    After::Stage(material::temperature),
    After::Stage(stop::contact_share),
    After::Stage(closing::stays_open),
    After::Stage(holder::lifted),
    After::Stage(holder::rests),
    After::Stage(holder::lost),
    After::Stage(solution_quality::yields_again),
];

/// Assumptions made while a case was read, and warnings before it is solved.
pub fn before(case: &Case) -> Vec<Finding> {
    let sizes = SIZE_CHECKS.iter().filter_map(|check| check(case.model()));
    let findings = BEFORE.iter().flat_map(|finding| match finding {
        Before::Case(ask) => ask(case).into_iter().collect(),
        Before::Model(ask) => ask(case.model()).into_iter().collect(),
        Before::Tool(ask) => case.model().tools.iter().filter_map(|tool| ask(case.model(), tool)).collect::<Vec<_>>(),
    });
    let assumed = case.derived.iter().cloned().map(Finding::assumed);
    assumed.chain(sizes).chain(findings).map(|finding| Finding { when: When::Before, ..finding }).collect()
}

/// Verdict on a solved case, and the warnings of every stage.
pub fn after(case: &Case, stages: &[StageSolution]) -> Vec<Finding> {
    on_run(&Run { case, stages, nearest: Nearest::of(stages), is_one_of_many: false })
}

/// Like [`after`] for one of many runs; no finding solves the case a second time.
pub fn after_one_of_many(case: &Case, stages: &[StageSolution]) -> Vec<Finding> {
    on_run(&Run { case, stages, nearest: Nearest::of(stages), is_one_of_many: true })
}

fn on_run(run: &Run) -> Vec<Finding> {
    let findings = AFTER.iter().flat_map(|finding| match finding {
        After::Run(ask) => ask(run).into_iter().collect::<Vec<_>>(),
        After::Stage(_) => Vec::new(),
    });
    let of_stages = run.stages.iter().enumerate().flat_map(|(i, stage)| of_stage(i, stage));
    findings.chain(of_stages).collect()
}

/// Findings to print with each stage: its warnings and all assumptions; with the first stage, also the warnings before the
/// run.
pub fn by_stage(before: &[Finding], stages: &[StageSolution]) -> Vec<Vec<Finding>> {
    let of = |(i, stage)| {
        let with = before.iter().filter(move |finding| i == 0 || finding.kind == Kind::Assumption);
        of_stage(i, stage).into_iter().chain(with.cloned()).collect()
    };
    stages.iter().enumerate().map(of).collect()
}

/// Warnings on a solved stage, as sentences.
pub fn warnings(stage: &StageSolution) -> Vec<String> {
    sentences(&of_stage(0, stage), Kind::Warning)
}

/// Warnings on the `i`-th stage of a case, counted from 0.
pub fn of_stage(i: usize, stage: &StageSolution) -> Vec<Finding> {
    let findings = AFTER.iter().filter_map(|finding| match finding {
        After::Run(_) => None,
        After::Stage(ask) => ask(stage),
    });
    findings.map(|finding| Finding { stage: Some(i), ..finding }).collect()
}
