//! Layers of lines and arcs in true size, for CAD: as a picture with a group for each layer, and as a table.

use super::{sections::whole_sheet, *};
use crate::geometry::Bounds;
use crate::units::trimmed;
use std::{f64::consts::PI, fmt::Write};

/// Margin over the larger side, and height of labels over the width \[–\].
const MARGIN: f64 = 0.05;
const LABEL: f64 = 0.02;
/// Width of lines \[mm\].
const LINE: f64 = 0.25;

/// Index in the palette of CAD programs, and red, green and blue.
pub type Color = (u8, &'static str);

/// One connected line of a drawing \[mm\], x to the right and y upward.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Name: `PUNCH`, `OP20_SHEET`.
    pub name: String,
    /// Colour of its lines.
    pub color: Color,
    /// Lines and arcs in order.
    pub pieces: Vec<Piece>,
    /// True for one polyline, false for an entity of each line and arc.
    pub is_joined: bool,
    /// Text and its place.
    pub label: Option<(Point, String)>,
}

/// Reach of the line of a cut beyond the sheet, over its thickness \[–\].
const ACROSS: f64 = 5.0;

impl Layer {
    pub(crate) fn of_pieces(name: String, color: Color, pieces: Vec<Piece>) -> Self {
        Self { name, color, pieces, is_joined: false, label: None }
    }

    pub(crate) fn polyline(name: String, color: Color, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let points: Vec<Point> = points.into_iter().map(|(x, y)| Point::new(x, y)).collect();
        let pieces = points.windows(2).map(|ends| Piece::line(ends[0], ends[1])).collect();
        Self { is_joined: true, ..Self::of_pieces(name, color, pieces) }
    }

    pub(crate) fn sheet(prefix: &str, frame: &Frame, label: Option<&str>) -> [Self; 2] {
        let outline = whole_sheet(frame, 1.0);
        let outline = outline.iter().chain(outline.first()).copied();
        let middle = frame.nodes.iter().map(|node| (node.r, node.z));
        let faces = Self::polyline(format!("{prefix}SHEET"), (7, "#000000"), outline);
        let label = faces.pieces.first().map(Piece::first).zip(label.map(str::to_owned));
        [Self { label, ..faces }, Self::polyline(format!("{prefix}MIDLINE"), (9, "#909090"), middle)]
    }

    pub(crate) fn cut(name: String, at: Point, thickness: Point, text: String) -> Self {
        let [from, to] = [-ACROSS, ACROSS].map(|reach| at + reach * thickness);
        Self { label: Some((to, text)), ..Self::of_pieces(name, (6, "#c000c0"), vec![Piece::line(from, to)]) }
    }
}

/// Corners of the box around all layers \[mm\].
pub(crate) fn extent(layers: &[Layer]) -> (Point, Point) {
    let all = layers.iter().flat_map(|layer| &layer.pieces);
    Bounds::around(all.copied()).map_or((Point::zeros(), Point::zeros()), |around| (around.low, around.high))
}

pub(crate) fn coordinate(value: f64) -> String {
    trimmed(value, 12)
}

pub(crate) fn true_size_svg(layers: &[Layer]) -> String {
    let (low, high) = extent(layers);
    let margin = MARGIN * (high - low).max();
    // The label of the blank stands at its edge.
    let (width, height) = (high.x - low.x + 5.0 * margin, high.y - low.y + 2.0 * margin);
    let [x, y, w, h] = [low.x - margin, -high.y - margin, width, height].map(coordinate);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"{x} {y} {w} {h}\">\n\
         <rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n"
    );
    for Layer { name, color: (_, color), pieces, label, .. } in layers {
        let _ = writeln!(text, "<g id=\"{name}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{LINE}\">");
        let path: String = pieces.iter().map(|piece| format!("M{}{}", place(piece.first()), along(piece))).collect();
        let _ = writeln!(text, "<path d=\"{path}\"/>");
        if let Some((at, label)) = label {
            let ([x, y], size) = ([at.x, -at.y].map(coordinate), coordinate(LABEL * width));
            let style = format!("font-family=\"sans-serif\" fill=\"{color}\" stroke=\"none\"");
            let _ = writeln!(text, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" {style}>{label}</text>");
        }
        text.push_str("</g>\n");
    }
    text + "</svg>\n"
}

fn place(p: Point) -> String {
    format!("{} {}", coordinate(p.x), coordinate(-p.y))
}

fn along(piece: &Piece) -> String {
    let end = place(piece.last());
    match piece {
        Piece::Segment(_) => format!(" L{end}"),
        Piece::Arc(arc) => {
            let (radius, flags) = (coordinate(arc.radius), [arc.sweep.abs() > PI, arc.sweep < 0.0].map(u8::from));
            format!(" A{radius} {radius} 0 {} {} {end}", flags[0], flags[1])
        }
    }
}

/// One row a line or arc \[mm\]: ends, and of an arc the radius, positive counter-clockwise, and the centre.
pub(crate) fn layers_csv(layers: &[Layer]) -> String {
    let mut text = "layer,r0_mm,z0_mm,r1_mm,z1_mm,radius_mm,centre_r_mm,centre_z_mm\n".to_owned();
    for (layer, piece) in layers.iter().flat_map(|layer| layer.pieces.iter().map(move |piece| (&layer.name, piece))) {
        let (a, b) = (piece.first(), piece.last());
        let arc = match piece {
            Piece::Segment(_) => [const { String::new() }; 3],
            Piece::Arc(arc) => [arc.radius.copysign(arc.sweep), arc.center.x, arc.center.y].map(coordinate),
        };
        let _ = writeln!(text, "{layer},{},{}", [a.x, a.y, b.x, b.y].map(coordinate).join(","), arc.join(","));
    }
    text
}
