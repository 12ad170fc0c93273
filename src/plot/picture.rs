//! Pictures as files: their formats, how wide they are on paper, and how much they say.

use super::Chart;
use super::draw::{Drawing, WIDTH};
use super::pdf::MM;
use super::png::drawn;

/// A kind of picture file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Scalable, for web pages.
    Svg,
    /// Scalable, for print.
    Pdf,
    /// Pixels.
    Png,
}

/// How much a picture says beside its axes and its legend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Captions {
    /// Nothing: the text around it does.
    None,
    /// What its lines and areas mean: the title of the case stands above.
    Own,
    /// Its title, and what its lines and areas mean.
    #[default]
    Short,
    /// Also the settings, warnings and assumptions, which the summary has for all pictures.
    Full,
}

/// How pictures are made.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// A file each.
    pub formats: Vec<Format>,
    /// Width on paper \[mm\]; [`PAPER`] where nothing else is asked for.
    pub width: Option<f64>,
    /// Pixels per inch on paper; 1600 pixels wide where nothing else is asked for.
    pub dpi: Option<f64>,
    /// How much they say.
    pub captions: Captions,
    /// Whether forming limit diagrams are in engineering strains, as sheet makers' are, instead of logarithmic ones.
    pub engineering_strain: bool,
}

/// Width on paper where nothing else is asked for: between the margins of A4 \[mm\].
pub const PAPER: f64 = 170.0;

/// Width in pixels where neither a width nor a density is asked for.
const PIXELS: f64 = 1600.0;

/// Pixels per inch where a width is asked for and nothing else: what printers want.
const PRINTED: f64 = 300.0;

/// No letter is smaller on paper \[pt\].
const LEAST_LETTER: f64 = 6.0;

/// The smallest letters of drawings \[px\].
const SMALLEST: f64 = 13.5;

/// An inch \[pt\].
const INCH: f64 = 72.0;

impl Default for Pictures {
    fn default() -> Self {
        Self {
            formats: vec![Format::Png],
            width: None,
            dpi: None,
            captions: Captions::default(),
            engineering_strain: false,
        }
    }
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Svg, Self::Pdf, Self::Png];

    /// Ending of its files.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Pdf => "pdf",
            Self::Png => "png",
        }
    }

    /// A file's name without the ending that one of these formats has.
    pub(crate) fn stem(name: &str) -> Option<&str> {
        Self::ALL.iter().find_map(|format| name.strip_suffix(format.ending())?.strip_suffix('.'))
    }
}

impl Pictures {
    /// The files of a picture, `stem` with the ending of each format.
    pub fn files(&self, stem: &str, chart: &Chart) -> Vec<(String, Vec<u8>)> {
        let bare;
        let chart = match self.captions {
            Captions::None => {
                bare = Chart { title: String::new(), notes: Vec::new(), ..chart.clone() };
                &bare
            }
            _ => chart,
        };
        let drawing = Drawing::of(chart, self.layout());
        let file =
            |format: &Format| (format!("{stem}.{}", format.ending()), self.bytes(&drawing, &chart.title, *format));
        self.formats.iter().map(file).collect()
    }

    /// Width of the drawing \[px\]: on narrow paper there is less room, and letters keep their size.
    fn layout(&self) -> f64 {
        WIDTH.min(self.points() * SMALLEST / LEAST_LETTER)
    }

    /// Width on paper \[pt\].
    fn points(&self) -> f64 {
        MM * self.width.unwrap_or(PAPER)
    }

    fn bytes(&self, drawing: &Drawing, title: &str, format: Format) -> Vec<u8> {
        match format {
            Format::Svg => drawing.svg(self.width).into_bytes(),
            Format::Pdf => drawing.pdf(title, self.points()),
            Format::Png => {
                let dpi = self.dpi.or(self.width.map(|_| PRINTED));
                let pixels = dpi.map_or(PIXELS, |dpi| (dpi * self.points() / INCH).round());
                drawn(drawing, pixels / drawing.width, dpi)
            }
        }
    }
}
