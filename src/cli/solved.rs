//! A solved case on screen: the verdict's sentence, red and amber findings with what to change, key numbers.

use super::*;

/// Output of one case of several: text or JSON, and errors that are no reason to give less of it.
#[derive(Default)]
pub struct Output {
    pub code: Code,
    pub screen: ScreenText,
    pub json: Option<Value>,
    pub failed: Vec<anyhow::Error>,
}

pub fn finish(outputs: Vec<Result<Output>>, mut failed: Vec<anyhow::Error>, several: bool) -> Result<Code> {
    let (mut code, mut screen, mut values) = (Code::Done, ScreenText::default(), Vec::new());
    for output in sound(outputs, &mut failed) {
        (code, screen) = (code.max(output.code), screen + output.screen);
        values.extend(output.json);
        failed.extend(output.failed);
    }
    let printed = match values.as_slice() {
        [] => print(screen),
        [value] if !several => print_json(value),
        values => print_json(&values),
    };
    failed.extend(printed.err());
    Ok(complained(&failed, code))
}

pub struct Solved {
    pub solution: Solution,
    pub verification: Option<ErrorBars>,
    pub answer: Answer,
    pub findings: Vec<Finding>,
}

impl Solved {
    pub fn new(solution: Solution, progress: &Progress, has_bars: bool, has_advice: bool) -> Self {
        let count = |what| progress.count(format!("{}, {what}", solution.case.name));
        let verification = has_bars.then(|| stampflow::study::verify::verify(&solution, &count("finer")).bars);
        let (answer, findings) = judge(&solution, verification.as_ref(), has_advice, &count("advice"));
        Self { solution, verification, answer, findings }
    }

    /// Exit code: red only with `--strict`, whether complete or not.
    pub fn code(&self, strict: bool) -> Code {
        match self.answer.light {
            Light::Red if strict => Code::Red,
            _ if is_done(&self.solution) => Code::Done,
            _ => Code::StoppedEarly,
        }
    }

    pub fn verdict(&self) -> Value {
        stampflow::results::verdict(&self.answer, &self.findings, self.verification.as_ref())
    }

    /// One line: `cup: RED: it tears in the wall.`, with `more` at its end.
    pub fn sentence(&self, more: &str) -> ScreenText {
        let Answer { light, sentence, .. } = &self.answer;
        let word = light.name().to_uppercase();
        screen::highlighted(&format!("{}: {word}: {sentence}. {more}", self.solution.case.name), &word, *light)
    }

    pub fn screen(&self, verdict: ScreenText) -> ScreenText {
        let Self { solution, verification, answer, findings } = self;
        let all = answer.numbers.iter();
        let numbers = all.map(|n| [n.name.as_deref().unwrap_or(n.label).into(), n.amount.to_string(), n.place.clone()]);
        let bars = verification.as_ref().map_or_else(|| vec![ErrorBars::NONE.to_owned()], ErrorBars::sentences);
        let end = Some(answer.end.clone()).filter(|end| !end.is_empty());
        let warnings: Vec<String> = end.into_iter().chain(sentences(findings, Kind::Warning)).chain(bars).collect();
        let text = self.sentence("") + list(size_doubts(&solution.case)) + "\n" + judged(findings);
        let text = text + rows(numbers) + list(warnings) + verdict;
        let unchecked = unchecked(findings);
        if unchecked.is_empty() { text } else { text + wrapped(format!("\nNot checked: {unchecked}.")) }
    }
}

fn judged(findings: &[Finding]) -> ScreenText {
    let mut lines: Vec<[Cell; 3]> = Vec::new();
    for alike in [Light::Red, Light::Amber].iter().flat_map(|light| by_advice(findings, *light)) {
        lines.extend(alike.iter().map(|finding| {
            // Words have no limit.
            let limit = finding.value().map_or(String::new(), |_| format!("; limit: {}", finding.limit));
            [Cell::Light(finding.light, String::new()), finding.label.into(), (finding.statement() + &limit).into()]
        }));
        let advice = Some(&alike[0].advice).filter(|advice| !advice.is_empty());
        lines.extend(advice.map(|advice| ["", "→ change", advice].map(Cell::from)));
    }
    lines.extend((!lines.is_empty()).then(|| [""; 3].map(Cell::from)));
    rows(lines)
}
