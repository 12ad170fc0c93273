//! Numbers in text: each kind of number has one unit and one number of digits.
//!
//! ```
//! use stampflow::units::Amount;
//! let (thinning, place) = (Amount::share(0.387), Amount::place(23.52));
//! assert_eq!(format!("{thinning} thinner at {place}"), "39 % thinner at 23.5 mm");
//! ```

use super::{DisplaySettings, Unit};
use std::fmt;

/// Number with its unit and its number of digits. Displays in the units of [`DisplaySettings`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// In `unit`.
    pub value: f64,
    /// The solver's unit, or percent.
    pub unit: Unit,
    /// Number of digits.
    pub digits: Digits,
    /// Symbol in place of a unit: `t` for thicknesses.
    times: &'static str,
    /// Half width of its error bar, in `unit`; `None` where it is not known, or the number was given.
    bar: Option<f64>,
    /// Whether the bar is displayed.
    tells_bar: bool,
}

/// Number of digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// Decimals.
    Decimals(usize),
    /// Significant digits, and all digits of larger whole parts; the smallest numbers with a power of ten.
    Significant(usize),
    /// Most decimals, without zeros at the end: of numbers that were given.
    Given(usize),
    /// Most decimals of a length \[mm\] on a drawing; of inches three.
    Drawn(usize),
    /// Significant digits, rounded up in the displayed unit.
    Upward(usize),
    /// All digits in the solver's unit; significant digits in others.
    Converted(usize),
}

use Digits::{Converted, Decimals, Drawn, Given, Significant, Upward};

/// Decimals of a length on a drawing in inches.
const OF_INCHES: usize = 3;

/// Decimals of a number as it was given.
const FINEST: i32 = 6;

/// Power of ten below which numbers are displayed with it.
const SMALLEST: i32 = -4;

macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident = $factor:literal, $unit:ident, $digits:expr;)*) => {
        impl Amount {$(
            $(#[$doc])*
            pub const fn $kind(value: f64) -> Self {
                Self::new($factor * value, Unit::$unit, $digits)
            }
        )*}
    };
}

kinds! {
    /// Plain number that was given.
    number = 1.0, None, Given(3);
    /// Share \[–\], displayed in percent.
    share = 100.0, Percent, Significant(2);
    /// Share that was given \[–\], displayed in percent.
    given_share = 100.0, Percent, Given(3);
    /// Place, height or travel \[mm\], to a tenth.
    place = 1.0, Mm, Decimals(1);
    /// Size that was given \[mm\], to a micrometre.
    size = 1.0, Mm, Given(3);
    /// Radius, gap or opening of tools \[mm\], to a hundredth.
    drawn = 1.0, Mm, Drawn(2);
    /// Blank or travel as a press shop sets it \[mm\], to a tenth.
    set = 1.0, Mm, Drawn(1);
    /// Stress or pressure \[MPa\].
    stress = 1.0, MPa, Significant(3);
    /// Stress or pressure that was given \[MPa\].
    given_stress = 1.0, MPa, Given(3);
    /// Residual or another small number of the solver \[–\].
    norm = 1.0, None, Significant(2);
    /// Angle \[degrees\], to a tenth.
    angle = 1.0, Degree, Decimals(1);
    /// Temperature \[°C\], to a degree.
    temperature = 1.0, Celsius, Decimals(0);
    /// Time \[s\].
    time = 1.0, Second, Significant(3);
    /// True strain \[–\], to a hundredth.
    strain = 1.0, None, Decimals(2);
    /// Quotient \[–\], to a hundredth: draw ratios, coefficients.
    ratio = 1.0, None, Decimals(2);
}

impl Amount {
    /// Number with its unit and digits.
    pub const fn new(value: f64, unit: Unit, digits: Digits) -> Self {
        Self { value, unit, digits, times: "", bar: None, tells_bar: false }
    }

    /// Adds the error bar: `0.61 ± 0.01 mm`, with no digit beyond the bar.
    pub const fn with_bar(self, bar: f64) -> Self {
        Self { bar: Some(bar), tells_bar: true, ..self }
    }

    /// Limits the digits to those of an error bar that is displayed elsewhere.
    pub const fn within_bar(self, bar: f64) -> Self {
        Self { bar: Some(bar), tells_bar: false, ..self }
    }

    /// Half width of its error bar, in `unit`.
    pub const fn bar(self) -> Option<f64> {
        self.bar
    }

    /// Another value of the same kind.
    pub const fn of(self, value: f64) -> Self {
        Self { value, ..self }
    }

    /// Changes the digits.
    pub const fn to(self, digits: Digits) -> Self {
        Self { digits, ..self }
    }

    /// Force \[`N`, or `N/mm` of depth\] in its unit, see [`Extent`](crate::model::Extent).
    pub const fn force(force: f64, unit: Unit) -> Self {
        Self::new(force, unit, Significant(3))
    }

    /// Work or heat \[J, or J/mm of depth\] in its unit.
    pub const fn energy(energy: f64, unit: Unit) -> Self {
        Self::new(energy, unit, Significant(3))
    }

    /// Number of items.
    pub const fn count(count: usize) -> Self {
        Self::new(count as f64, Unit::None, Decimals(0))
    }

    /// Computed thickness \[mm\], to a hundredth; of foils two digits.
    pub const fn thickness(thickness: f64) -> Self {
        Self::new(thickness, Unit::Mm, if thickness < 0.1 { Significant(2) } else { Decimals(2) })
    }

    /// Length over the sheet's thickness \[–\].
    pub const fn thicknesses(ratio: f64) -> Self {
        Self { times: "t", ..Self::new(ratio, Unit::None, Significant(2)) }
    }

    /// Length over the sheet's thickness that was given \[–\].
    pub const fn given_thicknesses(ratio: f64) -> Self {
        Self::thicknesses(ratio).to(Given(3))
    }

    /// Number and unit apart, for tables.
    pub fn parts(self) -> (String, &'static str) {
        self.parts_in(DisplaySettings::current())
    }

    fn parts_in(self, settings: DisplaySettings) -> (String, &'static str) {
        let to = settings.unit(self.unit, self.value);
        let unit = if self.times.is_empty() { to.symbol } else { self.times };
        let value = to.convert(self.value);
        if !value.is_finite() {
            return ("–".to_owned(), unit);
        }
        if let Some(bar) = self.bar.map(|bar| (bar * to.factor).abs()).filter(|bar| bar.is_finite()) {
            let [value, bar] = within_bar(value, bar, self.decimals(value, to.extra_decimals));
            return (if self.tells_bar { format!("{value} ± {bar}") } else { value }, unit);
        }
        let written = match self.digits {
            Decimals(n) => format!("{value:.*}", n + to.extra_decimals),
            Given(n) => super::trimmed(value, (n + to.extra_decimals) as i32),
            Drawn(n) => super::trimmed(value, if to.extra_decimals > 0 { OF_INCHES } else { n } as i32),
            Converted(_) if to.factor == 1.0 => super::trimmed(value, FINEST),
            Converted(n) => super::trimmed(value, n as i32 - 1 - magnitude(value, n)),
            Upward(n) => upward(value, n),
            Significant(_) if value == 0.0 => "0".to_owned(),
            Significant(n) => match magnitude(value, n) {
                magnitude if magnitude < SMALLEST && self.unit == Unit::Percent => "0".to_owned(),
                magnitude if magnitude < SMALLEST => format!("{value:.*e}", n.max(1) - 1),
                magnitude => format!("{value:.*}", (n as i32 - 1 - magnitude).max(0) as usize),
            },
        };
        (unsigned_zero(&written), unit)
    }

    /// Decimals of a number without a bar.
    fn decimals(self, value: f64, extra_decimals: usize) -> i32 {
        match self.digits {
            Decimals(n) | Given(n) | Drawn(n) => (n + extra_decimals) as i32,
            Significant(n) | Converted(n) | Upward(n) => (n as i32 - 1 - magnitude(value, n)).max(0),
        }
    }
}

impl fmt::Display for Amount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&text(self.parts()))
    }
}

fn text(parts: (String, &str)) -> String {
    match parts {
        (number, "") => number,
        (number, "°") => number + "°",
        (number, unit) => format!("{number} {unit}"),
    }
}

impl From<Amount> for String {
    fn from(amount: Amount) -> Self {
        amount.to_string()
    }
}

/// Number and bar with as many decimals: one digit of the bar, or two if the first is 1, rounded up but for a twentieth of
/// the last digit.
fn within_bar(value: f64, bar: f64, most: i32) -> [String; 2] {
    let first = if bar > 0.0 { -bar.log10().floor() as i32 } else { most };
    let is_one = format!("{bar:e}").starts_with('1');
    let decimals = most.min(first + i32::from(is_one));
    let place = 10f64.powi(-decimals);
    let write = |places: f64| unsigned_zero(&format!("{:.*}", decimals.max(0) as usize, places * place));
    [write((value / place).round()), write((bar / place - 0.05).ceil().max(1.0))]
}

/// A number rounded up to so many digits: 105.4 to two is 110.
fn upward(value: f64, digits: usize) -> String {
    let decimals = digits as i32 - 1 - value.abs().log10().floor() as i32;
    let place = 10f64.powi(-decimals);
    // What is a whole number of places but for round-off stays.
    let places = (value / place - 1e-9).ceil();
    super::trimmed(places * place, decimals.max(0))
}

/// The power of ten of a number once it is rounded to so many digits: 9.996 is 10.0.
fn magnitude(value: f64, digits: usize) -> i32 {
    let rounded = format!("{value:.*e}", digits.max(1) - 1);
    rounded.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

/// Without a minus before 0.
fn unsigned_zero(number: &str) -> String {
    let is_zero = number.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    if is_zero { number.trim_start_matches('-').to_owned() } else { number.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Text in SI and in US units.
    fn both(amount: Amount) -> [String; 2] {
        [DisplaySettings::Si, DisplaySettings::Us].map(|settings| text(amount.parts_in(settings)))
    }

    /// Trust: by hand.
    #[test]
    fn each_kind_of_number_has_its_digits_and_its_unit() {
        for (amount, expected) in [
            (Amount::share(0.058), ["5.8 %", "5.8 %"]),
            (Amount::place(23.53), ["23.5 mm", "0.926 in"]),
            (Amount::thickness(0.612), ["0.61 mm", "0.0241 in"]),
            (Amount::size(30.0), ["30 mm", "1.1811 in"]),
            (Amount::drawn(30.126), ["30.13 mm", "1.186 in"]),
            (Amount::set(200.48), ["200.5 mm", "7.893 in"]),
            (Amount::new(68_950.0, Unit::MPa, Converted(3)), ["68950 MPa", "10000 ksi"]),
            (Amount::force(36_180.0, Unit::N), ["36.2 kN", "4.07 US tonf"]),
            (Amount::angle(-0.04), ["0.0°", "0.0°"]),
            (Amount::thicknesses(0.193), ["0.19 t", "0.19 t"]),
            (Amount::force(9_999.0, Unit::N), ["10.0 kN", "1.12 US tonf"]),
            (Amount::share(1.23e-8), ["0 %", "0 %"]),
            (Amount::new(1.23e-6, Unit::None, Significant(2)), ["1.2e-6", "1.2e-6"]),
            (Amount::force(105_400.0, Unit::N).to(Upward(2)), ["110 kN", "12 US tonf"]),
            (Amount::stress(f64::NAN), ["– MPa", "– psi"]),
            (Amount::force(17.512_683_5, Unit::NPerMm), ["17.5 N/mm", "100 lbf/in"]),
            (Amount::energy(135.581_795, Unit::Joule), ["136 J", "100 ft lbf"]),
            (Amount::temperature(100.0), ["100 °C", "212 °F"]),
        ] {
            assert_eq!(both(amount), expected);
        }
    }

    /// Trust: by hand.
    #[test]
    fn a_number_has_no_digit_beyond_its_bar() {
        for (amount, expected) in [
            (Amount::thickness(0.612).with_bar(0.0102), ["0.61 ± 0.01 mm", "0.0241 ± 0.0004 in"]),
            (Amount::thickness(0.612).with_bar(0.0004), ["0.61 ± 0.01 mm", "0.0241 ± 0.0001 in"]),
            (Amount::force(36_180.0, Unit::N).with_bar(2_400.0), ["36 ± 3 kN", "4.1 ± 0.3 US tonf"]),
            (Amount::angle(-0.01).with_bar(0.0), ["0.0 ± 0.1°", "0.0 ± 0.1°"]),
            (Amount::place(23.53).with_bar(f64::NAN), ["23.5 mm", "0.926 in"]),
        ] {
            assert_eq!(both(amount), expected);
        }
    }
}
