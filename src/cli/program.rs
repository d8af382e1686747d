//! `technolog program`: the NC program of a part, with its sheets and drawings.

use std::borrow::Cow;
use std::path::PathBuf;

use clap::ValueEnum;
use serde::Serialize;
use technolog::error::KnowledgeError;
use technolog::job::Job;
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::motion::MotionStep;
use technolog::motion::time::{Clock, Times};
use technolog::note::{Finding, Note, Severity};
use technolog::plan::{CuttingMethod, Plan};
use technolog::program::proof::{PlannedJob, Proof};
use technolog::program::written::{Form, ProgramLine, WrittenProgram};
use technolog::program::{Fault, Language, Setting};
use technolog::report;
use technolog::report::encoding::encoding_sheet;
use technolog::shop::Shop;
use technolog::words::say;

use super::diagnostics::{Texts, below, render, render_all};
use super::proof;
use super::usage::whole_number;
use super::{CliError, Context, Format, Lang, Outcome, check, control, format, knowledge, output, plan};

// The NC program of a part: planned, written, and read back before it is shown
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "PART.yaml")]
    part: PathBuf,
    #[arg(long, value_parser = control::Names { lathes: false })]
    control: Option<String>,
    #[arg(long, value_enum, default_value = "program", hide_possible_values = true)]
    show: Show,
    #[arg(long, value_name = "N", value_parser = whole_number::<1, 9999>)]
    number: Option<u32>,
    #[arg(long)]
    no_subprograms: bool,
    #[arg(long)]
    force: bool,
}

/// The sheets and drawings of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Show {
    Program,
    Setting,
    Encoding,
    Backplot,
    Cycles,
}

impl Show {
    const fn formats(self) -> &'static [Format] {
        match self {
            Self::Program => &[Format::Text, Format::Json],
            Self::Setting => &[Format::Yaml, Format::Text, Format::Markdown, Format::Html, Format::Json],
            Self::Encoding => &[Format::Text, Format::Markdown, Format::Html, Format::Json, Format::Csv],
            Self::Backplot | Self::Cycles => &[Format::Svg],
        }
    }
}

/// What can be shown, each with its formats.
pub fn shown() -> Vec<(String, &'static [Format])> {
    format::formats_of_each(Show::value_variants(), |show| show.formats())
}

/// The answer in JSON.
#[derive(Serialize)]
struct Answer<'a> {
    part: &'a str,
    control: &'a str,
    machine: &'a str,
    program: &'a str,
    lines: &'a [ProgramLine],
    job: &'a Job,
    trace: &'a [MotionStep],
    time: Times,
    findings: Vec<FindingMessage<'a>>,
    faults: &'a [Fault],
    proof: proof::Answer<'a>,
}

#[derive(Serialize)]
struct FindingMessage<'a> {
    message: String,
    #[serde(flatten)]
    finding: &'a Finding,
}

/// Writes the program of a part and checks it with the interpreter of its control.
///
/// # Errors
/// The part file cannot be used; all its mistakes are reported at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("program", args.show.formats())?;
    let knowledge = knowledge::load(context)?;
    let at_fault = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let plan = plan::make(&args.part, CuttingMethod::default(), knowledge, context)?;
    let machine = control::machine(&plan.part.machine, knowledge, context)?;
    let control = control::chosen(args.control.as_deref(), Some(&machine), knowledge, context)?;
    if let Some(number) = args.number.filter(|number| control == "2c42-65" && *number > 99) {
        let message = say!(context.lang, "program-number-beyond", number = number);
        return Err(Diagnostic::error("bad-number", message, None).into());
    }
    let made = Made::of(plan, control, (args.number, !args.no_subprograms), knowledge).map_err(at_fault)?;
    let Made { language, planned, written, setting, steps, times, faults, proof, .. } = &made;
    let (plan, job) = (&planned.plan, &planned.job);
    let (text, findings, reason) = (written.text(), made.findings(), made.reason());
    // Behind the last number a writer goes on with the first, which may be a program of somebody else.
    if let Some(number) = args.number.filter(|number| written.numbers.iter().any(|used| used < number)) {
        let count = written.numbers.iter().filter(|used| **used != number).count();
        let message = say!(context.lang, "program-numbers-run-out", number = number, count = count);
        return Err(Diagnostic::error("bad-number", message, None).into());
    }
    if job.setups.is_empty() && format != Format::Json {
        // No hole can be made: there is nothing to write, and half a program is worse than none.
        let problems = proof::part_diagnostics(&findings, context);
        output::complain(&render(problems, &Texts::default(), context.amount, context.lang));
        return Ok(Outcome::Findings);
    }
    let sheet = || encoding_sheet(written, job, plan, control, knowledge, context.lang).map_err(at_fault);
    match (args.show, format) {
        (Show::Encoding, Format::Json) => context.emit_json(&sheet()?)?,
        (Show::Encoding, Format::Csv) => context.emit_rows(sheet()?.rows_of_cells(), "\r\n")?,
        (Show::Encoding, _) => context.emit_document(&sheet()?.page(), format)?,
        (Show::Backplot, _) => {
            context.emit_cleaned(&report::backplot::backplot(steps, Some(&proof::frame(planned)), context.lang))?;
        }
        (Show::Cycles, _) => context.emit_cleaned(&report::cycles::page(job, plan, context.lang))?,
        (_, Format::Json) => context.emit_json(&Answer {
            part: &job.part,
            control,
            machine: &job.machine,
            program: &text,
            lines: &written.lines,
            job,
            trace: steps,
            time: *times,
            findings: findings.iter().map(|finding| with_message(finding, context)).collect(),
            faults,
            proof: proof::answer(proof, context),
        })?,
        (Show::Setting, Format::Yaml) => {
            context.emit_cleaned(&report::setting::file(setting, plan, job, context.lang))?
        }
        (Show::Setting, _) => {
            let of = (control, knowledge);
            context.emit_document(&report::setting::page(setting, plan, job, of, context.lang), format)?;
        }
        (Show::Program, _) => match &reason {
            None => context.emit(&text)?,
            Some(reason) if args.force => {
                // Remarks of a program are in letters that every control shows.
                let reason =
                    reason.hole.iter().fold(Lang::EN.say(&reason.note), |told, hole| format!("{hole}: {told}"));
                context.emit(&language.warned(written.clone(), &reason).text())?;
            }
            Some(_) => {}
        },
    }
    if format != Format::Json {
        complain(&findings, faults, proof, text, context);
        if args.show == Show::Program && reason.is_some() && !args.force {
            let note = Note::new("program-not-written");
            let help = context.lang.remedy(&note).map(Into::into);
            let message = context.lang.say(&note);
            let told = Diagnostic { help, ..Diagnostic::error("not-written", message, None) };
            output::complain(&render(vec![told], &Texts::default(), context.amount, context.lang));
        }
    }
    Ok(if reason.is_some() { Outcome::Findings } else { Outcome::Done })
}

/// A program of a plan: written, and read back by the interpreter of its control.
pub struct Made {
    language: Language,
    /// The plan with its job.
    pub planned: PlannedJob,
    /// The program.
    pub written: WrittenProgram,
    /// The operator's setting.
    pub setting: Setting,
    /// The motions of the program, read back.
    pub steps: Vec<MotionStep>,
    times: Times,
    faults: Vec<Fault>,
    undone: Vec<Finding>,
    proof: Proof,
}

impl Made {
    /// Writes the program of a plan and reads it back; `number` is that of the program, with whether it may have
    /// subprograms.
    ///
    /// # Errors
    /// The tables lack something of the control or the machine.
    pub fn of(
        plan: Plan,
        control: &str,
        (number, subprograms): (Option<u32>, bool),
        knowledge: &Knowledge,
    ) -> Result<Self, KnowledgeError> {
        let language = Language::read(control, knowledge)?;
        let planned = PlannedJob::of(plan, &language, knowledge)?;
        let shop = Shop::new(&planned.plan.part, planned.plan.cutting, knowledge)?;
        let form = Form { program: number, subprograms, ..Form::read(&shop)? };
        let written = language.write(&planned.job, form);
        let setting = Setting::of_job(&planned.job);
        let mut sink = (Vec::<MotionStep>::new(), Clock::new(&shop.machine, setting.start));
        let faults = language.check(&written.text(), &shop.machine, &setting, &mut sink);
        let (steps, clock) = sink;
        let times = clock.times();
        let undone = planned.job.unfinished.iter().filter_map(|one| one.finding(Severity::Wrong)).collect();
        let proof = planned.prove(&steps, &setting);
        Ok(Self { language, planned, written, setting, steps, times, faults, undone, proof })
    }

    fn findings(&self) -> Vec<&Finding> {
        serious(&self.planned.plan, &self.planned.job).into_iter().chain(&self.undone).collect()
    }

    /// What is left undone of the part when the program has run.
    pub fn left(&self) -> &[Finding] {
        &self.undone
    }

    /// Why the program must not be run, the gravest that is told of it; or else what it leaves undone.
    pub fn reason(&self) -> Option<Finding> {
        self.gravest().or_else(|| self.undone.first().cloned())
    }

    /// The gravest of what is wrong with the program, beside what it leaves undone.
    pub fn gravest(&self) -> Option<Finding> {
        self.wrong().into_iter().next()
    }

    /// All that is wrong with plan and program, the gravest first, beside what the program leaves undone.
    pub fn wrong(&self) -> Vec<Finding> {
        let findings = serious(&self.planned.plan, &self.planned.job);
        let of_part = findings.iter().filter(|own| own.severity <= Severity::Wrong).map(|own| (*own).clone());
        let of_text = self.faults.iter().filter(|fault| fault.is_grave());
        let of_text = of_text.map(|fault| Finding::of_part(fault.severity, fault.note.clone()));
        let of_proof = self.proof.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
        let of_proof = of_proof.map(|finding| Finding::of_part(finding.severity, finding.note.clone()));
        let mut wrong: Vec<Finding> = Vec::new();
        for finding in of_part.chain(of_text).chain(of_proof) {
            if !wrong.contains(&finding) {
                wrong.push(finding);
            }
        }
        wrong.sort_by_key(|finding| finding.severity);
        wrong
    }
}

/// Findings in the plan and the job because of which the program cannot make the part.
fn serious<'a>(plan: &'a Plan, job: &'a Job) -> Vec<&'a Finding> {
    let of_plan = |finding: &&Finding| finding.severity <= Severity::Wrong && !job.findings.contains(finding);
    plan.findings.iter().filter(of_plan).chain(&job.findings).collect()
}

fn with_message<'a>(finding: &'a Finding, context: &Context) -> FindingMessage<'a> {
    FindingMessage { message: context.lang.say(&finding.note), finding }
}

/// Reports faults beside the program: of the part, of the machine, of its blocks.
fn complain(findings: &[&Finding], faults: &[Fault], proof: &Proof, text: String, context: &Context) {
    const NAME: &str = "program.nc";
    let mut problems = proof::part_diagnostics(findings, context);
    let file = std::sync::Arc::from(NAME);
    let (shown, more) = context.amount.select(faults.iter().collect(), |fault| fault.severity);
    problems.extend(shown.iter().map(|fault| check::diagnostic(fault, &file, context)));
    problems.extend(proof::diagnostics(proof, &text, &file, context));
    if problems.is_empty() {
        return;
    }
    let texts = Texts::default().with(NAME, NAME.to_owned(), Cow::Owned(text));
    let (shown, more_now) = context.amount.select(problems, |problem| problem.severity);
    output::complain(&(render_all(&shown, &texts, context.lang) + &below(more + more_now, context.lang)));
}
