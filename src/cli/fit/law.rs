//! A hardening law from tension tests.

use super::super::code::{BadRequest, Code};
use super::super::many::{asked, write_all};
use super::super::say::{say, say_json};
use super::super::table::{Cell, table, wrapped};
use super::args::Args;
use super::shown::{cells, csv, json_of};
use serde_json::{Value, json};
use stampflow::message::Message;
use stampflow::output::study::fit_law;
use stampflow::study::fit::{Direction, FlowCurve, LawFit, LawFits, Reduction, Tension, fit_laws, material_text};
use stampflow::units::{four_digits, trimmed};

pub fn law(args: &Args) -> anyhow::Result<Code> {
    let options = &args.of_law;
    if !args.vary.is_empty() || !args.to.is_empty() {
        return Err(BadRequest("--vary and --to are of a case: name its file in place of a test".into()).into());
    }
    let fits = fit_laws(curves(args)?, options.law, options.rate_law).map_err(asked)?;
    let form = args.many.told.form();
    let dir = args.many.folder(&args.files[0], "fit");
    let best = fits.best();
    let text = material_text(&fits, best);
    let value = json(&fits, &text);
    let rows = fits.fits.iter().flat_map(|fit| fit.estimates.all.iter().map(|e| (fit.kind.name(), e)));
    let mut files = vec![
        ("fit.csv".to_owned(), csv(rows).into_bytes()),
        ("fit.json".to_owned(), serde_json::to_vec_pretty(&value)?),
        ("material.toml".to_owned(), text.clone().into_bytes()),
    ];
    files.extend(args.many.pictures.pictures().files("fit", &fit_law(&fits, form)));
    write_all(&dir, files)?;
    if args.many.json.json {
        return say_json(&value);
    }
    let mut lines: Vec<Message> = fits.tests.iter().map(FlowCurve::sentence).collect();
    lines.extend(fits.sentences());
    let told: String = lines.iter().map(|line| format!("- {}\n", line.told(form))).collect();
    let plain = |cells: [String; 4]| cells.map(Cell::plain);
    let mut rows: Vec<_> = fits.fits.iter().map(|fit| plain(row(fit, fit.kind == best.kind, form))).collect();
    rows.push(plain([const { String::new() }; 4]));
    rows.extend(best.estimates.all.iter().map(|e| {
        let [value, error, interval] = cells(e, form);
        plain([format!("  {}", e.key), value, format!("± {error}"), interval])
    }));
    let headers = ["Law", "R²", "Misses", "AIC"].map(|header| form.tell(header));
    let mut shown = wrapped(&told) + "\n".into() + table(Some(headers.each_ref().map(String::as_str)), rows);
    if !fits.directions.is_empty() {
        let headers = ["Direction", "Tests", "Stress ratio", "r"].map(|header| form.tell(header));
        let rows = fits.directions.iter().map(|d| plain(direction(d, form))).collect();
        shown = shown + "\n".into() + table(Some(headers.each_ref().map(String::as_str)), rows);
    }
    say(shown + format!("\n{text}\n{}\n", dir.display()).into())
}

fn row(fit: &LawFit, is_best: bool, form: stampflow::message::Form) -> [String; 4] {
    let number = |text: String| form.language.number(&text);
    let mark = if is_best { " *" } else { "" };
    [
        format!("{}{mark}", fit.kind.label()),
        number(trimmed(fit.r2, 5)),
        number(format!("{} MPa", four_digits(fit.rms))),
        number(trimmed(fit.aic, 1)),
    ]
}

fn direction(d: &Direction, form: stampflow::message::Form) -> [String; 4] {
    let number = |text: String| form.language.number(&text);
    let r = d.r.map_or_else(|| "–".to_owned(), |r| format!("{r:.3} ± {:.3}", d.r_error.unwrap_or(0.0)));
    [format!("{}°", trimmed(d.angle, 1)), d.tests.to_string(), number(trimmed(d.ratio, 4)), number(r)]
}

/// The tests, reduced.
fn curves(args: &Args) -> anyhow::Result<Vec<FlowCurve>> {
    let of = &args.of_law;
    let count = args.files.len();
    for (what, given) in [("--rate", of.rate.len()), ("--direction", of.direction.len())] {
        if given != 0 && given != count {
            return Err(BadRequest(format!("{what} has {given} values for {count} tests: give one each")).into());
        }
    }
    if let Some(rate) = of.rate.iter().find(|rate| !(**rate > 0.0 && rate.is_finite())) {
        return Err(BadRequest(format!("a strain rate of {rate} /s: it must be above 0")).into());
    }
    let reduction = Reduction { young: of.young, offset: of.offset, from: of.from, to: of.until };
    let one = |(i, path): (usize, &std::path::PathBuf)| {
        let curve = FlowCurve::of(&Tension::load(path, of.section, of.gauge)?, &reduction)?;
        Ok(FlowCurve { rate: of.rate.get(i).copied(), direction: of.direction.get(i).copied(), ..curve })
    };
    args.files.iter().enumerate().map(one).collect::<Result<_, _>>().map_err(asked)
}

fn json(fits: &LawFits, text: &str) -> Value {
    let of_fit = |fit: &LawFit| {
        let p = fit.estimates.all.len();
        let correlations: Vec<Vec<Option<f64>>> =
            (0..p).map(|i| (0..p).map(|j| fit.estimates.correlation(i, j)).collect()).collect();
        json!({
            "law": fit.kind.name(), "formula": fit.hardening.describe(), "rate": fit.rate.map(|rate| rate.to_string()),
            "r2": fit.r2, "rms_MPa": fit.rms, "aic": fit.aic, "bows": fit.bows, "points": fit.misses.len(),
            "parameters": fit.estimates.all.iter().map(json_of).collect::<Vec<_>>(), "correlations": correlations,
        })
    };
    let of_test = |test: &FlowCurve| {
        json!({
            "file": test.name, "young_MPa": test.young, "yield_stress_MPa": test.yield_stress, "strength_MPa": test.strength,
            "uniform_plastic_strain": test.uniform, "points": test.points.len(), "end": test.end(), "r": test.r.map(|r| r.0),
            "rate_per_s": test.rate, "direction_deg": test.direction,
        })
    };
    let of_direction = |d: &Direction| json!({ "direction_deg": d.angle, "tests": d.tests, "stress_ratio": d.ratio, "r": d.r, "r_error": d.r_error });
    json!({
        "best": fits.best().kind.name(),
        "laws": fits.fits.iter().map(of_fit).collect::<Vec<_>>(),
        "tests": fits.tests.iter().map(of_test).collect::<Vec<_>>(),
        "directions": fits.directions.iter().map(of_direction).collect::<Vec<_>>(),
        "told": fits.sentences().iter().map(ToString::to_string).collect::<Vec<_>>(),
        "material": text,
    })
}
