//! The help of the program in the language of the answers.

use clap::{Arg, Command, CommandFactory};

use technolog::words::say;

use super::Cli;
use super::words::Lang;

/// The language of help and usage, found before the arguments are parsed: that of `--lang`, if it is given.
pub fn language(default: Lang) -> Lang {
    let mut arguments = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned());
    while let Some(argument) = arguments.next() {
        let value = match argument.strip_prefix("--lang") {
            Some("") => arguments.next(),
            Some(rest) => rest.strip_prefix('=').map(str::to_owned),
            None => continue,
        };
        if let Some(lang) = value.and_then(|value| value.parse().ok()) {
            return lang;
        }
    }
    default
}

/// The same, from the arguments and the environment alone.
pub fn asked() -> Lang {
    language(Lang::of_environment(std::env::var("LANG").ok().as_deref()))
}

/// The command without any texts, for parsing arguments.
pub fn bare() -> Command {
    Cli::command().disable_help_subcommand(true)
}

/// The command with its help in that language.
pub fn command(lang: Lang) -> Command {
    let command = bare();
    let names: Vec<String> = command.get_subcommands().map(|inner| inner.get_name().to_owned()).collect();
    let heading = lang.word("help-commands");
    let command = told(command, lang).subcommand_help_heading(heading);
    names.into_iter().fold(command, |command, name| command.mut_subcommand(name, |inner| told(inner, lang)))
}

fn told(command: Command, lang: Lang) -> Command {
    let name = command.get_name().to_owned();
    let template = format!("{{about-with-newline}}\n{}: {{usage}}\n\n{{all-args}}", lang.word("help-usage"));
    let positional: Vec<_> = command.get_positionals().map(|arg| arg.get_id().clone()).collect();
    command.about(lang.word(&format!("help-{name}")).to_owned()).help_template(template).mut_args(|arg| {
        let heading = lang.word(if arg.is_positional() { "help-arguments" } else { "help-options" });
        // The texts that clap adds itself are English.
        let more = [values(&arg, lang), default(&arg, lang)].into_iter().flatten();
        let help = more.fold(lang.word(&key(&name, &arg)).to_owned(), |help, more| format!("{help} {more}"));
        let order = positional.iter().position(|id| id == arg.get_id());
        let arg = arg.help_heading(heading).help(help);
        let arg = if let Some(order) = order { arg.display_order(order) } else { arg };
        if arg.get_action().takes_values() { arg.hide_possible_values(true).hide_default_value(true) } else { arg }
    })
}

/// The possible values of an argument, where its help does not list them.
fn values(arg: &Arg, lang: Lang) -> Option<String> {
    let shown = !arg.is_hide_possible_values_set() && arg.get_action().takes_values();
    let values: Vec<String> =
        arg.get_possible_values().iter().filter(|_| shown).map(|value| value.get_name().to_owned()).collect();
    (!values.is_empty()).then(|| say!(lang, "help-values", values = values.join(", ")))
}

/// The default value of an argument.
fn default(arg: &Arg, lang: Lang) -> Option<String> {
    let default = arg.get_default_values().first().filter(|_| arg.get_action().takes_values())?;
    Some(say!(lang, "help-default", value = default.to_string_lossy().into_owned()))
}

/// The message of an argument.
fn key(command: &str, arg: &Arg) -> String {
    format!("help-{command}-{}", arg.get_id().as_str().replace('_', "-"))
}

#[cfg(test)]
mod tests {
    use technolog::words::Lang;

    use super::*;

    #[test]
    fn every_command_and_option_has_help_in_every_language() {
        let root = Cli::command();
        for command in std::iter::once(&root).chain(root.get_subcommands()) {
            let name = command.get_name();
            let arguments = command.get_arguments().map(|arg| key(name, arg));
            for key in arguments.chain([format!("help-{name}")]) {
                for lang in Lang::all() {
                    assert_ne!(lang.word(&key), key, "{lang:?}");
                    assert!(!lang.word(&key).contains("  "), "{lang:?} {key}");
                }
            }
        }
    }

    #[test]
    fn the_arguments_are_sound() {
        Lang::all().for_each(|lang| command(lang).debug_assert());
    }
}
