//! Sweeps as a user runs them: pictures, distances, error bars, one key at a time, kept curves; the same bytes after any end.

use crate::common::cli::{CUP, folder, stampflow, text};
use serde_json::Value;
use stampflow::output::study::{kept_loads, load_file, pictures, thickness_file};
use stampflow::results::svg;
use stampflow::study::verify::{Of, quick};
use stampflow::study::{Bars, Designs, How, Meets, Plan, Results, Said, Solved, Vary, Zone, base, swings, windows};
use std::fs;
use std::path::Path;

/// A coarse cup that wrinkles, is sound or asks too much of its press as the holder presses harder.
const PRESS: &str = "\n[press]\nforce = \"65 kN\"\n";

fn cup() -> temp_dir::TempDir {
    folder(&CUP.replace("travel = \"5 mm\"", "travel = \"15 mm\"").replace("[tools]", &format!("{PRESS}[tools]")))
}

fn run(dir: &Path, args: &[&str]) -> String {
    let done = stampflow(dir, &[&["sweep", "cases/cup.toml", "--quiet"], args].concat());
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    text(&done.stdout).to_owned()
}

fn plan(dir: &Path, varied: &[&str]) -> Plan {
    let axes = varied.iter().map(|text| Vary::together(text)).collect::<Result<_, _>>().expect("axes");
    Plan::new(dir.join("cases/cup.toml"), Vec::new(), axes).expect("a plan")
}

/// A sweep of the cup and what it found, read back.
fn studied(varied: &[&str], how: How, bars: Bars, look: impl Fn(&Results)) {
    let dir = cup();
    let plan = plan(dir.path(), varied).made(how);
    let mut args: Vec<&str> = varied.iter().flat_map(|text| ["--vary", text]).collect();
    args.extend((how == How::OneAtATime).then_some("--one-at-a-time"));
    args.extend((bars == Bars::Quick).then_some("--error-bars").or(Some("--no-error-bars")));
    run(dir.path(), &[&args[..], &["--out", "out"]].concat());
    let base: Solved = base(plan.subject(), bars, &()).expect("solved");
    look(&Results::read(&dir.path().join("out/study.csv"), &plan, &base).expect("a table"));
}

const WINDOW: [&str; 2] = ["tools.holder.force=1..31 kN/4", "friction=0.04..0.16/4"];

/// Trust: Siebel's index goes with the inverse of the holder's force, so that the border is where force times index is that
/// of the case over the limit, 2, however far apart the designs stand; the press's border is on the straight line between the
/// designs beside it, by hand from the table, at the friction of the case, which is one of the study's.
#[test]
fn distances_are_those_of_the_closed_form_and_of_a_line_between_designs() {
    studied(&WINDOW, How::Combined, Bars::Without, |results| {
        let windows = windows(results);
        let [window] = &windows[..] else { panic!("one window") };
        assert_eq!(window.own(), Some((10_000.0, 0.08)));
        let distances = window.distances();
        let met: Vec<Meets> = distances.iter().map(|distance| distance.meets).collect();
        assert_eq!(met, [Meets::Failure(Zone::Wrinkles), Meets::Failure(Zone::Press), Meets::End, Meets::End]);
        let index = results.place(Of::Verdict, "wrinkling").expect("an index");
        let own = results.base.outcome.numbers[index].amount.value;
        assert!((distances[0].to - 10_000.0 * own / 2.0).abs() < 1e-3, "{:?}", distances[0]);

        let (place, red, _) = results.limit("press_force").expect("a limit");
        assert_eq!(red, 65_000.0);
        // Friction 0.08 is the second of four, force the slower axis.
        let forces = [1e3, 11e3, 21e3, 31e3];
        let needed: Vec<f64> = (0..4).map(|i| results.rows[4 * i + 1].numbers[place]).collect();
        let i = needed.iter().position(|force| *force > 65e3).expect("one that is too large");
        let by_hand = forces[i - 1] + 10e3 * (65e3 - needed[i - 1]) / (needed[i] - needed[i - 1]);
        // Ram and holder press together: the force itself is the straighter one. The table has nine digits.
        assert!((distances[1].to - by_hand).abs() < 0.1, "{} {by_hand}", distances[1].to);

        let said: Vec<String> = Said::of(results).sentences(results).iter().map(ToString::to_string).collect();
        let all = said.join("\n").replace('\u{a0}', " ");
        for part in ["16 designs: ", "Holder force may fall by 8.1 kN before it would wrinkle", "need a larger press"] {
            assert!(all.contains(part), "{part} in\n{all}");
        }
        let fails: usize = results.rows.iter().filter(|found| !found.is_sound()).count();
        let said = Said::of(results);
        assert_eq!(said.sound + fails, 16);
        assert_eq!(said.fails.iter().map(|(_, count)| count).sum::<usize>(), fails);
    });
}

/// Trust: what a reader looks for, by name.
#[test]
fn a_window_shows_zones_lines_of_thinning_and_the_case() {
    studied(&WINDOW, How::Combined, Bars::Without, |results| {
        let drawn = || {
            let made = pictures(results, "Cup");
            assert_eq!(made.len(), 1);
            (made[0].0, svg(&made[0].1))
        };
        let (stem, english) = drawn();
        assert_eq!(stem, "window");
        for part in [
            "process window, Holder force × Friction",
            "Wrinkles",
            "Press too small",
            "Thinning [%]",
            " %<",
            "The case as it stands",
            "Holder force [kN]",
            "may fall by 8.1 kN before it",
            "passes its limit",
        ] {
            assert!(english.contains(part), "{part}");
        }
    });
}

#[test]
fn one_axis_has_curves_with_bands_and_three_have_a_window_each() {
    studied(&["tools.holder.force=1..41 kN/5"], How::Combined, Bars::Quick, |results| {
        let made = pictures(results, "Cup");
        let (stem, chart) = &made[0];
        assert_eq!(*stem, "curves");
        let svg = svg(chart);
        for part in ["Error band", "Thinning [%]", "Punch force [kN]", "Wrinkles", "Amber", "the case as it stands"] {
            assert!(svg.contains(part), "{part}");
        }
        assert!(chart.panels.len() >= 4);
    });
    let three = ["tools.holder.force=1,41 kN", "friction=0.05,0.15", "tools.die.shoulder=5,6,8 mm"];
    studied(&three, How::Combined, Bars::Without, |results| {
        let made = pictures(results, "Cup");
        assert_eq!((made[0].0, made[0].1.panels.len()), ("windows", 3));
        let svg = svg(&made[0].1);
        for shoulder in ["5 mm", "6 mm", "8 mm"] {
            assert!(svg.contains(&format!("Die shoulder radius {shoulder}")), "{shoulder}");
        }
    });
}

/// Trust: names have no values between them: of two sheets the zones of each reach half-way to its neighbour at most.
#[test]
fn names_stand_beside_each_other() {
    studied(&["material=dc04,dc06", "tools.holder.force=1..31 kN/4"], How::Combined, Bars::Without, |results| {
        let window = &windows(results)[0];
        assert_eq!((window.x, window.y), (1, Some(0)), "names go up");
        let (regions, _) = window.zone(Zone::Wrinkles);
        assert_eq!(regions.len(), 2);
        for (i, region) in regions.iter().enumerate() {
            let points = region.outlines.iter().flatten();
            assert!(points.clone().count() > 3 && points.clone().all(|p| (p.1 - i as f64).abs() < 0.5));
        }
        let svg = svg(&pictures(results, "Cup")[0].1);
        assert!(svg.contains(">dc04<") && svg.contains(">dc06<"));
    });
}

/// Trust: each swing by hand from the table: its key's rows and the case's own; the largest on top of the picture.
#[test]
fn a_tornado_is_sorted_by_how_far_a_key_moves_a_number() {
    let varied = ["friction=0.04,0.16", "tools.die.shoulder=5,8 mm", "tools.holder.force=9,11 kN"];
    studied(&varied, How::OneAtATime, Bars::Without, |results| {
        assert_eq!((results.plan.count(), results.rows.len()), (7, 7));
        assert!(results.plan.design(0).settings.is_empty() && results.plan.design(3).settings.len() == 1);
        let place = results.place(Of::Answer, "punch_force").expect("a force");
        let number = |row: usize| results.rows[row].numbers[place];
        let width = |rows: [usize; 3]| {
            let all = rows.map(number);
            all.iter().copied().fold(f64::MIN, f64::max) - all.iter().copied().fold(f64::MAX, f64::min)
        };
        let by_hand = [width([0, 1, 2]), width([0, 3, 4]), width([0, 5, 6])];
        let found = swings(results, place);
        assert!(found.windows(2).all(|pair| pair[0].width() >= pair[1].width()));
        for swing in &found {
            assert!((swing.width() - by_hand[swing.axis]).abs() < 1e-9);
        }
        assert_eq!(found[0].axis, 0, "friction moves the force most: {found:?}");

        let made = pictures(results, "Cup");
        assert_eq!(made[0].0, "tornado");
        let panel = made[0].1.panels.iter().find(|panel| panel.x.text().starts_with("Punch force")).expect("a panel");
        assert_eq!(panel.y.names.last().map(String::as_str), Some("Friction"), "the uppermost");
        assert!(svg(&made[0].1).contains("Key above where the case stands"));
    });
}

/// Trust: the signs of both moves by hand from the table.
#[test]
fn both_values_of_a_key_are_drawn_where_they_move_a_number_to_one_side() {
    let varied = ["friction=0.04,0.16", "tools.die.shoulder=5,8 mm", "tools.holder.force=9,11 kN"];
    studied(&varied, How::OneAtATime, Bars::Without, |results| {
        let mut stacked = 0;
        for place in 0..results.rows[0].numbers.len() {
            for swing in swings(results, place).iter().filter(|swing| swing.width() > 0.0) {
                let own = results.rows[0].numbers[place];
                let rows = [2 * swing.axis + 1, 2 * swing.axis + 2].map(|row| results.rows[row].numbers[place] - own);
                if rows.iter().any(|moved| !moved.is_finite()) {
                    continue;
                }
                assert_eq!(swing.other.is_some(), rows[0] * rows[1] >= 0.0, "{rows:?}: {swing:?}");
                stacked += usize::from(rows[0] * rows[1] > 0.0);
                let shown = [swing.low, swing.high].into_iter().chain(swing.other).filter(|end| end.value.is_some());
                assert_eq!(shown.count(), 2, "{swing:?}");
            }
        }
        assert!(stacked > 0, "no number that this holds of");
    });
}

fn columns(table: &str, header: &str) -> Vec<String> {
    let mut lines = csv::Reader::from_reader(table.as_bytes());
    let place = lines.headers().expect("headers").iter().position(|own| own == header).expect(header);
    lines.records().map(|record| record.expect("a row")[place].to_owned()).collect()
}

/// Trust: the bars of `quick` on the same case, digit for digit.
#[test]
fn one_axis_has_error_bars_unless_they_are_refused() {
    let dir = cup();
    run(dir.path(), &["--vary", "friction=0.05,0.1", "--out", "with"]);
    run(dir.path(), &["--vary", "friction=0.05,0.1", "--no-error-bars", "--out", "without"]);
    run(dir.path(), &["--vary", "friction=0.05,0.1", "--vary", "tools.holder.force=9,10 kN", "--out", "two"]);
    let read = |name: &str| fs::read_to_string(dir.path().join(name).join("study.csv")).expect("a table");
    assert!(!read("without").contains("_error_") && !read("two").contains("_error_"));
    let with = read("with");
    let case = plan(dir.path(), &["friction=0.05,0.1"]);
    let case = case.subject().case(&["friction=0.1".to_owned()]).expect("a case");
    let bar = quick(&case.solve(&mut ()), &());
    let half = bar.bar(Of::Answer, "punch_force").and_then(|bar| bar.half).expect("a bar");
    let written: f64 = columns(&with, "punch_force_error_N")[1].parse().expect("a number");
    assert!((written - half).abs() < 1e-8 * half, "{written} {half}");
    assert_eq!(columns(&with, "thinning_judged_error_percent").len(), 2);
}

/// Every end leaves the same bytes: one go, killed in the middle of a row and resumed, and three shards put together, with
/// error bars and curves. Trust: bytes.
#[test]
fn resumed_and_merged_studies_are_the_same_bytes_with_bars_and_curves() {
    let dir = cup();
    let args = ["--vary", "friction=0.05..0.1/5", "--keep", "curves", "--out"];
    run(dir.path(), &[&args[..], &["whole"]].concat());
    let whole = fs::read(dir.path().join("whole/study.csv")).expect("a table");
    let curves = kept_loads(&dir.path().join("whole"), 5);
    assert!(curves.iter().all(|curve| curve.len() > 10 && curve.last().is_some_and(|point| point.0 == 15.0)));
    let header = |path| fs::read_to_string(path).expect("a file").lines().next().map(str::to_owned);
    assert_eq!(header(load_file(&dir.path().join("whole"), 4)).as_deref(), Some("travel_mm,punch_force_N"));
    assert_eq!(header(thickness_file(&dir.path().join("whole"), 4)).as_deref(), Some("s0_mm,thickness_mm"));
    assert!(dir.path().join("whole/loads.png").is_file() && dir.path().join("whole/curves.png").is_file());
    let times = fs::read_to_string(dir.path().join("whole/study_times.csv")).expect("times");
    assert!(times.starts_with("index,wall_s\n0,") && times.lines().count() == 6, "{times}");

    let cut = dir.path().join("cut");
    fs::create_dir(&cut).expect("a folder");
    let third = whole.iter().enumerate().filter(|(_, byte)| **byte == b'\n').nth(2).expect("three lines").0;
    fs::write(cut.join(".study.csv.part"), &whole[..third + 40]).expect("what a kill leaves");
    let told = run(dir.path(), &[&args[..], &["cut", "--resume"]].concat());
    assert_eq!(fs::read(cut.join("study.csv")).expect("a table"), whole);
    assert!(told.replace('\n', " ").contains("2 of an earlier run"), "{told}");
    let [early, late] = [0, 4].map(|index| load_file(&cut, index).is_file());
    assert!(!early && late, "only what was run with --keep has curves");

    for shard in ["1/3", "2/3", "3/3"] {
        run(dir.path(), &[&args[..], &["parts", "--shard", shard]].concat());
    }
    let shards = [1, 2, 3].map(|k| format!("parts/study-{k}-of-3.csv"));
    let args = [&["merge"], &shards.each_ref().map(String::as_str)[..], &["--out", "parts/study.csv"]].concat();
    assert_eq!(stampflow(dir.path(), &args).status.code(), Some(0));
    assert_eq!(fs::read(dir.path().join("parts/study.csv")).expect("a table"), whole);
    assert_eq!(kept_loads(&dir.path().join("parts"), 5), curves);
    // What was merged is answered and drawn without a run.
    let json = run(dir.path(), &["--vary", "friction=0.05..0.1/5", "--out", "parts", "--resume", "--json"]);
    let json: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!((&json["designs"], &json["kept"]), (&5.into(), &5.into()));
    assert!(dir.path().join("parts/curves.png").is_file() && json["told"][0].as_str().is_some());
}

#[test]
fn one_at_a_time_is_also_asked_for_by_a_study_file() {
    let dir = cup();
    let study = |more: &str| {
        let text = format!(
            "case = \"cases/cup.toml\"\n{more}\n[vary]\nfriction = [0.05, 0.1]\nblank.radius = \"54..56 mm/3\"\n"
        );
        fs::write(dir.path().join("study.toml"), text).expect("a study");
        stampflow(dir.path(), &["sweep", "study.toml", "--quiet", "--json", "--restart"])
    };
    let count = |more: &str| {
        let done = study(more);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        let json: Value = serde_json::from_slice(&done.stdout).expect("JSON");
        json["designs"].as_u64()
    };
    assert_eq!([count("one_at_a_time = true"), count("")], [Some(5), Some(6)]);
    let wrong = study("one_at_a_time = 3");
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text(&wrong.stderr).contains("neither true nor false"), "{}", text(&wrong.stderr));
}

#[test]
fn what_makes_no_sweep_is_refused() {
    let dir = cup();
    for (args, said) in [
        (&["--vary", "friction=0.05,0.1", "--keep", "everything"][..], "curves"),
        (&["--vary", "friction=0.05,0.1", "--error-bars", "--no-error-bars"], "cannot be used with"),
        (&["--vary", "friction=0.05,0.1", "--format", "bmp"], "svg"),
    ] {
        let done = stampflow(dir.path(), &[&["sweep", "cases/cup.toml"], args].concat());
        assert_eq!(done.status.code(), Some(2), "{args:?}");
        assert!(text(&done.stderr).contains(said), "{said}: {}", text(&done.stderr));
    }
    // A table of bars is no table without them.
    run(dir.path(), &["--vary", "friction=0.05,0.1", "--out", "out"]);
    let args =
        ["sweep", "cases/cup.toml", "--vary", "friction=0.05,0.1", "--no-error-bars", "--out", "out", "--resume"];
    let done = stampflow(dir.path(), &args);
    assert_eq!(done.status.code(), Some(2));
    assert!(text(&done.stderr).contains("rows of another study"), "{}", text(&done.stderr));
}

/// Trust: one value says nothing of what lies beside it; along the key that has several the distances are those of a study of
/// that key alone.
#[test]
fn one_value_by_itself_has_no_borders() {
    let said = |results: &Results| -> Vec<String> {
        Said::of(results).sentences(results).iter().map(|said| said.to_string().replace('\u{a0}', " ")).collect()
    };
    studied(&["friction=0.08"], How::Combined, Bars::Without, |results| {
        let all = said(results).join("\n");
        assert!(all.contains("one value has no borders") && !all.contains("may go to"), "{all}");
        assert!(pictures(results, "Cup").is_empty());
    });
    studied(&["friction=0.08", "tools.holder.force=1..31 kN/4"], How::Combined, Bars::Without, |results| {
        let all = said(results).join("\n");
        assert!(all.contains("Holder force may fall by 8.1 kN"), "{all}");
        assert!(!all.contains("Friction may"), "{all}");
        assert_eq!(pictures(results, "Cup")[0].0, "curves");
    });
}

/// Trust: each study or case is wrong in the way that its message says, at the line that is counted by hand.
#[test]
fn what_is_wrong_with_a_study_is_told_with_its_file_and_line() {
    let dir = cup();
    let refused = |args: &[&str], parts: &[&str]| {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(2), "{}", text(&done.stdout));
        let told = text(&done.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
        parts.iter().for_each(|part| assert!(told.contains(part), "{part} in\n{told}"));
    };
    let head = "case = \"cases/cup.toml\"\n";
    for (study, said) in [
        (format!("{head}[vari]\nfriction = [0.1]\n"), "study.toml, line 2: `vari` is no key of this study"),
        (format!("{head}[vary]\nfriction = \"0.1..0.2\"\n"), "study.toml, line 3: friction: the range"),
        (
            format!("{head}[vary.tools.die]\nshoulder = \"4,,6 mm\"\n"),
            "study.toml, line 3: tools.die.shoulder: a value",
        ),
        ("# of none\ncase = \"nope.toml\"\n".to_owned(), "study.toml, line 2: there is no file nope.toml"),
    ] {
        fs::write(dir.path().join("study.toml"), study).expect("written");
        refused(&["sweep", "study.toml"], &[said]);
    }
    fs::write(dir.path().join("study.toml"), format!("{head}[vary]\nfriction = [0, 5]\n")).expect("written");
    refused(&["run", "study.toml"], &["this is a study, not a case", "stampflow sweep"]);
    refused(&["sweep", "cases/cup.toml"], &["is a case, and nothing of it is varied", "--vary"]);
    fs::write(dir.path().join("latin.toml"), b"title = \"N\xe4pfchen\"\n").expect("written");
    refused(&["run", "latin.toml"], &["is not UTF-8", "save it as UTF-8"]);
    refused(&["sweep", "latin.toml"], &["is not UTF-8", "save it as UTF-8"]);
    let plan = stampflow::study::file::load(&dir.path().join("study.toml"), Vec::new()).expect("two whole numbers");
    assert_eq!(plan.count(), 2);
}
