//! Drawings of a solved case for CAD: tools, formed sheet, blank and trim line, each on a layer of its own.
//!
//! ```text
//! PUNCH DIE HOLDER   tools where they stand at the end of their stage, with the names that import reads
//! SHEET MIDLINE      faces and middle of the formed sheet
//! BEAD               beads by their section, and their grooves
//! BLANK TRIM AXIS    flat blank, place of a cut, axis or symmetry plane
//! ```
//!
//! Several stages have numbers before the names: `OP10_PUNCH`, `OP20_PUNCH`. A stage without a new tool draws its sheet alone.
//!
//! # Frame
//! x = r is the distance from the axis, y = z goes the way the punch moves from below. Lengths are in mm until written.

mod dxf;

use crate::bead::shapes;
use crate::case::{Finished, Solution};
use crate::geometry::{Bounds, Piece, Point};
use crate::import::{DrawingUnit, FINISHED, RELEASED, SIZES, STRIP};
use crate::measure::wall_at;
use crate::model::{Geometry, Model, Role, Stage, Tool};
use crate::plot::drawing::{Layer, extent, layers_csv, true_size_svg};
use crate::plot::sections::{flat, tool_displacement};
use crate::solver::solution::{Frame, StageSolution};
use crate::units::{joined, trimmed};
use std::path::Path;

const COLORS: [(u8, &str); 5] = [(1, "#d00000"), (5, "#0000d0"), (3, "#009000"), (6, "#a000a0"), (2, "#808000")];
/// Reach of endless walls beyond the sheet, over its size, and of the axis beyond the drawing, over its height \[–\].
const MARGIN: f64 = 0.2;
const BEYOND: f64 = 0.05;
const STEP: usize = 10;

/// Format of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// DXF of AutoCAD R12, which every program reads.
    DxfR12,
    /// DXF of AutoCAD 2000.
    Dxf2000,
    /// Picture in true size, a group for each layer.
    Svg,
    /// Table of lines and arcs.
    Csv,
}

impl Format {
    /// Format by the ending of a file's name, DXF of this version; `None` for any other ending.
    pub fn of(path: &Path, dxf: Self) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        let formats = [("dxf", dxf), ("svg", Self::Svg), ("csv", Self::Csv)];
        formats.into_iter().find(|(name, _)| *name == ending).map(|(_, format)| format)
    }
}

/// Drawing of a case.
#[derive(Clone, Debug)]
pub struct Drawing {
    unit: DrawingUnit,
    /// Layers in the order of the stages.
    pub layers: Vec<Layer>,
}

impl Drawing {
    /// Draws a solved case; DXF and labels have this unit.
    pub fn new(solution: &Solution, unit: DrawingUnit) -> Self {
        let stages = &solution.case.stages;
        let mut drawing = Self { unit, layers: Vec::new() };
        drawing.blank(&stages[0]);
        for (i, stage) in stages.iter().enumerate() {
            let prefix = if stages.len() > 1 { format!("OP{}_", STEP * (i + 1)) } else { String::new() };
            let before = i.checked_sub(1).map_or(&[][..], |before| &stages[before].model.tools);
            let stood = |tool: &Tool| before.iter().any(|old| old.role == tool.role && old.profile == tool.profile);
            let solved = solution.stages.get(i);
            if !stage.model.tools.iter().all(stood) {
                stage.model.tools.iter().enumerate().for_each(|tool| drawing.tool(&prefix, tool, stage, solved));
                drawing.beads(&prefix, &stage.model, solved);
            }
            let end = solved.and_then(|solved| solved.frames.last());
            let label = (stage.model.release.is_some() && i + 1 == stages.len()).then_some(RELEASED);
            drawing.layers.extend(end.into_iter().flat_map(|frame| Layer::sheet(&prefix, frame, label)));
            stage.begin.trim.into_iter().for_each(|r| drawing.trim(&prefix, r, solved));
        }
        drawing.finished(&solution.case.finished, solution.stages.get(stages.len() - 1));
        let (low, high) = extent(&drawing.layers);
        let ends = [(low.y, -BEYOND), (high.y, BEYOND)].map(|(y, by)| (0.0, y + by * (high.y - low.y)));
        drawing.layers.push(Layer::polyline("AXIS".to_owned(), (8, "#808080"), ends));
        drawing
    }

    /// Text of a file.
    pub fn text(&self, format: Format) -> String {
        match format {
            Format::DxfR12 => dxf::write(&self.layers, self.unit, false),
            Format::Dxf2000 => dxf::write(&self.layers, self.unit, true),
            Format::Svg => true_size_svg(&self.layers),
            Format::Csv => layers_csv(&self.layers),
        }
    }

    fn blank(&mut self, stage: &Stage) {
        let ([_, length], half) = (stage.model.blank.ends(), 0.5 * stage.model.blank.thickness);
        let outline = flat(&stage.model);
        let closed = outline.iter().chain(outline.first()).copied();
        let blank = Layer::polyline("BLANK".to_owned(), (30, "#ff7f00"), closed);
        if stage.model.blank.meridian.is_some() {
            return self.layers.push(blank);
        }
        let sign = if stage.model.geometry == Geometry::Axisymmetric { "blank Ø " } else { STRIP };
        let sizes = [Some(2.0 * length), Some(2.0 * half), stage.model.depth].into_iter().flatten();
        let text = format!("{sign}{}", joined(sizes.map(|mm| self.label(mm)), " x "));
        self.layers.push(Layer { label: Some((Point::new(length, half), text)), ..blank });
    }

    fn tool(&mut self, prefix: &str, (index, tool): (usize, &Tool), stage: &Stage, solved: Option<&StageSolution>) {
        let frames = || solved.into_iter().flat_map(|solved| solved.start.iter().chain(&solved.frames));
        let up = |frame: &Frame| tool_displacement(frame, index).y;
        let passed = frames().flat_map(|f| f.nodes.iter().map(move |node| Point::new(node.r, node.z - up(f))));
        let flat = Bounds { low: Point::zeros(), high: Point::new(stage.model.blank.reach(), 0.0) };
        let around = passed.fold(flat, Bounds::with);
        let profile = tool.profile.cut_to([around.low, around.high], MARGIN * (around.high - around.low).max());
        let profile = profile.shifted(frames().last().map_or(0.0, up));
        let color = COLORS[tool.role.index().min(COLORS.len() - 1)];
        let name = tool.role.further().map_or(tool.role.name(), |_| stage.model.name_of(tool.role));
        let name = format!("{prefix}{}", name.to_uppercase());
        self.layers.push(Layer::of_pieces(name, color, profile.pieces().to_vec()));
    }

    fn beads(&mut self, prefix: &str, model: &Model, solved: Option<&StageSolution>) {
        let end = solved.and_then(|solved| solved.start.iter().chain(&solved.frames).last());
        let moved = |role| end.zip(model.tool_index(role)).map_or(0.0, |(at, tool)| tool_displacement(at, tool).y);
        let moved = [moved(Role::Die), moved(Role::Holder)];
        let shapes = shapes(model).flat_map(|beads| beads.into_iter().zip(moved)).map(|(bead, by)| bead.shifted(by));
        let pieces: Vec<Piece> = shapes.flat_map(|bead| bead.pieces().to_vec()).collect();
        self.layers.extend((!pieces.is_empty()).then(|| Layer::of_pieces(format!("{prefix}BEAD"), COLORS[2], pieces)));
    }

    fn trim(&mut self, prefix: &str, r: f64, solved: Option<&StageSolution>) {
        let edge = solved.and_then(|solved| solved.start.as_ref()?.nodes.last());
        let (z, thickness) = edge.map_or((0.0, 1.0), |edge| (edge.z, edge.thickness));
        let (at, text) = (Point::new(r, z), format!("trim at r = {}", self.label(r)));
        self.layers.push(Layer::cut(format!("{prefix}TRIM"), at, Point::y() * thickness, text));
    }

    fn finished(&mut self, finished: &Finished, solved: Option<&StageSolution>) {
        let Finished { height, diameter, flange_diameter } = *finished;
        let sizes = SIZES.into_iter().zip([height, diameter, flange_diameter]);
        let sizes = joined(sizes.filter_map(|(name, size)| Some(format!("{name}{}", self.label(size?)))), ", ");
        let (Some(end), false) = (solved.and_then(|last| last.frames.last()), sizes.is_empty()) else { return };
        let edge = end.nodes[end.nodes.len() - 1];
        let rim = height.filter(|_| flange_diameter.is_none()).and_then(|height| wall_at(end, height));
        let flange = [flange_diameter.map_or(edge.r, |diameter| 0.5 * diameter), edge.z, edge.thickness];
        let ([r, z, thickness], along) = rim.map_or((flange, Point::y()), |rim| (rim, Point::x()));
        let (at, text) = (Point::new(r, z), format!("{FINISHED}{sizes}"));
        self.layers.push(Layer::cut("TRIM".to_owned(), at, thickness * along, text));
    }

    fn label(&self, mm: f64) -> String {
        format!("{} {}", trimmed(mm / self.unit.1, 4), self.unit.0)
    }
}
