//! # stampflow
//!
//! Sections of stamping dies by the **flow approach**: axisymmetric and plane-strain sheet forming with two-node
//! Mindlin shell elements, rigid tools with frictional penalty contact, an explicit predictor and an implicit corrector.
//!
//! ```text
//! drawing (DXF)
//!    │ import::read               Sections            a Profile for each tool; author::Import writes a case file with them
//! case file (TOML, quantities with units)
//!    │ Case::load                 CaseFile → Model     mm, N, s; validated, immutable
//!    │ mesh, State::flat          State                one instant: positions, velocities, thickness points, tools
//!    │ Case::solve                one Stage after another, each a Model of its own on the sheet of the one before
//!    │ solver::run                predictor → corrector → accepted step, or a shorter one
//!    │ Observer                   sees each StepRecord and IterationRecord; may end the run
//!    │ solver::trace              one step again, iteration by iteration, with any of the matrices
//!    │ Solution                   the Case, and a StageSolution for every stage: steps, frames, and why it ended
//!    │ assess::before, after      Finding             what a user should know, before the run and after it
//!    │ study::verify              an error bar for every number, from runs that are refined
//!    │ measure                    angles, curl and places of a Frame, as a person would measure them
//!    │ export::Drawing            tools, formed sheet, blank and trim line for CAD
//!    └ Solution::write            every table, plot and comparison of results::OUTPUTS
//! ```
//!
//! ```
//! # let dir = temp_dir::TempDir::new()?;
//! # let out = dir.path().join("quickstart");
//! let solution = stampflow::Case::load("cases/quickstart.toml")?.solve(&mut ());
//! println!("{}", solution.summary());
//! solution.write(&out)?; // or a path of yours, such as "out/quickstart"
//! # assert!(solution.is_complete() && out.join("load_travel.png").is_file());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The same cup in code, without a case file: `examples/cup.rs`.
//!
//! # Notation
//!
//! | symbol | meaning | unit | where |
//! |---|---|---|---|
//! | r, z | distance from the axis (or the symmetry plane); along the punch travel | mm | [`solver::state::State`] |
//! | θ, φ | rotation of the fibre; slope of the meridian, both counter-clockwise | rad | [`element::kinematics`] |
//! | ȧ | nodal velocities, the unknowns | mm/s, rad/s | [`solver`] |
//! | ε_s, ε_θ, κ_s, κ_θ, γ | meridional and hoop strain, their curvatures, transverse shear | –, 1/mm | [`element::kinematics`] |
//! | ε̄, ε̄̇ | equivalent plastic strain and its rate | –, 1/s | [`material::flow`] |
//! | σ_y, μ | yield stress; flow viscosity σ_y/(3 ε̄̇) | MPa, MPa s | [`material`] |
//! | D(μ), A | σ = D ε̇ = μ·3A ε̇ | | [`material::flow`] |
//! | H, r | iteration matrix, residual: δȧ = −H⁻¹ r | N/mm, N | [`solver`] |
//! | w | carried stress of the primal-dual matrix | MPa | [`material::flow::Iterate`] |
//! | g, p, N, T | gap, contact pressure, normal force, friction | mm, MPa, N | [`contact`] |
//!
//! Forces of models and records are of the whole: of the ring, or of both halves of a plane section per mm of its depth, or
//! over the depth that is given ([`model::Extent`]); inside the solver those of a plane section are of the half that is solved.
//!
//! # Features
//!
//! | feature | adds |
//! |---|---|
//! | none | the solver, case files, measures, findings and templates; without disk, clock, thread or environment |
//! | `app` | tables, pictures, studies, the report and the program; on by default |
//!
//! # References
//! W. Sosnowski, Flow approach — finite element model for stamping processes versus experiment, Comp. Assist. Mech.
//! Eng. Sci. (1994); E. Oñate, O. C. Zienkiewicz, Int. J. Mech. Sci. 25 (1983) 305–335; E. Oñate, C. Agelet de
//! Saracibar, Int. J. Num. Meth. Engng. 30 (1990) 1577–1593.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

/// Makes an enum whose variants have a name each, and `ALL` of them: a row is a variant, its name and its meaning.
macro_rules! named {
    (
        $(#[$attribute:meta])*
        pub enum $enum:ident;
        $(#[$doc:meta])*
        fn $method:ident;
        $($(#[$own:meta])* $variant:ident: $name:literal, $meaning:literal;)*
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $enum {
            $(#[doc = $meaning] $(#[$own])* $variant,)*
        }

        impl $enum {
            /// All variants in order.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$variant),*];

            $(#[$doc])*
            pub fn $method(self) -> &'static str {
                [$($name),*][self as usize]
            }
        }
    };
}

pub mod assess;
pub mod author;
pub mod bead;
pub mod case;
pub mod contact;
pub mod element;
#[cfg(feature = "app")]
pub mod export;
pub mod files;
pub mod forming_limit;
pub mod geometry;
pub mod grade;
pub mod import;
pub mod material;
pub mod measure;
pub mod model;
pub mod numerics;
pub mod part;
#[cfg(feature = "app")]
pub mod plot;
pub mod press;
#[cfg(feature = "app")]
pub mod report;
#[cfg(feature = "app")]
pub mod results;
pub mod rules;
pub mod solver;
#[cfg(feature = "app")]
pub mod study;
pub mod table;
#[cfg(feature = "app")]
pub mod tester;
pub mod units;
mod writer;

pub use case::{Case, Solution};
pub use model::{Model, Stage};
pub use solver::solution::{Frame, StageSolution, StepRecord, Stop};
pub use solver::state::State;
pub use solver::{Observer, run, solve};
pub use table::Table;

#[cfg(test)]
#[path = "../tests/inside/equations.rs"]
mod equations;
