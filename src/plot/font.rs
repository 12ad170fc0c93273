//! The built-in font of every picture: no system font is looked for.

use std::sync::LazyLock;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Name of the font in pictures.
pub const FAMILY: &str = "DejaVu Sans";

/// DejaVu Sans, Latin, Greek and mathematical signs only.
pub static DATA: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");

static FACE: LazyLock<Face<'static>> = LazyLock::new(|| Face::parse(DATA, 0).expect("the built-in font is a font"));

/// The em in the font's own units.
fn em() -> f64 {
    f64::from(FACE.units_per_em())
}

/// What stands for a letter: the font's empty box where it has none. And how far the next one is \[em\].
pub fn glyph(letter: char) -> (GlyphId, f64) {
    let glyph = FACE.glyph_index(letter).unwrap_or_default();
    (glyph, f64::from(FACE.glyph_hor_advance(glyph).unwrap_or(0)) / em())
}

/// Every letter of the font with its glyph.
pub fn letters() -> impl Iterator<Item = (char, GlyphId)> {
    let tables = FACE.tables().cmap.into_iter().flat_map(|map| map.subtables).filter(|table| table.is_unicode());
    tables.flat_map(|table| {
        let mut found = Vec::new();
        table.codepoints(|code| found.extend(char::from_u32(code).zip(table.glyph_index(code))));
        found
    })
}

/// How far the letter behind each glyph is \[em\], in the order of their numbers.
pub fn advances() -> impl Iterator<Item = f64> {
    (0..FACE.number_of_glyphs()).map(|i| f64::from(FACE.glyph_hor_advance(GlyphId(i)).unwrap_or(0)) / em())
}

/// The box around all letters: left, bottom, right, top; how far letters rise, and how far they reach below the baseline
/// (negative) \[em\].
pub fn extent() -> ([f64; 4], f64, f64) {
    let of = |v: i16| f64::from(v) / em();
    let all = FACE.global_bounding_box();
    ([all.x_min, all.y_min, all.x_max, all.y_max].map(of), of(FACE.ascender()), of(FACE.descender()))
}

/// The letters of a text that the font has not got, each once.
pub fn missing(text: &str) -> Vec<char> {
    let mut missing: Vec<char> = text.chars().filter(|c| !c.is_control() && FACE.glyph_index(*c).is_none()).collect();
    missing.sort_unstable();
    missing.dedup();
    missing
}

/// How wide a line of text is \[em\].
pub fn width(text: &str) -> f64 {
    text.chars().map(|letter| glyph(letter).1).sum()
}

/// The letters of a line and where each has its origin \[em\]. An accent of its own, the bar of r̄, stands over the middle
/// of the letter before it.
pub fn placed(text: &str) -> impl Iterator<Item = (char, GlyphId, f64)> {
    let (mut end, mut middle) = (0.0, 0.0);
    text.chars().map(move |letter| {
        let (glyph, advance) = glyph(letter);
        let half = || FACE.glyph_bounding_box(glyph).map_or(0.0, |b| 0.5 * f64::from(b.x_min + b.x_max) / em());
        if matches!(letter, '\u{300}'..='\u{36f}') {
            return (letter, glyph, middle - half());
        }
        let at = end;
        (end, middle) = (at + advance, at + half());
        (letter, glyph, at)
    })
}

/// Takes every edge of a letter's outline, which is turned into chords; x along the baseline and y down \[em\]. Chords
/// leave their curves by about `sagitta` \[em\].
pub fn outline(glyph: GlyphId, sagitta: f64, edge: &mut dyn FnMut((f64, f64), (f64, f64))) {
    FACE.outline_glyph(glyph, &mut Pen { sagitta, first: (0.0, 0.0), last: (0.0, 0.0), edge });
}

/// Follows an outline.
struct Pen<'a> {
    sagitta: f64,
    first: (f64, f64),
    last: (f64, f64),
    edge: &'a mut dyn FnMut((f64, f64), (f64, f64)),
}

fn at(x: f32, y: f32) -> (f64, f64) {
    (f64::from(x) / em(), -f64::from(y) / em())
}

impl Pen<'_> {
    fn to(&mut self, point: (f64, f64)) {
        (self.edge)(self.last, point);
        self.last = point;
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.first = at(x, y);
        self.last = self.first;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.to(at(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (a, b, c) = (self.last, at(x1, y1), at(x, y));
        // A chord over 1/n of the parabola leaves it by 1/n² of this.
        let rise = 0.25 * (a.0 - 2.0 * b.0 + c.0).hypot(a.1 - 2.0 * b.1 + c.1);
        let n = (rise / self.sagitta).sqrt().ceil().max(1.0) as usize;
        for i in 1..=n {
            let t = i as f64 / n as f64;
            let of = |a: f64, b: f64, c: f64| (1.0 - t) * ((1.0 - t) * a + 2.0 * t * b) + t * t * c;
            self.to((of(a.0, b.0, c.0), of(a.1, b.1, c.1)));
        }
    }

    /// By the parabola nearest to it: the built-in font has no cubics.
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (x0, y0) = (self.last.0 * em(), -self.last.1 * em());
        let middle = |a: f64, b: f32, c: f32, d: f32| 0.75 * (b + c) - 0.25 * (a as f32 + d);
        self.quad_to(middle(x0, x1, x2, x), middle(y0, y1, y2, y), x, y);
    }

    fn close(&mut self) {
        self.to(self.first);
    }
}
