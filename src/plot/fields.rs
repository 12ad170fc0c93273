//! Fields that several tables share.

pub mod step {
    use crate::solver::solution::StepRecord;
    use crate::table::{self, Unit};
    type Field = table::Field<StepRecord>;

    pub const TRAVEL: Field = Field::new("travel", "Punch travel", Unit::Mm, |s| s.travel);
    pub const PUNCH_FORCE: Field = Field::new("punch_force", "Punch force", Unit::N, |s| s.punch_force);
    pub const PAD_FORCE: Field = Field::new("pad_force", "Pad force", Unit::N, |s| s.pad_force);
    pub const HOLDER_FORCE: Field = Field::new("holder_force", "Holder force", Unit::N, |s| s.holder_force);
    pub const EDGE_FORCE: Field = Field::new("edge_force", "Edge force", Unit::N, |s| s.edge_force);
    pub const DRAW_IN: Field = Field::new("draw_in", "Draw-in of the edge", Unit::Mm, |s| s.draw_in);
    pub const THINNEST: Field = Field::new("thinnest", "Least thickness", Unit::Mm, |s| s.thinnest);
    const THINNEST_PLACE: [&str; 2] = [
        "Initial distance of the thinnest place from the axis",
        "Initial distance of the thinnest place from the symmetry plane",
    ];
    pub const THINNEST_S0: Field = Field::worded("thinnest_s0", THINNEST_PLACE, Unit::Mm, |s| s.thinnest_s0);
    pub const POLE_HEIGHT: Field = Field::new("pole_height", "Height of the middle", Unit::Mm, |s| s.pole_height);
    pub const TEARING_INDEX: Field = Field::new("tearing_index", "Tearing index", Unit::None, |s| s.tearing_index);
    pub const PRESSURE: Field = Field::new("pressure", "Gas pressure", Unit::MPa, |s| s.pressure);
}

/// Fields of an element at an instant; stresses are Cauchy's, means over the thickness, strains are logarithmic.
pub mod element {
    use crate::solver::solution::ElementRecord;
    use crate::table::{self, Unit};
    use crate::units::ZERO_CELSIUS;
    type Field = table::Field<ElementRecord>;

    const INITIAL: [&str; 2] = ["Initial distance from the axis", "Initial distance from the symmetry plane"];
    const PRESENT: [&str; 2] = ["Distance from the axis", "Distance from the symmetry plane"];
    const ALONG: [&str; 2] = ["Meridional strain", "In-plane strain"];
    const ACROSS: [&str; 2] = ["Hoop strain", "Out-of-plane strain"];
    const STRESS_ALONG: [&str; 2] = ["Meridional stress", "In-plane stress"];
    const STRESS_ACROSS: [&str; 2] = ["Hoop stress", "Out-of-plane stress"];

    pub const S0: Field = Field::worded("s0", INITIAL, Unit::Mm, |e| e.s0);
    /// Place on a sheet that is not flat.
    pub const S0_ALONG: Field = Field::new("s0", "Initial length along the sheet", Unit::Mm, |e| e.s0);
    pub const R: Field = Field::worded("r", PRESENT, Unit::Mm, |e| e.r);
    pub const Z: Field = Field::new("z", "z, along punch travel", Unit::Mm, |e| e.z);
    pub const THICKNESS: Field = Field::new("thickness", "Thickness", Unit::Mm, |e| e.thickness);
    pub const STRAIN_MERIDIONAL: Field = Field::worded("strain_meridional", ALONG, Unit::None, |e| e.strain_meridional);
    pub const STRAIN_HOOP: Field = Field::worded("strain_hoop", ACROSS, Unit::None, |e| e.strain_hoop);
    pub const STRAIN_THICKNESS: Field =
        Field::new("strain_thickness", "Thickness strain", Unit::None, |e| e.strain_thickness);
    pub const STRAIN_EQUIVALENT: Field =
        Field::new("strain_equivalent", "Equivalent strain", Unit::None, |e| e.strain_equivalent);
    pub const STRESS_MERIDIONAL: Field =
        Field::worded("stress_meridional", STRESS_ALONG, Unit::MPa, |e| e.stress_meridional);
    pub const STRESS_HOOP: Field = Field::worded("stress_hoop", STRESS_ACROSS, Unit::MPa, |e| e.stress_hoop);
    pub const STRAIN_EQUIVALENT_MAX: Field =
        Field::new("strain_equivalent_max", "Largest equivalent strain", Unit::None, |e| e.strain_equivalent_max);
    pub const TEARING_INDEX_NOW: Field = Field::new("tearing_index", "Tearing index", Unit::None, |e| e.tearing_index);
    pub const TEARING_INDEX_MAX: Field =
        Field::new("tearing_index_max", "Largest tearing index so far", Unit::None, |e| e.tearing_index_max);
    pub const POROSITY: Field = Field::new("porosity", "Porosity", Unit::None, |e| e.porosity);
    pub const DAMAGE: Field = Field::new("damage", "Damage over its critical value", Unit::None, |e| e.damage);
    pub const TEMPERATURE: Field =
        Field::new("temperature", "Temperature", Unit::Celsius, |e| e.temperature - ZERO_CELSIUS);
}
