//! Case files with something wrong in them, two thousand of them: each is refused with a message that says what and
//! where, or it is solved. Nothing panics, nothing runs for ever, nothing eats the memory.
//!
//! The seed is fixed, so that what fails once fails again.

use crate::common::files::files;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::RngSeed;
use roxmltree::Document;
use stampflow::case::{self, Case, CaseError};
use stampflow::model::Model;
use stampflow::model::mesh;
use stampflow::output::{Make, OUTPUTS, StageView, Summary, svg};
use stampflow::solver;
use stampflow::table::Table;
use std::sync::LazyLock;
use std::sync::mpsc::channel;
use std::time::Duration;

/// What the shipped cases do not show: a hardening table, drawn tools with arcs, kept frames, every solver setting.
const DRAWN: &str = r#"
title = "Drawn tools"
geometry = "axisymmetric"
[blank]
radius = "55 mm"
thickness = "1.0 mm"
layers = 7
grading = "uniform"
[material]
young = "210 GPa"
poisson = 0.3
[material.hardening.table]
points = [[0, "150 MPa"], [0.1, "290 MPa"], [0.3, "360 MPa"]]
extrapolation = "slope"
[tools.punch]
profile = [
    { from = ["0 mm", "0 mm"] },
    { to = ["24 mm", "0 mm"] },
    { arc_to = ["30 mm", "-6 mm"], center = ["24 mm", "-6 mm"], turn = "right" },
    { to = ["30 mm", "-200 mm"] },
]
friction = 0.08
travel = "12 mm"
speed = "6 m/min"
[tools.die]
profile = [
    { from = ["200 mm", "0 mm"] },
    { to = ["38 mm", "0 mm"] },
    { to = ["34 mm", "1.6 mm"] },
    { to = ["31.25 mm", "6 mm"] },
    { to = ["31.25 mm", "90 mm"] },
]
friction = 0.08
[tools.holder]
profile = [{ from = ["34 mm", "-50 mm"] }, { to = ["34 mm", "0 mm"] }, { to = ["90 mm", "0 mm"] }]
force = "10 kN"
[solver]
iteration = "primal_dual"
norm = "both"
tolerance = 1e-5
max_iterations = 40
max_step = 0.02
first_step = 0.002
min_step = 1e-4
cutoff_strain = 5e-6
contact_stiffness = "10 GPa"
contact_smoothing = 0.002
slip_speed = 0.01
facets = 20
round_facets = true
[output]
frames = ["3 mm", "6 mm", "9 mm"]
"#;

/// Laws and loads that no shipped case shows: kinematic friction, a punch's history, a holder's
/// history and spring, closing beads, stops.
const LOADED: &str = r#"
title = "Strip with springs, a bead and gas below"
geometry = "plane_strain"
[blank]
half_length = "60 mm"
thickness = "1 mm"
elements = 40
theory = "selective"
[material]
anisotropy = 1.4
[material.rate]
power = { exponent = 0.05, reference = "0.01 /s" }
[material.hardening.ludwik]
initial = "150 MPa"
k = "300 MPa"
n = 0.4
[material.softening]
johnson_cook = { reference = "20 °C", melting = "600 °C", exponent = 1.0 }
[heat]
initial = { punch = "20 °C", flange = "200 °C" }
[friction]
punch_side = { stribeck = { at_rest = 0.15, sliding = 0.05, speed = "2 mm/s", viscous = 0.001 } }
die_side = 0.05
[tools.punch]
flat = { half_width = "30 mm", nose = "6 mm" }
motion = [["0 s", "0 mm"], ["4 s", "4 mm"], ["5 s", "12 mm"]]
[tools.die]
throat = "31.25 mm"
shoulder = "6 mm"
[tools.holder]
inner_half_width = "38 mm"
spring = { preload = "20 N/mm", stiffness = "10 N/mm^2" }
[[tools.beads]]
at = "48 mm"
restraining = "30 N/mm"
closing = "5 N/mm"
[gas.lower]
pressure = [["0 s", "0 MPa"], ["4 s", "0.5 MPa"]]
within = "30 mm"
[solver]
contact = "augmented_lagrangian"
strain_step = 0.05
bend_ratio = 0.03
[stop]
localised = false
load_drop = "30 %"
contact_share = "99 %"
"#;

/// Every shipped case and two that use the rest of the keys.
static CASES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let shipped = files("cases", "toml").into_iter().map(|path| std::fs::read_to_string(path).expect("readable"));
    shipped.chain([DRAWN.to_owned(), LOADED.to_owned()]).collect()
});

/// What is written instead; shown in part when a test fails.
#[derive(Clone)]
struct Words(String);

impl std::fmt::Debug for Words {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:?} ({} bytes)", self.0.chars().take(60).collect::<String>(), self.0.len())
    }
}

/// One thing that is done to a text; an `Index` picks the place.
#[derive(Clone, Debug)]
enum Mutation {
    /// Another number where one stands, its unit left alone.
    Number(Index, Words),
    /// Another content for a text in quotes.
    Quoted(Index, Words),
    /// Another word where a key, a table's name or `true` stands.
    Word(Index, Words),
    DropLine(Index),
    RepeatLine(Index, usize),
    SwapLines(Index, Index),
    Truncate(Index),
    /// A stretch of characters replaced.
    Splice(Index, usize, Words),
    Append(Words),
}

/// The stretches of a text that `wanted` begins and `on` continues.
fn stretches(text: &str, wanted: impl Fn(char) -> bool, on: impl Fn(char) -> bool) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(start) = text[from..].find(&wanted).map(|i| from + i) {
        let rest = &text[start..];
        let first = rest.chars().next().map_or(1, char::len_utf8);
        let end = rest[first..].find(|c| !on(c)).map_or(text.len(), |i| start + first + i);
        found.push((start, end));
        from = end;
    }
    found
}

fn replaced(text: &str, stretches: &[(usize, usize)], pick: &Index, by: &str) -> String {
    if stretches.is_empty() {
        return text.to_owned();
    }
    let (start, end) = stretches[pick.index(stretches.len())];
    format!("{}{by}{}", &text[..start], &text[end..])
}

impl Mutation {
    fn apply(&self, text: &str) -> String {
        let lines = || text.lines().map(str::to_owned).collect::<Vec<_>>();
        let place = |pick: &Index| {
            let places: Vec<usize> = text.char_indices().map(|(i, _)| i).chain([text.len()]).collect();
            places[pick.index(places.len())]
        };
        match self {
            Self::Number(pick, by) => {
                let numeric = |c: char| c.is_ascii_digit() || matches!(c, '.' | 'e');
                replaced(text, &stretches(text, |c| c.is_ascii_digit(), numeric), pick, &by.0)
            }
            Self::Quoted(pick, by) => {
                let quotes: Vec<usize> = text.match_indices('"').map(|(i, _)| i).collect();
                let inside: Vec<_> = quotes.chunks_exact(2).map(|pair| (pair[0] + 1, pair[1])).collect();
                replaced(text, &inside, pick, &by.0)
            }
            Self::Word(pick, by) => {
                let letter = |c: char| c.is_ascii_lowercase() || c == '_';
                replaced(text, &stretches(text, letter, letter), pick, &by.0)
            }
            Self::DropLine(pick) => {
                let mut lines = lines();
                if !lines.is_empty() {
                    lines.remove(pick.index(lines.len()));
                }
                lines.join("\n")
            }
            Self::RepeatLine(pick, times) => {
                let mut lines = lines();
                if !lines.is_empty() {
                    let at = pick.index(lines.len());
                    let line = lines[at].clone();
                    lines.splice(at..at, std::iter::repeat_n(line, *times));
                }
                lines.join("\n")
            }
            Self::SwapLines(a, b) => {
                let mut lines = lines();
                if !lines.is_empty() {
                    let (a, b) = (a.index(lines.len()), b.index(lines.len()));
                    lines.swap(a, b);
                }
                lines.join("\n")
            }
            Self::Truncate(pick) => text[..place(pick)].to_owned(),
            Self::Splice(pick, length, by) => {
                let start = place(pick);
                let end = text[start..].char_indices().nth(*length).map_or(text.len(), |(i, _)| start + i);
                format!("{}{}{}", &text[..start], by.0, &text[end..])
            }
            Self::Append(what) => format!("{text}\n{}", what.0),
        }
    }
}

/// Numbers at the limits of everything, and any others.
fn number() -> impl Strategy<Value = String> {
    let edges = [
        "0",
        "-0",
        "-1",
        "1",
        "2",
        "3",
        "0.5",
        "0.999999999",
        "1e-300",
        "1e300",
        "-1e300",
        "1e-12",
        "1e-9",
        "1e-6",
        "1e5",
        "1e12",
        "nan",
        "inf",
        "-inf",
        "+inf",
        "0x10",
        "1_000",
        "1000",
        "2000",
        "2001",
        "101",
        "102",
        "10000",
        "9223372036854775807",
        "9223372036854775808",
        "1e",
        ".5",
        "5.",
        "0,5",
        "١",
        "00012",
        "1979-05-27",
    ];
    prop_oneof![
        3 => select(edges.to_vec()).prop_map(str::to_owned),
        2 => (-9..6i32, 1.0..10.0f64).prop_map(|(power, x)| format!("{:e}", x * 10f64.powi(power))),
        2 => (0.3..3.0f64).prop_map(|x| format!("{:.4}", 20.0 * x)),
    ]
}

/// Quantities, words and what else may stand between quotes.
fn quoted() -> impl Strategy<Value = String> {
    let units = ["mm", "in", "m", "um", "km", "inch", "N", "kN", "MPa", "N/mm", "%", "", "mm^2", "mm^-9/s", "°", "deg"];
    let texts = [
        "",
        " ",
        "mm",
        "\\u0000",
        "\\u0007 bell",
        "\\n",
        "\\\\",
        "../../../../etc/passwd",
        "/dev/zero",
        "<b>&\"",
        "axisymmetric",
        "plane_strain",
        "membrane",
        "bending",
        "clamped",
        "free",
        "uniform",
        "radii",
        "newton",
        "secant",
        "left",
        "right",
        "hold",
        "travel",
        "thickness_at_s0",
        "punch_force",
        "𝔘𝔫𝔦𝔠𝔬𝔡𝔢 \u{202e}rtl\u{0301}",
        "1 mm 2 mm",
        "1 mm // s",
        "--1 mm",
    ];
    prop_oneof![
        4 => (number(), select(units.to_vec())).prop_map(|(number, unit)| format!("{number} {unit}")),
        2 => select(texts.to_vec()).prop_map(str::to_owned),
        1 => "\\PC{0,40}".prop_map(|text| text.replace(['"', '\\'], "'")),
        1 => select(vec![300, 70_000, 2_000_000]).prop_map(|n| "Wörter ".repeat(n / 7)),
        1 => select(vec![300, 70_000]).prop_map(|n| "W".repeat(n)),
    ]
}

fn word() -> impl Strategy<Value = String> {
    prop_oneof![
        select(vec![
            "radius",
            "half_length",
            "half_width",
            "nose",
            "throat",
            "shoulder",
            "hemispherical",
            "flat",
            "crowned",
            "profile",
            "elements",
            "layers",
            "facets",
            "count",
            "frames",
            "travel",
            "speed",
            "force",
            "friction",
            "theory",
            "edge",
            "grading",
            "punch",
            "die",
            "holder",
            "swift",
            "voce",
            "ludwik",
            "hollomon",
            "table",
            "piecewise_power",
            "true",
            "false",
            "solver",
            "output",
            "x",
            "",
            "\"\"",
            "a.b.c",
            "tools.tools",
        ])
        .prop_map(str::to_owned),
        "[a-zä_.\"\\[\\]]{1,8}",
    ]
}

/// Nests as deep, and lists as long, as nobody writes.
fn excess() -> impl Strategy<Value = String> {
    let many = |entry: &'static str, n: usize| vec![entry; n].join(", ");
    let settings: Vec<String> = vec![
        "[output]\nframes = [[[[[[[[[[[[[[]]]]]]]]]]]]]]".into(),
        format!("deep = {}{}", "[".repeat(100_000), "]".repeat(100_000)),
        format!("deep = {}1{}", "{ a = ".repeat(50_000), " }".repeat(50_000)),
        format!("[{}a]", "a.".repeat(50_000)),
        format!("[output]\nframes = [{}]", many("\"1 mm\"", 1_001)),
        format!("[output]\nframes = [{}]", many("\"1 mm\"", 60_000)),
        format!("[output]\nframes = [{}]", many("\"1e-300 mm\"", 900)),
        format!("notes = [{}]", many("\"declared: a\"", 60_000)),
        "[blank]\nelements = 2000\nlayers = 101".into(),
        "[solver]\nmax_step = 1e-6\nfirst_step = 1e-6\nmin_step = 1e-12".into(),
        "[solver]\nfacets = 1000\nround_facets = true".into(),
        "[output]\ncount = 1000".into(),
        "# comment\n".repeat(80_000),
        "\n".repeat(500_000),
        "[[compare]]\n".repeat(2_000),
        format!("[material.hardening.table]\nextrapolation = \"hold\"\npoints = [{}]", many("[0, \"1 MPa\"]", 50_000)),
        format!(
            "[material.hardening.piecewise_power]\nbranches = [{}]",
            many("{ up_to = 0.1, initial = \"1 MPa\", k = \"1 MPa\", n = 0.1 }", 5_000)
        ),
    ];
    select(settings)
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<Index>;
    prop_oneof![
        12 => (at(), number()).prop_map(|(i, by)| Mutation::Number(i, Words(by))),
        5 => (at(), quoted()).prop_map(|(i, by)| Mutation::Quoted(i, Words(by))),
        3 => (at(), word()).prop_map(|(i, by)| Mutation::Word(i, Words(by))),
        2 => at().prop_map(Mutation::DropLine),
        1 => (at(), select(vec![1usize, 2, 5_000])).prop_map(|(i, n)| Mutation::RepeatLine(i, n)),
        1 => (at(), at()).prop_map(|(a, b)| Mutation::SwapLines(a, b)),
        1 => at().prop_map(Mutation::Truncate),
        2 => (at(), 0usize..30, "\\PC{0,12}|[\\x00-\\x7f]{0,6}").prop_map(|(i, n, by)| Mutation::Splice(i, n, Words(by))),
        1 => excess().prop_map(|what| Mutation::Append(Words(what))),
    ]
}

/// A message that can be acted on: it says something, points into the text, and does not bury the reader.
fn check_refusal(error: &CaseError, text: &str) {
    assert!(!error.to_string().trim().is_empty());
    let Some((line, column)) = error.position() else {
        assert!(error.to_string().contains("larger than") && text.len() > 2_000_000, "no place: {error}");
        return;
    };
    assert!(line <= text.lines().count().max(1) + 1 && column >= 1, "line {line}, column {column}");
    let shown = error.render(false);
    assert!(shown.chars().count() < 6_000, "a message of {} characters", shown.chars().count());
}

/// What is promised of every model, and what can be said without solving it.
fn check_accepted(case: &Case) {
    let model = case.model();
    let blank = &model.blank;
    for (what, value) in [
        ("length", blank.length),
        ("thickness", blank.thickness),
        ("duration", model.duration),
        ("speed", model.speed),
        ("tolerance", model.settings.tolerance),
        ("max_step", model.settings.max_step),
        ("min_step", model.settings.min_step),
        ("contact_stiffness", model.settings.contact_stiffness),
    ] {
        assert!(value.is_finite() && value > 0.0, "{what} = {value}");
    }
    assert!((2..=2000).contains(&blank.elements) && (1..=101).contains(&blank.layers));
    assert!(model.frames.len() <= 1001 && model.frames.last() == Some(&model.duration));
    assert!(model.frames.is_sorted_by(|a, b| a < b), "{:?}", model.frames);
    for tool in &model.tools {
        assert!((0.0..=64.0).contains(&tool.friction.largest_coefficient()), "{}", tool.friction);
        assert!(tool.profile.polyline(0.1).iter().all(|p| p.x.is_finite() && p.y.is_finite()));
    }
    let stresses = [0.0, 1e-4, 0.01, 0.1, 1.0].map(|strain| model.material.hardening.at(strain).stress);
    assert!(stresses.is_sorted() && stresses[0] >= 0.0 && stresses[4].is_finite() && stresses[4] > 0.0, "{stresses:?}");
    let nodes = mesh::nodes(model);
    assert_eq!(nodes.len(), blank.elements + 1);
    assert!(nodes.is_sorted_by(|a, b| a < b), "nodes do not rise");

    let report = stampflow::assess::check::report(case);
    for line in &report.lines {
        assert!(line.value.parse::<f64>().map_or(true, f64::is_finite), "{line:?}");
    }
    assert!(report.to_string().len() < 100_000);
}

/// The same problem, small enough to be solved two thousand times: the largest model that a file may ask for takes
/// hours by intention.
fn reduced(model: &Model) -> Model {
    let mut model = model.clone();
    model.blank.elements = model.blank.elements.min(20);
    model.blank.layers = model.blank.layers.min(7);
    let frames = model.frames.split_off(model.frames.len().saturating_sub(4));
    model.frames = frames;
    let settings = &mut model.settings;
    settings.max_step = settings.max_step.max(0.02);
    settings.first_step = settings.first_step.max(2e-3).min(settings.max_step);
    settings.min_step = settings.min_step.max(1e-3).min(settings.first_step);
    settings.max_iterations = settings.max_iterations.min(40);
    settings.facets = settings.facets.map(|n| n.min(40));
    model
}

fn check_finite(table: &Table, file: &str) {
    for column in &table.columns {
        assert!(column.values.iter().all(|v| v.is_finite()), "{file}: {}", column.key);
    }
}

/// Solves a reduced model and makes everything that a run leaves behind, short of files and pixels.
fn check_solved(case: &Case) {
    let model = &reduced(case.model());
    let run = solver::run(model, &mut ());
    let mut subject = StageView::alone(&case.name, &run);
    subject.case_text = &case.text;
    subject.findings.extend(stampflow::assess::before(case));
    for frame in &run.frames {
        assert!(frame.nodes.iter().all(|n| n.r.is_finite() && n.z.is_finite() && n.thickness > 0.0));
    }
    for output in OUTPUTS {
        match output.make {
            Make::Table(make) => make(&subject).iter().for_each(|table| check_finite(table, output.file)),
            Make::Text(make) => {
                let Some(text) = make(&subject) else { continue };
                let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
                let nulls = json.as_object().expect("an object").iter().filter(|(_, v)| v.is_null());
                assert_eq!(nulls.count(), 0, "{json}");
            }
            Make::Plot(make) => {
                let Some(chart) = make(&subject) else { continue };
                let picture = svg(&chart);
                let tree = Document::parse(&picture).expect("XML");
                let height: f64 = tree.root_element().attribute("height").expect("a height").parse().expect("a number");
                assert!(height < 5_000.0, "{}: {height} px high", output.file);
                for attribute in tree.descendants().flat_map(|node| node.attributes()) {
                    assert!(!attribute.value().contains("NaN"), "{}: {}", output.file, attribute.value());
                    assert!(!attribute.value().contains("inf"), "{}: {}", output.file, attribute.value());
                }
            }
            Make::Moving(..) | Make::OfCase(_) => {}
        }
    }
    assert!(!Summary::of(&subject).to_string().is_empty());
}

/// Refused or solved.
fn check(text: &str) {
    match case::parse(text, "cases/mutated.toml", &[]) {
        Err(error) => check_refusal(&error, text),
        Ok(case) => {
            check_accepted(&case);
            check_solved(&case);
        }
    }
}

/// The slowest reduced model takes about a tenth of a second; a busy machine gets six hundred times as long.
const LONGEST: Duration = Duration::from_secs(60);

/// As [`check`], under a watch.
fn check_in_time(text: &str) {
    let (done, ended) = channel();
    let own = text.to_owned();
    let worker = std::thread::spawn(move || {
        check(&own);
        let _ = done.send(());
    });
    let timed_out = ended.recv_timeout(LONGEST) == Err(std::sync::mpsc::RecvTimeoutError::Timeout);
    assert!(!timed_out, "no end after {LONGEST:?}");
    worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

/// A thousand mutated cases from one seed.
fn run(seed: u64) {
    let config = ProptestConfig {
        cases: 1_000,
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: None,
        max_shrink_iters: 200,
        ..ProptestConfig::default()
    };
    let strategy = (any::<Index>(), prop::collection::vec(mutation(), 1..4));
    proptest!(config, |((case, mutations) in strategy)| {
        let text = mutations.iter().fold(case.get(&CASES).clone(), |text, mutation| mutation.apply(&text));
        check_in_time(&text);
    });
    if let Some(peak) = peak_memory() {
        assert!(peak < MOST_MEMORY, "{} MB", peak >> 20);
    }
}

/// Both halves at once and other tests beside them, well above what they take: a list or a mesh that grew with a number would
/// be far beyond.
const MOST_MEMORY: u64 = 512 << 20;

/// Most memory that this process has held \[bytes\], where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes << 10)
}

/// StageSolution in two halves, side by side.
#[test]
fn a_thousand_mutated_cases_are_refused_or_solved() {
    run(1994);
}

#[test]
fn another_thousand_mutated_cases_are_refused_or_solved() {
    run(2024);
}
