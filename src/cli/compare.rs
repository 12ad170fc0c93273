//! `stampflow compare`: runs and measured curves side by side; cases against their references.

use super::*;
use stampflow::case::comparison::{KINDS, Spec};
use stampflow::results::comparison::{Comparison, Verdict};
use stampflow::study::compare::{Candidate, SideBySide, check, variant};

options! {
    /// Compare cases, variants and measured curves
    Args {
        files: Vec<PathBuf> = "CASE.toml|CURVE.csv|DIR" [default_value = "cases"]
            "Case files and CSV files of measured curves; or one case or folder, to compare with its references",
    } variants: Variants, options: StudyOptions;
    Variants {
        also: Vec<String> = "KEY=VALUE; ..." [long]
            "One more run: the first case with these overrides, KEY=VALUE joined by semicolons; as often as needed",
    };
}

pub fn compare(args: &Args) -> Result<Code> {
    let first = &args.files[0];
    if args.files.len() == 1 && args.variants.also.is_empty() && !is_curve(first) {
        return references(args, first);
    }
    let (candidates, curves) = to_compare(&args.files, &args.variants, &args.options.common.overrides.all())?;
    let first = args.files.iter().find(|file| !is_curve(file)).unwrap_or(first);
    let dir = args.options.folder(first, "compare")?;
    place::file(&dir.join("differences.csv"), &args.files, "--out")?;
    let folder = study_folder("compare", &dir).map_err(unusable("--out"))?;
    let threads = args.options.threads.count();
    let all = SideBySide::solve(&candidates, curves, None, threads, &args.options.count(first, "compared"))?;
    if all.members.len() < candidates.len() {
        warn(format!("{} of {} runs had ended", all.members.len(), candidates.len()));
    }
    if all.members.is_empty() && is_interrupted() {
        return Ok(Code::Done);
    }
    args.options.present(&all.report(), (&dir, folder), Vec::new(), &[], Value::Null)
}

pub fn to_compare(files: &[PathBuf], variants: &Variants, set: &[String]) -> Result<(Vec<Candidate>, Vec<Spec>)> {
    let (curves, cases): (Vec<&PathBuf>, Vec<&PathBuf>) = files.iter().partition(|file| is_curve(file));
    let variants = variants.also.iter().map(|text| variant(text)).collect::<Result<Vec<_>, _>>()?;
    let mut candidates = Vec::new();
    for (i, path) in cases.into_iter().enumerate() {
        for overrides in std::iter::once(Vec::new()).chain(variants.iter().filter(|_| i == 0).cloned()) {
            candidates.push(Candidate { case: options::load(path, &[set, &overrides].concat())?, overrides });
        }
    }
    let curves = curves.into_iter().map(|path| measured_curve(path)).collect::<Result<Vec<_>, _>>()?;
    check(&candidates, &curves)?;
    Ok((candidates, curves))
}

pub fn is_curve(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

fn references(args: &Args, path: &Path) -> Result<Code> {
    let wrong = |error| bad_request(format!("cannot read the folder {}: {error}", path.display()));
    let files = if path.is_dir() { stampflow::grade::toml_files(path).map_err(wrong)? } else { vec![path.to_owned()] };
    let (mut cases, mut failed) = args.options.common.load_all(&files);
    cases.retain(|case| !case.compare.is_empty());
    let what = format!("no case in {} has a [[compare]] table", path.display());
    ensure!(!cases.is_empty() || !failed.is_empty(), bad_request(what));
    let (dir, progress) = (args.options.folder(path, "compare")?, args.options.common.progress());
    args.options.threads.apply()?;
    let one = |case: &Case| {
        let dir = place::folder(&dir, case)?;
        place::results(case, &dir)?;
        let folder = comparison_folder(&dir).map_err(unusable("--out"))?;
        let solution = progress.watch(case).solve(case.clone());
        let results = Results::of(&solution)?.with_pictures(&args.options.pictures.pictures()?);
        let unwritten = results.write_comparisons(folder).err().map(anyhow::Error::from);
        let compared = results.comparisons.into_iter().map(|comparison| (case.name.clone(), comparison));
        Ok((compared.collect::<Vec<_>>(), unwritten))
    };
    let runs = cases.par_iter().filter(|_| !is_interrupted());
    let runs: Vec<_> = runs.map(|case| caught(&format!("case {}", case.name), || one(case))).collect();
    let (compared, unwritten): (Vec<_>, Vec<_>) = sound(runs, &mut failed).into_iter().unzip();
    let compared = compared.concat();
    failed.extend(unwritten.into_iter().flatten());
    if args.options.common.json() {
        print_json(&as_json(compared.iter().map(|(case, comparison)| (case, comparison))))?;
    } else {
        let headers = ["Case", "Kind", "Quantity", "Computed", "Reference", "Verdict"];
        let end = wrapped(format!("\n{}\n{}", reasons(&compared), counts(&compared)));
        print(table(&headers, compared.iter().map(row)) + end)?;
    }
    let is_out = compared.iter().any(|(_, comparison)| comparison.is_failure()) && !is_interrupted();
    Ok(complained(&failed, if is_out { Code::Failed } else { Code::Done }))
}

/// Comparisons with all their numbers; what was not reached is null.
pub fn as_json<'a>(all: impl Iterator<Item = (&'a String, &'a Comparison)>) -> Value {
    let one = |(case, comparison): (&String, &Comparison)| {
        let columns = comparison.table().columns;
        let values = columns.iter().map(|one| (one.header(), one.values.iter().copied().map(rounded).collect()));
        json!({
            "case": case, "quantity": comparison.spec.quantity.name(), "reference": comparison.spec.reference,
            "source": comparison.spec.source, "worst": comparison.worst(), "accepted": comparison.accepted(),
            "verdict": comparison.outcome(), "failure": comparison.is_failure(), "reason": comparison.spec.reason,
            "values": values.collect::<Map<_, _>>(),
        })
    };
    all.map(one).collect()
}

fn row((case, comparison): &(String, Comparison)) -> [String; 6] {
    let kind = comparison.spec.source.as_ref().map(|source| source.kind().to_owned());
    let computed = comparison.farthest().map(|amount| amount.to_string());
    let [kind, computed, target] = [kind, computed, comparison.target()].map(|text| text.unwrap_or("–".to_owned()));
    [case.clone(), kind, comparison.spec.quantity.label().to_owned(), computed, target, comparison.outcome()]
}

fn reasons(all: &[(String, Comparison)]) -> String {
    let mut lines = Vec::new();
    for (case, comparison) in all.iter().filter(|(_, comparison)| comparison.verdict != Verdict::In) {
        let reason = comparison.spec.reason.trim_end_matches('.');
        let (quantity, miss) = (comparison.spec.quantity.label(), comparison.worst().unwrap_or_default());
        let line = format!("{case}, {quantity} {miss}: {reason}.");
        lines.extend((!lines.contains(&line)).then_some(line));
    }
    lines.join("\n")
}

fn counts(all: &[(String, Comparison)]) -> String {
    let line = |name: &&str| {
        let own = |c: &Comparison| c.spec.source.as_ref().is_some_and(|source| source.kind() == *name);
        let count = |is: &dyn Fn(&Verdict) -> bool| all.iter().filter(|(_, c)| is(&c.verdict) && own(c)).count();
        let (known, inside) = (count(&|verdict| *verdict != Verdict::NoData), count(&|v| *v == Verdict::In));
        (known > 0).then(|| format!("{name}: {inside} of {known} inside"))
    };
    KINDS.iter().filter_map(line).collect::<Vec<_>>().join("\n")
}
