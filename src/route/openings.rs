//! The rest of a hole: wider cylinders, and the edges and faces at its ends.

use crate::error::{Refusal, Tried};
use crate::note::{Because, Note};
use crate::plan::{Feature, Operation};
use crate::shop::Shop;
use crate::units::Micrometres;

use super::bores::{Bore, Edge};
use super::diameters::Sizes;
use super::scheme::{self, Question};
use super::search::{self, Cost, leaves_flat};
use super::{Candidate, Place, Step};

/// The candidates of a wider cylinder: for a step of the drawing those of the tables for a hole that is
/// there already, and those of the search; a shoulder that must be flat takes only those that leave one.
///
/// # Errors
/// The knowledge cannot answer, or nothing opens it.
pub fn candidates(
    bore: &Bore,
    question: &Question<'_>,
    sizes: &Sizes<'_>,
    cost: &Cost<'_>,
    shop: &Shop<'_>,
) -> Tried<Vec<Candidate>> {
    let mut found = Vec::new();
    let mut failed = None;
    if bore.place.feature == Feature::Step && bore.thread.is_none() {
        match Refusal::split(scheme::candidates(question, shop))? {
            Ok(schemes) => found.extend(schemes),
            Err(why) => failed = Some(why),
        }
    }
    match Refusal::split(search::candidates(bore, sizes, cost, shop))? {
        Ok(routes) => found.extend(routes),
        Err(why) => failed = failed.or(Some(why)),
    }
    found.retain(|candidate| !bore.flat || cuts_shoulder(&candidate.transitions));
    if let Some(thread) = &bore.thread {
        for candidate in &mut found {
            candidate.transitions.push(Operation::Tap);
            candidate.because.push(Because::table(
                shop.knowledge.table("A.10")?,
                Note::new("thread-of-step").with("thread", &thread.written),
            ));
        }
    }
    if found.is_empty() {
        let why = failed.unwrap_or_else(|| Note::new("no-flat-opening").with("diameter", bore.diameter.nominal));
        return Err(Refusal::Not(why));
    }
    Ok(found)
}

/// Whether transitions leave a flat shoulder: what comes first is cut flat over its whole width, by a
/// counterbore or a mill where a drill went before, else also by boring.
fn cuts_shoulder(transitions: &[Operation]) -> bool {
    match transitions {
        [Operation::DrillOut | Operation::Drill, next, ..] => {
            matches!(next, Operation::Mill | Operation::Counterbore)
        }
        [first, ..] => leaves_flat(*first),
        [] => false,
    }
}

/// The step that cuts an edge: a chamfer, a countersink, a cone or a face. `around` is the diameter of the
/// cylinder when it is cut.
///
/// # Errors
/// The knowledge lacks a convention.
pub fn edge(edge: &Edge, around: Micrometres, shop: &Shop<'_>) -> Tried<Step> {
    let stock = shop.convention("face-stock-mm")?;
    let depth = Edge { around, ..*edge }.depth(stock);
    let place = Place {
        feature: edge.feature,
        step: None,
        face: edge.face,
        start: edge.start,
        depth: edge.start + depth,
        through: false,
    };
    let operation = match edge.feature {
        Feature::Face => Operation::Counterbore,
        Feature::Chamfer => Operation::Chamfer,
        _ => Operation::Countersink,
    };
    let mut step = Step::plain(operation, place, edge.diameter, around);
    if edge.feature != Feature::Face {
        step.angle_millideg = Some(edge.angle_millideg);
    }
    step.because.push(Because::table(
        shop.knowledge.table("transition-order")?,
        Note::new("edge").with("diameter", edge.diameter).with("depth", depth),
    ));
    Ok(step)
}
