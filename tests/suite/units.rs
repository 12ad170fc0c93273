//! Quantities, headers and numbers as they are read and written.

use crate::common::prelude::*;
use proptest::prelude::*;
use stampflow::table::Unit;
use stampflow::units::{
    Angle, Conductivity, Density, Dimensioned, Energy, Force, HeatTransfer, Length, LineForce, PerKelvin, Positive,
    QuantityError, Ratio, SpecificHeat, Speed, Stress, Temperature, Time, parse, rounded, significant, trimmed,
    without_zeros,
};

fn value<Q: Dimensioned + std::str::FromStr<Err = QuantityError>>(text: &str) -> f64 {
    text.parse::<Q>().unwrap_or_else(|e| panic!("{text}: {e}")).value()
}

/// Trust: hand conversions with the exact definitions of inch, pound-force and the three tons.
#[test]
fn units_convert_to_solver_units() {
    let pound = 4.448_221_615_260_5;
    for (found, expected) in [
        (value::<Length>("0.035 in"), 0.889),
        (value::<Length>("0.035\""), 0.889),
        (value::<Length>("0.035″"), 0.889),
        (value::<Length>("60mm"), 60.0),
        (value::<Length>("−3 mm"), -3.0),
        (value::<Length>("2 m^2/m"), 2000.0),
        (value::<Length>("20 ga_steel"), 0.0359 * 25.4),
        (value::<Length>("20 ga_al"), 0.0320 * 25.4),
        (value::<Length>("60 inches"), 1524.0),
        (value::<Force>("80 kN"), 80_000.0),
        (value::<Force>("1e3 N"), 1000.0),
        (value::<Force>("100 t"), 980_665.0),
        (value::<Force>("1 tonf_us"), 2000.0 * pound),
        (value::<Force>("100 tonnes"), 980_665.0),
        (value::<LineForce>("1300 kN/m"), 1300.0),
        (value::<Stress>("5.4 tonf_uk/in^2"), 5.4 * 2240.0 * pound / 645.16),
        (value::<Stress>("1 tonf_uk/in²"), 2240.0 * pound / 645.16),
        (value::<Stress>("30 ksi"), 30.0 * 1000.0 * pound / 645.16),
        (value::<Stress>("60 kp/cm^2"), 60.0 * 9.80665 / 100.0),
        (value::<Stress>("1 N·mm^-2"), 1.0),
        (value::<Stress>("30N/mm2"), 30.0),
        (value::<Stress>("300 bar"), 30.0),
        (value::<Angle>("90 deg") + value::<Angle>("60°") + value::<Angle>("30 °"), std::f64::consts::PI),
        (value::<Speed>("6 m/min"), 100.0),
        (value::<Time>("30 ms"), 0.03),
        (value::<Ratio>("5 %"), 0.05),
        (value::<Temperature>("-20°C"), 253.15),
        (value::<Temperature>("493 K"), 493.0),
        // ρ c of aluminium: 2700 kg/m³ × 900 J/(kg K) = 2.43 MPa/K.
        (value::<Density>("2700 kg/m3") * value::<SpecificHeat>("900 J/kg/K"), 2.43),
        (value::<Density>("2.7 g/cm^3"), 2.7e-9),
        (value::<Conductivity>("130 W/m/K"), 130.0),
        (value::<HeatTransfer>("1400 W/m^2/K"), 1.4),
        (value::<PerKelvin>("0.3 %/K"), 0.003),
        (value::<Energy>("8.314 J/mol"), 8314.0),
    ] {
        assert_relative_eq!(found, expected, max_relative = 1e-9);
    }
}

proptest! {
    #[test]
    fn parser_never_panics_be_it_near_the_grammar(text in "\\PC*|[-+−]?[0-9.,e]{0,6} ?([a-zA-Z%²^*/· ]|mm|kN|in){0,8}") {
        let _ = (parse(&text), text.parse::<Positive<Stress>>());
    }
}

/// Trust: by hand.
#[test]
fn numbers_are_written_without_noise() {
    assert_eq!([rounded(31.400000000000002), rounded(-0.0), significant(0.0123456, 4)], [31.4, 0.0, 0.01235]);
    assert!(rounded(-0.0).is_sign_positive());
    for (value, decimals, text) in
        [(30.5, 3, "30.5"), (-0.0001, 3, "0"), (100.0, 0, "100"), (1.23456, 3, "1.235"), (120.0, 2, "120")]
    {
        assert_eq!(trimmed(value, decimals), text);
    }
    assert_eq!([without_zeros("10.500"), without_zeros("100")], ["10.5", "100"]);
}

/// Trust: factors by hand, with the exact definitions of inch and pound-force.
#[test]
fn headers_end_in_units() {
    for (header, factor) in [("x_in", 25.4), ("x_lbf", 4.448_221_615_260_5), ("x_kN_per_m", 1.0)] {
        assert_eq!(Unit::of_header(header).map(|found| found.1), Ok(factor), "{header}");
    }
}
