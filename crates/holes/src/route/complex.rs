//! The second source of routes: the complexes of transitions of tables A.4 and A.5.

use crate::error::{Refusal, Tried};
use crate::note::{Because, Figure, Note};
use crate::plan::{Operation, RouteSource};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::tables::holes::{Complex, ComplexGroup, ComplexesOfHoleFor};
use crate::units::Micrometres;

use super::Candidate;
use super::scheme::{SchemeQuestion, centre_first};

/// The openings at the entry of the hole.
#[derive(Clone, Copy, Debug)]
pub struct Openings {
    /// A counterbore.
    pub counterbored: bool,
    /// A countersink.
    pub countersunk: bool,
}

/// The kind of hole of a cylinder in A.4, and the diameter by which A.4 is queried.
fn kind(question: &SchemeQuestion<'_>, openings: Openings) -> Option<(ComplexGroup, Micrometres)> {
    let bore = question.bore;
    let diameter = bore.diameter.nominal;
    match (&bore.thread, bore.diameter.it.number()) {
        _ if !bore.before.is_solid() => None,
        (Some(thread), _) => Some((ComplexGroup::Threaded, thread.size)),
        (None, 12..) if openings.counterbored => Some((ComplexGroup::Counterbored, diameter)),
        (None, 12..) if openings.countersunk => Some((ComplexGroup::Countersunk, diameter)),
        (None, 12..) => Some((ComplexGroup::Smooth, diameter)),
        // Group 5 of A.4 holds grades 7 to 9; grades 10 and 11 are in no group.
        (None, 7..=9) => Some((ComplexGroup::Precise, diameter)),
        _ => None,
    }
}

/// The complexes of A.4 for a cylinder in solid metal, in its order.
///
/// The chamfering and counterboring of a complex are planned with the openings of the hole; centring is added where
/// section 1.2.1 requires it.
///
/// # Errors
/// The knowledge base has no answer, or A.4 has no complex for it.
pub fn candidates(question: &SchemeQuestion<'_>, openings: Openings, shop: &Shop<'_>) -> Tried<Vec<Candidate>> {
    let (grade, nominal, centre) =
        (question.bore.diameter.it, question.bore.diameter.nominal, question.centre_tolerance);
    let Some((kind, diameter)) = kind(question, openings) else {
        return Err(Refusal::Not(Reason::NoComplexGroup { it: grade, diameter: nominal, centre }));
    };
    let no_complex = || Refusal::Not(Reason::NoComplex { it: grade, diameter: nominal, centre });
    let query = ComplexesOfHoleFor { hole: kind, diameter, centre_tolerance: centre };
    let answer = shop.knowledge.ask_within(&query)?.ok_or_else(no_complex)?;
    let Some(row) = answer.winner()? else { return Err(no_complex()) };
    let (centred, centring) = centre_first(question.bore, shop)?;
    let mut found = Vec::new();
    for number in row.complex {
        let complex = shop.knowledge.need(number, |row: &Complex<'_>| row.complex.to_string() == number)?;
        let mut transitions: Vec<Operation> = complex
            .transitions
            .into_iter()
            .filter(|operation| !matches!(operation, Operation::Chamfer | Operation::Counterbore))
            .collect();
        let note = Note::new("complex").with("complex", number).with("kind", Figure::word(kind.name()));
        let mut because = vec![Because::answer(&answer.answer, note), centring.clone()];
        let mut scheme = number.to_owned();
        if centred && transitions.first() != Some(&Operation::CentreDrill) {
            transitions.insert(0, Operation::CentreDrill);
            scheme.push_str(" + centre");
        }
        because.push(Because::row(complex.row, Note::new("complex-transitions").with("complex", number)));
        found.push(Candidate {
            source: RouteSource::Complexes,
            table: complex.row.table.id.clone(),
            scheme,
            transitions,
            finish_elsewhere: false,
            last_resort: false,
            // A.4 promises the grades of its groups: 7 to 9 for the precise holes. The roughness is that of the
            // chain.
            promise: (kind != ComplexGroup::Threaded).then_some(super::Promise {
                it: question.bore.diameter.it,
                roughness: None,
                position: Some(question.drawn_tolerance),
            }),
            because,
        });
    }
    Ok(found)
}
