//! What plotters draws, recorded as [`Mark`]s.

use super::letters::{CAP, MIDDLE, text_width};
use super::mark::{Mark, Point};
use super::stroke::circle;
use crate::plot::chart::Color;
use plotters::style::text_anchor::VPos;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontTransform,
};
use std::convert::Infallible;

/// plotters counts in whole units, and so many of them are a px: finer than what is seen.
const FINE: f64 = 100.0;

/// Units of plotters in so many px.
pub(super) fn units(px: f64) -> i32 {
    (px * FINE).round() as i32
}

/// px of a point in units.
pub(super) fn px(at: BackendCoord) -> Point {
    (f64::from(at.0) / FINE, f64::from(at.1) / FINE)
}

/// Takes down marks, on a page of this width and height \[px\]. Colours are opaque, or nothing is drawn.
pub(super) struct Recorder<'a> {
    pub size: [f64; 2],
    pub marks: &'a mut Vec<Mark>,
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl Recorder<'_> {
    /// A line, or one more piece of the last one where it has the same pen.
    fn line(&mut self, piece: Vec<Point>, style: &impl BackendStyle) {
        let (BackendColor { rgb, alpha }, stroke) = (style.color(), f64::from(style.stroke_width()) / FINE);
        match self.marks.last_mut() {
            _ if alpha == 0.0 => {}
            Some(Mark::Line { pieces, color, width }) if (*color, *width) == (rgb, stroke) => pieces.push(piece),
            _ => self.marks.push(Mark::Line { pieces: vec![piece], color: rgb, width: stroke }),
        }
    }

    fn area(&mut self, outline: Vec<Point>, fill: Color) {
        self.marks.push(Mark::Area { outline, fill });
    }
}

impl DrawingBackend for Recorder<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size.map(|px| units(px) as u32).into()
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, at: BackendCoord, color: BackendColor) -> Drawn {
        self.draw_rect(at, (at.0 + 1, at.1 + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Drawn {
        self.line(path.into_iter().map(px).collect(), style);
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S, fill: bool) -> Drawn {
        let ((left, top), (right, bottom)) = (px(from), px(to));
        let mut outline = vec![(left, top), (right, top), (right, bottom), (left, bottom)];
        if fill {
            self.area(outline, style.color().rgb);
        } else {
            // From the middle of a side, so that all corners are joined.
            let middle = (left, 0.5 * (top + bottom));
            outline.insert(0, middle);
            outline.push(middle);
            self.line(outline, style);
        }
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, at: BackendCoord, radius: u32, style: &S, fill: bool) -> Drawn {
        let (at, radius, color) = (px(at), f64::from(radius) / FINE, style.color().rgb);
        if fill {
            self.area(circle(at, radius), color);
        } else {
            self.marks.push(Mark::Circle { at, radius, color, width: f64::from(style.stroke_width()) / FINE });
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, outline: I, style: &S) -> Drawn {
        self.area(outline.into_iter().map(px).collect(), style.color().rgb);
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn {
        let (anchor, size) = (style.anchor(), style.size());
        let down = size
            * match anchor.v_pos {
                VPos::Top => CAP,
                VPos::Center => MIDDLE,
                VPos::Bottom => -MIDDLE,
            };
        let (x, y) = px(at);
        let turned = matches!(style.transform(), FontTransform::Rotate270);
        self.marks.push(Mark::Text {
            // What XML cannot hold, escape sequences for example, is left out.
            text: text.replace(|c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'), ""),
            size,
            color: style.color().rgb,
            at: if turned { (x + down, y) } else { (x, y + down) },
            anchor: anchor.h_pos,
            turned,
        });
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        Ok([text_width(text, style.size()), style.size()].map(|px| units(px) as u32).into())
    }
}
