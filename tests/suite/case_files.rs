//! Case files: the shipped ones load, broken ones say what is wrong, and no override can make the reader panic.

use crate::common::prelude::*;
use proptest::prelude::*;
use stampflow::model::ReleaseStiffness;
use std::{fs::File, io, io::ErrorKind};

const QUICKSTART: &str = include_str!("../../cases/quickstart.toml");

#[test]
fn every_shipped_case_loads_and_names_what_it_assumes() {
    let cases = files("cases", "toml");
    assert!(cases.len() >= 8, "{cases:?}");
    for path in cases {
        let case = loaded(&path, &[]);
        assert!(!case.model().notes.is_empty(), "{}: no notes", case.name);
        let report = format!("{:#}", stampflow::assess::check::report(&case));
        assert!(case.model().notes.iter().all(|note| report.contains(note)), "{report}");
        assert_eq!(case.model().frames.last(), Some(&case.model().duration), "{}", case.name);
        for spec in case.compare.iter().filter(|spec| !spec.optional) {
            assert!(spec.data.is_some() && spec.source.is_some(), "{}", spec.reference.display());
        }
    }
}

/// Trust: by hand. A temperature by the tools' zones, and one from a file of the case's folder.
#[test]
fn a_temperature_is_given_by_zones_or_by_a_file() {
    let at = |heat: &stampflow::model::Heat, places: [f64; 4]| places.map(|s0| heat.initial.at(s0) - 273.15);
    let zones = format!("{MINIMAL}[heat]\ninitial = {{ punch = \"25 °C\", flange = \"225 °C\" }}\n");
    let case = parsed(&zones, &[]);
    let heat = case.model().heat.as_ref().expect("given");
    let found = at(heat, [10.0, 30.0, 30.625, 50.0]);
    for (found, expected) in found.into_iter().zip([25.0, 25.0, 125.0, 225.0]) {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
    assert_eq!(heat.flow, None);

    let folder = temp_dir::TempDir::new().expect("a folder");
    std::fs::write(folder.path().join("field.csv"), "# measured\ns0_in,temperature_C\n1,20\n2,120\n").expect("written");
    let path = folder.path().join("case.toml");
    std::fs::write(&path, format!("{MINIMAL}[heat]\ninitial = \"field.csv\"\n")).expect("written");
    let heat = loaded(&path, &[]).model().heat.clone().expect("given");
    for (found, expected) in at(&heat, [0.0, 25.4, 38.1, 54.0]).into_iter().zip([20.0, 20.0, 70.0, 120.0]) {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

/// Trust: every CSV is walked; its columns are those of the cases that compare with it.
#[test]
fn every_reference_curve_has_its_source_and_the_columns_that_cases_ask_for() {
    let sources: toml::Table = std::fs::read_to_string("reference_data/sources.toml").unwrap().parse().unwrap();
    let curves = files("reference_data", "csv");
    for path in &curves {
        let name = path.file_name().unwrap().to_str().unwrap();
        let source = sources.get(name).unwrap_or_else(|| panic!("{name} is not in sources.toml"));
        for key in ["citation", "kind", "grade", "scatter"] {
            let text = source.get(key).and_then(toml::Value::as_str);
            assert!(text.is_some_and(|text| !text.is_empty()), "{name}: {key}");
        }
    }
    assert_eq!(sources.len(), curves.len(), "a source without its curve");
    for path in files("cases", "toml") {
        for spec in loaded(&path, &[]).compare.iter().filter(|spec| spec.data.is_some()) {
            let text = std::fs::read_to_string(&spec.reference).unwrap();
            let header: Vec<&str> = text.lines().find(|line| !line.starts_with('#')).expect("one").split(',').collect();
            for wanted in spec.columns.iter().chain(&spec.error) {
                assert!(header.contains(&wanted.as_str()), "{}: {wanted}", path.display());
            }
        }
    }
}

#[test]
fn a_twelve_line_case_is_enough_and_its_defaults_are_the_documented_ones() {
    assert!(MINIMAL.lines().count() <= 12);
    let case = parsed(MINIMAL, &[]);
    let model = case.model();
    assert_eq!(case.name, "case");
    assert_eq!((model.blank.elements, model.blank.layers), (100, 5));
    assert_eq!((model.blank.grading, model.blank.theory), (Grading::Radii, Theory::Bending));
    assert_eq!(model.settings, stampflow::model::Settings::default());
    assert_eq!(model.frames, [6.25, 12.5, 18.75, 25.0]);
    assert_eq!(model.speed, 1.0);
    let holder = model.tool(Role::Holder).unwrap();
    assert_eq!((holder.friction, &holder.motion), (0.08.into(), &Motion::Pressed(Press::constant(10_000.0))));
}

/// Trust: by hand. 2600 N/mm over 500 mm are 1.3 MN, whichever way it is said; springs of 50 N/mm² are 25 kN/mm.
#[test]
fn with_a_depth_forces_are_of_the_whole_part() {
    let holder = |overrides: &[&str]| {
        let model = shipped_case("strip_draw", overrides).model().clone();
        assert_eq!(model.extent(), Extent::Depth(500.0));
        model.tool(Role::Holder).unwrap().motion.clone()
    };
    let depth = "blank.depth=500 mm";
    for force in ["2600 N/mm", "1300 kN"] {
        let press = holder(&[depth, &format!("tools.holder.force={force}")]);
        assert_eq!(press, Motion::Pressed(Press::constant(1.3e6)), "{force}");
    }
    let text = include_str!("../../cases/strip_draw.toml").split("[[compare]]").next().unwrap();
    for stiffness in ["50 N/mm^2", "25 kN/mm"] {
        let spring = format!("spring = {{ preload = \"10 kN\", stiffness = \"{stiffness}\" }}");
        let case = parsed(&text.replace("force = \"2600 N/mm\"", &spring), &[depth]);
        let model = case.model();
        let press = Motion::Pressed(Press { force: 10e3.into(), stiffness: 25e3 });
        assert_eq!(model.tool(Role::Holder).unwrap().motion, press, "{stiffness}");
    }
}

#[test]
fn overrides_take_toml_values_and_bare_text() {
    let overrides = [
        "tools.punch.friction=0.1",
        "blank.thickness=0.9 mm",
        "blank.radius=\"52 mm\"",
        "solver.iteration=newton",
        "output.count = 2",
        "title=Another cup",
    ];
    let case = shipped_case("quickstart", &overrides);
    let model = case.model();
    assert_eq!(model.tool(Role::Punch).unwrap().friction, 0.1.into());
    assert_eq!((model.blank.thickness, model.blank.length), (0.9, 52.0));
    assert_eq!(model.settings.iteration, stampflow::model::Iteration::Newton);
    assert_eq!(model.frames.len(), 2);
    assert_eq!(model.title, "Another cup");
    assert_eq!(parsed(&case.text, &[]).model(), case.model(), "the text repeats the run");
    let woo = shipped_case("woo_hemispherical", &["material.hardening.piecewise_power.branches.0.n=0.5045"]);
    assert_ne!(woo.model().material, shipped_case("woo_hemispherical", &[]).model().material);
}

/// All that is needed is read with the case: the shipped ones give the same where there is no disk.
#[test]
fn a_case_can_be_read_from_memory() {
    let (mut memory, cases) = (Memory::default(), files("cases", "toml"));
    let all = [files("cases", ""), files("reference_data", "")].concat();
    for path in all.into_iter().filter(|path| path.is_file()) {
        memory.insert(&path, std::fs::read(&path).unwrap());
    }
    assert!(cases.len() >= 19, "{cases:?}");
    let mut beside = 0;
    for path in cases {
        let text = std::fs::read_to_string(&path).unwrap();
        let read = |files: &dyn Files| case::parse_with(&text, path.to_str().unwrap(), &[], files);
        let case = loaded(&path, &[]);
        assert_eq!(read(&memory).unwrap_or_else(|error| panic!("{}", error.render(false))), case);
        if read(&Memory::default()).is_err() {
            beside += 1;
        }
    }
    assert!(beside >= 6, "{beside} cases need a file beside them");
}

/// Reads a case whose punch is `a.csv`, or whose sheet's temperature or reference is.
fn with_csv(what: &str, csv: impl Into<Vec<u8>>) -> Result<Case, String> {
    let text = match what {
        "profile" => MINIMAL.replace(r#"flat = { radius = "30 mm", nose = "6 mm" }"#, r#"profile = "a.csv""#),
        "temperature" => format!("{MINIMAL}[heat]\ninitial = \"a.csv\"\n"),
        _ => format!(
            "{MINIMAL}[[compare]]\nreference = \"a.csv\"\nquantity = \"punch_force\"\nx = \"travel_mm\"\n\
             y = \"punch_force_kN\"\ntolerance = \"5 %\"\nreason = \"a test\"\n"
        ),
    };
    let mut files = Memory::default();
    files.insert("cases/a.csv", csv);
    case::parse_with(&text, "cases/cup.toml", &[], &files).map_err(|error| error.render(false).replace("\n  │ ", " "))
}

/// Gone through once: from the first line anew for each line, one of these files alone would take a minute.
#[test]
fn long_files_beside_a_case_are_read_or_refused_by_their_length() {
    let rows = |n: usize| (0..n).map(move |i| i as f64 * 55.0 / n as f64);
    let points: String = rows(50_000).map(|r| format!("{r},{}\n", -0.01 * r * r)).collect();
    let error = with_csv("profile", format!("r_mm,z_mm\n{points}")).unwrap_err();
    assert!(error.contains("50000 points are more than the 2000") && error.contains("a.csv:50001:1"), "{error}");
    let field: String = rows(50_000).map(|s0| format!("{s0},{}\n", 20.0 + s0)).collect();
    let case = with_csv("temperature", format!("s0_mm,temperature_C\n{field}")).unwrap();
    assert!((case.model().heat.as_ref().unwrap().initial.at(30.0) - 273.15 - 50.0).abs() < 1e-9);
    for what in ["profile", "temperature", "reference"] {
        let many = with_csv(what, format!("a_mm,b_mm\n{}", "1,2\n".repeat(100_001))).unwrap_err();
        assert!(many.contains("there are more than 100000 rows"), "{many}");
        let large = with_csv(what, "a_mm,b_mm\n".repeat(1_000_001)).unwrap_err();
        assert!(large.contains("\"a.csv\" cannot be read: it is larger than 10 MB"), "{large}");
    }
}

/// Trust: half of a diameter, and thicknesses times 1 mm, by hand.
#[test]
fn diameters_and_lengths_in_thicknesses_are_radii_in_millimetres() {
    let radii = parsed(MINIMAL, &[]);
    let across = MINIMAL
        .replace("blank = { radius = \"55 mm\"", "blank = { diameter = \"110 mm\"")
        .replace("radius = \"55 mm\"", "diameter = \"110 mm\"")
        .replace("flat = { radius = \"30 mm\", nose = \"6 mm\" }", "flat = { diameter = \"60 mm\", nose = \"6 t\" }")
        .replace("throat = \"31.25 mm\", shoulder = \"6 mm\"", "throat_diameter = \"62.5 mm\", shoulder = \"6 t\"")
        .replace("inner_radius = \"32 mm\"", "inner_diameter = \"64 mm\"");
    assert_eq!(across.matches("diameter").count(), 4, "{across}");
    assert_eq!(parsed(&across, &[]).model(), radii.model());
    let set = shipped_case("quickstart", &["blank.diameter=104 mm"]);
    let pressed = shipped_case("quickstart", &["tools.holder.pressure=2 MPa"]);
    assert!(pressed.text.contains("2 MPa") && !pressed.text.contains("10 kN"), "an override replaces the force");
    assert_eq!(set.model().blank.length, 52.0, "an override replaces the radius");
}

/// Trust: by hand; what a stage does not say is that of the stage before, except that tools which went stand still.
#[test]
fn stages_say_what_changes() {
    let elastic = ["material.young=\"210 GPa\"", "material.poisson=0.3", "blank.layers=25"];
    let text = format!(
        r#"{QUICKSTART}
[[stages]]
name = "back"
punch.move = "-30 mm"
holder = {{ force = "20 N", friction = 0.2 }}
[[stages]]
name = "open"
trim = "40 mm"
anneal = true
die = {{ move = "3 mm", aside = "4 mm" }}
remove = ["holder"]
edge = "clamped"
duration = "2 s"
frames = 2
[[stages]]
name = "redraw"
punch = {{ hemispherical = {{ radius = "20 mm" }}, move = "5 mm" }}
speed = "10 mm/s"
edge = "free"
[[stages]]
name = "free"
release = "constant"
"#
    );
    let stages = parsed(&text, &elastic[..2]).stages;
    let names: Vec<&str> = stages.iter().map(|stage| stage.name.as_str()).collect();
    assert_eq!(names, ["forming", "back", "open", "redraw", "free"]);
    // Spring-back asks for more points through the thickness than the flow law alone, and for points on the faces.
    let mut alone = shipped_case("quickstart", &elastic).model().clone();
    assert_eq!(alone.blank.rule, ThicknessRule::Parts);
    alone.blank.rule = ThicknessRule::Lobatto;
    assert_eq!(stages[0].model, alone);
    let motion = |i: usize, role| stages[i].model.tool(role).map(|tool| tool.motion.clone());
    let path = |axial, aside| Some(Motion::Path(Point::new(aside, axial)));

    assert_eq!(motion(1, Role::Punch), path(-30.0, 0.0));
    assert_eq!(motion(1, Role::Die), Some(Motion::Fixed));
    let Some(Motion::Pressed(press)) = motion(1, Role::Holder) else { panic!("a pressed holder") };
    assert_eq!([0.0, 3.0, 6.0, 30.0].map(|travel| press.force.at(travel)), [10_000.0, 5010.0, 20.0, 20.0]);
    assert_eq!(stages[1].model.tool(Role::Holder).unwrap().friction, 0.2.into());
    assert_eq!((stages[1].model.travel, stages[1].model.duration, stages[1].model.speed), (30.0, 30.0, 1.0));

    let open = &stages[2];
    assert_eq!((motion(2, Role::Punch), motion(2, Role::Die)), (Some(Motion::Fixed), path(3.0, 4.0)));
    assert_eq!(motion(2, Role::Holder), None);
    assert_eq!((open.begin.trim, open.begin.anneal, open.model.blank.edge), (Some(40.0), true, Edge::Clamped));
    assert_eq!((open.model.travel, open.model.duration, &open.model.frames[..]), (5.0, 2.0, &[1.0, 2.0][..]));

    let redraw = &stages[3];
    assert_eq!((&redraw.begin.meets[..], redraw.begin.trim, redraw.begin.anneal), (&[Role::Punch][..], None, false));
    assert_eq!((redraw.model.duration, redraw.model.blank.edge), (0.5, Edge::Free));
    assert_ne!(redraw.model.tools[0].profile, stages[0].model.tools[0].profile);
    assert_eq!(redraw.model.tools[0].friction, 0.08.into());

    assert_eq!(stages[4].model.release, Some(ReleaseStiffness::Constant));
    assert_eq!(stages[4].model.mode, Mode::Elastic);
    assert!(stages[4].model.tools.iter().all(|tool| tool.motion == Motion::Fixed));
    assert_eq!((stages[4].model.travel, stages[4].model.duration), (0.0, 1.0));
    assert!(stages[..4].iter().all(|stage| stage.model.release.is_none() && stage.model.mode == Mode::Flow));

    let elastic = text.replace(
        "[material.hardening",
        "[material]\nyoung = \"210 GPa\"\npoisson = 0.3\nmode = \"elasto_viscoplastic\"\n[material.hardening",
    );
    let case = parsed(&elastic.replace("name = \"redraw\"", "name = \"redraw\"\nmode = \"elastic\""), &[]);
    let modes: Vec<Mode> = case.stages.iter().map(|stage| stage.model.mode).collect();
    let elastoplastic = Mode::ElastoViscoplastic;
    assert_eq!(modes, [elastoplastic, elastoplastic, elastoplastic, Mode::Elastic, Mode::Elastic]);
}

fn kind(read: io::Result<Vec<u8>>) -> ErrorKind {
    read.expect_err("refused").kind()
}

#[test]
fn paths_in_memory_are_the_same_however_they_are_written() {
    let mut files = Memory::default();
    files.insert("cases/../data/./a.csv", "1");
    files.insert("../up.csv", "2");
    for (path, found) in [("data/a.csv", "1"), ("./data/b/../a.csv", "1"), ("x/../../up.csv", "2")] {
        assert_eq!(files.read(Path::new(path), 1).unwrap(), found.as_bytes(), "{path}");
    }
    assert_eq!(kind(files.read(Path::new("up.csv"), 1)), ErrorKind::NotFound);
    assert_eq!(kind(files.read(Path::new("../up.csv"), 0)), ErrorKind::FileTooLarge);
}

#[test]
fn the_disk_gives_whole_files_and_refuses_the_rest() {
    let folder = temp_dir::TempDir::new().unwrap();
    let path = folder.path().join("a");
    fs::write(&path, "12345").unwrap();
    assert_eq!(Disk.read(&path, 5).unwrap(), b"12345");
    assert_eq!(kind(Disk.read(&path, 4)), ErrorKind::FileTooLarge);
    assert_eq!(kind(Disk.read(folder.path(), 4)), ErrorKind::IsADirectory);
    assert_eq!(kind(Disk.read(&folder.path().join("b"), 4)), ErrorKind::NotFound);
    // Nothing of it is read: its length is enough.
    File::create(&path).and_then(|file| file.set_len(1 << 42)).unwrap();
    assert_eq!(kind(Disk.read(&path, 50_000_000)), ErrorKind::FileTooLarge);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn overrides_never_panic(key in "[a-z.]{0,12}|tools.punch.[a-z]{0,8}", value in "\\PC{0,12}") {
        if let Err(error) = case::parse(QUICKSTART, "case.toml", &[format!("{key}={value}")]) {
            let _ = error.render(false);
        }
    }
}
