//! `stampflow export`: tools and formed sheet of a case as a drawing.

use super::*;
use stampflow::export::{Drawing, Format};

const VERSIONS: [(&str, Format); 2] = [("r12", Format::DxfR12), ("2000", Format::Dxf2000)];

options! {
    /// Solve a case and draw its tools, blank and formed sheet for CAD (DXF, SVG or CSV)
    Args {
        case: PathBuf [] "Case file",
        output: PathBuf = "FILE" [long, short, alias = "out", default_value = "tools.dxf"]
            "Drawing to write: .dxf, .svg or .csv by its ending",
        dxf: Format = "VERSION" [long, default_value = "r12", value_parser = one_of(VERSIONS)]
            "Version of DXF: r12 or 2000",
        force: bool [long] "Replace an existing file",
    } common: Common;
}

pub fn export(args: &Args) -> Result<Code> {
    let case = args.common.overrides.load(&args.case)?;
    let path = &args.output;
    let what = format!("{} is no drawing by its ending: write -o NAME.dxf, NAME.svg or NAME.csv", path.display());
    let format = Format::of(path, args.dxf).ok_or_else(|| bad_request(what))?;
    place::free(path, args.force, &case.inputs, "-o")?;
    can_write(path).map_err(unusable("-o"))?;
    let solution = args.common.progress().watch(&case).solve(case);
    let drawing = Drawing::new(&solution, [DrawingUnit::MM, DrawingUnit::INCH][DisplaySettings::current() as usize]);
    write(path, drawing.text(format).as_bytes()).map_err(unusable("-o"))?;
    let layers: Vec<_> = drawing.layers.iter().map(|layer| layer.name.as_str()).collect();
    let is_complete = is_done(&solution);
    emit(args.common.json(), json!({ "file": path, "layers": layers, "complete": is_complete }), || {
        let early = if is_complete { "" } else { "\nthe run stopped early: the sheet is drawn as it was then" };
        wrapped(format!("{} is written, layers {}{early}", path.display(), layers.join(", ")))
    })?;
    Ok(if is_complete { Code::Done } else { Code::StoppedEarly })
}
