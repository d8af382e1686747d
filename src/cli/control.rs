//! Finds the machine, and the control of a program.

use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::machine::Machine;
use technolog::program::Language;
use technolog::words::say;

use super::{CliError, Context, words};

/// The given control, otherwise that of the machine's record.
///
/// # Errors
/// None is given, and the record names none, or one whose language is not known.
pub fn chosen<'a>(given: Option<&'a str>, machine: &Machine<'a>, context: &Context) -> Result<&'a str, CliError> {
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

/// The machine of that id.
///
/// # Errors
/// There is none (the error lists the existing ones), or its tables lack something.
pub fn machine<'k>(id: &str, knowledge: &'k Knowledge, context: &Context) -> Result<Machine<'k>, CliError> {
    let known: Vec<&str> = Machine::ids(knowledge).collect();
    if !known.contains(&id) {
        let message = say!(context.lang, "cli-no-machine", id = id);
        let help = say!(context.lang, "cli-known", names = known.join(", "));
        return Err(Diagnostic::error("unknown-machine", message, None).help(help).into());
    }
    Machine::find(knowledge, id).map_err(|error| CliError::of_knowledge(&error, context.lang))
}
