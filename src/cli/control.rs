//! Finds the machine, and the control of a program.

use std::sync::LazyLock;

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::machine::{self, Machine};
use technolog::program::Language;
use technolog::program::lathe::LatheLanguage;
use technolog::turning::tooling::Lathe;
use technolog::words::say;

use super::{CliError, Context, words};

/// The name of a control on the command line. Any name is taken: `--knowledge` may have records of more controls than ship,
/// which help and completion name.
#[derive(Clone, Copy, Debug)]
pub struct Names {
    /// Whether controls of lathes are named, too.
    pub lathes: bool,
}

impl TypedValueParser for Names {
    type Value = String;

    fn parse_ref(
        &self,
        command: &clap::Command,
        arg: Option<&clap::Arg>,
        value: &std::ffi::OsStr,
    ) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        static SHIPPED: LazyLock<Option<Knowledge>> = LazyLock::new(|| technolog::shipped::knowledge().ok());
        let knowledge = SHIPPED.as_ref()?;
        let lathes = LatheLanguage::NAMES.into_iter().filter(|_| self.lathes);
        let names: Vec<&str> = Language::names(knowledge).into_iter().chain(lathes).collect();
        Some(Box::new(names.into_iter().map(PossibleValue::new)))
    }
}

/// The given control, otherwise that of the machine's record, otherwise 2С42-65.
///
/// # Errors
/// None is given, and the record of the machine names none; or there is none of that name, or its language is not known.
pub fn chosen<'a>(
    given: Option<&'a str>,
    machine: Option<&Machine<'a>>,
    knowledge: &Knowledge,
    context: &Context,
) -> Result<&'a str, CliError> {
    let control = match (given, machine) {
        (Some(given), _) => given,
        (None, None) => Language::UNLESS_NAMED,
        (None, Some(machine)) => {
            let none = || unknown(words::no_control(context.lang, machine.id()), knowledge, context);
            machine.control.ok_or_else(none)?
        }
    };
    if Language::names(knowledge).contains(&control) {
        return Ok(control);
    }
    let message = match given {
        Some(_) => say!(context.lang, "cli-unknown-control", control = control),
        None => words::alien_control(context.lang, machine.map_or(control, Machine::id), control),
    };
    Err(unknown(message, knowledge, context))
}

fn unknown(message: String, knowledge: &Knowledge, context: &Context) -> CliError {
    let known = Language::names(knowledge).join(", ");
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
