//! SVG to PNG, antialiased, with the built-in font only.

use super::font;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::fontdb::Source;
use resvg::usvg::{Options, Tree};
use std::io::Write;
use std::sync::Arc;

/// Pixels per px of the picture: 1600 pixels wide.
const DENSITY: f32 = 2.0;

/// Rows that are in memory at a time.
const BAND: u32 = 128;

/// Renders an SVG that this program drew: opaque RGB, band by band so that little memory is needed.
///
/// Flat drawings compress best unfiltered and deflated (a fifth of the encoder's own settings).
///
/// # Panics
/// When the text is no SVG: a mistake of the caller.
pub fn png(svg: &str) -> Vec<u8> {
    let tree = tree(svg);
    let (width, height) = pixels(&tree, DENSITY);

    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_filter(png::FilterType::NoFilter);
    encoder.set_compression(png::Compression::Default);
    let never = "encoding into memory";
    let mut writer = encoder.write_header().expect(never);
    let mut rows = writer.stream_writer().expect(never);
    let mut band = Pixmap::new(width, BAND.min(height)).expect("the picture has a size");
    for top in (0..height).step_by(BAND as usize) {
        render(&tree, DENSITY, top, &mut band);
        let pixels = &band.pixels()[..(width * BAND.min(height - top)) as usize];
        let rgb: Vec<u8> = pixels.iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect();
        rows.write_all(&rgb).expect(never);
    }
    rows.finish().expect(never);
    writer.finish().expect(never);
    bytes
}

/// An SVG that this program drew, with the built-in font.
///
/// # Panics
/// When the text is no SVG: a mistake of the caller.
pub(super) fn tree(svg: &str) -> Tree {
    let mut options = Options { font_family: font::FAMILY.to_owned(), ..Options::default() };
    options.fontdb_mut().load_font_source(Source::Binary(Arc::new(font::DATA)));
    Tree::from_str(svg, &options).expect("the SVG is of our own making")
}

/// Width and height of a picture at `density` pixels per px.
pub(super) fn pixels(tree: &Tree, density: f32) -> (u32, u32) {
    let size = tree.size();
    ((density * size.width()).ceil() as u32, (density * size.height()).ceil() as u32)
}

/// Draws what lies below `top` \[pixels\] on white.
pub(super) fn render(tree: &Tree, density: f32, top: u32, onto: &mut Pixmap) {
    onto.fill(Color::WHITE);
    let shifted = Transform::from_scale(density, density).post_translate(0.0, -(top as f32));
    resvg::render(tree, shifted, &mut onto.as_mut());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: only the built-in font is loaded, so a text that leaves dark pixels was drawn with it; Polish, Greek
    /// and mathematical letters are asked for beside plain ones.
    #[test]
    fn text_is_drawn_without_system_fonts() {
        for text in ["Force", "ąłż", "σε̄ ∂", "≈ ≤ −", "s₀²"] {
            let svg = format!(
                "<svg width=\"120\" height=\"30\" xmlns=\"http://www.w3.org/2000/svg\"><rect width=\"120\" height=\"30\" \
                 fill=\"white\"/><text x=\"5\" y=\"22\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"20\">{text}\
                 </text></svg>"
            );
            let pixels = Pixmap::decode_png(&png(&svg)).unwrap();
            assert_eq!((pixels.width(), pixels.height()), (240, 60));
            let dark = pixels.pixels().iter().filter(|p| p.red() < 64).count();
            assert!(dark > 150, "{text}: {dark} dark pixels");
        }
    }
}
