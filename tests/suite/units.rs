//! Quantities, headers and numbers as they are read and written.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stampflow::units::{
    Angle, Conductivity, Density, Dimensioned, Energy, Force, HeatTransfer, Length, LineForce, NonNegative, PerKelvin,
    Positive, QuantityError, Ratio, SpecificHeat, Speed, Stress, Temperature, Time, parse, rounded, significant,
    trimmed, without_zeros,
};

fn value<Q: Dimensioned + std::str::FromStr<Err = QuantityError>>(text: &str) -> f64 {
    text.parse::<Q>().unwrap_or_else(|e| panic!("{text}: {e}")).value()
}

fn message<Q: Dimensioned + std::str::FromStr<Err = QuantityError>>(text: &str) -> String {
    match text.parse::<Q>() {
        Ok(q) => panic!("{text} was read as {}", q.value()),
        Err(e) => e.to_string(),
    }
}

/// Trust: hand conversions with the exact definitions of inch and pound-force.
#[test]
fn units_convert_to_solver_units() {
    assert_relative_eq!(value::<Length>("0.035 in"), 0.889);
    assert_eq!(value::<Length>("60mm"), 60.0);
    assert_eq!(value::<Length>("-3 mm"), -3.0);
    assert_eq!(value::<Length>("−3 mm"), -3.0);
    assert_eq!(value::<Length>("2 m^2/m"), 2000.0);
    assert_eq!(value::<Force>("80 kN"), 80_000.0);
    assert_eq!(value::<Force>("1e3 N"), 1000.0);
    assert_eq!(value::<LineForce>("1300 N/mm"), 1300.0);
    assert_relative_eq!(value::<LineForce>("1300 kN/m"), 1300.0);
    assert_relative_eq!(value::<Stress>("5.4 tonf_uk/in^2"), 5.4 * 9_964.016_418 / 645.16, max_relative = 1e-9);
    assert_relative_eq!(value::<Stress>("1 tonf_uk/in²"), 15.4443, max_relative = 1e-5);
    assert_relative_eq!(value::<Stress>("30 ksi"), 206.843, max_relative = 1e-5);
    assert_relative_eq!(value::<Stress>("60 kp/cm^2"), 5.884, max_relative = 1e-4);
    assert_relative_eq!(value::<Stress>("1 N·mm^-2"), 1.0);
    assert_relative_eq!(value::<Angle>("180 deg"), std::f64::consts::PI);
    assert_relative_eq!(value::<Speed>("6 m/min"), 100.0);
    assert_eq!(value::<Time>("30 ms"), 0.03);
    assert_relative_eq!(value::<Ratio>("5 %"), 0.05);
    assert_relative_eq!(value::<Temperature>("20 °C"), 293.15);
    assert_relative_eq!(value::<Temperature>("-20°C"), 253.15);
    assert_relative_eq!(value::<Temperature>("493 K"), 493.0);
    // ρ c of aluminium: 2700 kg/m³ × 900 J/(kg K) = 2.43 MJ/(m³ K) = 2.43 MPa/K.
    assert_relative_eq!(
        value::<Density>("2700 kg/m^3") * value::<SpecificHeat>("900 J/kg/K"),
        2.43,
        max_relative = 1e-12
    );
    assert_relative_eq!(value::<Density>("2.7 g/cm^3"), 2.7e-9, max_relative = 1e-12);
    assert_relative_eq!(value::<Conductivity>("130 W/m/K"), 130.0, max_relative = 1e-12);
    assert_relative_eq!(value::<HeatTransfer>("1400 W/m^2/K"), 1.4, max_relative = 1e-12);
    assert_relative_eq!(value::<PerKelvin>("0.3 %/K"), 0.003, max_relative = 1e-12);
    assert_relative_eq!(value::<Energy>("8.314 J/mol"), 8314.0, max_relative = 1e-12);
}

#[test]
fn what_a_shop_word_leaves_open_is_asked_for() {
    let tons = "did you mean `tonf` (metric, 9.807 kN) or `tonf_us` (short, 8.896 kN) or `tonf_uk` (long, 9.964 kN)?";
    assert!(message::<Force>("100 tons").ends_with(tons), "{}", message::<Force>("100 tons"));
    for word in ["ga", "gauge", "gage"] {
        let message = message::<Positive<Length>>(&format!("20 {word}"));
        assert!(message.contains("0.912 mm of steel and 0.813 mm of aluminium"), "{message}");
        assert!(message.contains("\"20 ga_steel\"") && message.contains("\"20 ga_al\""), "{message}");
    }
    for gauge in ["2 ga_steel", "31 ga_al", "20.5 ga_steel", "-20 ga", "1e99 ga_al"] {
        assert!(message::<Length>(gauge).contains("whole numbers from 3 to 30"), "{gauge}");
    }
    assert!(message::<Length>("6 t").contains("thicknesses of the sheet"));
    assert!(message::<Force>("20 ga_steel").contains("is a length, wanted a force"));
}

#[test]
fn messages_name_the_value_and_the_remedy() {
    assert_eq!(
        message::<Length>("0.9"),
        "0.9 needs a unit\nwrite \"0.9 mm\"; a length may also be written \"0.9 mm\" or \"0.035 in\""
    );
    assert!(message::<Temperature>("230").contains("write \"230 °C\""));
    assert!(message::<Angle>("20").contains("write \"20 deg\""));
    assert!(message::<Ratio>("8").contains("write \"8 %\""));
    assert!(message::<Ratio>("0.08").contains("write \"8 %\""));
    assert!(message::<Density>("2700").contains("write \"2700 kg/m^3\""));
    assert_eq!(message::<Length>("0,9 mm"), "decimal comma in \"0,9 mm\"\nwrite a point: \"0.9 mm\"");
    assert_eq!(
        message::<Force>("5 MPa"),
        "\"5 MPa\" is a stress, wanted a force\nwrite for example \"80 kN\" or \"5000 N\""
    );
    assert_eq!(
        message::<Force>("250 t"),
        "\"250 t\" are thicknesses of the sheet, wanted a force\nt is thicknesses of the sheet here: write 250 tonf \
         (tonnes-force) or 2452 kN"
    );
    assert_eq!("60 inch".parse::<Length>().unwrap(), "60 in".parse().unwrap());
    assert_eq!("60 inches".parse::<Length>().unwrap(), "60 in".parse().unwrap());
    assert_eq!(message::<Stress>("210 Gpa"), "unknown unit `Gpa` in \"210 Gpa\"\ndid you mean `GPa`?");
    for (word, unit) in [("Inches", "in"), ("µm", "um"), ("millimeters", "mm"), ("meter", "m")] {
        let message = message::<Length>(&format!("0.04 {word}"));
        assert!(message.ends_with(&format!("did you mean `{unit}`?")), "{message}");
    }
    assert!(message::<Length>("3 furlong").contains("known units: mm, cm"));
    assert!(message::<Positive<Length>>("0 mm").starts_with("must be positive, found 0 mm"));
    assert!(message::<NonNegative<Force>>("-1 N").starts_with("must not be negative"));
    assert!(message::<Length>("1e9 m").contains("at most 100000 mm"));
    assert!(message::<Length>("1e999 mm").contains("out of range"));
    assert!(message::<Length>("nan mm").contains("no number"));
    assert!(message::<Length>("5 mm//s").contains("cannot be read from"));
    assert!(message::<Length>("5 mm^99999999999").contains("cannot be read from"));
}

proptest! {
    #[test]
    fn parser_never_panics(text in "\\PC*") {
        let _ = parse(&text);
    }

    #[test]
    fn parser_never_panics_near_the_grammar(text in "[-+−]?[0-9.,e]{0,6} ?([a-zA-Z%²^*/· ]|mm|kN|in){0,8}") {
        let _ = text.parse::<Positive<Stress>>();
    }

    /// Trust: Rust prints the shortest decimal that reads back as the same number.
    #[test]
    fn what_is_printed_reads_back_the_same(x in -1e5..1e5f64) {
        let length = Length::checked(x, "x").unwrap();
        prop_assert_eq!(length.to_string().parse::<Length>().unwrap(), length);
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
