//! Load, shape, energy and condition of the part.

use super::{Group, Summary, Value, largest};
use crate::assess::holder_lift;
use crate::forming_limit::Assessment;
use crate::measure::{Shape, part_height, thickest};
use crate::model::{Mode, Model, Role};
use crate::results::{pressure_cycle, springback};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::{JOULES, Unit, worded};
use crate::units::ZERO_CELSIUS;
use crate::units::{Amount, Digits};

impl Summary {
    /// Travel and forces of the punch, or pressure of the gas.
    pub(super) fn load(&mut self, model: &Model, run: &StageSolution, last: &StepRecord) {
        let unit = model.extent().force_unit();
        let peak = run.steps.iter().copied().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force));
        let peak = peak.unwrap_or_default();
        let largest = |value| largest(run, value);
        if model.travel > 0.0 {
            self.number("travel", "Punch travel reached", Amount::place(last.travel));
            self.number("peak_punch_force", "Peak punch force", Amount::force(peak.punch_force, unit));
            self.number("peak_travel", "  at a travel of", Amount::place(peak.travel));
        }
        if !model.gas.is_empty() {
            self.number("peak_pressure", "Largest gas pressure", Amount::stress(largest(|s| s.pressure.abs())));
            self.number("pole_height", "Height of the middle", Amount::place(last.pole_height));
        }
        if let Some(control) = model.rate_control() {
            self.number("held_rate_target", "Strain rate to be held", rate(control.target));
            let least = run.steps.iter().map(|s| s.held_rate).reduce(f64::min).unwrap_or(0.0);
            self.number("held_rate_least", "  least", rate(least));
            self.number("held_rate_largest", "  largest", rate(largest(|s| s.held_rate)));
            let capped = pressure_cycle::time_on_a_cap(run);
            self.number("time_on_cap", "  time on a cap of the pressure", share(capped, last.time));
            self.number("time", "Time of the cycle", Amount::time(last.time));
        }
        if last.contact_share > 0.0 {
            self.number("contact_share", "Sheet on punch and die at the end", Amount::share(last.contact_share));
        }
    }

    /// Height, angles, and the thinnest and thickest places.
    pub(super) fn part(&mut self, model: &Model, run: &StageSolution, last: &StepRecord) {
        let end = run.frames.last();
        if let Some(height) = end.and_then(part_height) {
            self.number("part_height", "Part height over all", Amount::place(height));
        }
        if let Some(changes) = springback::changes(run) {
            self.push("springback", "Spring-back", Value::changes(&changes));
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
    }

    /// Work and heat.
    pub(super) fn balance(&mut self, model: &Model, run: &StageSolution, last: &StepRecord) {
        let unit = model.extent().energy_unit();
        let energy = |energy| Amount::energy(energy, unit);
        let work = last.work.without_round_off().scaled(JOULES);
        let given_back = work.external < 0.0;
        if given_back {
            // What the tools did is told as what they got; what was stored, as what came out of it.
            self.number("work_given_back", "Work given back to the tools", energy(-work.external));
            let mut out_of = |key, label: &str, stored: f64| self.number(key, label, energy(0.0 - stored));
            out_of("work_out_of_sheet", "  out of the sheet's elasticity", work.elastic);
            out_of("work_out_of_contact", "  out of the contact", work.contact);
        }
        let shown = |label: &'static str| if given_back { "" } else { label };
        self.number("work_external", shown("Work of the tools"), energy(work.external));
        self.number("work_plastic", "  plastic", energy(work.plastic));
        if model.mode != Mode::Flow {
            self.number("work_elastic", shown("  stored in the sheet"), energy(work.elastic));
        }
        self.number("work_friction", "  friction", energy(work.friction));
        self.number("work_contact", shown("  stored in contact"), energy(work.contact));
        self.group = Group::Solution;
        let missing = share(last.work.missing(), run.largest_work());
        self.number("imbalance", "Work missing in the balance", missing);
        let nearly_rigid = share(work.cutoff, work.plastic);
        self.number("cutoff_share", "Plastic work in nearly rigid zones", nearly_rigid);
        self.group = Group::Part;
        if model.heat.as_ref().is_some_and(|heat| heat.flow.is_some()) {
            self.number("heat_stored", "Heat stored in the sheet", energy(JOULES * last.heat.stored));
            self.number("heat_plastic", "  from plastic work", energy(JOULES * last.heat.plastic));
            self.number("heat_tools", "  from the tools", energy(JOULES * last.heat.tools));
        }
    }

    /// Distance to the forming limit.
    pub(super) fn forming_limit(&mut self, model: &Model, assessment: &Assessment) {
        if let Some(curve) = &model.forming_limit {
            self.text("forming_limit", "Forming limit", curve.name);
            let least = Amount::strain(curve.plane_strain());
            self.number("forming_limit_plane_strain", "  at plane strain, true strain", least);
        }
        if assessment.open().is_some() {
            self.push("forming_limit_unjudged", "  ends before the most strained place", Value::Flag(true));
        }
        let worst = assessment.worst();
        self.number("forming_margin", "  least margin in major true strain", Amount::strain(worst.margin()));
        self.number("forming_ratio", "  major strain over the limit there", Amount::share(worst.ratio()));
        self.number("forming_margin_s0", "  at s0, its initial distance", Amount::place(worst.s0));
        self.push("forming_margin_path_crooked", "  its path is not straight", Value::Flag(worst.is_crooked()));
        self.count("forming_paths_crooked", "  elements whose path is not straight", assessment.crooked());
        self.push("forming_limit_reached", "  reached", Value::Flag(assessment.reached.is_some()));
        if let Some(reached) = assessment.reached {
            if model.travel > 0.0 {
                self.number("forming_limit_travel", "    first at a travel of", Amount::place(reached.travel));
            } else {
                self.number("forming_limit_time", "    first at a time of", Amount::time(reached.time));
            }
            self.number("forming_limit_s0", "    at s0, its initial distance", Amount::place(reached.s0));
        }
    }

    /// Voids and temperatures.
    pub(super) fn condition(&mut self, model: &Model, run: &StageSolution, last: &StepRecord) {
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
    }

    /// Force and lift of the holder.
    pub(super) fn holder(&mut self, model: &Model, run: &StageSolution) {
        let largest = |value| largest(run, value);
        if model.tool(Role::Holder).is_some() && model.release.is_none() {
            let unit = model.extent().force_unit();
            if let Some(closing) = run.closing {
                self.number("closing_way", "Way of the holder to close over the sheet", Amount::place(closing.way));
                self.number("closing_gap", "  stands open by", Amount::thickness(closing.gap));
                self.number("closing_force", "  with a force of", Amount::force(closing.force, unit));
            }
            let width = Amount::given_thicknesses(StepRecord::RIM);
            let rim = format!("  last share on the outer {width}");
            let peak = Amount::force(largest(|s| s.holder_force), unit);
            self.number("peak_holder_force", "Largest holder force", peak);
            let shares = run.steps.iter().rev().find(|s| s.holder_force > 0.0).map_or(0.0, |s| s.rim_share);
            self.number("rim_share", &rim, Amount::share(shares));
            if let Some(lift) = holder_lift(run) {
                self.number("holder_lift", "  lifted by up to, while there is a flange", Amount::thickness(lift));
            }
        }
    }
}

/// Part of a whole; 0 of nothing.
fn share(part: f64, whole: f64) -> Amount {
    Amount::share(if whole == 0.0 { 0.0 } else { part / whole })
}

/// Strain rate \[1/s\].
fn rate(rate: f64) -> Amount {
    Amount::new(rate, Unit::PerSecond, Digits::Significant(3))
}
