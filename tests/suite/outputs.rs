//! What is made from a run: tables, files and plots, over the whole list of outputs.

use crate::common::drawn;
use stampflow::assess;
use stampflow::author::templates::find;
use stampflow::case::comparison::{Against, BandSpec, ComparedQuantity, Data, Spec};
use stampflow::case::files::sha256;
use stampflow::case::{Solution, parse};
use stampflow::measure::{Shape, changes};
use stampflow::model::{Geometry, Model, Role};
use stampflow::report::Report;
use stampflow::results::comparison::{Compared, Comparison, Computed, compare};
use stampflow::results::{Make, OUTPUTS, Results, Summary, comparison_folder, load_travel, profile};
use stampflow::solver::solution::StageSolution;
use stampflow::table::{Csv, Table};
use std::fs;
use std::path::PathBuf;
use std::time::Duration;

fn headers(table: &Table) -> String {
    table.columns.iter().map(|c| c.header()).collect::<Vec<_>>().join(",")
}

#[test]
fn load_travel_begins_with_travel_and_forces() {
    for (geometry, begins) in [
        (Geometry::Axisymmetric, "travel_mm,punch_force_N,holder_force_N,edge_force_N,draw_in_mm,thinnest_mm"),
        (Geometry::PlaneStrain, "travel_mm,punch_force_N_per_mm,holder_force_N_per_mm,edge_force_N_per_mm"),
    ] {
        let model = drawn::model(geometry);
        let run = drawn::run(&model);
        let table = load_travel::table(&run);
        assert!(headers(&table).starts_with(begins), "{}", headers(&table));
        assert_eq!(table.rows(), run.steps.len());
        assert_eq!(table.column("punch_force").values[41], run.steps[41].punch_force);
    }
}

#[test]
fn profile_has_one_row_per_frame_and_element_from_the_axis_outward() {
    let model = drawn::model(Geometry::Axisymmetric);
    let run = drawn::run(&model);
    let table = profile::table(&model, &run.frames);
    assert!(headers(&table).starts_with(
        "travel_mm,s0_mm,r_mm,z_mm,thickness_mm,strain_meridional,strain_hoop,strain_thickness,strain_equivalent,\
         stress_meridional_MPa,stress_hoop_MPa"
    ));
    let n = model.blank.elements;
    assert_eq!(table.rows(), run.frames.len() * n);
    let element = run.frames[2].elements[3];
    assert_eq!(table.column("travel").values[2 * n + 3], run.frames[2].travel);
    assert_eq!(table.column("thickness").values[2 * n + 3], element.thickness);
    assert_eq!(profile::table(&model, &run.frames[4..]).column("travel").values, vec![50.0; n]);
    assert_eq!(profile::table(&model, &[]).rows(), 0);
}

#[test]
fn all_files_are_written_and_nothing_else() {
    let model = drawn::blown(Geometry::Axisymmetric);
    let run = drawn::run(&model);
    let plain = StageSolution { model: drawn::model(Geometry::Axisymmetric), ..run.clone() };
    let none = OUTPUTS.iter().filter(|output| output.bytes(&drawn::view(&plain)).is_none());
    let none: Vec<&str> = none.map(|output| output.file).collect();
    let special = "springback.csv springback.png residual_stress.csv residual_stress.png pressure_cycle.csv \
                   pressure_cycle.png porosity.png temperature.png forming_limit.csv strain_paths.csv forming_limit.png \
                   section.pvd tools.pvd shapes.gif compare_*.png, csv error_bars.csv stages.csv";
    assert_eq!(none.join(" "), special);
    let dir = temp_dir::TempDir::new().unwrap();
    let mut written = solution(run).write(dir.path().join("cup")).unwrap();
    let mut found: Vec<_> = std::fs::read_dir(dir.path().join("cup")).unwrap().map(|e| e.unwrap().path()).collect();
    found.sort();
    written.sort();
    assert_eq!(found, written);
    assert_eq!(found.len(), OUTPUTS.len() - 10, "all but those of a release, of several frames and of a whole case");
}

/// The drawn run as that of a case.
fn solution(run: StageSolution) -> Solution {
    let mut case = parse(&find("cup").unwrap().fill(&[]).unwrap(), "cup.toml", &[]).unwrap();
    case.stages[0].model = run.model.clone();
    Solution { case, stages: vec![run], wall: Some(Duration::from_millis(312)) }
}

#[test]
fn the_summary_says_the_same_in_print_and_in_json() {
    let model = drawn::model(Geometry::Axisymmetric);
    let run = drawn::run(&model);
    let summary = Summary::of(&drawn::view(&run));
    let printed = summary.to_string();
    let json = serde_json::to_value(&summary).unwrap();
    let peak = run.steps.iter().map(|s| s.punch_force).fold(0.0, f64::max);
    assert!((json["peak_punch_force_N"].as_f64().unwrap() - peak).abs() < 1e-6 * peak);
    assert!(printed.contains(&format!("{:.1} kN", 1e-3 * peak)), "{printed}");
    assert_eq!(json["complete"], true);
    assert_eq!(json["steps"], 100);
    assert_eq!(json["case_sha256"].as_str().unwrap().len(), 64);
    let warnings = assess::warnings(&run);
    assert_eq!(warnings.len(), 1, "a tool that penetrates: {warnings:?}");
    for line in model.notes.iter().cloned().chain(warnings.iter().map(ToString::to_string)) {
        assert!(printed.contains(&line));
        assert!(json["notes"].to_string().contains(&line[..20]) || json["warnings"].to_string().contains(&line[..20]));
    }
}

/// What never started has tables, a summary, and one plot: tools and sheet where they would have begun.
#[test]
fn a_run_without_a_step_draws_no_empty_axes() {
    let model = drawn::blown(Geometry::PlaneStrain);
    let mut run = drawn::run(&model);
    run.steps.clear();
    run.frames.clear();
    let subject = drawn::view(&run);
    for output in OUTPUTS {
        let made = output.bytes(&subject);
        let expected = ["summary.json", "load_travel.csv", "profile.csv", "forming_limit.csv", "shapes.png"];
        assert_eq!(made.is_some(), expected.contains(&output.file), "{}", output.file);
        assert!(made.is_none_or(|bytes| !bytes.is_empty()), "{}", output.file);
    }
}

/// Runs that leave something open: a stage that is not run, a first step that is not found, tools taken away, gas on a
/// membrane, a stage in which nothing goes anywhere, steps that the residual alone accepts, a release of the undeformed sheet.
///
/// Trust: the names of what is no number, in every text and in what every frame holds, from which binary files are made.
#[test]
fn nothing_that_is_no_number_is_written() {
    let cup = |sets: &[&str]| find("cup").unwrap().fill(&[]).unwrap() + &sets.join("\n");
    let stage = |rest: &str| format!("[[stages]]\nname = \"next\"\n{rest}");
    let shipped = |name: &str| fs::read_to_string(format!("cases/{name}.toml")).unwrap();
    let odd: [(&str, String, &[&str], bool); 8] = [
        ("a stage that is not run", cup(&[&stage("punch.move = \"-1 mm\"")]), &["solver.max_iterations=1"], false),
        ("no first step", cup(&[]), &["solver.max_iterations=1"], false),
        ("interrupted by creeping", cup(&[]), &["solver.max_iterations=2", "solver.min_step=1e-12"], false),
        ("the residual alone", cup(&[]), &["solver.norm=residual", "solver.tolerance=1e-3"], true),
        ("nothing moves", cup(&[&stage("duration = \"1 s\"")]), &[], true),
        (
            "the residual alone where nothing moves",
            cup(&[&stage("duration = \"1 s\"")]),
            &["solver.norm=residual"],
            true,
        ),
        ("a release", find("v-bend").unwrap().fill(&[]).unwrap(), &[], true),
        ("gas on a membrane", shipped("superplastic_dome"), &["blank.elements=30"], true),
    ];
    for (name, text, sets, ends) in odd {
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
        let case = parse(&text, "case.toml", &sets).unwrap_or_else(|e| panic!("{name}: {}", e.render(false)));
        let solution = case.solve(&mut ());
        assert_eq!(solution.is_complete(), ends, "{name}: {}", solution.stages.last().unwrap().stop);
        let mut texts = vec![
            ("summary".into(), solution.summary().to_string()),
            ("report".into(), Report::of(&solution).html()),
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

/// A cup that is drawn until its rim has left the holder.
fn cup_without_flange() -> (Model, StageSolution) {
    let text = find("cup").unwrap().fill(&[("height", "35 mm"), ("punch-radius", "40 mm"), ("trim", "8 %")]).unwrap();
    let model = parse(&text, "cup.toml", &[]).unwrap().model().clone();
    let run = stampflow::run(&model, &mut ());
    (model, run)
}

/// Trust: what touches nothing has no reason to move, and what last lay between holder and die had the sheet's thickness.
#[test]
fn a_holder_that_the_sheet_has_left_stays_where_it_last_touched() {
    let (model, run) = cup_without_flange();
    let lost = run.steps.iter().position(|step| step.holder_force == 0.0).expect("the rim leaves the holder");
    let (before, after) = run.steps.split_at(lost);
    let stands = before[lost - 1].holder_move;
    assert!(stands < 0.0 && after.len() > 5, "{stands} mm, {} steps", after.len());
    for step in after {
        assert_eq!(step.holder_move, stands, "at {} mm of travel", step.travel);
    }
    let holder = model.tools.iter().position(|tool| tool.role == Role::Holder).unwrap();
    let last = run.frames.last().unwrap();
    assert_eq!(last.tool_displacement[holder].y, stands);
    // Half a thickness of the blank from z = 0, each: the faces of holder and die.
    let (room, rim) = (model.blank.thickness - stands, last.elements.last().unwrap().thickness);
    assert!(room > rim, "{room} mm of room for a rim of {rim} mm");
    let column = load_travel::table(&run).column("holder_move").values.clone();
    assert_eq!(column[lost..], vec![stands; after.len()]);
    let warnings = assess::warnings(&run);
    assert!(warnings.iter().any(|w| w.to_string().contains("the sheet left the holder at 29.1")), "{warnings:?}");
}

/// Trust: the template's own height, to the 3 % that its test asks for; energies are the run's in N mm, a thousandth of
/// which is a joule.
#[test]
fn the_summary_says_what_the_part_came_out_as() {
    let (_, run) = cup_without_flange();
    let summary = Summary::of(&drawn::view(&run));
    let json = serde_json::to_value(&summary).unwrap();
    let of = |key: &str| json[key].as_f64().unwrap_or_else(|| panic!("{key} in {json}"));
    assert!((of("part_height_mm") / 35.0 - 1.0).abs() < 0.03, "{json}");
    assert!(of("wall_angle_deg").abs() < 2.0, "the wall of a cup is upright: {json}");
    let last = run.frames.last().unwrap();
    let thickest = last.elements.iter().map(|element| element.thickness).fold(0.0, f64::max);
    assert!((of("thickest_mm") - thickest).abs() < 1e-8 && of("thickest_s0_mm") > 60.0, "the rim is thickest: {json}");
    let work = run.steps.last().unwrap().work.external;
    assert!((of("work_external_J") - 1e-3 * work).abs() < 1e-8 * work);
    assert_eq!(load_travel::table(&run).column("work_external").header(), "work_external_J");
    let printed = summary.to_string();
    assert!(printed.contains(" J\n") && !printed.contains("mJ"), "{printed}");
}

/// Every stage of a case.
fn stages(text: &str) -> Solution {
    parse(text, "case.toml", &[]).unwrap().solve(&mut ())
}

fn v_bend() -> Solution {
    stages(&find("v-bend").unwrap().fill(&[]).unwrap())
}

/// Trust: what is measured on the last frames of both stages; the sheet of a release is that of the stage before.
#[test]
fn the_summary_of_a_release_has_its_spring_back_and_no_round_off() {
    let solution = v_bend();
    let passes = &solution.stages;
    let ends = [&passes[0], &passes[1]].map(|pass| Shape::of(pass.frames.last().unwrap()));
    let summary = Summary::of(&drawn::view(&passes[1]));
    let printed = summary.to_string();
    let json = serde_json::to_value(&summary).unwrap();
    let listed = json["springback"].as_array().unwrap();
    let expected = changes(&ends[0], &ends[1]);
    assert_eq!(listed.len(), expected.len());
    for (found, change) in listed.iter().zip(expected) {
        assert_eq!(
            (&found["key"], &found["unit"]),
            (&change.quantity.key.into(), &change.quantity.unit.spelled().into())
        );
        assert!((found["after"].as_f64().unwrap() - change.after.unwrap()).abs() < 1e-6);
        assert!(printed.contains(change.quantity.label), "{printed}");
    }
    let angle = ends[1].opening_angle().unwrap();
    assert!(printed.contains(&format!("→ {angle:.1}° (+")), "{printed}");
    assert!(printed.contains("full time reached") && !printed.contains("Largest holder force"), "{printed}");
    // Nothing yields as the bend opens; what the sums leave of its plastic work is 1e-14 of the others.
    assert_eq!(json["work_plastic_J_per_mm"], 0.0, "{printed}");
    assert!(json["work_elastic_J_per_mm"].as_f64().unwrap() < 0.0);
    assert!(Summary::of(&drawn::view(&passes[0])).to_string().contains("full travel reached"));
    let report = solution.summary().lines.to_string();
    let lines: Vec<&str> = report.lines().collect();
    assert!(lines[0].contains("full travel reached: ") && lines[1].contains("full time reached: "), "{report}");
}

/// Trust: over every text of every table, plot and the summary.
#[test]
fn plane_strain_has_no_axis_hoops_or_rings() {
    let model = drawn::blown(Geometry::PlaneStrain);
    let run = drawn::run(&model);
    let subject = drawn::view(&run);
    let mut texts = vec![Summary::of(&subject).to_string()];
    for output in OUTPUTS {
        match output.make {
            Make::Table(make) => {
                texts.extend(make(&subject).iter().flat_map(|table| &table.columns).map(|c| c.label.to_owned()))
            }
            Make::Plot(make) => {
                let Some(chart) = make(&subject) else { continue };
                texts.extend(chart.panels.iter().flat_map(|p| [p.x.text().to_owned(), p.y.text().to_owned()]));
                texts.extend(chart.panels.iter().flat_map(|p| &p.series).filter_map(|s| s.label.clone()));
                texts.extend(chart.notes);
            }
            Make::Text(_) | Make::Moving(..) | Make::OfCase(_) => {}
        }
    }
    for text in texts.iter().flat_map(|text| text.lines()) {
        let words: Vec<String> = text.split(|c: char| !c.is_alphabetic()).map(str::to_lowercase).collect();
        assert!(!["axis", "hoop", "ring", "meridional"].iter().any(|w| words.iter().any(|word| word == w)), "{text}");
    }
}

/// Measured thicknesses without places beside the sample run.
fn band(run: &StageSolution) -> Comparison {
    let csv = Csv::read("thickness_mm,error_mm\n0.84,0.01\n1.0,0.01\n1.12,0.01\n", "cup.csv", "").unwrap();
    let against = Against::Band(BandSpec {
        quantity: ComparedQuantity::Thickness,
        columns: vec!["thickness_mm".to_owned()],
        error: Some("error_mm".to_owned()),
    });
    let (reference, data) = (PathBuf::from("cup_thickness.csv"), Some(Data { csv, source: None }));
    let reason = "the edge was not measured".to_owned();
    compare(&Spec { reference, data, against, reason, optional: false, demonstration: false }, &Computed::of(run))
        .unwrap()
}

/// Trust: the sample's flange thickens beyond the 1.12 mm that were measured.
#[test]
fn a_band_is_written_as_a_picture_and_in_numbers() {
    let model = drawn::model(Geometry::Axisymmetric);
    let run = drawn::run(&model);
    let dir = temp_dir::TempDir::new().unwrap();
    let band = band(&run);
    let largest = run.frames.last().unwrap().elements.iter().map(|e| e.thickness).fold(0.0, f64::max);
    let solution = solution(run);
    let mut results = Results { comparisons: vec![band], ..Results::of(&solution).unwrap() };
    let written = results.write_comparisons(comparison_folder(dir.path()).unwrap()).unwrap();
    assert_eq!(written[1], dir.path().join("compare_1_thickness.png"));
    let numbers = fs::read_to_string(&written[0]).unwrap();
    let (header, row) = numbers.trim().split_once('\n').unwrap();
    assert_eq!(
        header,
        "measured_low_mm,measured_high_mm,accepted_low_mm,accepted_high_mm,computed_low_mm,computed_high_mm,outside_mm,\
         difference_percent"
    );
    let outside: f64 = row.split(',').nth(6).unwrap().parse().unwrap();
    assert!(outside > 0.0 && (outside - (largest - 1.13)).abs() < 1e-8, "{numbers}");
    results.comparisons[0].compared = Compared::NoData;
    assert!(results.write_comparisons(comparison_folder(dir.path()).unwrap()).unwrap().is_empty());
}

/// XML cannot hold control characters, and a title can: they are left out of pictures, the rest is drawn.
#[test]
fn a_title_may_hold_any_character() {
    let mut model = drawn::blown(Geometry::Axisymmetric);
    model.title = "Cup \u{0}\u{7}\u{1b}[1m\u{fffe} <&\"> \u{202e}".to_owned();
    let run = drawn::run(&model);
    let made = OUTPUTS.iter().filter(|output| output.bytes(&drawn::view(&run)).is_some());
    assert_eq!(made.count(), OUTPUTS.len() - 10, "all but those of a release, of several frames and of a whole case");
}

/// Trust: the digest of the empty text as given in FIPS 180.
#[test]
fn the_checksum_is_sha256_in_hexadecimal() {
    assert_eq!(sha256([""]), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}
