//! `technolog turn`: the roughing passes of a shaft, the shortest sequence compared with usual ones; and operations
//! of turned parts.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use technolog::cases::FileKind;
use technolog::document::Document;
use technolog::error::KnowledgeError;
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::note::{Figure, Note};
use technolog::report::{self, Lang};
use technolog::turning::length::Half;
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::Form;
use technolog::turning::passes;
use technolog::turning::passes::cost::Objective;
use technolog::turning::shaft::{Mistake, Moves, Shaft};
use technolog::turning::ways;
use technolog::turning::workpiece::{Drawings, Workpiece, files_named, read_turned_with};
use technolog::units::{Micrometres, RevsPerMinute};
use technolog::words::say;

use super::diagnostics::Texts;
use super::input::FileRoots;
use super::turn_operation::{self, Control, Wanted};
use super::usage::whole_number;
use super::{CliError, Context, Format, Outcome, format, help, kind, knowledge};

// The roughing of a shaft: the shortest sequence of passes, beside longitudinal, transverse and one direction per step; levels, zones and removal schemes with their tool paths
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "SHAFT.yaml")]
    shaft: PathBuf,
    #[arg(long, value_enum, hide_possible_values = true, default_value = "path")]
    objective: Aim,
    #[arg(long, value_name = "MM", default_value = "1", value_parser = per_pass, allow_negative_numbers = true)]
    per_pass: Micrometres,
    #[arg(long, value_enum, hide_possible_values = true)]
    moves: Option<MovesName>,
    #[arg(long, value_enum, hide_possible_values = true, default_value = "passes")]
    show: Show,
    #[arg(long, value_enum, hide_possible_values = true, default_value = "linuxcnc")]
    control: Control,
    #[arg(long, value_name = "N", default_value = "1", value_parser = whole_number::<1, 1_000>)]
    number: u32,
    #[arg(long, value_enum, hide_possible_values = true)]
    variant: Option<WayName>,
    #[arg(long, value_name = "RPM", value_parser = whole_number::<1, 20_000>)]
    spindle: Option<u32>,
    #[arg(long)]
    force: bool,
}

/// The requested output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Show {
    Passes,
    Steps,
    Map,
    Operation,
    Schemes,
    Program,
    Cycle,
    Setting,
    ToolTable,
}

impl Show {
    /// The form of the program, if one is requested.
    const fn program(self) -> Option<Form> {
        match self {
            Self::Program => Some(Form::Motions),
            Self::Cycle => Some(Form::Cycles),
            _ => None,
        }
    }

    /// Its formats. A program and a tool table are text; their extensions are those of the control.
    const fn formats(self) -> (&'static str, &'static [Format]) {
        match self {
            Self::Program | Self::Cycle => ("turn --show=program", &[Format::Text]),
            Self::ToolTable => ("turn --show=tool-table", &[Format::Text]),
            Self::Setting => {
                ("turn --show=setting", &[Format::Text, Format::Markdown, Format::Html, Format::Json, Format::Yaml])
            }
            Self::Passes | Self::Steps | Self::Map | Self::Operation | Self::Schemes => ("turn", &FORMATS),
        }
    }
}

/// What can be shown, each with its formats.
pub fn shown() -> Vec<(String, &'static [Format])> {
    format::formats_of_each(Show::value_variants(), |show| show.formats().1)
}

/// Objectives by their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Aim {
    Path,
    PathAndPasses,
    Time,
    Passes,
}

/// Moves by their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MovesName {
    Basic,
    Rich,
}

/// Ways of roughing by their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum WayName {
    Longitudinal,
    Transverse,
    PerStep,
    Optimal,
    Verticals,
    Levels,
    HorizontalsA,
    HorizontalsB,
}

impl WayName {
    const fn name(self) -> &'static str {
        match self {
            Self::Longitudinal => "longitudinal",
            Self::Transverse => "transverse",
            Self::PerStep => "per-step",
            Self::Optimal => "optimal",
            Self::Verticals => "verticals",
            Self::Levels => "levels",
            Self::HorizontalsA => "horizontals-a",
            Self::HorizontalsB => "horizontals-b",
        }
    }
}

/// The formats of its pages.
const FORMATS: [Format; 6] = [Format::Text, Format::Markdown, Format::Html, Format::Json, Format::Yaml, Format::Svg];

/// Shows the passes of a shaft, or an operation.
///
/// # Errors
/// The file cannot be used; all its mistakes are reported at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let (command, formats) = args.show.formats();
    let format = context.format(command, formats)?;
    let knowledge = knowledge::load(context)?;
    let mut read = read(&args.shaft, knowledge, context)?;
    if let (Some(shaft), Some(moves)) = (&mut read.shaft, args.moves) {
        shaft.roughing.moves = if moves == MovesName::Rich { Moves::Rich } else { Moves::Basic };
    }
    if let Some(form) = args.show.program() {
        let operation = operation_of(&read, args, knowledge, context)?;
        let spindle = args.spindle.map(|speed| RevsPerMinute(f64::from(speed)));
        let wanted = Wanted { control: args.control, form, number: args.number as usize, spindle, force: args.force };
        return turn_operation::program(&operation, wanted, knowledge, context);
    }
    if matches!(args.show, Show::Setting | Show::ToolTable) {
        let operation = operation_of(&read, args, knowledge, context)?;
        return match args.show {
            Show::Setting => turn_operation::setting(&operation, args.control, format, knowledge, context),
            _ => turn_operation::tool_table(&operation, args.control, knowledge, context),
        };
    }
    let operation = || turn_operation::page(&read, args.show == Show::Schemes, knowledge, format, context);
    let shaft = match &read.shaft {
        _ if matches!(args.show, Show::Operation | Show::Schemes) => return operation(),
        Some(shaft) => shaft,
        None if matches!(args.show, Show::Steps | Show::Map) => return Err(refused("only-for-steps", context)),
        None => return operation(),
    };
    let objective = objective(args, shaft, context)?;
    if args.show == Show::Map {
        let map = passes::map::map(shaft, objective);
        match format {
            Format::Json => context.emit_json(&map)?,
            Format::Yaml => context.emit_yaml(&map)?,
            Format::Svg => context.emit_cleaned(&report::turning::map_drawing(&read.name, &map, context.lang))?,
            _ => {
                let page = report::turning::map_page(&read.name, &map, context.lang);
                drawn(page, format, context, "turn-map-figure", |lang| {
                    report::turning::map_drawing(&read.name, &map, lang)
                })?;
            }
        }
        return Ok(Outcome::Done);
    }
    let lacking = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let Some(found) = ways::find(&read, objective, knowledge).map_err(lacking)? else { return operation() };
    match format {
        Format::Json => context.emit_json(&found)?,
        Format::Yaml => context.emit_yaml(&found)?,
        Format::Svg if args.show == Show::Steps => {
            context.emit_cleaned(&report::turning::frames(&found.sequences, context.lang))?
        }
        Format::Svg => context.emit_cleaned(&report::turning::drawing(&found, context.lang))?,
        _ => {
            let page = report::turning::page(&found, knowledge, context.amount.doubts(), context.lang);
            drawn(page, format, context, "turn-figure", |lang| report::turning::drawing(&found, lang))?;
        }
    }
    Ok(if found.is_wrong() { Outcome::Findings } else { Outcome::Done })
}

/// The operation whose programs are written.
fn operation_of(
    read: &Workpiece,
    args: &Args,
    knowledge: &Knowledge,
    context: &Context,
) -> Result<Operation, CliError> {
    let Some(way) = args.variant else { return turn_operation::plan(read, knowledge, context) };
    let only = || refused("only-for-steps", context);
    let aim = objective(args, read.shaft.as_ref().ok_or_else(only)?, context)?;
    let lacking = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let ways = ways::find(read, aim, knowledge).map_err(lacking)?.ok_or_else(only)?;
    let taken = ways.ways.iter().find(|one| one.name == way.name());
    if let Some(why) = taken.and_then(|one| one.refused.as_ref()) {
        let told = say!(context.lang, "turn-ways-refused", way = Figure::word(way.name()), why = why);
        super::output::complain(&format!("{told}\n"));
    }
    ways.operation_by(way.name()).ok_or_else(|| refused("way-without-tool", context))
}

/// Writes a page; HTML also shows its drawing, under a caption of the message catalogue.
///
/// # Errors
/// It cannot be written.
pub fn drawn(
    mut page: Document,
    format: Format,
    context: &Context,
    caption: &str,
    draw: impl FnOnce(Lang) -> String,
) -> Result<(), CliError> {
    if format == Format::Html {
        let caption = context.lang.word(caption);
        page.push(report::turning::figure_of(draw(context.lang), caption, context.lang));
    }
    context.emit_document(&page, format)
}

/// The distance added by a pass: 0 to 100,000 mm, so that sums stay exact.
fn per_pass(text: &str) -> Result<Micrometres, String> {
    const MOST: i64 = 100_000;
    let length = text.parse().ok().filter(|length| (Micrometres::ZERO..=Micrometres::from_mm(MOST)).contains(length));
    length.ok_or_else(|| say!(help::requested_language(), "usage-length", most = MOST))
}

fn objective(args: &Args, shaft: &Shaft, context: &Context) -> Result<Objective, CliError> {
    let refused = |code: &'static str| refused(code, context);
    Ok(match args.objective {
        Aim::Path => Objective::Path,
        Aim::PathAndPasses => Objective::PathAndPasses { per_pass_mm: Half::of(args.per_pass) },
        Aim::Passes => Objective::Passes,
        Aim::Time if shaft.roughing.moves == Moves::Rich => return Err(refused("rich-has-no-time")),
        Aim::Time => Objective::Time { rates: shaft.rates.ok_or_else(|| refused("no-rates"))? },
    })
}

/// The refusal with that code: the command cannot do it with the given input.
pub fn refused(code: &'static str, context: &Context) -> CliError {
    let note = Note::new(code);
    let problem = Diagnostic::error(code, context.lang.say(&note), None);
    CliError::from(problem.help(context.lang.remedy(&note).unwrap_or_default()))
}

/// Reads a shaft.
///
/// # Errors
/// The file cannot be used; all its mistakes are reported at once.
pub fn read(path: &Path, knowledge: &Knowledge, context: &Context) -> Result<Workpiece, CliError> {
    let shown = path.display().to_string();
    let text = context.text(path)?;
    // Tables of points and drawings that its contours name.
    let (mut drawings, mut texts) = (Drawings::default(), Texts::default());
    for name in files_named(&shown, &text) {
        // This command has no option that lets a file name others anywhere.
        let outside = context.word("file-outside");
        let read = FileRoots { folder: None, anywhere: false }.text(path, &name, context);
        let read = read.map_err(|why| if why == outside { context.word("file-not-beside").to_owned() } else { why });
        if let Ok(text) = &read {
            texts = texts.with(&name, name.clone(), Cow::Owned(text.clone()));
        }
        drawings.add(&name, read);
    }
    read_turned_with(&shown, &text, &drawings, knowledge).map_err(|mistakes| CliError::Unusable {
        problems: {
            let problems = mistakes.into_iter().map(|mistake| problem(mistake, context)).collect();
            kind::or_other(&shown, &text, FileKind::Turned, problems, context)
        },
        texts: texts.with(&shown, shown.clone(), Cow::Owned(text)),
    })
}

/// A mistake in the language of the reader.
pub fn problem(mistake: Mistake, context: &Context) -> Diagnostic {
    match mistake {
        Mistake::Form(problem) => problem,
        Mistake::Meaning(code, note, place) => {
            let problem = Diagnostic::error(code, context.lang.say(&note), place);
            match context.lang.remedy(&note) {
                Some(remedy) => problem.help(remedy),
                None => problem,
            }
        }
    }
}
