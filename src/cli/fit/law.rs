//! A hardening law from tension tests.

use super::super::code::{BadRequest, Code};
use super::super::many::asked;
use super::super::say::{say, say_json};
use super::super::table::{Cell, table, wrapped};
use super::{Args, cells, csv, json_of, share, stress};
use anyhow::Context;
use serde_json::{Value, json};
use stampflow::message::Message;
use stampflow::output::study::fit_law;
use stampflow::output::write;
use stampflow::study::fit::{
    Direction, FlowCurve, Kind, LawFit, LawFits, RateKind, Reduction, Tension, fit_laws, material_text,
};
use stampflow::units::{four_digits, parse, trimmed};

#[derive(Debug, clap::Args)]
pub struct Options {
    /// Of tension tests: fit this law only
    #[arg(long, value_name = "LAW", value_parser = kind)]
    law: Option<Kind>,
    /// Young's modulus [default: the slope at the beginning]
    #[arg(long, value_name = "STRESS", value_parser = stress)]
    young: Option<f64>,
    /// Plastic strain at yield, where the law begins
    #[arg(long, value_name = "STRAIN", default_value = "0.2 %", value_parser = share)]
    offset: f64,
    /// Plastic strain where the fit begins, such as that behind a yield plateau [default: the offset]
    #[arg(long, value_name = "STRAIN", value_parser = share)]
    from: Option<f64>,
    /// Plastic strain where the fit ends [default: at the largest force]
    #[arg(long, value_name = "STRAIN", value_parser = share)]
    until: Option<f64>,
    /// Section of the specimen, for forces: "20 mm^2"
    #[arg(long, value_name = "AREA", value_parser = section)]
    section: Option<f64>,
    /// Gauge length, for elongations: "80 mm"
    #[arg(long, value_name = "LENGTH", value_parser = gauge)]
    gauge: Option<f64>,
    /// Strain rate of each test in 1/s, in their order: 0.001,1
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    rate: Vec<f64>,
    /// Law of the rate: power, johnson-cook or cowper-symonds
    #[arg(long, value_name = "LAW", default_value = "power", value_parser = rate_kind)]
    rate_law: RateKind,
    /// Direction of each test to that of rolling in degrees: 0,45,90
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    direction: Vec<f64>,
}

fn kind(name: &str) -> Result<Kind, String> {
    let names = || Kind::ALL.map(Kind::name).join(", ");
    Kind::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| format!("the laws are {}", names()))
}

fn rate_kind(name: &str) -> Result<RateKind, String> {
    match name {
        "power" => Ok(RateKind::Power),
        "johnson-cook" => Ok(RateKind::JohnsonCook),
        "cowper-symonds" => Ok(RateKind::CowperSymonds),
        _ => Err("the laws are power, johnson-cook and cowper-symonds".to_owned()),
    }
}

fn section(text: &str) -> Result<f64, String> {
    measured(text, "an area", "20 mm^2")
}

fn gauge(text: &str) -> Result<f64, String> {
    measured(text, "a length", "80 mm")
}

fn measured(text: &str, what: &str, example: &str) -> Result<f64, String> {
    let parsed = parse(text).map_err(|error| error.to_string())?;
    let fits = parsed.dimension.describe() == what && parsed.value > 0.0;
    fits.then_some(parsed.value).ok_or_else(|| format!("{text} is not {what}: write \"{example}\""))
}

pub fn law(args: &Args) -> anyhow::Result<Code> {
    let options = &args.of_law;
    if !args.vary.is_empty() || !args.to.is_empty() {
        return Err(BadRequest("--vary and --to are of a case: name its file in place of a test".into()).into());
    }
    let fits = fit_laws(options.curves(args)?, options.law, options.rate_law).map_err(asked)?;
    let form = args.told.form();
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
    files.extend(args.pictures.pictures().files("fit", &fit_law(&fits, form)));
    for (name, bytes) in files {
        write(&dir.join(&name), &bytes).with_context(|| format!("cannot write {name}"))?;
    }
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

impl Options {
    /// The tests, reduced.
    fn curves(&self, args: &Args) -> anyhow::Result<Vec<FlowCurve>> {
        let count = args.files.len();
        for (what, given) in [("--rate", self.rate.len()), ("--direction", self.direction.len())] {
            if given != 0 && given != count {
                return Err(BadRequest(format!("{what} has {given} values for {count} tests: give one each")).into());
            }
        }
        if let Some(rate) = self.rate.iter().find(|rate| !(**rate > 0.0 && rate.is_finite())) {
            return Err(BadRequest(format!("a strain rate of {rate} /s: it must be above 0")).into());
        }
        let reduction = Reduction { young: self.young, offset: self.offset, from: self.from, to: self.until };
        let one = |(i, path): (usize, &std::path::PathBuf)| {
            let curve = FlowCurve::of(&Tension::load(path, self.section, self.gauge)?, &reduction)?;
            Ok(FlowCurve { rate: self.rate.get(i).copied(), direction: self.direction.get(i).copied(), ..curve })
        };
        args.files.iter().enumerate().map(one).collect::<Result<_, _>>().map_err(asked)
    }
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
