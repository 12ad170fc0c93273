//! `[[tools.further]]`: tools beside the common ones, each with a name, a side of the sheet and a drive of its own.

use super::contact::{Force, Friction, Spring, force_curve, pressed};
use super::section::Section;
use super::tools::ToolContext;
use super::*;
use crate::model::Press;

const MOST: usize = 50;
const LONGEST: usize = 30;

/// Tool beside the common ones, such as an inner punch or an ejector. One drive at most is given: without, it stands.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Further {
    /// Name in tables and plots.
    pub name: String,
    /// True of a tool on the die's side, at larger z (underneath in pictures); false of one on the punch's side.
    above: bool,
    /// Section, placed where it touches the flat sheet. In a later stage it is a new tool, brought along z until it touches the
    /// sheet; without a profile there one of the stage before goes on.
    pub profile: Option<Section>,
    /// Coulomb's coefficient, 0 to 1, or another law.
    friction: Option<Friction>,
    /// Distance from the flat sheet at the start along z.
    gap: Option<NonNegative<Length>>,
    /// Drive: it moves with the punch.
    #[serde(default)]
    with_punch: bool,
    /// Drive: its displacement along z over the punch travel, [["0 mm", "0 mm"], ["10 mm", "4 mm"]].
    path: Option<Vec<(NonNegative<Length>, Length)>>,
    /// Drive of a later stage: its displacement along z over the stage.
    #[serde(rename = "move")]
    pub moved: Option<Length>,
    /// Drive: it is pressed against the sheet with this force of the whole tool, or its history over the punch travel.
    force: Option<Force>,
    /// Drive: springs with a preload.
    spring: Option<Spring>,
    /// Drive: gas springs.
    gas_spring: Option<GasSpring>,
}

/// Gas springs, whose force rises about evenly over their stroke.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct GasSpring {
    /// Force of all springs together at the begin of their stroke.
    force: HolderForce,
    /// Force at its end.
    end_force: HolderForce,
    /// Stroke.
    stroke: Positive<Length>,
}

/// Further tools of the first stage.
pub fn further_tools(frictions: &Frictions, context: &ToolContext) -> Result<Vec<Tool>> {
    let (all, source) = (&context.written.further, context.source);
    let read = |(number, further): (usize, &Further)| {
        let table = format!("tools.further.{number}");
        source.refuse(&table, &["move"], "is for later stages", "give a `path` over the punch travel")?;
        let others = all[..number].iter().map(|other| &other.name[..]).chain(Role::ALL.map(Role::name));
        let twice = others.into_iter().any(|name| name.eq_ignore_ascii_case(&further.name));
        let what = format!("another tool is called \"{}\"", further.name);
        source.require(!twice, &format!("{table}.name"), what, "name them apart")?;
        further.tool(number, &table, frictions, context)
    };
    all.iter().enumerate().map(read).collect()
}

/// Changes the further tools of a stage, written at `path`; returns those that are brought up to the sheet.
pub fn changed(
    written: &Tools, path: &str, (frictions, source): (&Frictions, &Source), model: &mut Model,
) -> Result<Vec<Role>> {
    let mut new = Vec::new();
    for (k, further) in written.further.iter().enumerate() {
        let table = format!("{path}.further.{k}");
        let number = model.further.iter().position(|name| *name == further.name).unwrap_or(model.further.len());
        model.further.extend((number == model.further.len()).then(|| further.name.clone()));
        let Model { tools: standing, further: names, blank, travel, .. } = &*model;
        let extent = model.extent();
        let context = ToolContext { written, standing, further: names, blank, extent, travel: *travel, source };
        if further.profile.is_some() {
            let tool = further.tool(number, &table, frictions, &context)?;
            model.tools.retain(|other| other.role.further() != Some(number));
            new.push(tool.role);
            model.tools.push(tool);
        } else {
            let motion = further.motion(&table, &context)?;
            let stays = model.tools.iter_mut().find(|tool| tool.role.further() == Some(number));
            stays.ok_or_else(|| source.missing(&table, "profile"))?.motion = motion;
        }
    }
    Ok(new)
}

impl ToolContext<'_> {
    /// Path of a tool's table.
    pub fn table(&self, role: Role) -> String {
        let name = self.name(role);
        let place = self.written.further.iter().position(|tool| tool.name == name);
        place.map_or_else(|| format!("tools.{name}"), |place| format!("tools.further.{place}"))
    }

    pub fn name(&self, role: Role) -> &str {
        role.further().map_or(role.name(), |number| &self.further[number])
    }
}

impl Further {
    /// New tool, written at the path `table`.
    pub fn tool(&self, number: usize, table: &str, frictions: &Frictions, context: &ToolContext) -> Result<Tool> {
        let (role, source) = (if self.above { Role::Upper } else { Role::Lower }(number as u8), context.source);
        let short = (1..=LONGEST).contains(&self.name.len());
        let plain = short && !self.name.contains(|c: char| c.is_control() || c == ',');
        let what = format!("a tool cannot be called \"{}\"", self.name);
        source.require(plain, &format!("{table}.name"), what, format!("at most {LONGEST} letters"))?;
        source.require(number < MOST, table, "there are too many tools", format!("at most {MOST} further ones"))?;
        let section = self.profile.as_ref().ok_or_else(|| source.missing(table, "profile"))?;
        let profile = section.placed(role, context)?.shifted(role.side() * self.gap.map_or(0.0, Dimensioned::value));
        let friction = frictions.law_of(self.friction, role, (&self.name, table), source)?;
        Ok(Tool { role, profile, friction, motion: self.motion(table, context)? })
    }

    /// Drive, or rest without one.
    pub fn motion(&self, table: &str, context: &ToolContext) -> Result<Motion> {
        let ToolContext { extent, source, .. } = *context;
        let drives = ["with_punch", "path", "move", "force", "spring", "gas_spring"];
        source.one_of(table, &drives, "a tool has one drive")?;
        if let Some(path) = &self.path {
            let points = path.iter().map(|(travel, z)| (travel.value(), z.value())).collect();
            let what = "a path begins with 0 mm at 0 mm of punch travel, which rises point by point; a punch travels";
            let begins = |curve: &PiecewiseLinear| curve.points()[0] == (0.0, 0.0) && context.travel > 0.0;
            let curve = PiecewiseLinear::new(points).filter(begins);
            let help = "write [[\"0 mm\", \"0 mm\"], [\"10 mm\", \"4 mm\"]]";
            return curve.map(Motion::Course).ok_or_else(|| source.error(&format!("{table}.path"), what, help));
        }
        if let Some(z) = self.moved {
            return Ok(Motion::Path(Point::new(0.0, z.value())));
        }
        if let Some(GasSpring { force, end_force, stroke }) = self.gas_spring {
            let table = format!("{table}.gas_spring");
            let of = |force: HolderForce, key: &str| force.in_extent(&format!("{table}.{key}"), extent, source);
            let (first, last) = (of(force, "force")?, of(end_force, "end_force")?);
            let (stroke, travel) = (stroke.value(), context.travel);
            let what = format!("the stroke of {} mm ends before the travel of {} mm", rounded(stroke), rounded(travel));
            source.require(stroke >= travel, &format!("{table}.stroke"), what, "a longer spring, or less travel")?;
            let what = "the force at the end of the stroke is less than at its begin";
            source.require(last >= first, &format!("{table}.end_force"), what, "see the data sheet")?;
            return Ok(Motion::Pressed(Press { force: first.into(), stiffness: (last - first) / stroke }));
        }
        if self.spring.is_some() || self.force.is_some() {
            let force = force_curve(&format!("{table}.force"), self.force.as_ref(), extent, source)?;
            return pressed(table, self.spring, force, extent, source);
        }
        Ok(if self.with_punch { Motion::Travel } else { Motion::Fixed })
    }
}
