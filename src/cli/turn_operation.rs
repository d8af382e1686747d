//! The part of `technolog turn` for contours: the page of the whole operation, its drawing and its programs.

use clap::ValueEnum;
use serde::Serialize;
use technolog::audit::turned;
use technolog::document::Document;
use technolog::error::KnowledgeError;
use technolog::job::{GivenTimes, Norm, NormItem, NormedWork, norm_of};
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::note::{Finding, Note, Severity};
use technolog::report;
use technolog::turning::jobs::Work;
use technolog::turning::operation::Regrip;
use technolog::turning::operation::gauging::gauges;
use technolog::turning::operation::programs::{Form, OperationProgram, Remarks, programs, programs_named};
use technolog::turning::operation::setting;
use technolog::turning::operation::times::{Times, loading, times};
use technolog::turning::operation::tool_table;
use technolog::turning::operation::turret::{Put, stations};
use technolog::turning::operation::{self, Operation};
use technolog::turning::program::{Control as LatheControl, NotCycled, NotWritten, ProgramFile};
use technolog::turning::workpiece::Workpiece;
use technolog::units::{Minutes, RevsPerMinute};
use technolog::words::{Lang, say};

use super::diagnostics::{Texts, render};
use super::turn::drawn;
use super::{CliError, Context, Format, Outcome};

/// Controls of lathes by their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Control {
    Linuxcnc,
    Sinumerik,
    Fanuc,
    #[value(name = "nc-201")]
    Nc201,
}

impl Control {
    const ALL: [Self; 4] = [Self::Linuxcnc, Self::Sinumerik, Self::Fanuc, Self::Nc201];

    /// The control of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|control| control.name() == name)
    }

    /// The names of all.
    pub fn names() -> [&'static str; 4] {
        Self::ALL.map(Self::name)
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Linuxcnc => "linuxcnc",
            Self::Sinumerik => "sinumerik",
            Self::Fanuc => "fanuc",
            Self::Nc201 => "nc-201",
        }
    }
}

/// An operation with the times of its set-ups.
#[derive(Serialize)]
struct Answer<'a> {
    #[serde(flatten)]
    operation: &'a Operation,
    times: &'a [Times],
    #[serde(skip_serializing_if = "Option::is_none")]
    norm: Option<&'a Norm>,
}

/// The norm of time of a part that is made whole.
fn norm(
    operation: &Operation,
    times: &[Times],
    given: GivenTimes,
    knowledge: &Knowledge,
) -> Result<Option<Norm>, KnowledgeError> {
    if operation.has_errors() || times.is_empty() {
        return Ok(None);
    }
    let all = |time: fn(&Times) -> Minutes| times.iter().map(time).sum::<Minutes>();
    let because = Some(loading(knowledge)?);
    let each = times.first().map_or(Minutes(0.0), |times| times.load_min);
    // Nobody has a time for jaws that are loosened or tightened at a stop: that of clamping holds it.
    let grips = operation.set_ups.iter().filter_map(|one| Some(one.grip.as_ref()?.regrips(&one.jobs).len()));
    let regrips = NormItem { key: "norm-regrip", count: grips.sum(), each, because: because.clone() };
    let mut loading = vec![NormItem { key: "norm-loading", count: times.len(), each, because }];
    loading.extend(Some(regrips).filter(|one| one.count > 0));
    let work = NormedWork {
        cutting: all(|times| times.cutting_min).rounded(2),
        machine: all(|times| times.rapid_min + times.tool_change_min + times.spindle_start_min),
        hands: Minutes(0.0),
        loading,
        gauges: gauges(operation),
        settings: 1 + held_otherwise(operation),
        soft_jaws: operation.set_ups.iter().filter(|one| one.jaws.is_some_and(|jaws| jaws.soft)).count(),
        tools: stations(operation).len(),
        zeros: times.len(),
    };
    norm_of(work, given, knowledge).map(Some)
}

/// How often a set-up is held by another kind of device than the one before it: the lathe is then set anew. Turned over between the
/// same centres, or in jaws that are bored anew, it is not.
fn held_otherwise(operation: &Operation) -> usize {
    let kinds: Vec<bool> = operation.set_ups.iter().map(|one| one.jaws.is_some()).collect();
    kinds.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// Shows the whole operation; a drawing has the toolpaths of all schemes if requested.
///
/// # Errors
/// The knowledge base lacks something, or the answer cannot be written.
pub fn page(
    workpiece: &Workpiece,
    all_schemes: bool,
    knowledge: &Knowledge,
    format: Format,
    context: &Context,
) -> Result<Outcome, CliError> {
    let mut operation = plan(workpiece, knowledge, context)?;
    let refused = refusals(&operation, knowledge).map_err(|error| CliError::of_knowledge(&error, context.lang))?;
    operation.findings.extend(refused);
    let times = times(&operation, knowledge).map_err(|error| CliError::of_knowledge(&error, context.lang))?;
    let norm = norm(&operation, &times, GivenTimes::default(), knowledge)
        .map_err(|error| CliError::of_knowledge(&error, context.lang))?;
    let answer = Answer { operation: &operation, times: &times, norm: norm.as_ref() };
    match format {
        Format::Json => context.emit_json(&answer)?,
        Format::Yaml => context.emit_yaml(&answer)?,
        Format::Svg => {
            context.emit_cleaned(&report::turning::operation_drawing(&operation, all_schemes, context.lang))?
        }
        _ => {
            let doubts = context.amount.doubts();
            let page =
                report::turning::operation_page(&operation, &times, norm.as_ref(), knowledge, doubts, context.lang);
            drawn(page, format, context, "turn-figure", |lang| {
                report::turning::operation_drawing(&operation, all_schemes, lang)
            })?;
        }
    }
    Ok(if operation.has_errors() { Outcome::Findings } else { Outcome::Done })
}

/// That a program of an operation would be refused, although nothing else is wrong with it: its page ends as its programs do.
fn refusals(operation: &Operation, knowledge: &Knowledge) -> Result<Vec<Finding>, KnowledgeError> {
    if operation.has_errors() {
        return Ok(Vec::new());
    }
    let control = Control::Linuxcnc.name();
    let mut findings = Vec::new();
    for program in programs(operation, control, Form::Motions, None, knowledge)? {
        let why = match program.files {
            Err(why) => Some(why).filter(NotWritten::is_found),
            Ok(files) => turned::read_back(operation, program.set_up, control, &files, knowledge)?
                .map(|why| NotWritten::Unsafe { why }),
        };
        let note = |why: NotWritten| {
            Note::new("turned-program-refused").with("number", program.set_up).with("why", why.note())
        };
        findings.extend(why.map(|why| Finding::of_part(Severity::Wrong, note(why))));
    }
    Ok(findings)
}

/// The requested program of an operation.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// The control.
    pub control: Control,
    /// With motions or with cycles.
    pub form: Form,
    /// The number of the program, from 1.
    pub number: usize,
    /// The spindle speed, where the user states it.
    pub spindle: Option<RevsPerMinute>,
    /// Whether a program that does not make the whole part is written all the same.
    pub force: bool,
}

/// Writes one program of an operation.
///
/// # Errors
/// There is no such program, or it cannot be written, with the reason.
pub fn program(
    operation: &Operation,
    wanted: Wanted,
    knowledge: &Knowledge,
    context: &Context,
) -> Result<Outcome, CliError> {
    let lacking = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let (control, form) = (wanted.control.name(), wanted.form);
    let named = |work: Work| context.lang.term("turn-does", work.name()).to_owned();
    let put = |put: &Put<'_>, offset: u32| context.lang.say(&put.note(offset));
    let single = |why: NotCycled| context.lang.say(&why.note());
    let regrip = |one: &Regrip| context.lang.say(&one.note());
    let remarks = Remarks { work: &named, put: &put, regrip: &regrip, single: &single };
    let all = programs_named(operation, control, form, wanted.spindle, remarks, knowledge).map_err(lacking)?;
    let Some(written) = wanted.number.checked_sub(1).and_then(|index| all.get(index)) else {
        let (message, help) = if all.is_empty() {
            (say!(context.lang, "turn-no-programs"), context.word("turn-see-operation").to_owned())
        } else {
            // A remedy is one sentence, so the lines are joined.
            let list = report::turning::programs_list(&all, context.lang);
            let known = list.lines().map(str::trim).collect::<Vec<_>>().join("; ");
            (say!(context.lang, "turn-no-such-program"), say!(context.lang, "turn-programs-are", known = known))
        };
        return Err(Diagnostic::error("no-such-program", message, None).help(help).into());
    };
    match &written.files {
        Ok(files) => {
            let read = turned::read_back(operation, written.set_up, wanted.control.name(), files, knowledge);
            if let Some(why) = read.map_err(lacking)? {
                let note = match wanted.form {
                    Form::Motions => NotWritten::Unsafe { why }.note(),
                    // The passes of a cycle are made by the control itself.
                    Form::Cycles => Note::new("turned-cycle-rejected").with("why", why),
                };
                return Ok(refused(operation, written, note, context));
            }
            if turned::reader(wanted.control.name(), knowledge).map_err(lacking)?.is_none() {
                super::output::complain(&say!(context.lang, "turn-not-read-back", control = wanted.control.name()));
            }
            let wrong = wrong(operation);
            if !wrong.is_empty() && !wanted.force {
                return Ok(unfinished(operation, context));
            }
            let files =
                if wrong.is_empty() { files.clone() } else { warned(files, control, &wrong, knowledge, context)? };
            let texts: Vec<&str> = files.iter().map(|file| file.text.as_str()).collect();
            context.emit(&texts.join("\n"))?;
            for why in &written.remarks {
                super::output::complain(&format!("{}\n", say!(context.lang, "turn-single-passes", why = why)));
            }
            super::output::complain(&report::turning::programs_list(&all, context.lang));
            if all.len() > 1 {
                let others = (1..=all.len()).filter(|number| *number != wanted.number);
                let others = others.map(|number| format!("--number {number}")).collect::<Vec<_>>().join(", ");
                let (number, set_up) = (wanted.number, written.set_up);
                let of = all.len();
                let text = say!(
                    context.lang,
                    "turn-one-of-programs",
                    number = number,
                    of = of,
                    set_up = set_up,
                    others = others
                );
                super::output::complain(&format!("{text}\n"));
            }
            Ok(leave(operation, context))
        }
        Err(error) if error.is_found() => Ok(refused(operation, written, error.note(), context)),
        Err(error) => Err(not_written(written, error.note(), context).into()),
    }
}

/// Shows the tool list and the setting sheet for the programs of an operation.
///
/// # Errors
/// The knowledge base lacks something, or the answer cannot be written.
pub fn setting(
    operation: &Operation,
    control: Control,
    format: Format,
    knowledge: &Knowledge,
    context: &Context,
) -> Result<Outcome, CliError> {
    let setting = set(operation, control, knowledge, context)?;
    match format {
        Format::Json => context.emit_json(&setting)?,
        Format::Yaml => context.emit_yaml(&setting)?,
        _ => context.emit_document(&report::turning::setting_page(&setting, context.lang), format)?,
    }
    Ok(leave(operation, context))
}

/// The report of a turned part: a page with everything, and whether something is wrong.
///
/// # Errors
/// The knowledge base lacks something.
pub fn report(
    read: &Workpiece,
    control: Control,
    given: GivenTimes,
    knowledge: &Knowledge,
    context: &Context,
) -> Result<(Document, Outcome), CliError> {
    let lacking = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let operation = plan(read, knowledge, context)?;
    let times = times(&operation, knowledge).map_err(lacking)?;
    let setting = set(&operation, control, knowledge, context)?;
    let named = |work: Work| context.lang.term("turn-does", work.name()).to_owned();
    let put = |put: &Put<'_>, offset: u32| context.lang.say(&put.note(offset));
    let single = |why: NotCycled| context.lang.say(&why.note());
    let regrip = |one: &Regrip| context.lang.say(&one.note());
    let remarks = Remarks { work: &named, put: &put, regrip: &regrip, single: &single };
    let all = programs_named(&operation, control.name(), Form::Motions, None, remarks, knowledge).map_err(lacking)?;
    let list = report::turning::programs_list(&all, context.lang);
    let is_read = turned::reader(control.name(), knowledge).map_err(lacking)?.is_some();
    let mut printed = Vec::new();
    for (program, makes) in all.iter().zip(list.lines()) {
        let mut remarks =
            program.remarks.iter().map(|why| say!(context.lang, "turn-single-passes", why = why)).collect::<Vec<_>>();
        if !is_read {
            remarks.push(say!(context.lang, "turn-not-read-back", control = control.name()));
        }
        let text = match &program.files {
            Err(error) => Err(context.lang.say(&error.note())),
            // As for the program alone: what does not make the whole part is not given out.
            Ok(_) if operation.has_errors() => Err(context.lang.say(&Note::new("program-not-written"))),
            Ok(files) => match turned::read_back(&operation, program.set_up, control.name(), files, knowledge)
                .map_err(lacking)?
            {
                Some(why) => Err(context.lang.say(&NotWritten::Unsafe { why }.note())),
                None => Ok(files.iter().map(|file| file.text.as_str()).collect::<Vec<_>>().join("\n")),
            },
        };
        printed.push(report::turning::Printed { makes: makes.to_owned(), text, remarks });
    }
    let unsafe_ = operation.has_errors() || printed.iter().any(|program| program.text.is_err());
    let norm = norm(&operation, &times, given, knowledge).map_err(lacking)?;
    let page =
        report::turning::report_page(&operation, &times, norm.as_ref(), &setting, &printed, knowledge, context.lang);
    Ok((page, if unsafe_ { Outcome::Findings } else { Outcome::Done }))
}

/// Writes the tool table of LinuxCNC.
///
/// # Errors
/// Another control was named, the knowledge base lacks something, or the answer cannot be written.
pub fn tool_table(
    operation: &Operation,
    control: Control,
    knowledge: &Knowledge,
    context: &Context,
) -> Result<Outcome, CliError> {
    if control.name() != tool_table::CONTROL {
        return Err(super::turn::refused("no-tool-table", context));
    }
    let setting = set(operation, control, knowledge, context)?;
    let head = say!(context.lang, "turn-tool-table-head", part = setting.part.as_str());
    let named = |work: Work| context.lang.term("turn-does", work.name()).to_owned();
    context.emit(&tool_table::tool_table(&setting, &head, named))?;
    Ok(leave(operation, context))
}

/// Says what is wrong with an operation, or doubtful, beside what goes to the machine, where nobody sees its page.
fn leave(operation: &Operation, context: &Context) -> Outcome {
    tell(operation, context);
    if !operation.has_errors() {
        return Outcome::Done;
    }
    super::output::complain(&format!("{}\n", context.word("turn-written-despite")));
    Outcome::Findings
}

/// Tells the findings of an operation; those about rows that nothing confirms are counted on its page.
fn tell(operation: &Operation, context: &Context) {
    let told = |finding: &&Finding| finding.severity <= Severity::Doubtful && !report::is_of_row(&finding.note);
    let told: Vec<&Finding> = operation.findings.iter().filter(told).collect();
    if !told.is_empty() {
        let problems = super::proof::part_diagnostics(&told, context);
        super::output::complain(&render(problems, &Texts::default(), context.amount, context.lang));
    }
}

/// What is wrong with an operation, each as a sentence for a remark, which is in letters that every control shows.
fn wrong(operation: &Operation) -> Vec<String> {
    let wrong = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    wrong.map(|finding| Lang::EN.say(&finding.note)).collect()
}

/// A program that does not make the whole part is not written.
fn unfinished(operation: &Operation, context: &Context) -> Outcome {
    tell(operation, context);
    let note = Note::new("program-not-written");
    let told = Diagnostic::error("not-written", context.lang.say(&note), None);
    let told = match context.lang.remedy(&note) {
        Some(remedy) => told.help(remedy),
        None => told,
    };
    super::output::complain(&render(vec![told], &Texts::default(), context.amount, context.lang));
    Outcome::Findings
}

/// The files of a program with the reasons why it must not be run at its head.
fn warned(
    files: &[ProgramFile],
    control: &str,
    reasons: &[String],
    knowledge: &Knowledge,
    context: &Context,
) -> Result<Vec<ProgramFile>, CliError> {
    let lacking = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let control = LatheControl::read(control, knowledge).map_err(lacking)?;
    let mut files = files.to_vec();
    if let Some(main) = files.first_mut()
        && let Ok(warned) = technolog::turning::program::warned(&control, main.clone(), reasons)
    {
        *main = warned;
    }
    Ok(files)
}

/// A program that must not be run is not written: something is found wrong, as on the page of the operation.
fn refused(operation: &Operation, written: &OperationProgram, note: Note, context: &Context) -> Outcome {
    tell(operation, context);
    let problem = not_written(written, note, context);
    super::output::complain(&render(vec![problem], &Texts::default(), context.amount, context.lang));
    Outcome::Findings
}

fn set(
    operation: &Operation,
    control: Control,
    knowledge: &Knowledge,
    context: &Context,
) -> Result<setting::Setting, CliError> {
    let set = setting::setting(operation, control.name(), knowledge);
    set.map_err(|error| CliError::of_knowledge(&error, context.lang))
}

fn not_written(written: &OperationProgram, note: Note, context: &Context) -> Diagnostic {
    let set_up = say!(context.lang, "turn-job-of", number = written.set_up);
    let text = say!(context.lang, "turn-tool-not-written", tool = set_up, why = &note);
    let problem = Diagnostic::error("not-written", text, None);
    match context.lang.remedy(&note) {
        Some(remedy) => problem.help(remedy),
        None => problem,
    }
}

/// Plans the operation of a part.
///
/// # Errors
/// The knowledge base lacks something.
pub fn plan(workpiece: &Workpiece, knowledge: &Knowledge, context: &Context) -> Result<Operation, CliError> {
    operation::plan(workpiece, knowledge).map_err(|error| CliError::of_knowledge(&error, context.lang))
}
