//! What the program tells a user to know of a case, before it is solved and after: [`Finding`]s, made here and nowhere else.
//!
//! One question, one file, asked before the run, after it, or both; a new one is a file here and a line in `BEFORE` or
//! `AFTER`. Each rule has one constant with its source; what has no source that could be read is called a declared rule of
//! thumb.

mod answer;
mod bead;
mod bending_radius;
mod bent_strength;
mod blank_size;
mod bottom_tearing;
pub mod check;
mod clearance;
mod closing;
mod contact_share;
mod cut_off;
pub mod design;
mod draw_ratio;
mod ears;
pub mod estimate;
mod failure_mode;
mod finding;
mod forming_limit;
mod friction;
mod hardening;
mod holder;
mod ironing;
mod key_number;
mod line_end;
mod mesh;
mod moment;
mod nearest;
mod neck;
mod nose;
mod penetration;
mod place;
mod power_balance;
mod press;
mod redraw_ratio;
mod run;
mod sharp_corner;
pub mod size;
mod springback;
mod stop;
mod strength;
mod thinning;
mod trim;
mod two_sheets;
mod wall_load;
mod wrinkling;
mod yield_condition;
mod yielding;

pub use answer::{Answer, tears_at};
pub use failure_mode::FailureMode;
pub use finding::{Finding, Kind, Light, When, advice, by_advice, headline, judgements, sentences};
pub use forming_limit::{CAREFUL, Used, used as forming_limit_used};
pub use holder::holder_lift;
pub use key_number::largest_force;
pub use size::{SIZE_CHECKS, size_doubts};

use crate::case::Case;
use crate::model::{Model, Tool};
use crate::solver::solution::StageSolution;
use nearest::Nearest;
use run::Run;

/// A question to a case.
enum Before {
    /// Of the case.
    Case(fn(&Case) -> Option<Finding>),
    /// Of the first stage.
    Model(fn(&Model) -> Option<Finding>),
    /// Of each of its tools.
    Tool(fn(&Model, &Tool) -> Option<Finding>),
}

/// A question to what came out.
enum After {
    /// Of all stages together.
    Run(fn(&Run) -> Option<Finding>),
    /// Of each stage.
    Stage(fn(&StageSolution) -> Option<Finding>),
}

/// What is asked of a case, in the order of telling.
const BEFORE: &[Before] = &[
    Before::Case(two_sheets::mixed),
    Before::Case(two_sheets::thickness),
    Before::Model(strength::unusual),
    Before::Model(closing::closes),
    Before::Model(closing::drawn),
    Before::Model(holder::idle),
    Before::Model(holder::crushing),
    Before::Tool(bending_radius::small),
    Before::Tool(friction::dry),
    Before::Tool(sharp_corner::met),
    Before::Tool(line_end::passed),
    Before::Model(clearance::narrow),
    Before::Model(mesh::coarse),
    Before::Model(draw_ratio::large),
    Before::Model(blank_size::drawn_through),
    Before::Model(hardening::short),
];

/// What is asked of a run, in the order of telling: tears, wrinkles, press, tools, trust.
const AFTER: &[After] = &[
    After::Stage(trim::cut),
    After::Run(stop::judge),
    After::Run(thinning::judge),
    After::Run(neck::judge),
    After::Stage(neck::seen),
    After::Run(forming_limit::margin),
    After::Run(forming_limit::path),
    After::Run(bottom_tearing::judge),
    After::Run(redraw_ratio::judge),
    After::Run(wrinkling::judge),
    After::Run(wrinkling::wall),
    After::Run(press::force),
    After::Run(press::energy),
    After::Run(holder::judge),
    After::Run(clearance::judge),
    After::Run(ironing::judge),
    After::Run(springback::judge),
    After::Run(ears::expected),
    After::Run(bending_radius::judge),
    After::Run(bent_strength::judge),
    After::Run(yield_condition::judge),
    After::Run(hardening::judge),
    After::Run(friction::judge),
    After::Run(power_balance::judge),
    After::Stage(power_balance::missed),
    After::Run(cut_off::judge),
    After::Stage(cut_off::large),
    After::Run(penetration::judge),
    After::Stage(penetration::deep),
    After::Stage(penetration::left),
    After::Run(moment::judge),
    After::Stage(hardening::beyond),
    After::Stage(hardening::other_temperatures),
    After::Stage(contact_share::missed),
    After::Stage(closing::stays_open),
    After::Stage(holder::lifted),
    After::Stage(holder::rests),
    After::Stage(holder::lost),
    After::Stage(yielding::again),
];

/// What can be found before a case is solved: what was assumed while it was read, and what should be known before a result
/// is trusted.
pub fn before(case: &Case) -> Vec<Finding> {
    let sizes = SIZE_CHECKS.iter().filter_map(|check| check(case.model()));
    let asked = BEFORE.iter().flat_map(|question| match question {
        Before::Case(ask) => ask(case).into_iter().collect(),
        Before::Model(ask) => ask(case.model()).into_iter().collect(),
        Before::Tool(ask) => case.model().tools.iter().filter_map(|tool| ask(case.model(), tool)).collect::<Vec<_>>(),
    });
    let assumed = case.derived.iter().cloned().map(Finding::assumed);
    assumed.chain(sizes).chain(asked).map(|finding| Finding { when: When::Before, ..finding }).collect()
}

/// What can be found on a case's solved stages: the verdict, and the warnings of every stage.
pub fn after(case: &Case, stages: &[StageSolution]) -> Vec<Finding> {
    asked(&Run { case, stages, nearest: Nearest::of(stages), is_one_of_many: false })
}

/// The same of one of many runs: what wants the case solved again is found, and not solved.
pub fn after_one_of_many(case: &Case, stages: &[StageSolution]) -> Vec<Finding> {
    asked(&Run { case, stages, nearest: Nearest::of(stages), is_one_of_many: true })
}

fn asked(run: &Run) -> Vec<Finding> {
    let asked = AFTER.iter().flat_map(|question| match question {
        After::Run(ask) => ask(run).into_iter().collect::<Vec<_>>(),
        After::Stage(_) => Vec::new(),
    });
    let of_stages = run.stages.iter().enumerate().flat_map(|(i, stage)| of_stage(i, stage));
    asked.chain(of_stages).collect()
}

/// What is told with the results of each stage: its warnings, of `before` what was assumed while the case was read, and with
/// the first stage the rest of it.
pub fn told(before: &[Finding], stages: &[StageSolution]) -> Vec<Vec<Finding>> {
    let of = |(i, stage)| {
        let with = before.iter().filter(move |finding| i == 0 || finding.kind == Kind::Assumption);
        of_stage(i, stage).into_iter().chain(with.cloned()).collect()
    };
    stages.iter().enumerate().map(of).collect()
}

/// What a user should know before trusting a solved stage, as sentences.
pub fn warnings(stage: &StageSolution) -> Vec<String> {
    sentences(&of_stage(0, stage), Kind::Warning)
}

/// The warnings of a solved stage, which is the `i`-th of its case, counted from 0.
pub fn of_stage(i: usize, stage: &StageSolution) -> Vec<Finding> {
    let asked = AFTER.iter().filter_map(|question| match question {
        After::Run(_) => None,
        After::Stage(ask) => ask(stage),
    });
    asked.map(|finding| Finding { stage: Some(i), ..finding }).collect()
}
