//! Tool sections from a drawing (DXF): lines, arcs, polylines and splines joined into oriented chains, one per tool.
//!
//! ```text
//! text → dxf                     entities and their numbers, the header's unit
//!    │ blocks                     each block as often as it is referred to
//!    │ layers                     tool and operation of each layer
//!    │ stroke, spline             entity → Stroke: pieces in mm
//!    │ axis, halves               is the axis at x = 0? a second half is compared and left out
//!    │ chain                      strokes joined end to end: gaps, overlaps, branches are named
//!    └ orient                     Section: sheet on the left; of outlines the side towards the sheet
//! ```
//!
//! # Frame
//! In the drawing x is the distance from the axis (or the symmetry plane) and y goes up. In a section r = x, and z goes
//! the way the punch moves: z = −y for a punch above the sheet. Tools stay where they are drawn.

mod axis;
mod blocks;
mod chain;
mod dxf;
mod frame;
mod halves;
mod layers;
mod options;
mod orient;
mod spline;
mod stroke;

pub use dxf::LARGEST;
pub use options::{DrawingUnit, Heading, Options, layer};

use crate::geometry::{Bounds, Point, Profile};
use crate::model::{Geometry, Role};
use crate::units::parse;
use layers::ToolId;
use std::{collections::BTreeSet, fmt};

/// Reason why no section can be read from a drawing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}\n  {help}")]
pub struct ImportError {
    /// The error, with the entities and the place.
    pub what: String,
    /// Remedy.
    pub help: String,
    /// Line of the file, from 1, of the first named entity.
    pub line: Option<usize>,
}

impl ImportError {
    fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into(), line: None }
    }

    fn at(self, line: usize) -> Self {
        Self { line: Some(line), ..self }
    }
}

pub(crate) type Result<T = (), E = ImportError> = std::result::Result<T, E>;

fn ensure(fits: bool, error: impl FnOnce() -> ImportError) -> Result {
    if fits { Ok(()) } else { Err(error()) }
}

/// Label of a strip's blank, before its width, thickness and length: `240 mm x 1 mm x 1000 mm`.
pub const STRIP: &str = "blank L = ";
/// Label of the trimmed part.
pub const FINISHED: &str = "finished: ";
/// Label of the sheet once its tools are taken away.
pub const RELEASED: &str = "sprung back";
const FORMED: [&str; 2] = ["sheet", "midline"];
/// Words before the sizes of the trimmed part.
pub const SIZES: [&str; 3] = ["height ", "diameter ", "flange diameter "];

fn length(text: &str) -> Option<f64> {
    Some(parse(text).ok()?.value)
}

/// Sizes of the trimmed part \[mm\], in the order of [`SIZES`], where the drawing has its label.
fn finished(text: &str) -> [Option<f64>; 3] {
    let label = text.lines().find_map(|line| line.trim().strip_prefix(FINISHED)).unwrap_or_default();
    SIZES.map(|name| label.split(", ").find_map(|size| length(size.strip_prefix(name)?)))
}

/// Section of a tool.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// The tool.
    pub role: Role,
    /// Profile with the sheet on its left, z along the punch travel, not moved.
    pub profile: Profile,
    /// Ends of drawn lines, arcs and splines \[mm\].
    pub ends: Vec<Point>,
    /// Source, `4 entities of layer "PUNCH"`.
    pub made_of: String,
}

/// Tools of one operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// Number in the layers' names, if any.
    pub number: Option<u32>,
    /// Punch, die, holder as far as they are drawn.
    pub tools: Vec<Section>,
    /// Lowest z of the formed sheet \[mm\], where its layer SHEET or MIDLINE is drawn.
    pub sheet_end: Option<f64>,
}

impl Operation {
    /// `OP30`.
    pub fn name(&self) -> String {
        self.number.map_or_else(|| "the first operation".to_owned(), |number| format!("OP{number}"))
    }

    /// Section of a tool, if drawn.
    pub fn tool(&self, role: Role) -> Option<&Section> {
        self.tools.iter().find(|tool| tool.role == role)
    }
}

impl fmt::Display for Operation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.tools.iter().try_for_each(|Section { role, profile, made_of, .. }| {
            let pieces = profile.pieces().len();
            let drawn = if pieces == 1 { "line or arc" } else { "lines and arcs" };
            writeln!(f, "{:<8}{pieces} {drawn} from {made_of}", role.name())
        })
    }
}

/// Tools read from a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// Operations by their numbers, one at least.
    pub operations: Vec<Operation>,
    /// Hole, edge and thickness of the blank \[mm\], where its layer is drawn.
    pub blank: Option<[f64; 3]>,
    /// Least and largest z of the blank \[mm\], where it is a tube: the end with the largest stays.
    pub tube: Option<[f64; 2]>,
    /// Height, diameter and flange diameter of the trimmed part \[mm\], where they are labelled.
    pub finished: [Option<f64>; 3],
    /// Plane strain if the blank is labelled as that of a strip.
    pub geometry: Geometry,
    /// Length of the strip across the section \[mm\], where it is labelled.
    pub depth: Option<f64>,
    /// True if a formed sheet is labelled as sprung back.
    pub is_released: bool,
    /// All layers with the number of their entities.
    pub layers: String,
    /// Names of layers that are left out.
    pub others: Vec<String>,
    /// How the drawing was understood: unit, direction, halves, joints, omissions.
    pub notes: Vec<String>,
}

/// Reads the tools' sections from the bytes of a DXF file (text; binary DXF is refused).
/// Fails when the drawing is damaged, its unit or axis unknown, or a tool's lines make no chain; with entities and place.
pub fn read(bytes: &[u8], options: &Options) -> Result<Sections> {
    let text = dxf::decode(bytes)?;
    let (drawing, finished) = (dxf::drawing(&text)?, finished(&text));
    let frame = frame::Frame::new(&drawing, options)?;
    let entities = blocks::exploded(&drawing)?;
    let (blank, tube) = stroke::blank(&entities, options, &frame).unzip();
    let tube = tube.flatten();
    if let Some([_, edge, thickness]) = blank {
        let (what, side) = if tube.is_some() { ("a tube, its wall ", "outside") } else { ("", "edge") };
        frame.note(format!("the blank of layer BLANK is {what}{thickness} mm thick, its {side} at x = {edge} mm"));
    }
    let (layers, all, others) = layers::layers(&entities, options, &frame)?;
    let tools: BTreeSet<ToolId> = layers.values().copied().collect();
    let drawn = |tool: ToolId| Ok((tool, stroke::strokes(&entities, &layers, tool, &frame)?));
    let mut strokes = tools.into_iter().map(drawn).collect::<Result<Vec<_>>>()?;
    strokes.retain(|(_, drawn)| !drawn.is_empty());
    let help = "say which is which, for example --layer NAME=punch --layer OTHER=die; layers whose names hold punch, die or \
                holder are found by themselves, in German and French too";
    let what = format!("no line, arc, polyline or spline is on a tool's layer: there are {all}");
    ensure(!strokes.is_empty(), || ImportError::new(what, help))?;
    // Tools of a tube may be rings.
    options.axis.or(tube.map(|_| 0.0)).map_or_else(|| axis::check(&strokes, &frame), |_| Ok(()))?;
    let pieces = strokes.iter().flat_map(|(_, strokes)| strokes).flat_map(|stroke| stroke.pieces());
    frame.check_unit(options, 2.0 * pieces.map(|piece| piece.last().x.abs()).fold(0.0, f64::max))?;
    let right = |(tool, strokes)| Ok((tool, halves::right(strokes, tool, &frame)?));
    let chains = strokes.into_iter().map(right).collect::<Result<Vec<_>>>()?;
    let exported = entities.iter().filter_map(|placed| layers::exported(&placed.source.layer));
    let first = exported.filter(|(_, name)| FORMED.contains(name)).map(|(number, _)| number).min().flatten();
    let formed = |number: Option<u32>| stroke::bounds(&FORMED, number.or(first), &entities, options, &frame);
    let asked = options.punch_moves.map(|heading| (heading, "as asked for".to_owned()));
    let known = asked.or_else(|| Some(orient::tube(&chains, tube?, formed(first))));
    let heading = orient::heading(&chains, known, &frame)?;
    let to_z =
        |Bounds { low, high }: Bounds| if heading == Heading::Down { [-high.y, -low.y] } else { [low.y, high.y] };
    let mut operations: Vec<Operation> = Vec::new();
    for (tool, chain) in chains {
        let section = orient::section(tool, chain, heading, tube.is_some(), &frame)?;
        match operations.last_mut().filter(|operation| operation.number == tool.operation) {
            Some(operation) => operation.tools.push(section),
            None => {
                let sheet_end = formed(tool.operation).map(|sheet| to_z(sheet)[0]);
                operations.push(Operation { number: tool.operation, tools: vec![section], sheet_end });
            }
        }
    }
    let strip = text.split_once(STRIP).and_then(|(_, sizes)| sizes.lines().next());
    let geometry = strip.map_or(Geometry::Axisymmetric, |_| Geometry::PlaneStrain);
    let depth = strip.and_then(|sizes| length(sizes.split(" x ").nth(2)?));
    let is_released = text.contains(RELEASED);
    if is_released {
        frame.note("the formed sheet has sprung back: a last stage takes the tools away, the sheet is elastic".into());
    }
    let (notes, tube) = (frame.notes.into_inner(), tube.map(to_z));
    Ok(Sections { operations, blank, tube, finished, geometry, depth, is_released, layers: all, others, notes })
}

/// Reads the one line of a layer, or of the whole drawing, as a profile with z upward: of a tool, or of a sheet as that of a tool
/// below it. Fails as [`read`], and without a line.
pub fn line(bytes: &[u8], layer: Option<&str>, role: Role) -> Result<Profile> {
    let help = "draw one open line of lines, arcs and splines, with its unit in the drawing's header, or name its layer: \
                { file = \"die.dxf\", layer = \"DIE\" }";
    only_line(bytes, layer, role).map_err(|ImportError { what, line, .. }| {
        ImportError::new(line.map_or_else(String::new, |line| format!("line {line}: ")) + &what, help)
    })
}

fn only_line(bytes: &[u8], layer: Option<&str>, role: Role) -> Result<Profile> {
    let drawing = dxf::decode(bytes)?;
    let drawing = dxf::drawing(&drawing)?;
    let (frame, tool) = (frame::Frame::new(&drawing, &Options::default())?, ToolId { operation: None, role });
    let entities = blocks::exploded(&drawing)?;
    let names: BTreeSet<&str> = entities.iter().map(|placed| placed.source.layer.as_str()).collect();
    let is_ours = |name: &&&str| layer.is_none_or(|layer| layer.eq_ignore_ascii_case(name));
    let layers = names.iter().filter(is_ours).map(|name| ((*name).to_owned(), tool)).collect();
    let strokes = stroke::strokes(&entities, &layers, tool, &frame)?;
    let place = layer.map_or_else(|| "there".to_owned(), |layer| format!("on layer {layer}"));
    let all = layers::list(names.iter().map(|name| (*name).to_owned()));
    ensure(!strokes.is_empty(), || ImportError::new(format!("no line is drawn {place}; its layers are {all}"), ""))?;
    Ok(orient::section(tool, halves::right(strokes, tool, &frame)?, Heading::Up, false, &frame)?.profile)
}
