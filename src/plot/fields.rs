//! Fields that several tables share.

use crate::solver::solution::{ElementRecord, StepRecord};
use crate::table::{Field, Unit};
use crate::units::ZERO_CELSIUS;

/// Makes fields of a record's own numbers: the number, its name in files, and labels, axisymmetric and in plane strain.
macro_rules! fields {
    ($record:ident: $($(#[$doc:meta])* $name:ident = $number:ident, $labels:expr, $unit:ident;)*) => {$(
        $(#[$doc])*
        pub const $name: Field<$record> = Field::worded(stringify!($number), $labels, Unit::$unit, |of| of.$number);
    )*};
}

pub mod step {
    use super::*;

    fields! {
        StepRecord:
        TIME = time, ["Time"; 2], Second;
        TRAVEL = travel, ["Punch travel"; 2], Mm;
        PUNCH_FORCE = punch_force, ["Punch force"; 2], N;
        PAD_FORCE = pad_force, ["Pad force"; 2], N;
        HOLDER_FORCE = holder_force, ["Holder force"; 2], N;
        EDGE_FORCE = edge_force, ["Edge force"; 2], N;
        DRAW_IN = draw_in, ["Draw-in of the edge"; 2], Mm;
        THINNEST = thinnest, ["Least thickness"; 2], Mm;
        THINNEST_S0 = thinnest_s0, PLACE, Mm;
        POLE_HEIGHT = pole_height, ["Height of the middle"; 2], Mm;
        TEARING_INDEX = tearing_index, ["Tearing index"; 2], None;
        PRESSURE = pressure, ["Pressure"; 2], MPa;
    }

    const PLACE: [&str; 2] = [
        "Initial distance of the thinnest place from the axis",
        "Initial distance of the thinnest place from the symmetry plane",
    ];
}

/// Fields of an element at an instant; stresses are Cauchy's, means over the thickness, strains are logarithmic.
pub mod element {
    use super::*;

    fields! {
        ElementRecord:
        S0 = s0, ["Initial distance from the axis", "Initial distance from the symmetry plane"], Mm;
        /// Place on a sheet that is not flat.
        S0_ALONG = s0, ["Initial length along the sheet"; 2], Mm;
        R = r, ["Distance from the axis", "Distance from the symmetry plane"], Mm;
        Z = z, ["z, along the axis", "z, along the plane"], Mm;
        THICKNESS = thickness, ["Thickness"; 2], Mm;
        STRAIN_MERIDIONAL = strain_meridional, ["Meridional strain", "In-plane strain"], None;
        STRAIN_HOOP = strain_hoop, ["Hoop strain", "Out-of-plane strain"], None;
        STRAIN_THICKNESS = strain_thickness, ["Thickness strain"; 2], None;
        STRAIN_EQUIVALENT = strain_equivalent, ["Equivalent strain"; 2], None;
        STRESS_MERIDIONAL = stress_meridional, ["Meridional stress", "In-plane stress"], MPa;
        STRESS_HOOP = stress_hoop, ["Hoop stress", "Out-of-plane stress"], MPa;
        STRAIN_EQUIVALENT_MAX = strain_equivalent_max, ["Largest equivalent strain"; 2], None;
        TEARING_INDEX_NOW = tearing_index, ["Tearing index"; 2], None;
        TEARING_INDEX_MAX = tearing_index_max, ["Largest tearing index so far"; 2], None;
        POROSITY = porosity, ["Porosity"; 2], None;
        DAMAGE = damage, ["Damage over its critical value"; 2], None;
    }

    pub const TEMPERATURE: Field<ElementRecord> =
        Field::new("temperature", "Temperature", Unit::Celsius, |e| e.temperature - ZERO_CELSIUS);
}
