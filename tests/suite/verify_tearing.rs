//! Tearing index: closed form of a pulled strip, and cups that a toolmaker would draw or not.

use crate::common::prelude::*;
use stampflow::solver::solve;

/// Trust: of σ = K (ε₀ + ε̄)^n, ε̄ = c ε and c = 2/√3, the force of a wide strip is (ε₀ + c ε)^n e^(−ε) over its maximum at
/// ε = n − ε₀/c. Its strains are exact at any step; what is left is the corrector's tolerance.
#[test]
fn the_index_of_a_wide_strip_is_one_at_its_load_maximum() {
    for theory in [Theory::Membrane, Theory::Bending] {
        let mut model = simple::pulled(Geometry::PlaneStrain, theory, 16.0);
        model.frames = (1..=40).map(|i| model.duration * f64::from(i) / 40.0).collect();
        model.stop.localised = false;
        let (n, offset, c) = (0.22, 1e-3, 2.0 / 3.0_f64.sqrt());
        let force = |strain: f64| (offset + c * strain).powf(n) * (-strain).exp();
        let top = n - offset / c;
        let solved = run(&model, &mut ());
        for frame in &solved.frames {
            let element = &frame.elements[3];
            let strain = element.strain_meridional;
            // Past the maximum every state is one.
            let expected = if strain < top { force(strain) / force(top) } else { 1.0 };
            assert!((element.tearing_index - expected).abs() < 1e-4, "{theory:?} {strain}: {element:?}");
        }
        let last = solved.steps.last().expect("steps");
        assert!(last.tearing_index > 0.9999 && solved.frames[39].elements[3].strain_meridional > top);
    }
}

fn judged(case: &Case) -> (f64, Light) {
    let found = assess::after(case, &solve(&case.stages, &mut ()));
    let row = row(&found, "tearing");
    (0.01 * row.value().expect("a number"), row.light)
}

/// A cup of mild steel over a punch of Ø 70 mm with this nose and draw ratio, held by Siebel's pressure.
fn cup(nose: &str, ratio: f64) -> Case {
    let given = [("material", "dc04"), ("punch-radius", "35 mm"), ("nose", nose)];
    let pressure = 0.0025 * ((ratio - 1.0).powi(2) + 0.35) * 300.0;
    let radius = 35.0 * ratio;
    let force = pressure * PI * (radius * radius - 43.5 * 43.5);
    let [blank, force] = [format!("blank.radius={radius} mm"), format!("tools.holder.force={force} N")];
    made("cup", &given, &[&blank, &force, "tools.punch.travel=40 mm"])
}

/// Trust: mild steel is drawn to 1.8 safely, to 2.0 over a generous nose (4ming, table of draw ratios: 2.0), and never to 2.4; a
/// nose wants 4 to 5 thicknesses (4ming, "Punch radius").
#[test]
fn cups_tear_where_a_toolmaker_has_them_tear() {
    for (nose, ratio, light) in [
        ("5 mm", 1.8, Light::Green),
        ("6 mm", 2.0, Light::Green),
        ("3 mm", 2.0, Light::Amber),
        ("2 mm", 2.1, Light::Red),
        ("5 mm", 2.4, Light::Red),
    ] {
        let (index, found) = judged(&cup(nose, ratio));
        assert_eq!(found, light, "nose {nose}, draw ratio {ratio}: {index}");
    }
}

/// Trust: the wall carries the force, whatever is embossed in the bottom: a recess or a boss, 3 mm deep. Of two steps the inner one
/// carries until the outer one meets the sheet, as a punch of its size in the same die does; drawn on, it tears there.
#[test]
fn an_embossed_bottom_does_not_tear_a_cup() {
    let folder = temp_dir::TempDir::new().expect("a folder");
    let given = [("material", "dc04"), ("punch-radius", "35 mm")];
    let text = templates::find("cup").and_then(|template| template.fill(&given)).expect("a case");
    let plain = text.lines().find(|line| line.starts_with("flat = ")).expect("a flat punch");
    let cup = |punch: &str, set: &[&str]| {
        let (file, is_flat) = (folder.child("made.toml"), punch.starts_with("flat"));
        fs::write(folder.child("punch.csv"), format!("r_mm,z_mm,radius_mm\n{punch}35,-200,\n")).expect("written");
        let line = if is_flat { punch } else { "profile = \"punch.csv\"" };
        fs::write(&file, text.replace(plain, line)).expect("written");
        judged(&loaded(&file, set))
    };
    let flat = cup(plain, &[]);
    let recess = cup("0,-3,\n15,-3,4\n18,0,4\n35,0,6\n", &[]);
    let boss = cup("0,0,\n12,0,3\n14,-3,3\n35,-3,6\n", &[]);
    assert_eq!([flat.1, recess.1, boss.1], [Light::Green; 3], "{flat:?} {recess:?} {boss:?}");
    assert!((recess.0 / flat.0 - 1.0).abs() < 0.05, "{flat:?} {recess:?}");
    let steps = "0,0,\n20,0,3\n20,-12,5\n35,-12,6\n";
    let [small, inner] =
        ["flat = { radius = \"20 mm\", nose = \"3 mm\" }", steps].map(|punch| cup(punch, &["tools.punch.travel=8 mm"]));
    assert!((inner.0 / small.0 - 1.0).abs() < 0.02 && inner.0 > flat.0, "{small:?} {inner:?}");
    assert_eq!(cup(steps, &[]).1, Light::Red);
}

/// Trust: at 7 mm a dome over a ball of ten thicknesses is whole, as every producer's index of 11 mm and more says.
#[test]
fn a_sound_dome_is_no_neck() {
    let case = shipped_case("erichsen_304l", &["tools.punch.travel=7 mm"]);
    let stages = solve(&case.stages, &mut ());
    assert!(stages[0].neck.is_none() && assess::tears_at(&stages[0]).is_none());
}
