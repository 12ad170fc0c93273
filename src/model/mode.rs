//! How the metal answers to strain, and how the tools let go of it.

/// How the metal answers to strain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// The flow approach: rigid-viscoplastic.
    #[default]
    Flow,
    /// The twin: large-strain elasto-(visco)plastic on the same elements.
    ElastoViscoplastic,
    /// D(E, ν) on the stress that the sheet carries, without yield: the flow approach's spring-back.
    Elastic,
}

/// Tools are taken away: the forces of contact become equal external loads that fade to zero over the run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Release {
    pub stiffness: Stiffness,
}

/// Which stiffness the unloading iterates with (Sosnowski 1994, equations 10 to 13).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stiffness {
    /// Formed anew in every iteration, with the geometric stiffness.
    #[default]
    Updated,
    /// The one at the start of each increment.
    Constant,
}
