//! Pictures and reports, in German and in US units: nothing stays in English or in mm.

use crate::common::few::Few;
use crate::common::shipped::shipped_case;
use stampflow::assess::{self, judgements};
use stampflow::author::templates::TEMPLATES;
use stampflow::case::{self, Solution};
use stampflow::message::{Form, Language, Message, System, Term};
use stampflow::report::{Block, Document, Report, html};
use stampflow::results::{Captions, Chart, OUTPUTS, Pictures, Results};

fn german() -> Form {
    Form { language: Language::of("de").expect("German"), ..Form::default() }
}

fn us() -> Form {
    Form { system: System::Us, ..Form::default() }
}

fn of_template(name: &str) -> Solution {
    let template = TEMPLATES.iter().find(|template| template.name == name).expect("a template");
    case::parse(&template.fill(&[]).expect("a case"), "made.toml", &[]).expect("valid").solve(&mut ())
}

/// A cup that tears, under a press, and one that is drawn through; springs and strips; gas with and without a rate to hold; a
/// warm sheet and one with voids; several stages.
fn solutions() -> Vec<Solution> {
    let torn = ["tools.holder.force=150 kN", "tools.die.friction=0.2", "forming_limit.hill=true", "press.force=100 kN"];
    let through = ["tools.punch.travel=40 mm", "blank.radius=45 mm", "blank.elements=40"];
    vec![
        shipped_case("quickstart", &torn).solve(&mut ()),
        shipped_case("quickstart", &through).solve(&mut ()),
        of_template("hat-section"),
        shipped_case("strip_draw", &["forming_limit.hill=true"]).solve(&mut Few(12)),
        shipped_case("bulge", &["blank.elements=20"]).solve(&mut ()),
        shipped_case("superplastic_dome", &[]).solve(&mut Few(12)),
        shipped_case("warm_cup", &[]).solve(&mut Few(12)),
        shipped_case("woo_porous", &[]).solve(&mut Few(12)),
        shipped_case("stages_cup", &[]).solve(&mut Few(12)),
    ]
}

/// All that a chart says.
fn of_chart(chart: &Chart) -> Vec<String> {
    let axes = chart.panels.iter().flat_map(|panel| [panel.x.text(), panel.y.text()]);
    let labels = chart.panels.iter().flat_map(|panel| &panel.series).filter_map(|series| series.label.clone());
    let own = [chart.title.clone(), chart.legend.clone()];
    own.into_iter().chain(axes).chain(labels).chain(chart.notes.iter().cloned()).collect()
}

/// All that a report says, its pictures too.
fn of_document(document: &Document) -> Vec<String> {
    let block = |block: &Block| match block {
        Block::Paragraph(text) | Block::Sentence(_, text) => vec![text.clone()],
        Block::List(entries) => entries.clone(),
        Block::Numbers(numbers) => {
            numbers.iter().flat_map(|n| [n.label.clone(), n.value.clone(), n.detail.clone()]).collect()
        }
        Block::Issues(issues) => {
            issues.iter().flat_map(|i| [i.label.clone(), i.found.clone(), i.limit.clone(), i.advice.clone()]).collect()
        }
        Block::Table { head, rows } => head.iter().chain(rows.iter().flat_map(|row| &row.cells)).cloned().collect(),
        Block::Picture(picture) => std::iter::once(picture.caption.clone()).chain(of_chart(&picture.chart)).collect(),
    };
    let headings = document.sections.iter().map(|section| section.heading.clone());
    let title_block = document.title_block.iter().flatten().cloned();
    headings.chain(title_block).chain(document.blocks().flat_map(block)).collect()
}

/// Trust: these words stand in nearly every English sentence and in no German one; a key such as `fitted_up_to` is one word.
fn is_english(text: &str) -> bool {
    const ENGLISH: [&str; 14] =
        ["the", "of", "and", "is", "are", "with", "from", "than", "which", "at", "over", "above", "by", "to"];
    text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| ENGLISH.contains(&word))
}

/// What the case's author and the sources of its numbers say stays as it is.
fn given(solution: &Solution) -> Vec<String> {
    let case = &solution.case;
    let mut given = vec![case.title_block.part.clone().unwrap_or_default()];
    for model in solution.stages.iter().map(|stage| &stage.model) {
        let law = model.material.describe();
        given.extend([model.title.clone(), Message::Formula(law.clone()).told(german()).to_string(), law]);
        given.extend(model.notes.iter().cloned());
    }
    given.extend([&case.sources.friction, &case.sources.material].into_iter().flatten().cloned());
    given.extend(case.model().material.gtn.iter().map(ToString::to_string));
    given.extend(case.compare.iter().map(|spec| spec.against.to_string()));
    given.extend(case.stage_names().map(str::to_owned));
    // The longest first: one may be part of another.
    given.sort_by_key(|text| std::cmp::Reverse(text.len()));
    given
}

/// Fails where something is told in English, or not otherwise than in English though it has words.
#[test]
fn pictures_and_reports_are_told_in_german() {
    let mut english = std::collections::BTreeSet::new();
    for solution in solutions() {
        let given = given(&solution);
        let own = |text: &str| {
            given.iter().filter(|text| !text.is_empty()).fold(text.to_owned(), |t, g| t.replace(g.as_str(), ""))
        };
        let report = Report::of(&solution);
        let pictures = Pictures { captions: Captions::Full, ..Pictures::default() };
        let mut results = Results::of(&solution).expect("no references").with_pictures(&pictures).told(german());
        results.views.iter_mut().for_each(|view| view.findings.clear());
        let charts = results.views.iter().flat_map(|view| OUTPUTS.iter().filter_map(|output| output.chart(view)));
        let said = charts.flat_map(|chart| of_chart(&chart)).chain(of_document(&report.told(german())));
        english.extend(said.map(|text| own(&text)).filter(|text| is_english(text)));
    }
    assert!(english.is_empty(), "{english:#?}");
}

/// Trust: what is told in US units has none of the others, but in what a case's author wrote, and in laws' formulas.
#[test]
fn pictures_and_reports_are_told_in_us_units() {
    let solution = shipped_case("quickstart", &["forming_limit.hill=true"]).solve(&mut ());
    let given = given(&solution);
    let document = Report::of(&solution).told(us());
    let texts = of_document(&document);
    assert!(texts.contains(&"Force [US tonf]".to_owned()) && texts.contains(&"Distance from the axis [in]".to_owned()));
    for text in texts.iter().filter(|text| !given.contains(text)) {
        let mut words = text.split([' ', '\u{a0}', '[', ']', ',', ';', ')']);
        assert!(!words.any(|word| ["mm", "kN", "N", "MPa", "°C"].contains(&word)), "{text}");
    }
    // Trust: an inch is 25.4 mm, a ton of 2000 lbf 8896.44 N.
    let [si, us] = [document_curve(&solution, Form::default()), document_curve(&solution, us())];
    assert_eq!(si.len(), us.len());
    for ((x, y), (inches, tons)) in si.into_iter().zip(us) {
        assert!((x - 25.4 * inches).abs() < 1e-9 && (y - 8.896_443_230_521 * tons).abs() < 1e-9, "{x} {y}");
    }
}

/// The first curve over the travel.
fn document_curve(solution: &Solution, form: Form) -> Vec<(f64, f64)> {
    let document = Report::of(solution).told(form);
    let load = document.pictures().find(|picture| picture.name == "load_travel").expect("the load");
    load.chart.panels[0].series[0].points.clone()
}

/// Every row of the verdict has its word explained, once, at the report's end; and the page says its language.
#[test]
fn a_report_explains_its_words() {
    let solution = shipped_case("quickstart", &["forming_limit.hill=true", "press.force=1 MN"]).solve(&mut ());
    let findings = assess::after(&solution.case, &solution.stages);
    let unexplained: Vec<_> = judgements(&findings).map(|f| f.key).filter(|key| Term::of_row(key).is_none()).collect();
    assert!(unexplained.is_empty(), "{unexplained:?}");
    let document = Report::of(&solution).told(german());
    let words = document.sections.last().expect("a section");
    assert_eq!(words.heading, "Begriffe");
    let Some(Block::Table { rows, .. }) = words.blocks.first() else { panic!("a table") };
    let named: Vec<&str> = rows.iter().map(|row| row.cells[0].as_str()).collect();
    assert!(named.contains(&"Ausdünnung") && named.contains(&"Niederhalter"), "{named:?}");
    assert!(named.iter().enumerate().all(|(i, name)| !named[..i].contains(name)), "{named:?}");
    let page = html(&document);
    assert!(page.contains("<html lang=\"de\">") && page.contains("\" von \" counter(pages)"), "{}", &page[..200]);
}
