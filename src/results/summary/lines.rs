//! Lines of a summary: load, part, energies, condition, and the numerical solution.

use super::method::{bent, corrector, mesh};
use super::{Group, Line, Value, section_of};
use crate::assess::{Kind, holder_lift, sentences};
use crate::case::files::sha256;
use crate::measure::{Shape, events, moment_error, part_height, thickest};
use crate::model::{Mode, Model, Role, Theory};
use crate::plot::{StageView, stop_text};
use crate::results::tables;
use crate::solver::solution::{StageSolution, StepRecord, StopKind};
use crate::table::{JOULES, Unit, worded};
use crate::units::{Amount, Digits, ZERO_CELSIUS};
use serde_json::Value as Json;

/// Numbers of the numerical solution that stand between those of the part.
const NUMERICAL: [&str; 4] = ["imbalance", "cutoff_share", "moment_error", "penetration"];

/// Lines of a stage as they are collected.
struct Lines<'a> {
    view: &'a StageView<'a>,
    model: &'a Model,
    run: &'a StageSolution,
    /// Last step, or the sheet at its start.
    last: StepRecord,
    group: Group,
    lines: Vec<Line>,
}

/// Lines of a stage in the order of printing.
pub(super) fn lines(view: &StageView) -> Vec<Line> {
    let (model, run) = (view.model(), view.stage);
    let last = run.steps.last().copied().unwrap_or_else(|| as_begun(run));
    let mut lines = Lines { view, model, run, last, group: Group::Case, lines: Vec::new() };
    lines.plain("case", "Case", view.name.clone());
    lines.plain("title", "Title", model.title.clone());
    lines.plain("section", "Section", section_of(model.extent()));
    lines.group = Group::Part;
    lines.load();
    lines.part();
    lines.forming_limit();
    lines.energy();
    lines.condition();
    lines.holder();
    lines.group = Group::Solution;
    lines.solution();
    lines.group = Group::Case;
    for (key, label, entries) in [
        ("overrides", "Set on the command line", view.overrides.to_vec()),
        ("derived", "Assumed while reading", sentences(&view.findings, Kind::Assumption)),
        ("warnings", "Warnings", sentences(&view.findings, Kind::Warning)),
        ("notes", "Declared assumptions", model.notes.clone()),
    ] {
        lines.add(key, label, Value::list(entries));
    }
    lines.lines
}

impl Lines<'_> {
    fn add(&mut self, key: &'static str, label: &str, value: Value) {
        let group = if NUMERICAL.contains(&key) { Group::Solution } else { self.group };
        self.lines.push(Line { group, key, label: label.to_owned(), value });
    }

    fn number(&mut self, key: &'static str, label: &str, amount: Amount) {
        let amount = self.view.half(amount).map_or(amount, |bar| amount.with_bar(bar));
        self.add(key, label, Value::Number(amount));
    }

    fn plain(&mut self, key: &'static str, label: &str, value: impl Into<Json>) {
        self.add(key, label, Value::Plain(value.into()));
    }

    /// Largest value over the steps, or 0.
    fn largest(&self, value: fn(&StepRecord) -> f64) -> f64 {
        self.run.steps.iter().map(value).fold(0.0, f64::max)
    }

    fn force(&self, force: f64) -> Amount {
        Amount::force(force, self.model.extent().force_unit())
    }

    /// End, travel and forces of the punch, or pressure of the gas.
    fn load(&mut self) {
        let Self { model, run, last, .. } = *self;
        self.plain("hardening", "Hardening", model.material.describe());
        let is_full = run.stop.kind == StopKind::FullTravel;
        let ended = if is_full { format!("{} reached", stop_text(run)) } else { run.stop.to_string() };
        self.plain("stop", "Ended", ended);
        self.plain("complete", "", run.stop.is_complete());
        let peak = run.steps.iter().copied().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force));
        let peak = peak.unwrap_or_default();
        if model.travel > 0.0 {
            self.number("travel", "Punch travel reached", Amount::place(last.travel));
            self.number("peak_punch_force", "Peak punch force", self.force(peak.punch_force));
            self.number("peak_travel", "  at a travel of", Amount::place(peak.travel));
        }
        if !model.gas.is_empty() {
            self.number("peak_pressure", "Largest gas pressure", Amount::stress(self.largest(|s| s.pressure.abs())));
            self.number("pole_height", "Height of the middle", Amount::place(last.pole_height));
        }
        if let Some(control) = model.rate_control() {
            let rate = |rate| Amount::new(rate, Unit::PerSecond, Digits::Significant(3));
            self.number("held_rate_target", "Strain rate to be held", rate(control.target));
            let least = run.steps.iter().map(|s| s.held_rate).reduce(f64::min).unwrap_or(0.0);
            self.number("held_rate_least", "  least", rate(least));
            self.number("held_rate_largest", "  largest", rate(self.largest(|s| s.held_rate)));
            let capped = tables::time_on_a_cap(run);
            self.number("time_on_cap", "  time on a cap of the pressure", share(capped, last.time));
            self.number("time", "Time of the cycle", Amount::time(last.time));
        }
        if last.contact_share > 0.0 {
            self.number("contact_share", "Sheet on punch and die at the end", Amount::share(last.contact_share));
        }
        self.add("events", "Events", Value::events(&events(run), model.extent().force_unit()));
    }

    /// Height, angles, and the thinnest and thickest places.
    fn part(&mut self) {
        let Self { model, run, last, .. } = *self;
        let end = run.frames.last();
        if let Some(height) = end.and_then(part_height) {
            self.number("part_height", "Part height over all", Amount::place(height));
        }
        if let Some(changes) = tables::springback_changes(run) {
            self.add("springback", "Spring-back", Value::changes(&changes));
        } else if let Some(angle) = end.and_then(|end| Shape::of(end).wall_angle()) {
            self.number("wall_angle", "Wall to the punch direction", Amount::angle(angle));
        }
        let over_initial = |thickness| Amount::share(thickness / model.blank.thickness);
        let from =
            worded(model.geometry, "  at s0, initially from the axis", "  at s0, initially from the symmetry plane");
        self.number("thinnest", "Thinnest place", Amount::thickness(last.thinnest));
        self.number("thinnest_over_initial", "  over the initial thickness", over_initial(last.thinnest));
        self.number("thinnest_s0", from, Amount::place(last.thinnest_s0));
        if let Some((thickest, s0)) = end.and_then(thickest) {
            self.number("thickest", "Thickest place", Amount::thickness(thickest));
            self.number("thickest_over_initial", "  over the initial thickness", over_initial(thickest));
            self.number("thickest_s0", from, Amount::place(s0));
        }
        if let Some(opening) = self.view.ring_opening() {
            self.number("ring_opening", "Opening of a slit ring", Amount::place(opening));
        }
    }

    /// Distance to the forming limit, and the draw-in.
    fn forming_limit(&mut self) {
        let Self { view, model, run, last, .. } = *self;
        if let Some(assessment) = view.forming_limit() {
            if let Some(curve) = &model.forming_limit {
                self.plain("forming_limit", "Forming limit", curve.name);
                let least = Amount::ratio(curve.plane_strain());
                self.number("forming_limit_plane_strain", "  at plane strain, true strain", least);
            }
            if assessment.open().is_some() {
                self.plain("forming_limit_unjudged", "  ends before the most strained place", true);
            }
            let worst = assessment.worst();
            self.number("forming_margin", "  least margin in major true strain", Amount::ratio(worst.margin()));
            self.number("forming_ratio", "  major strain over the limit there", Amount::share(worst.ratio()));
            self.number("forming_margin_s0", "  at s0, its initial distance", Amount::place(worst.s0));
            self.plain("forming_margin_path_crooked", "  its path is not straight", worst.is_crooked());
            self.plain("forming_paths_crooked", "  elements whose path is not straight", assessment.crooked());
            self.plain("forming_limit_reached", "  reached", assessment.reached.is_some());
            if let Some(reached) = assessment.reached {
                if model.travel > 0.0 {
                    self.number("forming_limit_travel", "    first at a travel of", Amount::place(reached.travel));
                } else {
                    self.number("forming_limit_time", "    first at a time of", Amount::time(reached.time));
                }
                self.number("forming_limit_s0", "    at s0, its initial distance", Amount::place(reached.s0));
            }
        }
        if run.paths.stride() > 1 {
            let kept = format!("kept of every {n}th step and of the last", n = run.paths.stride());
            self.plain("strain_paths", "Strain paths", kept);
        }
        self.number("draw_in", "Draw-in of the edge", Amount::place(last.draw_in));
    }

    /// Work, heat, and what the balance misses.
    fn energy(&mut self) {
        let Self { model, run, last, .. } = *self;
        let energy = |energy| Amount::force(energy, model.extent().energy_unit());
        let work = last.work.without_round_off().scaled(JOULES);
        let given_back = work.external < 0.0;
        if given_back {
            self.number("work_given_back", "Work given back to the tools", energy(-work.external));
            self.number("work_out_of_sheet", "  out of the sheet's elasticity", energy(0.0 - work.elastic));
            self.number("work_out_of_contact", "  out of the contact", energy(0.0 - work.contact));
        }
        let shown = |label: &'static str| if given_back { "" } else { label };
        self.number("work_external", shown("Work of the tools"), energy(work.external));
        self.number("work_plastic", "  plastic", energy(work.plastic));
        if model.mode != Mode::Flow {
            self.number("work_elastic", shown("  stored in the sheet"), energy(work.elastic));
        }
        self.number("work_friction", "  friction", energy(work.friction));
        self.number("work_contact", shown("  stored in contact"), energy(work.contact));
        let missing = share(last.work.missing(), run.largest_work());
        self.number("imbalance", "Work missing in the balance", missing);
        self.number("cutoff_share", "Plastic work in nearly rigid zones", share(work.cutoff, work.plastic));
        if model.heat.as_ref().is_some_and(|heat| heat.flow.is_some()) {
            self.number("heat_stored", "Heat stored in the sheet", energy(JOULES * last.heat.stored));
            self.number("heat_plastic", "  from plastic work", energy(JOULES * last.heat.plastic));
            self.number("heat_tools", "  from the tools", energy(JOULES * last.heat.tools));
        }
    }

    /// Bending moment, voids, temperatures, ironing and bends.
    fn condition(&mut self) {
        let Self { model, run, last, .. } = *self;
        let bent = run.frames.last().filter(|_| model.mode != Mode::Flow && model.release.is_none());
        if let Some(error) = bent.and_then(moment_error) {
            let label = "Bending moment missed by the layers, estimated";
            self.number("moment_error", label, Amount::share(error));
        }
        if model.material.gtn.is_some() {
            self.number("porosity", "Largest porosity", Amount::share(last.porosity));
            self.number("porous_s0", "  at an initial distance of", Amount::place(last.porous_s0));
        }
        if let Some(heat) = &model.heat {
            // A run that never started has the temperature it was given.
            let coldest = run.steps.iter().map(|s| s.coldest).reduce(f64::min).unwrap_or(heat.initial.smallest());
            let hottest = run.steps.iter().map(|s| s.hottest).reduce(f64::max).unwrap_or(heat.initial.largest());
            self.number("coldest", "Lowest temperature", Amount::temperature(coldest - ZERO_CELSIUS));
            self.number("hottest", "Highest temperature", Amount::temperature(hottest - ZERO_CELSIUS));
        }
        let deepest = Amount::share(self.largest(|s| s.penetration));
        self.number("penetration", "Tools in the sheet, of its thickness", deepest);
        let ironing = self.largest(|s| s.ironing);
        if ironing > 0.0 {
            let [force, friction] = [self.largest(|s| s.ironing_force), self.largest(|s| s.ironing_friction)]
                .map(|force| self.force(force));
            self.number("ironing", "Ironing: reduction of the thickness", Amount::share(ironing));
            self.number("ironing_force", "Largest ironing force of the die", force);
            self.number("ironing_friction", "Largest friction in it", friction);
            let pressure = Amount::stress(self.largest(|s| s.ironing_pressure));
            self.number("ironing_pressure", "Largest ironing pressure", pressure);
        }
        // A flat sheet has no bend.
        let sharpest = self.largest(|s| s.sharpest_bend);
        let radius = if sharpest > 0.0 { 1.0 / sharpest } else { 0.0 };
        self.number("sharpest_bend", "Smallest bending radius", Amount::thicknesses(radius));
    }

    /// Force and lift of the holder.
    fn holder(&mut self) {
        let Self { model, run, .. } = *self;
        if model.tool(Role::Holder).is_none() || model.release.is_some() {
            return;
        }
        if let Some(closing) = run.closing {
            self.number("closing_way", "Way of the holder to close over the sheet", Amount::place(closing.way));
            self.number("closing_gap", "  stands open by", Amount::thickness(closing.gap));
            self.number("closing_force", "  with a force of", self.force(closing.force));
        }
        self.number("peak_holder_force", "Largest holder force", self.force(self.largest(|s| s.holder_force)));
        let rim = format!("  last share on the outer {}", Amount::given_thicknesses(StepRecord::RIM));
        let last = run.steps.iter().rev().find(|s| s.holder_force > 0.0).map_or(0.0, |s| s.rim_share);
        self.number("rim_share", &rim, Amount::share(last));
        if let Some(lift) = holder_lift(run) {
            self.number("holder_lift", "  lifted by up to, while there is a flange", Amount::thickness(lift));
        }
    }

    /// Contact, mesh, method and effort.
    fn solution(&mut self) {
        let Self { view, model, run, last, .. } = *self;
        let (steps, effort) = (&run.steps, &run.effort);
        self.number("sticking", "Contacts that stick at the end", Amount::share(last.sticking));
        self.plain("flips", "Contacts that came or went", steps.iter().map(|s| s.contact_changes).sum::<usize>());
        let strain = Amount::ratio(self.largest(|s| s.strain_increment));
        self.number("strain_increment", "Largest strain of one step", strain);
        self.plain("mesh", "Mesh", mesh(model));
        if model.blank.theory == Theory::Selective {
            let (share, points) = bent(model, run);
            self.number("bending_share", "  elements times steps that bent", Amount::share(share));
            self.number("point_share", "  law points over those of full bending", Amount::share(points));
        }
        self.plain("corrector", "Corrector", corrector(model));
        self.plain("steps", "Steps", steps.len());
        self.plain("steps_from_predictor", "  solved from the predictor", effort.predictor);
        self.plain("steps_from_secant", "  from a secant start at rest", effort.secant);
        self.plain("steps_from_softened", "  from a softened start", effort.softened);
        self.plain("iterations", "Iterations", steps.iter().map(|s| s.iterations).sum::<usize>());
        // Where the residual alone decides, a step may be accepted without an increment that says how far it was.
        let known = steps.iter().map(|s| s.velocity_norm).filter(|norm| norm.is_finite());
        if let Some(norm) = known.reduce(f64::max) {
            self.number("velocity_norm", "Largest accepted velocity norm", Amount::norm(norm));
        }
        let residual = Amount::norm(self.largest(|s| s.residual_norm));
        self.number("residual_norm", "Largest accepted residual norm", residual);
        let rejected = steps.iter().map(|s| s.rejected).sum::<usize>() + effort.abandoned;
        self.plain("rejected", "Rejected tries", rejected);
        self.plain("steps_halved", "  steps halved", effort.halved);
        self.plain("steps_overstrained", "  repeated for too much strain", effort.overstrained);
        self.plain("steps_overstepped", "  repeated to find the end of the run", effort.overstepped);
        if let Some(wall) = view.wall {
            self.number("wall_time", "Wall time", Amount::time(wall.as_secs_f64()));
        }
        self.plain("program", "", concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION")));
        self.plain("case_sha256", "", sha256([view.case_text]));
    }
}

/// Record of a stage without a step: the sheet at its start, or the blank.
fn as_begun(run: &StageSolution) -> StepRecord {
    let blank = &run.model.blank;
    let (elements, nodes) =
        run.start.as_ref().map_or((&[][..], &[][..]), |start| (&start.elements[..], &start.nodes[..]));
    let thinnest = elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness));
    StepRecord {
        thinnest: thinnest.map_or(blank.thickness, |element| element.thickness),
        thinnest_s0: thinnest.map_or(0.0, |element| element.s0),
        draw_in: nodes.last().map_or(0.0, |node| blank.length - node.r),
        pole_height: nodes.first().map_or(0.0, |node| node.z),
        ..StepRecord::default()
    }
}

/// Part of a whole; 0 of nothing.
fn share(part: f64, whole: f64) -> Amount {
    Amount::share(if whole == 0.0 { 0.0 } else { part / whole })
}
