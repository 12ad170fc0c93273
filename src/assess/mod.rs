//! Assessment of a case, before and after it is solved: [`Finding`]s, made here and nowhere else.
//!
//! A new finding is a file here and a line in one of the lists below. Each rule has one constant with its source; a rule without
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

/// Findings on a case, in the order of output.
const ON_CASE: [fn(&Case) -> Option<Finding>; 2] = [material::mixed, material::thickness];

/// Findings on the first stage.
const ON_MODEL: [fn(&Model) -> Option<Finding>; 10] = [
    material::strength,
    closing::closes,
    closing::bead,
    holder::idle,
    holder::crushing,
    clearance::narrow,
    solution_quality::mesh,
    draw::ratio,
    draw::blank_area,
    material::short,
];

/// Findings on each tool of the first stage.
const ON_TOOL: [fn(&Model, &Tool) -> Option<Finding>; 4] =
    [bends::tool_radius, friction::dry, bends::sharp_corner, solution_quality::line_end];

/// Findings on a run, in the order of output: tears, wrinkles, press, tools, trust.
const ON_RUN: [fn(&Run) -> Option<Finding>; 22] = [
    stop::judge,
    thinning::judge,
    thinning::localisation,
    forming_limit::margin,
    forming_limit::paths,
    bottom_tearing::judge,
    draw::redraw,
    wrinkling::judge,
    wrinkling::wall,
    press::force,
    press::energy,
    holder::judge,
    clearance::judge,
    clearance::ironing,
    springback::judge,
    draw::ears,
    bends::radius,
    bends::strength,
    yield_condition::judge,
    material::hardening,
    friction::judge,
    solution_quality::judge,
];

/// Findings on each solved stage, in the order of output.
const ON_STAGE: [fn(&StageSolution) -> Option<Finding>; 11] = [
    draw::trim,
    thinning::neck_seen,
    solution_quality::poor,
    material::extrapolated,
    material::temperature,
    stop::contact_share,
    closing::stays_open,
    holder::lifted,
    holder::rests,
    holder::lost,
    solution_quality::yields_again,
];

/// Assumptions made while a case was read, and warnings before it is solved.
pub fn before(case: &Case) -> Vec<Finding> {
    let model = case.model();
    let assumed = case.derived.iter().cloned().map(Finding::assumed);
    let on_case = ON_CASE.iter().filter_map(|find| find(case));
    let on_model = SIZE_CHECKS.iter().chain(&ON_MODEL).filter_map(|find| find(model));
    let on_tools = ON_TOOL.iter().flat_map(|find| model.tools.iter().filter_map(|tool| find(model, tool)));
    let findings = assumed.chain(on_case).chain(on_model).chain(on_tools);
    findings.map(|finding| Finding { when: When::Before, ..finding }).collect()
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
    let of_stages = run.stages.iter().enumerate().flat_map(|(i, stage)| of_stage(i, stage));
    ON_RUN.iter().filter_map(|find| find(run)).chain(of_stages).collect()
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
    let findings = ON_STAGE.iter().filter_map(|find| find(stage));
    findings.map(|finding| Finding { stage: Some(i), ..finding }).collect()
}
