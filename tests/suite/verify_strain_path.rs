//! The strain path of a full circle over a hemispherical punch, measured on AA6016A Surfalex, with what friction does to it.

use crate::common::shipped::shipped_case;
use stampflow::compare::Found;

/// Friction, r̄, and the minor strain at major strains of 0.1, 0.16 and 0.2 of the place that tears, as computed when these
/// lines were written.
const COMPUTED: [(f64, f64, [f64; 3]); 6] = [
    (0.05, 0.47, [0.0927, 0.1512, 0.1901]),
    (0.1, 0.47, [0.0861, 0.1422, 0.1794]),
    (0.2, 0.47, [0.0703, 0.1186, 0.1506]),
    (0.3, 0.47, [0.0584, 0.0970, 0.1227]),
    (0.1, 1.0, [0.0717, 0.1234, 0.1576]),
    (0.3, 1.0, [0.0394, 0.0628, 0.0772]),
];

/// Trust: no reference, but a record of how far the run is from the measured path; the README's table has the same numbers, and
/// 0.002 is a twentieth of what friction from 0.05 to 0.3 does.
#[test]
fn the_miss_of_the_strain_path_at_every_friction_is_as_the_readme_has_it() {
    let readme = include_str!("../../README.md");
    let mut moved = Vec::new();
    for (friction, ratio, recorded) in COMPUTED {
        let [punch, die] = ["punch", "die"].map(|side| format!("friction.{side}_side={friction}"));
        let given = [punch, die, format!("material.anisotropy={ratio}")];
        let case = shipped_case("surfalex_full_circle", &given.each_ref().map(String::as_str));
        let solution = case.solve(&mut ());
        let comparison = solution.comparisons().expect("a reference").remove(0);
        let Found::Points(points) = &comparison.found else { panic!("{:?}", comparison.found) };
        let at = |major: f64| points.0.iter().find(|p| (p.x - major).abs() < 1e-9).expect("a point");
        let found = [0.1, 0.16, 0.2].map(|major| at(major).computed.unwrap_or(f64::NAN));
        if found.iter().zip(recorded).any(|(found, recorded)| (found - recorded).abs() > 0.002 || found.is_nan()) {
            moved.push(format!(
                "({friction}, {ratio}, {found:.4?}) {} {:?}",
                comparison.sentence(),
                solution.stages[0].stop
            ));
        }
        let row = recorded.map(|minor| format!("{minor:.3}")).join(" | ");
        let row = format!("| {friction} | {ratio} | {row} |");
        if !readme.contains(&row) {
            moved.push(format!("the README has no {row}"));
        }
    }
    assert!(moved.is_empty(), "{}", moved.join("\n"));
}
