//! Random tubes, holes, bosses, bends pressed home or stretched, pads, reverse redraws and ironed cups: templates with random sizes, made from a seed.

use super::random_die::between;
use fastrand::Rng;
use stampflow::{author::templates::find, case, model::Stage};

/// Template and the ranges of its sizes \[mm\].
type Kind = (&'static str, &'static [(&'static str, f64, f64)]);

pub const KINDS: [Kind; 12] = [
    ("tube-end", &[("tube", 8.0, 60.0), ("length", 60.0, 200.0), ("end", 8.0, 80.0), ("land", 2.0, 20.0)]),
    ("tube-inversion", &[("tube", 10.0, 80.0), ("length", 60.0, 200.0), ("travel", 10.0, 60.0)]),
    ("tube-bulge", &[("tube", 20.0, 60.0), ("bulge", 25.0, 80.0), ("width", 30.0, 120.0), ("feed", 2.0, 15.0)]),
    ("collar", &[("radius", 6.0, 40.0), ("height", 4.0, 20.0)]),
    ("hole-expansion", &[("hole", 3.0, 9.0), ("travel", 4.0, 20.0)]),
    ("u-bend", &[("half-width", 10.0, 60.0)]),
    ("hydroform", &[("opening", 20.0, 80.0), ("depth", 5.0, 30.0), ("corner", 3.0, 15.0), ("shoulder", 3.0, 12.0)]),
    ("emboss", &[("boss", 8.0, 60.0), ("depth", 0.5, 8.0), ("radius", 2.0, 15.0)]),
    ("stretch-bend", &[("radius", 10.0, 200.0)]),
    ("v-bend", &[("nose", 3.0, 20.0)]),
    ("hat-section", &[("height", 20.0, 60.0), ("nose", 8.0, 15.0), ("shoulder", 8.0, 15.0), ("restrike", 4.0, 12.0)]),
    ("redraw", &[("punch-radius", 20.0, 40.0), ("height", 30.0, 70.0)]),
];
const ELASTIC: [&str; 3] =
    ["material.mode=\"elasto_viscoplastic\"", "material.young=\"206 GPa\"", "material.poisson=0.3"];

/// Stages that belong to `seed`, their template and its options. Sizes that do not fit each other are drawn again.
pub fn random_template(seed: u64, elastic: bool) -> (String, Vec<Stage>, String) {
    let rng = &mut Rng::with_seed(seed ^ 0x7e3);
    loop {
        let (kind, sizes) = KINDS[rng.usize(0..KINDS.len())];
        let mut given = vec![("friction", format!("{:.3}", between(rng, 0.0, 0.15)))];
        given.push(("k", format!("{:.0} MPa", between(rng, 150.0, 1000.0))));
        given.push(("n", format!("{:.3}", between(rng, 0.05, 0.4))));
        for (key, low, high) in [("thickness", 0.5, 3.0)].iter().chain(sizes) {
            given.push((key, format!("{:.2} mm", between(rng, *low, *high))));
        }
        match kind {
            "tube-end" => given.push(("angle", format!("{:.1} deg", between(rng, 8.0, 45.0)))),
            "u-bend" => given.push(("pad-pressure", format!("{:.2} MPa", between(rng, 0.1, 4.0)))),
            "emboss" => given.push(("shape", ["flat", "dome"][rng.usize(0..2)].into())),
            "stretch-bend" => given.push(("angle", format!("{:.1} deg", between(rng, 90.0, 170.0)))),
            "v-bend" => {
                given.extend([("bottom", "yes".into()), ("angle", format!("{:.1} deg", between(rng, 70.0, 150.0)))])
            }
            "hat-section" => given.push(("springback", "1 deg".into())),
            "redraw" if rng.bool() => given.push(("reverse", "yes".into())),
            "redraw" => given.push(("wall", format!("{:.2} t", between(rng, 0.5, 1.0)))),
            _ => {}
        }
        let given: Vec<(&str, &str)> = given.iter().map(|(key, value)| (*key, value.as_str())).collect();
        let Ok(text) = find(kind).and_then(|template| template.fill(&given)) else { continue };
        let overrides =
            if elastic && !text.contains("mode = ") { ELASTIC.map(String::from).to_vec() } else { Vec::new() };
        let case =
            case::parse(&text, "case.toml", &overrides).unwrap_or_else(|error| panic!("{kind} {given:?}: {error}"));
        return (kind.into(), case.stages, format!("{given:?}"));
    }
}
