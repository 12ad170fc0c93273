//! The measured forming limit of a sheet of the library, and grooves that are fitted to it.

use crate::common::prelude::*;

const DATA: &str = include_str!("../../reference_data/surfalex_aa6016_flc_points.csv");
const SHEET: &str = "aa6016a-surfalex";
/// Exponent of fcc metal \[–\].
const FCC: f64 = 8.0;
const CRITERION: &str = "necking_strain_rate_ratio_10";
const MIDDLE: [usize; 2] = [2, 3];
/// Grooves that are tried \[–\], and halvings of the interval between their logarithms of 1 − f₀.
const GROOVES: [f64; 2] = [0.93, 0.9995];
const HALVINGS: usize = 12;

struct Width {
    name: String,
    points: Vec<[f64; 2]>,
}

impl Width {
    /// Minor and major strain \[–\].
    fn mean(&self) -> [f64; 2] {
        [0, 1].map(|i| self.points.iter().map(|p| p[i]).sum::<f64>() / self.points.len() as f64)
    }

    /// Strain ratio at the neck \[–\].
    fn beta(&self) -> f64 {
        let [minor, major] = self.mean();
        minor / major
    }
}

fn measured() -> Vec<Width> {
    let mut widths: Vec<Width> = Vec::new();
    for line in DATA.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [specimen, _, criterion, minor, major] = fields[..] else { panic!("a row of five: {line}") };
        let name = specimen.split('_').next().unwrap_or(specimen);
        if widths.iter().all(|width| width.name != name) {
            widths.push(Width { name: name.to_owned(), points: Vec::new() });
        }
        let width = widths.iter_mut().find(|width| width.name == name).expect("just made");
        let point = [minor, major].map(|text| text.parse().expect("a number"));
        width.points.extend((criterion == CRITERION).then_some(point));
    }
    widths
}

/// The sheet of the library with a yield condition, and the groove that fits its two middle widths.
struct Fitted {
    material: Material,
    imperfection: f64,
}

impl Fitted {
    fn new(criterion: impl Fn(f64) -> YieldCriterion, widths: &[Width]) -> Self {
        let mut material = library::material(SHEET).expect("a sheet of the library").material;
        material.yield_criterion = criterion(material.yield_criterion.ratio());
        let mut fitted = Self { material, imperfection: GROOVES[0] };
        let [low, high] = GROOVES.map(|groove| (1.0 - groove).ln());
        bisect(low, high, HALVINGS, |middle| {
            fitted.imperfection = 1.0 - middle.exp();
            // A shallower groove necks later: the misses cancel where it is right.
            MIDDLE.iter().map(|&i| fitted.miss(&widths[i]).unwrap_or(f64::INFINITY)).sum::<f64>() < 0.0
        });
        fitted
    }

    /// Minor and major strain of the limit on a straight path; `None` where no groove necks \[–\].
    fn limit(&self, beta: f64) -> Option<[f64; 2]> {
        let sheet = Sheet { material: &self.material, thickness: 1.5, temperature: 293.15 };
        let groove = MarciniakKuczynski { imperfection: self.imperfection, strain_rate: 1.0 };
        groove.limit(&sheet, beta).ok().map(|limit| [limit.minor, limit.major])
    }

    /// Major strain by which the limit is above the measured one \[–\].
    fn miss(&self, width: &Width) -> Option<f64> {
        Some(self.limit(width.beta())?[1] - width.mean()[1])
    }
}

fn fitted(widths: &[Width]) -> [Fitted; 2] {
    [Fitted::new(|r| Hill48::new(r).into(), widths), Fitted::new(|r| Hosford::new(r, FCC).into(), widths)]
}

/// Trust: the points of the library are the means of what was measured, to the digits that they are written with.
#[test]
fn the_points_of_the_library_are_the_means_of_the_data() {
    let sheet = library::material("aa6016a-surfalex").expect("a sheet");
    let curve = sheet.measured_limit.expect("a measured limit");
    let widths = measured();
    assert_eq!((widths.len(), curve.points.len()), (6, 6));
    for (point, width) in curve.points.iter().zip(&widths) {
        let mean = width.mean();
        assert!((0..2).all(|i| (point[i] - mean[i]).abs() < 6e-5), "{}", width.name);
    }
}

/// Trust: the misses of the fitted widths cancel to the precision of the fit; the corner of Hosford's condition brings the
/// limit of the full circle down to what was measured.
#[test]
fn a_groove_fitted_at_two_widths_gives_the_others_by_hosfords_condition() {
    let widths = measured();
    let fitted = fitted(&widths);
    for one in &fitted {
        let [a, b] = [2, 3].map(|i| one.miss(&widths[i]).expect("a limit"));
        // The limit itself settles to 0.2 %.
        assert!((a + b).abs() < 4e-3, "{a} {b}");
    }
    let [hill, hosford] = [0, 1].map(|i| fitted[i].miss(&widths[5]).expect("a limit"));
    let most =
        (0..widths.len()).filter_map(|i| fitted[1].miss(&widths[i])).fold(0.0_f64, |most, miss| most.max(miss.abs()));
    assert!(hosford.abs() < 0.5 * hill, "{hill} {hosford}");
    agrees(
        "fitted at two of six widths: within {} by Hosford's condition, {} too high at the full circle by Hill's",
        &plain(&[most, hill], 3),
    );
}

/// Trust: a hemispherical cup is held against what was measured, and nothing of it is computed.
#[test]
fn a_cup_of_the_sheet_is_held_against_its_measured_limit() {
    let case = made("hemispherical-cup", &[("material", "aa6016a-surfalex"), ("thickness", "1.5 mm")], &[]);
    let text = case.text.clone();
    assert!(text.contains("Forming limit: measured on the library's sheet"), "{text}");
    let curve = case.model().forming_limit.clone().expect("a limit");
    assert!(curve.name == "Points" && (curve.major_at(0.0915) - 0.2616).abs() < 1e-12);
    let found = findings(&case.solve(&mut ()));
    let limit = row(&found, "forming_limit");
    assert!(limit.light != Light::Grey && limit.limit.to_string().contains("of Points"), "{limit:?}");
    for other in ["hill", "none"] {
        let two = owned(&["forming_limit.measured=true", &format!("forming_limit.{other}=true")]);
        assert!(case::parse(&text, "made.toml", &two).is_err(), "the measured points, and {other}");
    }
    // Of a sheet without measured points, and of none, the case says what is missing.
    for (from, to) in [
        ("aa6016a-surfalex", "drawing-steel"),
        ("name = \"aa6016a-surfalex\"", "hardening.swift = { k = \"500 MPa\", n = 0.2, offset = 0.01 }"),
    ] {
        let measured = owned(&["forming_limit.measured=true"]);
        let error = case::parse(&text.replace(from, to), "made.toml", &measured).expect_err("no points");
        assert!(error.to_string().contains("names none that has some"), "{error}");
    }
}
