//! Keys of a case from measured curves.

use super::super::code::{BadRequest, Code};
use super::super::interrupt;
use super::super::many::{asked, write_all};
use super::super::say::{say, say_json};
use super::super::table::{Cell, table, wrapped};
use super::args::Args;
use super::shown::{cells, csv, json_of};
use serde_json::{Value, json};
use stampflow::output::study::fit_case as pictures;
use stampflow::study::fit::{CaseFit, Range, fit_case, load};

pub fn case(args: &Args) -> anyhow::Result<Code> {
    let [file] = args.files.as_slice() else {
        return Err(BadRequest("give tension tests, or one case or study file".into()).into());
    };
    let ranges = args.vary.iter().map(|text| Range::read(text)).collect::<Result<Vec<_>, _>>().map_err(asked)?;
    let spec = load(file, args.many.overrides.all(), ranges, &args.to).map_err(asked)?;
    let count = args.many.count(file, "fit");
    let fit = match fit_case(&spec, args.many.threads(), &count) {
        Err(_) if interrupt::is_wanted() => return Ok(Code::Interrupted),
        fit => fit.map_err(asked)?,
    };
    let form = args.many.told.form();
    let dir = args.many.folder(file, "fit");
    let value = json(&fit);
    let mut files = vec![
        ("fit.csv".to_owned(), csv(fit.estimates.all.iter().map(|e| ("case", e))).into_bytes()),
        ("fit.json".to_owned(), serde_json::to_vec_pretty(&value)?),
        ("fitted.toml".to_owned(), fit.text.clone().into_bytes()),
    ];
    for (i, chart) in pictures(&fit, form).iter().enumerate() {
        let stem = if i == 0 { "fit".to_owned() } else { format!("fit_{}", i + 1) };
        files.extend(args.many.pictures.pictures().files(&stem, chart));
    }
    write_all(&dir, files)?;
    if args.many.json.json {
        return say_json(&value);
    }
    let told: String = fit.sentences().iter().map(|line| format!("- {}\n", line.told(form))).collect();
    let headers = ["Key", "Value", "Standard error", "Interval of 95 %"].map(|header| form.tell(header));
    let rows = fit.estimates.all.iter().map(|e| {
        let [value, error, interval] = cells(e, form);
        [e.key.clone(), value, error, interval].map(Cell::plain)
    });
    let settings: String = fit.settings.iter().map(|setting| format!("--set \"{setting}\" ")).collect();
    let shown = table(Some(headers.each_ref().map(String::as_str)), rows.collect()) + "\n".into() + wrapped(&told);
    say(shown + format!("\n{}\n{}\n", settings.trim_end(), dir.display()).into())
}

fn json(fit: &CaseFit) -> Value {
    let p = fit.estimates.all.len();
    let correlations: Vec<Vec<Option<f64>>> =
        (0..p).map(|i| (0..p).map(|j| fit.estimates.correlation(i, j)).collect()).collect();
    let curve = |matched: &stampflow::study::fit::Matched| {
        let points = matched.points.iter().map(|p| json!([p.x, p.reference, p.computed])).collect::<Vec<_>>();
        json!({ "file": matched.name, "left_out": matched.left_out, "x_measured_computed": points })
    };
    json!({
        "parameters": fit.estimates.all.iter().map(json_of).collect::<Vec<_>>(),
        "start": fit.start,
        "correlations": correlations,
        "rms": { "start": fit.rms[0], "end": fit.rms[1], "noise": fit.noise },
        "differences": fit.steps,
        "runs": fit.runs[0],
        "failed": fit.runs[1],
        "curves": fit.matched.iter().map(curve).collect::<Vec<_>>(),
        "set": fit.settings,
        "told": fit.sentences().iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}
