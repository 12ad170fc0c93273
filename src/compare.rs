//! A computed table against a reference curve.

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Punch force at equal travel.
    PunchForce,
    /// Punch travel at equal force.
    Travel,
    /// Thickness over the initial distance from the axis, at the last frame.
    ThicknessAtS0,
    /// Thickness over the present radius, at the last frame.
    ThicknessAtRadius,
}
