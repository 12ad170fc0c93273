//! `stampflow new`: a case file to begin with. Its subcommands and their options are read off the list of templates.

use super::code::{BadPath, Code, unusable};
use super::say::{say, say_json, warn};
use super::suggested::Suggested;
use super::table::wrapped;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use serde_json::{Value, json};
use stampflow::assess::SIZE_CHECKS;
use stampflow::author::templates::{self as template, Choice, SHEET, TEMPLATES, Template};
use stampflow::case;
use stampflow::results::{can_write, write};
use std::path::{Path, PathBuf};

/// What was asked for.
#[derive(Debug)]
pub enum Args {
    List {
        json: bool,
    },
    Case {
        template: &'static Template,
        /// Names of options and their values.
        given: Vec<(&'static str, String)>,
        output: Option<PathBuf>,
        force: bool,
        json: bool,
    },
}

pub fn new(args: &Args) -> anyhow::Result<Code> {
    let (template, given, output, force, json) = match args {
        Args::List { json: true } => return say_json(&TEMPLATES.iter().map(of).collect::<Vec<_>>()),
        Args::List { json: false } => return say(wrapped(&template::list())),
        Args::Case { template, given, output, force, json } => (template, given, output, force, json),
    };
    let given: Vec<(&str, &str)> = given.iter().map(|(key, value)| (*key, value.as_str())).collect();
    let text = template.fill(&given)?;
    let case = case::parse(&text, template.name, &[])?;
    for finding in SIZE_CHECKS.iter().filter_map(|check| check(case.model())) {
        warn(format!("warning: {}", finding.sentence()));
    }
    let Some(path) = output else {
        return if *json { say_json(&json!({ "template": template.name, "case": text })) } else { say(text) };
    };
    if !force && path.symlink_metadata().is_ok() {
        let what = format!("{} is there already and was left as it is", path.display());
        let help = "choose another name, or replace it with --force".into();
        return Err(BadPath { what, help, path: path.clone() }.into());
    }
    can_write(path).map_err(unusable("--output"))?;
    write(path, text.as_bytes())?;
    if *json {
        return say_json(&json!({ "template": template.name, "file": path }));
    }
    say(written(path))
}

/// A template for programs.
fn of(template: &Template) -> Value {
    let option = |choice: &Choice| {
        json!({
            "key": choice.key,
            "diameter": choice.diameter,
            "value": choice.kind.placeholder,
            "about": choice.about,
            "default": choice.default,
        })
    };
    json!({
        "name": template.name,
        "about": template.about,
        "options": template.options().map(option).collect::<Vec<_>>(),
    })
}

fn json() -> Arg {
    Arg::new("json")
        .long("json")
        .action(ArgAction::SetTrue)
        .help("Print JSON for programs instead, and errors as JSON too")
}

fn written(path: &Path) -> String {
    format!("{0} is written; next: stampflow run {0} (or check {0} first)", path.display())
}

impl clap::Args for Args {
    fn augment_args(command: Command) -> Command {
        command
            .override_usage("stampflow new TEMPLATE [OPTIONS]\n       stampflow new --list")
            .arg(Arg::new("list").long("list").action(ArgAction::SetTrue).help("List all templates with their options"))
            .arg(json())
            .subcommands(TEMPLATES.iter().map(subcommand))
            .subcommand_value_name("TEMPLATE")
            .subcommand_help_heading("Templates")
            .arg_required_else_help(true)
            .args_conflicts_with_subcommands(true)
            .disable_help_subcommand(true)
            .after_help(
                "Examples:\n  stampflow new cup -o cup.toml\n  stampflow new cup --punch-radius \"40 mm\" --height \"35 mm\" -o cup.toml\n  \
                 stampflow new v-bend --angle \"120 deg\"\n  stampflow new cup --material drawing-steel --thickness \"0.8 mm\"\n\nWithout -o the case is printed; a file that is there is left alone.",
            )
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

fn subcommand(template: &Template) -> Command {
    Command::new(template.name)
        .about(template.about)
        .override_usage(format!("stampflow new {} [-o FILE] [--force] [OPTIONS]", template.name))
        .args(template.own.iter().flat_map(|choice| [Some(option(choice, "Sizes")), diameter(choice)]).flatten())
        .args(SHEET.iter().map(|choice| option(choice, "Sheet")))
        .arg(
            Arg::new("output")
                .short('o')
                .long("output")
                .alias("out")
                .value_name("FILE")
                .value_parser(value_parser!(PathBuf))
                .help("Write the case there instead of printing it"),
        )
        .arg(Arg::new("force").long("force").action(ArgAction::SetTrue).help("Replace a file that is there"))
        .arg(json())
}

fn option(choice: &'static Choice, heading: &'static str) -> Arg {
    let arg = Arg::new(choice.key)
        .long(choice.key)
        .value_name(choice.kind.placeholder)
        .allow_hyphen_values(true)
        .help_heading(heading)
        .help(format!("{} [default: {}]", choice.about, choice.default));
    match choice.key {
        "material" => arg.value_parser(Suggested::SHEETS).hide_possible_values(true),
        _ => arg,
    }
}

/// The option that takes the diameter of a radius; that of the punch is the diameter that a part is called by.
fn diameter(choice: &'static Choice) -> Option<Arg> {
    let key = choice.diameter?;
    let arg = Arg::new(key)
        .long(key)
        .value_name(choice.kind.placeholder)
        .allow_hyphen_values(true)
        .conflicts_with(choice.key)
        .help_heading("Sizes")
        .help(format!("its diameter, instead of --{}", choice.key));
    Some(if key == "punch-diameter" { arg.visible_alias("diameter") } else { arg })
}

impl clap::FromArgMatches for Args {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let Some((name, matches)) = matches.subcommand() else {
            return Ok(Self::List { json: matches.get_flag("json") });
        };
        let template = template::find(name).expect("subcommands are templates");
        let value = |key: &'static str| Some((key, matches.get_one::<String>(key)?.clone()));
        Ok(Self::Case {
            template,
            given: template.options().flat_map(|choice| choice.keys()).filter_map(value).collect(),
            output: matches.get_one::<PathBuf>("output").cloned(),
            force: matches.get_flag("force"),
            json: matches.get_flag("json"),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
