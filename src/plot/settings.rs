//! Picture settings: formats, width on paper, captions.

use super::{svg::WIDTH, svg::sized, *};

named! {
    /// Picture file format.
    pub enum Format;
    /// File name extension.
    fn ending;
    Svg: "svg", "Scalable, for web pages and print.";
    Png: "png", "Pixels.";
}

/// Text in a picture beside axes and legend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Captions {
    /// No title, no notes.
    None,
    /// Notes on the picture itself; the title of the case stands elsewhere.
    Own,
    /// Title and notes on the picture itself.
    #[default]
    Short,
    /// All of it, settings, warnings and assumptions too.
    Full,
}

/// Picture settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// File formats, one file each.
    pub formats: Vec<Format>,
    /// Width on paper \[mm\]; [`PAPER`] by default.
    pub width: Option<f64>,
    /// Pixels per inch on paper; 1600 pixels in all by default.
    pub dpi: Option<f64>,
    /// Text beside axes and legend.
    pub captions: Captions,
    /// True draws forming limit diagrams in engineering strains instead of logarithmic ones.
    pub engineering_strain: bool,
}

/// Default width on paper: between the margins of A4 \[mm\].
pub const PAPER: f64 = 170.0;
/// Default width of PNG files \[px\], and their default density if a paper width is given \[px/inch\].
const PIXELS: f64 = 1600.0;
const PRINTED: f64 = 300.0;
/// Largest width of PNG files \[px\]: 1200 per inch of [`PAPER`], half a gigabyte of memory while one is made.
pub const WIDEST: f64 = 8032.0;
/// Smallest font on paper \[pt\] and in drawings \[px\].
const LEAST_LETTER: f64 = 6.0;
const SMALLEST: f64 = 13.5;
const POINTS: f64 = 72.0;
const INCH: f64 = 25.4;

/// PNG file of a chart, 1600 px wide.
pub fn png(chart: &Chart) -> Vec<u8> {
    raster::png(&sized(chart, WIDTH, None), PIXELS, None)
}

/// Standalone SVG laid out for a width on paper \[mm\]: its smallest letters keep their size.
pub fn svg_on_paper(chart: &Chart, mm: f64) -> String {
    sized(chart, layout_width(mm), None)
}

/// Width of the layout for a width on paper \[px of mm\]: narrow paper holds fewer px.
fn layout_width(mm: f64) -> f64 {
    WIDTH.min(mm / INCH * POINTS * SMALLEST / LEAST_LETTER)
}

impl Default for Pictures {
    fn default() -> Self {
        let captions = Captions::default();
        Self { formats: vec![Format::Png], width: None, dpi: None, captions, engineering_strain: false }
    }
}

impl Format {
    pub(crate) fn stem(name: &str) -> Option<&str> {
        name.strip_suffix(".svg").or_else(|| name.strip_suffix(".png"))
    }
}

impl Pictures {
    fn density(&self) -> Option<f64> {
        self.dpi.or(self.width.map(|_| PRINTED))
    }

    /// Width on paper \[inch\].
    pub fn inches(&self) -> f64 {
        self.width.unwrap_or(PAPER) / INCH
    }

    /// Width of PNG files \[px\].
    pub fn across(&self) -> f64 {
        self.density().map_or(PIXELS, |dpi| (dpi * self.inches()).round())
    }

    /// Files of a chart, `stem` with the extension of each format.
    pub fn files(&self, stem: &str, chart: &Chart) -> Vec<(String, Vec<u8>)> {
        let mut chart = chart.clone();
        if self.captions == Captions::None {
            chart.title.clear();
            chart.notes.clear();
        }
        let svg = sized(&chart, layout_width(self.inches() * INCH), self.width);
        let file = |format: &Format| {
            let bytes = match format {
                Format::Svg => svg.clone().into_bytes(),
                Format::Png => raster::png(&svg, self.across(), self.density()),
            };
            (format!("{stem}.{}", format.ending()), bytes)
        };
        self.formats.iter().map(file).collect()
    }
}
