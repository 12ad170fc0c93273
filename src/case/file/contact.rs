//! Contact with the tools: the holder's force, draw beads, and `friction` of a tool or of its side of the sheet.

use super::{material::only, tools::Holder, tools::Pad, tools::ToolKeys, values::Stiffness, *};
use crate::bead;
use crate::contact::friction::FrictionTable;
use crate::material::law::Family;
use crate::model::Press;
use crate::units::{Digits, LineForce, Unit};

/// Draw bead as a line restraint that holds the sheet back while it passes, by given forces or those of its section.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [{ "required": ["at"] }, { "required": ["diameter"] }]))]
pub struct Bead {
    /// Distance of its line from the axis or symmetry plane.
    at: Option<Positive<Length>>,
    /// Diameter of its line, instead of `at`, of a round part.
    diameter: Option<Positive<Length>>,
    /// Restraining force per length of the line, of which a plane section has one on each side. Or its history over the punch
    /// travel, as of a bead that closes late and stretches the wall: [["37 mm", "0 N/mm"], ["38 mm", "700 N/mm"]].
    restraining: Option<History<NonNegative<Length>, NonNegative<LineForce>>>,
    /// Closing force per length of the line, taken from the holder's force; none when not given.
    closing: Option<NonNegative<LineForce>>,
    /// Instead of both forces: a round bead by its section.
    round: Option<model::Round>,
}

/// Soft holder or pad.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Force where it touches the flat sheet, of the whole tool as `force`.
    preload: HolderForce,
    /// Force per move of the whole holder, "5 kN/mm"; in plane strain per depth, "50 N/mm^2", unless blank.depth is given.
    stiffness: Stiffness,
}

impl Holder {
    /// Support of the holder: exactly one of force, pressure, gap and spring.
    pub fn support(&self, profile: &Profile, die: &Tool, context: &ToolContext) -> Result<Motion> {
        let ToolContext { blank, extent, source, .. } = *context;
        source.one_of("tools.holder", &["force", "pressure", "gap", "spring"], "keep one of them")?;
        if let Some(gap) = self.gap {
            let (gap, t) = (gap.value(), blank.thickness);
            let what = format!("the holder's gap of {gap} mm is less than the sheet's thickness of {t} mm");
            let help = format!("at least {t} mm; 1.02 to 1.1 times is usual");
            source.require(gap >= t, "tools.holder.gap", what, help)?;
            return Ok(Motion::Gap(gap));
        }
        if let Some(pressure) = self.pressure {
            let area = (extent.area(blank.length) - extent.area(profile.least_r().max(shoulder_end(die)))).max(0.0);
            let force = pressure.value() * area;
            let (total, pressure) =
                (Amount::given_force(force, extent.force_unit()), Amount::given_stress(pressure.value()));
            let on = format!("{pressure} on {} mm²", Amount::new(area, Unit::None, Digits::Significant(4)));
            source.note(format!("the holder's force is its pressure on the initial area, {on}, {total}"));
            return Ok(Motion::Pressed(Press::constant(force)));
        }
        pressed("tools.holder", self.spring, self.force_curve(extent, source)?, extent, source)
    }

    /// Force that stays, or its history over the travel.
    pub fn force_curve(&self, extent: Extent, source: &Source) -> Result<Option<PiecewiseLinear>> {
        force_curve("tools.holder.force", self.force.as_ref(), extent, source)
    }
}

impl Pad {
    /// Drive of the pad: exactly one of force, pressure and spring.
    pub fn support(&self, profile: &Profile, edge: f64, extent: Extent, source: &Source) -> Result<Motion> {
        source.one_of("tools.pad", &["force", "pressure", "spring"], "keep one of them")?;
        let force = force_curve("tools.pad.force", self.force.as_ref(), extent, source)?;
        let area = extent.area(profile.first().x.max(profile.last().x).min(edge));
        let pressure = self.pressure.map(|pressure| (pressure.value() * area).into());
        pressed("tools.pad", self.spring, force.or(pressure), extent, source)
    }
}

pub type Force = History<NonNegative<Length>, HolderForce>;

pub fn force_curve(
    path: &str, force: Option<&Force>, extent: Extent, source: &Source,
) -> Result<Option<PiecewiseLinear>> {
    let value = |force: HolderForce, path: &str| force.in_extent(path, extent, source);
    force.map(|force| force.curve(path, "travels", source, value)).transpose()
}

pub fn pressed(
    table: &str, spring: Option<Spring>, force: Option<PiecewiseLinear>, extent: Extent, source: &Source,
) -> Result<Motion> {
    let press = match spring {
        Some(Spring { preload, stiffness }) => Press {
            force: preload.in_extent(&format!("{table}.spring.preload"), extent, source)?.into(),
            stiffness: stiffness.in_extent(&format!("{table}.spring.stiffness"), extent, source)?,
        },
        None => Press { force: force.ok_or_else(|| source.missing(table, "force"))?, stiffness: 0.0 },
    };
    Ok(Motion::Pressed(press))
}

/// Beads for the sheet and the tools of a model.
pub fn beads(written: &[Bead], model: &Model, source: &Source) -> Result<Vec<model::Bead>> {
    let (extent, geometry, edge) = (model.extent(), model.geometry, model.blank.length);
    let mut beads = Vec::new();
    for (i, bead) in written.iter().enumerate() {
        let path = format!("tools.beads.{i}");
        let help = "keep the forces, or the section that they are computed from";
        ["restraining", "closing"].into_iter().try_for_each(|key| source.one_of(&path, &[key, "round"], help))?;
        let lengths = [bead.at, bead.diameter, bead.at];
        let (key, at) = radius_of(source, &path, geometry, ["at", "diameter", "at"], lengths)?;
        let help = "add [tools.die], or drop the bead";
        let die = model.tool(Role::Die).ok_or_else(|| source.error(&path, "a bead needs a die to sit on", help))?;
        let flat = shoulder_end(die);
        let flange = format!("the flange, from the die's shoulder at {flat:.3} mm to the edge at {edge} mm");
        let what = format!("a bead at {at} mm is not on {flange}");
        source.require((flat..edge).contains(&at), &format!("{path}.{key}"), what, "check the unit and the blank")?;
        if let Some(round) = bead.round {
            let (line, shut, note) = bead::closed(model, &round, at).map_err(|(what, help, is_stopped_run)| {
                let mut error = source.error(&format!("{path}.round"), what, help);
                error.is_stopped_run = is_stopped_run;
                error
            })?;
            source.note(note);
            beads.push((line, shut));
            continue;
        }
        let restraining = bead.restraining.as_ref().ok_or_else(|| source.missing(&path, "restraining"))?;
        let path = format!("{path}.restraining");
        let restraining = restraining.curve(&path, "travels", source, |force, _| Ok(force.value()))?;
        let closing = bead.closing.map_or(0.0, Dimensioned::value);
        beads.push((model::Bead { at, restraining, closing, round: None }, closing));
    }
    let closing: f64 = beads.iter().map(|(bead, force)| force * (extent.times() * bead.line(geometry))).sum();
    if let Some(Motion::Pressed(press)) = model.tool(Role::Holder).map(|holder| &holder.motion) {
        let (unit, least) = (extent.force_unit().symbol(), press.force.smallest());
        let what = format!("closing the beads takes {closing:.0} {unit}, the holder has only {least:.0} {unit}");
        let help = "raise the holder's force, or lower the bead or its closing force";
        source.require(closing <= 0.0 || closing < least, "tools.beads.0", what, help)?;
    }
    Ok(beads.into_iter().map(|(bead, _)| bead).collect())
}

/// The friction law of one tool: Coulomb's coefficient, 0 to 1, or exactly one other law.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(untagged)]
pub enum Friction {
    /// Coulomb's coefficient.
    Coefficient(Fraction),
    /// Another law with its parameters.
    Law(FrictionTable),
}

untagged!(
    [] Friction, "a plain number, such as 0.1, or a law, such as { tresca = { factor = 0.2 } }",
    number(number) => Fraction::deserialize(number.into_deserializer()).map(Friction::Coefficient),
    table => Friction::Law
);

/// Friction by the face of the sheet, for tools without their own, and the source of all friction numbers.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sides {
    /// Face that punch and holder touch: a coefficient, 0 to 1, or a law.
    punch_side: Option<Friction>,
    /// Face that the die touches: a coefficient, 0 to 1, or a law.
    die_side: Option<Friction>,
    /// Source of the coefficients of all tools: how they were measured, or author and year; left out if they are assumed.
    pub source: Option<String>,
}

/// Written laws, by tool and by side of the sheet.
pub struct Frictions<'a> {
    pub tools: [Option<Friction>; Role::ALL.len()],
    sides: &'a Sides,
}

impl<'a> Frictions<'a> {
    pub fn new(file: &'a CaseFile) -> Self {
        let mut frictions = Self { tools: [None; Role::ALL.len()], sides: &file.friction };
        file.tools.keys().for_each(|tool| frictions.add(&tool));
        frictions
    }

    pub fn add(&mut self, tool: &ToolKeys) {
        let own = &mut self.tools[tool.role.index()];
        *own = tool.friction.or(*own);
    }

    /// Law of a tool: its own, that of its side, or, for a holder, the die's.
    pub fn law(&self, role: Role, source: &Source) -> Result<model::Friction> {
        let name = role.name();
        self.law_of(self.tools[role.index()], role, (name, &format!("tools.{name}")), source)
    }

    /// Law of a tool with its `own` friction, by its name and table.
    pub fn law_of(
        &self, own: Option<Friction>, role: Role, (name, table): (&str, &str), source: &Source,
    ) -> Result<model::Friction> {
        let law = |law: Friction, path: &str| match law {
            Friction::Coefficient(coefficient) => Ok(coefficient.value().into()),
            Friction::Law(table) => only(model::Friction::named(table), None, path, source),
        };
        if let Some(own) = own {
            return law(own, &format!("{table}.friction"));
        }
        let below = (self.sides.punch_side, "friction.punch_side");
        let (side, path) = if role.side() < 0.0 { below } else { (self.sides.die_side, "friction.die_side") };
        let (law, origin) = match (side, role) {
            (Some(side), _) => (law(side, path)?, "that of its side of the sheet"),
            (None, Role::Holder) => (source.silently(|| self.law(Role::Die, source))?, "the die's"),
            (None, _) => return Err(source.missing(table, "friction")),
        };
        source.note(format!("the {name}'s friction is {origin}, {law}"));
        Ok(law)
    }
}
