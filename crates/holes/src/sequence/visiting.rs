//! Parallel or sequential: each tool round all holes, or each hole with all tools (textbook 1.3.1).

use crate::error::KnowledgeError;
use crate::machine::Machine;
use crate::note::{Because, Figure, Finding, Note, Severity};
use crate::part::{Hole, Part, Point};
use crate::plan::{HolePlan, Mixture, Operation, Visiting, VisitingMethod};
use crate::shop::Shop;
use crate::tables::rules::MethodOfVisitingFor;
use crate::units::{Minutes, round_to};

use super::metric::{self, Metric};
use super::tool_change_point;
use super::tour::{self, Space};

/// Time of the parallel method, `Tпар = m(τ+θ)`: each of `m` tools is changed once, τ, and visits all holes once, θ
/// (textbook 1.3.1).
pub fn parallel(tools: usize, change: Minutes, round: Minutes) -> Minutes {
    Minutes(tools as f64 * (change.0 + round.0))
}

/// Time of the sequential method, `Tпосл = nmτ+θ`: each of `m` tools is changed at each of `n` holes, and the holes
/// are visited once (textbook 1.3.1). It holds for a machine that changes tools at any position.
pub fn sequential(holes: usize, tools: usize, change: Minutes, round: Minutes) -> Minutes {
    Minutes(holes as f64 * tools as f64 * change.0 + round.0)
}

/// The ratio of the two, `K_T = Tпар/Tпосл = m(1+K)/(nm+K)` with `K = θ/τ` (textbook 1.3.1): above 1 the
/// sequential method is quicker, below 1 the parallel one.
pub fn ratio(holes: usize, tools: usize, change: Minutes, round: Minutes) -> f64 {
    let (n, m, k) = (holes as f64, tools as f64, round.0 / change.0);
    m * (1.0 + k) / (n * m + k)
}

/// The quickest mixture of both methods: the first tools in parallel, the last ones at each hole in turn. Returns
/// their number and the time, or none where two tools leave nothing to mix. `round` is the time of one tool in
/// parallel, `changed` that of one tool changed at every hole, each with its tool changes and the travel to them.
///
/// One tool «at each hole in turn» visits the holes as in parallel, so at least two tools are. It makes no difference
/// which tools: all visit the same holes.
pub fn mixture(tools: usize, round: Minutes, changed: Minutes) -> Option<(usize, Minutes)> {
    let time = |last: usize| (tools - last) as f64 * round.0 + last as f64 * changed.0;
    (2..tools).map(|last| (last, Minutes(time(last)))).min_by(|one, other| one.1.0.total_cmp(&other.1.0))
}

/// The method that the book's rule gives each group with more than one tool, with the times of both methods; and a
/// finding where this machine cannot follow the rule.
///
/// The true times of the machine include the travel of the table to the change position, which every change needs. In
/// the parallel method the round includes it; in the sequential method it is added from and to each hole for each
/// tool, in place of the round. A round is never longer than separate travels to each of its holes and back, so on
/// such a machine neither the sequential method nor a mixture saves time.
///
/// # Errors
/// The knowledge base lacks the rule.
pub fn visiting(
    part: &Part,
    holes: &[HolePlan],
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Visiting>, KnowledgeError> {
    let mut all = Vec::new();
    for (plan, hole) in holes.iter().zip(&part.holes) {
        let Some(visiting) = of_group(part, plan, hole, shop)? else { continue };
        findings.extend(not_kept(&visiting, &shop.machine));
        all.push(visiting);
    }
    Ok(all)
}

/// A finding that the machine cannot visit a group as the rule says; none if it can.
pub fn not_kept(visiting: &Visiting, machine: &Machine<'_>) -> Option<Finding> {
    if visiting.method == VisitingMethod::Parallel || visiting.finishing_tools < 2 || visiting.holes < 2 {
        return None;
    }
    let code = match visiting.method {
        VisitingMethod::Sequential => "visited-in-parallel",
        _ => "position-lost-at-tool-change",
    };
    let note = Note::new(code)
        .with("tools", visiting.finishing_tools)
        .with("x", machine.tool_change_at.0)
        .with("y", machine.tool_change_at.1)
        .with("parallel", visiting.finish_parallel_min.rounded(2).0)
        .with("sequential", visiting.finish_sequential_min.rounded(2).0);
    Some(Finding::of_hole(Severity::Note, &visiting.hole, note))
}

fn of_group(part: &Part, plan: &HolePlan, hole: &Hole, shop: &Shop<'_>) -> Result<Option<Visiting>, KnowledgeError> {
    let here = || plan.transitions.iter().filter(|step| !step.elsewhere);
    let count = |finishing: bool| {
        let mut tools: Vec<u32> =
            here().filter(|step| !finishing || is_finishing(step.operation)).map(|step| step.tool.number).collect();
        tools.sort_unstable();
        tools.dedup();
        tools.len()
    };
    let (tools, finishing) = (count(false), count(true));
    let Some(route) = plan.route.as_ref().filter(|_| tools > 1) else { return Ok(None) };
    let machine = &shop.machine;
    let rapid = machine.rapids();
    let home = tool_change_point(part, machine);
    let points: Vec<Point> = std::iter::once(home).chain(hole.at.iter().copied()).collect();
    let metric = Metric::Rapid(rapid);
    let path = tour::quick_path(&Space::closed(&points, metric));
    let round = metric.minutes(path.cost).unwrap_or_default();
    // The round of the book does not include the change position: the tool is changed wherever the table stands.
    let change = machine.tool_change;
    let k_t = ratio(hole.at.len(), tools, change, round);
    let each: f64 = hole.at.iter().map(|&at| change.0 + 2.0 * metric::between(rapid, home, at).0).sum();
    let grade = hole.diameter.it;
    let question = MethodOfVisitingFor { it: grade, centre_tolerance: route.centre_tolerance_mm, k_t };
    let answer = shop.knowledge.ask(&question)?;
    let method = answer.need("this group")?.method;
    let note = Note::new("visiting-method")
        .with("method", Figure::word(method.name()))
        .with("it", grade)
        .with("centre", route.centre_tolerance_mm)
        .with("ratio", round_to(k_t, 3));
    // With one finishing tool, «one after the other at each hole» is the same as its own round.
    let concerned = if method == VisitingMethod::Sequential { tools } else { finishing };
    Ok(Some(Visiting {
        hole: plan.name.clone(),
        method,
        holes: hole.at.len(),
        tools,
        finishing_tools: concerned,
        round_min: round.rounded(3),
        ratio: round_to(k_t, 3),
        book_parallel_min: parallel(tools, change, round).rounded(2),
        book_sequential_min: sequential(hole.at.len(), tools, change, round).rounded(2),
        sequential_min: Minutes(tools as f64 * each).rounded(2),
        mixture: mixture(tools, Minutes(change.0 + round.0), Minutes(each))
            .map(|(sequential_tools, time)| Mixture { sequential_tools, time_min: time.rounded(2) }),
        finish_parallel_min: parallel(concerned, change, round).rounded(2),
        finish_sequential_min: Minutes(concerned as f64 * each).rounded(2),
        because: vec![Because::answer(&answer.answer, note)],
    }))
}

/// Whether a transition is a finishing one, for which the rule would not move the part: none of the first ones that
/// the text lists (centring, drilling, countersinking, core drilling).
const fn is_finishing(operation: Operation) -> bool {
    operation.is_boring() || operation.is_reaming() || matches!(operation, Operation::Tap | Operation::Mill)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ratio_is_that_of_the_two_times() {
        for (holes, tools, change, round) in [(1, 2, 0.5, 0.1), (10, 3, 20.0 / 60.0, 0.4), (4, 5, 0.01, 9.0)] {
            let (change, round) = (Minutes(change), Minutes(round));
            let by_times = parallel(tools, change, round).0 / sequential(holes, tools, change, round).0;
            assert!((ratio(holes, tools, change, round) - by_times).abs() < 1e-12);
        }
    }

    #[test]
    fn one_hole_is_visited_sequentially_and_many_in_parallel() {
        let (change, round) = (Minutes(20.0 / 60.0), Minutes(0.06));
        assert!(ratio(1, 3, change, round) > 1.0);
        assert!(ratio(10, 3, change, round) < 1.0);
    }

    #[test]
    fn the_quickest_mixture_is_that_of_a_count_by_hand() {
        // Two holes 0.1 and 0.2 min from the change position, 0.15 min apart; a change takes 0.5 min.
        // In parallel one tool takes 0.5 + (0.1 + 0.15 + 0.2) = 0.95, at each hole (0.5 + 0.2) + (0.5 + 0.4) = 1.6.
        let (round, changed) = (Minutes(0.95), Minutes(1.6));
        assert_eq!(mixture(2, round, changed), None, "two tools are visited in one way or the other");
        let (tools, time) = mixture(3, round, changed).unwrap();
        assert_eq!((tools, time.rounded(3)), (2, Minutes(4.15)), "0.95 + 2 · 1.6");
        let (tools, time) = mixture(5, round, changed).unwrap();
        assert_eq!((tools, time.rounded(3)), (2, Minutes(6.05)), "3 · 0.95 + 2 · 1.6");
        // If a change at a hole were cheap, as many tools as possible would change there: 0.95 + 4 · 0.3.
        let (tools, time) = mixture(5, round, Minutes(0.3)).unwrap();
        assert_eq!((tools, time.rounded(3)), (4, Minutes(2.15)));
    }
}
