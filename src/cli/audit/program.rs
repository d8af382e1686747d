//! A program that is audited alone: its plan is read out of it.

use std::borrow::Cow;
use std::path::Path;

use technolog::audit::stated::Stated;
use technolog::audit::{Auditor, ProgramAlone};
use technolog::cases::FileKind;
use technolog::part::Part;
use technolog::program::Language;

use super::super::diagnostics::Texts;
use super::super::input::FileRoots;
use super::super::{CliError, Context, control, kind};
use super::file;

/// How the files of programs end; of any other a named control says that it is one.
const ENDINGS: [&str; 7] = ["nc", "ngc", "tap", "cnc", "gcode", "mpf", "eia"];

/// The machine of a program whose part is not named.
const MACHINE: &str = "gf2171";

/// What is asked.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The program.
    pub path: &'a Path,
    /// The control.
    pub control: Option<&'a str>,
    /// What the operator sets.
    pub setting: Option<&'a Path>,
    /// A list of tools.
    pub tools: Option<&'a Path>,
    /// The part.
    pub part: Option<&'a Part>,
}

/// Whether a file is a program: by its ending, or because a control is named for it.
pub fn is_program(path: &Path, has_control: bool) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    has_control || ENDINGS.contains(&ending.as_str())
}

/// The plan of a program.
///
/// # Errors
/// Every mistake of its list of tools or its setting, an unknown control, or a program without holes.
pub fn read(
    asked: &Asked<'_>,
    auditor: &Auditor<'_>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<Stated, CliError> {
    let knowledge = auditor.knowledge;
    let at_fault = |error: technolog::error::KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let shown = asked.path.display().to_string();
    let text = context.text(asked.path)?;
    let machine = asked.part.map_or(MACHINE, |part| part.machine.as_str());
    let machine = control::machine(machine, knowledge, context)?;
    let control = control::chosen(asked.control, Some(&machine), knowledge, context)?;
    let language = Language::read(control, knowledge).map_err(at_fault)?;
    let setting = match asked.setting {
        None => None,
        Some(path) => {
            let (name, text) = (path.display().to_string(), context.text(path)?);
            language.setting(&name, &text).map_err(|problems| CliError::Unusable {
                problems: kind::or_other(&name, &text, FileKind::Setting, problems, context),
                texts: Texts::default().with(&name, name.clone(), Cow::Owned(text.clone())),
            })?;
            Some((name, text))
        }
    };
    let tools = asked.tools.map(|path| file::read(path, asked.part, auditor, places, context)).transpose()?;
    let program = ProgramAlone {
        file: &shown,
        text: &text,
        control,
        setting: setting.as_ref().map(|(name, text)| (name.as_str(), text.as_str())),
        part: asked.part,
        tools: tools.as_ref(),
    };
    let read = program.read(knowledge).map_err(at_fault)?;
    read.map_err(|problem| CliError::Unusable {
        problems: vec![problem],
        texts: Texts::default().with(&shown, shown.clone(), Cow::Owned(text.clone())),
    })
}
