//! `stampflow import`: from a drawing to a case file.

use super::*;
use stampflow::author::Import;
use stampflow::import::{self, Heading, Operation, Options, Section};

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
        geometry: Option<Geometry> [long]
            "axisymmetric or plane_strain [default: that of the drawing's blank, else axisymmetric]",
        material: Option<String> = "NAME" [long]
            "Sheet of the library or a grade such as DC04 [default: a placeholder]",
        thickness: Option<f64> = "LENGTH" [long, allow_hyphen_values = true, value_parser = length]
            "Thickness of the sheet [default: a placeholder]",
        blank: Option<f64> = "LENGTH" [long = "blank-radius", visible_alias = "blank-half-length", allow_hyphen_values = true, value_parser = length]
            "Radius of the blank, in plane strain its half-length [default: a placeholder]",
        length: Option<String> = "LENGTH" [long]
            "Length of a strip across the section, over which forces are given [default: that of the blank's label]",
        travel: Option<f64> = "LENGTH" [long, allow_hyphen_values = true, value_parser = length]
            "Punch travel [default: as drawn where the tools are closed, else a placeholder]",
        friction: Option<f64> = "NUMBER" [long, value_parser = |text: &str| text.parse().map(stampflow::units::Fraction::value)]
            "Coulomb's coefficient of every tool, 0 to 1 [default: a placeholder]",
        holder_force: Option<String> = "FORCE" [long] "Holder's force, such as \"9.6 kN\" [default: a placeholder]",
        drawn_through: bool [long] "The part is pushed through the die [default: if the drawing's layer SHEET shows it]",
        set: Vec<String> = "KEY=VALUE" [long] "Set a value of the case, as often as needed",
    } json: Json;
}

pub fn import(args: Args) -> Result<Code> {
    let Args { drawing, out, force, layers, unit, axis, punch_moves, join, tolerance, .. } = args;
    let Args { geometry, material, thickness, blank, travel, friction, .. } = args;
    let Args { holder_force, length, drawn_through, set, json: Json { json }, .. } = args;
    let holder = holder_force.map(|force| format!("tools.holder.force={force:?}"));
    let through = drawn_through.then(|| "stop.drawn_through=true".to_owned());
    let length = length.map(|length| format!("blank.depth={length:?}"));
    let overrides = holder.into_iter().chain(length).chain(through).chain(set).collect();
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
    let mut import = Import { options, geometry, material, thickness, blank, travel, friction, overrides };
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
    imported.doubts.iter().filter(|_| !json).for_each(|doubt| warn(format!("warning: {doubt}")));
    let tool = |tool: &Section| json!({ "tool": tool.role.name(), "pieces": tool.profile.pieces().len(), "made_of": tool.made_of });
    let tools = |tools: &[Section]| tools.iter().map(tool).collect::<Value>();
    let stage = |stage: &Operation| json!({ "name": stage.name(), "tools": tools(&stage.tools) });
    let [first, later @ ..] = &imported.sections.operations[..] else { return Err(bad_request("no tool is drawn")) };
    let later = later.iter().map(stage).collect::<Value>();
    let value = json!({ "case": out, "picture": picture, "size": imported.size, "notes": imported.notes });
    emit(json, with(value, json!({ "tools": tools(&first.tools), "later": later })), || {
        let (out, picture) = (out.display(), picture.display());
        format!("{imported}\n{out} and {picture} are written; next: stampflow check {out}").into()
    })
}
