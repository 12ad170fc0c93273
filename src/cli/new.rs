//! `stampflow new`: a case file to begin with; subcommands and options come from the list of templates.

use super::*;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use stampflow::assess::size_doubts;
use stampflow::author::templates::{self, Choice, SHEET, TEMPLATES, Template};
use stampflow::results::can_write;

/// Writes a case, or lists all templates without a subcommand.
pub fn new(matches: &ArgMatches) -> Result<Code> {
    let Some((name, matches)) = matches.subcommand() else {
        return match matches.get_flag("json") {
            true => print_json(&TEMPLATES.iter().map(as_json).collect::<Vec<_>>()),
            false => print(wrapped(templates::list())),
        };
    };
    let template = templates::find(name)?;
    let value = |key: &'static str| Some((key, matches.get_one::<String>(key)?.as_str()));
    let options: Vec<_> = template.options().flat_map(Choice::keys).filter_map(value).collect();
    let (output, force, as_json) =
        (matches.get_one::<PathBuf>("output"), matches.get_flag("force"), matches.get_flag("json"));
    let text = template.fill(&options)?;
    size_doubts(&case::parse(&text, template.name, &[])?).iter().for_each(|doubt| warn(format!("warning: {doubt}")));
    let Some(path) = output else {
        return if as_json { print_json(&json!({ "template": template.name, "case": text })) } else { print(text) };
    };
    let help = "choose another name, or replace it with --force";
    let is_free = force || path.symlink_metadata().is_err();
    ensure!(is_free, bad_path(path, "is there already and was left as it is", help));
    can_write(path).map_err(error::unusable("--output"))?;
    write(path, text.as_bytes())?;
    match as_json {
        true => print_json(&json!({ "template": template.name, "file": path })),
        false => print(format!("{0} is written; next: stampflow run {0} (or check {0} first)", path.display())),
    }
}

fn as_json(template: &Template) -> Value {
    let options = template.options().map(|Choice { key, kind, default, about, diameter }| {
        json!({ "key": key, "diameter": diameter, "value": kind.placeholder, "about": about, "default": default })
    });
    json!({ "name": template.name, "about": template.about, "options": options.collect::<Vec<_>>() })
}

fn flag(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name).long(name).action(ArgAction::SetTrue).help(help)
}

fn option(choice: &'static Choice) -> impl Iterator<Item = Arg> {
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
}

fn subcommand(template: &'static Template) -> Command {
    let output = Arg::new("output").short('o').long("output").alias("out").value_name("FILE");
    Command::new(template.name)
        .about(template.about)
        .override_usage(format!("stampflow new {} [-o FILE] [--force] [OPTIONS]", template.name))
        .args(template.options().flat_map(option))
        .arg(output.value_parser(value_parser!(PathBuf)).help("Write the case there instead of printing it"))
        .arg(flag("force", "Replace an existing file"))
        .arg(flag("json", "Print JSON, errors too"))
}

/// Adds options and templates to the verb.
pub fn command(verb: Command) -> Command {
    verb.override_usage("stampflow new TEMPLATE [OPTIONS]\n       stampflow new --list")
        .arg(flag("list", "List all templates with their options"))
        .arg(flag("json", "Print JSON, errors too"))
        .subcommands(TEMPLATES.iter().map(subcommand))
        .subcommand_value_name("TEMPLATE")
        .subcommand_help_heading("Templates")
        .arg_required_else_help(true)
        .args_conflicts_with_subcommands(true)
        .disable_help_subcommand(true)
        .after_help(
            "Examples:\n  stampflow new cup -o cup.toml\n  stampflow new cup --material drawing-steel --thickness \"0.8 mm\"",
        )
}
