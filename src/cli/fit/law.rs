//! A hardening law from tension tests.

use super::super::code::{BadRequest, Code};
use super::super::many::{asked, write_all};
use super::super::say::{say, say_json};
use super::super::table::{Cell, table, wrapped};
use super::args::Args;
use super::shown::{cells, csv};
use stampflow::output::study::{fit_law, json};
use stampflow::study::fit::{Direction, FlowCurve, LawFit, fit_laws, material_text};
use stampflow::units::{Amount, Digits};
use stampflow::units::{Unit, trimmed};

pub fn law(args: &Args) -> anyhow::Result<Code> {
    let options = &args.of_law;
    if !args.vary.is_empty() || !args.to.is_empty() {
        return Err(BadRequest("--vary and --to are of a case: name its file in place of a test".into()).into());
    }
    let fits = fit_laws(args.tests().curves().map_err(asked)?, options.law, options.rate_law).map_err(asked)?;
    let dir = args.many.folder(&args.files[0], "fit");
    let best = fits.best();
    let text = material_text(&fits, best);
    let value = json::fit_law(&fits);
    let rows = fits.fits.iter().flat_map(|fit| fit.estimates.all.iter().map(|e| (fit.kind.name(), e)));
    let mut files = vec![
        ("fit.csv".to_owned(), csv(rows).into_bytes()),
        ("fit.json".to_owned(), serde_json::to_vec_pretty(&value)?),
        ("material.toml".to_owned(), text.clone().into_bytes()),
    ];
    files.extend(args.many.pictures.pictures().files("fit", &fit_law(&fits)));
    write_all(&dir, files)?;
    if args.many.json.json {
        return say_json(&value);
    }
    let mut lines: Vec<String> = fits.tests.iter().map(FlowCurve::sentence).collect();
    lines.extend(fits.sentences());
    let told: String = lines.iter().map(|line| format!("- {}\n", line.to_string())).collect();
    let plain = |cells: [String; 4]| cells.map(Cell::plain);
    let mut rows: Vec<_> = fits.fits.iter().map(|fit| plain(row(fit, fit.kind == best.kind))).collect();
    rows.push(plain([const { String::new() }; 4]));
    rows.extend(best.estimates.all.iter().map(|e| {
        let [value, error, interval] = cells(e);
        plain([format!("  {}", e.key), value, format!("± {error}"), interval])
    }));
    let headers = ["Law", "R²", "Misses", "AIC"].map(|header| String::from(header));
    let mut shown = wrapped(&told) + "\n".into() + table(Some(headers.each_ref().map(String::as_str)), rows);
    if !fits.directions.is_empty() {
        let headers = ["Direction", "Tests", "Stress ratio", "r"].map(|header| String::from(header));
        let rows = fits.directions.iter().map(|d| plain(direction(d))).collect();
        shown = shown + "\n".into() + table(Some(headers.each_ref().map(String::as_str)), rows);
    }
    say(shown + format!("\n{text}\n{}\n", dir.display()).into())
}

fn row(fit: &LawFit, is_best: bool) -> [String; 4] {
    let mark = if is_best { " *" } else { "" };
    [
        String::from(fit.kind.label()) + mark,
        trimmed(fit.r2, 5),
        Amount::new(fit.rms, Unit::MPa, Digits::Significant(4)).to_string(),
        trimmed(fit.aic, 1),
    ]
}

fn direction(d: &Direction) -> [String; 4] {
    let r = d.r.map_or_else(|| "–".to_owned(), |r| format!("{r:.3} ± {:.3}", d.r_error.unwrap_or(0.0)));
    [format!("{}°", trimmed(d.angle, 1)), d.tests.to_string(), trimmed(d.ratio, 4), r]
}
