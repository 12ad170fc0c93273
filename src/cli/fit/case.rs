//! Keys of a case from measured curves.

use super::super::code::{BadRequest, Code};
use super::super::interrupt;
use super::super::many::{asked, write_all};
use super::super::say::{say, say_json};
use super::super::table::{Cell, table, wrapped};
use super::args::Args;
use super::shown::{cells, csv};
use stampflow::output::study::{fit_case as pictures, json};
use stampflow::study::Readings;
use stampflow::study::fit::{Range, fit_case, load};

pub fn case(args: &Args) -> anyhow::Result<Code> {
    let [file] = args.files.as_slice() else {
        return Err(BadRequest("give tension tests, or one case or study file".into()).into());
    };
    let ranges = args.vary.iter().map(|text| Range::read(text)).collect::<Result<Vec<_>, _>>().map_err(asked)?;
    let to: Vec<Readings> = args.to.iter().cloned().map(Into::into).collect();
    let spec = load(file, args.many.overrides.all(), ranges, &to).map_err(asked)?;
    let count = args.many.count(file, "fit");
    let fit = match fit_case(&spec, args.many.threads(), &count) {
        Err(_) if interrupt::is_wanted() => return Ok(Code::Interrupted),
        fit => fit.map_err(asked)?,
    };
    let dir = args.many.folder(file, "fit");
    let value = json::fit_case(&fit);
    let mut files = vec![
        ("fit.csv".to_owned(), csv(fit.estimates.all.iter().map(|e| ("case", e))).into_bytes()),
        ("fit.json".to_owned(), serde_json::to_vec_pretty(&value)?),
        ("fitted.toml".to_owned(), fit.text.clone().into_bytes()),
    ];
    for (i, chart) in pictures(&fit).iter().enumerate() {
        let stem = if i == 0 { "fit".to_owned() } else { format!("fit_{}", i + 1) };
        files.extend(args.many.pictures.pictures().files(&stem, chart));
    }
    write_all(&dir, files)?;
    if args.many.json.json {
        return say_json(&value);
    }
    let told: String = fit.sentences().iter().map(|line| format!("- {}\n", line.to_string())).collect();
    let headers = ["Key", "Value", "Standard error", "Interval of 95 %"].map(|header| String::from(header));
    let rows = fit.estimates.all.iter().map(|e| {
        let [value, error, interval] = cells(e);
        [e.key.clone(), value, error, interval].map(Cell::plain)
    });
    let settings: String = fit.settings.iter().map(|setting| format!("--set \"{setting}\" ")).collect();
    let shown = table(Some(headers.each_ref().map(String::as_str)), rows.collect()) + "\n".into() + wrapped(&told);
    say(shown + format!("\n{}\n{}\n", settings.trim_end(), dir.display()).into())
}
