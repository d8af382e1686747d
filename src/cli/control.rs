//! Which control a program is for.

use technolog::knowledge::Diagnostic;
use technolog::machine::Machine;
use technolog::program::Language;

use super::{CliError, Context, words};

/// The control that is given, else that of the machine's record.
///
/// # Errors
/// None is given, and the record names none, or one whose language is not known.
pub fn meant<'a>(given: Option<&'a str>, machine: &Machine<'a>, context: &Context) -> Result<&'a str, CliError> {
    let Some(control) = given.or(machine.control) else {
        return Err(unknown(words::no_control(context.lang, machine.id()), context));
    };
    if Language::NAMES.contains(&control) {
        return Ok(control);
    }
    Err(unknown(words::alien_control(context.lang, machine.id(), control), context))
}

fn unknown(message: String, context: &Context) -> CliError {
    let known = Language::NAMES.join(", ");
    Diagnostic::error("unknown-control", message, None).help(words::name_control(context.lang, known)).into()
}
