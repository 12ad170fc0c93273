//! Constitutive mode, and release of the tools.

/// Constitutive mode of the metal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// The flow approach, rigid-viscoplastic: σ = 3 μ A ε̇ with the flow viscosity μ = σ_y/(3 ε̄̇) and ε̄̇² = ε̇ᵀ A ε̇, all at the
    /// end of the step; where the sheet hardly flows ε̄̇² + ε̇₀² takes the place of ε̄̇² (`solver.cutoff_strain`).
    ///
    /// Valid where plastic strains are many times the elastic ones; nothing springs back.
    ///
    /// Source: Zienkiewicz, Jain, Oñate, Int. J. Solids Struct. 14 (1978) 15–38; W. Sosnowski (1994), equations 3, 4.
    #[default]
    Flow,
    /// Elastic and plastic strains: Δσ = D(E, ν) (Δε − Δε_p), Δε_p normal to σ̄(σ − Σ α) = σ_y(ε̄, ε̄̇) at its end.
    ///
    /// Valid for loads from the first contact on, bending and spring-back. Yield is by Cauchy's stress.
    ///
    /// Source: J. C. Simo, R. L. Taylor, Int. J. Num. Meth. Engng. 22 (1986) 649–670.
    ElastoViscoplastic,
    /// Elastic on the stress that the sheet carries, without yield: Δσ = D(E, ν) Δε.
    ///
    /// Valid for the release of a sheet that the flow law formed, as a first guess.
    ///
    /// Source: W. Sosnowski (1994), equations 10 to 13.
    Elastic,
}

/// Release of the tools, whose contact forces become external loads that fade to zero over the run: stiffness of its iterations.
// Sosnowski (1994), equations 10 to 13.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ReleaseStiffness {
    /// Formed anew in every iteration, with the geometric stiffness.
    #[default]
    Updated,
    /// Stiffness at the start of each increment.
    Constant,
}
