//! Every route a group of holes may take, each with its tools, conditions and time.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Input;
use crate::note::{Because, Note};
use crate::part::{Face, Hole, Part};
use crate::plan::{Alternative, Feature, Operation, Way};
use crate::route::auxiliary::{self, Kind};
use crate::route::bores::{self, Bore, Task};
use crate::route::diameters::{self, Sizes};
use crate::route::scheme::{self, Question};
use crate::route::{Candidate, Step, accuracy, complex, openings, order, search};
use crate::shop::Shop;
use crate::tooling::DrillSize;
use crate::units::{Micrometres, Minutes};

use super::fit::{Fitted, Fitting};

/// A route that can be carried out.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    pub candidate: Candidate,
    pub steps: Vec<Fitted>,
    /// Whether it holds grade, roughness and position.
    pub meets: bool,
    /// Cutting and rapids of all holes of the group, without tool changes.
    pub own: Minutes,
    /// A drill that another group must have, for which this route drills in two passes.
    pub borrowed: Option<Micrometres>,
}

/// The routes of a group.
#[derive(Clone, Debug, Default)]
pub(super) struct Options {
    /// What can be carried out.
    pub choices: Vec<Choice>,
    /// What cannot, or is barred by a rule, with the reason.
    pub refused: Vec<Alternative>,
    /// The tolerance on centre distances the tables were asked with.
    pub centre_tolerance: Micrometres,
    /// The row of A.6, or that it has none.
    pub stages: Option<Because>,
    /// Whether A.6 finishes the hole on another machine.
    pub stages_end_elsewhere: bool,
    /// Whether the position asks for boring and no boring tool can be used.
    pub not_bored: bool,
    /// What no axial tool makes, and openings that nothing opens.
    pub impossible: Vec<Note>,
}

impl Options {
    /// The transitions of a choice with their diameters, as plans show them.
    pub fn operations(choice: &Choice) -> Vec<(Operation, Micrometres)> {
        choice.steps.iter().map(|fitted| (fitted.step.operation, fitted.step.diameter)).collect()
    }
}

/// The steps that open a wider cylinder, or why nothing does.
type Opened = Result<Vec<Step>, Note>;

/// What the routes of one group are found with.
struct Finder<'a, 'k> {
    hole: &'a Hole,
    task: &'a Task,
    fitting: &'a Fitting<'a, 'k>,
    question: Question<'a>,
    sizes: Sizes<'a>,
    position: accuracy::Position,
    shop: &'a Shop<'k>,
    /// The best way to open each wider cylinder from a diameter.
    opened: RefCell<BTreeMap<(usize, Micrometres), Opened>>,
    hops: Minutes,
    /// The step that cuts each edge, or why none does.
    edges: Vec<Result<Step, Note>>,
    /// The edge that centring makes.
    centred_edge: Option<bores::Edge>,
}

/// Every route of a group of holes.
///
/// # Errors
/// The knowledge cannot answer. What makes the whole group impossible is a refusal.
pub(super) fn options(
    hole: &Hole,
    part: &Part,
    in_magazine: &[Micrometres],
    all_drills: &[DrillSize],
    shop: &Shop<'_>,
) -> Tried<Options> {
    let task = bores::task(hole, part, shop)?;
    let fitting = Fitting::new(hole, &task.edges, part, shop)?;
    let main = &task.main;
    let reached = |size: &&DrillSize| size.reach >= fitting.drill_reach(&main.place, size.diameter);
    let drills: Vec<Micrometres> = all_drills.iter().filter(reached).map(|size| size.diameter).collect();
    let written = accuracy::centre_tolerance(hole, shop).map_err(Refusal::Not)?;
    // The tables speak of machined faces: an unmachined one must be asked for as a tighter hole.
    let rough_face = accuracy::rough_face(main, part, shop)?;
    let loss = rough_face.as_ref().map_or(0.0, |(loss, _)| *loss);
    let centre_tolerance = Micrometres::from_mm_rounded(written.to_mm() / (1.0 + loss));
    let position = part.position_tolerance.unwrap_or(written);
    let question = Question { bore: main, centre_tolerance, position, outer_wall: hole.outer_wall, drills: &drills };
    let sizes = Sizes {
        drills: &drills,
        in_magazine,
        smallest_bore: smallest_bore(shop)?,
        start: hole.state.diameter(),
        single_drill: false,
        bore_large: false,
    };
    let finder = Finder {
        hole,
        task: &task,
        fitting: &fitting,
        question,
        sizes,
        position: accuracy::Position::new(main, part, shop)?,
        shop,
        opened: RefCell::new(BTreeMap::new()),
        hops: hops(hole, shop),
        edges: edges(&task, &fitting, shop)?,
        centred_edge: fitting.edge_by_centring()?,
    };
    let kind = finder.auxiliary_kind();
    let stage_name = kind.map_or("plain", Kind::stage_name);
    let asked = if kind.is_some() { auxiliary::diameter(&finder.question) } else { main.diameter.nominal };
    let (stages, stages_end_elsewhere) = scheme::stages(&finder.question, stage_name, asked, shop)?;
    let mut options = Options {
        centre_tolerance: written,
        stages: Some(stages),
        stages_end_elsewhere,
        impossible: task.impossible.clone(),
        ..Options::default()
    };
    for (edge, step) in task.edges.iter().zip(&finder.edges) {
        if let (Err(why), true) = (step, Some(*edge) != finder.centred_edge) {
            options.impossible.push(why.clone());
        }
    }
    finder.tables(kind, &mut options)?;
    let elsewhere = options.choices.iter().any(|choice| choice.candidate.finish_elsewhere);
    if !elsewhere {
        finder.complexes(&mut options)?;
        if main.thread.is_none() {
            finder.search(&mut options)?;
        }
    }
    finder.boring_stands_back(&mut options)?;
    if let Some((_, because)) = rough_face {
        for choice in &mut options.choices {
            choice.candidate.because.push(because.clone());
        }
    }
    Ok(options)
}

impl Finder<'_, '_> {
    /// The kind of auxiliary hole by which A.10 knows it; a finer main cylinder is a main hole of A.8 or A.9.
    fn auxiliary_kind(&self) -> Option<Kind> {
        let main = &self.task.main;
        if main.thread.is_some() {
            return Some(Kind::Thread);
        }
        if main.diameter.it.number() < 12 || !main.before.is_solid() || !self.hole.steps.is_empty() {
            return None;
        }
        if self.hole.counterbore.is_some() {
            return Some(Kind::Counterbore);
        }
        let sink = self.hole.countersink.map(|sink| sink.angle_millideg).or(self.hole.cone.map(|c| c.angle_millideg));
        sink.map(|angle| if angle == 90_000 { Kind::Countersink90 } else { Kind::CountersinkOther })
    }

    /// The first scheme of the tables that can be carried out; what the tables rank behind it is not weighed
    /// against it.
    fn tables(&self, kind: Option<Kind>, options: &mut Options) -> Result<(), KnowledgeError> {
        let mut found = None;
        if let Some(kind) = kind {
            match Refusal::split(auxiliary::candidates(&self.question, kind, self.shop))? {
                Ok(schemes) => found = Some(schemes),
                Err(why) => options.refused.push(none(Way::Tables, "A.10", why)),
            }
        }
        if found.is_none() && self.task.main.thread.is_none() {
            match Refusal::split(scheme::candidates(&self.question, self.shop))? {
                Ok(schemes) => found = Some(schemes),
                Err(why) => options.refused.push(none(Way::Tables, "A.8", why)),
            }
        }
        let mut taken = None;
        for candidate in found.into_iter().flatten() {
            if let Some(first) = &taken {
                let later = refused(&candidate, Note::new("ranked-later").with("first", first));
                let own = *first == format!("{} {}", candidate.table, candidate.scheme);
                if !own && !options.refused.contains(&later) {
                    options.refused.push(later);
                }
                continue;
            }
            if self.weigh(&candidate, options)? {
                taken = Some(format!("{} {}", candidate.table, candidate.scheme));
            }
        }
        Ok(())
    }

    fn complexes(&self, options: &mut Options) -> Result<(), KnowledgeError> {
        let counterbored = self.hole.counterbore.is_some();
        match Refusal::split(complex::candidates(&self.question, counterbored, self.shop))? {
            Err(why) => options.refused.push(none(Way::Complexes, "A.4", why)),
            Ok(complexes) => {
                for candidate in complexes {
                    self.weigh(&candidate, options)?;
                }
            }
        }
        Ok(())
    }

    fn search(&self, options: &mut Options) -> Result<(), KnowledgeError> {
        let main = &self.task.main;
        let cost = |steps: Vec<Step>| self.cost(steps);
        match Refusal::split(search::candidates(main, &self.sizes, &cost, self.shop))? {
            Err(why) => options.refused.push(none(Way::Search, "next-transition", why)),
            Ok(routes) => {
                for candidate in routes {
                    self.weigh(&candidate, options)?;
                }
            }
        }
        Ok(())
    }

    /// Time of steps for all holes of the group, each step with a tool change of its own.
    fn cost(&self, steps: Vec<Step>) -> Tried<Minutes> {
        let mut minutes = 0.0;
        for step in steps {
            minutes += self.shop.machine.tool_change.0 + self.hops.0;
            if step.operation == Operation::CentreDrill {
                continue;
            }
            let fitted = self.fitting.one(step, None, false)?;
            minutes += self.time(&fitted);
        }
        Ok(Minutes(minutes))
    }

    /// Cutting and withdrawal of a step in all holes of the group, min.
    fn time(&self, fitted: &Fitted) -> f64 {
        if fitted.step.elsewhere {
            return 0.0;
        }
        let back = fitted.travel.to_mm() * f64::from(fitted.step.passes) / self.shop.machine.rapid.0;
        (fitted.conditions.machine_time_min.0 + back) * self.hole.at.len() as f64
    }

    /// Tries a candidate, files it under what can be done or what cannot, and says whether it can.
    fn weigh(&self, candidate: &Candidate, options: &mut Options) -> Result<bool, KnowledgeError> {
        // With a cutter for each opening, and with a step drill for hole and opening at once.
        let plain = Refusal::split(self.carried_out(candidate, false))?;
        let joined =
            if self.may_join(candidate) { Refusal::split(self.carried_out(candidate, true))?.ok() } else { None };
        let plain = match (plain, &joined) {
            (Ok(steps), _) => Some(steps),
            (Err(_), Some(_)) => None,
            (Err(why), None) => {
                options.refused.push(refused(candidate, why));
                return Ok(false);
            }
        };
        for steps in plain.into_iter().chain(joined) {
            let choice = self.choice(candidate, steps);
            let twin = options.choices.iter().find(|known| same(known, &choice));
            match twin {
                Some(twin) => {
                    let why = Note::new("same-as").with("table", &twin.candidate.table);
                    let why = why.with("same", &twin.candidate.scheme);
                    options.refused.push(refused(candidate, why));
                }
                None => options.choices.push(choice),
            }
        }
        Ok(true)
    }

    /// Section 1.2 on boring (rule `boring-for-position`): where the position asks for it, routes of complexes
    /// and search that do not bore stand back; where it does not, those that bore; in both cases only while
    /// another route can be carried out.
    fn boring_stands_back(&self, options: &mut Options) -> Result<(), KnowledgeError> {
        let asked = self.boring_asked()?;
        let bores = |choice: &Choice| choice.candidate.transitions.iter().any(|operation| operation.is_boring());
        let stands_back = |choice: &Choice| choice.candidate.way != Way::Tables && bores(choice) != asked;
        let other = options.choices.iter().any(|choice| choice.meets && !stands_back(choice));
        if !other {
            options.not_bored = asked && !options.choices.iter().any(bores);
            return Ok(());
        }
        let (back, kept): (Vec<Choice>, Vec<Choice>) = options.choices.drain(..).partition(stands_back);
        options.choices = kept;
        let code = if asked { "position-asks-boring" } else { "boring-not-asked" };
        for choice in back {
            let why = Note::new(code).with("position", self.question.position);
            let operations = Options::operations(&choice);
            options.refused.push(Alternative { operations, meets: choice.meets, ..refused(&choice.candidate, why) });
        }
        Ok(())
    }

    /// Whether the position of the axis asks for boring, by the rule `boring-for-position`.
    fn boring_asked(&self) -> Result<bool, KnowledgeError> {
        let rule = self.shop.knowledge.table("boring-for-position")?;
        let enters = self.task.main.diameter.nominal >= self.sizes.smallest_bore;
        let position = self.question.position;
        let answer = rule.decide(&[("position", Input::Length(position)), ("bar_enters", Input::Bool(enters))])?;
        let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this position"))?;
        Ok(row.text("boring")? == "asked")
    }

    /// The steps of the whole hole by a candidate: as the rules prefer, else with one drill, else bored.
    fn carried_out(&self, candidate: &Candidate, joined: bool) -> Tried<Vec<Fitted>> {
        let mut first_why = None;
        for (single_drill, bore_large) in [(false, false), (true, false), (false, true), (true, true)] {
            let sizes = Sizes { single_drill, bore_large, ..self.sizes };
            let steps = match Refusal::split(diameters::steps(candidate, &self.task.main, &sizes, self.shop))? {
                Ok(steps) => steps,
                Err(why) => {
                    first_why.get_or_insert(why);
                    continue;
                }
            };
            let both = steps.iter().any(|step| step.operation == Operation::DrillOut);
            match Refusal::split(self.whole(steps, candidate, joined))? {
                Ok(mut fitted) => {
                    if both {
                        self.fitting.compare_with_one_drill(&mut fitted)?;
                    }
                    return Ok(fitted);
                }
                // The first reason is the one to tell: the other attempts are only ways around it.
                Err(why) => {
                    first_why.get_or_insert(why);
                }
            }
        }
        Err(Refusal::Not(first_why.unwrap_or_else(|| Note::new("no-route").with("tried", 0))))
    }

    /// Adds openings, edges and the floor to the steps of the main cylinder, in the order of section 1.1.2,
    /// and fits them all.
    fn whole(&self, mut steps: Vec<Step>, candidate: &Candidate, joined: bool) -> Tried<Vec<Fitted>> {
        let main = &self.task.main;
        accuracy::write(&mut steps, main, candidate.promise, self.position, self.shop)?;
        self.flat_floor(&mut steps)?;
        for step in &mut steps {
            step.elsewhere |= step.operation == Operation::Tap && !self.shop.machine.can_tap;
        }
        let also = if joined { self.join(&mut steps)? } else { None };
        let opened_from = roughed(&steps);
        let mut before = [opened_from, opened_from];
        for (index, bore) in self.task.wider.iter().enumerate().filter(|_| also != Some(Feature::Counterbore)) {
            let side = usize::from(bore.place.face == Face::Back);
            let opening = self.open(index, bore, before[side])?;
            before[side] = roughed(&opening);
            steps.extend(opening);
        }
        let centred = steps.iter().any(|step| step.operation == Operation::CentreDrill);
        let made = if centred { self.fitting.edge_by_centring()? } else { None };
        for (edge, step) in self.task.edges.iter().zip(&self.edges).filter(|(edge, _)| Some(**edge) != made) {
            match step {
                _ if also == Some(edge.feature) => {}
                Ok(step) => steps.push(step.clone()),
                // What centring makes in other routes is not made in this one.
                Err(why) if Some(*edge) == self.centred_edge => return Err(Refusal::Not(why.clone())),
                Err(_) => {}
            }
        }
        order::sort(&mut steps, self.shop)?;
        self.below_steps(&mut steps);
        self.fitting.fit(steps, candidate.finish_elsewhere)
    }

    /// What is done to the main cylinder after the steps above it begins below them.
    fn below_steps(&self, steps: &mut [Step]) {
        let wider = self.task.wider.iter().filter(|bore| bore.place.face == Face::Entry);
        let Some(deepest) = wider.map(|bore| bore.place.depth).max() else { return };
        let mut opened = false;
        for step in steps.iter_mut().filter(|step| step.place.face == Face::Entry) {
            let main = matches!(step.place.feature, Feature::Bore | Feature::Thread) && step.place.step.is_none();
            if !main {
                opened |= matches!(step.place.feature, Feature::Step | Feature::Counterbore);
            } else if opened && step.place.start < deepest {
                step.place.start = deepest;
            }
        }
    }

    /// A flat floor: the drill stops where its point touches it, and an end mill goes round on it.
    fn flat_floor(&self, steps: &mut Vec<Step>) -> Tried<()> {
        if !self.task.main.flat {
            return Ok(());
        }
        let Some(last) =
            steps.iter().rposition(|step| matches!(step.operation, Operation::Drill | Operation::DrillOut))
        else {
            return Ok(());
        };
        let (diameter, depth) = (steps[last].diameter, steps[last].place.depth);
        let stop = depth - self.fitting.point(diameter);
        if stop <= Micrometres::ZERO {
            let note = Note::new("too-shallow-for-flat").with("depth", depth).with("diameter", diameter);
            return Err(Refusal::Not(note));
        }
        let whole = steps[last].place;
        for step in &mut steps[..=last] {
            if step.operation != Operation::CentreDrill {
                step.place.depth = stop;
            }
        }
        let mut floor = Step::plain(Operation::Mill, whole, diameter, diameter);
        floor.place.start = stop;
        floor.because.push(Because::table(
            self.shop.knowledge.table("transition-order")?,
            Note::new("flat-floor").with("stop", stop).with("depth", depth),
        ));
        steps.insert(last + 1, floor);
        Ok(())
    }

    /// The quickest way to open a wider cylinder from a diameter.
    fn open(&self, index: usize, bore: &Bore, start: Micrometres) -> Tried<Vec<Step>> {
        if let Some(known) = self.opened.borrow().get(&(index, start)) {
            return known.clone().map_err(Refusal::Not);
        }
        let found = Refusal::split(self.opening(bore, start))?;
        self.opened.borrow_mut().insert((index, start), found.clone());
        found.map_err(Refusal::Not)
    }

    fn opening(&self, bore: &Bore, start: Micrometres) -> Tried<Vec<Step>> {
        let question = Question { bore, ..self.question };
        let sizes = Sizes { start: Some(start), ..self.sizes };
        let cost = |steps: Vec<Step>| self.cost(steps);
        let asked = self.boring_asked()?;
        let mut best: Option<((bool, Minutes), Vec<Step>)> = None;
        let mut why = None;
        for candidate in openings::candidates(bore, &question, &sizes, &cost, self.shop)? {
            for bore_large in [false, true] {
                let sizes = Sizes { bore_large, ..sizes };
                let made = diameters::steps(&candidate, bore, &sizes, self.shop).and_then(|mut steps| {
                    accuracy::write(&mut steps, bore, candidate.promise, self.position.following(), self.shop)?;
                    cone_above_shoulder(&mut steps, bore, start, self.fitting);
                    for step in &mut steps {
                        step.elsewhere |= step.operation == Operation::Tap && !self.shop.machine.can_tap;
                    }
                    Ok((self.cost(steps.clone())?, steps))
                });
                match Refusal::split(made)? {
                    Ok((minutes, mut steps)) => {
                        let bores = !asked && steps.iter().any(|step| step.operation.is_boring());
                        let better = |(least, time): (bool, Minutes)| (bores, minutes.0) < (least, time.0);
                        if best.as_ref().is_none_or(|(least, _)| better(*least)) {
                            if let Some(first) = steps.first_mut() {
                                first.because.extend(candidate.because.clone());
                            }
                            best = Some(((bores, minutes), steps));
                        }
                        break;
                    }
                    Err(note) => {
                        why.get_or_insert(note);
                    }
                }
            }
        }
        let none = || Note::new("no-opening").with("diameter", bore.diameter.nominal).with("start", start);
        best.map(|(_, steps)| steps).ok_or_else(|| Refusal::Not(why.unwrap_or_else(none)))
    }

    /// Whether a step drill may make the hole and its opening at once: a through hole that is only drilled,
    /// with one counterbore, or with a chamfer.
    fn may_join(&self, candidate: &Candidate) -> bool {
        let cuts = |operation: &&Operation| !matches!(operation, Operation::CentreDrill | Operation::Tap);
        let counterbored = self.hole.counterbore.is_some() && self.task.wider.len() == 1;
        let chamfered =
            self.task.wider.is_empty() && self.task.edges.iter().any(|edge| edge.feature == Feature::Chamfer);
        self.task.main.place.through
            && (counterbored || chamfered)
            && candidate.transitions.iter().filter(cuts).eq([&Operation::Drill])
    }

    /// Lets the drill make the opening too; which one, or why no step drill does.
    fn join(&self, steps: &mut [Step]) -> Tried<Option<Feature>> {
        let Some(drill) = steps.iter_mut().find(|step| step.operation == Operation::Drill) else {
            return Err(Refusal::Not(Note::new("no-step-drill")));
        };
        let (feature, wide) = match self.hole.counterbore {
            Some(counterbore) => (Feature::Counterbore, Some(counterbore.diameter)),
            None => {
                let chamfer = self.task.edges.iter().find(|edge| edge.feature == Feature::Chamfer);
                let chamfer = chamfer.map(|edge| edge.diameter).unwrap_or_default();
                (Feature::Chamfer, self.chamfering_drill(drill.diameter, chamfer)?)
            }
        };
        let none = || Note::new("no-step-drill").with("narrow", drill.diameter).with("wide", wide.unwrap_or_default());
        if wide.is_none() {
            return Err(Refusal::Not(none()));
        }
        drill.also = wide;
        Ok(Some(feature))
    }

    /// The wide diameter of a drill of A.15 that makes the chamfer too.
    fn chamfering_drill(
        &self,
        drill: Micrometres,
        chamfer: Micrometres,
    ) -> Result<Option<Micrometres>, KnowledgeError> {
        let table = self.shop.knowledge.table("A.15")?;
        let rows = table.all_rows().filter(|row| row.length_if_any("diameter") == Some(drill));
        Ok(rows.filter_map(|row| row.length_if_any("step_diameter")).find(|wide| *wide >= chamfer))
    }

    fn choice(&self, candidate: &Candidate, steps: Vec<Fitted>) -> Choice {
        let own = steps.iter().map(|fitted| self.time(fitted) + self.hops.0).sum::<f64>();
        let borrowed = steps
            .iter()
            .flat_map(|fitted| &fitted.because)
            .any(|why| why.note.code == "two-passes" && why.note.params.contains_key("first"))
            .then(|| steps.iter().find(|fitted| fitted.step.operation == Operation::Drill))
            .flatten()
            .map(|fitted| fitted.step.diameter)
            .filter(|drill| self.sizes.in_magazine.contains(drill));
        let meets = self.meets(candidate, &steps);
        Choice { candidate: candidate.clone(), steps, meets, own: Minutes(own), borrowed }
    }

    /// Whether a route holds what the drawing asks: what a table gives it promises; a searched one must reach
    /// grade, roughness and position by its chain.
    fn meets(&self, candidate: &Candidate, steps: &[Fitted]) -> bool {
        if candidate.way == Way::Tables {
            return true;
        }
        let main = &self.task.main;
        let last = steps
            .iter()
            .rev()
            .map(|fitted| &fitted.step)
            .find(|step| step.place.feature == Feature::Bore && !step.elsewhere && step.achieved.is_some());
        let Some(reached) = last.and_then(|step| step.achieved) else { return false };
        let graded = reached.it.is_some_and(|it| it <= main.diameter.it) || main.thread.is_some();
        let smooth = reached.roughness.is_some_and(|own| own <= main.roughness) || main.thread.is_some();
        let placed = candidate.way != Way::Search
            || reached.position_mm.is_none_or(|position| position <= self.question.position);
        graded && smooth && placed
    }
}

/// The step that cuts each edge of a hole, or why none does; a face that no counterbore of the catalogs cuts
/// is milled round.
fn edges(task: &Task, fitting: &Fitting<'_, '_>, shop: &Shop<'_>) -> Result<Vec<Result<Step, Note>>, KnowledgeError> {
    let mut steps = Vec::with_capacity(task.edges.len());
    for edge in &task.edges {
        let cut = |operation: Option<Operation>| -> Tried<Step> {
            let mut step = openings::edge(edge, edge.around, shop)?;
            step.operation = operation.unwrap_or(step.operation);
            fitting.one(step.clone(), None, false)?;
            Ok(step)
        };
        let mut found = Refusal::split(cut(None))?;
        if edge.feature == Feature::Face && found.is_err() {
            found = Refusal::split(cut(Some(Operation::Mill)))?;
        }
        steps.push(found);
    }
    Ok(steps)
}

/// Over a flat shoulder a drill stops where the rim of its point touches it; what is left is cut flat after it.
fn cone_above_shoulder(steps: &mut [Step], bore: &Bore, start: Micrometres, fitting: &Fitting<'_, '_>) {
    if !bore.flat {
        return;
    }
    for step in steps.iter_mut().filter(|step| step.operation == Operation::DrillOut) {
        let point = fitting.point(step.diameter) - fitting.point(start);
        step.place.depth = (step.place.depth - point).max(Micrometres::new(1));
    }
}

/// The diameter the main cylinder has when the openings are made: after its roughing.
fn roughed(steps: &[Step]) -> Micrometres {
    let rough = |step: &&Step| {
        matches!(
            step.operation,
            Operation::Drill | Operation::DrillOut | Operation::Mill | Operation::RoughBore | Operation::Counterbore
        )
    };
    let last = steps.iter().filter(rough).map(|step| step.diameter).max();
    last.or_else(|| steps.iter().map(|step| step.diameter).min()).unwrap_or_default()
}

/// Whether two routes are one: the same cutters leave the same diameters.
fn same(a: &Choice, b: &Choice) -> bool {
    let shown = |choice: &Choice| -> Vec<(Operation, Micrometres, Micrometres, Option<String>)> {
        let steps = choice.steps.iter();
        steps
            .map(|fitted| {
                let tool = fitted.tool.as_ref().map(|tool| tool.designation.clone());
                (fitted.step.operation, fitted.step.from, fitted.step.diameter, tool)
            })
            .collect()
    };
    a.candidate.finish_elsewhere == b.candidate.finish_elsewhere && shown(a) == shown(b)
}

fn refused(candidate: &Candidate, why: Note) -> Alternative {
    Alternative {
        way: candidate.way,
        table: candidate.table.clone(),
        scheme: candidate.scheme.clone(),
        operations: Vec::new(),
        time_min: None,
        new_tools: None,
        meets: false,
        why,
    }
}

/// A way that has no candidate at all.
fn none(way: Way, table: &str, why: Note) -> Alternative {
    Alternative {
        way,
        table: table.to_owned(),
        scheme: String::new(),
        operations: Vec::new(),
        time_min: None,
        new_tools: None,
        meets: false,
        why,
    }
}

/// The smallest hole a boring bar of the catalogs enters.
fn smallest_bore(shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let bars = shop.knowledge.table("boring-bars")?;
    Ok(bars.all_rows().filter_map(|row| row.length_if_any("diameter_min")).min().unwrap_or_default())
}

/// Rapids from hole to hole of one group, by one tool: for weighing routes, not the path itself.
fn hops(hole: &Hole, shop: &Shop<'_>) -> Minutes {
    let mut points = hole.at.clone();
    points.sort_unstable();
    let way: f64 =
        points.windows(2).map(|pair| (pair[0].x - pair[1].x).abs().max((pair[0].y - pair[1].y).abs()).to_mm()).sum();
    Minutes(way / shop.machine.rapid.0)
}
