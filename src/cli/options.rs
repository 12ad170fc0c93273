//! Options that several verbs have.

use super::*;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use stampflow::plot::{Captions, Format, Pictures, WIDEST};
use stampflow::results::comparison::{Computed, comparisons};
use std::thread::available_parallelism;

pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    values: [(&'static str, T); N],
) -> impl TypedValueParser<Value = T> {
    let value = move |word: String| values.iter().find(|(name, _)| *name == word).expect("a possible value").1;
    PossibleValuesParser::new(values.map(|(name, _)| name)).map(value)
}

pub const UNITS: [(&str, DisplaySettings); 2] = [("si", DisplaySettings::Si), ("us", DisplaySettings::Us)];
const FORMATS: [(&str, Format); 2] = [("svg", Format::Svg), ("png", Format::Png)];
const CAPTIONS: [(&str, Captions); 3] =
    [("none", Captions::None), ("short", Captions::Short), ("full", Captions::Full)];

options! {
    Json {
        json: bool [long, hide_short_help = true] "Print JSON, errors too; show no progress",
    };
    Overrides {
        set: Vec<String> = "KEY=VALUE" [long] "Replace a value of the case, as often as needed: tools.die.friction=0.1",
        material: Option<String> = "NAME" [long]
            "Take another sheet of the library, by name or grade, in place of the [material] table",
        coil: Option<String> = "COIL" [long, value_parser = ["strong", "weak"]]
            "Take the end of its grade's band of strength: strong or weak [default: the middle]",
    };
    /// Options of verbs that solve.
    Common {
        quiet: bool [long, short, hide_short_help = true] "Show no progress",
    } overrides: Overrides, json: Json;
    Threads {
        threads: Option<u16> = "N" [long, hide_short_help = true, value_parser = clap::value_parser!(u16).range(1..=256)]
            "Threads for runs side by side [default: one per core]",
    };
    PictureOptions {
        format: Vec<Format> = "FORMAT" [long, value_delimiter = ',', default_value = "png", value_parser = one_of(FORMATS), hide_short_help = true]
            "Formats of pictures",
        width: Option<f64> = "LENGTH" [long, value_parser = width, allow_hyphen_values = true, hide_short_help = true]
            "Width of pictures on paper, 50 to 400 mm [default: 170 mm]",
        dpi: Option<u16> = "N" [long, value_parser = clap::value_parser!(u16).range(50..=1200), hide_short_help = true]
            "Pixels per inch of png, 50 to 1200 [default: 300 with --width, else 1600 pixels across]",
        captions: Captions = "HOW_MUCH" [long, default_value = "short", value_parser = one_of(CAPTIONS), hide_short_help = true]
            "Text of pictures besides axes and legend: short is the title, full also settings and warnings",
        engineering_strain: bool [long, hide_short_help = true] "Draw the forming limit diagram in engineering strains",
    };
}

impl Json {
    /// Whether the command line has `--json`, even if the rest of it is wrong.
    pub fn is_requested() -> bool {
        std::env::args_os().any(|arg| arg == "--json")
    }
}

impl Overrides {
    /// All overrides as `KEY=VALUE`, in the order in which they are applied.
    pub fn all(&self) -> Vec<String> {
        let sheet = self.material.iter().map(|name| format!("material={name:?}"));
        let coil = self.coil.iter().map(|coil| format!("material.coil={coil:?}"));
        sheet.chain(coil).chain(self.set.iter().cloned()).collect()
    }

    pub fn load(&self, path: &Path) -> Result<Case> {
        load(path, &self.all())
    }
}

/// Reads a case and the curves that it will be compared with: bad input is found before solving.
pub fn load(path: &Path, overrides: &[String]) -> Result<Case> {
    caught(&format!("reading {}", path.display()), || {
        let case = case::load(path, overrides)?;
        comparisons(&case, &Computed::nothing(case.model()))?;
        Ok(case)
    })
}

impl Common {
    pub fn json(&self) -> bool {
        self.json.json
    }

    pub fn progress(&self) -> Progress {
        Progress::new(self.quiet || self.json())
    }

    pub fn load_all(&self, paths: &[PathBuf]) -> (Vec<Case>, Vec<anyhow::Error>) {
        let mut failed = Vec::new();
        (sound(paths.iter().map(|path| self.overrides.load(path)), &mut failed), failed)
    }
}

impl Threads {
    pub fn count(&self) -> usize {
        self.threads.map_or_else(|| available_parallelism().map_or(1, usize::from), usize::from)
    }

    /// Sets the number of threads of the process; once, before anything runs.
    pub fn apply(&self) -> Result<()> {
        Ok(rayon::ThreadPoolBuilder::new().num_threads(self.count()).build_global()?)
    }
}

impl PictureOptions {
    pub fn pictures(&self) -> Result<Pictures> {
        let formats = FORMATS.map(|(_, format)| format).into_iter().filter(|one| self.format.contains(one)).collect();
        let (width, dpi) = (self.width, self.dpi.map(f64::from));
        let &Self { captions, engineering_strain, .. } = self;
        let pictures = Pictures { formats, width, dpi, captions, engineering_strain };
        let (across, dpi) = (pictures.across(), (WIDEST / pictures.inches()).floor());
        let what = format!("png would be {across} pixels wide, {WIDEST} at most: try --dpi {dpi} or --format svg");
        ensure!(across <= WIDEST || !pictures.formats.contains(&Format::Png), bad_request(what));
        Ok(pictures)
    }
}

/// Reads a length above 0 \[mm\].
pub fn length(text: &str) -> Result<f64, String> {
    text.parse().map(Positive::<Length>::value).map_err(|error: QuantityError| error.to_string())
}

/// Reads a width on paper \[mm\].
fn width(text: &str) -> Result<f64, String> {
    let mm = length(text)?;
    let is_paper = (50.0..=400.0).contains(&mm);
    is_paper.then_some(mm).ok_or_else(|| "give 50 to 400 mm: 85 mm is a column, 170 mm a page".to_owned())
}
