//! The order of the transitions of a whole hole: section 1.1.2, rule `transition-order`.

use crate::error::KnowledgeError;
use crate::plan::Feature;
use crate::shop::Shop;
use crate::tables::rules::TransitionOrderFor;

use super::RouteStep;

/// Sorts the steps of a hole: the entry face first, then the back face; on each face by the rank of the rule; within
/// a rank in the given order, the narrower cylinder first.
///
/// # Errors
/// The knowledge base has no answer.
pub fn sort(steps: &mut Vec<RouteStep>, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    let mut ranked = Vec::with_capacity(steps.len());
    // The chain of one cylinder is already in order, and a step must not move before an earlier step of its chain:
    // rough boring after core drilling stays after it.
    let mut least: Vec<(Feature, Option<usize>, i64)> = Vec::new();
    for step in steps.drain(..) {
        let face = step.place.feature == Feature::Face;
        let question = TransitionOrderFor { operation: step.operation, face };
        let mut rank = shop.knowledge.ask(&question)?.need(step.operation.name())?.rank;
        // A thread belongs to the cylinder it is cut in.
        let feature = match (step.place.feature, step.place.step) {
            (Feature::Thread, None) => Feature::Bore,
            (Feature::Thread, Some(_)) => Feature::Step,
            (feature, _) => feature,
        };
        let key = (feature, step.place.step);
        match least.iter_mut().find(|(feature, number, _)| (*feature, *number) == key) {
            Some((.., least)) => {
                rank = rank.max(*least);
                *least = rank;
            }
            None => least.push((key.0, key.1, rank)),
        }
        ranked.push(((step.place.face, rank), step));
    }
    ranked.sort_by_key(|(key, _)| *key);
    steps.extend(ranked.into_iter().map(|(_, step)| step));
    Ok(())
}
