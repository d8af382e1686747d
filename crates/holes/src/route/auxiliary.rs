//! Table A.10: schemes for threaded, counterbored and countersunk holes.

use crate::error::{Refusal, Tried};
use crate::note::{Because, Figure, Note};
use crate::part::{Hole, ThreadKind};
use crate::plan::{Operation, RouteSource};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::tables::holes::{AuxiliaryHole, SchemesOfAuxiliaryHoleFor, StagedHole};
use crate::units::{ItGrade, Micrometres};

use super::Candidate;
use super::bores::Bore;
use super::scheme::{SchemeQuestion, with_transitions};

/// The kinds of hole by which A.10 is queried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AuxiliaryKind {
    /// A thread.
    Thread,
    /// A counterbore over a hole.
    Counterbore,
    /// A countersink of 90 degrees over a hole.
    Countersink90,
    /// A countersink of another angle over a hole.
    CountersinkOther,
}

impl AuxiliaryKind {
    /// The kind of hole by which A.10 is queried. None for plain and stepped holes, for holes finer than what
    /// drilling leaves (`drilled`), and where the metal is not solid, because A.10 begins in solid metal.
    pub fn of(hole: &Hole, main: &Bore, drilled: ItGrade) -> Option<Self> {
        if main.thread.is_some() {
            return main.before.is_solid().then_some(Self::Thread);
        }
        if main.diameter.it < drilled || !main.before.is_solid() || !hole.steps.is_empty() {
            return None;
        }
        if hole.counterbore.is_some() {
            return Some(Self::Counterbore);
        }
        let sink = hole.countersink.map(|sink| sink.angle_millideg).or(hole.cone.map(|cone| cone.angle_millideg));
        sink.map(|angle| if angle == 90_000 { Self::Countersink90 } else { Self::CountersinkOther })
    }

    /// As A.10 names it.
    pub fn name(self, question: &SchemeQuestion<'_>) -> AuxiliaryHole {
        match self {
            Self::Thread => match question.bore.thread.as_ref().map(|thread| thread.kind) {
                Some(ThreadKind::Conical) => AuxiliaryHole::ThreadConical,
                _ => AuxiliaryHole::ThreadCylindrical,
            },
            Self::Counterbore => AuxiliaryHole::Counterbore,
            Self::Countersink90 => AuxiliaryHole::Countersink90,
            Self::CountersinkOther => AuxiliaryHole::CountersinkOther,
        }
    }

    /// As A.6 names it.
    pub const fn stage_name(self) -> StagedHole {
        match self {
            Self::Thread => StagedHole::Threaded,
            Self::Counterbore => StagedHole::Counterbored,
            Self::Countersink90 | Self::CountersinkOther => StagedHole::Countersunk,
        }
    }
}

/// The diameter by which A.10 and A.6 are queried: of a thread its own, otherwise that of the hole.
pub fn diameter(question: &SchemeQuestion<'_>) -> Micrometres {
    question.bore.thread.as_ref().map_or(question.bore.diameter.nominal, |thread| thread.size)
}

/// The query to A.10.
pub fn query(question: &SchemeQuestion<'_>, kind: AuxiliaryKind) -> SchemesOfAuxiliaryHoleFor {
    SchemesOfAuxiliaryHoleFor {
        hole: kind.name(question),
        diameter: diameter(question),
        centre_tolerance: question.centre_tolerance,
    }
}

/// The schemes of A.10 in its order; a scheme marked with a star only where no drill has the diameter of the hole.
/// Counterboring and chamfering are left out here: they are planned with the openings of the hole.
///
/// # Errors
/// The knowledge base has no answer, or A.10 has no scheme.
pub fn candidates(question: &SchemeQuestion<'_>, kind: AuxiliaryKind, shop: &Shop<'_>) -> Tried<Vec<Candidate>> {
    let (name, diameter) = (kind.name(question), diameter(question));
    let answer = shop.knowledge.ask(&query(question, kind))?;
    let Some(row) = answer.winner()? else {
        let centre = question.centre_tolerance;
        return Err(Refusal::Not(Reason::NoAuxiliaryScheme { kind: name.name(), diameter, centre }));
    };
    let starred = row.if_drill_differs.unwrap_or_default();
    let drill = super::diameters::final_drill(&question.bore.diameter, question.drills, shop)?.is_some();
    let mut found = Vec::new();
    for scheme in row.schemes {
        if starred.contains(&scheme) && drill {
            continue;
        }
        let note = Note::new("auxiliary-scheme")
            .with("scheme", Figure::scheme(scheme))
            .with("kind", Figure::word(name.name()));
        let candidate = Candidate {
            source: RouteSource::Tables,
            table: row.row.table.id.clone(),
            scheme: scheme.to_owned(),
            transitions: Vec::new(),
            finish_elsewhere: false,
            last_resort: false,
            // A.10 promises nothing for the hole under a thread.
            promise: (kind != AuxiliaryKind::Thread).then_some(super::Promise {
                it: question.bore.diameter.it,
                roughness: None,
                position: Some(question.drawn_tolerance),
            }),
            because: vec![Because::answer(&answer.answer, note)],
        };
        let mut candidate = with_transitions(candidate, question.bore, shop)?;
        candidate.transitions.retain(|operation| !matches!(operation, Operation::Counterbore | Operation::Chamfer));
        found.push(candidate);
    }
    Ok(found)
}
