//! The three sources of routes. Each candidate is tried and filed as feasible or refused.

use crate::error::{KnowledgeError, Refusal};
use crate::note::{Because, Note, Severity};
use crate::plan::{Feature, Operation, Preference, RouteSource, Transition};
use crate::reason::Reason;
use crate::route::auxiliary::{self, AuxiliaryKind};
use crate::route::scheme;
use crate::route::{Candidate, RouteStep, complex, search};
use crate::tables::holes::HoleDefault;
use crate::tables::practice::{ProofLimit, ProofLimits};
use crate::tables::rules::NextTransition;
use crate::units::{Micrometres, Minutes};
use technolog_proof::{Fault, Shortfall};

use super::fit::Fitted;
use super::options::{Choice, Options, RefusedRoute};
use super::whole::Finder;

impl Finder<'_, '_> {
    /// The kind of auxiliary hole in A.10; none where the main cylinder is finer and so a main hole of A.8 or A.9.
    pub fn auxiliary_kind(&self) -> Option<AuxiliaryKind> {
        AuxiliaryKind::of(self.hole, &self.task.main, self.drilled)
    }

    /// Tries all three sources. Where the tables finish a hole on another machine, the other two are asked only for a route that
    /// finishes it here without a doubt, and not at all where the position asks for boring: what bars hold here is just that.
    pub fn try_all_sources(&self, kind: Option<AuxiliaryKind>, options: &mut Options) -> Result<(), KnowledgeError> {
        if let Some(candidate) = self.tapped_at_once()? {
            self.try_candidate(&candidate, options)?;
            return Ok(());
        }
        self.tables(kind, options)?;
        let elsewhere = options.choices.iter().any(|choice| choice.candidate.finish_elsewhere);
        let resort = options.choices.iter().any(|choice| choice.candidate.last_resort);
        if elsewhere && !resort && (self.preference == Preference::Tables || self.close()?) {
            return Ok(());
        }
        self.other_sources(options)?;
        if elsewhere {
            options.finish_here_or_elsewhere();
        }
        Ok(())
    }

    fn other_sources(&self, options: &mut Options) -> Result<(), KnowledgeError> {
        self.complexes(options)?;
        // A.10 says how a hole in solid metal is made for a thread. Where it bores under it, a drill of that size may do alone.
        let bores = |choice: &Choice| choice.candidate.transitions.iter().any(|operation| operation.is_boring());
        let bored = options.choices.iter().any(bores);
        if self.task.main.thread.is_some() && self.task.main.before.is_solid() && !bored {
            return Ok(());
        }
        self.search(options)
    }

    /// Tapping alone, where the hole of the blank already has the size for the thread.
    fn tapped_at_once(&self) -> Result<Option<Candidate>, KnowledgeError> {
        let main = &self.task.main;
        let (Some(thread), Some(start)) = (&main.thread, self.sizes.start) else { return Ok(None) };
        if !(main.diameter.smallest()..=main.diameter.largest()).contains(&start) {
            return Ok(None);
        }
        let rule = self.shop.knowledge.table_of::<NextTransition<'_>>()?;
        let note = Note::new("tapped-at-once").with("start", start).with("thread", &thread.written);
        Ok(Some(Candidate {
            source: RouteSource::Search,
            table: rule.id.clone(),
            scheme: Operation::Tap.name().to_owned(),
            transitions: vec![Operation::Tap],
            finish_elsewhere: false,
            last_resort: false,
            promise: None,
            because: vec![Because::table(rule, note)],
        }))
    }

    /// The first scheme of the tables that can be carried out; the lower-ranked schemes are not compared with it.
    fn tables(&self, kind: Option<AuxiliaryKind>, options: &mut Options) -> Result<(), KnowledgeError> {
        let mut found = None;
        if let Some(kind) = kind {
            match Refusal::split(auxiliary::candidates(&self.question, kind, self.shop))? {
                Ok(schemes) => found = Some(schemes),
                Err(why) => options.refused.push(no_candidate(RouteSource::Tables, "A.10", why)),
            }
        }
        if found.is_none() && self.task.main.thread.is_none() {
            match Refusal::split(scheme::candidates(&self.question, self.shop))? {
                Ok(schemes) => found = Some(schemes),
                Err(why) => options.refused.push(no_candidate(RouteSource::Tables, "A.8", why)),
            }
        }
        let mut taken: Option<String> = None;
        for candidate in found.into_iter().flatten() {
            if let Some(first) = &taken {
                let later = refused(&candidate, Reason::RankedLater { first: first.clone() });
                let own = *first == format!("{} {}", candidate.table, candidate.scheme);
                if !own && !options.refused.contains(&later) {
                    options.refused.push(later);
                }
                continue;
            }
            if self.try_candidate(&candidate, options)? {
                taken = Some(format!("{} {}", candidate.table, candidate.scheme));
            }
        }
        Ok(())
    }

    fn complexes(&self, options: &mut Options) -> Result<(), KnowledgeError> {
        let openings = complex::Openings {
            counterbored: self.hole.counterbore.is_some(),
            countersunk: self.hole.countersink.is_some(),
        };
        match Refusal::split(complex::candidates(&self.question, openings, self.shop))? {
            Err(why) => options.refused.push(no_candidate(RouteSource::Complexes, "A.4", why)),
            Ok(complexes) => {
                for candidate in complexes {
                    self.try_candidate(&candidate, options)?;
                }
            }
        }
        Ok(())
    }

    fn search(&self, options: &mut Options) -> Result<(), KnowledgeError> {
        let main = &self.task.main;
        let cost = |steps: &[RouteStep]| self.cost(steps);
        match Refusal::split(search::candidates(main, &self.sizes, &cost, self.shop))? {
            Err(why) => options.refused.push(no_candidate(RouteSource::Search, "next-transition", why)),
            Ok(routes) => {
                for mut candidate in routes {
                    if main.thread.is_some() {
                        candidate.transitions.push(Operation::Tap);
                        candidate.scheme.push_str(" + tap");
                    }
                    self.try_candidate(&candidate, options)?;
                }
            }
        }
        Ok(())
    }

    /// Tries a candidate and files it as feasible or refused; returns whether it is feasible.
    fn try_candidate(&self, candidate: &Candidate, options: &mut Options) -> Result<bool, KnowledgeError> {
        // One route with a cutter for each opening, one with a step drill for hole and opening at once.
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
        let mut done = false;
        for steps in plain.into_iter().chain(joined) {
            let Some(choice) = self.proven(candidate, steps, options)? else { continue };
            done = true;
            let borrowed = choice.borrowed;
            self.file(choice, options);
            // Without the borrowed drill the rule requires one pass.
            if let Some(drill) = borrowed
                && let Ok(steps) = Refusal::split(self.carried_out_alone(candidate))?
                && let Some(alone) = self.proven(candidate, steps, options)?
            {
                self.file(Choice { instead_of: Some(drill), ..alone }, options);
            }
        }
        Ok(done)
    }

    /// The route of a candidate, if the proof accepts it; otherwise it is refused with the first reason.
    fn proven(
        &self,
        candidate: &Candidate,
        steps: Vec<Fitted>,
        options: &mut Options,
    ) -> Result<Option<Choice>, KnowledgeError> {
        let transitions: Vec<Transition> = steps.iter().map(|fitted| fitted.transition(0)).collect();
        let faults = technolog_proof::prove_hole(self.hole, &transitions, self.part, self.shop)?;
        let (at_best, mut wrong): (Vec<_>, Vec<_>) =
            faults.iter().partition(|fault| fault.severity() == Severity::Doubtful);
        // If the user prefers the tables, their scheme is taken, and what it does not reach is reported.
        if self.preference == Preference::Tables && candidate.source == RouteSource::Tables {
            wrong.retain(|fault| !matches!(fault, Fault::Wanting { .. }));
        }
        if let Some(first) = wrong.first() {
            let refused = refused(candidate, Reason::NotProven { why: first.note() });
            if !options.refused.contains(&refused) {
                options.refused.push(refused);
            }
            return Ok(None);
        }
        let at_best = at_best.into_iter().map(|fault| fault.note()).collect();
        let misses = self.misses(candidate, &steps)?;
        // A shortfall that the proof finds too is told by the proof alone, with its severity.
        let untold = misses.iter().filter(|miss| !faults.iter().any(|fault| miss.is_told_by(fault)));
        let untold = untold.map(|miss| miss.note.clone()).collect();
        let mut misses: Vec<Note> = misses.into_iter().map(|miss| miss.note).collect();
        // What stays unfinished above a floor is a remark of its step; a route without it goes first.
        let unfinished = self.shop.share(HoleDefault::UnfinishedShare)?;
        let left = |fitted: &&Fitted| fitted.step.leaves_unfinished(unfinished);
        misses.extend(steps.iter().find(left).map(|_| Note::new("misses-floor")));
        Ok(Some(Choice { at_best, misses, untold, ..self.choice(candidate, steps)? }))
    }

    /// Files a route as feasible, unless the same route is there already.
    fn file(&self, choice: Choice, options: &mut Options) {
        let twin = options.choices.iter().find(|known| same_route(known, &choice));
        let Some(twin) = twin else {
            options.choices.push(choice);
            return;
        };
        let (table, scheme) = (twin.candidate.table.clone(), twin.candidate.scheme.clone());
        let same = refused(&choice.candidate, Reason::SameAs { table, scheme });
        let itself = (same.source, &same.table, &same.scheme)
            == (twin.candidate.source, &twin.candidate.table, &twin.candidate.scheme);
        if !itself && !options.refused.contains(&same) {
            options.refused.push(same);
        }
    }

    fn choice(&self, candidate: &Candidate, steps: Vec<Fitted>) -> Result<Choice, KnowledgeError> {
        let own = steps.iter().map(|fitted| self.time(fitted) + self.rapids_between.0).sum::<f64>();
        let borrowed = steps.iter().find(|fitted| fitted.step.borrowed).map(|fitted| fitted.step.diameter);
        Ok(Choice {
            candidate: candidate.clone(),
            steps,
            misses: Vec::new(),
            untold: Vec::new(),
            at_best: Vec::new(),
            own_time: Minutes(own),
            borrowed,
            instead_of: None,
        })
    }

    /// The requirements of the drawing that a route does not hold. Grade, roughness and position must be promised by
    /// the table of the route or reached by its chain; what is finished on another machine is held there.
    fn misses(&self, candidate: &Candidate, steps: &[Fitted]) -> Result<Vec<Miss>, KnowledgeError> {
        let main = &self.task.main;
        if candidate.finish_elsewhere || candidate.transitions == [Operation::Tap] {
            return Ok(Vec::new());
        }
        let cuts =
            |step: &&RouteStep| step.place.feature == Feature::Bore && !step.elsewhere && step.achieved.is_some();
        let last = steps.iter().rev().map(|fitted| &fitted.step).find(cuts);
        let Some(reached) = last.and_then(|step| step.achieved) else {
            return Ok(vec![Miss { of: None, note: Note::new("misses-unknown") }]);
        };
        let mut misses = Vec::new();
        if main.thread.is_none() {
            // The proof judges the promise of a table; here the promise is enough.
            let promised = candidate.promise.map(|promise| promise.it);
            if promised.is_none_or(|it| it > main.diameter.it)
                && reached.it.is_none_or(|grade| grade > main.diameter.it)
            {
                let it = reached.it.map_or_else(|| "-".to_owned(), |it| it.to_string());
                let note = Note::new("misses-grade").with("it", it).with("asked", main.diameter.it);
                misses.push(Miss { of: Some(Requirement::Grade), note });
            }
            let promised = candidate.promise.and_then(|promise| promise.roughness);
            if promised.is_none_or(|roughness| roughness > main.roughness)
                && reached.roughness.is_none_or(|own| own > main.roughness)
            {
                let note = Note::new("misses-roughness").with("asked", main.roughness);
                let note = match reached.roughness {
                    Some(own) => note.with("roughness", own),
                    None => note.with("roughness", "-"),
                };
                misses.push(Miss { of: Some(Requirement::Surface), note });
            }
        }
        let required = self.question.position;
        if main.before.is_cast() && reached.position_mm.is_none() {
            let named = |row: &ProofLimits<'_>| row.name.is(ProofLimit::CoreShift);
            let shift = self.shop.knowledge.need(ProofLimit::CoreShift.name(), named)?.value;
            let shift = Micrometres::from_mm_rounded(shift);
            if shift > required {
                let note = Note::new("misses-axis").with("shift", shift).with("asked", required);
                misses.push(Miss { of: None, note });
            }
        }
        let beyond = reached.position_mm.filter(|own| *own > required);
        misses.extend(beyond.map(|own| Miss {
            of: Some(Requirement::Position),
            note: Note::new("misses-position").with("position", own).with("asked", required),
        }));
        Ok(misses)
    }
}

/// A requirement that the proof judges too.
#[derive(Clone, Copy, PartialEq)]
enum Requirement {
    Grade,
    Surface,
    Position,
}

/// A requirement that a route misses by its tables; `of` is none for what the proof does not judge.
struct Miss {
    of: Option<Requirement>,
    note: Note,
}

impl Miss {
    fn is_told_by(&self, fault: &Fault) -> bool {
        let Fault::Wanting { shortfall, .. } = fault else { return false };
        self.of
            == Some(match shortfall {
                Shortfall::Grade(..) => Requirement::Grade,
                Shortfall::Surface(..) => Requirement::Surface,
                Shortfall::Position(..) => Requirement::Position,
            })
    }
}

/// Whether two routes are the same: the same cutters leave the same diameters.
fn same_route(a: &Choice, b: &Choice) -> bool {
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

pub(super) fn refused(candidate: &Candidate, why: Reason) -> RefusedRoute {
    RefusedRoute { scheme: candidate.scheme.clone(), ..no_candidate(candidate.source, &candidate.table, why) }
}

/// The refusal of a source that has no candidate.
pub(super) fn no_candidate(source: RouteSource, table: &str, why: Reason) -> RefusedRoute {
    RefusedRoute { source, table: table.to_owned(), scheme: String::new(), operations: Vec::new(), meets: false, why }
}
