//! Validation of models and stages before they are solved.
//!
//! Laws are checked by their values at a few places, so that a new law needs nothing here.

use super::*;
use crate::contact::friction::Sliding;
use crate::material::fracture::FractureStress;
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
/// Largest relative difference of two numbers that must agree \[–\].
const SAME: f64 = 1e-6;
const FINITE: [f64; 2] = [f64::MIN, f64::MAX];
const NOT_NEGATIVE: [f64; 2] = [0.0, f64::MAX];
const POSITIVE: [f64; 2] = [f64::MIN_POSITIVE, f64::MAX];

/// Reason why a model cannot be solved.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("`{what}` {problem}")]
pub struct ModelError {
    /// Path of the value in the model.
    pub what: String,
    /// Condition that is not met, and the found value.
    pub problem: String,
    /// Nearest whole number that can be solved.
    pub nearest: Option<usize>,
}

type Checked = Result<(), ModelError>;

fn check(holds: bool, what: &str, problem: impl FnOnce() -> String) -> Checked {
    if holds { Ok(()) } else { Err(ModelError { what: what.into(), problem: problem(), nearest: None }) }
}

fn number(what: &str, value: f64, range: [f64; 2]) -> Checked {
    let [least, most] = range;
    check((least..=most).contains(&value), what, || match range {
        FINITE => format!("must be finite, found {value:?}"),
        NOT_NEGATIVE => format!("must be zero or positive and finite, found {value:?}"),
        POSITIVE => format!("must be positive and finite, found {value:?}"),
        _ => format!("must lie between {least:?} and {most:?}, found {value:?}"),
    })
}

fn optional(what: &str, value: Option<f64>, range: [f64; 2]) -> Checked {
    value.map_or(Ok(()), |value| number(what, value, range))
}

fn numbers<const N: usize>(of: &str, values: [(&str, f64, [f64; 2]); N]) -> Checked {
    values.into_iter().try_for_each(|(key, value, range)| number(&format!("{of}.{key}"), value, range))
}

fn count(what: &str, value: usize, range: RangeInclusive<usize>) -> Checked {
    let (least, most) = (*range.start(), *range.end());
    check(range.contains(&value), what, || format!("must lie between {least} and {most}, found {value}"))
        .map_err(|error| ModelError { nearest: Some(value.clamp(least, most)), ..error })
}

fn rising(what: &str, mut before: f64, values: impl IntoIterator<Item = f64>) -> Checked {
    for value in values {
        number(what, value, FINITE)?;
        check(value > before, what, || format!("must rise from entry to entry, found {value:?} after {before:?}"))?;
        before = value;
    }
    Ok(())
}

fn curve(what: &str, curve: &PiecewiseLinear, range: [f64; 2]) -> Checked {
    curve.points().iter().try_for_each(|(x, value)| number(what, *x, FINITE).and_then(|()| number(what, *value, range)))
}

fn agree(what: &str, value: f64, other: &str, wanted: f64) -> Checked {
    let same = (value - wanted).abs() <= SAME * value.abs().max(wanted.abs());
    check(same, what, || format!("is {value:?} and must agree with `{other}`, {wanted:?}"))
}

fn needs(what: &str, given: bool, other: &str) -> Checked {
    check(given, what, || format!("needs `{other}`"))
}

fn excludes(both: bool, what: &str, other: &str) -> Checked {
    check(!both, what, || format!("and `{other}` exclude each other"))
}

fn once(is_repeated: bool, what: &str) -> Checked {
    check(!is_repeated, what, || "is given more than once".into())
}

impl Model {
    /// Checks all numbers' ranges, and that every needed part is there. Fails with the first invalid value and its bounds.
    pub fn check(&self) -> Checked {
        self.check_blank()?;
        self.check_material()?;
        self.check_tools()?;
        self.check_loads()?;
        self.heat.as_ref().map_or(Ok(()), |heat| self.check_heat(heat))?;
        self.check_motion()?;
        optional("stop.load_drop", self.stop.load_drop, POSITIVE)?;
        optional("stop.contact_share", self.stop.contact_share, [0.0, 1.0])?;
        self.settings.check()
    }

    fn check_blank(&self) -> Checked {
        let blank = &self.blank;
        numbers("blank", [("thickness", blank.thickness, POSITIVE), ("length", blank.length, POSITIVE)])?;
        number("blank.hole", blank.hole, [0.0, if blank.meridian.is_some() { f64::MAX } else { blank.length }])?;
        let stands = matches!(blank.inner_edge, Edge::Free | Edge::Guided | Edge::Clamped);
        check(stands, "blank.inner_edge", || "must be free, guided or clamped".into())?;
        needs("blank.edge_limit", blank.edge_limit.is_none() || blank.hole > 0.0, "blank.hole")?;
        needs("stop.edge_limit", !self.stop.edge_limit || blank.edge_limit.is_some(), "blank.edge_limit")?;
        count("blank.elements", blank.elements, ELEMENTS)?;
        count("blank.layers", blank.layers, if blank.theory == Theory::Membrane { 1..=1 } else { POINTS })?;
        if let Edge::Pulled { speed } = blank.edge { number("blank.edge.speed", speed, FINITE) } else { Ok(()) }
    }

    fn check_material(&self) -> Checked {
        let material = &self.material;
        let mut before = 0.0;
        for strain in STRAINS {
            let stress = material.hardening.at(strain).stress;
            number(&format!("material.hardening at a strain of {strain}"), stress, [before, f64::MAX])?;
            before = stress;
        }
        number("material.hardening", before, POSITIVE)?;
        for rate in RATES.iter().filter_map(|rate| Some(material.rate?.at(*rate))) {
            number("material.rate", rate.value, POSITIVE)?;
        }
        if let Some(Elastic { young, poisson }) = material.elastic {
            numbers("material.elastic", [("young", young, POSITIVE), ("poisson", poisson, [0.0, 0.5])])?;
        }
        number("material.yield_criterion", material.yield_criterion.ratio(), POSITIVE)?;
        for law in &material.chaboche {
            let recovery = ("dynamic_recovery", law.dynamic_recovery, NOT_NEGATIVE);
            numbers("material.chaboche", [("modulus", law.modulus, NOT_NEGATIVE), recovery])?;
        }
        let tension = FractureStress { largest: 1.0, mean: 1.0 / 3.0, equivalent: 1.0 };
        for rate in material.fracture.iter().map(|criterion| criterion.at(tension)) {
            number("material.fracture", rate, POSITIVE)?;
        }
        if let Some(gtn) = &material.gtn {
            let initial = ("initial", gtn.initial, [0.0, gtn.fracture()]);
            let factors = [("q1", gtn.q1, POSITIVE), ("q2", gtn.q2, POSITIVE), ("q3", gtn.q3, POSITIVE), initial];
            numbers("material.gtn", factors)?;
            if let Some(law) = gtn.coalescence {
                number("material.gtn.coalescence.critical", law.critical, NOT_NEGATIVE)?;
                rising("material.gtn.coalescence", law.critical, [law.fracture])?;
            }
            if let Some(law) = gtn.nucleation {
                let range = [("fraction", law.fraction, NOT_NEGATIVE), ("strain", law.strain, NOT_NEGATIVE)];
                numbers("material.gtn.nucleation", range)?;
                number("material.gtn.nucleation.deviation", law.deviation, POSITIVE)?;
            }
        }
        if self.mode == Mode::Flow {
            excludes(material.chaboche.iter().any(|law| law.modulus != 0.0), "mode flow", "material.chaboche")?;
            return excludes(self.release.is_some(), "mode flow", "release");
        }
        needs("mode", material.elastic.is_some(), "material.elastic")?;
        excludes(material.gtn.is_some(), "elastic mode", "material.gtn")
    }

    fn check_tools(&self) -> Checked {
        for (i, tool) in self.tools.iter().enumerate() {
            let Tool { role, profile, friction, motion } = tool;
            let name = role.name();
            once(self.tools[..i].iter().any(|other| other.role == *role), name)?;
            let ends = profile.pieces().iter().flat_map(|piece| [piece.first(), piece.last()]);
            ends.flat_map(|end| [end.x, end.y]).try_for_each(|x| number(&format!("{name}.profile"), x, FINITE))?;
            check_friction(&format!("{name}.friction"), friction)?;
            let path = format!("{name}.motion");
            match motion {
                Motion::Fixed | Motion::Travel => {}
                Motion::Path(way) => number(&path, way.y, FINITE).and(number(&path, way.x, FINITE))?,
                Motion::Course(course) => {
                    curve(&path, course, FINITE)?;
                    agree(&path, course.at(0.0), "its begin", 0.0)?;
                }
                Motion::Gap(gap) => number(&path, *gap, POSITIVE)?,
                Motion::Pressed(press) => {
                    curve(&path, &press.force, NOT_NEGATIVE).and(number(&path, press.stiffness, NOT_NEGATIVE))?;
                }
            }
            if matches!(motion, Motion::Pressed(_) | Motion::Gap(_)) {
                let pressed = role.further().is_some() || *role == Role::Pad && !matches!(motion, Motion::Gap(_));
                needs(name, pressed || *role == Role::Holder, "the role of a holder or a pad")?;
                needs("holder", *role != Role::Holder || self.tool(Role::Die).is_some(), "die")?;
                needs("pad", *role != Role::Pad || self.tool(Role::Punch).is_some(), "punch")?;
            }
        }
        Ok(())
    }

    fn check_loads(&self) -> Checked {
        for (i, bead) in self.beads.iter().enumerate() {
            number(&format!("beads.{i}.at"), bead.at, [0.0, self.blank.length])?;
            curve(&format!("beads.{i}.restraining"), &bead.restraining, NOT_NEGATIVE)?;
            number(&format!("beads.{i}.closing"), bead.closing, NOT_NEGATIVE)?;
        }
        for (i, gas) in self.gas.iter().enumerate() {
            once(self.gas[..i].iter().any(|other| other.face == gas.face), "gas on one face")?;
            check_gas(&format!("gas.{i}"), gas)?;
        }
        let held = self.gas.iter().filter(|gas| matches!(gas.pressure, Pressure::Rate(_))).count();
        once(held > 1, "gas that holds a strain rate")?;
        let pulled = matches!(self.blank.edge, Edge::Pulled { .. } | Edge::Fed);
        let acts = pulled || !self.tools.is_empty() || !self.gas.is_empty() || self.release.is_some();
        check(acts, "tools", || "are missing: there is no gas, no pulled edge and no release that acts either".into())
    }

    fn check_heat(&self, heat: &Heat) -> Checked {
        curve("heat.initial", &heat.initial, POSITIVE)?;
        for (_, temperature) in heat.initial.points() {
            optional("material.thermal", self.material.thermal.map(|law| law.at(*temperature)), NOT_NEGATIVE)?;
        }
        let Some(flow) = &heat.flow else { return Ok(()) };
        let shares = [("capacity", flow.capacity, POSITIVE), ("plastic_share", flow.plastic_share, [0.0, 1.0])];
        numbers("heat.flow", shares)?;
        number("heat.flow.conductivity", flow.conductivity, NOT_NEGATIVE)?;
        flow.tools.iter().try_for_each(|tool| {
            needs("heat.flow.tools", self.tool(tool.role).is_some(), tool.role.name())?;
            let transfer = ("transfer", tool.transfer, NOT_NEGATIVE);
            numbers("heat.flow.tools", [("temperature", tool.temperature, POSITIVE), transfer])
        })
    }

    fn check_motion(&self) -> Checked {
        number("duration", self.duration, POSITIVE)?;
        number("speed", self.speed, POSITIVE)?;
        let driven = self.tools.iter().any(|tool| tool.motion == Motion::Travel);
        number("travel", self.travel, if driven || self.schedule.is_some() { POSITIVE } else { NOT_NEGATIVE })?;
        if driven {
            agree("speed", self.speed, "travel over duration", self.travel / self.duration)?;
        }
        if let Some(schedule) = &self.schedule {
            curve("schedule", schedule, NOT_NEGATIVE)?;
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
    /// Checks the model, and that the stage can continue with the sheet of the one before. Fails as [`Model::check`].
    pub fn check(&self, before: Option<&Model>) -> Checked {
        self.model.check()?;
        optional("begin.trim", self.begin.trim, POSITIVE)?;
        let is_there = |role: &Role| needs("begin.meets", self.model.tool(*role).is_some(), role.name());
        self.begin.meets.iter().try_for_each(is_there)?;
        let Some(before) = before else { return Ok(()) };
        let (mine, theirs) = (&self.model.blank, &before.blank);
        agree("blank.layers", mine.layers as f64, "blank.layers of the stage before", theirs.layers as f64)?;
        agree("blank.thickness", mine.thickness, "blank.thickness of the stage before", theirs.thickness)?;
        excludes(mine.rule != theirs.rule, "blank.rule", "that of the stage before")?;
        excludes(self.model.geometry != before.geometry, "geometry", "that of the stage before")?;
        excludes(self.model.heat.is_some() != before.heat.is_some(), "heat", "that of the stage before")
    }
}

impl Settings {
    /// Checks all ranges, and the steps' order. Fails with the first invalid parameter, its key behind `settings.`.
    pub fn check(&self) -> Checked {
        count("settings.max_iterations", self.max_iterations, 1..=10_000)?;
        let ranges = [
            ("tolerance", self.tolerance, [1e-12, 0.1]),
            ("min_step", self.min_step, [1e-12, 0.1]),
            ("max_step", self.max_step, [1e-5, 0.5]),
            ("cutoff_strain", self.cutoff_strain, [1e-10, 1e-2]),
            ("contact_stiffness", self.contact_stiffness, [1.0, 1e7]),
            ("contact_smoothing", self.contact_smoothing, [1e-6, 0.1]),
            ("slip_speed", self.slip_speed, [1e-6, 1.0]),
            ("strain_step", self.strain_step, [1e-3, 1.0]),
        ];
        numbers("settings", ranges)?;
        number("settings.first_step", self.first_step, [self.min_step, self.max_step])
    }
}

fn check_gas(path: &str, gas: &Gas) -> Checked {
    number(&format!("{path}.within"), gas.within, POSITIVE)?;
    let path = format!("{path}.pressure");
    match &gas.pressure {
        Pressure::OverTime(history) => curve(&path, history, NOT_NEGATIVE),
        Pressure::Rate(control) => {
            // Without a cap both are infinite.
            let cap = [f64::MIN_POSITIVE, f64::INFINITY];
            numbers(&path, [("target", control.target, POSITIVE), ("exponent", control.exponent, [1.0, 1000.0])])?;
            numbers(&path, [("max_pressure", control.max_pressure, cap), ("max_rise", control.max_rise, cap)])
        }
    }
}

fn check_friction(what: &str, law: &Friction) -> Checked {
    number(what, law.largest_coefficient(), NOT_NEGATIVE)?;
    if let Friction::Tresca(law) = law {
        number(what, law.factor, NOT_NEGATIVE)?;
    }
    PRESSURES.into_iter().try_for_each(|pressure| {
        let drag = law.at(&Sliding { pressure, slip: 1e-3, scale: 1e-3, duration: 1.0, shear_yield: 100.0 });
        number(what, drag.value, NOT_NEGATIVE)?;
        [drag.by_pressure, drag.by_slip].into_iter().try_for_each(|slope| number(what, slope, FINITE))
    })
}
