//! The order of the transitions of a whole hole: section 1.1.2, rule `transition-order`.

use crate::error::KnowledgeError;
use crate::plan::Feature;
use crate::shop::Shop;
use crate::tables::rules::TransitionOrderFor;

use super::RouteStep;

/// Puts the steps of a hole in order: the entry face first, then the back face; on each by the rank of the
/// rule; within a rank the narrower cylinder first, as they are given.
///
/// # Errors
/// The knowledge base has no answer.
pub fn sort(steps: &mut Vec<RouteStep>, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    let mut ranked = Vec::with_capacity(steps.len());
    // Within one cylinder its chain is already in order, and a later rank must not be overtaken by an earlier
    // one of the same chain: rough boring after core drilling stays after it.
    let mut least: Vec<(Feature, Option<usize>, i64)> = Vec::new();
    for step in steps.drain(..) {
        let face = step.place.feature == Feature::Face;
        let question = TransitionOrderFor { operation: step.operation, face };
        let mut rank = shop.knowledge.ask(&question)?.need(step.operation.name())?.rank;
        // A thread is cut into its own cylinder.
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
