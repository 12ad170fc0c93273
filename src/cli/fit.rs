//! `stampflow fit`.

use super::*;
use stampflow::study::fit::{CaseFitRequest, HardeningKind, Reduction, fit_case, fit_laws, flow_curves, material_text};

const STRAIN: &str = "a plain number";

options! {
    /// Fit a law to tension tests, or a case to measured curves
    Args {
        files: Vec<PathBuf> = "TEST.csv|CASE.toml" [required = true] "Tension tests, or one case or study file",
        law: Option<HardeningKind> = "LAW" [long] "Fit only this law to tension tests",
        young: Option<f64> = "STRESS" [long, value_parser = |text: &str| measured(text, "a stress", "210 GPa")]
            "Young's modulus [default: the slope at the beginning]",
        offset: f64 = "STRAIN" [long, hide_short_help = true, default_value = "0.2 %", value_parser = strain] "Plastic strain at yield",
        from: Option<f64> = "STRAIN" [long, hide_short_help = true, value_parser = strain]
            "Plastic strain where the fit begins [default: the offset]",
        until: Option<f64> = "STRAIN" [long, hide_short_help = true, value_parser = strain]
            "Plastic strain where the fit ends [default: at the largest force]",
        section: Option<f64> = "AREA" [long, visible_alias = "area", value_parser = |text: &str| measured(text, "an area", "20 mm^2")]
            "Section of the specimen, for forces: \"20 mm^2\"",
        gauge: Option<f64> = "LENGTH" [long, visible_alias = "gauge-length", value_parser = |text: &str| measured(text, "a length", "80 mm")]
            "Gauge length, for elongations: \"80 mm\"",
        rate: Vec<f64> = "A,B,C" [long, value_delimiter = ',']
            "Strain rate of each test in 1/s, in their order: 0.001,1; fits a power of it",
        direction: Vec<f64> = "A,B,C" [long, value_delimiter = ',']
            "Direction of each test to the rolling direction in degrees: 0,45,90",
        vary: Vec<String> = "KEY=RANGE" [long] "A key of the case: KEY=START in LOW..HIGH UNIT; as often as needed",
        to: Vec<PathBuf> = "CURVE.csv" [long]
            "A measured curve, as often as needed [default: those of the case's [[compare]]]",
    } options: StudyOptions;
}

pub fn fit(args: &Args) -> Result<Code> {
    let dir = args.options.folder(&args.files[0], "fit")?;
    place::file(&dir.join("fit.csv"), &[args.files.as_slice(), &args.to].concat(), "--out")?;
    let folder = || study_folder("fit", &dir).map_err(unusable("--out"));
    let fitted = match args.files.as_slice() {
        tests if tests.iter().all(|path| compare::is_curve(path)) => laws(args, (&dir, folder()?)),
        [file] => keys(args, file, (&dir, folder()?)),
        _ => Err(bad_request("give tension tests, or one case or study file")),
    };
    let is_cut = is_interrupted() && fitted.as_ref().is_err_and(|error| error.is::<StudyError>());
    if is_cut { Ok(Code::Interrupted) } else { fitted }
}

fn laws(args: &Args, place: (&Path, ResultFolder)) -> Result<Code> {
    let what = "--vary and --to are of a case: name its file in place of a test";
    ensure!(args.vary.is_empty() && args.to.is_empty(), bad_request(what));
    let &Args { young, offset, from, until: to, section, gauge, .. } = args;
    let reduction = Reduction { young, offset, from, to, section, gauge };
    let count = args.options.count(&args.files[0], "laws");
    let curves = flow_curves(&args.files, &reduction, &args.rate, &args.direction, &count);
    let fits = curves.and_then(|curves| fit_laws(curves, args.law, &count))?;
    drop(count);
    let best = fits.best();
    let files = vec![("material.toml".to_owned(), material_text(&fits, best).into_bytes())];
    let extra = json!({ "law": best.kind.name(), "parameters": best.estimates });
    args.options.present(&fits.report(), place, files, &[], extra)
}

fn keys(args: &Args, file: &Path, place: (&Path, ResultFolder)) -> Result<Code> {
    let fit = CaseFitRequest::load(file, args.options.common.overrides.all(), &args.vary, &args.to)?;
    let fit = fit_case(&fit, args.options.threads.count(), &args.options.count(file, "fit"))?;
    let files = vec![("fitted.toml".to_owned(), fit.text.clone().into_bytes())];
    args.options.present(&fit.report, place, files, &[], json!({ "law": null, "parameters": fit.estimates }))
}

fn measured(text: &str, dimension: &str, example: &str) -> Result<f64, String> {
    let parsed = parse(text).map_err(|error| error.to_string())?;
    let is_large = parsed.value > 0.0 || dimension == STRAIN && parsed.value == 0.0;
    let fits = parsed.dimension.describe() == dimension && is_large;
    fits.then_some(parsed.value).ok_or_else(|| format!("{text} is not {dimension}: write \"{example}\""))
}

fn strain(text: &str) -> Result<f64, String> {
    measured(text, STRAIN, "0.2 %")
}
