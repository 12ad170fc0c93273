//! The measured forming limit of a sheet of the library, and the table that is made of it.

use crate::common::page::{plain, told};
use stampflow::assess::{self, Light};
use stampflow::author::templates;
use stampflow::case::{self, library};
use stampflow::forming_limit::{MarciniakKuczynski, Sheet};
use stampflow::material::{Hill48, Hosford, Material, YieldCriterion};

const DATA: &str = include_str!("../../reference_data/surfalex_aa6016_flc_points.csv");
const SHEET: &str = "aa6016a-surfalex";
/// Exponent of fcc metal \[–\].
const FCC: f64 = 8.0;
/// When the sheet counts as necked: key in the data, and words. The first is that of the groove itself.
const CRITERIA: [(&str, &str); 3] = [
    ("necking_strain_rate_ratio_10", "strain rate 10 times as fast"),
    ("necking_second_derivative_10pc", "second derivative"),
    ("last_stage_before_crack", "last stage before the crack"),
];
/// The widths that the imperfection is fitted at, in the order of the data.
const MIDDLE: [usize; 2] = [2, 3];
/// Grooves that are tried \[–\], and halvings of the interval between their logarithms of 1 − f₀.
const GROOVES: [f64; 2] = [0.93, 0.9995];
const HALVINGS: usize = 12;

/// Mean and standard deviation of minor and major strain \[–\].
#[derive(Clone, Copy)]
struct Mean {
    minor: [f64; 2],
    major: [f64; 2],
}

/// A width of specimen: its name, and its points by each criterion.
struct Width {
    name: String,
    points: [Vec<[f64; 2]>; 3],
}

impl Width {
    fn mean(&self, criterion: usize) -> Mean {
        let points = &self.points[criterion];
        let of = |i: usize| {
            let mean = points.iter().map(|p| p[i]).sum::<f64>() / points.len() as f64;
            let square = points.iter().map(|p| (p[i] - mean).powi(2)).sum::<f64>() / (points.len() - 1) as f64;
            [mean, square.sqrt()]
        };
        Mean { minor: of(0), major: of(1) }
    }

    /// Strain ratio at the neck by the groove's own criterion \[–\].
    fn beta(&self) -> f64 {
        let Mean { minor, major } = self.mean(0);
        minor[0] / major[0]
    }
}

/// The widths, from the narrowest to the full circle.
fn measured() -> Vec<Width> {
    let mut widths: Vec<Width> = Vec::new();
    for line in DATA.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [specimen, _, criterion, minor, major] = fields[..] else { panic!("a row of five: {line}") };
        let name =
            specimen.split('_').next().unwrap_or(specimen).replace("mm", " mm").replace("fullcircle", "full circle");
        if widths.last().is_none_or(|last| last.name != name) && widths.iter().all(|width| width.name != name) {
            widths.push(Width { name: name.clone(), points: Default::default() });
        }
        let width = widths.iter_mut().find(|width| width.name == name).expect("just made");
        let criterion = CRITERIA.iter().position(|(key, _)| *key == criterion).expect("a known criterion");
        width.points[criterion].push([minor, major].map(|text| text.parse().expect("a number")));
    }
    widths
}

/// The sheet of the library with a yield condition, and the groove that fits its two middle widths.
struct Fitted {
    name: String,
    material: Material,
    imperfection: f64,
}

impl Fitted {
    fn new(condition: &str, criterion: impl Fn(f64) -> YieldCriterion, widths: &[Width]) -> Self {
        let mut material = library::material(SHEET).expect("a sheet of the library").material;
        material.yield_criterion = criterion(material.yield_criterion.ratio());
        let mut fitted = Self { name: condition.to_owned(), material, imperfection: GROOVES[0] };
        let [mut low, mut high] = GROOVES.map(|groove| (1.0 - groove).ln());
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            fitted.imperfection = 1.0 - middle.exp();
            // A shallower groove necks later: the misses cancel where it is right.
            let miss: f64 = MIDDLE.iter().map(|&i| fitted.miss(&widths[i]).unwrap_or(f64::INFINITY)).sum();
            if miss < 0.0 { low = middle } else { high = middle }
        }
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
        Some(self.limit(width.beta())?[1] - width.mean(0).major[0])
    }
}

/// Both conditions, fitted.
fn fitted(widths: &[Width]) -> [Fitted; 2] {
    [
        Fitted::new("Hill 1948", |r| Hill48::new(r).into(), widths),
        Fitted::new("Hosford, a = 8", |r| Hosford::new(r, FCC).into(), widths),
    ]
}

/// Measured means with their standard deviations, and what is computed on the same strain ratio, in Markdown.
fn table(widths: &[Width], fitted: &[Fitted]) -> Vec<String> {
    let signed = |value: f64| format!("{value:+.3}").replace('-', "−");
    let with_scatter = |[mean, scatter]: [f64; 2]| format!("{mean:.3} ± {scatter:.3}");
    let heads = fitted.iter().map(|one| format!("{}, f₀ = {:.4} | miss", one.name, one.imperfection));
    let criteria = CRITERIA.map(|(_, words)| words).join(" | ");
    let heads = heads.collect::<Vec<_>>().join(" | ");
    let mut lines = vec![
        format!("| specimen | minor strain | major: {criteria} | {heads} |"),
        "|---|---|---|---|---|---|---|---|---|".to_owned(),
    ];
    for (i, width) in widths.iter().enumerate() {
        let minor = width.mean(0).minor[0];
        let majors = [0, 1, 2].map(|criterion| with_scatter(width.mean(criterion).major)).join(" | ");
        let computed = fitted.iter().map(|one| match (one.limit(width.beta()), one.miss(width)) {
            (Some([_, major]), Some(miss)) => format!("{major:.3} | {}", signed(miss)),
            _ => "no neck | –".to_owned(),
        });
        let role = if MIDDLE.contains(&i) { " (fitted)" } else { "" };
        let computed = computed.collect::<Vec<_>>().join(" | ");
        lines.push(format!("| {}{role} | {} | {majors} | {computed} |", width.name, signed(minor)));
    }
    lines
}

const DOCUMENT: &str = include_str!("../../docs/surfalex_limit.md");

/// Trust: the points of the library are the means of what was measured, to the digits that they are written with.
#[test]
fn the_points_of_the_library_are_the_means_of_the_data() {
    let sheet = library::material("aa6016a-surfalex").expect("a sheet");
    let curve = sheet.measured_limit.expect("a measured limit");
    let widths = measured();
    assert_eq!((widths.len(), curve.points().len()), (6, 6));
    for (point, width) in curve.points().iter().zip(&widths) {
        let mean = width.mean(0);
        assert!((point[0] - mean.minor[0]).abs() < 6e-5 && (point[1] - mean.major[0]).abs() < 6e-5, "{}", width.name);
    }
}

/// Trust: the document has what the program prints, and the program's words of what came out hold: the misses of the fitted
/// widths cancel to the precision of the fit, and both conditions agree up to plane strain within the scatter of the means.
#[test]
fn the_document_has_the_table_that_the_program_makes() {
    let widths = measured();
    let fitted = fitted(&widths);
    let lines = table(&widths, &fitted);
    for line in &lines {
        assert!(DOCUMENT.contains(line.as_str()), "not in the document:\n{}", lines.join("\n"));
    }
    for one in &fitted {
        let [a, b] = [2, 3].map(|i| one.miss(&widths[i]).expect("a limit"));
        // The limit itself settles to 0.2 %.
        assert!((a + b).abs() < 4e-3, "{a} {b}");
    }
    let [hill, hosford] = [0, 1].map(|i| fitted[i].miss(&widths[5]).expect("a limit"));
    let most =
        (0..widths.len()).filter_map(|i| fitted[1].miss(&widths[i])).fold(0.0_f64, |most, miss| most.max(miss.abs()));
    assert!(hosford.abs() < 0.5 * hill, "{hill} {hosford}");
    told(
        "docs/agreement.md",
        "fitted at two of six widths: within {} by Hosford's condition, {} too high at the full circle by Hill's",
        &plain(&[most, hill], 3),
    );
}

/// Trust: a hemispherical cup is held against what was measured, and nothing of it is computed.
#[test]
fn a_cup_of_the_sheet_is_held_against_its_measured_limit() {
    let given = [("material", "aa6016a-surfalex"), ("thickness", "1.5 mm")];
    let text = templates::find("hemispherical-cup").and_then(|template| template.fill(&given)).expect("a case");
    assert!(text.contains("Forming limit: measured on the library's sheet"), "{text}");
    let case = case::parse(&text, "made.toml", &[]).expect("valid");
    let curve = case.model().forming_limit.clone().expect("a limit");
    assert_eq!(
        Some(&curve),
        library::material("aa6016a-surfalex").expect("a sheet").measured_limit.as_ref().map(|_| &curve)
    );
    assert!(curve.name == "Points" && (curve.major_at(0.0915) - 0.2616).abs() < 1e-12);
    assert!(case.derived.iter().any(|note| note.to_string().contains("measured points of aa6016a-surfalex")));
    let solution = case.solve(&mut ());
    let found = assess::after(&solution.case, &solution.stages);
    let limit = found.iter().find(|finding| finding.key == "forming_limit").expect("a row");
    assert!(limit.light != Light::Grey && limit.limit.to_string().starts_with("Points"), "{limit:?}");
    // Of a sheet without measured points, and of none, the case says what is missing.
    for (from, to) in [
        ("aa6016a-surfalex", "drawing-steel"),
        ("name = \"aa6016a-surfalex\"", "hardening.swift = { k = \"500 MPa\", n = 0.2, offset = 0.01 }"),
    ] {
        let measured = ["forming_limit.measured=true".to_owned()];
        let error = case::parse(&text.replace(from, to), "made.toml", &measured).expect_err("no points");
        assert!(error.to_string().contains("names none that has some"), "{error}");
    }
}
