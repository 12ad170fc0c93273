//! All tests of the program but those of private items, which stand beside them; one program, so that the library is linked
//! once.
//!
//! `cargo test --test suite outputs::` runs one file of it, `cargo test --test suite verify_` all comparisons with closed forms
//! and experiments. The tests share a process: none changes its folder, its environment or its panic hook, and each
//! writes into a temporary folder of its own.

mod common;

mod animation;
mod answers;
mod architecture;
mod attack;
mod bad_cases;
mod bug;
mod campaign;
mod case_files;
mod check;
mod cli;
mod compare;
mod depth;
mod drawings;
mod drawn_tools;
mod events;
mod files;
mod forming_limit;
mod geometry;
mod material_laws;
mod materials;
mod measures;
mod meridians;
mod messages;
mod model_check;
mod numerics;
mod observer;
mod outputs;
mod package;
mod part;
mod pictures;
mod profiles;
mod report;
mod result_folder;
mod scripts;
mod sizes;
mod springback;
mod stops;
mod tables;
mod templates;
mod told;
mod tool_ends;
mod tool_sizes;
mod units;
mod validation;
mod verdict;
mod verify_beads;
mod verify_bulge;
mod verify_closed_forms;
mod verify_draw_ratio;
mod verify_elastoplastic;
mod verify_fine_mesh;
mod verify_forming_limit;
mod verify_heat_and_voids;
mod verify_hosford;
mod verify_ironing;
mod verify_loads;
mod verify_motion;
mod verify_necking;
mod verify_selective;
mod verify_solver;
mod verify_stages;
mod verify_steps;
mod voids;
mod vtu;
mod wording;
mod written_files;
