//! Options that several verbs have.

use super::progress::Progress;
use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Command};
use stampflow::case::{self, Solution, library};
use stampflow::plot::{Captions, Format, Pictures};
use stampflow::results::error_bars;
use stampflow::study::verify::{quick, verify};
use stampflow::units::{Dimensioned, DisplaySettings, Length, Positive};
use std::ffi::OsStr;
use std::ops::RangeInclusive;
use std::sync::LazyLock;

/// Widths of pictures on paper \[mm\].
const WIDTHS: RangeInclusive<f64> = 50.0..=400.0;
const FORMATS: [(&str, Format); 2] = [("svg", Format::Svg), ("png", Format::Png)];
const CAPTIONS: [(&str, Captions); 3] =
    [("none", Captions::None), ("short", Captions::Short), ("full", Captions::Full)];
const SYSTEMS: [(&str, DisplaySettings); 2] = [("si", DisplaySettings::Si), ("us", DisplaySettings::Us)];

/// Parser of a text with words that a shell offers to complete; any other text is accepted too.
#[derive(Clone)]
pub struct Suggested(&'static LazyLock<Vec<String>>);

impl Suggested {
    pub const SHEETS: Self = Self(&SHEETS);
    pub const KEYS: Self = Self(&KEYS);
}

/// Sheets of the library and the grades that they stand for; a space would end a word of the shell.
static SHEETS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let grades = library::materials().into_iter().flatten().filter_map(|entry| entry.stands_for);
    let grades = grades.flat_map(|stands| stands.grades).filter(|grade| !grade.contains(' '));
    library::names().map(str::to_owned).chain(grades).collect()
});

/// Keys of a case file, ready for their value.
static KEYS: LazyLock<Vec<String>> = LazyLock::new(|| case::keys().into_iter().map(|key| key + "=").collect());

impl TypedValueParser for Suggested {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(|word| PossibleValue::new(word.as_str()))))
    }
}

/// Error bars of a run.
#[derive(Debug, clap::Args)]
pub struct ErrorBars {
    /// Compute error bars from finer runs, as `stampflow verify`
    #[arg(long)]
    pub error_bars: bool,
    /// Give no error bars: skip the coarser run for their estimate
    #[arg(long, conflicts_with = "error_bars", hide_short_help = true)]
    no_error_bars: bool,
}

impl ErrorBars {
    /// Error bars from finer runs with `--error-bars`, else from one coarser run if that is the verb's `default`.
    pub fn of(&self, solution: &Solution, progress: &Progress, default: bool) -> Option<error_bars::ErrorBars> {
        if self.error_bars {
            return Some(verify(solution, &progress.count(format!("{}, finer", solution.case.name))).bars);
        }
        (default && !self.no_error_bars).then(|| quick(solution, &Progress::new(true).count(String::new())).bars)
    }
}

#[derive(Debug, clap::Args)]
pub struct Json {
    /// Print JSON, errors too; show no progress
    #[arg(long)]
    pub json: bool,
}

impl Json {
    /// Whether the command line has `--json`, even if the rest of it is wrong.
    pub fn is_requested() -> bool {
        std::env::args_os().any(|arg| arg == "--json")
    }
}

#[derive(Debug, clap::Args)]
pub struct Overrides {
    /// Replace a value of the case: tools.die.friction=0.1
    ///
    /// KEY is a dotted path; give the option as often as needed.
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = Suggested::KEYS, hide_possible_values = true)]
    set: Vec<String>,
    /// Take another sheet of the library
    ///
    /// A name, a grade such as DC04 or the beginning of a name, see `stampflow materials`. It replaces the whole [material]
    /// table except what --set says.
    #[arg(long, value_name = "NAME", value_parser = Suggested::SHEETS, hide_possible_values = true)]
    material: Option<String>,
}

impl Overrides {
    /// All overrides as `KEY=VALUE`, in the order in which they are applied.
    pub fn all(&self) -> Vec<String> {
        let sheet = self.material.iter().map(|name| format!("material={name:?}"));
        sheet.chain(self.set.iter().cloned()).collect()
    }
}

#[derive(Debug, clap::Args)]
pub struct Threads {
    /// Threads for runs side by side [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
}

impl Threads {
    pub fn count(&self) -> Option<usize> {
        self.threads.map(usize::from)
    }

    /// Sets the number of threads of the process; once, before anything runs.
    pub fn apply(&self) -> anyhow::Result<()> {
        if let Some(threads) = self.threads {
            rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global()?;
        }
        Ok(())
    }
}

#[derive(Debug, clap::Args)]
pub struct PictureOptions {
    /// Formats of pictures: svg, png
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', default_value = "png", value_parser = one_of(&FORMATS))]
    format: Vec<Format>,
    /// Width of pictures on paper, 50 to 400 mm [default: 170 mm]
    #[arg(long, value_name = "LENGTH", value_parser = width, allow_hyphen_values = true, hide_short_help = true)]
    width: Option<f64>,
    /// Pixels per inch of png, 50 to 1200 [default: 300 with --width, else 1600 pixels across]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(50..=1200), hide_short_help = true)]
    dpi: Option<u16>,
    /// Text of pictures besides axes and legend: none, short (the title) or full (also settings and warnings)
    #[arg(long, value_name = "HOW_MUCH", default_value = "short", value_parser = one_of(&CAPTIONS), hide_short_help = true)]
    captions: Captions,
    /// Draw the forming limit diagram in engineering strains
    #[arg(long, hide_short_help = true)]
    engineering_strain: bool,
}

impl PictureOptions {
    pub fn pictures(&self) -> Pictures {
        let formats = FORMATS.iter().map(|(_, format)| *format).filter(|format| self.format.contains(format)).collect();
        let (width, dpi) = (self.width, self.dpi.map(f64::from));
        Pictures { formats, width, dpi, captions: self.captions, engineering_strain: self.engineering_strain }
    }
}

/// Reads the value of `--units`.
pub fn units(name: &str) -> Result<DisplaySettings, String> {
    one_of(&SYSTEMS)(&name.to_lowercase()).map_err(|_| "give si (mm, kN, MPa) or us (in, US tonf, ksi)".to_owned())
}

/// Parser of one word of a list.
fn one_of<T: Copy + Send + Sync>(
    all: &'static [(&str, T)],
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync {
    |text| {
        let known = || all.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
        all.iter().find(|(name, _)| *name == text).map(|(_, value)| *value).ok_or_else(|| format!("give {}", known()))
    }
}

fn width(text: &str) -> Result<f64, String> {
    let mm = text.parse::<Positive<Length>>().map_err(|error| error.to_string())?.value();
    match WIDTHS.contains(&mm) {
        true => Ok(mm),
        false => Err(format!("give {} to {} mm: 85 mm is a column, 170 mm a page", WIDTHS.start(), WIDTHS.end())),
    }
}
