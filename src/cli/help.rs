//! The help of the program in the language of the answers.

use clap::{Command, CommandFactory};

use super::Cli;
use super::help_uk::HELP_UK;
use super::words::Lang;

/// The language of help and usage, found before the arguments are read: that of `--lang`, if it stands there.
pub fn language(default: Lang) -> Lang {
    let mut arguments = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned());
    while let Some(argument) = arguments.next() {
        let value = match argument.strip_prefix("--lang") {
            Some("") => arguments.next(),
            Some(rest) => rest.strip_prefix('=').map(str::to_owned),
            None => continue,
        };
        match value.as_deref() {
            Some("uk") => return Lang::Uk,
            Some("en") => return Lang::En,
            _ => {}
        }
    }
    default
}

/// The command with its help in that language.
pub fn command(lang: Lang) -> Command {
    let english = Cli::command();
    match lang {
        Lang::En => english,
        Lang::Uk => ukrainian(english),
    }
}

const TEMPLATE: &str = "{about-with-newline}\nВикористання: {usage}\n\n{all-args}";

fn ukrainian(command: Command) -> Command {
    let names: Vec<String> = command.get_subcommands().map(|inner| inner.get_name().to_owned()).collect();
    let mut command = translated(command).subcommand_help_heading("Команди").disable_help_subcommand(true);
    for name in names {
        command = command.mut_subcommand(name, translated);
    }
    command
}

fn translated(command: Command) -> Command {
    let name = command.get_name().to_owned();
    let about = of(&name);
    let command = match about {
        Some(about) => command.about(about),
        None => command,
    };
    command.help_template(TEMPLATE).mut_args(|arg| {
        let heading = if arg.is_positional() { "Аргументи" } else { "Параметри" };
        let help = of(&format!("{name}.{}", arg.get_id()));
        let arg = arg.help_heading(heading);
        match help {
            Some(help) => arg.help(help),
            None => arg,
        }
    })
}

fn of(key: &str) -> Option<&'static str> {
    HELP_UK.iter().find(|(known, _)| *known == key).map(|(_, help)| *help)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_and_option_has_help_in_both_languages_and_no_help_is_left_over() {
        let root = Cli::command();
        let mut keys = Vec::new();
        for command in std::iter::once(&root).chain(root.get_subcommands()) {
            let name = command.get_name();
            assert!(command.get_about().is_some(), "{name} has no help in English");
            keys.push(name.to_owned());
            for arg in command.get_arguments() {
                let key = format!("{name}.{}", arg.get_id());
                assert!(arg.get_help().is_some(), "{key} has no help in English");
                keys.push(key);
            }
        }
        let mut known: Vec<&str> = HELP_UK.iter().map(|(key, _)| *key).collect();
        known.sort_unstable();
        keys.sort_unstable();
        assert_eq!(known, keys);
    }

    #[test]
    fn the_arguments_are_sound() {
        command(Lang::Uk).debug_assert();
        command(Lang::En).debug_assert();
    }
}
