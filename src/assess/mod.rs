//! Assessment of a case, before and after it is solved: [`Finding`]s, made here and nowhere else.
//!
//! A new finding is a file here and a line in one of the lists below. Each rule has one constant with its source; a rule without
//! a source that could be read is called a declared rule of thumb.

pub mod advice;
mod answer;
mod bends;
pub mod check;
mod draw;
mod edge;
pub mod error_bars;
pub mod estimate;
mod failure;
mod filling;
mod finding;
mod fold;
mod forming_limit;
mod fracture;
mod holder;
mod material;
mod press;
pub mod sensitivity;
pub mod size;
mod solution_quality;
mod springback;
mod stop;
mod tear;
mod tools;

pub use answer::Answer;
pub use draw::draws;
pub use failure::FailureMode;
pub use finding::{Finding, Kind, Light, When, by_advice, first_clause, headline, judgements, sentences, unchecked};
pub use fold::folded;
pub use forming_limit::{CAREFUL, Used, used as forming_limit_used};
pub use holder::holder_lift;
pub use press::{largest_force, on_ram};
pub use size::{SIZE_CHECKS, size_doubts};
pub use tear::tears_at;

use crate::case::{Case, Solution};
use crate::forming_limit::assess;
use crate::geometry::Piece;
use crate::material::YieldCriterion;
use crate::measure::events;
use crate::model::{Bead, Edge, Geometry, Mode, Model, Motion, Role, Tool, tool_sizes::extent};
use crate::solver::solution::{Frame, NodeRecord, StageSolution, StepRecord, StopKind};
use crate::table::worded;
use crate::units::{Amount, Digits, ErrorBar, Limits, Quantity, Sense, Unit, joined, rounded, rounded_up, significant};
use forming_limit::Nearest;
use serde::{Serialize, Serializer, ser::SerializeMap};

const ON_CASE: &[fn(&Case) -> Option<Finding>] =
    &[press::no_force, material::mixed, material::thickness, sensitivity::assumed];

const ON_MODEL: &[fn(&Model) -> Option<Finding>] = &[
    material::strength,
    material::idle_zone,
    stop::earlier,
    holder::closes,
    holder::idle,
    holder::crushing,
    tools::narrow,
    tools::wide,
    tools::overlap,
    edge::planned,
    solution_quality::mesh,
    draw::ratio,
    material::short,
];

const ON_TOOL: &[fn(&Model, &Tool) -> Option<Finding>] =
    &[bends::tool_radius, tools::dry_friction, bends::sharp_corner, solution_quality::line_end];

/// Findings on a run, in the order of output: tears, wrinkles, press, tools, trust.
const ON_RUN: &[fn(&Run) -> Option<Finding>] = &[
    stop::judge,
    tear::thinning,
    tear::localisation,
    forming_limit::margin,
    fracture::judge,
    edge::judge,
    tear::tearing,
    draw::redraw,
    draw::wrinkling,
    draw::wall_wrinkles,
    fold::judge,
    press::force,
    press::energy,
    holder::judge,
    filling::judge,
    tools::clearance,
    tools::ironing,
    tools::idle,
    springback::judge,
    draw::delayed_cracking,
    draw::ears,
    draw::trim_allowance,
    holder::pads,
    forming_limit::bend,
    material::placeholders,
    material::yield_condition,
    material::hardening,
    sensitivity::row,
    solution_quality::judge,
];

const ON_STAGE: &[fn(&StageSolution) -> Option<Finding>] = &[
    draw::trim,
    material::temperature,
    stop::contact_share,
    stop::remedied,
    holder::stays_open,
    holder::rests,
    holder::lost,
    holder::out_of_bead,
    solution_quality::yields_again,
];

/// Assumptions made while a case was read, and warnings before it is solved.
pub fn before(case: &Case) -> Vec<Finding> {
    let model = case.model();
    let on_case = ON_CASE.iter().filter_map(|find| find(case));
    let on_model = SIZE_CHECKS.iter().chain(ON_MODEL).filter_map(|find| find(model));
    // A pad's edge stands over the bottom's flat.
    let tools = || model.tools.iter().filter(|tool| tool.role != Role::Pad);
    let on_tools = ON_TOOL.iter().flat_map(|find| tools().filter_map(|tool| find(model, tool)));
    let findings = case.derived.iter().cloned().map(Finding::assumed).chain(on_case).chain(on_model).chain(on_tools);
    findings.map(|finding| Finding { when: When::Before, ..finding }).collect()
}

/// Verdict on a solved case, and the warnings of every stage.
pub fn after(case: &Case, stages: &[StageSolution]) -> Vec<Finding> {
    let run = Run { case, stages, nearest: Nearest::of(stages), fold: fold::first(stages) };
    let of_stages = stages.iter().enumerate().flat_map(|(i, stage)| of_stage(i, stage));
    // Known before the run, and wrong with its result, if a run that ended as wished came so far.
    let whole = stages.first().filter(|stage| stage.stop.is_complete()).and_then(|stage| stage.steps.last());
    let comes = |own: &Finding| own.key != "overlap" || whole.is_none_or(|end| own.value() <= Some(end.travel));
    let of_case =
        [stop::earlier, tools::overlap, tools::wide].into_iter().filter_map(|find| find(case.model())).filter(comes);
    let of_case = of_case.map(|finding| Finding { kind: Kind::Judgement, light: Light::Red, ..finding });
    let judge = if answer::is_test(stages) { of_test } else { |finding| finding };
    let judged = ON_RUN.iter().filter_map(|find| find(&run)).map(judge);
    of_case.chain(judged).chain(of_stages).collect()
}

/// True of a run that came to its end, and of a test that ended by the failure it looks for.
pub fn is_done(solution: &Solution) -> bool {
    solution.is_complete() || answer::is_test(&solution.stages)
}

/// A test ends by the failure that it looks for, and its tools are those of its standard.
fn of_test(mut finding: Finding) -> Finding {
    if finding.key == "stop" || failure::TEARS.contains(&finding.key) {
        finding = finding.passed("the end of the test");
    }
    if finding.key != "friction" && finding.light > Light::Grey {
        finding.advice.clear();
    }
    finding
}

/// Findings to print with each stage: its warnings and all assumptions; with the first, also the warnings before the run.
pub fn by_stage(before: &[Finding], stages: &[StageSolution]) -> Vec<Vec<Finding>> {
    let of = |(i, stage)| {
        let with = before.iter().filter(move |finding| i == 0 || finding.kind == Kind::Assumption);
        of_stage(i, stage).into_iter().chain(with.cloned()).collect()
    };
    stages.iter().enumerate().map(of).collect()
}

/// Warnings on the `i`-th stage of a case, counted from 0.
pub fn of_stage(i: usize, stage: &StageSolution) -> Vec<Finding> {
    ON_STAGE.iter().filter_map(|find| find(stage)).map(|finding| Finding { stage: Some(i), ..finding }).collect()
}

struct Run<'a> {
    case: &'a Case,
    stages: &'a [StageSolution],
    nearest: Option<Nearest<'a>>,
    fold: Option<(usize, &'a Frame)>,
}

impl<'a> Run<'a> {
    fn of_stage(&self, text: String, i: usize) -> String {
        if self.stages.len() > 1 { format!("{text}, stage {}", i + 1) } else { text }
    }

    fn steps(&self) -> impl Iterator<Item = &StepRecord> {
        self.stages.iter().flat_map(|stage| &stage.steps)
    }

    fn largest(&self, value: impl Fn(&StepRecord) -> f64) -> Option<f64> {
        self.steps().map(value).reduce(f64::max).map(|largest| largest.max(0.0))
    }

    fn peak<T>(&self, figure: impl Fn(usize, &'a StageSolution) -> Option<(f64, T)>) -> Option<(usize, f64, T)> {
        let all = self.stages.iter().enumerate();
        let figures = all.filter_map(|(i, stage)| figure(i, stage).map(|(value, with)| (i, value, with)));
        figures.max_by(|a, b| a.1.total_cmp(&b.1))
    }
}

fn formed(stages: &[StageSolution]) -> impl Iterator<Item = (usize, &StageSolution)> {
    stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none())
}

/// Instant of a stage by its travel \[mm\], or by its time \[s\] where nothing travels.
fn instant(stage: &StageSolution, travel: f64, time: f64) -> String {
    let (travel, time) = (Amount::place(travel), Amount::time(time));
    if stage.model.travel > 0.0 { format!("{travel} of travel") } else { time.to_string() }
}

fn at_event(stage: &StageSolution, peak: &StepRecord) -> String {
    let begins = stage.steps.iter().rev().find(|step| step.step < peak.step).map_or(0.0, |before| before.travel);
    let here = events(stage).into_iter().find(|event| event.travel > begins && event.travel <= peak.travel);
    here.map_or_else(String::new, |event| format!("({})", event.kind.label(&stage.model)))
}

pub(crate) fn largest(stage: &StageSolution, value: impl Fn(&StepRecord) -> f64) -> f64 {
    stage.steps.iter().map(value).fold(0.0, f64::max)
}
