use super::{table::Extrapolation, table::Monotone, table::Points, table::curve, *};

/// Measured points at several temperatures, interpolated straight over the temperature.
///
/// Valid between the coldest and the hottest curve; beyond them these are held.
/// Source: each curve as `table`.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Isotherms {
    /// At rising temperatures.
    curves: Vec<Isotherm>,
    /// Extrapolation beyond the last points: a choice that has to be made.
    extrapolation: Extrapolation,
}

/// One curve.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
struct Isotherm {
    #[serde(with = "As::<Positive<Temperature>>")]
    temperature: f64,
    /// Pairs of strain and stress, the first at strain 0: `[[0, "90 MPa"], [0.1, "170 MPa"]]`.
    points: Points,
    /// Takes the place of the points that were read.
    #[serde(skip)]
    curve: Monotone,
}

impl Isotherms {
    pub(super) fn temperatures(&self) -> [f64; 2] {
        [self.curves[0].temperature, self.curves[self.curves.len() - 1].temperature]
    }

    pub(super) fn valid_up_to(&self) -> f64 {
        self.curves.iter().map(|isotherm| isotherm.curve.last_strain()).fold(f64::INFINITY, f64::min)
    }
}

impl Example for Isotherms {
    fn example() -> Self {
        let curve = |temperature, factor| Isotherm { temperature, points: vec![], curve: Monotone::example(factor) };
        Self { curves: vec![curve(293.15, 1.0), curve(503.15, 0.6)], extrapolation: Extrapolation::Slope }
    }
}

impl HardeningLaw for Isotherms {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        for (i, isotherm) in self.curves.iter_mut().enumerate() {
            isotherm.curve = curve(&isotherm.points, self.extrapolation).map_err(|error| {
                let key = if error.key.is_empty() { "points" } else { &error.key };
                let (key, message) = (format!("curves.{i}.{key}"), format!("curve {}: {}", i + 1, error.message));
                LawError { key, message, ..error }
            })?;
        }
        let n = self.curves.len();
        require("", n >= 2, || format!("needs curves at two temperatures or more, found {n}"))?;
        self.curves.windows(2).enumerate().try_for_each(|(i, pair)| {
            require(&format!("curves.{}.temperature", i + 1), pair[1].temperature > pair[0].temperature, || {
                format!("curve {}: its temperature does not rise above that of the one before", i + 2)
            })
        })
    }

    fn formula(&self) -> String {
        let [cold, hot] = self.temperatures().map(|t| rounded(t - ZERO_CELSIUS));
        let (n, coldest) = (self.curves.len(), &self.curves[0].curve);
        format!("{n} hardening curves from {cold} to {hot} °C, the coldest a {coldest}")
    }

    fn at_temperature(&self, strain: f64, temperature: f64) -> FlowStress {
        let after = self.curves.partition_point(|isotherm| isotherm.temperature < temperature);
        if after == 0 || after == self.curves.len() {
            return self.curves[after.min(self.curves.len() - 1)].curve.at(strain);
        }
        let [before, after] = [&self.curves[after - 1], &self.curves[after]];
        let x = (temperature - before.temperature) / (after.temperature - before.temperature);
        before.curve.at(strain).towards(after.curve.at(strain), x)
    }
}

/// Trust: by hand, the mean of the two curves half-way between them, the outer ones beyond.
#[cfg(test)]
#[test]
fn isotherms_are_interpolated_and_held() {
    let stress = |t: f64| Isotherms::example().at_temperature(0.07, t).stress;
    let [cold, hot] = [1.0, 0.6].map(|factor| Monotone::example(factor).at(0.07).stress);
    approx::assert_relative_eq!(stress(398.15), 0.5 * (cold + hot), max_relative = 1e-14);
    assert_eq!([stress(200.0), stress(600.0)], [cold, hot]);
}
