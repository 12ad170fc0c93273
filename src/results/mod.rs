//! Results on disk: tables, the summary, and the folder that holds them; [`OUTPUTS`] lists every file.

pub(crate) mod csv;
mod error_bars;
mod file;
mod folder;
pub mod forming_limit;
pub mod load_travel;
mod output;
mod overlay;
pub mod pressure_cycle;
pub mod profile;
pub mod residual_stress;
mod run;
pub mod springback;
mod stages;
pub mod summary;
pub mod trace;
pub mod verification;
pub mod vtk;
mod write;

pub use crate::plot::{
    Captions, Chart, Dimension, Extra, Format, FrameRecorder, Mark, PAPER, Pictures, Size, StageView, animation,
    dimensioned, flow_curve, png, sketch, svg,
};
use crate::plot::{forming_diagram, part, shapes, strains, thickness};
pub use csv::csv;
pub use file::{WriteError, can_write, write};
pub use folder::{IsOurs, ResultFolder};
pub use output::{Files, Make, Output};
pub use overlay::comparisons;
pub use run::{Results, verdict};
pub use summary::{CaseSummary, Figure, Summary};
pub use write::{OutputError, REPORT_MARKER, comparison_folder, is_report, is_result, result_folder};

/// List of all files that may be written.
pub const OUTPUTS: &[Output] = &[
    Output::new("summary.json", "the printed summary, versions and checksums", Make::Text(summary::json)),
    Output::new("part.png", "the part coloured by thinning, and its thinnest place", Make::Plot(part::plot)),
    Output::new(
        "load_travel.csv",
        "forces, draw-in, energy and iterations of every step",
        Make::Table(load_travel::of),
    ),
    Output::new("profile.csv", "shape, thickness, strains and stresses of every kept frame", Make::Table(profile::of)),
    Output::new(
        "springback.csv",
        "what was measured before and after a release of the tools",
        Make::Text(springback::csv),
    ),
    Output::new("springback.png", "the section before and after release", Make::Plot(crate::plot::springback::plot)),
    Output::new(
        "residual_stress.csv",
        "stress at every thickness point after release",
        Make::Table(residual_stress::of),
    ),
    Output::new(
        "residual_stress.png",
        "residual stress through the thickness",
        Make::Plot(crate::plot::residual_stress::plot),
    ),
    Output::new("load_travel.png", "forces over the punch travel", Make::Plot(crate::plot::load_travel::plot)),
    Output::new(
        "pressure_cycle.csv",
        "pressure and strain rate over time, where a gas pressure holds a rate",
        Make::Table(pressure_cycle::of),
    ),
    Output::new(
        "pressure_cycle.png",
        "the same, and the height of the dome",
        Make::Plot(crate::plot::pressure_cycle::plot),
    ),
    Output::new(
        "thickness.png",
        "thickness over the blank at every kept frame, and over the part",
        Make::Plot(thickness::thickness),
    ),
    Output::new("porosity.png", "porosity over the blank, of a sheet with voids", Make::Plot(thickness::porosity)),
    Output::new("temperature.png", "temperature over the blank, where it is given", Make::Plot(thickness::temperature)),
    Output::new("strains.png", "strains over the blank at the last frame", Make::Plot(strains::plot)),
    Output::new(
        "forming_limit.csv",
        "the forming limit curve, where one is given",
        Make::Table(forming_limit::curve_of),
    ),
    Output::new(
        "strain_paths.csv",
        "strain path and margin of every element, where a forming limit is given",
        Make::Table(forming_limit::paths_of),
    ),
    Output::new(
        "forming_limit.png",
        "how near every place comes to the forming limit",
        Make::Plot(forming_diagram::plot),
    ),
    Output::new(
        "shapes.png",
        "the section over the travel, coloured by thinning, and the tools where they were then",
        Make::Plot(shapes::plot),
    ),
    Output::new(
        "section.pvd",
        "with --vtu: some 25 states from the start to the end, for ParaView",
        Make::Moving(Extra::Vtu, vtk::section_files),
    )
    .family(vtk::is_of),
    Output::new("tools.pvd", "with --vtu: the tools beside them", Make::Moving(Extra::Vtu, vtk::tool_files))
        .family(vtk::is_of),
    Output::new(
        "shapes.gif",
        "with --animate: the section and the load as they move",
        Make::Moving(Extra::Animation, animation::files),
    ),
    Output::new(
        "compare_*.png, csv",
        "overlay and differences for every reference the case is compared with",
        Make::OfCase(overlay::files),
    )
    .family(overlay::is_comparison),
    Output::new(
        error_bars::FILE,
        "with --error-bars, or quick ones with --report: every number and curve with its bar",
        Make::OfCase(error_bars::files),
    ),
    Output::new(stages::FILE, "a line for every stage, of a case with several", Make::OfCase(stages::files)),
];
