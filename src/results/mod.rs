//! Results on disk: tables, error bars, the summary, and the folder that holds them; [`OUTPUTS`] lists every file.

pub mod comparison;
pub(crate) mod csv;
pub(crate) mod file;
mod folder;
mod stages;
pub mod summary;
pub mod tables;
pub mod vtk;
mod write;

use crate::plot::{self, Chart, Extra, Format, FrameRecorder, Pictures, StageView, animation};
use crate::plot::{forming_diagram, part, profiles, shapes};
use crate::solver::solution::Frame;
use crate::table::Table;
pub use csv::csv;
pub use file::{WriteError, can_write, write};
pub use folder::{IsOurs, ResultFolder};
pub use summary::{CaseSummary, Summary};
pub use write::{OutputError, REPORT_MARKER, Results, comparison_folder, is_report, is_result, result_folder, verdict};

/// List of all files that may be written.
pub const OUTPUTS: &[Output] = &[
    output("summary.json", "the printed summary, versions and checksums", Make::Text(Summary::json)),
    picture("part.png", "the part coloured by thinning, and its thinnest place", part::plot),
    table("load_travel.csv", "forces, draw-in, energy and iterations of every step", |view| {
        Some(Table::new([tables::load_travel(view.stage).columns, tables::press(view)].concat()))
    }),
    table("beads.csv", "forces and thinning of beads by their section", |view| crate::bead::table(view.model())),
    table("profile.csv", "shape, thickness, strains and stresses of every kept frame", |view| {
        Some(tables::profile(view.model(), &view.stage.frames))
    }),
    output("springback.csv", "measures before and after a release of the tools", Make::Text(tables::springback)),
    picture("springback.png", "the section before and after release", plot::springback::plot),
    table("residual_stress.csv", "stress at every thickness point after release", tables::residual_stress),
    picture("residual_stress.png", "residual stress through the thickness", plot::residual_stress::plot),
    picture("load_travel.png", "forces over the travel", plot::load_travel::plot),
    table("pressure_cycle.csv", "pressure and the strain rate it holds, over time", tables::pressure_cycle),
    picture("pressure_cycle.png", "pressure over time, and height or feed", plot::pressure_cycle::plot),
    picture("thickness.png", "thickness over the blank at every kept frame, and over the part", profiles::thickness),
    picture("tearing.png", "tearing index over the blank at every kept frame", profiles::tearing_index),
    picture("porosity.png", "porosity over the blank, of a sheet with voids", profiles::porosity),
    picture("damage.png", "damage over the blank, with a criterion of ductile fracture", profiles::damage),
    picture("temperature.png", "temperature over the blank, where it is given", profiles::temperature),
    picture("strains.png", "strains over the blank at the last frame", profiles::strains),
    table("forming_limit.csv", "the forming limit curve, where one is given", |view| {
        view.model().forming_limit.as_ref().map(tables::forming_limit)
    }),
    table("strain_paths.csv", "strain path of every element and its margin to the limit", tables::strain_paths),
    picture("forming_limit.png", "how near every place comes to the forming limit", forming_diagram::plot),
    picture("shapes.png", "section and tools over the travel, coloured by thinning", shapes::plot),
    output(vtk::COLLECTION, "with --vtu: some 25 states for ParaView", Make::Moving(Extra::Vtu, vtk::files)),
    output("shapes.gif", "with --animate: section and load", Make::Moving(Extra::Animation, animation::files)),
    output("compare_*.png, csv", "each reference beside the computed values", Make::OfCase(comparison::files)),
    output(stages::FILE, "a line for every stage, of a case with several", Make::OfCase(stages::files)),
];

/// Files with their names.
pub type Files = Vec<(String, Vec<u8>)>;

/// Function that makes an output; `None` or no files where the solution has no such thing.
#[derive(Clone, Copy, Debug)]
pub enum Make {
    /// Table of a stage.
    Table(fn(&StageView) -> Option<Table>),
    /// Text of a stage.
    Text(fn(&StageView) -> Option<String>),
    /// Picture of a stage.
    Plot(fn(&StageView) -> Option<Chart>),
    /// Files from the recorded frames of a stage, rising in time.
    Moving(Extra, fn(&StageView, &[&Frame]) -> Files),
    /// Files of the whole case, beside the folders of its stages.
    OfCase(fn(&Results) -> Files),
}

/// A file, or a family of files.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    /// Name of the file, or of the first of a family; pictures may have other endings.
    pub file: &'static str,
    /// Content, for help texts and captions.
    pub about: &'static str,
    /// Its making.
    pub make: Make,
}

impl Output {
    /// Tells whether a file's name is one of this output.
    pub fn is_named(&self, name: &str) -> bool {
        let is_other = match self.make {
            Make::Plot(_) => Format::stem(name) == Some(self.stem()),
            Make::Moving(extra, _) => extra == Extra::Vtu && vtk::is_ours(name),
            Make::OfCase(_) => self.file.starts_with(comparison::PREFIX) && comparison::is_comparison(name),
            Make::Table(_) | Make::Text(_) => false,
        };
        self.file == name || is_other
    }

    /// Files of a stage, a plot in every chosen format.
    pub fn files(&self, view: &StageView) -> Files {
        let file = |bytes| vec![(self.file.to_owned(), bytes)];
        let files = match self.make {
            Make::Table(make) => make(view).map(|table| file(csv(&table))),
            Make::Text(make) => make(view).map(|text| file(text.into_bytes())),
            Make::Plot(_) => self.chart(view).map(|chart| view.pictures.files(self.stem(), &chart)),
            Make::Moving(..) | Make::OfCase(_) => None,
        };
        files.unwrap_or_default()
    }

    /// Picture of a stage in display units; `None` if there is nothing to draw or this is no plot.
    pub fn chart(&self, view: &StageView) -> Option<Chart> {
        let Make::Plot(make) = self.make else { return None };
        Some(make(view)?.displayed())
    }

    /// Name without the ending of a picture.
    pub fn stem(&self) -> &'static str {
        Format::stem(self.file).unwrap_or(self.file)
    }
}

const fn output(file: &'static str, about: &'static str, make: Make) -> Output {
    Output { file, about, make }
}

const fn table(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Table>) -> Output {
    output(file, about, Make::Table(make))
}

const fn picture(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Chart>) -> Output {
    output(file, about, Make::Plot(make))
}
