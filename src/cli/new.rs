//! `stampflow new`: a case file to begin with; subcommands and options come from the list of templates.

use super::*;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use stampflow::author::templates::{self, Choice, TEMPLATES, Template};

pub fn new(matches: &ArgMatches) -> Result<Code> {
    let Some((name, matches)) = matches.subcommand() else {
        let options = |one: &'static Template| one.options().collect::<Vec<&Choice>>();
        let entry = |one: &'static Template| json!({ "name": one.name, "about": one.about, "options": options(one) });
        return emit(matches.get_flag("json"), TEMPLATES.iter().map(entry).collect(), || wrapped(templates::list()));
    };
    let template = templates::find(name)?;
    let value = |key: &'static str| Some((key, matches.get_one::<String>(key)?.as_str()));
    let options: Vec<_> = template.options().flat_map(Choice::keys).filter_map(value).collect();
    let (is_json, text) = (matches.get_flag("json"), template.fill(&options)?);
    size_doubts(&case::parse(&text, template.name, &[])?).iter().for_each(|doubt| warn(format!("warning: {doubt}")));
    let Some(path) = matches.get_one::<PathBuf>("output") else {
        return emit(is_json, json!({ "template": template.name, "case": text }), || text.into());
    };
    place::free(path, matches.get_flag("force"), &[], "-o")?;
    write(path, text.as_bytes()).map_err(unusable("--output"))?;
    let next = || format!("{0} is written; next: stampflow run {0} (or check {0} first)", path.display()).into();
    emit(is_json, json!({ "template": template.name, "file": path }), next)
}

fn flag(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name).long(name).action(ArgAction::SetTrue).help(help)
}

/// Refuses the next option as a value.
fn is_value(text: &str) -> Result<String, String> {
    let is_option = text.starts_with('-') && !text.contains(|c: char| c.is_ascii_digit());
    if is_option { Err("it is an option: the one before it needs a value".into()) } else { Ok(text.to_owned()) }
}

fn option(choice: &'static Choice, heading: &'static str) -> impl Iterator<Item = Arg> {
    let value = |key: &'static str, help: String| {
        let arg = Arg::new(key).long(key).value_name(choice.value.as_str()).allow_hyphen_values(true);
        let arg = arg.help_heading(heading).help(help).value_parser(is_value);
        let is_switch = choice.value == "SWITCH";
        if is_switch { arg.num_args(0..=1).require_equals(true).default_missing_value("yes") } else { arg }
    };
    let arg = value(&choice.key, format!("{} [default: {}]", choice.about, choice.default));
    // A height that is measured inside is a depth.
    let arg = if choice.about.starts_with("depth ") { arg.alias("depth") } else { arg };
    let diameter = choice.diameter.as_deref().map(|key| {
        let arg = value(key, format!("twice that, instead of --{}", choice.key)).conflicts_with(choice.key.as_str());
        if key == "punch-diameter" { arg.visible_alias("diameter") } else { arg }
    });
    std::iter::once(arg).chain(diameter)
}

fn subcommand(template: &'static Template) -> Command {
    let output = Arg::new("output").short('o').long("output").alias("out").value_name("FILE");
    let heading = |i: usize| if i < template.own.len() { "Sizes" } else { "Sheet" };
    Command::new(template.name)
        .about(template.about.as_str())
        .override_usage(format!("stampflow new {} [-o FILE] [--force] [OPTIONS]", template.name))
        .args(template.options().enumerate().flat_map(|(i, choice)| option(choice, heading(i))))
        // A word without an option: that before it is read first, and is the mistake if it has no value.
        .arg(Arg::new("word").hide(true).value_parser(|_: &str| Err::<String, _>("no option stands before it")))
        .arg(output.value_parser(value_parser!(PathBuf)).help("Write the case there instead of printing it"))
        .arg(flag("force", "Replace an existing file"))
        .arg(flag("json", "Print JSON, errors too"))
}

pub fn command(verb: Command) -> Command {
    verb.override_usage("stampflow new TEMPLATE [OPTIONS]\n       stampflow new --list")
        .arg(flag("list", "List all templates with their options"))
        .arg(flag("json", "Print JSON, errors too"))
        .subcommands(TEMPLATES.iter().map(subcommand))
        .subcommand_value_name("TEMPLATE")
        .subcommand_help_heading("Templates")
        .arg_required_else_help(true)
        .args_conflicts_with_subcommands(true)
        .allow_external_subcommands(true)
        .disable_help_subcommand(true)
        .after_help(help("new"))
}
