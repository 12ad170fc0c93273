//! What a run comes to, line by line: printed and as JSON from the same list.

mod whole;
mod written;

pub use whole::CaseSummary;

use super::stage_view::ended;
use super::{StageView, pressure_cycle, springback};
use crate::assess::{Kind, sentences};
use crate::forming_limit::Assessment;
use crate::measure::{Change, Shape, moment_error, part_height, thickest};
use crate::model::{Geometry, Grading, Iteration, Mode, Model, Norm, Role, Theory};
use crate::solution::{Effort, StageSolution, StepRecord, Stop};
use crate::table::{JOULES, Unit, energy_unit, force_unit, worded};
use crate::units::ZERO_CELSIUS;
use sha2::{Digest, Sha256};

/// What a line of the summary is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// What was solved.
    Case,
    /// How the stage ended.
    End,
    /// What the part is like and took to form.
    Part,
    /// How the numbers were found.
    Solution,
    /// What a reader should not overlook.
    Warnings,
}

/// One line of the summary.
#[derive(Clone, Debug)]
struct Entry {
    group: Group,
    key: &'static str,
    /// Empty for what only a program wants to know.
    label: String,
    unit: Unit,
    value: Value,
}

#[derive(Clone, Debug)]
enum Value {
    Number(f64),
    Count(usize),
    Flag(bool),
    Text(String),
    List(Vec<String>),
    Changes(Vec<Change>),
}

/// A line for readers, its number apart from its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What the line is about.
    pub group: Group,
    /// Name in JSON, without the unit.
    pub key: &'static str,
    /// Begins with spaces where it belongs to the line above.
    pub label: String,
    /// As it is printed, without its unit.
    pub value: String,
    /// Empty for words.
    pub unit: &'static str,
}

/// The lines of the summary, in the order of printing; displays as aligned text, serialises with units in the keys.
#[derive(Clone, Debug)]
pub struct Summary {
    entries: Vec<Entry>,
    /// Of the entries to come.
    group: Group,
}

impl Summary {
    /// Sums up a stage.
    pub fn of(view: &StageView) -> Self {
        let (model, run) = (view.model(), view.stage);
        let force = force_unit(model.geometry);
        let unmoved = StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() };
        let last = run.steps.last().copied().unwrap_or(unmoved);
        let peak = run.steps.iter().copied().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force));
        let peak = peak.unwrap_or_default();
        let largest = |value: fn(&StepRecord) -> f64| run.steps.iter().map(value).fold(0.0, f64::max);

        let mut summary = Self { entries: Vec::new(), group: Group::Case };
        summary.text("case", "Case", &view.name);
        summary.text("title", "Title", view.title);
        summary.text("section", "Section", section_of(model.geometry));
        summary.group = Group::Part;
        summary.text("hardening", "Hardening", &model.material.describe());
        let ended = match &run.stop {
            Stop::FullTravel => format!("{} reached", ended(run)),
            stop => stop.to_string(),
        };
        summary.group = Group::End;
        summary.text("stop", "Ended", &ended);
        summary.group = Group::Part;
        summary.push("complete", "", Unit::None, Value::Flag(run.stop.is_complete()));
        if model.travel > 0.0 {
            summary.number("travel", "Punch travel reached", Unit::Mm, last.travel);
            summary.number("peak_punch_force", "Peak punch force", force, peak.punch_force);
            summary.number("peak_travel", "  at a travel of", Unit::Mm, peak.travel);
        }
        if !model.gas.is_empty() {
            summary.number("peak_pressure", "Largest gas pressure", Unit::MPa, largest(|s| s.pressure.abs()));
            summary.number("pole_height", "Height of the middle", Unit::Mm, last.pole_height);
        }
        if let Some(control) = model.rate_control() {
            summary.number("held_rate_target", "Strain rate to be held", Unit::PerSecond, control.target);
            let least = run.steps.iter().map(|s| s.held_rate).reduce(f64::min).unwrap_or(0.0);
            summary.number("held_rate_least", "  least", Unit::PerSecond, least);
            summary.number("held_rate_largest", "  largest", Unit::PerSecond, largest(|s| s.held_rate));
            let capped = pressure_cycle::time_on_a_cap(run);
            summary.number("time_on_cap", "  time on a cap of the pressure", Unit::Percent, percent(capped, last.time));
            summary.number("time", "Time of the cycle", Unit::Second, last.time);
        }
        if last.contact_share > 0.0 {
            let share = 100.0 * last.contact_share;
            summary.number("contact_share", "Sheet on punch and die at the end", Unit::Percent, share);
        }
        summary.part(model, run, &last);
        if let Some(assessment) = view.forming_limit() {
            summary.forming_limit(model, assessment);
        }
        summary.number("draw_in", "Draw-in of the edge", Unit::Mm, last.draw_in);
        summary.balance(model, &last);
        if let Some(error) =
            run.frames.last().filter(|_| model.mode != Mode::Flow && model.release.is_none()).and_then(moment_error)
        {
            let share = 100.0 * error.share;
            summary.group = Group::Solution;
            summary.number("moment_error", "Moment missed by the layers, estimated", Unit::Percent, share);
        }
        summary.group = Group::Part;
        if model.material.gtn.is_some() {
            summary.number("porosity", "Largest porosity", Unit::Percent, 100.0 * last.porosity);
            summary.number("porous_s0", "  at an initial distance of", Unit::Mm, last.porous_s0);
        }
        if let Some(heat) = &model.heat {
            // A run that never started has the temperature it was given.
            let coldest = run.steps.iter().map(|s| s.coldest).reduce(f64::min).unwrap_or(heat.initial.smallest());
            let hottest = run.steps.iter().map(|s| s.hottest).reduce(f64::max).unwrap_or(heat.initial.largest());
            summary.number("coldest", "Lowest temperature", Unit::Celsius, coldest - ZERO_CELSIUS);
            summary.number("hottest", "Highest temperature", Unit::Celsius, hottest - ZERO_CELSIUS);
        }
        summary.group = Group::Solution;
        summary.number(
            "penetration",
            "Largest penetration over thickness",
            Unit::Percent,
            100.0 * largest(|s| s.penetration),
        );
        summary.group = Group::Part;
        let ironing = largest(|s| s.ironing);
        if ironing > 0.0 {
            summary.number("squeeze", "Ironing: thicker than its gap by", Unit::Percent, 100.0 * ironing);
        }
        summary.number("sharpest_bend", "Smallest bending radius over thickness", Unit::None, bend_radius(run));
        if model.tool(Role::Holder).is_some() && model.release.is_none() {
            let rim = format!("  last share on the outer {} thicknesses", StepRecord::RIM);
            let peak_force = largest(|s| s.holder_force);
            summary.number("peak_holder_force", "Largest holder force", force, peak_force);
            let shares = run.steps.iter().rev().find(|s| s.holder_force > 0.0).map_or(0.0, |s| s.rim_share);
            summary.push("rim_share", &rim, Unit::Percent, Value::Number(100.0 * shares));
            summary.number("holder_lift", "  lifted by up to", Unit::Mm, largest(|s| -s.holder_move));
        }
        summary.group = Group::Solution;
        summary.number("sticking", "Contacts that stick at the end", Unit::Percent, 100.0 * last.sticking);
        summary.count("flips", "Contacts that came or went", run.steps.iter().map(|s| s.contact_changes).sum());
        summary.number("strain_increment", "Largest strain of one step", Unit::None, largest(|s| s.strain_increment));
        summary.text("mesh", "Mesh", &mesh(model));
        if model.blank.theory == Theory::Selective {
            let (share, points) = bent(model, run);
            summary.number("bending_share", "  elements times steps that bent", Unit::Percent, 100.0 * share);
            summary.number("point_share", "  law points over those of full bending", Unit::Percent, 100.0 * points);
        }
        summary.text("corrector", "Corrector", &corrector(model));
        let Effort { predictor, secant, softened, halved, overstrained, overstepped, abandoned } = run.effort;
        summary.count("steps", "Steps", run.steps.len());
        summary.count("steps_from_predictor", "  solved from the predictor", predictor);
        summary.count("steps_from_secant", "  from a secant start at rest", secant);
        summary.count("steps_from_softened", "  from a softened start", softened);
        summary.count("iterations", "Iterations", run.steps.iter().map(|s| s.iterations).sum());
        summary.number("velocity_norm", "Largest accepted velocity norm", Unit::None, largest(|s| s.velocity_norm));
        summary.number("residual_norm", "Largest accepted residual norm", Unit::None, largest(|s| s.residual_norm));
        summary.count("rejected", "Rejected tries", run.steps.iter().map(|s| s.rejected).sum::<usize>() + abandoned);
        summary.count("steps_halved", "  steps halved", halved);
        summary.count("steps_overstrained", "  repeated for too much strain", overstrained);
        summary.count("steps_overstepped", "  repeated to find the end of the run", overstepped);
        if let Some(wall) = view.wall {
            summary.number("wall_time", "Wall time", Unit::Second, wall.as_secs_f64());
        }
        summary.text("program", "", concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION")));
        summary.text("case_sha256", "", &sha256(view.case_text));
        summary.group = Group::Case;
        summary.list("overrides", "Set on the command line", view.overrides);
        summary.list("derived", "Assumed while reading", &sentences(&view.findings, Kind::Assumption));
        summary.group = Group::Warnings;
        summary.list("warnings", "Warnings", &sentences(&view.findings, Kind::Warning));
        summary.group = Group::Case;
        summary.list("notes", "Declared assumptions", view.declared);
        summary
    }

    /// What the part came out as: its height, its angles and its thinnest and thickest places.
    fn part(&mut self, model: &Model, run: &StageSolution, last: &StepRecord) {
        let end = run.frames.last();
        if let Some(height) = end.and_then(part_height) {
            self.number("part_height", "Part height over all", Unit::Mm, height);
        }
        if let Some(changes) = springback::changes(run) {
            self.push("springback", "Spring-back", Unit::None, Value::Changes(changes));
        } else if let Some(angle) = end.and_then(|end| Shape::of(end).wall_angle()) {
            self.number("wall_angle", "Wall to the punch direction", Unit::Degree, angle);
        }
        let over_initial = |thickness| 100.0 * thickness / model.blank.thickness;
        let from =
            worded(model.geometry, "  at s0, initially from the axis", "  at s0, initially from the symmetry plane");
        self.number("thinnest", "Thinnest place", Unit::Mm, last.thinnest);
        self.number(
            "thinnest_over_initial",
            "  over the initial thickness",
            Unit::Percent,
            over_initial(last.thinnest),
        );
        self.number("thinnest_s0", from, Unit::Mm, last.thinnest_s0);
        if let Some((thickest, s0)) = end.and_then(thickest) {
            self.number("thickest", "Thickest place", Unit::Mm, thickest);
            self.number("thickest_over_initial", "  over the initial thickness", Unit::Percent, over_initial(thickest));
            self.number("thickest_s0", from, Unit::Mm, s0);
        }
    }

    /// Where the work and the heat went.
    fn balance(&mut self, model: &Model, last: &StepRecord) {
        let unit = energy_unit(model.geometry);
        let work = last.work.without_round_off().scaled(JOULES);
        self.number("work_external", "External work", unit, work.external);
        self.number("work_plastic", "  plastic", unit, work.plastic);
        if model.mode != Mode::Flow {
            self.number("work_elastic", "  stored in the sheet", unit, work.elastic);
        }
        self.number("work_friction", "  friction", unit, work.friction);
        self.number("work_contact", "  stored in contact", unit, work.contact);
        self.group = Group::Solution;
        self.number("imbalance", "Work missing in the balance", Unit::Percent, 100.0 * last.work.imbalance());
        self.number("cutoff_share", "Plastic work in cut-off", Unit::Percent, percent(work.cutoff, work.plastic));
        self.group = Group::Part;
        if model.heat.as_ref().is_some_and(|heat| heat.flow.is_some()) {
            self.number("heat_stored", "Heat stored in the sheet", unit, JOULES * last.heat.stored);
            self.number("heat_plastic", "  from plastic work", unit, JOULES * last.heat.plastic);
            self.number("heat_tools", "  from the tools", unit, JOULES * last.heat.tools);
        }
    }

    /// How near the sheet came to its forming limit.
    fn forming_limit(&mut self, model: &Model, assessment: &Assessment) {
        if let Some(curve) = &model.forming_limit {
            self.text("forming_limit", "Forming limit", curve.name);
            self.number(
                "forming_limit_plane_strain",
                "  at plane strain, true strain",
                Unit::None,
                curve.plane_strain(),
            );
        }
        let worst = assessment.worst();
        self.number("forming_margin", "  least margin in major true strain", Unit::None, worst.margin());
        self.number("forming_ratio", "  major strain over the limit there", Unit::Percent, 100.0 * worst.ratio());
        self.number("forming_margin_s0", "  at s0, its initial distance", Unit::Mm, worst.s0);
        self.push(
            "forming_margin_path_crooked",
            "  its path is not straight",
            Unit::None,
            Value::Flag(worst.is_crooked()),
        );
        self.count("forming_paths_crooked", "  elements whose path is not straight", assessment.crooked());
        self.push("forming_limit_reached", "  reached", Unit::None, Value::Flag(assessment.reached.is_some()));
        if let Some(reached) = assessment.reached {
            if model.travel > 0.0 {
                self.number("forming_limit_travel", "    first at a travel of", Unit::Mm, reached.travel);
            } else {
                self.number("forming_limit_time", "    first at a time of", Unit::Second, reached.time);
            }
            self.number("forming_limit_s0", "    at s0, its initial distance", Unit::Mm, reached.s0);
        }
    }

    fn push(&mut self, key: &'static str, label: &str, unit: Unit, value: Value) {
        self.entries.push(Entry { group: self.group, key, label: label.to_owned(), unit, value });
    }

    fn number(&mut self, key: &'static str, label: &'static str, unit: Unit, value: f64) {
        self.push(key, label, unit, Value::Number(value));
    }

    fn count(&mut self, key: &'static str, label: &'static str, value: usize) {
        self.push(key, label, Unit::None, Value::Count(value));
    }

    fn text(&mut self, key: &'static str, label: &'static str, value: &str) {
        self.push(key, label, Unit::None, Value::Text(value.to_owned()));
    }

    fn list(&mut self, key: &'static str, label: &'static str, values: &[String]) {
        self.push(key, label, Unit::None, Value::List(values.to_vec()));
    }
}

/// A part of a whole \[%\]; 0 of nothing.
fn percent(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { 100.0 * part / whole }
}

/// Smallest bending radius of the run over the thickness \[–\]; 0 when the sheet stayed flat.
fn bend_radius(run: &StageSolution) -> f64 {
    let sharpest = run.steps.iter().map(|s| s.sharpest_bend).fold(0.0, f64::max);
    if sharpest > 0.0 { 1.0 / sharpest } else { 0.0 }
}

/// Share of the elements that bent, of all steps, and share of the thickness points that full bending would have evaluated in
/// as many iterations \[–\].
fn bent(model: &Model, run: &StageSolution) -> (f64, f64) {
    let (elements, layers) = (model.blank.elements as f64, model.blank.layers as f64);
    let (mut bent, mut all, mut points, mut full) = (0.0, 0.0, 0.0, 0.0);
    for step in &run.steps {
        let bending = step.bending as f64;
        // One more evaluation finds the step in equilibrium.
        let evaluations = step.iterations as f64 + 1.0;
        bent += bending;
        all += elements;
        points += evaluations * (bending * layers + elements - bending);
        full += evaluations * elements * layers;
    }
    if all > 0.0 { (bent / all, points / full) } else { (0.0, 0.0) }
}

fn mesh(model: &Model) -> String {
    let blank = &model.blank;
    let theory = match blank.theory {
        Theory::Bending => format!("bending elements, {} layers", blank.layers),
        Theory::Membrane => "membrane elements".to_owned(),
        Theory::Selective => {
            format!("elements, bending with {} layers where t/R is above {}", blank.layers, model.settings.bend_ratio)
        }
    };
    let grading = match blank.grading {
        Grading::Uniform => "uniform",
        Grading::Radii => "graded where the tools' radii ask for it",
    };
    format!("{} {theory}, {grading}", blank.elements)
}

fn corrector(model: &Model) -> String {
    let settings = &model.settings;
    let matrix = match settings.iteration {
        Iteration::PrimalDual => "primal-dual Newton",
        Iteration::Newton => "Newton",
        Iteration::Secant => "secant",
    };
    let norm = match settings.norm {
        Norm::Velocity => "velocity norm",
        Norm::Residual => "residual norm",
        Norm::Both => "velocity and residual norm",
    };
    format!("{matrix} matrix, {norm} below {:e}", settings.tolerance)
}

/// `summary.json`.
pub(super) fn json(view: &StageView) -> Option<String> {
    serde_json::to_string_pretty(&Summary::of(view)).ok().map(|text| text + "\n")
}

/// What is modelled, and what its forces are of.
pub fn section_of(geometry: Geometry) -> &'static str {
    match geometry {
        Geometry::Axisymmetric => "axisymmetric; forces of the whole ring",
        Geometry::PlaneStrain => "plane strain; forces per mm of depth, of the half that is modelled",
    }
}

/// Checksum of a text in hexadecimal.
pub fn sha256(text: &str) -> String {
    Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: the digest of the empty text as given in FIPS 180.
    #[test]
    fn the_checksum_is_sha256_in_hexadecimal() {
        assert_eq!(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    }
}
