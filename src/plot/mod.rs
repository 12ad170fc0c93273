//! Pictures: chart values, and their rendering as SVG, PNG and GIF.

pub mod animation;
pub(crate) mod axis;
mod bands;
pub mod chart;
mod dimensions;
pub mod drawing;
pub(crate) mod fields;
pub mod forming_diagram;
mod frame_recorder;
pub(crate) mod load_travel;
pub mod palette;
pub(crate) mod part;
pub(crate) mod pressure_cycle;
pub(crate) mod profiles;
mod raster;
pub mod residual_stress;
pub(crate) mod sections;
mod settings;
pub(crate) mod shapes;
mod sketch;
pub mod springback;
mod stage_view;
mod svg;
pub(crate) mod thinning;

pub use axis::{Axis, Spacing};
pub use chart::Chart;
pub use dimensions::{Dimension, dimensioned};
pub use frame_recorder::{Extra, FrameRecorder};
pub use settings::{Captions, Format, PAPER, Pictures, WIDEST, png, svg_on_paper};
pub use sketch::{SketchedTool, sketch};
pub use stage_view::StageView;
pub(crate) use stage_view::stop_text;
pub use svg::svg;

use crate::geometry::{Piece, Point, Profile};
use crate::model::{Extent, Geometry, Model, Role};
use crate::solver::solution::{ElementRecord, Frame, StageSolution, StepRecord};
use crate::table::{Field, Unit};
use crate::units::{Amount, Digits};
use axis::capitalised;
use chart::{Annotation, Color, Panel, Scale, Series, Style, bounds};
use palette::{BLACK, GREY, WHITE, color, pale};
use thinning::Thinning;
