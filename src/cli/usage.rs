//! Arguments that fit no command, reported in the language of the answers, because clap's own texts are English.

use clap::Command;
use clap::error::{ContextKind, ContextValue, Error, ErrorKind};

use technolog::note::Note;
use technolog::words::say;

use super::help;
use super::words::Lang;

/// The fault of the arguments and its remedy; none where clap's own text is shown: help, version, and kinds of faults
/// that this command line cannot have.
pub fn message(error: &Error, command: &mut Command, arguments: &[String], lang: Lang) -> Option<String> {
    let context_text = |kind| error.get(kind).map(text).unwrap_or_default();
    let (argument, value) = (context_text(ContextKind::InvalidArg), context_text(ContextKind::InvalidValue));
    let about = |code: &'static str| Note::new(code).with("argument", &argument).with("value", &value);
    let note = match error.kind() {
        ErrorKind::MissingRequiredArgument => about("usage-missing"),
        ErrorKind::UnknownArgument => about("usage-unknown"),
        ErrorKind::InvalidSubcommand => {
            Note::new("usage-no-command").with("command", context_text(ContextKind::InvalidSubcommand))
        }
        ErrorKind::MissingSubcommand => Note::new("usage-command-missing"),
        ErrorKind::InvalidValue if value.is_empty() => about("usage-value-missing"),
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => match std::error::Error::source(error) {
            Some(why) => about("usage-bad-value-because").with("why", why.to_string()),
            None => about("usage-bad-value"),
        },
        ErrorKind::ArgumentConflict => {
            let other = context_text(ContextKind::PriorArg);
            if other == argument || other.is_empty() {
                about("usage-twice")
            } else {
                about("usage-conflict").with("other", other)
            }
        }
        ErrorKind::NoEquals | ErrorKind::TooManyValues | ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues => {
            about("usage-count")
        }
        ErrorKind::InvalidUtf8 => Note::new("usage-not-utf8"),
        _ => return None,
    };
    let mut message = format!("{}: {}", lang.word("cli-error"), lang.say(&note));
    let mut more = |code: &'static str, values: String| {
        if !values.is_empty() {
            message.push_str(&format!("\n  {}", lang.say(&Note::new(code).with("values", values))));
        }
    };
    // Of the formats that the program knows each command has only some.
    match help::formats_of(arguments, command).filter(|_| argument.starts_with("--format")) {
        Some(formats) => more("usage-of-command", formats),
        None => more("usage-possible-values", context_text(ContextKind::ValidValue)),
    }
    for kind in [ContextKind::SuggestedArg, ContextKind::SuggestedSubcommand, ContextKind::SuggestedValue] {
        more("usage-similar", context_text(kind));
    }
    let usage = context_text(ContextKind::Usage);
    let usage = if usage.is_empty() { usage_of(command, arguments) } else { usage };
    let usage = usage.trim().trim_start_matches("Usage:").trim();
    let usage = worded(usage, lang);
    Some(format!("{message}\n\n{}: {usage}\n\n{}\n", lang.word("help-usage"), lang.word("usage-more")))
}

/// The usage of the command in the arguments, if they name one.
fn usage_of(command: &mut Command, arguments: &[String]) -> String {
    command.build();
    let named = arguments.iter().find(|argument| command.find_subcommand(argument).is_some());
    let mut inner = named.and_then(|name| command.find_subcommand(name)).cloned();
    inner.as_mut().unwrap_or(command).render_usage().to_string()
}

/// A whole number within limits; the error gives the limits.
///
/// # Errors
/// It is none, or outside the limits.
pub fn whole_number<const LEAST: u32, const MOST: u32>(text: &str) -> Result<u32, String> {
    let number = text.parse().ok().filter(|number| (LEAST..=MOST).contains(number));
    number.ok_or_else(|| say!(help::requested_language(), "usage-whole-number", least = LEAST, most = MOST))
}

/// The usage line with its two words in the language.
pub fn worded(text: &str, lang: Lang) -> String {
    text.replace("[OPTIONS]", lang.word("usage-options")).replace("<COMMAND>", lang.word("usage-command"))
}

/// A value of an error's context as text.
fn text(value: &ContextValue) -> String {
    match value {
        ContextValue::String(text) => text.clone(),
        ContextValue::Strings(texts) => texts.join(", "),
        ContextValue::StyledStr(text) => text.to_string(),
        ContextValue::StyledStrs(texts) => texts.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "),
        ContextValue::Number(number) => number.to_string(),
        ContextValue::Bool(yes) => yes.to_string(),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message_of(arguments: &[&str]) -> String {
        let mut command = help::command(Lang::UK);
        let error = command.clone().try_get_matches_from(arguments).unwrap_err();
        let arguments: Vec<String> = arguments.iter().map(|&argument| argument.to_owned()).collect();
        message(&error, &mut command, &arguments[1..], Lang::UK).unwrap_or_default()
    }

    #[test]
    fn mistakes_of_arguments_are_told_in_ukrainian() {
        for (arguments, expected) in [
            (&["technolog", "turn"][..], "помилка: бракує аргументів: <SHAFT.yaml>"),
            (&["technolog", "frob"], "помилка: невідома команда `frob`"),
            (
                &["technolog", "turn", "x", "--objectiv"],
                "помилка: невідомий параметр чи зайве слово `--objectiv`\n  підказка: можливо, --objective",
            ),
            (
                &["technolog", "turn", "x", "--objective", "foo"],
                "помилка: значення `foo` не годиться для `--objective <OBJECTIVE>`\n  можливі значення: path, path-and-passes, time, passes",
            ),
            (
                &["technolog", "turn", "x", "--objective"],
                "помилка: аргумент `--objective <OBJECTIVE>` потребує значення",
            ),
            (
                &["technolog", "turn", "x", "--number", "0"],
                "помилка: значення `0` не годиться для `--number <N>`: потрібне ціле число від 1 до 1000",
            ),
            (
                &["technolog", "order", "x", "--effort", "many"],
                "помилка: значення `many` не годиться для `--effort <N>`: потрібне ціле число від 0 до 100000",
            ),
            (
                &["technolog", "order", "x", "--tries", "many"],
                "помилка: значення `many` не годиться для `--tries <N>`: потрібне ціле число від 0 до 4294967295",
            ),
            (
                &["technolog", "turn", "x", "--per-pass", "-"],
                "помилка: значення `-` не годиться для `--per-pass <MM>`: потрібна довжина від 0 до 100000 мм",
            ),
            (
                &["technolog", "plan", "x", "--format", "odt"],
                "помилка: значення `odt` не годиться для `--format <FORMAT>`\n  Формат відповіді: text, markdown, html, json, yaml, hand",
            ),
            (&["technolog", "turn", "a", "b"], "помилка: невідомий параметр чи зайве слово `b`"),
            (
                &["technolog", "turn", "a", "--lang", "uk", "--lang", "en"],
                "помилка: аргумент `--lang <LANG>` вказано більше одного разу",
            ),
        ] {
            let text = message_of(arguments);
            assert!(text.starts_with(expected), "{arguments:?}: {text}");
            assert!(text.contains("\nВикористання: technolog") && !text.contains("error"), "{text}");
            assert!(!text.contains("OPTIONS") && !text.contains("COMMAND"), "{text}");
        }
    }

    #[test]
    fn the_usage_is_that_of_the_command() {
        let text = message_of(&["technolog", "order", "x", "--effort", "many"]);
        assert!(text.contains("\nВикористання: technolog order [ПАРАМЕТРИ] <FILE>\n"), "{text}");
    }

    #[test]
    fn help_and_version_stay_what_they_are() {
        let mut command = help::command(Lang::UK);
        let error = command.clone().try_get_matches_from(["technolog", "--version"]).unwrap_err();
        assert_eq!(message(&error, &mut command, &[], Lang::UK), None);
    }
}
