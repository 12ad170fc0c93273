//! Random parts by the templates, some too bold: whether every verb judges them alike, and whether advice keeps its word.

use fastrand::Rng;
use stampflow::assess::{self, Answer, FailureMode, Finding, Light, judgements};
use stampflow::author::templates;
use stampflow::case::{self, Solution};
use stampflow::model::{Motion, Role};
use stampflow::study::verify::verify;
use stampflow::study::{
    BaseCase, Evaluation, LimitSearch, Scatter, SearchRequest, Shard, Side, Study, Sweep, begin, judge,
};

const SHEETS: [&str; 7] = ["dc04", "if-steel", "aa5754-o", "aa6016-t4", "stainless-304", "stainless-430", "trip690"];

/// A part of a template with random sizes, sheet, friction and holder force, in the range of press shops and beyond its rules; its
/// mesh is coarse.
pub fn random_part(seed: u64) -> BaseCase {
    let mut rng = Rng::with_seed(seed);
    let mut between = |low: f64, high: f64| low + (high - low) * rng.f64();
    // Sizes that a template refuses are drawn anew.
    loop {
        let template =
            ["cup", "hemispherical-cup", "conical-cup", "stretch-dome", "hat-section"][between(0.0, 5.0) as usize];
        let sheet = SHEETS[between(0.0, SHEETS.len() as f64) as usize];
        let thickness = between(0.6, 2.0);
        let radius = thickness * between(25.0, 50.0);
        let mm = |size: f64| format!("{size:.2} mm");
        let has_corners = ["cup", "conical-cup", "hat-section"].contains(&template);
        let width = if template == "hat-section" { "half-width" } else { "punch-radius" };
        let mut sizes = vec![("material", sheet.to_owned()), ("thickness", mm(thickness)), (width, mm(radius))];
        sizes.push(("height", mm(radius * between(0.3, 1.1))));
        sizes.push(("friction", format!("{:.3}", between(0.03, 0.15))));
        if has_corners {
            sizes.push(("nose", mm(thickness * between(2.0, 8.0))));
            sizes.push(("shoulder", mm(thickness * between(3.0, 10.0))));
        }
        let times = 10_f64.powf(between(-0.7, 0.7));
        let sizes: Vec<(&str, &str)> = sizes.iter().map(|(name, text)| (*name, text.as_str())).collect();
        let Ok(text) = templates::find(template).and_then(|template| template.fill(&sizes)) else { continue };
        let case = case::parse(&text, "part.toml", &[]).expect("a case of a template");
        let force = match case.model().tool(Role::Holder).map(|holder| &holder.motion) {
            Some(Motion::Pressed(press)) => Some(press.force.largest() * times),
            _ => None,
        };
        let unit = if template == "hat-section" { "N/mm" } else { "N" };
        let force = force.map(|force| format!("tools.holder.force={force:.4} {unit}"));
        let settings = force.into_iter().chain(["blank.elements=40".to_owned()]).collect();
        return BaseCase::from_text(text, "part.toml", settings).expect("a case");
    }
}

/// What two verbs say otherwise of a part, and whether it is sound; the report's error bars cost as much as ten runs.
pub fn disagreement(part: &BaseCase, has_report: bool) -> (Option<String>, bool) {
    let solution = part.case(&[]).expect("a case").solve(&mut ());
    let (run, lines) = judge(&solution, None, false, &());
    let keys = |findings: &[Finding], light: Light| {
        let open = judgements(findings).filter(|row| row.light == light && row.key != "friction");
        open.map(|row| row.key.to_owned()).collect::<Vec<_>>()
    };
    let lights = [Light::Red, Light::Amber].map(|light| keys(&lines, light));
    let mut differs = Vec::new();
    // Bars turn green lines amber, never red.
    let bars = has_report.then(|| verify(&solution, &()).bars);
    let (report, weighed) = judge(&solution, bars.as_ref(), false, &());
    if report.failures != run.failures || keys(&weighed, Light::Red) != lights[0] {
        differs.push(format!("report: {}", report.sentence));
    }
    // The page solves no other friction.
    let findings = assess::after(&solution.case, &solution.stages);
    let page = Answer::of(&solution.case, &solution.stages, &findings);
    if page.failures != run.failures || [Light::Red, Light::Amber].map(|light| keys(&findings, light)) != lights {
        differs.push(format!("page: {}", page.sentence));
    }
    let own = part.value("tools.punch.friction").expect("a friction");
    let request = SearchRequest {
        vary: Some("friction=0.02..0.2".into()),
        condition: Some("no red".into()),
        side: Some(Side::Largest),
        ..SearchRequest::default()
    };
    let sweep = Sweep::new(part.clone(), &[format!("friction={own}")], false).expect("a sweep");
    let search = LimitSearch::new(part.clone(), &request).expect("a search");
    let scatter = Scatter::new(part.clone(), &["friction=uniform 0.05..0.12".into()], 8, 1).expect("a scatter");
    let studies: [(&str, Box<dyn Study>); 3] =
        [("sweep", Box::new(sweep)), ("search", Box::new(search)), ("scatter", Box::new(scatter))];
    for (name, mut study) in studies {
        let row = begin(&mut *study, &Evaluation { threads: 1, shard: Shard::WHOLE, watch: &() }).expect("a run").base;
        let is_like = row.failures == run.failures && [row.red.clone(), row.amber.clone()] == lights;
        if !is_like || row.is_sound() != (lights[0].is_empty() && row.is_known()) {
            differs.push(format!("{name}: {row:?}"));
        }
    }
    let text = (!differs.is_empty()).then(|| format!("run: {}; {}", run.sentence, differs.join("; ")));
    (text, run.failures.is_empty())
}

/// First advice on a part that is red or amber, and whether the part with it has what the advice says.
pub struct Advised {
    pub light: Light,
    /// `None` if no change helps.
    pub first: Option<(String, bool)>,
}

const SIZES: [(&str, &[&str]); 11] = [
    ("die radius", &["tools.die.shoulder"]),
    ("punch nose", &["tools.punch.flat.nose"]),
    ("holder force", &["tools.holder.force"]),
    ("friction of die and holder", &["tools.die.friction", "tools.holder.friction"]),
    ("friction of all tools", &["friction"]),
    ("friction of the punch", &["tools.punch.friction"]),
    ("blank diameter", &["blank.diameter"]),
    ("blank radius", &["blank.radius"]),
    ("holder gap", &["tools.holder.gap"]),
    ("die throat", &["tools.die.throat"]),
    ("travel", &["tools.punch.travel"]),
];

/// Follows the first advice on a part; `None` for a part whose design is green.
pub fn advised(part: &BaseCase) -> Option<Advised> {
    let solution = part.case(&[]).expect("a case").solve(&mut ());
    let (answer, lines) = judge(&solution, None, true, &());
    let is_known = !answer.failures.contains(&FailureMode::NoResult);
    let open: Vec<&Finding> = judgements(&lines).filter(|row| assess::advice::is_open(row)).collect();
    let worst = open.iter().map(|row| row.light).max().filter(|_| is_known)?;
    let row = open.into_iter().find(|row| row.light == worst && row.advice.contains(" → "));
    let first = row.map(|row| {
        let text = row.advice.split("; or ").next().expect("a change");
        (format!("{}: {text}", row.label), keeps(part, &solution, row, text))
    });
    Some(Advised { light: worst, first })
}

/// Whether the line of the verdict has the number, or the light, that the advice says, once it is followed.
fn keeps(part: &BaseCase, old: &Solution, row: &Finding, text: &str) -> bool {
    let (change, gain) = text.split_once(": ").expect("a change and its gain");
    let (words, keys) = SIZES.iter().find(|(words, _)| change.starts_with(words)).unwrap_or_else(|| panic!("{text}"));
    let value = change.strip_prefix(words).expect("words").trim();
    let settings = keys.iter().filter(|key| !old.case.written(key).is_empty()).map(|key| format!("{key}={value}"));
    let new = part.case(&settings.collect::<Vec<_>>()).expect("a case").solve(&mut ());
    let findings = assess::after(&new.case, &new.stages);
    let new = judgements(&findings).find(|new| new.key == row.key).expect("the line");
    let is_better = new.light < row.light || new.light == row.light && new.value() != row.value();
    let said = gain.split_once(" → ").expect("a gain").1;
    let number = new.quantity.as_ref().map(|quantity| quantity.amount.to_string()).unwrap_or_default();
    is_better && (said == number || said == new.light.name())
}
