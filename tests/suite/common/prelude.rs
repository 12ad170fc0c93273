//! Names that several files of tests use.

pub use crate::common::{
    cli::{COMPARE, CUP, STAGES, ends, folder, read_json, stampflow, text},
    convergence::{orders, orders_of_changes},
    cup::{LAW, MINIMAL},
    files::{below, files},
    page::{agreement, at_most, percent, plain, signed, told},
    random_die,
    shipped::{
        self, DRAWN, findings, last, loaded, made, owned, parsed, peak, row, shipped_case, solve, solved, solved_once,
    },
    simple::{self, are_alike, drive_to},
};
pub use approx::assert_relative_eq;
pub use fastrand::Rng;
pub use regex::Regex;
pub use roxmltree::Document;
pub use serde_json::Value;
pub use stampflow::{
    Observer, State,
    assess::{
        self, Answer, FailureMode, Finding, Kind, Light, check,
        error_bars::{ErrorBars, Origin},
    },
    author::templates::{self, TEMPLATES, find},
    case::{
        self, Case, Solution,
        files::{Disk, Files, Memory},
        library, parse,
    },
    element::Node,
    forming_limit::{Hill, Instant, KeelerBrazier, MarciniakKuczynski, Paths, Points, Sheet, Strain},
    geometry::{Arc, Piece, Point, Profile, Segment},
    import::Options,
    material::{
        Elastic, Fracture, Gtn, Hardening, Hill48, Hosford, Material, Rate, ThermalLaw, YieldCriterion,
        flow::{FlowLaw, ROOM_TEMPERATURE, StressUpdate, YieldCondition},
        fracture::Brozzo,
        hardening::{Extrapolation, Hollomon, Ludwik, Swift, Table},
        rate::PowerRate,
    },
    measure::{CutRing, Ring, Shape, changes, part_height},
    model::{
        Bead, Edge, Extent, Face, Friction, Gas, Geometry, Grading, Heat, HeatFlow, Iteration, Mode, Model, Motion,
        Press, Pressure, RateControl, Role, Settings, Theory, ThicknessRule, Tool, ToolHeat, mesh,
        stage::{Beginning, Stage},
    },
    numerics::{
        PiecewiseLinear, bisect,
        quadrature::{ThicknessPoint, lobatto},
    },
    results::{Make, OUTPUTS, comparison::Computed, tables},
    solver::{
        self, enter, run,
        solution::{
            ElementRecord, Frame, IterationRecord, NodeRecord, PointRecord, StageSolution, StepRecord, StopKind,
            ThroughThickness,
        },
    },
    study::{
        BaseCase, Bracket, Evaluation, LimitSearch, RunTable, SearchRequest, Shard, Study, StudyError, Watch, begin,
        fit::{FlowCurve, HardeningKind, Reduction, fit_laws},
    },
    table::Csv,
};
pub use std::{
    collections::{BTreeMap, BTreeSet},
    f64::consts::{FRAC_PI_2, PI, TAU},
    fs,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    sync::Mutex,
    thread::sleep,
    time::Duration,
};
pub use temp_dir::TempDir;
