//! The help of the program in the language of the answers.

use std::ffi::OsString;

use clap::{Arg, Command, CommandFactory};

use technolog::words::say;

use super::format::names;
use super::words::Lang;
use super::{Cli, Format, audit, check, lint, lookup, order, plan, program, report, table, test, turn};

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
pub fn requested_language() -> Lang {
    language(Lang::of_environment(std::env::var("LANG").ok().as_deref()))
}

/// The arguments with the word `help` before a command, which people type too, as the option that it stands for.
pub fn asked_for(mut arguments: Vec<OsString>) -> Vec<OsString> {
    let is_option = |argument: &OsString| argument.to_string_lossy().starts_with('-');
    // The value of an option before it, `--lang en`, is not a command.
    let mut after = arguments.iter().zip(arguments.iter().skip(1));
    let first = after.position(|(before, argument)| !is_option(argument) && before.as_os_str() != "--lang");
    if let Some(place) =
        first.map(|place| place + 1).filter(|place| arguments.get(*place).is_some_and(|own| own == "help"))
    {
        arguments.remove(place);
        arguments.push(OsString::from("--help"));
    }
    arguments
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
    let command = translated(command, lang).subcommand_help_heading(heading);
    let format = command.get_arguments().find(|arg| arg.get_id() == "format").cloned();
    names.into_iter().fold(command, |command, name| {
        command.mut_subcommand(&name, |inner| {
            let inner = translated(inner, lang);
            // Of the options that all commands have, this one means something else for each.
            match format.clone() {
                Some(format) => inner.arg(format.help(formats(&name, lang))),
                None => inner,
            }
        })
    })
}

/// The formats of the command that the arguments name, as its help has them.
pub fn formats_of(arguments: &[String], command: &Command) -> Option<String> {
    let named = arguments.iter().find_map(|argument| command.find_subcommand(argument))?;
    let format = named.get_arguments().find(|arg| arg.get_id() == "format")?;
    format.get_help().map(ToString::to_string)
}

/// The formats of a command: the same for all its answers, or by what `--show` names.
fn formats(command: &str, lang: Lang) -> String {
    let one = |formats: &[Format]| say!(lang, "help-formats", formats = names(formats));
    let each = |shown: Vec<(String, &'static [Format])>| {
        let mut alike: Vec<(Vec<String>, &[Format])> = Vec::new();
        for (show, formats) in shown {
            match alike.iter_mut().find(|(_, known)| *known == formats) {
                Some((shows, _)) => shows.push(show),
                None => alike.push((vec![show], formats)),
            }
        }
        let lines = alike.iter().map(|(shows, formats)| format!("{} – {}", shows.join(", "), names(formats)));
        say!(lang, "help-formats-by-show", formats = lines.collect::<Vec<_>>().join("; "))
    };
    match command {
        "plan" => one(plan::FORMATS),
        "explain" => one(plan::EXPLAIN_FORMATS),
        "order" => one(order::FORMATS),
        "turn" => each(turn::shown()),
        "program" => each(program::shown()),
        "report" => one(report::FORMATS),
        "audit" => {
            let more: Vec<Format> =
                audit::FOLDER_FORMATS.iter().filter(|one| !audit::FORMATS.contains(one)).copied().collect();
            say!(lang, "help-formats-of-folder", formats = names(audit::FORMATS), more = names(&more))
        }
        "table" => one(table::FORMATS),
        "lookup" => one(lookup::FORMATS),
        "check" => one(check::FORMATS),
        "lint" => one(lint::FORMATS),
        "test" => one(test::FORMATS),
        _ => lang.word("help-technolog-format").to_owned(),
    }
}

fn translated(command: Command, lang: Lang) -> Command {
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

    /// `--help` of a command tells its own formats: `plan` writes no SVG, and of `program` only the sheet is CSV.
    #[test]
    fn the_help_of_each_command_lists_its_own_formats() {
        for lang in Lang::all() {
            let mut root = command(lang);
            root.build();
            let general = lang.word("help-technolog-format");
            for inner in root.get_subcommands() {
                let formats: Vec<&Arg> = inner.get_arguments().filter(|arg| arg.get_id() == "format").collect();
                let [format] = formats.as_slice() else { panic!("{}: {formats:?}", inner.get_name()) };
                let help = format.get_help().map(ToString::to_string).unwrap_or_default();
                // A report is for people only.
                let own = if inner.get_name() == "report" { "html" } else { "json" };
                assert!(help != general && help.contains(own), "{}: {help}", inner.get_name());
                let (svg, csv) = (help.contains("svg"), help.contains("csv"));
                let expected = match inner.get_name() {
                    "program" => (true, true),
                    "order" | "turn" | "check" => (true, false),
                    "table" | "plan" | "audit" => (false, true),
                    _ => (false, false),
                };
                assert_eq!((svg, csv), expected, "{}: {help}", inner.get_name());
            }
        }
    }

    #[test]
    fn the_arguments_are_sound() {
        Lang::all().for_each(|lang| command(lang).debug_assert());
    }
}
