//! Searches: limits of known functions with noise, islands and failed trials; conditions; the searches that have a name.

use crate::common::cli::{stampflow, text};
use stampflow::study::search::{
    Aim, Answer, Bracket, Condition, Found, Goal, Line, Quest, Said, Side, Target, Template, Wanted, bracket,
};
use stampflow::study::{Bars, Row, Span, StudyError, Subject, base, one};
use std::cell::Cell;

const CASE: &str = "cases/quickstart.toml";

/// The span 0 to 100, known within 0.5, two trials at once.
fn found(aim: Aim, says: impl Fn(f64) -> Option<f64>) -> (Bracket, usize) {
    let runs = Cell::new(0);
    let line = Line {
        at: &|way| (1e3 * way).round() / 10.0,
        share: &|x| x / 100.0,
        tolerance: &|_| 0.5,
        places: 9,
        at_once: 2,
    };
    let bracket = bracket(&line, aim, &mut |values| {
        runs.set(runs.get() + values.len());
        Some(values.iter().map(|x| says(*x)).collect())
    });
    (bracket, runs.get())
}

fn holds(is: bool) -> Option<f64> {
    Some(if is { 1.0 } else { -1.0 })
}

fn between(bracket: &Bracket) -> [f64; 2] {
    let Found::Between(ends) = bracket.found else { panic!("{bracket:?}") };
    ends
}

/// Trust: the limit is given.
#[test]
fn the_limit_of_a_step_lies_in_a_bracket_as_narrow_as_is_asked_for() {
    for limit in [3.3, 37.21, 50.0, 87.4, 99.2] {
        let (largest, runs) = found(Aim::Edge(Side::Largest), |x| holds(x <= limit));
        let [inner, outer] = between(&largest);
        assert!(inner <= limit && limit < outer && outer - inner <= 0.5 + 1e-9, "{limit}: {inner} {outer}");
        // 9 places, three rounds of two that divide 12.5 by 3 each time, four beside.
        assert!(runs <= 9 + 6 + 4, "{runs} runs");
        assert_eq!(largest.mixed, None);
        let (smallest, _) = found(Aim::Edge(Side::Smallest), |x| holds(x > limit));
        let [inner, outer] = between(&smallest);
        assert!(outer <= limit && limit < inner && inner - outer <= 0.5 + 1e-9, "{limit}: {inner} {outer}");
    }
}

/// Trust: two stretches, the second of which a bisection between the ends would not see.
#[test]
fn a_condition_that_comes_and_goes_is_told_with_all_its_stretches() {
    let says = |x: f64| holds((10.0..=40.0).contains(&x) || (60.0..=80.0).contains(&x));
    let (largest, _) = found(Aim::Edge(Side::Largest), says);
    let [inner, outer] = between(&largest);
    assert!(inner <= 80.0 && outer > 80.0);
    assert_eq!(largest.stretches.len(), 2, "{:?}", largest.stretches);
    let [inner, outer] = between(&found(Aim::Edge(Side::Smallest), says).0);
    assert!(outer < 10.0 && inner >= 10.0);
    // A stretch between the first places is found by the second look.
    let [inner, outer] = between(&found(Aim::Edge(Side::Largest), |x| holds((17.0..=22.0).contains(&x))).0);
    assert!(inner <= 22.0 && outer > 22.0);
}

/// Trust: the answer changes back and forth within 2 of the limit and nowhere else: whatever holds lies below limit + 2, what does
/// not above limit − 2, and both are half apart. Four widths of the bracket are seen more often than not by four looks beside it.
#[test]
fn noise_about_a_limit_is_told_and_the_answer_lies_within_it() {
    let noise = |x: f64| 2.0 * ((x * 7919.0).sin() * 43_758.545).fract();
    let mut told = 0;
    for i in 0..100 {
        let limit = 20.0 + 0.6237 * f64::from(i);
        let (largest, runs) = found(Aim::Edge(Side::Largest), |x| holds(x + noise(x) <= limit));
        let [inner, outer] = between(&largest);
        assert!((inner - limit).abs() <= 2.5 && outer - inner <= 0.5 + 1e-9, "{limit}: {inner} {outer}");
        assert!(runs <= 40, "{runs} runs");
        told += usize::from(largest.mixed.is_some());
        let is_within =
            |mixed: &std::ops::RangeInclusive<f64>| limit - mixed.start() <= 4.5 && mixed.end() - limit <= 4.5;
        assert!(largest.mixed.as_ref().is_none_or(is_within), "{limit}: {:?}", largest.mixed);
    }
    assert!(told >= 50, "{told} of 100 are told");
}

/// Trust: trials in the last two thirds of every tenth fail; a limit outside such a stretch is found all the same.
#[test]
fn a_failed_trial_is_neither_and_others_are_tried_beside_it() {
    let says = |x: f64| if (x * 10.0) as i64 % 7 < 3 { None } else { holds(x <= 61.0) };
    let [inner, outer] = between(&found(Aim::Edge(Side::Largest), says).0);
    assert!(inner <= 61.0 && outer > 61.0 && outer - inner <= 1.5, "{inner} {outer}");
    assert_eq!(found(Aim::Edge(Side::Largest), |_| None).0.found, Found::Failed);
    let open = found(Aim::Edge(Side::Largest), |x| if x > 50.0 { None } else { holds(true) }).0;
    assert_eq!(open.found, Found::Open(50.0));
}

/// Trust: nothing to find.
#[test]
fn a_condition_that_holds_everywhere_or_nowhere_is_told() {
    assert_eq!(found(Aim::Edge(Side::Largest), |_| holds(true)).0.found, Found::Everywhere(100.0));
    assert_eq!(found(Aim::Edge(Side::Smallest), |_| holds(true)).0.found, Found::Everywhere(0.0));
    assert_eq!(found(Aim::Edge(Side::Largest), |_| holds(false)).0.found, Found::Nowhere);
    assert_eq!(found(Aim::Crossing(Side::Smallest), |x| Some(1.0 + x)).0.found, Found::Nowhere);
    let mut asked = 0;
    let line = Line { at: &|way| way, share: &|x| x, tolerance: &|_| 0.01, places: 5, at_once: 1 };
    let ended = bracket(&line, Aim::Edge(Side::Largest), &mut |values| {
        asked += 1;
        (asked < 3).then(|| values.iter().map(|x| holds(*x < 0.3)).collect())
    });
    assert_eq!(ended.found, Found::Interrupted);
    assert!(ended.trials.len() >= 5, "what was done is kept");
}

/// Trust: roots by hand; the secant takes fewer trials than sections do.
#[test]
fn a_smooth_number_crosses_where_its_root_is() {
    for root in [12.0f64, 47.3, 93.1] {
        let (crossing, runs) = found(Aim::Crossing(Side::Smallest), |x| Some(x.powi(3) - root.powi(3)));
        let [a, b] = between(&crossing);
        assert!((a - root) * (b - root) <= 0.0 && (b - a).abs() <= 0.5, "{root}: {a} {b}");
        assert!(runs <= 9 + 4 + 4, "{root}: {runs} runs");
    }
    let parabola = |x: f64| Some((x - 20.0) * (x - 70.0));
    let [a, b] = between(&found(Aim::Crossing(Side::Smallest), parabola).0);
    assert!(a.min(b) <= 20.0 && a.max(b) >= 20.0);
    let [a, b] = between(&found(Aim::Crossing(Side::Largest), parabola).0);
    assert!(a.min(b) <= 70.0 && a.max(b) >= 70.0);
}

/// Coarse runs of the quickstart's cup.
fn subject(set: &[&str]) -> Subject {
    let coarse = ["blank.elements=30", "solver.max_step=0.05"];
    Subject::new(CASE, coarse.iter().chain(set).map(|s| (*s).to_owned()).collect()).expect("a case")
}

fn row(set: &[&str]) -> Row {
    let subject = subject(&[]);
    let settings = set.iter().map(|s| (*s).to_owned()).collect();
    one(&subject, stampflow::study::Design { index: 0, values: Vec::new(), settings }, Bars::Without, &())
}

fn judged(row: &Row, condition: &str) -> Said {
    Condition::read(condition).expect(condition).judge(row)
}

/// Trust: the quickstart is amber for its friction, thins by 5.9 %, has a punch force of 45 kN, draws in 12.8 mm.
#[test]
fn conditions_are_judged_by_lights_and_numbers_with_their_units() {
    let sound = row(&[]);
    for (condition, expected) in [
        ("no red", Said::Holds),
        ("no red or amber", Said::Fails),
        ("wrinkling not red", Said::Holds),
        ("friction is not red or amber", Said::Fails),
        ("no tear", Said::Holds),
        ("thinning < 20 %", Said::Holds),
        ("thinning < 3 %", Said::Fails),
        ("punch_force <= 60 kN", Said::Holds),
        ("Punch force > 10 tonf and draw_in >= 8 mm", Said::Fails),
        ("no red and punch_force_N >= 40 kN and draw_in < 0.6 in", Said::Holds),
    ] {
        assert_eq!(judged(&sound, condition), expected, "{condition}");
    }
    let torn = row(&["blank.diameter=160 mm", "tools.punch.travel=60 mm"]);
    assert_eq!(judged(&torn, "no tear"), Said::Fails);
    assert_eq!(
        judged(&torn, "punch_force <= 600 kN"),
        Said::Fails,
        "a number of a sheet that tore is none of the part"
    );
    let none = row(&["tools.die.throat=20 mm"]);
    assert!(matches!(judged(&none, "no red"), Said::Neither(why) if why.to_string().contains("throat")));
}

/// Trust: each is wrong in the way that its message says.
#[test]
fn wrong_searches_are_told_before_anything_is_searched() {
    let subject = subject(&[]);
    let wrong = |text: &str| {
        let error = Condition::read(text).and_then(|condition| condition.check(&base(&subject, Bars::Without, &())?));
        error.expect_err(text).to_string()
    };
    for (text, said) in [
        ("red", "no condition"),
        ("thinning", "no condition"),
        ("thinnning < 20 %", "did you mean `thinning`"),
        ("thinning < 20", "in %"),
        ("thinning < 20 mm", "in %, not a length"),
        ("punch_force < 60 kNN", "kNN"),
        ("wrinkles not red", "no row `wrinkles`"),
    ] {
        assert!(wrong(text).contains(said), "{text}: {}", wrong(text));
    }
    let span = |text: &str| Span::read(text, &subject);
    for (text, said) in [
        ("blank.diameter=90..140", "unit"),
        ("blank.diameter=90 mm", "no range"),
        ("blank.diameter=90..140 mm/2", "2 places"),
        ("blank.colour", "no number at `blank.colour`"),
        ("blank.diameter=0..140 mm log", "logarithms"),
    ] {
        let told = span(text).map(|span| Quest {
            subject: subject.clone(),
            span,
            goal: Goal::Keep(Condition::read("no red").expect("a condition")),
            side: Side::Largest,
        });
        let told = told.and_then(|quest| quest.search(1, &())).expect_err(text).to_string();
        assert!(told.contains(said), "{text}: {told}");
    }
    let about = span("blank.diameter").expect("about 110 mm");
    assert_eq!(about.difference(-0.02).to_string(), "0.02 mm");
    assert_eq!(about.ends(), [55.0, 220.0]);
    assert!(about.within("3 kN").is_err_and(|error| error.to_string().contains("tolerance")));
    assert!(Target::read("draw_in").is_err());
}

/// What a template finds on a case.
fn searched(name: &str, case: &str, set: &[&str], target: Option<&str>) -> Result<(Quest, Answer), StudyError> {
    let set: Vec<String> = set.iter().map(|s| (*s).to_owned()).collect();
    let draft = Template::named(name)?.draft(&Subject::new(case, set.clone())?.case(&[])?)?;
    let subject = Subject::new(case, draft.settings.into_iter().chain(set).collect())?;
    let goal = match (draft.goal, target) {
        (Wanted::Condition(condition), _) => Goal::Keep(Condition::read(condition)?),
        (Wanted::Number(number), target) => Goal::Reach(Target::read(&format!("{number}={}", target.unwrap_or("")))?),
    };
    let side = if draft.is_smallest { Side::Smallest } else { Side::Largest };
    let quest = Quest { span: Span::read(&draft.vary, &subject)?, subject, goal, side };
    let answer = quest.search(2, &())?;
    Ok((quest, answer))
}

const COARSE: [&str; 2] = ["blank.elements=40", "solver.max_step=0.02"];

/// Trust: Siebel's force for the quickstart's cup, 5.5 kN, is what its verdict advises; a bead that lets as much in as is
/// wanted, within a hundredth; a tool that cannot be had is told.
#[test]
fn searches_that_have_a_name_take_what_they_need_from_the_case() {
    let (_, holder) = searched("least-holder-force", CASE, &COARSE, None).expect("a search");
    let force = holder.value(holder.best.expect("found"));
    let beside = holder.value(holder.other.expect("the other side"));
    assert!(beside < force && force < 1.05 * beside, "{beside} {force}");
    let red = |run: usize| holder.rows[run].result.as_ref().expect("solved").amber.contains(&"wrinkling");
    assert!(red(holder.other.expect("found")) && !red(holder.best.expect("found")));

    let (_, bead) = searched("bead-force", "cases/hydroform.toml", &COARSE, Some("10 mm")).expect("a search");
    let best = bead.rows[bead.best.expect("found")].result.as_ref().expect("solved");
    assert!((best.number("draw_in_mm").expect("drawn in") - 10.0).abs() < 0.1);

    let (_, radius) = searched("smallest-radius", CASE, &COARSE, None).expect("a search");
    assert!(matches!(radius.bracket.found, Found::Between([inner, outer]) if outer < inner && inner < 6.0));

    for (name, case, said) in [
        ("bead-force", CASE, "needs a bead"),
        ("over-bend", CASE, "takes the tools away"),
        ("least-holder-force", "cases/hydroform.toml", "a holder with a force"),
        ("limiting-draw-ratio", "cases/strip_draw.toml", "axisymmetric"),
        ("greatest-width", CASE, "choose one of limiting-draw-ratio"),
    ] {
        let error = searched(name, case, &[], Some("10 mm")).expect_err(name).to_string();
        assert!(error.contains(said), "{name}: {error}");
    }
}

/// Trust: what the page says is what the command prints; a mistake has its code and names what to write.
#[test]
fn the_program_searches_writes_its_table_and_picture_and_tells_mistakes() {
    let folder = temp_dir::TempDir::new().expect("a folder");
    let out = folder.path().to_str().expect("a name");
    let coarse = ["--set", "blank.elements=40", "--set", "solver.max_step=0.02", "--out", out, "--no-error-bars"];
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let run = |args: &[&str]| stampflow(root, &[&["search", CASE], args, &coarse].concat());
    let search = |args: &[&str]| {
        let ended = run(args);
        assert!(ended.status.success(), "{args:?}: {}", text(&ended.stderr));
        text(&ended.stdout).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let said = search(&["--vary", "blank.diameter=100..150 mm", "--largest", "--while", "thinning < 10 %"]);
    assert!(said.contains("Blank diameter: “thinning < 10 %” holds up to 12"), "{said}");
    let table = std::fs::read_to_string(folder.path().join("search.csv")).expect("a table");
    assert!(table.starts_with("study,designs,index,inputs_sha256,blank.diameter_mm,"), "{table}");
    assert!(folder.path().join("search.png").exists());
    let german =
        search(&["--vary", "blank.diameter=100..150 mm", "--largest", "--while", "thinning < 10 %", "--lang", "de"]);
    assert!(german.contains("ist bis 12") && german.contains("Stempelkraft"), "{german}");
    let best = search(&[
        "--vary",
        "tools.die.shoulder=5..9 mm",
        "--vary",
        "friction=0.04..0.12",
        "--minimise",
        "punch_force",
        "--while",
        "thinning < 8 %",
        "--json",
    ]);
    let best: serde_json::Value = serde_json::from_str(&best).expect("JSON");
    // A force falls with friction and with a rounder shoulder: the corner of both spans.
    assert_eq!(best["values"], serde_json::json!({ "tools.die.shoulder_mm": 9.0, "friction": 0.04 }));
    for (args, said) in [
        (&["--vary", "blank.diameter=90..140 mm", "--while", "no red"][..], "--largest or --smallest"),
        (&["--vary", "blank.diameter=90..140 mm", "--largest"], "--while"),
        (&["--largest", "--while", "no red"], "nothing to vary"),
        (&["--for", "over-bend"], "takes the tools away"),
        (&["--vary", "blank.diametre=90..140 mm", "--largest", "--while", "no red"], "diametre"),
    ] {
        let ended = run(args);
        let error = text(&ended.stderr);
        assert!(ended.status.code() == Some(2) && error.contains(said), "{args:?}: {error}");
    }
}

/// A loss of power keeps what was run. Trust: the table at the end, but for how many designs there were then.
#[test]
fn the_table_grows_with_every_run() {
    let subject = Subject::new(CASE, vec!["blank.elements=40".into(), "solver.max_step=0.02".into()]).expect("a case");
    let span = Span::read("blank.diameter=100..120 mm/4 log", &subject).expect("a span");
    let goal = Goal::Keep(Condition::read("thinning < 8 %").expect("a condition"));
    let quest = Quest { subject, span, goal, side: Side::Largest };
    let (mut headers, mut lines) = (Vec::new(), Vec::new());
    let keep = &mut |header: &[String], line: &[String]| {
        headers.push(header.to_vec());
        lines.push(line.to_vec());
    };
    let answer = quest.search_keeping(2, &(), keep).expect("an answer");
    let (header, table) = answer.table();
    assert!(headers.iter().all(|own| own == header) && table.len() == answer.rows.len());
    for (i, (line, own)) in lines.iter_mut().zip(table).enumerate() {
        assert_eq!((line[1].as_str(), own[1].as_str()), (&*(i + 1).to_string(), &*table.len().to_string()));
        line[1].clone_from(&own[1]);
    }
    assert_eq!(lines, table);
    let chart = stampflow::output::study::search::plot(&quest, &answer).expect("a picture");
    let x = &chart.panels[0].x;
    let places =
        || chart.panels[0].series.iter().flat_map(|series| &series.points).map(|point| x.spacing.value(point.0));
    assert!(x.spacing.is_logarithmic() && x.text() == "Blank diameter [mm]", "{}", x.text());
    assert!(places().all(|value| (99.9..120.1).contains(&value)), "values of the span, at their logarithms");
}

/// Trust: a signal as Ctrl-C sends it, in the middle of a thousand runs.
#[cfg(unix)]
#[test]
fn an_interrupted_search_keeps_what_was_run() {
    let folder = temp_dir::TempDir::new().expect("a folder");
    let mut running = std::process::Command::new(env!("CARGO_BIN_EXE_stampflow"))
        .args(["search", CASE, "--vary", "blank.diameter=90..140 mm/1000", "--largest", "--while", "no red"])
        .args(["--set", "blank.elements=40", "--quiet", "--out"])
        .arg(folder.path())
        .stdout(std::process::Stdio::null())
        .spawn()
        .expect("begun");
    let [table, part] = ["search.csv", ".search.csv.part"].map(|name| folder.path().join(name));
    while std::fs::read_to_string(&part).map_or(0, |rows| rows.lines().count()) < 3 {
        assert!(running.try_wait().expect("a process").is_none(), "it has ended");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let told = std::process::Command::new("kill").args(["-INT", &running.id().to_string()]).status();
    assert!(told.expect("a signal").success());
    assert_eq!(running.wait().expect("ended").code(), Some(130));
    let table = std::fs::read_to_string(table).expect("a table");
    let rows = table.lines().count() - 1;
    assert!(rows < 1000 && table.lines().all(|line| line.contains(',')), "{rows} rows");
    assert!(!part.exists());
}

/// Trust: the run in one go; of what was killed the rows are those of it, but for how many designs there were then, and the next
/// search begins anew.
#[cfg(unix)]
#[test]
fn a_search_that_was_killed_leaves_whole_rows_beside_the_table_of_an_earlier_one() {
    let folder = temp_dir::TempDir::new().expect("a folder");
    let [table, part] = ["search.csv", ".search.csv.part"].map(|name| folder.path().join(name));
    let search = |places: usize| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_stampflow"));
        command.args(["search", CASE, "--largest", "--while", "no red", "--quiet", "--no-error-bars"]);
        command.args(["--vary", &format!("blank.diameter=90..140 mm/{places}"), "--set", "blank.elements=30", "--out"]);
        command.arg(folder.path()).stdout(std::process::Stdio::null());
        command
    };
    assert!(search(3).status().expect("run").success());
    let earlier = std::fs::read(&table).expect("a table");
    let mut running = search(1000).spawn().expect("begun");
    let begun = std::time::Instant::now();
    let rows = || std::fs::read_to_string(&part).map_or(0, |text| text.matches('\n').count());
    while rows() < 5 {
        assert!(begun.elapsed().as_secs() < 120, "no rows");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    running.kill().expect("killed");
    running.wait().expect("ended");
    assert_eq!(std::fs::read(&table).expect("a table"), earlier, "whole or not at all");
    let left = std::fs::read_to_string(&part).expect("rows");
    let earlier = String::from_utf8(earlier).expect("text");
    let fields = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(left.lines().next(), earlier.lines().next());
    // The first of the 1000 places is the first of the three.
    let [first, own] = [&left, &earlier].map(|text| fields(text.lines().nth(1).expect("a row")));
    assert_eq!((&first[2], &first[4..]), (&own[2], &own[4..]));
    assert!(search(3).status().expect("run").success());
    assert_eq!(std::fs::read_to_string(&table).expect("a table"), earlier);
    assert!(!part.exists());
}

/// Trust: a step from 4.5 to 5.5 at 30.3 misses 5 by half, and beside it the number goes with a thousandth of the key, 0.03 there. A line meets it.
#[test]
fn a_step_past_the_target_is_told_from_a_line() {
    let step = |x: f64| Some(if x < 30.3 { 4.5 } else { 5.5 } + 1e-3 * x - 5.0);
    let (bracket, _) = found(Aim::Crossing(Side::Smallest), step);
    let [before, behind] = bracket.jump(between(&bracket)[0]).expect("a step");
    assert!((before + 0.47).abs() < 1e-2 && (behind - 0.53).abs() < 1e-2, "{before} {behind}");
    let (bracket, _) = found(Aim::Crossing(Side::Smallest), |x| Some(x - 30.3));
    assert_eq!(bracket.jump(between(&bracket)[0]), None);
}

/// Trust: elements are counted; half a millimetre is none too small a step of a diameter.
#[test]
fn a_key_of_whole_numbers_is_tried_at_whole_numbers() {
    let subject = subject(&[]);
    let whole = Span::read("blank.elements=40..120", &subject).expect("a span");
    assert!((1..64).all(|i| whole.at(f64::from(i) / 64.0).fract() == 0.0));
    let plain = Span::read("friction=0..1", &subject).expect("a span");
    assert!(plain.at(0.3) > 0.0 && plain.at(0.3) < 1.0);
}
