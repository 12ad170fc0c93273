//! Names that several files of tests use.

pub use crate::common::cli::{COMPARE, CUP, LAW, MINIMAL, STAGES, endless, ends, folder, read_json, stampflow, text};
pub use crate::common::convergence::{orders, orders_of_changes};
pub use crate::common::files::{below, files};
pub use crate::common::page::{agreement, agrees, at_most, percent, plain, signed, told};
pub use crate::common::random_die;
pub use crate::common::shipped::{self, DRAWN, findings, last, loaded, made, mean, owned, parsed, peak, row, shipped};
pub use crate::common::shipped::{numbers, shipped_case, solve, solved, solved_once};
pub use crate::common::simple::{self, are_alike, drive_to};
pub use approx::assert_relative_eq;
pub use fastrand::Rng;
pub use regex::Regex;
pub use roxmltree::Document;
pub use serde_json::Value;
pub use stampflow::assess::error_bars::{ErrorBars, Origin, answered};
pub use stampflow::assess::{self, Answer, FailureMode, Finding, Kind, Light, check};
pub use stampflow::author::{Import, templates, templates::TEMPLATES, templates::find};
pub use stampflow::case::files::{Disk, Files, Memory};
pub use stampflow::case::{self, Case, Solution, library, parse};
pub use stampflow::element::{Node, kinematics::Reference, section::Section};
pub use stampflow::forming_limit::{Hill, Instant, KeelerBrazier, MarciniakKuczynski, Paths, Points, Sheet, Strain};
pub use stampflow::geometry::{Arc, Entry, Opening, Piece, Point, Profile, Segment};
pub use stampflow::import::{DrawingUnit, Options};
pub use stampflow::material::flow::{FlowLaw, PointState, ROOM_TEMPERATURE, StressUpdate, YieldCondition};
pub use stampflow::material::hardening::{Extrapolation, Hollomon, Ludwik, Swift, Table, Voce};
pub use stampflow::material::{Elastic, Fracture, Gtn, Hardening, Hill48, Hosford, Material, Rate, ThermalLaw};
pub use stampflow::material::{YieldCriterion, fracture::Brozzo, rate::PowerRate};
pub use stampflow::measure::{CutRing, Ring, Shape, changes, part_height};
pub use stampflow::model::stage::{Beginning, Stage};
pub use stampflow::model::{
    Bead, Blank, Edge, Extent, Face, Friction, Gas, Geometry, Grading, Heat, HeatFlow, Iteration,
};
pub use stampflow::model::{Mode, Model, Motion, Press, Pressure, RateControl, Role, Settings, Theory, ThicknessRule};
pub use stampflow::model::{Tool, ToolHeat};
pub use stampflow::numerics::quadrature::{ThicknessPoint, lobatto, midpoint};
pub use stampflow::numerics::{PiecewiseLinear, bisect};
pub use stampflow::results::{Make, OUTPUTS, comparison::Computed, tables};
pub use stampflow::solver::solution::{ElementRecord, Frame, IterationRecord, NodeRecord, PointRecord, StageSolution};
pub use stampflow::solver::solution::{StepRecord, StopKind, ThroughThickness};
pub use stampflow::solver::{self, enter, mesh, run};
pub use stampflow::study::fit::{FlowCurve, HardeningKind, Reduction, fit_laws};
pub use stampflow::study::{
    BaseCase, Bracket, Evaluation, LimitSearch, RunTable, SearchRequest, Shard, Study, StudyError,
};
pub use stampflow::study::{Watch, begin, verify::verify};
pub use stampflow::{Observer, State, table::Csv};
pub use std::collections::{BTreeMap, BTreeSet};
pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};
pub use std::path::{Path, PathBuf};
pub use std::process::{Command, Output, Stdio};
pub use std::{fmt::Write, fs, sync::Mutex, thread::sleep, time::Duration};
pub use temp_dir::TempDir;
