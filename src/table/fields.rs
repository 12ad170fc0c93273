//! Fields of steps, elements and strain paths that several tables share.

/// Fields of an accepted step.
pub mod step {
    use crate::model::Geometry;
    use crate::solver::solution::StepRecord;
    use crate::table::{Column, Field, Unit, worded};
    type Step = Field<StepRecord>;

    /// Punch travel \[mm\].
    pub const TRAVEL: Step = Field::new("travel", "Punch travel", Unit::Mm, |s| s.travel);
    /// Force of the punch on the sheet \[N, or N/mm\].
    pub const PUNCH_FORCE: Step = Field::new("punch_force", "Punch force", Unit::N, |s| s.punch_force);
    /// Force of the holder on the sheet \[N, or N/mm\].
    pub const HOLDER_FORCE: Step = Field::new("holder_force", "Holder force", Unit::N, |s| s.holder_force);
    /// Force of the held edge, outward \[N, or N/mm\].
    pub const EDGE_FORCE: Step = Field::new("edge_force", "Edge force", Unit::N, |s| s.edge_force);
    /// Inward motion of the edge \[mm\].
    pub const DRAW_IN: Step = Field::new("draw_in", "Draw-in of the edge", Unit::Mm, |s| s.draw_in);
    /// Thickness of the thinnest element \[mm\].
    pub const THINNEST: Step = Field::new("thinnest", "Least thickness", Unit::Mm, |s| s.thinnest);
    /// Height of the sheet's middle above the flat blank \[mm\].
    pub const POLE_HEIGHT: Step = Field::new("pole_height", "Height of the middle", Unit::Mm, |s| s.pole_height);
    /// Gas pressure on the lower face less that on the upper \[MPa\].
    pub const PRESSURE: Step = Field::new("pressure", "Gas pressure", Unit::MPa, |s| s.pressure);

    /// Diameter at the edge of a blank of this length \[mm\]; in plane strain the width between both edges.
    pub fn edge_diameter(geometry: Geometry, length: f64, steps: &[StepRecord]) -> Column {
        let label = worded(geometry, "Diameter at the edge", "Width between the edges");
        let values = steps.iter().map(|s| 2.0 * (length - s.draw_in)).collect();
        Column::new("edge_diameter", label, Unit::Mm, values)
    }
}

/// Fields of an element at an instant; stresses are Cauchy's, means over the thickness, strains are logarithmic.
pub mod element {
    use crate::solver::solution::ElementRecord;
    use crate::table::{Field, Unit};
    use crate::units::ZERO_CELSIUS;
    type Element = Field<ElementRecord>;

    const INITIAL: [&str; 2] = ["Initial distance from the axis", "Initial distance from the symmetry plane"];
    const PRESENT: [&str; 2] = ["Distance from the axis", "Distance from the symmetry plane"];
    const ALONG: [&str; 2] = ["Meridional strain", "In-plane strain"];
    const ACROSS: [&str; 2] = ["Hoop strain", "Out-of-plane strain"];
    const STRESS_ALONG: [&str; 2] = ["Meridional stress", "In-plane stress"];
    const STRESS_ACROSS: [&str; 2] = ["Hoop stress", "Out-of-plane stress"];

    /// Initial distance from the axis or symmetry plane \[mm\].
    pub const S0: Element = Field::worded("s0", INITIAL, Unit::Mm, |e| e.s0);
    /// Distance from the axis or symmetry plane \[mm\].
    pub const R: Element = Field::worded("r", PRESENT, Unit::Mm, |e| e.r);
    /// Height along the punch travel \[mm\].
    pub const Z: Element = Field::new("z", "z, along punch travel", Unit::Mm, |e| e.z);
    /// Thickness \[mm\].
    pub const THICKNESS: Element = Field::new("thickness", "Thickness", Unit::Mm, |e| e.thickness);
    /// Strain along the section \[–\].
    pub const STRAIN_MERIDIONAL: Element =
        Field::worded("strain_meridional", ALONG, Unit::None, |e| e.strain_meridional);
    /// Strain across the section \[–\].
    pub const STRAIN_HOOP: Element = Field::worded("strain_hoop", ACROSS, Unit::None, |e| e.strain_hoop);
    /// ln(t/t₀) \[–\].
    pub const STRAIN_THICKNESS: Element =
        Field::new("strain_thickness", "Thickness strain", Unit::None, |e| e.strain_thickness);
    /// Equivalent plastic strain, mean over the thickness \[–\].
    pub const STRAIN_EQUIVALENT: Element =
        Field::new("strain_equivalent", "Equivalent strain", Unit::None, |e| e.strain_equivalent);
    /// Stress along the section \[MPa\].
    pub const STRESS_MERIDIONAL: Element =
        Field::worded("stress_meridional", STRESS_ALONG, Unit::MPa, |e| e.stress_meridional);
    /// Stress across the section \[MPa\].
    pub const STRESS_HOOP: Element = Field::worded("stress_hoop", STRESS_ACROSS, Unit::MPa, |e| e.stress_hoop);
    /// Equivalent plastic strain, largest over the thickness \[–\].
    pub const STRAIN_EQUIVALENT_MAX: Element =
        Field::new("strain_equivalent_max", "Largest equivalent strain", Unit::None, |e| e.strain_equivalent_max);
    /// 1 where the element bends, 0 where it is a membrane.
    pub const BENDING: Element =
        Field::new("bending", "Bending (1) or membrane (0)", Unit::None, |e| f64::from(u8::from(e.bends)));
    /// Void volume fraction \[–\].
    pub const POROSITY: Element = Field::new("porosity", "Porosity", Unit::None, |e| e.porosity);
    /// Temperature \[°C\].
    pub const TEMPERATURE: Element =
        Field::new("temperature", "Temperature", Unit::Celsius, |e| e.temperature - ZERO_CELSIUS);
}

/// True strains of the mid-surface along a strain path.
pub mod path {
    use crate::table::{Column, Unit};

    /// Smaller strain in the sheet's plane \[–\].
    pub fn minor(values: Vec<f64>) -> Column {
        Column::new("strain_minor", "Minor true strain, mid-surface", Unit::None, values)
    }

    /// Larger strain in the sheet's plane \[–\].
    pub fn major(values: Vec<f64>) -> Column {
        Column::new("strain_major", "Major true strain, mid-surface", Unit::None, values)
    }
}
