//! What a solution leaves on disk: one file of this folder per table or plot, and one list, [`OUTPUTS`].

mod animation;
pub mod chart;
mod csv;
mod dimensions;
mod draw;
mod file;
pub mod flow_curve;
mod font;
pub mod forming_limit;
mod frame_recorder;
mod gif;
pub mod load_travel;
mod outline;
mod overlay;
mod png;
pub mod pressure_cycle;
pub mod profile;
pub mod residual_stress;
mod sections;
#[cfg(feature = "import")]
mod sketch;
pub mod springback;
mod stage_view;
mod stages;
mod strains;
pub mod summary;
mod thickness_profile;
pub mod trace;
pub mod vtk;
mod writing;

pub use chart::Chart;
pub use csv::csv;
pub use dimensions::{Dimension, Mark, dimensioned};
pub use draw::svg;
pub use file::{WriteError, can_write, remove_others, write};
pub use frame_recorder::FrameRecorder;
pub use overlay::comparisons;
pub use png::png;
#[cfg(feature = "import")]
pub use sketch::sketch;
pub use stage_view::StageView;
pub use summary::{CaseSummary, Figure, Summary};
pub use writing::{OutputError, can_write_all, remove_stale, write_comparisons};

use crate::case::Solution;
use crate::compare::Comparison;
use crate::solution::Frame;
use crate::table::Table;

/// Files by name, each made as it is asked for.
pub type Files<'a> = Box<dyn Iterator<Item = (String, Vec<u8>)> + 'a>;

/// What is written only where it is asked for, of the frames of a [`FrameRecorder`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extra {
    Vtu,
    Animation,
}

/// How a file is made.
#[derive(Clone, Copy, Debug)]
pub enum Make {
    /// Of a stage; nothing where it has no such thing.
    Table(fn(&StageView) -> Option<Table>),
    Text(fn(&StageView) -> Option<String>),
    /// Nothing where there is nothing to draw.
    Plot(fn(&StageView) -> Option<Chart>),
    /// Of the recorded frames of a stage, rising in time, where it is asked for.
    Moving(Extra, for<'a> fn(&'a StageView, &'a [&Frame]) -> Files<'a>),
    /// Of the whole case: stands beside the folders of its stages.
    OfCase(for<'a> fn(&'a Solution, &'a [Comparison]) -> Files<'a>),
}

/// A file that is written, or a family of them, where a solution has what it holds.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    pub file: &'static str,
    /// What it holds, for help texts and below pictures.
    pub about: &'static str,
    pub make: Make,
    /// Whether the second name is one of the family that the first, [`Output::file`], stands for; `None` of a single file.
    pub family: Option<fn(&str, &str) -> bool>,
}

impl Output {
    const fn table(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Table>) -> Self {
        Self { file, about, make: Make::Table(make), family: None }
    }

    const fn text(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<String>) -> Self {
        Self { file, about, make: Make::Text(make), family: None }
    }

    const fn plot(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Chart>) -> Self {
        Self { file, about, make: Make::Plot(make), family: None }
    }

    /// Whether a file of this name is written here.
    pub fn is_named(&self, name: &str) -> bool {
        self.file == name || self.family.is_some_and(|is_one| is_one(self.file, name))
    }

    /// The content of a single file of a stage; none for a plot or a table of nothing.
    pub fn bytes(&self, view: &StageView) -> Option<Vec<u8>> {
        match self.make {
            Make::Table(make) => make(view).map(|table| csv(&table)),
            Make::Text(make) => make(view).map(String::into_bytes),
            Make::Plot(make) => make(view).map(|chart| picture(&chart)),
            Make::Moving(..) | Make::OfCase(_) => None,
        }
    }
}

/// Every file that may be written.
pub const OUTPUTS: &[Output] = &[
    Output::text("summary.json", "the printed summary, versions and checksums", summary::json),
    Output::table("load_travel.csv", "forces, draw-in, energy and iterations of every step", load_travel::of),
    Output::table("profile.csv", "shape, thickness, strains and stresses of every kept frame", profile::of),
    Output::text("springback.csv", "what was measured before and after a release of the tools", springback::csv),
    Output::plot("springback.png", "the section before and after release", springback::plot),
    Output::table("residual_stress.csv", "stress at every layer point after release", residual_stress::of),
    Output::plot("residual_stress.png", "residual stress through the thickness", residual_stress::plot),
    Output::plot("load_travel.png", "forces over the punch travel", load_travel::plot),
    Output::table(
        "pressure_cycle.csv",
        "pressure and strain rate over time, where a gas pressure holds a rate",
        pressure_cycle::of,
    ),
    Output::plot("pressure_cycle.png", "the same, and the height of the dome", pressure_cycle::plot),
    Output::plot("thickness.png", "thickness over the blank at every kept frame", thickness_profile::thickness),
    Output::plot("porosity.png", "porosity over the blank, of a sheet with voids", thickness_profile::porosity),
    Output::plot("temperature.png", "temperature over the blank, where it is given", thickness_profile::temperature),
    Output::plot("strains.png", "strains over the blank at the last frame", strains::plot),
    Output::table("forming_limit.csv", "the forming limit curve, where one is given", forming_limit::curve_of),
    Output::table(
        "strain_paths.csv",
        "strain path and margin of every element, where a forming limit is given",
        forming_limit::paths_of,
    ),
    Output::plot("forming_limit.png", "the curve with every element's strain path", forming_limit::plot),
    Output::plot("shapes.png", "the sheet's section at every kept frame, and the tools", sections::plot),
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
        file: "stages.csv",
        about: "a line for every stage, of a case with several",
        make: Make::OfCase(stages::files),
        family: None,
    },
];

/// A chart as it is written.
fn picture(chart: &Chart) -> Vec<u8> {
    png(chart)
}
