//! What is made from a run: tables, files and pictures, over the whole list of outputs.

use crate::common::prelude::*;
use stampflow::plot::chart::{Series, Style};
use stampflow::{case::files::sha256, plot::StageView, report::Report, results::Summary, table::Table};

/// Cases, their stage, and the outputs that not every run has.
const SPECIAL: [(&str, usize, &str); 7] = [
    ("quickstart", 0, "forming_limit.csv strain_paths.csv forming_limit.png"),
    ("superplastic_dome", 0, "pressure_cycle.csv pressure_cycle.png"),
    ("superplastic_box", 0, "pressure_cycle.csv pressure_cycle.png"),
    ("woo_porous", 0, "porosity.png"),
    ("warm_cup", 0, "temperature.png"),
    (
        "hat_springback",
        1,
        "springback.csv springback.png residual_stress.csv residual_stress.png forming_limit.csv strain_paths.csv forming_limit.png",
    ),
    ("stretch_limit", 0, "forming_limit.csv strain_paths.csv forming_limit.png"),
];

fn solutions() -> impl Iterator<Item = (&'static Solution, usize, &'static str)> {
    SPECIAL.iter().map(|&(name, stage, special)| (solved(name), stage, special))
}

fn headers(table: &Table) -> String {
    table.columns.iter().map(|c| c.header()).collect::<Vec<_>>().join(",")
}

/// Trust: the list; what is written is what can be made, and nothing else.
#[test]
fn every_case_has_its_outputs_and_no_others() {
    let plain = "part.png shapes.png strains.png thickness.png load_travel.csv profile.csv summary.json";
    for (solution, stage, special) in solutions() {
        let (name, view) = (&solution.case.name, &solution.views()[stage]);
        for output in OUTPUTS.iter().filter(|output| !matches!(output.make, Make::Moving(..) | Make::OfCase(_))) {
            let is_release_curve = output.file == "load_travel.png" && view.model().release.is_some();
            let sure = plain.contains(output.file) || output.file == "load_travel.png" || special.contains(output.file);
            // Superplastic sheets and releases have no tearing index.
            let is_pulled = !name.starts_with("superplastic") && view.model().release.is_none();
            let expected = sure || output.file == "tearing.png" && is_pulled;
            let made = output.files(view).first().is_some_and(|(_, bytes)| !bytes.is_empty());
            assert_eq!(made, expected && !is_release_curve && !output.file.ends_with("pvd"), "{name} {}", output.file);
        }
    }
    let (hat, output) = (solved("hat_springback"), OUTPUTS.iter().find(|output| output.file == "strain_paths.csv"));
    let paths = &output.unwrap().files(&hat.views()[0])[0].1;
    let rows = paths.iter().filter(|byte| **byte == b'\n').count();
    assert!(hat.stages[0].steps.len() > 300 && rows < 1 + 202 * hat.stages[0].model.blank.elements, "{rows}");
    let dir = temp_dir::TempDir::new().unwrap();
    let mut written = solved("quickstart").write(dir.path().join("cup")).unwrap();
    written.sort();
    assert_eq!(crate::common::files::files(dir.path().join("cup"), ""), written);
}

/// Trust: the run's own records.
#[test]
fn tables_begin_with_their_columns_and_hold_the_records() {
    for (case, begins) in [
        ("quickstart", "travel_mm,punch_force_N,holder_force_N,edge_force_N,draw_in_mm,thinnest_mm"),
        ("strip_draw", "travel_mm,punch_force_N_per_mm,holder_force_N_per_mm,edge_force_N_per_mm"),
    ] {
        let run = &solved(case).stages[0];
        let table = tables::load_travel(run);
        assert!(headers(&table).starts_with(begins), "{}", headers(&table));
        assert_eq!(table.rows(), run.steps.len());
        assert_eq!(table.column("punch_force").values[41], run.steps[41].punch_force);
        let table = tables::profile(&run.model, &run.frames);
        assert!(headers(&table).starts_with(
            "travel_mm,s0_mm,r_mm,z_mm,thickness_mm,strain_meridional,strain_hoop,strain_thickness,strain_equivalent,\
             stress_meridional_MPa,stress_hoop_MPa"
        ));
        let (n, element) = (run.model.blank.elements, run.frames[1].elements[3]);
        assert_eq!(table.rows(), run.frames.len() * n);
        assert_eq!(table.column("travel").values[n + 3], run.frames[1].travel);
        assert_eq!(table.column("thickness").values[n + 3], element.thickness);
        assert_eq!(tables::profile(&run.model, &[]).rows(), 0);
    }
}

/// Runs that leave something open: a stage that is not run, a first step that is not found, gas on a membrane, a stage in
/// which nothing moves, steps that the residual alone accepts, a release.
///
/// Trust: the names of what is no number, in every text and in what every frame holds.
#[test]
fn nothing_that_is_no_number_is_written() {
    let cup = |more: &str| find("cup").unwrap().fill(&[]).unwrap() + more;
    let still = "[[stages]]\nname = \"next\"\nduration = \"1 s\"";
    let next = "[[stages]]\nname = \"next\"\npunch.move = \"-1 mm\"";
    let dome = fs::read_to_string("cases/superplastic_dome.toml").unwrap();
    let odd: [(&str, String, &[&str], bool); 8] = [
        ("a stage that is not run", cup(next), &["solver.max_iterations=1"], false),
        ("no first step", cup(""), &["solver.max_iterations=1"], false),
        ("creeping", cup(""), &["solver.max_iterations=2", "solver.min_step=1e-12"], false),
        ("the residual alone", cup(""), &["solver.norm=residual", "solver.tolerance=1e-3"], true),
        ("nothing moves", cup(still), &[], true),
        ("nothing moves, the residual alone", cup(still), &["solver.norm=residual"], true),
        ("a release", find("v-bend").unwrap().fill(&[]).unwrap(), &[], true),
        ("gas on a membrane", dome, &["blank.elements=30"], true),
    ];
    for (name, text, sets, ends) in odd {
        let solution = parsed(&text, sets).solve(&mut ());
        assert_eq!(solution.is_complete(), ends, "{name}: {}", solution.stages.last().unwrap().stop);
        let mut texts = vec![
            ("summary".into(), solution.summary().to_string()),
            ("report".into(), Report::answered(&solution, None, answered(&solution, None)).html()),
            ("frames".into(), solution.stages.iter().map(|stage| format!("{:?}", stage.frames)).collect()),
        ];
        let dir = temp_dir::TempDir::new().unwrap();
        let files = solution.write(dir.path()).unwrap();
        let read = |path: &PathBuf| (path.display().to_string(), fs::read_to_string(path).unwrap_or_default());
        texts.extend(files.iter().map(read));
        for (file, text) in texts {
            let words = text.split(|c: char| !c.is_ascii_alphanumeric());
            let odd: Vec<_> = words.filter(|word| ["nan", "inf"].contains(&word.to_lowercase().as_str())).collect();
            assert!(odd.is_empty(), "{name}: {file}: {odd:?}");
            // A light has no value or limit where there is none to have.
            let may_be = ["change", "value", "amber", "red"].map(|key| format!("\"{key}\": null"));
            let nulls = [text.matches("null").count(), may_be.iter().map(|null| text.matches(null).count()).sum()];
            assert!(!file.ends_with(".json") || nulls[0] == nulls[1], "{name}: {text}");
        }
    }
}

/// Trust: what touches nothing has no reason to move, and what last lay between holder and die had the sheet's thickness; the
/// height with what is trimmed to 3 %; energies are the run's in N mm, a thousandth of which is a joule.
#[test]
fn a_cup_without_a_flange_has_its_holder_where_it_last_touched_and_its_numbers() {
    let sizes = [("height", "35 mm"), ("punch-radius", "40 mm"), ("trim", "3 mm")];
    let run = shipped::solve(made("cup", &sizes, &[]).model());
    let lost = run.steps.iter().position(|step| step.holder_force == 0.0).expect("the rim leaves the holder");
    let (before, after) = run.steps.split_at(lost);
    let stands = before[lost - 1].holder_move;
    assert!(stands < 0.0 && after.len() > 5, "{stands} mm, {} steps", after.len());
    assert!(after.iter().all(|step| step.holder_move == stands));
    let holder = run.model.tools.iter().position(|tool| tool.role == Role::Holder).unwrap();
    let last = run.frames.last().unwrap();
    assert_eq!(last.tool_displacement[holder].y, stands);
    let (room, rim) = (run.model.blank.thickness - stands, last.elements.last().unwrap().thickness);
    assert!(room > rim, "{room} mm of room for a rim of {rim} mm");
    let warns =
        |run: &_| assess::of_stage(0, run).iter().any(|w| w.statement().contains("the sheet left the holder at 3"));
    let mut unmeant = run.clone();
    unmeant.model.stop.drawn_through = false;
    assert!(warns(&unmeant) && !warns(&run));

    let json = serde_json::to_value(Summary::of(&StageView::alone("cup", &run))).unwrap();
    let number = |key: &str| json[key].as_f64().unwrap_or_else(|| panic!("{key} in {json}"));
    assert!((number("part_height_mm") / 38.0 - 1.0).abs() < 0.03 && number("wall_angle_deg").abs() < 2.0, "{json}");
    let thickest = last.elements.iter().map(|element| element.thickness).fold(0.0, f64::max);
    assert!((number("thickest_mm") - thickest).abs() < 1e-8 && number("thickest_s0_mm") > 60.0, "{json}");
    let work = run.steps.last().unwrap().work.external;
    assert!((number("work_external_J") - 1e-3 * work).abs() < 1e-8 * work);
    assert!((number("peak_punch_force_N") / shipped::peak(&run) - 1.0).abs() < 1e-6);
    assert_eq!((&json["complete"], json["steps"].as_u64()), (&true.into(), Some(run.steps.len() as u64)));
    assert_eq!(json["case_sha256"].as_str().map(str::len), Some(64));
    // Digest of the empty text as given in FIPS 180.
    assert_eq!(sha256([""]), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

/// Trust: what is measured on the last frames of both stages; nothing yields as the bend opens.
#[test]
fn the_summary_of_a_release_has_its_spring_back_and_no_round_off() {
    let solution = made("v-bend", &[], &[]).solve(&mut ());
    let ends = [0, 1].map(|i| Shape::of(solution.stages[i].frames.last().unwrap()));
    let json = serde_json::to_value(Summary::of(&StageView::alone("bend", &solution.stages[1]))).unwrap();
    let (listed, expected) = (json["springback"].as_array().unwrap(), changes(&ends[0], &ends[1]));
    assert_eq!(listed.len(), expected.len());
    for (found, change) in listed.iter().zip(expected) {
        let quantity = &change.quantity;
        assert_eq!((&found["key"], &found["unit"]), (&quantity.key.into(), &quantity.unit.spelled().into()));
        assert!((found["after"].as_f64().unwrap() - change.after.unwrap()).abs() < 1e-6);
    }
    assert_eq!(json["work_plastic_J_per_mm"], 0.0);
    assert!(json["work_elastic_J_per_mm"].as_f64().unwrap() < 0.0);
}

#[test]
fn a_measured_curve_is_drawn_with_few_markers_and_its_first_point() {
    for (rows, markers) in [(0, 0), (400, 400), (401, 201), (99_000, 400)] {
        let style = Style::Circles { color: (0, 0, 0) };
        let drawn = Series::silent((0..rows).map(|i| (f64::from(i), 0.0)).collect(), style).points;
        assert!(drawn.len() == markers && drawn.first().is_none_or(|point| point.0 == 0.0), "{rows}: {}", drawn.len());
    }
}
