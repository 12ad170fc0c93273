//! Forces and works of a plane section: of both halves, and over a given depth the whole part; and which times show.

use crate::common::prelude::*;

const STRIP: &str = include_str!("../../cases/strip_draw.toml");

fn solved(text: &str, overrides: &[&str]) -> Solution {
    parsed(text.split("[[compare]]").next().unwrap(), overrides).solve(&mut ())
}

/// Trust: a part is as many sections as it has millimetres of depth, each pressed alike: the run is the same to the last digits
/// of a factor. That the section counts twice is in the closed forms of strips.
#[test]
fn over_a_depth_forces_and_works_are_as_many_times_those_per_millimetre() {
    let short = ["tools.punch.travel=10 mm", "blank.elements=60"];
    let per_mm = solved(STRIP, &short);
    let part = solved(STRIP, &[&short[..], &["blank.depth=800 mm"]].concat());
    let [a, b] = [&per_mm, &part].map(|solution| &solution.stages[0]);
    assert_eq!(a.steps.len(), b.steps.len());
    for (a, b) in a.steps.iter().zip(&b.steps) {
        let pairs = [
            (a.punch_force, b.punch_force),
            (a.holder_force, b.holder_force),
            (a.work.external, b.work.external),
            (a.work.plastic, b.work.plastic),
            (a.power.friction, b.power.friction),
        ];
        for (section, whole) in pairs {
            assert!((whole - 800.0 * section).abs() <= 1e-6 * whole.abs(), "{section} {whole} at {} mm", a.travel);
        }
        assert!((a.thinnest - b.thinnest).abs() < 1e-9);
    }
    // 2600 N/mm on 800 mm.
    assert!((b.steps.last().unwrap().holder_force / 2.08e6 - 1.0).abs() < 1e-2);
}
