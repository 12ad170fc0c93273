//! Sheets that are not the same all along: tailored blanks, and those that an earlier run has formed.

use crate::common::{cli::folder, cli::stampflow, prelude::*};
use stampflow::model::Zone;

/// Trust: equilibrium of a pulled strip, the same force N = (2/√3) σ_y(2ε/√3) t₀ exp(−ε) in every zone, in plane strain.
#[test]
fn zones_of_a_pulled_strip_carry_one_force() {
    for mode in [Mode::Flow, Mode::ElastoViscoplastic] {
        let mut model = simple::pulled(Geometry::PlaneStrain, Theory::Membrane, 3.0);
        model.material.elastic = Some(Elastic { young: 206e3, poisson: 0.3 });
        (model.mode, model.blank.elements) = (mode, 40);
        let hardening = Hardening::Swift(Swift::new(580.0, 0.2, 1e-3).expect("valid"));
        let material = Some(Material { hardening, ..model.material.clone() });
        model.blank.zones = vec![Zone { within: [20.0, 40.0], thickness: 0.9, material }];
        let elements = solve(&model).frames.pop().expect("a frame").elements;
        let force = |e: usize, t: f64| {
            let (strain, factor) = (elements[e].strain_meridional, 2.0 / 3f64.sqrt());
            let metal = model.material_at(elements[e].s0);
            factor * metal.yield_stress(factor * strain, 293.15) * t * (-strain).exp()
        };
        assert!(elements[3].strain_meridional > 0.05 && elements[36].strain_meridional > 0.02);
        assert_relative_eq!(force(3, 1.0), force(36, 0.9), max_relative = 2e-3);
    }
}

/// Trust: a cup that is redrawn in one run and in two is the same cup; what the second run leaves out, bending through the
/// thickness, is below a percent of it.
#[test]
fn an_earlier_run_goes_on_where_it_ended() {
    let whole = made("redraw", &[], &[]);
    let dir = folder("quickstart");
    std::fs::write(dir.path().join("whole.toml"), &whole.text).expect("written");
    assert!(stampflow(dir.path(), &["run", "whole.toml"]).status.success());
    let (first, second) = whole.text.split_once("# New tools").expect("a second stage");
    let [blank, material, tools] = ["[blank]", "[material]", "[tools.punch]"].map(|t| first.find(t).expect("a table"));
    let second = second.split_once("name = \"redraw\"").expect("its name").1.replace("[stages.", "[tools.");
    let sheet = "[blank]\nearlier_run = \"out/whole/1-draw\"\nthickness = \"1 mm\"\n[stop]\ndrawn_through = true\n";
    let text = [&first[..blank], sheet, &first[material..tools], &second.replace("move =", "travel =")].concat();
    let name = dir.path().join("second.toml");
    let case = |text: &str| case::parse(text, &name.to_string_lossy(), &[]);
    let again = case(&text).expect("a case").solve(&mut ());
    // The verdict goes on too: the ratio of the second draw by hand, and no word on a flat blank's holder.
    let found = assess::after(&again.case, &again.stages);
    assert_relative_eq!(row(&found, "redraw_ratio").value().unwrap(), 37.45 / 30.0, max_relative = 1e-3);
    assert!(found.iter().all(|row| !["holder", "wall_wrinkles"].contains(&row.key)), "{found:?}");
    let again = again.stages.into_iter().next().expect("a stage");
    let doubts =
        |text: &str| assess::before(&case(text).expect("a case")).into_iter().map(|row| row.key).collect::<Vec<_>>();
    let summary = dir.path().join("out/whole/1-draw/summary.json");
    let written = std::fs::read_to_string(&summary).expect("a summary");
    std::fs::write(summary, written.replace("\"complete\": true", "\"complete\": false")).expect("written");
    assert!(doubts(&text.replace("520 MPa", "600 MPa")).contains(&"earlier_material"));
    assert!(doubts(&text).contains(&"earlier_run") && !doubts(&text).contains(&"earlier_material"));
    let wide = "flat = { radius = \"38 mm\", nose = \"6 mm\" }\nfriction = 0.1\ntravel = \"5 mm\"\n\
                [tools.die]\nthroat = \"39.5 mm\"\nshoulder = \"6 mm\"\nfriction = 0.1\n";
    let wide = [text.split_once("flat =").expect("a punch").0, wide].concat();
    assert!(doubts(&wide).contains(&"wide_punch") && !doubts(&text).contains(&"wide_punch"));
    let found = assess::after(&case(&text).expect("a case"), std::slice::from_ref(&again));
    assert_eq!(row(&found, "earlier_run").light, Light::Red);
    let error = |from: &str, to: &str| case(&text.replace(from, to)).expect_err("refused").to_string();
    assert!(error("1-draw", "1-draw/profile.csv").contains("is a file") && error("/1-draw", "").contains("has stages"));
    assert!(error("axisymmetric", "plane_strain").contains("is not plane"));
    let wanted = &whole.solve(&mut ()).stages[1];
    assert_relative_eq!(peak(&again), peak(wanted), max_relative = 0.01);
    let values = |step: &StepRecord| [step.travel, step.thinnest];
    let [again, wanted] = [&again, wanted].map(|stage| values(last(stage)));
    again.iter().zip(wanted).for_each(|(a, b)| assert_relative_eq!(*a, b, max_relative = 0.01));
}
