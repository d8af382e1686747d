//! A program alone as a plan: what its motions and comments say is read back into the form of a plan by hand, and judged by the same
//! checks.
//!
//! ```text
//! program → run with zeros and offsets of 0 → cuts → points of the drawing → rows, tools, conditions ┐
//! comments, a list of tools ─────────────────────────────────→ what each tool is ────────────────────┴→ Stated
//! ```
//!
//! What neither the program nor a list says is derived only where one thing can be meant: the first shallow cut of a hole centres it, a
//! spindle that turns round at the bottom taps. What stays open is told and not judged.

mod frame;
mod operations;
mod part;
mod told;

use std::collections::{BTreeMap, BTreeSet};

use technolog_note::{Figure, Note, note};

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::diagnostic::{Diagnostic, Place};
use crate::machine::{Axis, Machine};
use crate::motion::{Motion, MotionStep, Position};
use crate::note::{IntoFigure as _, Severity};
use crate::part::Part;
use crate::plan::{CuttingMethod, Operation};
use crate::program::proof::DeviationFigure;
use crate::program::seen::{SeenCut, cuts};
use crate::program::setting::DecimalInput;
use crate::program::{Language, Setting, Subject};
use crate::tables::audit::{AuditThresholds, PlanPart, Threshold};
use crate::tables::practice::ReachOfTransitionFor;
use crate::units::Micrometres;

use super::finding::Section;
use super::quantity::Quantity as Q;
use super::sheet::{STAND_INS, Unsaid};
use super::stated::{
    Alone, Author, Conditions, Figures, Program, Remark, Row, Stated, StatedFigure, StatedValue, Text, Tool,
};
use operations::Meant;
use told::{Told, ToldTools};

/// A program without a plan.
#[derive(Clone, Copy, Debug)]
pub struct ProgramAlone<'a> {
    /// Its file, as the user knows it.
    pub file: &'a str,
    /// Its text.
    pub text: &'a str,
    /// The control.
    pub control: &'a str,
    /// What the operator sets: name and text.
    pub setting: Option<(&'a str, &'a str)>,
    /// The part, where it is known.
    pub part: Option<&'a Part>,
    /// A list of its tools, where there is one.
    pub tools: Option<&'a Stated>,
}

/// A cut with the group of holes of its point.
struct Placed {
    cut: SeenCut,
    hole: String,
}

impl ProgramAlone<'_> {
    /// The plan that the program carries out.
    ///
    /// # Errors
    /// The knowledge has no answer. Inside: the program makes no holes that could be judged.
    pub fn read(&self, knowledge: &Knowledge) -> Result<Result<Stated, Diagnostic>, KnowledgeError> {
        let language = Language::read(self.control, knowledge)?;
        let machine_id = self.part.map_or(STAND_INS[1].1, |part| part.machine.as_str());
        let machine = Machine::find(knowledge, machine_id)?;
        let own = self.setting.and_then(|(name, text)| language.setting(name, text).ok());
        let (steps, has_feeds) = run(self.text, &language, &machine, own.as_ref());
        let seen = cuts(&steps, own.as_ref().map(|own| own.start).unwrap_or_default());
        let told = ToldTools::read(self.text, &steps, self.tools, self.control != "2c42-65", knowledge)?;
        let length = |name| {
            let row = knowledge.need("audit-thresholds", |row: &AuditThresholds| row.name == name)?;
            Ok::<_, KnowledgeError>(Micrometres::from_mm_rounded(row.value))
        };
        let untold = length(Threshold::UntoldWidth)?;
        let of = self.part.cloned().or_else(|| part::made(self.file, &seen, &told, untold, knowledge));
        let Some(of) = of else {
            let problem = Diagnostic::error("no-holes", note!("audit-program-no-holes"), self.place(1));
            return Ok(Err(problem.help(note!("audit-program-no-holes-help"))));
        };
        let shift = if self.part.is_some() { frame::shift(&seen, &of) } else { Position::default() };
        let in_inches = self.part.is_some() && frame::is_in_inches(&seen, &of);
        let (placed, elsewhere) = frame::placed(seen, &of, shift);
        let drilled = drilled(&of, knowledge)?;
        let meant = operations::meant(&placed, &of, &told, shift, (length(Threshold::SpotOverRadius)?, &drilled));
        let placed: Vec<_> = placed.into_iter().zip(meant).collect();
        let nowhere = match in_inches {
            true => self.remark(1, Severity::Error, note!("audit-program-inches")),
            false => self.remark(1, Severity::Doubtful, note!("audit-program-nowhere", count = elsewhere)),
        };
        let elsewhere = if placed.is_empty() { Some(nowhere) } else { self.elsewhere(elsewhere) };
        let mut stated = self.plan(of, &placed, elsewhere, &told, shift, &steps);
        if !has_feeds {
            for conditions in &mut stated.conditions {
                conditions.figures.retain(|quantity, _| ![Q::Feed, Q::MinuteFeed].contains(quantity));
            }
        }
        Ok(Ok(stated))
    }

    fn remark(&self, line: u32, severity: Severity, note: Note) -> Remark {
        Remark {
            place: self.place(line),
            note,
            severity,
            section: Section::Missing,
            figure: None,
            unless_proven: false,
        }
    }

    /// What is to be said of the points where the drawing has no hole.
    fn elsewhere(&self, count: usize) -> Option<Remark> {
        (count > 0).then(|| self.remark(1, Severity::Note, note!("audit-program-elsewhere", count = count)))
    }

    fn place(&self, line: u32) -> Place {
        Place { file: self.file.into(), line: line.max(1), column: 1, width: 1 }
    }

    fn plan(
        &self,
        part: Part,
        placed: &[(Placed, Option<Meant>)],
        elsewhere: Option<Remark>,
        told: &ToldTools,
        shift: Position,
        steps: &[MotionStep],
    ) -> Stated {
        let (mut rows, mut conditions) = (Vec::new(), Vec::new());
        let whole = placed.iter().all(|(_, meant)| meant.is_some()) && self.part.is_some();
        let mut untold: BTreeSet<u32> = BTreeSet::new();
        let mut derived: BTreeMap<u32, Operation> = BTreeMap::new();
        let mut known: BTreeSet<(String, usize, Operation)> = BTreeSet::new();
        for (of, _) in placed.iter().filter(|(_, meant)| meant.is_none()) {
            untold.insert(of.cut.tool);
        }
        // The rest of such a hole hangs on what is not known of it.
        let open: BTreeSet<&str> =
            placed.iter().filter(|(_, meant)| meant.is_none()).map(|(of, _)| of.hole.as_str()).collect();
        for (of, meant) in placed.iter().filter(|(of, _)| !open.contains(of.hole.as_str())) {
            let Some(Meant { operation, derived: is_derived }) = *meant else { continue };
            if is_derived {
                derived.entry(of.cut.tool).or_insert(operation);
            }
            // One row for a tool at all points of a group.
            if !known.insert((of.hole.clone(), of.cut.section, operation)) {
                continue;
            }
            let at = rows.len();
            let row = self.row(at, of, operation, told, &part, shift);
            conditions.push(self.conditions(at, &of.cut));
            rows.push(row);
        }
        let numbers: BTreeSet<u32> = rows.iter().filter_map(|row: &Row| Some(row.tool.as_ref()?.value)).collect();
        let called = called(steps);
        let tools: Vec<Tool> = numbers.iter().map(|number| self.tool(*number, told, &called)).collect();
        let mut remarks = Vec::new();
        let remark = |note| self.remark(1, Severity::Note, note);
        if !derived.is_empty() {
            let words = derived.iter().map(|(tool, operation)| {
                Figure::List(vec![format!("T{tool} ").into_figure(), Figure::operation(operation.name())], "")
            });
            remarks.push(remark(note!("audit-program-derived", tools = Figure::List(words.collect(), ", "))));
        }
        let listed = |tools: &BTreeSet<u32>| tools.iter().map(|tool| format!("T{tool}")).collect::<Vec<_>>().join(", ");
        for (number, line, note) in self.unlisted(&untold, told, steps) {
            untold.remove(&number);
            let section = Section::Program;
            remarks.push(Remark { section, ..self.remark(line, Severity::Wrong, note) });
        }
        if !untold.is_empty() {
            remarks.push(remark(note!("audit-program-untold", tools = listed(&untold))));
        }
        let unsized_ones: BTreeSet<u32> =
            numbers.into_iter().filter(|tool| told.of(*tool).is_none_or(Told::has_no_size)).collect();
        if !unsized_ones.is_empty() {
            remarks.push(remark(note!("audit-program-unsized", tools = listed(&unsized_ones))));
        }
        remarks.extend(elsewhere);
        if shift != Position::default() {
            let note = note!("audit-program-shifted", x = shift.x, y = shift.y, z = shift.z);
            remarks.push(remark(note));
        }
        if self.part.is_some() {
            remarks.extend(short(&part, placed, shift).into_iter().map(|(line, note)| Remark {
                section: Section::Program,
                unless_proven: true,
                ..self.remark(line, Severity::Error, note)
            }));
            remarks.extend(left_out(&part, placed, shift).into_iter().map(|(line, note)| Remark {
                section: Section::Program,
                unless_proven: true,
                ..self.remark(line, Severity::Doubtful, note)
            }));
        }
        let mut scope = vec![PlanPart::Conditions];
        scope.extend(whole.then_some(PlanPart::Holes));
        scope.extend(tools.iter().any(|tool| tool.designation.is_some()).then_some(PlanPart::Tools));
        scope.push(PlanPart::Program);
        let setting = self.setting.map(|(name, text)| (name.to_owned(), text.to_owned()));
        let setting = setting.or_else(|| Some((self.file.to_owned(), registers(steps))));
        Stated {
            name: part.part.clone(),
            file: self.file.to_owned(),
            part,
            method: CuttingMethod::default(),
            scope: Some(scope),
            is_own: false,
            tree: None,
            rows,
            tools,
            conditions,
            clamping: None,
            program: Some(Program {
                file: StatedValue { value: self.file.to_owned(), place: self.place(1) },
                text: self.text.to_owned(),
                control: self.control.to_owned(),
                place: self.place(1),
                setting,
                shift,
                // A transition that is not known would be a cut too many.
                alone: Some(Alone { is_proven: whole, is_set: self.setting.is_some() }),
            }),
            times: Figures::new(),
            changes: None,
            author: Author::default(),
            is_list: false,
            unsaid: self.part.is_none().then_some(Unsaid { material: true, machine: true }),
            remarks,
        }
    }

    /// The tools of which nothing is known and which the list beside the program does not have, each with the line of its first call and
    /// what the list has instead that is never called.
    fn unlisted(&self, untold: &BTreeSet<u32>, told: &ToldTools, steps: &[MotionStep]) -> Vec<(u32, u32, Note)> {
        let Some(list) = self.tools.filter(|list| !list.tools.is_empty()) else { return Vec::new() };
        let call = |number: u32| steps.iter().find(|step| step.motion == Motion::ToolChange { tool: number });
        let rows = list.rows.iter().filter_map(|row| Some((row, row.tool.as_ref()?.value)));
        let left = rows.filter(|(_, number)| call(*number).is_none()).map(|(row, number)| {
            let hole = row.hole.as_ref().map(|hole| format!(" {}", hole.value)).unwrap_or_default();
            let operation = Figure::operation(row.operation.value.name());
            Figure::List(vec![format!("T{number} ").into_figure(), operation, hole.into_figure()], "")
        });
        let left: Vec<Figure> = left.collect();
        // Where the list has a tool instead, its number is wrong even where the motion says what is done.
        let called = called(steps).into_keys().filter(|_| !left.is_empty());
        let numbers: BTreeSet<u32> = untold.iter().copied().chain(called).collect();
        let told = numbers.iter().filter(|number| told.of(**number).is_none()).filter_map(|number| {
            let line = call(*number)?.block.line;
            let note = match left.is_empty() {
                true => note!("audit-program-unlisted", tool = *number),
                false => {
                    let left = Figure::List(left.clone(), ", ");
                    note!("audit-program-unlisted-instead", tool = *number, left = left)
                }
            };
            Some((*number, line, note))
        });
        told.collect()
    }

    fn row(&self, at: usize, of: &Placed, operation: Operation, told: &ToldTools, part: &Part, shift: Position) -> Row {
        let place = self.place(of.cut.block.line);
        let mut figures = Figures::new();
        let tool = told.of(of.cut.tool);
        let hole = part.holes.iter().find(|hole| hole.name == of.hole);
        let size = tool.and_then(|tool| tool.cuts(operation));
        let thread = hole.and_then(|hole| hole.thread_at(None)).map(|thread| thread.size.to_mm());
        let size = size.or(thread.filter(|_| operation == Operation::Tap));
        if let Some(size) = size {
            figures.insert(Q::Diameter, figure(size, &place));
        }
        if let Some(also) = tool.and_then(|tool| tool.also) {
            figures.insert(Q::Also, figure(also, &place));
        }
        // How deep a spot is only the program knows; how deep a hole is, the drawing.
        if operation == Operation::CentreDrill {
            let depth = part.datum.top - (of.cut.deepest + shift.z);
            if depth > Micrometres::ZERO {
                figures.insert(Q::Depth, figure(depth.to_mm(), &place));
            }
        }
        Row {
            number: u32::try_from(at + 1).unwrap_or(u32::MAX),
            place: place.clone(),
            operation: StatedValue { value: operation, place: place.clone() },
            hole: Some(Text { value: of.hole.clone(), place: place.clone() }),
            feature: None,
            step: None,
            setup: None,
            elsewhere: false,
            tool: Some(StatedValue { value: of.cut.tool, place }),
            scheme: None,
            table: None,
            figures,
        }
    }

    fn conditions(&self, at: usize, cut: &SeenCut) -> Conditions {
        let place = self.place(cut.block.line);
        let mut figures = Figures::new();
        if cut.speed.0 > 0.0 {
            figures.insert(Q::Rpm, figure(cut.speed.0, &place));
            if cut.feed.0 > 0.0 {
                figures.insert(Q::MinuteFeed, figure(cut.feed.0, &place));
                figures.insert(Q::Feed, figure(cut.feed.0 / cut.speed.0, &place));
            }
        }
        Conditions { place, rows: vec![at], is_limited: false, rounds: cut.mills, factors: BTreeMap::new(), figures }
    }

    fn tool(&self, number: u32, told: &ToldTools, called: &BTreeMap<u32, (u32, u32)>) -> Tool {
        let own = told.of(number);
        let place = self.place(own.map_or(1, |own| own.line));
        let text = |value: &Option<String>| value.clone().map(|value| Text { value, place: place.clone() });
        let mut figures = own.map(|own| own.figures.clone()).unwrap_or_default();
        if let Some(diameter) = own.and_then(|own| own.diameter) {
            figures.entry(Q::Diameter).or_insert_with(|| figure(diameter, &place));
        }
        if let Some((corrector, line)) = called.get(&number) {
            figures.insert(Q::Corrector, figure(f64::from(*corrector), &self.place(*line)));
        }
        Tool {
            number,
            place: place.clone(),
            designation: own.and_then(|own| text(&own.designation)),
            standard: own.and_then(|own| text(&own.standard)),
            table: None,
            shank: None,
            holder: own.and_then(|own| text(&own.holder)),
            holder_standard: None,
            correction_word: None,
            figures,
        }
    }
}

/// The points of groups at which some tool works and none goes down to the depth of the hole, whatever the tools are: for
/// each such group the line of its deepest cut there, 1 where there is none. Where it is known what every tool is, the proof says more.
fn short(part: &Part, placed: &[(Placed, Option<Meant>)], shift: Position) -> Vec<(u32, Note)> {
    let mut found = Vec::new();
    for hole in part.holes.iter().filter(|hole| placed.iter().any(|(own, _)| own.hole == hole.name)) {
        let mut points = Vec::new();
        let mut deepest: Option<(Micrometres, u32)> = None;
        for point in hole.at.iter().map(|at| [at.x, at.y]) {
            let here = placed.iter().filter(|(own, _)| own.hole == hole.name && frame::is_at(&own.cut, point, shift));
            let depth = |cut: &SeenCut| part.datum.top - (cut.deepest + shift.z);
            let own = here.map(|(own, _)| (depth(&own.cut), own.cut.block.line)).max();
            if own.is_none_or(|(depth, _)| depth < hole.depth) {
                points.push(point);
                deepest = deepest.max(own);
            }
        }
        if !points.is_empty() {
            let (reached, line) = deepest.unwrap_or((Micrometres::ZERO, 1));
            let note = note!(
                "audit-program-short",
                hole = Figure::called(&hole.name),
                points = DeviationFigure::Points(points),
                reached = reached,
                depth = hole.depth
            );
            found.push((line, note));
        }
    }
    found
}

/// The points of a group that a tool leaves out, where it works at others of it and no other tool takes its place there: for each the
/// line of its first cut in the group. Where it is known what every tool is, the proof says more.
fn left_out(part: &Part, placed: &[(Placed, Option<Meant>)], shift: Position) -> Vec<(u32, Note)> {
    let mut found = Vec::new();
    for hole in &part.holes {
        let own = || placed.iter().map(|(own, _)| own).filter(|own| own.hole == hole.name);
        let points = || hole.at.iter().map(|at| [at.x, at.y]);
        let cuts = |tool: u32, point| own().any(|one| one.cut.tool == tool && frame::is_at(&one.cut, point, shift));
        let tools: BTreeSet<u32> = own().map(|one| one.cut.tool).collect();
        for tool in &tools {
            let left: Vec<_> = points().filter(|point| !cuts(*tool, *point)).collect();
            let instead =
                |other: &u32| other != tool && points().all(|point| cuts(*other, point) == left.contains(&point));
            let Some(first) = own().find(|one| one.cut.tool == *tool).filter(|_| !left.is_empty()) else { continue };
            if !tools.iter().any(instead) {
                let hole = Figure::called(&hole.name);
                let note =
                    note!("audit-program-left-out", tool = *tool, hole = hole, points = DeviationFigure::Points(left));
                found.push((first.cut.block.line, note));
            }
        }
    }
    found
}

/// A figure of the program.
fn figure(value: f64, place: &Place) -> StatedFigure {
    let text = format!("{}", crate::units::round_to(value, 4));
    StatedFigure { value, text, last_place: 0.0001, place: place.clone() }
}

/// Where the zero of a program lies that nobody has set: far below the place of the tool change, whatever the machine.
const FAR_BELOW: Micrometres = Micrometres::from_mm(-2000);
/// Travels within which every program can be read: whether the machine has them the program itself is asked for later.
const WIDE: Micrometres = Micrometres::from_mm(20_000);

/// A setting in which every offset register is 0, and every zero that is not set far below.
fn nothing_set(own: Option<&Setting>) -> Setting {
    const REGISTERS: u32 = 99;
    let mut setting = own.cloned().unwrap_or_default();
    for zero in &mut setting.zeros {
        for axis in Axis::ALL {
            zero[axis.index()].get_or_insert(if axis == Axis::Z { FAR_BELOW } else { Micrometres::ZERO });
        }
    }
    if setting.correctors.is_empty() {
        setting.correctors = (1..=REGISTERS).map(|number| (number, Micrometres::ZERO)).collect();
    }
    setting
}

/// The steps of a run in the coordinates of the program: zeros and lengths that the operator has set are taken off again. And whether
/// its feeds are those of the steps: a feed per turn that is not carried out says nothing.
fn run(text: &str, language: &Language, machine: &Machine<'_>, own: Option<&Setting>) -> (Vec<MotionStep>, bool) {
    let setting = nothing_set(own);
    let mut machine = machine.clone();
    (machine.travel_x, machine.travel_y, machine.travel_z) = (WIDE, WIDE, WIDE);
    let mut steps: Vec<MotionStep> = Vec::new();
    let mut faults = language.check(text, &machine, &setting, &mut steps);
    // One forgotten point keeps the control from counting the lengths; what the author meant is read all the same, and the check of the
    // program says what the control makes of it.
    if faults.iter().any(|fault| fault.code == "point-missing") {
        let setting = Setting { decimal: Some(DecimalInput::Calculator), ..setting.clone() };
        steps.clear();
        faults = language.check(text, &machine, &setting, &mut steps);
    }
    let per_turn = Subject::Function("G95".to_owned());
    let has_feeds = !faults.iter().any(|fault| fault.subject.as_ref() == Some(&per_turn));
    let zero = Position::of(Axis::ALL.map(|axis| setting.zeros[0][axis.index()].unwrap_or_default()));
    let mut length = Micrometres::ZERO;
    for step in &mut steps {
        if let Motion::LengthCorrection { axis: Axis::Z, value, .. } = &step.motion {
            length = *value;
        }
        for axis in [Axis::X, Axis::Y] {
            step.at = step.at.with(axis, step.at.get(axis) - zero.get(axis));
        }
        step.at = step.at.with(Axis::Z, step.at.z - zero.z - length);
        if let Motion::Arc { centre, .. } = &mut step.motion {
            *centre = [centre[0] - zero.x, centre[1] - zero.y];
        }
    }
    (steps, has_feeds)
}

/// The holes that are no finer than a drill behind a spot leaves them ordinarily.
fn drilled<'p>(part: &'p Part, knowledge: &Knowledge) -> Result<BTreeSet<&'p str>, KnowledgeError> {
    let mut found = BTreeSet::new();
    for hole in &part.holes {
        let reach = knowledge.ask(&ReachOfTransitionFor { way: "drill-centred", diameter: hole.diameter.nominal })?;
        let grade = reach.winner()?.and_then(|row| row.it_ordinary);
        if grade.is_some_and(|grade| hole.diameter.it.number() >= grade.number()) {
            found.insert(&*hole.name);
        }
    }
    Ok(found)
}

/// The register that each tool calls first, with its line.
fn called(steps: &[MotionStep]) -> BTreeMap<u32, (u32, u32)> {
    let (mut tool, mut found) = (0, BTreeMap::new());
    for step in steps {
        match step.motion {
            Motion::ToolChange { tool: next } => tool = next,
            Motion::LengthCorrection { corrector: Some(corrector), .. } if corrector > 0 => {
                found.entry(tool).or_insert((corrector, step.block.line));
            }
            _ => {}
        }
    }
    found
}

/// A setting of the registers that the program calls: what stands in them nobody knows, and nothing depends on it.
fn registers(steps: &[MotionStep]) -> String {
    let called: BTreeSet<u32> = steps
        .iter()
        .filter_map(|step| match step.motion {
            Motion::LengthCorrection { corrector, .. } => corrector,
            Motion::RadiusCorrection { corrector, .. } => Some(corrector),
            _ => None,
        })
        .filter(|number| *number > 0)
        .collect();
    let pairs: Vec<String> = called.iter().map(|number| format!("{number}: 0")).collect();
    format!("correctors: {{{}}}\n", pairs.join(", "))
}
