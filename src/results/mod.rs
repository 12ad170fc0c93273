//! Results on disk: tables, the summary, and the folder that holds them; [`OUTPUTS`] lists every file.

pub mod comparison;
pub(crate) mod csv;
pub mod error_bars;
mod file;
mod folder;
pub mod forming_limit;
pub mod load_travel;
mod output;
pub mod pressure_cycle;
pub mod profile;
pub mod residual_stress;
mod run;
pub mod springback;
mod stages;
pub mod summary;
pub mod trace;
pub mod vtk;
mod write;

use crate::plot::{Chart, Extra, Format, FrameRecorder, Pictures, StageView, animation};
use crate::plot::{forming_diagram, part, profiles, shapes};
pub use csv::csv;
pub use file::{WriteError, can_write, write};
pub use folder::{IsOurs, ResultFolder};
pub use output::{Files, Make, Output};
use output::{output, plot, table};
pub use run::{Results, verdict};
pub use summary::{CaseSummary, Summary};
pub use write::{OutputError, REPORT_MARKER, comparison_folder, is_report, is_result, result_folder};

/// List of all files that may be written.
pub const OUTPUTS: &[Output] = &[
    output("summary.json", "the printed summary, versions and checksums", Make::Text(summary::json)),
    plot("part.png", "the part coloured by thinning, and its thinnest place", part::plot),
    table("load_travel.csv", "forces, draw-in, energy and iterations of every step", load_travel::of),
    table("profile.csv", "shape, thickness, strains and stresses of every kept frame", profile::of),
    output("springback.csv", "what was measured before and after a release of the tools", Make::Text(springback::csv)),
    plot("springback.png", "the section before and after release", crate::plot::springback::plot),
    table("residual_stress.csv", "stress at every thickness point after release", residual_stress::of),
    plot("residual_stress.png", "residual stress through the thickness", crate::plot::residual_stress::plot),
    plot("load_travel.png", "forces over the punch travel", crate::plot::load_travel::plot),
    table(
        "pressure_cycle.csv",
        "pressure and strain rate over time, where a gas pressure holds a rate",
        pressure_cycle::of,
    ),
    plot("pressure_cycle.png", "the same, and the height of the dome", crate::plot::pressure_cycle::plot),
    plot("thickness.png", "thickness over the blank at every kept frame, and over the part", profiles::thickness),
    plot("porosity.png", "porosity over the blank, of a sheet with voids", profiles::porosity),
    plot("temperature.png", "temperature over the blank, where it is given", profiles::temperature),
    plot("strains.png", "strains over the blank at the last frame", profiles::strains),
    table("forming_limit.csv", "the forming limit curve, where one is given", forming_limit::curve_of),
    table(
        "strain_paths.csv",
        "strain path and margin of every element, where a forming limit is given",
        forming_limit::paths_of,
    ),
    plot("forming_limit.png", "how near every place comes to the forming limit", forming_diagram::plot),
    plot(
        "shapes.png",
        "the section over the travel, coloured by thinning, and the tools where they were then",
        shapes::plot,
    ),
    output(
        "section.pvd",
        "with --vtu: some 25 states from the start to the end, for ParaView",
        Make::Moving(Extra::Vtu, vtk::section_files),
    ),
    output("tools.pvd", "with --vtu: the tools beside them", Make::Moving(Extra::Vtu, vtk::tool_files)),
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
    output(
        error_bars::FILE,
        "with --error-bars, or quick ones with --report: every number and curve with its bar",
        Make::OfCase(error_bars::files),
    ),
    output(stages::FILE, "a line for every stage, of a case with several", Make::OfCase(stages::files)),
];
