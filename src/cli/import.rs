//! `stampflow import`: from a drawing to a case file.

use super::code::{BadPath, Code};
use super::options::{Json, Suggested};
use super::place;
use super::screen::{print, print_json};
use serde_json::{Value, json};
use stampflow::author::{Import, ImportFailure, Imported};
use stampflow::case::files::{Disk, FileError, Files};
use stampflow::import::{self, DrawingUnit, Heading, Options, Section, Sections};
use stampflow::model::{Geometry, Role};
use stampflow::plot::{Chart, SketchedTool, png, sketch};
use stampflow::results::write;
use stampflow::units::{Dimensioned, Length, Positive};
use std::fmt::Write;
use std::path::PathBuf;

pub const HELP: &str = "\
Layers whose names hold punch, die, holder or another word for one (binder, Stempel, Matrize, Niederhalter, poinçon,
matrice, serre-flan) are those tools. A number as in OP20_PUNCH, OP30_PUNCH makes stages. In the drawing x is the distance
from the axis and y goes up. Lines, arcs, polylines and splines of a layer, in any order and in blocks too, make one line:
the side of the tool that faces the sheet, or an outline round it. If both halves are drawn, the right one is used.

You get the case file, in which placeholders (sheet, material, friction, travel) are marked, and a picture of what was
read beside it (die.png for die.toml).

Examples:
  stampflow import die.dxf
  stampflow import die.dxf --layer Stempel=punch --layer 7=die --layer Hilfslinien=none --unit mm -o cases/die.toml
  stampflow import die.dxf --thickness \"0.8 mm\" --blank-radius \"95 mm\" --travel \"30 mm\"

Exit codes: 0 done, 2 bad input (nothing is written), 1 anything else";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Drawing, DXF in text form
    #[arg(value_name = "DRAWING.dxf")]
    drawing: PathBuf,
    /// Case file to write [default: beside the drawing]
    #[arg(long, short, alias = "output", value_name = "CASE.toml")]
    out: Option<PathBuf>,
    /// Replace an existing case file and picture
    #[arg(long)]
    force: bool,
    /// Tool of a layer: punch, die, holder or none; as often as needed
    #[arg(long = "layer", value_name = "NAME=TOOL", value_parser = import::layer)]
    layers: Vec<(String, Option<Role>)>,
    /// Unit of the drawing: mm, cm, m, in, ft, mil or um [default: the drawing's header]
    #[arg(long, value_name = "UNIT")]
    unit: Option<DrawingUnit>,
    /// x of the axis or symmetry plane in the drawing [default: 0]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    axis: Option<Length>,
    /// Direction of the punch in the drawing: down or up [default: from the tools' walls]
    #[arg(long, value_name = "DIRECTION")]
    punch_moves: Option<Heading>,
    /// Largest gap between ends that meet
    #[arg(long, value_name = "LENGTH", default_value = "0.01 mm", allow_hyphen_values = true)]
    join: Positive<Length>,
    /// Largest distance of a spline from the arcs that replace it
    #[arg(long, value_name = "LENGTH", default_value = "0.001 mm", allow_hyphen_values = true)]
    tolerance: Positive<Length>,
    /// axisymmetric or plane_strain
    #[arg(long, value_name = "GEOMETRY", default_value = "axisymmetric")]
    geometry: Geometry,
    /// Sheet of the library or a grade such as DC04 [default: a placeholder]
    #[arg(long, value_name = "NAME", value_parser = Suggested::SHEETS, hide_possible_values = true)]
    material: Option<String>,
    /// Thickness of the sheet [default: a placeholder]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    thickness: Option<Positive<Length>>,
    /// Radius of the blank, in plane strain its half-length [default: a placeholder]
    #[arg(long, visible_alias = "blank-half-length", value_name = "LENGTH", allow_hyphen_values = true)]
    blank_radius: Option<Positive<Length>>,
    /// Punch travel [default: a placeholder]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    travel: Option<Positive<Length>>,
    #[command(flatten)]
    json: Json,
}

pub fn import(args: &Args) -> anyhow::Result<Code> {
    let drawing = args.drawing.display();
    let bytes = Disk.read(&args.drawing, import::LARGEST).map_err(|error| BadPath {
        what: format!("{drawing} cannot be read: {error}"),
        help: match error {
            FileError::TooLarge { .. } => "save the tools' layers only".into(),
            _ => "give the path of a DXF file".into(),
        },
        path: args.drawing.clone(),
    })?;
    let out = args.out.clone().unwrap_or_else(|| args.drawing.with_extension("toml"));
    let picture = out.with_extension("png");
    if out == picture {
        let what = format!("{} would be both the case and its picture", out.display());
        return Err(BadPath { what, help: "write -o NAME.toml".into(), path: out }.into());
    }
    for path in [&out, &picture] {
        if path.symlink_metadata().is_ok() && !args.force {
            let what = format!("{} is there already", path.display());
            let help = "choose another name with -o, or --force".into();
            return Err(BadPath { what, help, path: path.clone() }.into());
        }
        place::file(path, std::slice::from_ref(&args.drawing), "-o")?;
    }
    let mm = |length: Option<Positive<Length>>| length.map(Dimensioned::value);
    let import = Import {
        options: Options {
            layers: args.layers.clone(),
            unit: args.unit,
            axis: args.axis.map(Dimensioned::value),
            join: args.join.value(),
            tolerance: args.tolerance.value(),
            punch_moves: args.punch_moves,
        },
        geometry: args.geometry,
        material: args.material.clone(),
        thickness: mm(args.thickness),
        blank: mm(args.blank_radius),
        travel: mm(args.travel),
    };
    let imported = import.read(&bytes, &args.drawing).map_err(|failure| match failure {
        ImportFailure::Drawing(error) => anyhow::Error::new(error).context(drawing.to_string()),
        ImportFailure::Sheet(error) => error.into(),
        ImportFailure::Case(error) => anyhow::Error::new(error).context(drawing.to_string()),
    })?;
    let Imported { sections, text, size, notes, .. } = imported;
    let name = args.drawing.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    write(&out, text.as_bytes())?;
    write(&picture, &png(&drawn(&name, args.geometry, &sections)))?;
    if args.json.json {
        let tool = |tool: &Section| json!({ "tool": tool.role.name(), "pieces": tool.profile.pieces().len(), "made_of": tool.made_of });
        let tools = |tools: &[Section]| tools.iter().map(tool).collect::<Vec<Value>>();
        let later = sections.later.iter().map(|later| json!({ "name": later.name(), "tools": tools(&later.tools) }));
        let (tools, later) = (tools(&sections.tools), later.collect::<Vec<_>>());
        return print_json(
            &json!({ "case": out, "picture": picture, "tools": tools, "later": later, "size": size, "notes": notes }),
        );
    }
    let mut text = String::new();
    for tool in sections.tools.iter().chain(sections.later.iter().flat_map(|later| &later.tools)) {
        let pieces = tool.profile.pieces().len();
        let drawn = if pieces == 1 { "line or arc" } else { "lines and arcs" };
        let _ = writeln!(text, "{:<8}{pieces} {drawn} from {}", tool.role.name(), tool.made_of);
    }
    let _ = writeln!(text, "size    {size}");
    notes.iter().for_each(|note| text += &format!("  - {note}\n"));
    let (out, picture) = (out.display(), picture.display());
    let next = match sections.tool(Role::Punch) {
        Some(_) => format!("change the placeholders in the case, then: stampflow check {out}"),
        None => "no punch is drawn: add one to the case before you run it".to_owned(),
    };
    print(format!("{text}\n{out} and {picture} are written\n{next}"))
}

fn drawn(name: &str, geometry: Geometry, sections: &Sections) -> Chart {
    let tool = |tool: &Section| SketchedTool {
        label: format!("{}: {}", capitalised(tool.role.name()), tool.made_of),
        role: tool.role,
        profile: tool.profile.clone(),
        ends: tool.ends.clone(),
    };
    let operations = std::iter::once(&sections.tools).chain(sections.later.iter().map(|later| &later.tools));
    let operations: Vec<Vec<SketchedTool>> = operations.map(|tools| tools.iter().map(tool).collect()).collect();
    let caption = "Circles: where drawn lines, arcs and splines begin and end. The tools are where they are drawn; the \
                   case moves each along z to where it touches the sheet.";
    let notes = sections.notes.iter().map(|note| format!("{}.", capitalised(note)));
    let notes = std::iter::once(caption.to_owned()).chain(notes).collect();
    sketch(format!("{name}: the tools that were read"), geometry, &operations, notes)
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
