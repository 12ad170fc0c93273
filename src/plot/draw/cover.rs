//! How far outlines cover pixels, row by row.

use super::mark::Point;

/// Steps in which a pixel is covered, from nothing to all of it; finer ones are not seen at an edge.
pub(super) const FULL: u8 = 15;

/// What lies further away is drawn as if it lay there \[pixels\].
pub(super) const FAR: f64 = 1e7;

/// Pixels of a row that are covered alike, by so many parts of [`FULL`].
#[derive(Clone, Copy)]
pub(super) struct Span {
    pub row: i32,
    pub from: i32,
    /// One behind the last.
    pub to: i32,
    pub level: u8,
}

/// By how much the cover of a row rises where an edge crosses a pixel: there, and from the next one on.
#[derive(Clone, Copy)]
struct Crossing {
    pixel: u32,
    here: f32,
    later: f32,
}

/// The edges of outlines inside of a window from 0, 0, in pixels.
///
/// # References
/// Coverage is summed up along each row from what every edge adds to it, as FreeType and font-rs do it: D. Turner, The
/// FreeType smooth rasterizer; R. Levien, Inside the fastest font renderer in the world (2016). As commonly described, not
/// read.
#[derive(Default)]
pub(super) struct Cover {
    width: usize,
    /// Where edges cross each row.
    crossings: Vec<Vec<Crossing>>,
    /// Rows with crossings: from the first to before the last.
    touched: (usize, usize),
}

impl Cover {
    pub fn new(width: usize, height: usize) -> Self {
        // Few rows of a mark are crossed more often.
        let crossings = (0..height).map(|_| Vec::with_capacity(16)).collect();
        Self { width, crossings, touched: (height, 0) }
    }

    /// A window at least so large, between outlines.
    pub fn widen(&mut self, width: usize, height: usize) {
        self.width = self.width.max(width);
        if height > self.crossings.len() {
            self.crossings.resize(height, Vec::new());
        }
        self.touched = (self.crossings.len(), 0);
    }

    /// One edge of an outline \[pixels\]: what lies to its right is inside, or outside again.
    pub fn edge(&mut self, from: Point, to: Point) {
        let (sign, (from, to)) = if from.1 < to.1 { (1.0, (from, to)) } else { (-1.0, (to, from)) };
        let [(x, top), (end, bottom)] = [from, to].map(|p| (p.0.clamp(-FAR, FAR), p.1.clamp(-FAR, FAR)));
        let (first, last) = (top.max(0.0), bottom.min(self.crossings.len() as f64));
        if !(first < last && (x + end).is_finite()) {
            return;
        }
        let slope = (end - x) / (bottom - top);
        let rows = first as usize..last.ceil() as usize;
        self.touched = (self.touched.0.min(rows.start), self.touched.1.max(rows.end));
        let width = self.width as f64;
        let at = |y: f64| (x + (y - top) * slope).clamp(0.0, width);
        let (mut upper, mut a, mut below) = (first, at(first), rows.start as f64);
        for crossings in &mut self.crossings[rows] {
            // Comparisons, as none is NaN: `min` and `max` would look.
            below += 1.0;
            let lower = if below < last { below } else { last };
            let b = if slope == 0.0 { a } else { at(lower) };
            let (from, to) = if a < b { (a, b) } else { (b, a) };
            rise(crossings, sign * (lower - upper), from, to);
            (upper, a) = (lower, b);
        }
    }

    /// Says what the edges since the last call enclose, where their turns do not cancel, and forgets them.
    pub fn spans(&mut self, mut each: impl FnMut(Span)) {
        let (first, last) = std::mem::replace(&mut self.touched, (self.crossings.len(), 0));
        let width = self.width as u32;
        for row in first..last {
            let mut say = |from: u32, to: u32, cover: f32| {
                let (to, level) = (to.min(width), (cover.abs().min(1.0) * f32::from(FULL) + 0.5) as u8);
                if level > 0 && from < to {
                    each(Span { row: row as i32, from: from as i32, to: to as i32, level });
                }
            };
            let crossings = &mut self.crossings[row];
            crossings.sort_unstable_by_key(|crossing| crossing.pixel);
            let (mut pixel, mut here, mut cover) = (0, 0.0, 0.0);
            for crossing in crossings.iter() {
                if crossing.pixel > pixel {
                    say(pixel, pixel + 1, here);
                    say(pixel + 1, crossing.pixel, cover);
                    (pixel, here) = (crossing.pixel, cover);
                }
                (here, cover) = (here + crossing.here, cover + crossing.later);
            }
            say(pixel, pixel + 1, here);
            say(pixel + 1, width, cover);
            crossings.clear();
        }
    }
}

/// Cover that rises by `by` within a row, evenly from x to x \[pixels\].
fn rise(crossings: &mut Vec<Crossing>, by: f64, from: f64, to: f64) {
    let (whole, mut x, mut pixel) = (to - from, from, from as u32);
    loop {
        let next = f64::from(pixel) + 1.0;
        let (end, share) = if to <= next && x == from {
            (to, by)
        } else {
            let end = if to < next { to } else { next };
            (end, by * (end - x) / whole)
        };
        // The pixel is covered from the edge on.
        let (here, later) = ((share * (next - 0.5 * (x + end))) as f32, share as f32);
        match crossings.last_mut() {
            Some(last) if last.pixel == pixel => (last.here, last.later) = (last.here + here, last.later + later),
            _ => crossings.push(Crossing { pixel, here, later }),
        }
        if end >= to {
            break;
        }
        (x, pixel) = (end, pixel + 1);
    }
}
