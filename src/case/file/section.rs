//! `profile`: section of a tool, drawn in steps, read from a file or made from another tool; then placed.

use super::{counter::Counter, points::Points, *};
use crate::geometry::{Arc, Fold, with_radius};
use crate::import;
use crate::model::tool_sizes::met;

/// Largest move of an arc's centre onto the bisector of its ends \[mm\]: drawings are rounded.
const ROUNDED: f64 = 0.01;
/// Largest turn of one arc \[rad\]: half a circle, and round-off.
const HALF_TURN: f64 = std::f64::consts::PI + 1e-6;
const PLACES: usize = 400;
/// Depth of a tool in a drawn sheet over half the thickness that is taken for round-off \[–\].
const LIES: f64 = 0.02;

/// Section of a tool, the sheet on the left as one goes along it: steps, the name of a CSV file with points, or a table.
///
/// Wherever it is drawn along z, it is moved to where it touches the flat sheet.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
pub enum Section {
    /// Lines and arcs.
    Steps(Vec<ProfileStep>),
    /// CSV file, looked up from the case file's folder: columns `r_mm,z_mm` (any unit of length; `x_mm` in plane
    /// strain) and optionally `radius_mm`, the fillet radius at the point. Without any fillet, corners of less than 25°
    /// are rounded off by tangent arcs: the points are taken as chords of a curve. Or a drawing (DXF) of one line: x
    /// is the distance from the axis, y is z.
    File(String),
    /// A file with a fillet or a layer, or a tool made from another.
    Table(SectionTable),
}

/// `{ file, fillet }`, `{ file, layer }`, `{ offset_of, by, shoulder, closed_at }` or `{ mirror_of }`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "fillet": ["file"], "layer": ["file"], "offset_of": ["by"], "by": ["offset_of"], "shoulder": ["offset_of"], "closed_at": ["offset_of", "shoulder"] }))]
pub struct SectionTable {
    /// CSV file with points, or a drawing.
    file: Option<String>,
    /// Layer of the drawing that has the line; of all layers when not given.
    layer: Option<String>,
    /// Fillet radius of all inner points of the file that have none of their own; "0 mm" keeps them sharp.
    fillet: Option<NonNegative<Length>>,
    /// Punch or die whose outline this tool follows, so that the two close on each other: every point of this
    /// tool then lies `by` away from the other. A sharp corner of the other becomes an arc of radius `by`.
    pub offset_of: Option<Role>,
    /// Gap between the two tools when they have closed: the sheet's thickness and the clearance.
    pub by: Option<Positive<Length>>,
    /// Die around a punch with a wall: the cavity ends at the die's face, on which the flat sheet lies, with this
    /// radius. Without it the offset is the whole die: for a punch that is drawn as far as the blank reaches.
    pub shoulder: Option<Positive<Length>>,
    /// Only with `shoulder`: punch travel at which the gap is `by` everywhere, which is how deep the cavity is; the
    /// whole travel when not given. Without `shoulder` it follows from the die touching the flat sheet.
    pub closed_at: Option<Positive<Length>>,
    /// Tool on the other side of the sheet whose mirror image this is: a holder of the die's form, or the other way round.
    pub mirror_of: Option<Role>,
}

/// One step of a drawn section: `from` first, then `to` for straight lines, `arc_to` with `center` and `turn` for arcs.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "arc_to": ["center", "turn"], "center": ["arc_to"], "turn": ["arc_to"], "radius": ["arc_to"] }))]
pub struct ProfileStep {
    /// First point: [r, z].
    from: Option<[Length; 2]>,
    /// End of a straight line: [r, z].
    to: Option<[Length; 2]>,
    /// End of an arc: [r, z].
    arc_to: Option<[Length; 2]>,
    /// Centre of the arc: [r, z].
    center: Option<[Length; 2]>,
    /// Sense of the arc as one goes along it.
    turn: Option<Turn>,
    /// Another radius of an arc between two lines, which stay and meet it: for `--set` and studies.
    radius: Option<Positive<Length>>,
}

/// Sense of an arc as one goes along it, r to the right and z upward.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Turn {
    /// Counter-clockwise: a hollow of the tool.
    Left,
    /// Clockwise: a convex corner that bends the sheet.
    Right,
}

untagged!(
    [] Section, "a list of steps, the name of a file such as \"die.csv\" or \"die.dxf\", or a table",
    text(file) => Ok(Section::File(file.to_owned())),
    list => Section::Steps,
    table => Section::Table
);

impl Section {
    /// Chain as it is drawn, of a tool or a sheet with this name.
    pub fn drawn(&self, path: &str, of: (&str, Geometry), source: &Source) -> Result<Profile> {
        Ok(self.read(path, Role::Lower(0), of, source)?.0)
    }

    pub fn placed(&self, role: Role, context: &ToolContext) -> Result<Profile> {
        let (path, source) = (format!("{}.profile", context.table(role)), context.source);
        let alone = |kind: &str, others: &[&str]| {
            source.refuse(&path, others, &format!("does not go with `{kind}`"), "drop one of the two")
        };
        let counter = |of| Counter { role, of, path: path.clone(), context };
        let (profile, origin) = match self {
            Self::Table(table @ SectionTable { file: None, offset_of: Some(of), .. }) => {
                alone("offset_of", &["fillet", "layer", "mirror_of"])?;
                return counter(*of).offset(table);
            }
            Self::Table(SectionTable { file: None, mirror_of: Some(of), .. }) => {
                alone("mirror_of", &["fillet", "layer", "by", "shoulder", "closed_at"])?;
                return counter(*of).mirror();
            }
            Self::Table(SectionTable { file: None, .. }) => {
                let help = "write { file = \"die.csv\" }, { offset_of = \"punch\", by = \"1.2 mm\" } or { mirror_of = \"die\" }";
                return Err(source.error(&path, "the profile names neither a file nor a tool to make it from", help));
            }
            _ => {
                alone("file", &["offset_of", "by", "shoulder", "closed_at", "mirror_of"])?;
                self.read(&path, role, (context.name(role), context.extent.geometry()), source)?
            }
        };
        let drawn = Drawn { profile, path, origin };
        drawn.check_folds(context.name(role), source)?;
        drawn.placed(role, context).map(|(profile, _)| profile)
    }

    fn read(&self, path: &str, role: Role, of: (&str, Geometry), source: &Source) -> Result<(Profile, Origin)> {
        let (file, key, layer, fillet) = match self {
            Self::Steps(list) => return Ok((steps(list, path, source)?, Origin::Steps)),
            Self::File(file) => (file, path.to_owned(), None, None),
            Self::Table(SectionTable { file: Some(file), layer, fillet, .. }) => {
                (file, format!("{path}.file"), layer.as_deref(), fillet.map(Dimensioned::value))
            }
            _ => return Err(source.error(path, "a sheet follows no tool", "write steps, or the name of a file")),
        };
        let is_drawing = file.to_lowercase().ends_with(".dxf");
        let fits = if is_drawing { fillet.is_none() } else { layer.is_none() };
        source.require(fits, path, "a `layer` is of a drawing, a `fillet` of points", "drop it")?;
        if !is_drawing {
            return points::convert(file, &key, fillet, of, source)
                .map(|(line, points)| (line, Origin::Points(points)));
        }
        let refused = |what: &str, help: &str| source.error(&key, format!("the drawing {file}: {what}"), help);
        let text = source
            .file(&source.folder.path.join(file), import::LARGEST)
            .map_err(|error| refused(&error.to_string(), "put it beside the case, as DXF in text form"))?;
        let profile = import::line(text.as_bytes(), layer, role).map_err(|error| refused(&error.what, &error.help))?;
        source.note(format!("the {}'s profile is read from {file}: {} lines and arcs", of.0, profile.pieces().len()));
        Ok((profile, Origin::Tool))
    }
}

fn steps(steps: &[ProfileStep], path: &str, source: &Source) -> Result<Profile> {
    let mut pieces = Vec::new();
    let mut start = None;
    for (i, step) in steps.iter().enumerate() {
        let require = |ok: bool, what: &str, help: &str| source.require(ok, &format!("{path}.{i}"), what, help);
        let fail = |what: &str, help: &str| Err(source.error(&format!("{path}.{i}"), what, help));
        let ProfileStep { from, to, arc_to, center, turn, .. } = *step;
        let end = match (i, from, to, arc_to) {
            (0, Some(first), None, None) => point(first),
            (0, ..) => return fail("a profile begins with its first point", "write { from = [\"0 mm\", \"0 mm\"] }"),
            (_, None, Some(end), None) | (_, None, None, Some(end)) => point(end),
            _ => {
                let help = "write { to = [..] } or { arc_to = [..], center = [..], turn = .. }";
                return fail("a step is either a line or an arc", help);
            }
        };
        let is_whole = [center.is_some(), turn.is_some()] == [arc_to.is_some(); 2];
        let help = "write { arc_to = [..], center = [..], turn = \"right\" }";
        require(is_whole, "an arc has `arc_to`, `center` and `turn`", help)?;
        require(end.x >= 0.0, "a point lies at negative r", "the section is drawn from the axis outward, r >= 0")?;
        let Some(from) = start.replace(end) else { continue };
        require((end - from as Point).norm() >= 1e-6, "a step has no length", "drop it")?;
        let Some((center, turn)) = center.zip(turn) else {
            pieces.push(Piece::line(from, end));
            continue;
        };
        let (arc, moved) = Arc::between(from, end, point(center), turn == Turn::Left);
        require(moved <= ROUNDED, "the ends of an arc are not equally far from its center", "check `center`")?;
        let what = format!("an arc turns by {:.0}°, more than half a circle", arc.sweep.abs().to_degrees());
        require(arc.sweep.abs() <= HALF_TURN, &what, "check `turn`: it is seen with z upward; plots draw z downward")?;
        pieces.push(Piece::Arc(arc));
    }
    for (i, radius) in steps.iter().enumerate().filter_map(|(i, step)| Some((i, step.radius?.value()))) {
        let (what, help) = ("a `radius` is of an arc between two lines with room for it", "make it smaller");
        let around = i.checked_sub(2).and_then(|before| pieces.get(before..=i));
        let rounded = around.and_then(|around| with_radius(around, radius));
        pieces.splice(i - 2..=i, rounded.ok_or_else(|| source.error(&format!("{path}.{i}.radius"), what, help))?);
    }
    Profile::new(pieces).map_err(|error| source.error(path, format!("profile: {error}"), "add steps"))
}

fn point([r, z]: [Length; 2]) -> Point {
    Point::new(r.value(), z.value())
}

pub struct Drawn {
    pub profile: Profile,
    pub path: String,
    pub origin: Origin,
}

pub enum Origin {
    /// Piece i is step i + 1.
    Steps,
    Points(Points),
    /// Made from another tool, or drawn.
    Tool,
}

impl Drawn {
    fn written(&self) -> &Profile {
        if let Origin::Points(points) = &self.origin { &points.chords } else { &self.profile }
    }

    fn error(&self, piece: usize, source: &Source, what: String, help: impl Into<String>) -> CaseError {
        match &self.origin {
            Origin::Steps => source.error(&format!("{}.{}", self.path, piece + 1), what, help),
            Origin::Points(points) => points.error(piece + 1, what, help),
            Origin::Tool => source.error(&self.path, what, help),
        }
    }

    pub fn check_folds(&self, name: &str, source: &Source) -> Result<()> {
        let help = "the section is one open line along the side that meets the sheet, not a closed outline";
        let end_name = |piece: usize| match &self.origin {
            Origin::Points(points) => format!("line {}", points.lines[piece + 1]),
            _ => format!("step {}", piece + 1),
        };
        match self.written().fold() {
            None => Ok(()),
            Some(Fold::Back { at, after, turn }) => {
                let (at, turn) = (place_of(at), turn.abs().to_degrees());
                let what = format!("the {name}'s profile turns back on itself at {at}: by {turn:.0}°");
                Err(self.error(after, source, what, "drop the point, or round the tip off"))
            }
            Some(Fold::Crossing { at, pieces: [i, j] }) => {
                let (at, first, second) = (place_of(at), end_name(i), end_name(j));
                let what = format!("the {name}'s profile meets itself at {at}: the pieces to {first} and to {second}");
                Err(self.error(j, source, what, help))
            }
        }
    }

    /// Section where it touches the flat sheet, the sheet on its left, and its move along z \[mm\].
    pub fn placed(self, role: Role, context: &ToolContext) -> Result<(Profile, f64)> {
        if context.blank.meridian.is_some() {
            return Ok((self.profile, 0.0));
        }
        let (length, name, source) = (context.blank.length, context.name(role), context.source);
        let side = role.side();
        let Some(first) = self.profile.extreme(side < 0.0, context.blank.ends()) else {
            let what = format!("the {name} lies beyond the blank's edge at {length} mm");
            return Err(source.error(&self.path, what, "check the r coordinates and the size of the blank"));
        };
        let shift = side * 0.5 * context.blank.thickness - first.y;
        if shift.abs() > 1e-6 {
            let by = Amount::size(shift);
            source.note(format!("the {name}'s profile is moved by {by} along z to touch the flat sheet"));
        }
        let profile = self.profile.shifted(shift);
        let piece_at = |at: Point| self.written().closest(at).piece;
        // First r at which the middle of the flat sheet lies on the tool's side.
        let sheet_inside = |profile: &Profile| {
            let [hole, length] = context.blank.ends();
            let mut places = (0..=PLACES).map(|i| hole + (length - hole) * i as f64 / PLACES as f64);
            places.find(|r| profile.closest(Point::new(*r, 0.0)).distance < 0.0)
        };
        if let Some(r) = sheet_inside(&profile) {
            let what = format!("the {name}'s profile has the sheet on its right, inside the tool, at r = {r:.3} mm");
            let help = match sheet_inside(&profile.reversed()) {
                None => "list the points the other way round: the sheet lies on the left",
                Some(_) => "the sheet lies on the left all along: check the order of the points there",
            };
            return Err(self.error(piece_at(Point::new(r, -shift)), source, what, help));
        }
        // Steeper than 45°: an undrawn outline could hardly turn away again.
        let into_sheet = |(at, away): &(Point, Point)| at.x < length && -side * away.y > 0.7;
        if let Some((at, _)) = self.profile.ends().into_iter().flatten().find(into_sheet) {
            let (towards, away) = if side > 0.0 { ("down", "up") } else { ("up", "down") };
            let what = format!("the {name}'s profile ends on its way {towards} to the sheet, at {}", place_of(at));
            let help = format!("its walls go {away}, away from the sheet: check the sign of z");
            return Err(self.error(piece_at(at), source, what, help));
        }
        Ok((profile, shift))
    }
}

impl ToolContext<'_> {
    /// Section of a new tool, where it touches the flat sheet. Beside a sheet that is not flat tools stand where they are drawn,
    /// and the punch is brought along z until it touches it; all are brought to a sheet that an earlier run has formed.
    pub fn new_profile(&self, role: Role) -> Result<Profile> {
        let drawn = self.drawn_profile(role)?;
        if self.blank.meridian.is_none() || !self.standing.is_empty() {
            return Ok(drawn);
        }
        let sheet: Vec<_> = self.blank.mid_surface(PLACES).collect();
        if role == Role::Punch || self.blank.preform.is_some() {
            return Ok(drawn.shifted(met(&drawn, role.side(), &sheet, [self.blank.thickness, 0.0])));
        }
        let inside = |(at, half): &&(Point, f64)| drawn.closest(*at).distance < half * (1.0 - LIES);
        let Some((at, _)) = sheet.iter().find(inside) else { return Ok(drawn) };
        let what = format!("the {} cuts into the sheet at {}", role.name(), place_of(*at));
        let help = "it stands where it is drawn, beside `blank.profile`: the sheet lies on the left of its line";
        Err(self.source.error(&format!("tools.{}", role.name()), what, help))
    }
}
