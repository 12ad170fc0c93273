//! What a shell wants to know of the command line: completions and manual pages.

use super::code::{BadRequest, Code};
use super::say::say;
use clap::Command;
use clap_complete::Shell;

pub const COMPLETIONS_HELP: &str = "\
Examples:
  stampflow completions bash > ~/.local/share/bash-completion/completions/stampflow
  stampflow completions zsh > ~/.zfunc/_stampflow
  stampflow completions fish > ~/.config/fish/completions/stampflow.fish";

pub const MAN_HELP: &str = "\
Examples:
  stampflow man > ~/.local/share/man/man1/stampflow.1
  stampflow man run > ~/.local/share/man/man1/stampflow-run.1";

/// Prints the completions of a shell.
pub fn completions(mut command: Command, shell: Shell) -> anyhow::Result<Code> {
    let mut bytes = Vec::new();
    let name = command.get_name().to_owned();
    clap_complete::generate(shell, &mut command, name, &mut bytes);
    say(String::from_utf8(bytes)?)
}

/// Prints the manual page of the program or of a verb.
pub fn man(mut command: Command, verb: Option<&str>) -> anyhow::Result<Code> {
    // Gives the verbs their names and the options that all have.
    command.build();
    if let Some(verb) = verb {
        command = match command.find_subcommand(verb) {
            Some(found) => found.clone(),
            None => {
                let verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
                return Err(BadRequest(format!("there is no verb `{verb}`; there are {}", verbs.join(", "))).into());
            }
        };
    }
    let mut bytes = Vec::new();
    clap_mangen::Man::new(command).render(&mut bytes)?;
    say(String::from_utf8(bytes)?)
}
