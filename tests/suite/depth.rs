//! What forces and works of a plane section are of: both halves, and over a depth that is given the whole part; and which times
//! are told.

use stampflow::assess::{self, check};
use stampflow::case::{Solution, parse};
use stampflow::plot::StageView;
use stampflow::results::{Summary, load_travel};
use stampflow::table::Unit;

const STRIP: &str = include_str!("../../cases/strip_draw.toml");

/// A case without its references.
fn solved(text: &str, overrides: &[&str]) -> Solution {
    let text = text.split("[[compare]]").next().unwrap();
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    parse(text, "case.toml", &overrides).unwrap_or_else(|e| panic!("{}", e.render(false))).solve(&mut ())
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

#[test]
fn every_table_and_text_says_what_its_forces_are_of() {
    let depth =
        ["tools.punch.travel=3 mm", "blank.elements=60", "blank.depth=800 mm", "press.force=1 MN", "press.energy=5 kJ"];
    for (given, force, work, says) in [
        (&depth[..2], Unit::NPerMm, Unit::JoulePerMm, "both halves, per mm of depth"),
        (&depth[..], Unit::N, Unit::Joule, "of the whole part, 800 mm deep"),
    ] {
        let solution = solved(STRIP, given);
        let stage = &solution.stages[0];
        let table = load_travel::table(stage);
        assert_eq!((table.column("punch_force").unit, table.column("work_external").unit), (force, work));
        let summary = Summary::of(&StageView::alone("strip", stage));
        let json = serde_json::to_value(&summary).unwrap();
        assert!(json[force.keyed("peak_punch_force")].is_number() && json[work.keyed("work_plastic")].is_number());
        assert!(summary.to_string().contains(says), "{summary}");
        let report = check::report(&solution.case).to_string();
        assert!(report.contains(says) && !report.contains("modelled"), "{report}");
        for row in assess::after(&solution.case, &solution.stages) {
            let text = format!("{} {} {}", row.found(), row.limit, row.advice);
            assert!(!text.contains("half") && !text.contains("twice"), "{text}");
            if row.key == "press_force" && force == Unit::N {
                assert!(text.contains(" kN at ") && text.contains("1000 kN"), "{text}");
            }
            if row.key == "energy" {
                assert_eq!(row.quantity.as_ref().map(|number| number.amount.unit), Some(work), "{text}");
            }
        }
    }
}
