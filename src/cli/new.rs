//! `stampflow new`: a case file to begin with; subcommands and options come from the list of templates.

use super::code::{BadPath, Code, unusable};
use super::options::Suggested;
use super::screen::{print, print_json, warn, wrapped};
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use serde_json::{Value, json};
use stampflow::assess::size_doubts;
use stampflow::author::templates::{self, Choice, SHEET, TEMPLATES, Template};
use stampflow::case;
use stampflow::results::{can_write, write};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  stampflow new cup -o cup.toml
  stampflow new cup --punch-radius \"40 mm\" --height \"35 mm\" -o cup.toml
  stampflow new v-bend --angle \"120 deg\"
  stampflow new cup --material drawing-steel --thickness \"0.8 mm\"

Without -o the case is printed; an existing file is left alone.";

/// The template and its options; `None` lists all templates.
#[derive(Debug)]
pub struct Args {
    case: Option<(&'static Template, Vec<(&'static str, String)>)>,
    output: Option<PathBuf>,
    force: bool,
    json: bool,
}

pub fn new(args: &Args) -> anyhow::Result<Code> {
    let Some((template, options)) = &args.case else {
        return match args.json {
            true => print_json(&TEMPLATES.iter().map(as_json).collect::<Vec<_>>()),
            false => print(wrapped(&templates::list())),
        };
    };
    let options: Vec<(&str, &str)> = options.iter().map(|(key, value)| (*key, value.as_str())).collect();
    let text = template.fill(&options)?;
    size_doubts(&case::parse(&text, template.name, &[])?).iter().for_each(|doubt| warn(format!("warning: {doubt}")));
    let Some(path) = &args.output else {
        return if args.json { print_json(&json!({ "template": template.name, "case": text })) } else { print(text) };
    };
    if !args.force && path.symlink_metadata().is_ok() {
        let what = format!("{} is there already and was left as it is", path.display());
        let help = "choose another name, or replace it with --force".into();
        return Err(BadPath { what, help, path: path.clone() }.into());
    }
    can_write(path).map_err(unusable("--output"))?;
    write(path, text.as_bytes())?;
    match args.json {
        true => print_json(&json!({ "template": template.name, "file": path })),
        false => print(format!("{0} is written; next: stampflow run {0} (or check {0} first)", path.display())),
    }
}

fn as_json(template: &Template) -> Value {
    let option = |choice: &Choice| {
        let Choice { key, kind, default, about, diameter } = choice;
        json!({ "key": key, "diameter": diameter, "value": kind.placeholder, "about": about, "default": default })
    };
    let options: Vec<Value> = template.options().map(option).collect();
    json!({ "name": template.name, "about": template.about, "options": options })
}

fn flag(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name).long(name).action(ArgAction::SetTrue).help(help)
}

fn subcommand(template: &'static Template) -> Command {
    let options = template.options().flat_map(|choice| {
        let heading = if SHEET.iter().any(|of_sheet| of_sheet.key == choice.key) { "Sheet" } else { "Sizes" };
        let value = |key| {
            let arg = Arg::new(key).long(key).value_name(choice.kind.placeholder).allow_hyphen_values(true);
            arg.help_heading(heading)
        };
        let arg = value(choice.key).help(format!("{} [default: {}]", choice.about, choice.default));
        let arg = match choice.key {
            "material" => arg.value_parser(Suggested::SHEETS).hide_possible_values(true),
            _ => arg,
        };
        let diameter = choice.diameter.map(|key| {
            let arg = value(key).help(format!("its diameter, instead of --{}", choice.key)).conflicts_with(choice.key);
            if key == "punch-diameter" { arg.visible_alias("diameter") } else { arg }
        });
        std::iter::once(arg).chain(diameter)
    });
    let output = Arg::new("output").short('o').long("output").alias("out").value_name("FILE");
    Command::new(template.name)
        .about(template.about)
        .override_usage(format!("stampflow new {} [-o FILE] [--force] [OPTIONS]", template.name))
        .args(options)
        .arg(output.value_parser(value_parser!(PathBuf)).help("Write the case there instead of printing it"))
        .arg(flag("force", "Replace an existing file"))
        .arg(flag("json", "Print JSON, errors too"))
}

impl clap::Args for Args {
    fn augment_args(command: Command) -> Command {
        command
            .override_usage("stampflow new TEMPLATE [OPTIONS]\n       stampflow new --list")
            .arg(flag("list", "List all templates with their options"))
            .arg(flag("json", "Print JSON, errors too"))
            .subcommands(TEMPLATES.iter().map(subcommand))
            .subcommand_value_name("TEMPLATE")
            .subcommand_help_heading("Templates")
            .arg_required_else_help(true)
            .args_conflicts_with_subcommands(true)
            .disable_help_subcommand(true)
            .after_help(EXAMPLES)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl clap::FromArgMatches for Args {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let Some((name, matches)) = matches.subcommand() else {
            return Ok(Self { case: None, output: None, force: false, json: matches.get_flag("json") });
        };
        let template = templates::find(name).expect("subcommands are templates");
        let value = |key: &'static str| Some((key, matches.get_one::<String>(key)?.clone()));
        Ok(Self {
            case: Some((template, template.options().flat_map(Choice::keys).filter_map(value).collect())),
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
