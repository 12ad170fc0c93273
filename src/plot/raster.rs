//! Pixels: SVG to PNG and animated GIF.

use super::svg::text::FONT_DATA;
use gif::{Encoder, Frame, Repeat};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};
use std::sync::{Arc, LazyLock};

const IN_MEMORY: &str = "encoding into memory does not fail";
/// An inch \[m\].
const INCH: f64 = 0.0254;
/// Width of animations \[px\].
const GIF_WIDTH: f64 = 800.0;
/// Speed of the search for a palette, 1 (best) to 30.
const GIF_SPEED: i32 = 20;

fn pixels(svg: &str, width: f64) -> Pixmap {
    static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
        let mut fonts = Database::new();
        fonts.load_font_data(FONT_DATA.to_vec());
        Arc::new(fonts)
    });
    let options = Options { fontdb: Arc::clone(&FONTS), font_family: "DejaVu Sans".to_owned(), ..Options::default() };
    let tree = Tree::from_str(svg, &options).expect("the SVG is our own");
    let size = tree.size();
    let scale = width as f32 / size.width();
    let mut pixmap = Pixmap::new(width as u32, (scale * size.height()).round() as u32).expect("a picture has an area");
    pixmap.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    pixmap
}

pub(super) fn png(svg: &str, width: f64, dpi: Option<f64>) -> Vec<u8> {
    let pixmap = pixels(svg, width);
    let rgb: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|rgba| [rgba[0], rgba[1], rgba[2]]).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixmap.width(), pixmap.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    if let Some(dpi) = dpi {
        let per_metre = (dpi / INCH).round() as u32;
        encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter }));
    }
    let mut writer = encoder.write_header().expect(IN_MEMORY);
    writer.write_image_data(&rgb).expect(IN_MEMORY);
    writer.finish().expect(IN_MEMORY);
    bytes
}

pub(super) fn gif(pictures: impl IntoIterator<Item = String>, hundredths: &[u16]) -> Vec<u8> {
    let mut pictures = pictures.into_iter().map(|svg| pixels(&svg, GIF_WIDTH)).peekable();
    let (width, height) = pictures.peek().map_or((1, 1), |first| (first.width() as u16, first.height() as u16));
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height, &[]).expect(IN_MEMORY);
    encoder.set_repeat(Repeat::Infinite).expect(IN_MEMORY);
    for (mut pixmap, &delay) in pictures.zip(hundredths) {
        let frame = Frame::from_rgba_speed(width, height, pixmap.data_mut(), GIF_SPEED);
        encoder.write_frame(&Frame { delay, ..frame }).expect(IN_MEMORY);
    }
    drop(encoder);
    bytes
}
