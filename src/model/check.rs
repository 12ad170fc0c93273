//! Validation of models and stages before they are solved.
//!
//! Laws are checked by their values at a few places, so that a new law needs nothing here.

use super::error::{
    Checked, agree, check, count, curve, excludes, finite, needs, not_negative, positive, rising, within,
};
use super::{Blank, Edge, Friction, Gas, Heat, Mode, Model, Motion, Pressure, Role, Settings, Stage, Theory, Tool};
use crate::contact::friction::Sliding;
use crate::material::Material;
use std::ops::RangeInclusive;

/// Strains at which hardening laws are checked \[–\].
const STRAINS: [f64; 6] = [0.0, 1e-4, 1e-2, 0.1, 1.0, 5.0];
/// Strain rates at which rate laws are checked \[1/s\].
const RATES: [f64; 4] = [1e-6, 1e-3, 1.0, 1e3];
/// Contact pressures at which friction laws are checked \[MPa\].
const PRESSURES: [f64; 3] = [1e-2, 1.0, 1e3];
/// Allowed numbers of elements, and of points through the thickness.
const ELEMENTS: RangeInclusive<usize> = 2..=100_000;
const POINTS: RangeInclusive<usize> = 2..=1000;

impl Model {
    /// Checks that every number is finite and in its range, and that every needed part is there.
    ///
    /// # Errors
    /// The first invalid value, with its bounds.
    pub fn check(&self) -> Checked {
        self.blank.check()?;
        self.material.check()?;
        self.check_mode()?;
        self.check_tools()?;
        self.check_loads()?;
        self.heat.as_ref().map_or(Ok(()), |heat| heat.check(self))?;
        self.check_motion()?;
        optional(self.stop.load_drop, |share| positive("stop.load_drop", share))?;
        optional(self.stop.contact_share, |share| within("stop.contact_share", share, 0.0, 1.0))?;
        self.settings.check()
    }

    fn check_mode(&self) -> Checked {
        let material = &self.material;
        let shifts = material.chaboche.iter().any(|law| law.modulus != 0.0);
        if self.mode == Mode::Flow {
            excludes(shifts, "mode flow", "material.chaboche")?;
            return excludes(self.release.is_some(), "mode flow", "release");
        }
        needs("mode", material.elastic.is_some(), "material.elastic")?;
        excludes(material.gtn.is_some(), "elastic mode", "material.gtn")?;
        excludes(self.blank.theory == Theory::Selective, "elastic mode", "selective theory")
    }

    fn check_tools(&self) -> Checked {
        for (i, tool) in self.tools.iter().enumerate() {
            let twice = self.tools[..i].iter().any(|other| other.role == tool.role);
            check(!twice, tool.role.name(), || "is given more than once".into())?;
            tool.check()?;
            if matches!(tool.motion, Motion::Pressed(_) | Motion::Gap(_)) {
                needs(tool.role.name(), tool.role == Role::Holder, "the role of a holder")?;
                needs("holder", self.tool(Role::Die).is_some(), "die")?;
            }
        }
        Ok(())
    }

    fn check_loads(&self) -> Checked {
        for (i, bead) in self.beads.iter().enumerate() {
            within(&format!("beads.{i}.at"), bead.at, 0.0, self.blank.length)?;
            not_negative(&format!("beads.{i}.restraining"), bead.restraining)?;
            not_negative(&format!("beads.{i}.closing"), bead.closing)?;
        }
        for (i, gas) in self.gas.iter().enumerate() {
            let twice = self.gas[..i].iter().any(|other| other.face == gas.face);
            check(!twice, "gas on one face", || "is given more than once".into())?;
            gas.check(&format!("gas.{i}"))?;
        }
        let held = self.gas.iter().filter(|gas| matches!(gas.pressure, Pressure::Rate(_))).count();
        check(held < 2, "gas that holds a strain rate", || "is given more than once".into())?;
        let pulled = matches!(self.blank.edge, Edge::Pulled { .. });
        let acts = pulled || !self.tools.is_empty() || !self.gas.is_empty() || self.release.is_some();
        check(acts, "tools", || "are missing: there is no gas, no pulled edge and no release that acts either".into())
    }

    fn check_motion(&self) -> Checked {
        positive("duration", self.duration)?;
        positive("speed", self.speed)?;
        not_negative("travel", self.travel)?;
        if self.tools.iter().any(|tool| tool.motion == Motion::Travel) {
            positive("travel", self.travel)?;
            agree("speed", self.speed, "travel over duration", self.travel / self.duration)?;
        }
        if let Some(schedule) = &self.schedule {
            positive("travel", self.travel)?;
            curve("schedule", schedule, not_negative)?;
            let (first, last) = (schedule.points()[0], schedule.points()[schedule.points().len() - 1]);
            agree("first time of the schedule", first.0, "zero", 0.0)?;
            agree("first travel of the schedule", first.1, "zero", 0.0)?;
            agree("last time of the schedule", last.0, "duration", self.duration)?;
            agree("last travel of the schedule", last.1, "travel", self.travel)?;
            rising("travels of the schedule", 0.0, schedule.points()[1..].iter().map(|point| point.1))?;
        }
        check(!self.frames.is_empty(), "frames", || "is empty".into())?;
        rising("frames", 0.0, self.frames.iter().copied())?;
        agree("last of the frames", self.frames[self.frames.len() - 1], "duration", self.duration)
    }
}

impl Stage {
    /// Checks the model, and that the stage can continue with the sheet of the one before.
    ///
    /// # Errors
    /// As [`Model::check`].
    pub fn check(&self, before: Option<&Model>) -> Checked {
        self.model.check()?;
        optional(self.begin.trim, |radius| positive("begin.trim", radius))?;
        for role in &self.begin.meets {
            needs("begin.meets", self.model.tool(*role).is_some(), role.name())?;
        }
        let Some(before) = before else { return Ok(()) };
        let (mine, theirs) = (&self.model.blank, &before.blank);
        agree("blank.layers", mine.layers as f64, "blank.layers of the stage before", theirs.layers as f64)?;
        agree("blank.thickness", mine.thickness, "blank.thickness of the stage before", theirs.thickness)?;
        excludes(mine.rule != theirs.rule, "blank.rule", "that of the stage before")?;
        excludes(self.model.geometry != before.geometry, "geometry", "that of the stage before")?;
        excludes(self.model.heat.is_some() != before.heat.is_some(), "heat", "that of the stage before")
    }
}

impl Blank {
    fn check(&self) -> Checked {
        positive("blank.thickness", self.thickness)?;
        positive("blank.length", self.length)?;
        count("blank.elements", self.elements, ELEMENTS)?;
        match self.theory {
            Theory::Membrane => count("blank.layers", self.layers, 1..=1)?,
            Theory::Bending | Theory::Selective => count("blank.layers", self.layers, POINTS)?,
        }
        match self.edge {
            Edge::Pulled { speed } => finite("blank.edge.speed", speed),
            Edge::Free | Edge::Clamped => Ok(()),
        }
    }
}

impl Material {
    fn check(&self) -> Checked {
        let mut before = 0.0;
        for strain in STRAINS {
            let stress = self.hardening.at(strain).stress;
            let at = format!("material.hardening at a strain of {strain}");
            not_negative(&at, stress)?;
            within(&at, stress, before, f64::MAX)?;
            before = stress;
        }
        positive("material.hardening", before)?;
        for rate in RATES.iter().filter_map(|rate| Some(self.rate?.at(*rate))) {
            positive("material.rate", rate.value)?;
        }
        if let Some(elastic) = self.elastic {
            positive("material.elastic.young", elastic.young)?;
            within("material.elastic.poisson", elastic.poisson, 0.0, 0.5)?;
        }
        positive("material.yield_criterion", self.yield_criterion.ratio())?;
        for law in &self.chaboche {
            not_negative("material.chaboche.modulus", law.modulus)?;
            not_negative("material.chaboche.dynamic_recovery", law.dynamic_recovery)?;
        }
        let Some(gtn) = &self.gtn else { return Ok(()) };
        for (what, value) in [("q1", gtn.q1), ("q2", gtn.q2), ("q3", gtn.q3)] {
            positive(&format!("material.gtn.{what}"), value)?;
        }
        if let Some(law) = gtn.coalescence {
            not_negative("material.gtn.coalescence.critical", law.critical)?;
            rising("material.gtn.coalescence", law.critical, [law.fracture])?;
        }
        if let Some(law) = gtn.nucleation {
            not_negative("material.gtn.nucleation.fraction", law.fraction)?;
            not_negative("material.gtn.nucleation.strain", law.strain)?;
            positive("material.gtn.nucleation.deviation", law.deviation)?;
        }
        within("material.gtn.initial", gtn.initial, 0.0, gtn.fracture())
    }
}

impl Tool {
    fn check(&self) -> Checked {
        let name = self.role.name();
        let ends = self.profile.pieces().iter().flat_map(|piece| [piece.first(), piece.last()]);
        ends.flat_map(|end| [end.x, end.y]).try_for_each(|x| finite(&format!("{name}.profile"), x))?;
        slides(&format!("{name}.friction"), &self.friction)?;
        let motion = format!("{name}.motion");
        match &self.motion {
            Motion::Fixed | Motion::Travel => Ok(()),
            Motion::Path(way) => finite(&motion, way.y).and(finite(&motion, way.x)),
            Motion::Gap(gap) => positive(&motion, *gap),
            Motion::Pressed(press) => {
                curve(&motion, &press.force, not_negative).and(not_negative(&motion, press.stiffness))
            }
        }
    }
}

impl Gas {
    fn check(&self, at: &str) -> Checked {
        positive(&format!("{at}.within"), self.within)?;
        let pressure = format!("{at}.pressure");
        match &self.pressure {
            Pressure::OverTime(history) => curve(&pressure, history, not_negative),
            Pressure::Rate(control) => {
                positive(&format!("{pressure}.target"), control.target)?;
                within(&format!("{pressure}.exponent"), control.exponent, 1.0, 1000.0)?;
                // Without a cap both are infinite.
                within(&format!("{pressure}.max_pressure"), control.max_pressure, f64::MIN_POSITIVE, f64::INFINITY)?;
                within(&format!("{pressure}.max_rise"), control.max_rise, f64::MIN_POSITIVE, f64::INFINITY)
            }
        }
    }
}

impl Heat {
    fn check(&self, model: &Model) -> Checked {
        curve("heat.initial", &self.initial, positive)?;
        for (_, temperature) in self.initial.points() {
            optional(model.material.thermal, |law| not_negative("material.thermal", law.at(*temperature)))?;
        }
        let Some(flow) = &self.flow else { return Ok(()) };
        positive("heat.flow.capacity", flow.capacity)?;
        within("heat.flow.plastic_share", flow.plastic_share, 0.0, 1.0)?;
        not_negative("heat.flow.conductivity", flow.conductivity)?;
        for tool in &flow.tools {
            needs("heat.flow.tools", model.tool(tool.role).is_some(), tool.role.name())?;
            positive("heat.flow.tools.temperature", tool.temperature)?;
            not_negative("heat.flow.tools.transfer", tool.transfer)?;
        }
        Ok(())
    }
}

impl Settings {
    /// Checks that every parameter is in its range and the steps in their order.
    ///
    /// # Errors
    /// The first invalid parameter; `what` is its key behind `settings.`.
    pub fn check(&self) -> Checked {
        count("settings.max_iterations", self.max_iterations, 1..=10_000)?;
        optional(self.facets, |facets| count("settings.facets", facets, 1..=1000))?;
        for (key, value, least, most) in [
            ("tolerance", self.tolerance, 1e-12, 0.1),
            ("min_step", self.min_step, 1e-12, 0.1),
            ("max_step", self.max_step, 1e-5, 0.5),
            ("cutoff_strain", self.cutoff_strain, 1e-10, 1e-2),
            ("contact_stiffness", self.contact_stiffness, 1.0, 1e7),
            ("contact_smoothing", self.contact_smoothing, 1e-6, 0.1),
            ("slip_speed", self.slip_speed, 1e-6, 1.0),
            ("strain_step", self.strain_step, 1e-3, 1.0),
            ("bend_ratio", self.bend_ratio, 1e-4, 1.0),
        ] {
            within(&format!("settings.{key}"), value, least, most)?;
        }
        within("settings.first_step", self.first_step, self.min_step, self.max_step)
    }
}

fn optional<T>(value: Option<T>, valid: impl FnOnce(T) -> Checked) -> Checked {
    value.map_or(Ok(()), valid)
}

fn slides(what: &str, law: &Friction) -> Checked {
    not_negative(what, law.largest_coefficient())?;
    if let Friction::Tresca(law) = law {
        not_negative(what, law.factor)?;
    }
    for pressure in PRESSURES {
        let drag = law.at(&Sliding { pressure, slip: 1e-3, scale: 1e-3, duration: 1.0, shear_yield: 100.0 });
        not_negative(what, drag.value)?;
        finite(what, drag.by_pressure)?;
        finite(what, drag.by_slip)?;
    }
    Ok(())
}
