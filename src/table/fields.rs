//! Fields of steps, elements and strain paths that several tables share.

/// Fields of an accepted step.
pub mod step {
    use crate::model::Geometry;
    use crate::solver::solution::StepRecord;
    use crate::table::{Column, Field, Unit, worded};

    /// Punch travel \[mm\].
    pub const TRAVEL: Field<StepRecord> = Field::new("travel", "Punch travel", Unit::Mm, |s| s.travel);
    /// Force of the punch on the sheet \[N, or N/mm\].
    pub const PUNCH_FORCE: Field<StepRecord> = Field::force("punch_force", "Punch force", |s| s.punch_force);
    /// Force of the holder on the sheet \[N, or N/mm\].
    pub const HOLDER_FORCE: Field<StepRecord> = Field::force("holder_force", "Holder force", |s| s.holder_force);
    /// Force of the held edge, outward \[N, or N/mm\].
    pub const EDGE_FORCE: Field<StepRecord> = Field::force("edge_force", "Edge force", |s| s.edge_force);
    /// Inward motion of the edge \[mm\].
    pub const DRAW_IN: Field<StepRecord> = Field::new("draw_in", "Draw-in of the edge", Unit::Mm, |s| s.draw_in);
    /// Thickness of the thinnest element \[mm\].
    pub const THINNEST: Field<StepRecord> = Field::new("thinnest", "Least thickness", Unit::Mm, |s| s.thinnest);
    /// Height of the sheet's middle above the flat blank \[mm\].
    pub const POLE_HEIGHT: Field<StepRecord> =
        Field::new("pole_height", "Height of the middle", Unit::Mm, |s| s.pole_height);
    /// Gas pressure on the lower face less that on the upper \[MPa\].
    pub const PRESSURE: Field<StepRecord> = Field::new("pressure", "Gas pressure", Unit::MPa, |s| s.pressure);

    /// Diameter at the edge of a blank of this length \[mm\]; in plane strain the width between both edges.
    pub fn edge_diameter(geometry: Geometry, length: f64, steps: &[StepRecord]) -> Column {
        let label = worded(geometry, "Diameter at the edge", "Width between the edges");
        let values = steps.iter().map(|s| 2.0 * (length - s.draw_in)).collect();
        Column::new("edge_diameter", label, Unit::Mm, values)
    }
}

/// Fields of an element at an instant.
pub mod element {
    use crate::solver::solution::ElementRecord;
    use crate::table::{Field, Unit};
    use crate::units::ZERO_CELSIUS;

    /// Initial distance from the axis or symmetry plane \[mm\].
    pub const S0: Field<ElementRecord> = Field::worded(
        "s0",
        ["Initial distance from the axis", "Initial distance from the symmetry plane"],
        Unit::Mm,
        |e| e.s0,
    );
    /// Distance from the axis or symmetry plane \[mm\].
    pub const R: Field<ElementRecord> =
        Field::worded("r", ["Distance from the axis", "Distance from the symmetry plane"], Unit::Mm, |e| e.r);
    /// Height along the punch travel \[mm\].
    pub const Z: Field<ElementRecord> = Field::new("z", "z, along punch travel", Unit::Mm, |e| e.z);
    /// Thickness \[mm\].
    pub const THICKNESS: Field<ElementRecord> = Field::new("thickness", "Thickness", Unit::Mm, |e| e.thickness);
    /// Logarithmic strain along the section \[–\].
    pub const STRAIN_MERIDIONAL: Field<ElementRecord> =
        Field::worded("strain_meridional", ["Meridional strain", "In-plane strain"], Unit::None, |e| {
            e.strain_meridional
        });
    /// Logarithmic strain across the section \[–\].
    pub const STRAIN_HOOP: Field<ElementRecord> =
        Field::worded("strain_hoop", ["Hoop strain", "Out-of-plane strain"], Unit::None, |e| e.strain_hoop);
    /// ln(t/t₀) \[–\].
    pub const STRAIN_THICKNESS: Field<ElementRecord> =
        Field::new("strain_thickness", "Thickness strain", Unit::None, |e| e.strain_thickness);
    /// Equivalent plastic strain, mean over the thickness \[–\].
    pub const STRAIN_EQUIVALENT: Field<ElementRecord> =
        Field::new("strain_equivalent", "Equivalent strain", Unit::None, |e| e.strain_equivalent);
    /// Cauchy stress along the section, mean over the thickness \[MPa\].
    pub const STRESS_MERIDIONAL: Field<ElementRecord> =
        Field::worded("stress_meridional", ["Meridional stress", "In-plane stress"], Unit::MPa, |e| {
            e.stress_meridional
        });
    /// Cauchy stress across the section, mean over the thickness \[MPa\].
    pub const STRESS_HOOP: Field<ElementRecord> =
        Field::worded("stress_hoop", ["Hoop stress", "Out-of-plane stress"], Unit::MPa, |e| e.stress_hoop);
    /// Equivalent plastic strain, largest over the thickness \[–\].
    pub const STRAIN_EQUIVALENT_MAX: Field<ElementRecord> =
        Field::new("strain_equivalent_max", "Largest equivalent strain", Unit::None, |e| e.strain_equivalent_max);
    /// 1 where the element bends, 0 where it is a membrane.
    pub const BENDING: Field<ElementRecord> =
        Field::new("bending", "Bending (1) or membrane (0)", Unit::None, |e| f64::from(u8::from(e.bends)));
    /// Void volume fraction \[–\].
    pub const POROSITY: Field<ElementRecord> = Field::new("porosity", "Porosity", Unit::None, |e| e.porosity);
    /// Temperature \[°C\].
    pub const TEMPERATURE: Field<ElementRecord> =
        Field::new("temperature", "Temperature", Unit::Celsius, |e| e.temperature - ZERO_CELSIUS);
}

/// True strains of the mid-surface along a strain path.
pub mod path {
    use crate::table::{Column, Unit};

    /// The smaller strain in the sheet's plane \[–\].
    pub fn minor(values: Vec<f64>) -> Column {
        Column::new("strain_minor", "Minor true strain, mid-surface", Unit::None, values)
    }

    /// The larger one \[–\].
    pub fn major(values: Vec<f64>) -> Column {
        Column::new("strain_major", "Major true strain, mid-surface", Unit::None, values)
    }
}
