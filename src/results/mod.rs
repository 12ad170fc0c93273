//! Results on disk: tables, error bars, the summary, and the folder that holds them; [`OUTPUTS`] lists every file.

pub mod comparison;
pub(crate) mod csv;
pub mod error_bars;
mod file;
mod folder;
mod output;
mod stages;
pub mod summary;
pub mod tables;
pub mod vtk;
mod write;

use crate::plot::{self, Chart, Extra, Format, FrameRecorder, Pictures, StageView, animation};
use crate::plot::{forming_diagram, part, profiles, shapes};
pub use csv::csv;
pub use file::{WriteError, can_write, write};
pub use folder::{IsOurs, ResultFolder};
pub use output::{Files, Make, Output};
use output::{output, picture, table};
pub use summary::{CaseSummary, Summary};
pub use write::{OutputError, REPORT_MARKER, Results, comparison_folder, is_report, is_result, result_folder, verdict};

/// List of all files that may be written.
pub const OUTPUTS: &[Output] = &[
    output("summary.json", "the printed summary, versions and checksums", Make::Text(Summary::json)),
    picture("part.png", "the part coloured by thinning, and its thinnest place", part::plot),
    table("load_travel.csv", "forces, draw-in, energy and iterations of every step", |view| {
        Some(tables::load_travel(view.stage))
    }),
    table("profile.csv", "shape, thickness, strains and stresses of every kept frame", |view| {
        Some(tables::profile(view.model(), &view.stage.frames))
    }),
    output(
        "springback.csv",
        "what was measured before and after a release of the tools",
        Make::Text(tables::springback),
    ),
    picture("springback.png", "the section before and after release", plot::springback::plot),
    table("residual_stress.csv", "stress at every thickness point after release", tables::residual_stress),
    picture("residual_stress.png", "residual stress through the thickness", plot::residual_stress::plot),
    picture("load_travel.png", "forces over the punch travel", plot::load_travel::plot),
    table(
        "pressure_cycle.csv",
        "pressure and strain rate over time, where a gas pressure holds a rate",
        tables::pressure_cycle,
    ),
    picture("pressure_cycle.png", "the same, and the height of the dome", plot::pressure_cycle::plot),
    picture("thickness.png", "thickness over the blank at every kept frame, and over the part", profiles::thickness),
    picture("porosity.png", "porosity over the blank, of a sheet with voids", profiles::porosity),
    picture("temperature.png", "temperature over the blank, where it is given", profiles::temperature),
    picture("strains.png", "strains over the blank at the last frame", profiles::strains),
    table("forming_limit.csv", "the forming limit curve, where one is given", |view| {
        view.model().forming_limit.as_ref().map(tables::forming_limit)
    }),
    table(
        "strain_paths.csv",
        "strain path and margin of every element, where a forming limit is given",
        tables::strain_paths,
    ),
    picture("forming_limit.png", "how near every place comes to the forming limit", forming_diagram::plot),
    picture(
        "shapes.png",
        "the section over the travel, coloured by thinning, and the tools where they were then",
        shapes::plot,
    ),
    output(
        vtk::COLLECTION,
        "with --vtu: some 25 states from the start to the end, for ParaView",
        Make::Moving(Extra::Vtu, vtk::files),
    ),
    output(
        "shapes.gif",
        "with --animate: the section and the load as they move",
        Make::Moving(Extra::Animation, animation::files),
    ),
    output(
        "compare_*.png, csv",
        "comparisons and differences for every reference the case is compared with",
        Make::OfCase(comparison::files),
    ),
    output(stages::FILE, "a line for every stage, of a case with several", Make::OfCase(stages::files)),
];
