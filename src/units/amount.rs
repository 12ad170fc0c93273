//! Numbers in text: each kind of number has one unit and one number of digits. A computed number has the digits whose last
//! one is sure within two units by the error bars of three in four shipped cases; `cargo bench --bench digits` measures them.

use super::{DisplaySettings, Unit, trimmed};
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
    /// Half width of its error bar, in `unit`; `None` where it is not known, or the number was given.
    pub bar: Option<f64>,
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
}

use Digits::{Decimals, Given, Significant};

macro_rules! kinds {
    ($($kind:ident = $factor:literal, $unit:ident, $digits:expr, $what:literal;)*) => {
        impl Amount {$(
            #[doc = concat!($what, ", with ", stringify!($digits), ".")]
            pub const fn $kind(value: f64) -> Self {
                Self::new($factor * value, Unit::$unit, $digits)
            }
        )*}
    };
}

kinds! {
    number = 1.0, None, Given(3), "Plain number that was given";
    count = 1.0, None, Decimals(0), "Number of items";
    share = 100.0, Percent, Significant(2), "Share \\[–\\], displayed in percent";
    given_share = 100.0, Percent, Given(3), "Share that was given \\[–\\], displayed in percent";
    place = 1.0, Mm, Decimals(1), "Place, height or travel \\[mm\\]";
    opening = 1.0, Mm, Decimals(0), "Opening of a slit ring \\[mm\\]";
    size = 1.0, Mm, Given(3), "Size that was given \\[mm\\]";
    drawn = 1.0, Mm, Given(2), "Radius, gap or opening of tools \\[mm\\]";
    set = 1.0, Mm, Given(1), "Blank or travel as a press shop sets it \\[mm\\]";
    thicknesses = 1.0, Thicknesses, Significant(2), "Length over the sheet's thickness \\[–\\]";
    given_thicknesses = 1.0, Thicknesses, Given(3), "Length over the sheet's thickness that was given \\[–\\]";
    stress = 1.0, MPa, Significant(3), "Stress or pressure \\[MPa\\]";
    given_stress = 1.0, MPa, Given(3), "Stress or pressure that was given \\[MPa\\]";
    norm = 1.0, None, Significant(2), "Residual or another small number of the solver \\[–\\]";
    angle = 1.0, Degree, Decimals(1), "Computed angle, with a tolerance's decimal \\[degrees\\]";
    temperature = 1.0, Celsius, Decimals(0), "Temperature \\[°C\\]";
    time = 1.0, Second, Significant(3), "Time \\[s\\]";
    ratio = 1.0, None, Decimals(2), "True strain, draw ratio or another quotient \\[–\\]";
}

impl Amount {
    /// Number with its unit and digits.
    pub const fn new(value: f64, unit: Unit, digits: Digits) -> Self {
        Self { value, unit, digits, bar: None }
    }

    /// Adds the error bar: `0.61 ± 0.01 mm`, with no digit beyond the bar; a small bar makes one digit more sure.
    pub const fn with_bar(self, bar: f64) -> Self {
        let digits = match self.digits {
            Significant(n) => Significant(n + 1),
            Decimals(0) => Decimals(1),
            digits => digits,
        };
        Self { bar: Some(bar), digits, ..self }
    }

    /// Another value of the same kind.
    pub const fn with_value(self, value: f64) -> Self {
        Self { value, ..self }
    }

    /// Changes the digits.
    pub const fn to(self, digits: Digits) -> Self {
        Self { digits, ..self }
    }

    /// Computed force or work in its unit, per mm of depth or not, see [`Extent`](crate::model::Extent).
    pub const fn force(force: f64, unit: Unit) -> Self {
        Self::new(force, unit, Significant(2))
    }

    /// Force or work that was given, in its unit.
    pub const fn given_force(force: f64, unit: Unit) -> Self {
        Self::new(force, unit, Given(3))
    }

    /// Computed thickness \[mm\], to a hundredth; of foils two digits.
    pub const fn thickness(thickness: f64) -> Self {
        Self::new(thickness, Unit::Mm, if thickness < 0.1 { Significant(2) } else { Decimals(2) })
    }

    /// Computed draw-in \[mm\], from 10 mm on to a millimetre.
    pub const fn draw_in(draw_in: f64) -> Self {
        Self::new(draw_in, Unit::Mm, if draw_in < 10.0 { Decimals(1) } else { Decimals(0) })
    }

    /// Number and unit apart, for tables.
    pub fn parts(self) -> (String, &'static str) {
        self.parts_in(DisplaySettings::current())
    }

    fn parts_in(self, settings: DisplaySettings) -> (String, &'static str) {
        // A small difference has the unit of its bar.
        let to = settings.unit(self.unit, self.value.abs().max(self.bar.unwrap_or(0.0)));
        let value = to.convert(self.value);
        if !value.is_finite() {
            return ("–".to_owned(), to.symbol);
        }
        let magnitude = |n: usize| magnitude(value, n);
        let decimals = match self.digits {
            // An inch wants two more for the same resolution.
            Decimals(n) => n as i32 + if to.symbol == "in" { 2 } else { 0 },
            Given(n) if to.symbol == "in" => (n as i32 + 2).min(if value.abs() < 0.1 { 4 } else { 3 }),
            Given(n) => n as i32,
            Significant(n) => (n as i32 - 1 - magnitude(n)).max(0),
        };
        let bar = self.bar.map(|bar| (bar * to.factor).abs()).filter(|bar| bar.is_finite());
        let text = match (self.digits, bar) {
            (_, Some(bar)) => return (with_bar(value, bar, decimals), to.symbol),
            (Given(_), _) => trimmed(value, decimals),
            (Significant(_), _) if value == 0.0 => "0".to_owned(),
            (Significant(n), _) if magnitude(n) < -4 && self.unit == Unit::Percent => "0".to_owned(),
            (Significant(n), _) if magnitude(n) < -4 => format!("{value:.*e}", n.max(1) - 1),
            (Significant(_) | Decimals(_), _) => format!("{value:.*}", decimals as usize),
        };
        (unsigned_zero(&text), to.symbol)
    }
}

impl fmt::Display for Amount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&text(self.parts()))
    }
}

impl From<Amount> for String {
    fn from(amount: Amount) -> Self {
        amount.to_string()
    }
}

fn text((number, unit): (String, &str)) -> String {
    number + if matches!(unit, "" | "°") { "" } else { " " } + unit
}

/// Number, with two places of the larger of both, and bar, rounded up to its first digit, two if that is 1: 75 ± 50, 250 ± 300.
fn with_bar(value: f64, bar: f64, most: i32) -> String {
    let first = if bar > 0.0 { -bar.log10().floor() as i32 } else { most };
    let decimals = most.min(first + i32::from(format!("{bar:e}").starts_with('1')));
    let write = |scaled: f64, n: i32| unsigned_zero(&format!("{:.*}", n.max(0) as usize, scaled * 10f64.powi(-n)));
    let own = decimals.max(most.min(1 - magnitude(value.abs().max(bar), 2)));
    let bar = (bar * 10f64.powi(decimals) - 0.05).ceil().max(1.0);
    format!("{} ± {}", write((value * 10f64.powi(own)).round(), own), write(bar, decimals))
}

/// The power of ten of a number once it is rounded to so many digits: 9.996 is 10.0.
fn magnitude(value: f64, digits: usize) -> i32 {
    format!("{value:.*e}", digits.max(1) - 1).split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

fn unsigned_zero(number: &str) -> String {
    if number.bytes().all(|b| matches!(b, b'-' | b'0' | b'.')) { number.replace('-', "") } else { number.to_owned() }
}
