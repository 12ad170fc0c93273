//! Results on disk: tables, the summary, and the folder that holds them; [`OUTPUTS`] lists every file.

pub(crate) mod csv;
mod error_bars;
mod file;
mod folder;
pub mod forming_limit;
pub mod load_travel;
mod make;
pub mod pressure_cycle;
pub mod profile;
pub mod residual_stress;
mod results;
pub mod springback;
mod stages;
pub mod summary;
pub mod trace;
mod verdict;
pub mod verification;
pub mod vtk;
mod writing;

pub use crate::plot::{
    Captions, Chart, Dimension, Format, FrameRecorder, Mark, PAPER, Pictures, Size, StageView, animation, comparisons,
    dimensioned, flow_curve, png, sketch, svg,
};
use crate::plot::{forming_diagram, overlay, part, states, strains, thickness_profile};
pub use csv::csv;
pub use file::{WriteError, can_write, write};
pub use folder::{IsOurs, ResultFolder};
pub use make::{Extra, Files, Make, Output};
pub use results::Results;
pub use summary::{CaseSummary, Figure, Summary};
pub use verdict::verdict;
pub use writing::{OutputError, REPORT_MARKER, comparison_folder, is_report, is_result, result_folder};

/// Every file that may be written.
pub const OUTPUTS: &[Output] = &[
    Output::text("summary.json", "the printed summary, versions and checksums", summary::json),
    Output::plot("part.png", "the part coloured by thinning, and its thinnest place", part::plot),
    Output::table("load_travel.csv", "forces, draw-in, energy and iterations of every step", load_travel::of),
    Output::table("profile.csv", "shape, thickness, strains and stresses of every kept frame", profile::of),
    Output::text("springback.csv", "what was measured before and after a release of the tools", springback::csv),
    Output::plot("springback.png", "the section before and after release", crate::plot::springback::plot),
    Output::table("residual_stress.csv", "stress at every thickness point after release", residual_stress::of),
    Output::plot("residual_stress.png", "residual stress through the thickness", crate::plot::residual_stress::plot),
    Output::plot("load_travel.png", "forces over the punch travel", crate::plot::load_travel::plot),
    Output::table(
        "pressure_cycle.csv",
        "pressure and strain rate over time, where a gas pressure holds a rate",
        pressure_cycle::of,
    ),
    Output::plot("pressure_cycle.png", "the same, and the height of the dome", crate::plot::pressure_cycle::plot),
    Output::plot(
        "thickness.png",
        "thickness over the blank at every kept frame, and over the part",
        thickness_profile::thickness,
    ),
    Output::plot("porosity.png", "porosity over the blank, of a sheet with voids", thickness_profile::porosity),
    Output::plot("temperature.png", "temperature over the blank, where it is given", thickness_profile::temperature),
    Output::plot("strains.png", "strains over the blank at the last frame", strains::plot),
    Output::table("forming_limit.csv", "the forming limit curve, where one is given", forming_limit::curve_of),
    Output::table(
        "strain_paths.csv",
        "strain path and margin of every element, where a forming limit is given",
        forming_limit::paths_of,
    ),
    Output::plot("forming_limit.png", "how near every place comes to the forming limit", forming_diagram::plot),
    Output::plot(
        "shapes.png",
        "the section over the travel, coloured by thinning, and the tools where they were then",
        states::plot,
    ),
    Output {
        file: "section.pvd",
        about: "with --vtu: some 25 states from the start to the end, for ParaView",
        make: Make::Moving(Extra::Vtu, vtk::section_files),
        family: Some(vtk::is_of),
    },
    Output {
        file: "revolved.pvd",
        about: "with --vtu: the same turned about the axis, of axisymmetric cases",
        make: Make::Moving(Extra::Vtu, vtk::revolved_files),
        family: Some(vtk::is_of),
    },
    Output {
        file: "tools.pvd",
        about: "with --vtu: the tools beside them",
        make: Make::Moving(Extra::Vtu, vtk::tool_files),
        family: Some(vtk::is_of),
    },
    Output {
        file: "shapes.gif",
        about: "with --animate: the section and the load as they move",
        make: Make::Moving(Extra::Animation, animation::files),
        family: None,
    },
    Output {
        file: "compare_*.png, csv",
        about: "overlay and differences for every reference the case is compared with",
        make: Make::OfCase(overlay::files),
        family: Some(overlay::is_comparison),
    },
    Output {
        file: error_bars::FILE,
        about: "with --error-bars, or quick ones with --report: every number and curve with its bar",
        make: Make::OfCase(error_bars::files),
        family: None,
    },
    Output {
        file: stages::FILE,
        about: "a line for every stage, of a case with several",
        make: Make::OfCase(stages::files),
        family: None,
    },
];
