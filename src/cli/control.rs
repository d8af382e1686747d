//! Finds the machine, and the control of a program.

use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::machine::{self, Machine};
use technolog::program::Language;
use technolog::turning::tooling::Lathe;
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
    let id = known(id, &Machine::ids(knowledge).collect::<Vec<_>>(), context)?;
    Machine::find(knowledge, id).map_err(|error| CliError::of_knowledge(&error, context.lang))
}

/// The lathe of that id.
///
/// # Errors
/// There is none (the error lists the existing ones), or its record lacks something.
pub fn lathe<'k>(id: &str, knowledge: &'k Knowledge, context: &Context) -> Result<Lathe<'k>, CliError> {
    let id = known(id, &Lathe::ids(knowledge), context)?;
    Lathe::find(knowledge, id).map_err(|error| CliError::of_knowledge(&error, context.lang))
}

/// Holds the machine of the command line against that of the part.
///
/// # Errors
/// They differ.
pub fn same_machine(named: &str, of_part: &str, context: &Context) -> Result<(), CliError> {
    if named == of_part {
        return Ok(());
    }
    let message = say!(context.lang, "cli-other-machine", asked = named, own = of_part);
    Err(Diagnostic::error("other-machine", message, None).help(context.word("cli-leave-machine")).into())
}

/// The id that a user means: as it is, or as the machine is called, `ГФ2171`.
fn known<'k>(typed: &str, known: &[&'k str], context: &Context) -> Result<&'k str, CliError> {
    let id = machine::id_of(typed);
    known.iter().find(|own| **own == id).copied().ok_or_else(|| {
        let message = say!(context.lang, "cli-no-machine", id = typed);
        let help = say!(context.lang, "cli-known", names = known.join(", "));
        Diagnostic::error("unknown-machine", message, None).help(help).into()
    })
}
