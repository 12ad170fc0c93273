//! Pictures: chart values, free of drawing libraries, and with the feature `app` their rendering as SVG, PNG and GIF.

#[cfg(feature = "app")]
pub mod animation;
#[cfg(feature = "app")]
mod bands;
pub mod chart;
pub mod comparison;
mod dimensions;
mod display;
#[cfg(feature = "app")]
pub mod flow_curve;
#[cfg(feature = "app")]
pub mod forming_diagram;
#[cfg(feature = "app")]
mod frame_recorder;
#[cfg(feature = "app")]
pub(crate) mod load_travel;
pub mod palette;
#[cfg(feature = "app")]
pub(crate) mod part;
#[cfg(feature = "app")]
pub(crate) mod pressure_cycle;
#[cfg(feature = "app")]
mod raster;
#[cfg(feature = "app")]
pub mod residual_stress;
pub(crate) mod sections;
#[cfg(feature = "app")]
mod settings;
#[cfg(feature = "app")]
pub(crate) mod shapes;
mod sketch;
#[cfg(feature = "app")]
pub mod springback;
#[cfg(feature = "app")]
mod stage_view;
#[cfg(feature = "app")]
pub(crate) mod strains;
#[cfg(feature = "app")]
mod svg;
#[cfg(feature = "app")]
pub(crate) mod thickness;
pub(crate) mod thinning;

#[cfg(feature = "app")]
pub use app::*;
pub use chart::Chart;
pub use dimensions::{Dimension, Mark, Size, dimensioned};
pub use sketch::{SketchedTool, sketch};

#[cfg(feature = "app")]
mod app {
    pub use super::frame_recorder::{Extra, FrameRecorder};
    pub use super::settings::png;
    pub use super::settings::{Captions, Format, PAPER, Pictures};
    pub use super::stage_view::StageView;
    pub(crate) use super::stage_view::stop_text;
    pub use super::svg::svg;
}
