//! Compares a lathe program with its turned part: the motions that the control reads from the text are checked by the
//! proof, whoever wrote the program.
//!
//! Assumptions where nothing is known: a rapid of both axes is a straight line, as in the proof of the program's own
//! toolpaths. Before its first motion, and after a motion to a reference point, the tool is far away. A tool that the
//! text does not name is the program's tool at that place of the turret; then no finding is worse than doubtful.

mod borne;
mod calls;
mod compensated;
mod ends;
mod homes;
mod lathe;
mod pace;
mod passes;
mod turret;

use technolog_turning_proof::{At, Block, Degrees, Indexed, Mm, Motion, MotionKind, Piece, Sense};

use calls::{CalledTool, exchanges, tools};
use compensated::TipOfNose;
pub use lathe::against_lathe;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::contract::Word;
use crate::motion;
use crate::note::{Note, Severity};
use crate::program::lathe::{
    LatheAct, LatheFeed, LatheLanguage, LatheMotion, LathePlace, LathePoint, LatheReader, LatheRun, LatheTool,
    Subprogram, is_serious, read,
};
use crate::program::{Fault, TextSpan};
use crate::tables::controls::lathe::{LatheControl, LatheControls};
use crate::turning::jobs::Body;
use crate::turning::operation::beside::beside;
use crate::turning::operation::proof::{Proven, prove_set_up, rejected, told_of_program};
use crate::turning::operation::{Operation, SetUpWork};
use crate::turning::program::ProgramFile;
use crate::turning::tooling::{Lathe, ToolKind};

/// The assumed position of a tool that is not known, mm from the axis and from the face.
const FAR: f64 = 1000.0;

/// Compares a program of a set-up with the part, after the jobs of earlier set-ups. Returns the findings of the proof
/// with their lines, or why there is no comparison.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn compare_with_part(
    operation: &Operation,
    set_up: u8,
    text: &str,
    run: &LatheRun,
    knowledge: &Knowledge,
) -> Result<Vec<Fault>, KnowledgeError> {
    let Compared { work, proven, tools, motions } = match compared(operation, set_up, text, run) {
        Ok(compared) => compared,
        Err(why) => return Ok(vec![*why]),
    };
    let taken: Vec<&CalledTool> = tools.iter().filter(|tool| !tool.is_named).collect();
    let mut faults: Vec<Fault> = taken.iter().map(|tool| tool.taken(work)).collect();
    let under = run.motions.iter().filter(|one| one.act.cuts() && one.modes.compensation != motion::Side::Off);
    for tool in tools.iter().filter(|tool| under.clone().any(|one| one.modes.tool == Some(tool.called))) {
        let name = work.jobs.get(tool.job).map_or("", |job| &*job.tool.designation);
        let note = Note::new("turned-nose-taken").with("tool", name.to_owned());
        faults.push(fault("turned-nose-taken", Severity::Note, note, tool.line));
    }
    let end = run.motions.last().map_or(1, |motion| motion.line);
    let proof = match &proven.proof {
        Ok(proof) => proof,
        Err(refused) => {
            let note = Note::new("turning-not-proven").with("number", set_up).with("why", refused.note());
            faults.push(fault("turning-not-proven", Severity::Doubtful, note, end));
            return Ok(faults);
        }
    };
    // The final shape is the work of all tools; what is cut or hit in a line is the work of the tool that moves
    // there.
    let is_sure = |line: Option<u32>| match line.and_then(|line| run.motions.iter().find(|one| one.line == line)) {
        Some(motion) => taken.iter().all(|tool| motion.modes.tool.is_none_or(|of| of != tool.called)),
        None => taken.is_empty(),
    };
    let found = told_of_program(operation, set_up, proof).map(|(severity, found)| {
        let line = found.block.and_then(|block| u32::try_from(block.0).ok());
        // Lead and start of its passes hang on no tool.
        use technolog_turning_proof::What::{ThreadLead, ThreadPhase};
        let is_sure = is_sure(line) || matches!(found.what, ThreadLead { .. } | ThreadPhase { .. });
        let least = if is_sure { Severity::Error } else { Severity::Doubtful };
        fault(found.code(), severity.max(least), found.note().with("number", set_up), line.unwrap_or(end))
    });
    let found: Vec<Fault> = found.collect();
    faults.extend(exchanges(operation, work, text, run, &tools));
    faults.extend(pace::paced(operation, work, run, &tools, &proof.cuts, knowledge)?);
    faults.extend(passes::passes(operation, work, run, &tools, knowledge)?);
    faults.extend(ends::parted(operation, work, run, proof, knowledge)?);
    faults.extend(ends::drilled(operation, work, run, &tools, knowledge)?);
    faults.extend(homes::homes(operation, work, &run.motions, &motions, &proven));
    faults.extend(turret::turned_near(operation, work, &tools, &proof.indexed, knowledge)?);
    faults.extend(of_plan(operation, set_up, found.iter().any(is_serious), end));
    faults.extend(found);
    let note = Note::new(HELD).with("number", set_up).with("of", operation.set_ups.len());
    faults.push(fault(HELD, Severity::Note, note, end));
    Ok(faults)
}

/// What is wrong with the part beside the motions of a program: the plan says it, at the end of the program. What the plan cannot
/// do in a set-up is doubtful at most where the program does all of that set-up.
fn of_plan(operation: &Operation, set_up: u8, fails: bool, end: u32) -> Vec<Fault> {
    let beside = beside(operation, set_up);
    let does_better = beside.fails_here && !fails;
    let least = if does_better { Severity::Doubtful } else { Severity::Error };
    let planned = beside.planned.into_iter().map(|finding| (finding.severity.max(least), finding.note));
    let left = beside.left.into_iter().map(|finding| (finding.severity, finding.note));
    let of_part = |(severity, why)| fault(OF_PLAN, severity, Note::new(OF_PLAN).with("why", why), end);
    left.chain(planned).map(of_part).collect()
}

/// The code of what is wrong with the part, whatever the program does.
const OF_PLAN: &str = "turned-of-plan";

/// Reads a program of ours back, and simulates the in-process stock with the motions that the control reads from its
/// text. Returns the first reason why the program must not be run; none if there is none, or if no reader for the
/// control exists.
///
/// # Errors
/// The tables of the control lack something.
pub fn read_back(
    operation: &Operation,
    set_up: u8,
    control: &str,
    files: &[ProgramFile],
    knowledge: &Knowledge,
) -> Result<Option<Note>, KnowledgeError> {
    let Some((main, run)) = read_files(control, files, knowledge)? else { return Ok(None) };
    let at_line = |line: u32, why: Note| Note::new("turned-read-back").with("line", line).with("why", why);
    if let Some(fault) = run.faults.iter().find(|fault| is_serious(fault)) {
        return Ok(Some(at_line(fault.span.line, fault.note.clone())));
    }
    Ok(match compared(operation, set_up, &main.text, &run) {
        Ok(compared) => {
            let (work, tools) = (compared.work, &compared.tools);
            let mut faults = exchanges(operation, work, &main.text, &run, tools);
            let cuts = compared.proven.proof.as_ref().map(|proof| proof.cuts.clone()).unwrap_or_default();
            faults.extend(pace::paced(operation, work, &run, tools, &cuts, knowledge)?);
            if let Some(id) = &operation.workpiece.machine {
                faults.extend(against_lathe(&run, &Lathe::find(knowledge, id)?)?);
            }
            let serious = faults.into_iter().find(is_serious).map(|fault| at_line(fault.span.line, fault.note));
            rejected(operation, &compared.proven).or(serious)
        }
        Err(why) => Some(at_line(why.span.line, why.note.clone())),
    })
}

/// The proof of the motions that the control reads from a program of ours; none if no reader for the control exists, or the
/// program cannot be read.
///
/// # Errors
/// The tables of the control lack something.
pub fn swept(
    operation: &Operation,
    set_up: u8,
    control: &str,
    files: &[ProgramFile],
    knowledge: &Knowledge,
) -> Result<Option<Proven>, KnowledgeError> {
    let run = read_files(control, files, knowledge)?;
    Ok(run.and_then(|(main, run)| compared(operation, set_up, &main.text, &run).ok()).map(|compared| compared.proven))
}

/// The main file of a program, and how the control carries it out with the files beside it; none without a reader or a file.
fn read_files<'f>(
    control: &str,
    files: &'f [ProgramFile],
    knowledge: &Knowledge,
) -> Result<Option<(&'f ProgramFile, LatheRun)>, KnowledgeError> {
    let (Some(language), Some((main, rest))) = (reader(control, knowledge)?, files.split_first()) else {
        return Ok(None);
    };
    let language = LatheLanguage::read(language, knowledge)?;
    let beside: Vec<Subprogram<'_>> =
        rest.iter().map(|file| Subprogram { name: stem(&file.name), text: &file.text }).collect();
    Ok(Some((main, read(&main.text, &language, &beside))))
}

/// The language that reads programs for a lathe control, by `lathe-controls`; none where there is no reader.
///
/// # Errors
/// There is no such control.
pub fn reader(control: &str, knowledge: &Knowledge) -> Result<Option<&'static str>, KnowledgeError> {
    let known = LatheControl::from_word(control);
    let row = knowledge.need(control, |row: &LatheControls<'_>| Some(row.control) == known)?;
    Ok(row.read_as.map(Word::word))
}

/// The name of a file without its ending.
fn stem(name: &str) -> &str {
    name.split_once('.').map_or(name, |(stem, _)| stem)
}

/// A program of a set-up after its proof.
struct Compared<'o> {
    work: &'o SetUpWork,
    proven: Proven,
    tools: Vec<CalledTool>,
    motions: Vec<Motion>,
}

/// The proof of a program with the tools that it calls, or why there is none.
fn compared<'o>(operation: &'o Operation, set_up: u8, text: &str, run: &LatheRun) -> Result<Compared<'o>, Box<Fault>> {
    if run.faults.iter().any(Fault::is_error) {
        return Err(Box::new(fault("turned-mend-first", Severity::Note, Note::new("turned-mend-first"), 1)));
    }
    let work = operation.set_ups.iter().find(|one| one.set_up.number == set_up).ok_or_else(|| {
        let numbers: Vec<String> = operation.set_ups.iter().map(|one| one.set_up.number.to_string()).collect();
        let note = Note::new("turned-no-set-up").with("number", set_up).with("known", numbers.join(", "));
        Box::new(fault("turned-no-set-up", Severity::Error, note, 1))
    })?;
    if let Some(passed) = run.faults.iter().find(|fault| fault.code == "lathe-not-carried-out") {
        let note = Note::new("turned-not-carried-out");
        return Err(Box::new(fault("turned-not-carried-out", Severity::Doubtful, note, passed.span.line)));
    }
    let tools = tools(operation, work, text, run);
    let told = |why: NotHeld| Box::new(fault(why.code(), Severity::Doubtful, why.note(), why.line()));
    let followed = match run.control {
        Some(LatheReader::Fanuc | LatheReader::Sinumerik) => {
            let nose = |motion: &LatheMotion| nose_of(motion, &tools, work);
            compensated::followed(&run.motions, nose).map_err(|line| told(NotHeld::Compensated { line }))?
        }
        _ => run.motions.clone(),
    };
    let (motions, indexed) = motions(&followed, &tools).map_err(told)?;
    let proven = prove_set_up(operation, &operation.proven, work, motions.clone(), Some(indexed));
    Ok(Compared { work, proven, tools, motions })
}

/// The nose of the tool of a motion; none of one that no round nose turns with.
fn nose_of(motion: &LatheMotion, tools: &[CalledTool], work: &SetUpWork) -> Option<TipOfNose> {
    let called = tools.iter().find(|tool| Some(tool.called) == motion.modes.tool)?;
    let tool = &work.jobs.get(called.job)?.tool;
    let Body::Insert { kind: ToolKind::Turning | ToolKind::Boring, nose_radius_mm, .. } = tool.body else {
        return None;
    };
    let tip = tool.tip()?;
    Some(TipOfNose { radius: nose_radius_mm.to_mm(), z: -f64::from(tip.axial), r: f64::from(tip.radial) })
}

/// The id of these findings in the list of rules: docs/lathe-programs-read.md.
pub const RULE: &str = "part";

/// The code of the note that a program was compared with the part.
pub const HELD: &str = "turned-held";

fn fault(code: &'static str, severity: Severity, note: Note, line: u32) -> Fault {
    let span = TextSpan { line, column: 1, width: 1 };
    Fault {
        code,
        severity,
        rule: RULE,
        block: None,
        calls: Vec::new(),
        span,
        subject: None,
        note,
        of_program_alone: false,
    }
}

/// Why a program cannot be compared with the part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum NotHeld {
    /// It cuts from or to an unknown position.
    Place { line: u32 },
    /// It moves a tool that the set-up does not have.
    Tool { line: u32, number: u32 },
    /// It moves before it calls a tool.
    NoTool { line: u32 },
    /// The control offsets the path by the nose radius (G41, G42), which is not simulated.
    Compensated { line: u32 },
}

impl NotHeld {
    const fn line(self) -> u32 {
        match self {
            Self::Place { line } | Self::Tool { line, .. } | Self::NoTool { line } | Self::Compensated { line } => line,
        }
    }

    const fn code(self) -> &'static str {
        match self {
            Self::Place { .. } => "turned-place-unknown",
            Self::Tool { .. } => "turned-tool-unknown",
            Self::NoTool { .. } => "turned-no-tool",
            Self::Compensated { .. } => "turned-compensated",
        }
    }

    fn note(self) -> Note {
        let note = Note::new(self.code());
        if let Self::Tool { number, .. } = self { note.with("number", number) } else { note }
    }
}

/// The motions of a program as the proof has them, and the changes of tools at known places between them; a block of the proof is a
/// line of the program.
///
/// # Errors
/// Something in the program is not known well enough.
fn motions(all: &[LatheMotion], tools: &[CalledTool]) -> Result<(Vec<Motion>, Vec<Indexed>), NotHeld> {
    let mut motions: Vec<Motion> = Vec::new();
    let (mut indexed, mut before) = (Vec::new(), None);
    for one in all {
        if one.act == LatheAct::ToolChange {
            indexed.extend(change(one, before, motions.len(), tools));
        }
        before = one.modes.tool.or(before);
        if !one.act.moves() {
            continue;
        }
        let line = one.line;
        let cuts = one.act.cuts();
        let known = one.from.point().zip(one.to.point());
        if cuts && known.is_none() {
            return Err(NotHeld::Place { line });
        }
        let (from, to) = known.unwrap_or((far(one.from), far(one.to)));
        if from == to {
            continue;
        }
        let Some(called) = one.modes.tool else {
            // On a move from or to an unknown position no tool is needed yet.
            if known.is_none() {
                continue;
            }
            return Err(NotHeld::NoTool { line });
        };
        let number = called.number;
        let tool = tools.iter().find(|tool| tool.called == called).ok_or(NotHeld::Tool { line, number })?.job;
        if cuts && one.modes.compensation != motion::Side::Off {
            return Err(NotHeld::Compensated { line });
        }
        let (start, end) = (at(from), at(to));
        let (kind, path) = match one.act {
            LatheAct::Arc { centre, sense, .. } => {
                let sense = match sense {
                    motion::Sense::Clockwise => Sense::Clockwise,
                    motion::Sense::Counterclockwise => Sense::Counterclockwise,
                };
                (MotionKind::Feed, Piece::Arc { from: start, to: end, centre: at(centre), sense })
            }
            LatheAct::Thread { .. } => (MotionKind::Thread, Piece::Line { from: start, to: end }),
            LatheAct::Feed { .. } => (MotionKind::Feed, Piece::Line { from: start, to: end }),
            _ => (MotionKind::Rapid, Piece::Line { from: start, to: end }),
        };
        let lead = match one.act {
            LatheAct::Thread { lead, .. } => Some(Mm(lead.0)),
            LatheAct::Feed { feed: LatheFeed::PerRevolution(feed) } => Some(Mm(feed.0)),
            _ => None,
        };
        let start = match one.act {
            LatheAct::Thread { start_deg, .. } => Degrees(start_deg),
            _ => Degrees(0.0),
        };
        let block = Block(usize::try_from(line).unwrap_or(usize::MAX));
        motions.push(Motion { kind, path, tool, lead, start, block });
    }
    Ok((motions, indexed))
}

/// A change of tools, if the one before is known and stands at a known place. Calling a tool once more turns nothing.
fn change(one: &LatheMotion, before: Option<LatheTool>, after: usize, tools: &[CalledTool]) -> Option<Indexed> {
    let before = before.filter(|before| one.modes.tool.is_some_and(|tool| tool.number != before.number))?;
    let tool = tools.iter().find(|tool| tool.called == before)?.job;
    let block = Block(usize::try_from(one.line).unwrap_or(usize::MAX));
    Some(Indexed { after, tool, at: at(one.from.point()?), block })
}

fn far(place: LathePlace) -> LathePoint {
    LathePoint { radius_mm: place.radius_mm.unwrap_or(FAR), z_mm: place.z_mm.unwrap_or(FAR) }
}

fn at(point: LathePoint) -> At {
    At::new(Mm(point.z_mm), Mm(point.radius_mm))
}
