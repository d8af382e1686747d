//! All routes that a group of holes may take, each with tools, conditions and time; [`super::sources`] finds them.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::job::Hands;
use crate::note::{Because, Note};
use crate::part::{Bottom, Hole, Part};
use crate::plan::{Alternative, AlternativeStep, Feature, Operation, Preference, RouteSource};
use crate::reason::Reason;
use crate::route::auxiliary::{self, AuxiliaryKind};
use crate::route::bores::{self, Task};
use crate::route::diameters::Sizes;
use crate::route::scheme::{self, SchemeQuestion};
use crate::route::{Candidate, Remark, RouteStep, accuracy, openings};
use crate::shop::Shop;
use crate::tables::holes::{HoleDefault, StagedHole};
use crate::tables::practice::{ProofLimit, ProofLimits};
use crate::tables::rules::{BoringAsked, BoringForPositionFor, ToolTables};
use crate::tooling::DrillSize;
use crate::units::{Micrometres, Minutes};

use super::finer::Finer;
use super::fit::{Fitted, Fitting};
use super::slots;
use super::sources::{no_candidate, refused};
use super::whole::{Finder, edges, rapids_between, smallest_bore};

/// A route that can be carried out.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    pub candidate: Candidate,
    pub steps: Vec<Fitted>,
    /// The requirements of grade, roughness and position that it misses.
    pub misses: Vec<Note>,
    /// Those of them that the proof does not tell.
    pub untold: Vec<Note>,
    /// What the proof says that the route reaches only at best.
    pub at_best: Vec<Note>,
    /// Time of cutting and rapids in all holes of the group, without tool changes.
    pub own_time: Minutes,
    /// A drill of another group, because of which this route drills in two passes.
    pub borrowed: Option<Micrometres>,
    /// The drill without which this route drills in one pass; with it the rule requires two passes.
    pub instead_of: Option<Micrometres>,
    /// The scheme that the tables rank before it, where that can be carried out too.
    pub ranked_after: Option<String>,
}

impl Choice {
    /// Whether the route holds grade, roughness and position.
    pub fn meets_requirements(&self) -> bool {
        self.misses.is_empty()
    }

    /// Whether it leaves more unfinished above a flat floor than bars do, which stop that far above it.
    pub fn stops_high(&self, bar_gap: Micrometres) -> bool {
        self.over_floor() > bar_gap
    }

    /// How much of the main cylinder it leaves unfinished above a flat floor.
    pub fn over_floor(&self) -> Micrometres {
        let main = self.steps.iter().map(|fitted| &fitted.step).filter(|step| step.place.feature == Feature::Bore);
        main.flat_map(|step| &step.remarks)
            .filter_map(|remark| match remark {
                Remark::EndsAboveFloor(left) => Some(*left),
                _ => None,
            })
            .max()
            .unwrap_or_default()
    }
}

/// A route that cannot be carried out or is excluded by a rule, with the reason.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RefusedRoute {
    pub source: RouteSource,
    pub table: String,
    /// The scheme; empty where a source has none at all.
    pub scheme: String,
    /// The transitions, if known.
    pub operations: Vec<AlternativeStep>,
    /// Whether it would hold grade, roughness and position.
    pub meets: bool,
    pub why: Reason,
}

impl RefusedRoute {
    /// The route as a plan shows it.
    pub fn to_alternative(&self) -> Alternative {
        Alternative {
            source: self.source,
            table: self.table.clone(),
            scheme: self.scheme.clone(),
            operations: self.operations.clone(),
            time_min: None,
            new_tools: None,
            meets: self.meets,
            why: self.why.note(),
        }
    }
}

/// The routes of a group.
#[derive(Clone, Debug, Default)]
pub(super) struct Options {
    /// The routes that can be carried out.
    pub choices: Vec<Choice>,
    /// The routes that cannot be carried out or are excluded by a rule, each with the reason.
    pub refused: Vec<RefusedRoute>,
    /// The tolerance on centre distances the tables were queried with.
    pub centre_tolerance: Micrometres,
    /// The row of A.6, or the reason that there is none.
    pub stages: Option<Because>,
    /// Whether the position requires boring and no boring tool can be used.
    pub not_bored: bool,
    /// What no axial tool can make, and openings for which there is no tool.
    pub impossible: Vec<Note>,
    /// Requirements of the drawing that are probably a mistake.
    pub doubtful: Vec<Note>,
    /// What cannot be done, where the drawing does not require it.
    pub remarks: Vec<Note>,
    /// Where no route can be carried out: the nearest depth at which one can.
    pub nearest: Option<Note>,
    /// There, too: another machine that makes the hole as drawn.
    pub other_machine: Option<Note>,
}

impl Options {
    /// Adds routes that were refused, each once.
    fn also_refused(&mut self, others: Vec<RefusedRoute>) {
        for other in others {
            if !self.refused.contains(&other) {
                self.refused.push(other);
            }
        }
    }

    /// Keeps either the routes that finish the hole here or those that leave it to another machine: the former if one of them
    /// holds every requirement, and not only at best; where the other machine is a last resort, also at best. Time does not decide,
    /// because that of the other machine is not known.
    pub fn finish_here_or_elsewhere(&mut self) {
        let elsewhere = |choice: &Choice| choice.candidate.finish_elsewhere;
        let resort = self.choices.iter().filter(|choice| elsewhere(choice)).all(|choice| choice.candidate.last_resort);
        let sure = |choice: &Choice| {
            !elsewhere(choice) && choice.meets_requirements() && (resort || choice.at_best.is_empty())
        };
        let here = self.choices.iter().any(sure);
        let kept = |choice: &Choice| if here { sure(choice) } else { elsewhere(choice) };
        let (kept, back): (Vec<Choice>, Vec<Choice>) = self.choices.drain(..).partition(kept);
        self.choices = kept;
        for choice in back {
            let why = if elsewhere(&choice) { Reason::FinishedHere } else { Reason::NotSurelyFinishedHere };
            let operations = Self::operations(&choice);
            let refused = refused(&choice.candidate, why);
            self.refused.push(RefusedRoute { operations, meets: choice.meets_requirements(), ..refused });
        }
    }

    /// The transitions of a choice with their diameters, as a plan shows them.
    pub fn operations(choice: &Choice) -> Vec<AlternativeStep> {
        let made = |fitted: &Fitted| AlternativeStep {
            operation: fitted.step.operation,
            diameter_mm: fitted.step.diameter,
            elsewhere: fitted.step.elsewhere,
        };
        choice.steps.iter().map(made).collect()
    }
}

/// Every route of a group of holes. Where none holds grade and roughness, the hole is left for another machine to finish.
///
/// # Errors
/// The knowledge base has no answer. What makes the whole group impossible is a refusal, not an error.
pub(super) fn options(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Tried<Options> {
    if hole.slot.is_some() {
        return slots::options(hole, part, shop);
    }
    let mut own = options_here(hole, part, preference, drills, shop)?;
    if own.choices.iter().any(Choice::meets_requirements) {
        return Ok(own);
    }
    let Some(finer) = Finer::of(hole, shop)? else { return Ok(own) };
    let mut left = options_here(&finer.here, part, preference, drills, shop)?;
    left.choices.retain(Choice::meets_requirements);
    if left.choices.is_empty() || left.impossible.len() > own.impossible.len() {
        // What keeps the hole from being prepared is what keeps it from being made.
        if own.choices.is_empty() {
            own.also_refused(left.refused);
        }
        return Ok(own);
    }
    left.choices = left.choices.into_iter().map(|choice| finer.finished(choice)).collect();
    left.also_refused(own.refused);
    Ok(left)
}

/// Every route of a group of holes on this machine. A free floor is made flat where no route leaves the cone of a drill: its
/// point may come through the part, and what a flat floor permits is permitted by a free one. Under a blind thread without room
/// for the usual run-out, or where that leaves less floor than there should be, the drill goes deeper by the lead of the tap alone;
/// where that does not go either, by the lead of a bottoming tap, and no less.
///
/// # Errors
/// As for [`options`].
fn options_here(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Tried<Options> {
    let meets = |options: &Options| options.choices.iter().any(Choice::meets_requirements);
    let usual = HoleDefault::ThreadRunoutPitches;
    let own = options_as_drawn(hole, part, preference, usual, drills, shop)?;
    if let Some(thread) = hole.thread.as_ref().filter(|_| !hole.through) {
        if !own.choices.is_empty() && !leaves_thin_floor(&own, part, shop)? {
            return Ok(own);
        }
        let pitch = |name| Ok(Micrometres::from_mm_rounded(thread.pitch.to_mm() * shop.share(name)?));
        let mut refused = None;
        for (lead, code) in [
            (HoleDefault::TapLeadPitches, "thread-runout-short"),
            (HoleDefault::BottomingTapLeadPitches, "thread-bottoming-tap"),
        ] {
            let mut short = options_as_drawn(hole, part, preference, lead, drills, shop)?;
            if !short.choices.is_empty() {
                let note = Note::new(code).with("runout", pitch(lead)?);
                short.remarks.push(note.with("usual", pitch(usual).map_err(Refusal::Knowledge)?));
                return Ok(short);
            }
            if !own.choices.is_empty() {
                return Ok(own);
            }
            refused = Some(short);
        }
        // The refusal is that of the shortest lead: no depth less than that makes the thread.
        return Ok(refused.unwrap_or(own));
    }
    if hole.through || hole.thread.is_some() || hole.bottom == Bottom::Flat || meets(&own) {
        return Ok(own);
    }
    let flat = Hole { bottom: Bottom::Flat, ..hole.clone() };
    let mut flat = options_as_drawn(&flat, part, preference, usual, drills, shop)?;
    if !meets(&flat) || flat.impossible.len() > own.impossible.len() {
        return Ok(own);
    }
    flat.remarks.push(Note::new("free-floor-flat"));
    Ok(flat)
}

/// Whether every route leaves less floor under the point of its drill than there should be (table `proof-limits`).
fn leaves_thin_floor(options: &Options, part: &Part, shop: &Shop<'_>) -> Result<bool, KnowledgeError> {
    let name = ProofLimit::LeastFloor;
    let least = shop.knowledge.need(name.name(), |row: &ProofLimits<'_>| row.name.is(name))?.value;
    let most = part.blank.thickness - Micrometres::from_mm_rounded(least);
    let drilled = |fitted: &Fitted| matches!(fitted.step.operation, Operation::Drill | Operation::DrillOut);
    let thin = |choice: &Choice| choice.steps.iter().filter(|fitted| drilled(fitted)).any(|fitted| fitted.end() > most);
    Ok(options.choices.iter().all(thin))
}

fn options_as_drawn(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    run_out: HoleDefault,
    (in_magazine, all_drills): (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Tried<Options> {
    let task = bores::task_with_run_out(hole, part, run_out, shop)?;
    let usual = Fitting::new(hole, &task.edges, part, shop)?;
    let bottoming = run_out == HoleDefault::BottomingTapLeadPitches;
    let fitting = if bottoming { usual.with_taps(run_out)? } else { usual };
    let main = &task.main;
    let mut drills = Vec::new();
    for size in all_drills {
        if size.reach >= fitting.drill_reach(&main.place, size.diameter)? {
            drills.push(size.diameter);
        }
    }
    let written = accuracy::centre_tolerance(hole, shop).map_err(Refusal::Not)?;
    // The tables assume machined faces: for an unmachined face they are queried with a tighter tolerance.
    let rough_face = accuracy::rough_face(main, part, shop)?;
    let loss = rough_face.as_ref().map_or(0.0, |(loss, _)| *loss);
    let centre_tolerance = Micrometres::from_mm_rounded(written.to_mm() / (1.0 + loss));
    let position = part.position_tolerance.unwrap_or(written);
    let question = SchemeQuestion {
        bore: main,
        centre_tolerance,
        drawn_tolerance: written,
        position,
        outer_wall: hole.outer_wall,
        drills: &drills,
    };
    let sizes = Sizes {
        drills: &drills,
        in_magazine,
        smallest_bore: smallest_bore(shop)?,
        overruns: [false, true].map(|through| fitting.travels(through).1),
        start: hole.state.diameter(),
        single_drill: false,
        bore_large: false,
        level_floor: true,
    };
    let mut finder = Finder {
        hole,
        part,
        preference,
        task: &task,
        fitting: &fitting,
        question,
        sizes,
        position: accuracy::Position::new(main, part, shop)?,
        shop,
        opened: RefCell::new(BTreeMap::new()),
        rapids_between: rapids_between(hole, shop),
        hands: Hands::read(shop.knowledge)?,
        drilled: accuracy::drilled(shop)?,
        edges: edges_with_reasons(&task, &fitting, shop)?,
        centred_edge: fitting.edge_by_centring()?,
    };
    let kind = finder.auxiliary_kind();
    let stage_name = kind.map_or(StagedHole::Plain, AuxiliaryKind::stage_name);
    let main_diameter = if kind.is_some() { auxiliary::diameter(&finder.question) } else { main.diameter.nominal };
    let (stages, stages_end_elsewhere) = scheme::stages(&finder.question, stage_name, main_diameter, shop)?;
    if stages_end_elsewhere {
        // A.6 asks for the position of the axis; A.8 and A.9 have such holes in the column of the tightest centre
        // distance.
        finder.question.centre_tolerance = finder.question.centre_tolerance.min(position);
    }
    let mut options = Options {
        centre_tolerance: written,
        stages: Some(stages),
        impossible: task.impossible.clone(),
        doubtful: task.doubtful.clone(),
        ..Options::default()
    };
    for (edge, step) in task.edges.iter().zip(&finder.edges) {
        if let (Err(why), true) = (step, Some(*edge) != finder.centred_edge) {
            // The chamfer of a thread is not in the drawing: a tap begins without it all the same.
            if edge.required {
                options.impossible.push(why.note());
            } else {
                options.remarks.push(Note::new("thread-without-chamfer").with("why", why.note()));
            }
        }
    }
    finder.try_all_sources(kind, &mut options)?;
    if options.choices.is_empty() && main.flat {
        // Where no mill can make the floor flat, the hole is planned with the cone of the drill, and the plan says
        // why.
        let why = options.refused.iter().map(|other| &other.why).find(|why| why.is_of_milled_floor()).map(Reason::note);
        finder.sizes.level_floor = false;
        let refused = std::mem::take(&mut options.refused);
        finder.try_all_sources(kind, &mut options)?;
        if options.choices.is_empty() {
            options.refused = refused;
        } else {
            let why = why.or_else(|| refused.first().map(|other| other.why.note()));
            options.impossible.extend(std::iter::once(Note::new("floor-not-flat")).chain(why));
        }
    }
    // What opens a hole of the blank is refused for reasons of its own: the hole is there without a drill.
    if options.choices.is_empty()
        && main.before.is_solid()
        && let Some(short) = too_short(&options.refused, all_drills, &drills, shop.machine.drill_max)
    {
        let needed = fitting.drill_reach(&main.place, short.diameter)?;
        let why = Reason::DrillsTooShort { diameter: short.diameter, reach: short.reach, needed };
        options.refused.push(no_candidate(RouteSource::Search, "next-transition", why));
    }
    finder.exclude_by_boring_rule(&mut options)?;
    finder.only_quicker(&mut options);
    if let Some((_, because)) = rough_face {
        for choice in &mut options.choices {
            choice.candidate.because.push(because.clone());
        }
    }
    Ok(options)
}

impl Finder<'_, '_> {
    /// Section 1.2 on boring (rule `boring-for-position`). Where the position requires boring, routes of complexes
    /// and of the search without boring are excluded; where it does not, those with boring. Both hold only while
    /// another route can be carried out.
    fn exclude_by_boring_rule(&self, options: &mut Options) -> Result<(), KnowledgeError> {
        let boring = self.boring_required()?;
        let bores = |choice: &Choice| choice.candidate.transitions.iter().any(|operation| operation.is_boring());
        let stands_back = |choice: &Choice| choice.candidate.source != RouteSource::Tables && bores(choice) != boring;
        options.not_bored = !boring && self.close()?;
        // The text compares boring with drills, core drills and reamers: beside a mill, time decides.
        let mills = |choice: &Choice| {
            choice.steps.iter().map(|fitted| &fitted.step).any(|step| {
                step.operation == Operation::Mill && step.place.feature == Feature::Bore && step.from != step.diameter
            })
        };
        let goes_first = |choice: &Choice| !stands_back(choice) && (boring || !mills(choice));
        // Nor does it compare them over a flat floor, where a reamer stops higher, by its lead, than a bar.
        let gap = self.shop.convention(HoleDefault::FlatFloorGap)?;
        let down = |choice: &Choice| boring || !choice.stops_high(gap);
        let other =
            options.choices.iter().any(|choice| choice.meets_requirements() && goes_first(choice) && down(choice));
        if !other {
            options.not_bored = self.close()? && !options.choices.iter().any(bores);
            return Ok(());
        }
        let (back, kept): (Vec<Choice>, Vec<Choice>) = options.choices.drain(..).partition(stands_back);
        options.choices = kept;
        let position = self.question.position;
        let why = if boring { Reason::BoringAsked { position } } else { Reason::BoringNotAsked { position } };
        for choice in back {
            let operations = Options::operations(&choice);
            let refused = refused(&choice.candidate, why.clone());
            options.refused.push(RefusedRoute { operations, meets: choice.meets_requirements(), ..refused });
        }
        Ok(())
    }

    /// Whether the position would require boring, if a boring bar could enter.
    pub fn close(&self) -> Result<bool, KnowledgeError> {
        self.asks_for_boring(true)
    }

    /// Whether the position of the axis requires boring, by the rule `boring-for-position`.
    pub fn boring_required(&self) -> Result<bool, KnowledgeError> {
        self.asks_for_boring(self.task.main.diameter.nominal >= self.sizes.smallest_bore)
    }

    fn asks_for_boring(&self, enters: bool) -> Result<bool, KnowledgeError> {
        let position = self.question.position;
        let rule = self.shop.knowledge.ask(&BoringForPositionFor { position, bar_enters: enters })?;
        Ok(rule.need("this position")?.boring == BoringAsked::Asked)
    }
}

/// The steps of the edges; a face that is milled says why no cutter plunges it.
fn edges_with_reasons(
    task: &Task,
    fitting: &Fitting<'_, '_>,
    shop: &Shop<'_>,
) -> Result<Vec<Result<RouteStep, Reason>>, KnowledgeError> {
    let mut steps = edges(task, fitting, shop)?;
    for (edge, step) in task.edges.iter().zip(&mut steps) {
        let Ok(step) = step else { continue };
        if edge.feature != Feature::Face || step.operation != Operation::Mill {
            continue;
        }
        let plunged = openings::edge(edge, edge.cylinder_diameter, shop);
        if let Err(why) = Refusal::split(plunged.and_then(|step| fitting.fit_step(step, None, false)))? {
            let rule = shop.knowledge.table_of::<ToolTables<'_>>()?;
            step.because.push(Because::table(rule, Note::new("face-milled").with("why", why.note())));
        }
    }
    Ok(steps)
}

/// The largest drill of a size that a route lacked, that the machine takes and that the catalogs have only too short.
fn too_short(
    refused: &[RefusedRoute],
    all: &[DrillSize],
    reaching: &[Micrometres],
    most: Micrometres,
) -> Option<DrillSize> {
    let short = |size: &&DrillSize| size.diameter <= most && !reaching.contains(&size.diameter);
    refused.iter().find_map(|other| {
        let lacked = match other.why {
            Reason::NoDrillInAllowance { low, high, .. } => low..=high,
            Reason::NoDrillBefore { largest, .. } => Micrometres::ZERO..=largest,
            _ => return None,
        };
        all.iter().rev().filter(short).find(|size| lacked.contains(&size.diameter)).copied()
    })
}
