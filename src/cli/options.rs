//! Options that several verbs have.

use super::suggested::Suggested;
use clap::ValueEnum;
use stampflow::results::{Captions, Format, Pictures};
use stampflow::units::{Dimensioned, DisplaySettings, Length, Positive};
use std::ops::RangeInclusive;

/// The option of every verb that has a result.
#[derive(Debug, clap::Args)]
pub struct Json {
    /// Print JSON for programs instead, and errors as JSON too; shows no progress
    #[arg(long)]
    pub json: bool,
}

impl Json {
    /// Whether the command line asks for JSON, be the rest of it right or wrong.
    pub fn is_asked_for() -> bool {
        std::env::args_os().any(|arg| arg == "--json")
    }
}

/// The option of every verb that reads a case.
#[derive(Debug, clap::Args)]
pub struct Overrides {
    /// Replace what the case says: a dotted path of keys and a value with its unit, as often as needed
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = Suggested::KEYS, hide_possible_values = true)]
    set: Vec<String>,
    /// Another sheet: the whole of [material] is that of the library, but for what --set says besides; a name, a grade such
    /// as DC04 or the beginning of one, see `stampflow materials`
    #[arg(long, value_name = "NAME", value_parser = Suggested::SHEETS, hide_possible_values = true)]
    material: Option<String>,
}

impl Overrides {
    /// All of them as `KEY=VALUE`, in the order in which they are applied.
    pub fn all(&self) -> Vec<String> {
        let sheet = self.material.iter().map(|name| format!("material={name:?}"));
        sheet.chain(self.set.iter().cloned()).collect()
    }
}

/// Reads the value of `--units`.
pub fn units(name: &str) -> Result<DisplaySettings, String> {
    match name.to_lowercase().as_str() {
        "si" => Ok(DisplaySettings::Si),
        "us" => Ok(DisplaySettings::Us),
        _ => Err("the systems are si (mm, kN, MPa) and us (in, US tonf, ksi)".to_owned()),
    }
}

/// The option of every verb that solves several cases.
#[derive(Debug, clap::Args)]
pub struct Threads {
    /// Threads for cases that run side by side, at most 256 [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
}

impl Threads {
    /// How many are asked for.
    pub fn count(&self) -> Option<usize> {
        self.threads.map(usize::from)
    }

    /// Makes it so, once and before anything runs.
    pub fn apply(&self) -> anyhow::Result<()> {
        if let Some(threads) = self.threads {
            rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global()?;
        }
        Ok(())
    }
}

/// The options of every verb that draws pictures.
#[derive(Debug, clap::Args)]
pub struct PictureOptions {
    /// Formats of pictures, a file each: svg, pdf, png
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', default_value = "png")]
    format: Vec<PictureFormat>,
    /// Width of pictures on paper, 50 to 400 mm: no letter is smaller than 6 pt [default: 170 mm]
    #[arg(long, value_name = "LENGTH", value_parser = width, allow_hyphen_values = true)]
    width: Option<Millimetres>,
    /// Pixels per inch of png, 50 to 1200 [default: 300 of a width that is given, else 1600 pixels across]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(50..=1200))]
    dpi: Option<u16>,
    /// What pictures say beside axes and legend: nothing; the title and what lines mean; also settings, warnings and
    /// assumptions, which the summary has
    #[arg(long, value_name = "HOW_MUCH", value_enum, default_value_t = CaptionOption::Short)]
    captions: CaptionOption,
    /// Draw the forming limit diagram in engineering strains instead of true ones
    #[arg(long)]
    engineering_strain: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum PictureFormat {
    Svg,
    Png,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum CaptionOption {
    None,
    Short,
    Full,
}

/// Of a picture on paper.
#[derive(Clone, Copy, Debug)]
struct Millimetres(f64);

/// Widths that letters and paper leave room for \[mm\].
const WIDTHS: RangeInclusive<f64> = 50.0..=400.0;

fn width(text: &str) -> Result<Millimetres, String> {
    let mm = text.parse::<Positive<Length>>().map_err(|error| error.to_string())?.value();
    match WIDTHS.contains(&mm) {
        true => Ok(Millimetres(mm)),
        false => Err(format!("give {} to {} mm: 85 mm is a column, 170 mm a page", WIDTHS.start(), WIDTHS.end())),
    }
}

impl PictureOptions {
    /// How pictures are made.
    pub fn pictures(&self) -> Pictures {
        let mut formats: Vec<Format> = Vec::new();
        for format in &self.format {
            let format = match format {
                PictureFormat::Svg => Format::Svg,
                PictureFormat::Png => Format::Png,
            };
            if !formats.contains(&format) {
                formats.push(format);
            }
        }
        let captions = match self.captions {
            CaptionOption::None => Captions::None,
            CaptionOption::Short => Captions::Short,
            CaptionOption::Full => Captions::Full,
        };
        Pictures {
            formats,
            width: self.width.map(|width| width.0),
            dpi: self.dpi.map(f64::from),
            captions,
            engineering_strain: self.engineering_strain,
        }
    }
}
