//! `stampflow import`: from a drawing to a case file.

use super::*;
use stampflow::author::{Import, Imported};
use stampflow::import::{self, Heading, Operation, Options, Section, Sections};

options! {
    /// Write a case file with the tools of a drawing (DXF)
    Args {
        drawing: PathBuf = "DRAWING.dxf" [] "Drawing, DXF in text form",
        out: Option<PathBuf> = "CASE.toml" [long, short, alias = "output"]
            "Case file to write [default: beside the drawing]",
        force: bool [long] "Replace an existing case file and picture",
        layers: Vec<(String, Option<Role>)> = "NAME=TOOL" [long = "layer", value_parser = import::layer]
            "Tool of a layer: punch, die, holder or none; as often as needed",
        unit: Option<DrawingUnit> [long]
            "Unit of the drawing: mm, cm, m, in, ft, mil or um [default: the drawing's header]",
        axis: Option<Length> = "LENGTH" [long, allow_hyphen_values = true]
            "x of the axis or symmetry plane in the drawing [default: 0]",
        punch_moves: Option<Heading> = "DIRECTION" [long, hide_short_help = true]
            "Direction of the punch in the drawing: down or up [default: from the tools' walls]",
        join: f64 = "LENGTH" [long, hide_short_help = true, default_value = "0.01 mm", allow_hyphen_values = true, value_parser = length]
            "Largest gap between ends that meet",
        tolerance: f64 = "LENGTH" [long, hide_short_help = true, default_value = "0.001 mm", allow_hyphen_values = true, value_parser = length]
            "Largest distance of a spline from the arcs that replace it",
        geometry: Geometry [long, hide_short_help = true, default_value = "axisymmetric"] "axisymmetric or plane_strain",
        material: Option<String> = "NAME" [long]
            "Sheet of the library or a grade such as DC04 [default: a placeholder]",
        thickness: Option<f64> = "LENGTH" [long, allow_hyphen_values = true, value_parser = length]
            "Thickness of the sheet [default: a placeholder]",
        blank: Option<f64> = "LENGTH" [long = "blank-radius", visible_alias = "blank-half-length", allow_hyphen_values = true, value_parser = length]
            "Radius of the blank, in plane strain its half-length [default: a placeholder]",
        travel: Option<f64> = "LENGTH" [long, allow_hyphen_values = true, value_parser = length]
            "Punch travel [default: a placeholder]",
    } json: Json;
}

pub fn import(args: Args) -> Result<Code> {
    let Args { drawing, out, force, layers, unit, axis, punch_moves, join, tolerance, .. } = args;
    let Args { geometry, material, thickness, blank, travel, json: Json { json }, .. } = args;
    let bytes = Disk.read(&drawing, import::LARGEST).map_err(|error| {
        let is_large = error.kind() == std::io::ErrorKind::FileTooLarge;
        let help = if is_large { "save the tools' layers only" } else { "give the path of a DXF file" };
        bad_path(&drawing, format!("cannot be read: {error}"), help)
    })?;
    let out = out.unwrap_or_else(|| drawing.with_extension("toml"));
    let picture = out.with_extension("png");
    ensure!(out != picture, bad_path(&out, "would be both the case and its picture", "write -o NAME.toml"));
    let is_free = |path| place::free(path, force, std::slice::from_ref(&drawing), "-o");
    is_free(&out).and_then(|()| is_free(&picture))?;
    let options = Options { layers, unit, axis: axis.map(Dimensioned::value), join, tolerance, punch_moves };
    let mut import = Import { options, geometry, material, thickness, blank, travel };
    let mut imported = import.read(&bytes, &drawing);
    let can_ask = unit.is_none() && !json && stdin().is_terminal();
    if let Some(error) = imported.as_ref().err().filter(|error| can_ask && error.help.contains("--unit")) {
        warn(format!("{}\nUnit of the drawing ({}):", error.what, DrawingUnit::ALL.join(", ")));
        let line = stdin().lines().next().transpose()?.unwrap_or_default();
        import.options.unit = Some(line.trim().parse().map_err(|help: String| bad_request(help))?);
        imported = import.read(&bytes, &drawing);
    }
    let imported = imported.with_context(|| drawing.display().to_string())?;
    write(&out, imported.text.as_bytes()).map_err(unusable("-o"))?;
    write(&picture, &png(&imported.picture(&drawing))).map_err(unusable("-o"))?;
    let Imported { sections: Sections { first, later, .. }, size, case, doubts, notes, .. } = imported;
    doubts.iter().filter(|_| !json).for_each(|doubt| warn(format!("warning: {doubt}")));
    let tool = |tool: &Section| json!({ "tool": tool.role.name(), "pieces": tool.profile.pieces().len(), "made_of": tool.made_of });
    let tools = |tools: &[Section]| tools.iter().map(tool).collect::<Value>();
    let stage = |stage: &Operation| json!({ "name": stage.name(), "tools": tools(&stage.tools) });
    let stages = json!({ "tools": tools(&first.tools), "later": later.iter().map(stage).collect::<Value>() });
    let value = with(json!({ "case": out, "picture": picture, "size": size, "notes": notes }), stages);
    let printed = emit(json, value, || {
        let tools = first.tools.iter().chain(later.iter().flat_map(|later| &later.tools)).map(|tool| {
            let pieces = tool.profile.pieces().len();
            let drawn = if pieces == 1 { "line or arc" } else { "lines and arcs" };
            format!("{:<8}{pieces} {drawn} from {}\n", tool.role.name(), tool.made_of)
        });
        let notes = notes.iter().skip(doubts.len()).map(|note| format!("  - {note}\n"));
        let text: String = tools.chain([format!("size    {size}\n")]).chain(notes).collect();
        let (out, picture) = (out.display(), picture.display());
        let next = |open| format!("\nplaceholders: {open}\nchange them in the case or so: stampflow check {out}");
        let next = case.iter().find_map(|case| case.model().placeholders()).map_or_else(String::new, next);
        format!("{text}\n{out} and {picture} are written{next}").into()
    });
    ensure!(
        case.is_some(),
        "no punch is drawn, and the case cannot be run: add one, or import with --layer NAME=punch"
    );
    printed
}
