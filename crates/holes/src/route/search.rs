//! The third source of routes: a search over the states of a hole.
//!
//! A node is a state: the last tool and the diameter it left. An edge is a transition with its steps and its time.
//! The graph is built backwards from the finished cylinder, because the allowances of section 1.2.1 give the diameter
//! before each transition. The rows of the rule `next-transition` say which transition may follow which, and name the
//! rows of A.1, A.2 and section 1.2.1 with the accuracy that a chain reaches. Every simple path from the blank to the
//! finished cylinder is a route; routes are returned in order of time.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::rc::Rc;

use petgraph::Direction;
use petgraph::algo::all_simple_paths;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::EdgeRef;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Figure, Note};
use crate::plan::{Operation, RouteSource};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::tables::rules::{HoleState, NextTransition};
use crate::units::{Micrometres, Minutes};

use super::bores::{Before, Bore};
use super::diameters::{BackwardStep, Sizes};
use super::{Candidate, RouteStep, accuracy};

/// The most routes that are returned: the fastest by the times of their edges.
const MOST: usize = 8;
/// The most transitions of a route: centring, the five of the longest scheme of A.7, and one more.
const LONGEST: usize = 7;

/// A state of the cylinder.
#[derive(Clone, Debug)]
struct SearchState {
    /// The diameter there; zero in solid metal.
    diameter: Micrometres,
}

/// A transition between two states.
#[derive(Clone, Debug)]
struct Edge {
    operation: Operation,
    minutes: f64,
    /// The number of the rule's row.
    row: usize,
}

/// Time, transitions and rows of a path.
type Found = (f64, Vec<Operation>, Vec<usize>);

/// The cost of an edge: the time of its steps, or why they cannot be done.
pub type Cost<'a> = dyn Fn(&[RouteStep]) -> Tried<Minutes> + 'a;

/// The routes of the search, fastest first.
///
/// # Errors
/// The knowledge base has no answer, or no path leads to the finished cylinder; the refusal then names the failed
/// transition nearest to the end.
pub fn candidates(bore: &Bore, sizes: &Sizes<'_>, cost: &Cost<'_>, shop: &Shop<'_>) -> Tried<Vec<Candidate>> {
    let mut graph = Graph::new(bore, sizes, cost, shop)?;
    let goal = graph.goal()?;
    let Some(start) = graph.start else {
        return Err(Refusal::Not(most_informative(graph.failed, bore)));
    };
    let mut paths: Vec<Vec<NodeIndex>> = all_simple_paths::<Vec<_>, _, std::collections::hash_map::RandomState>(
        &graph.states,
        start,
        goal,
        0,
        Some(LONGEST),
    )
    .collect();
    // Parallel edges give the same nodes several times.
    paths.sort_unstable();
    paths.dedup();
    let mut routes: Vec<Found> = Vec::new();
    for path in paths {
        let mut open: Vec<Found> = vec![(0.0, Vec::new(), Vec::new())];
        for pair in path.windows(2) {
            let edges: Vec<&Edge> = graph.states.edges_connecting(pair[0], pair[1]).map(|edge| edge.weight()).collect();
            open = open
                .into_iter()
                .flat_map(|(minutes, operations, rows)| {
                    edges.iter().map(move |edge| {
                        let (mut operations, mut rows) = (operations.clone(), rows.clone());
                        operations.push(edge.operation);
                        rows.push(edge.row);
                        (minutes + edge.minutes, operations, rows)
                    })
                })
                .collect();
        }
        // Where the shoulder must be flat, other routes are removed before the quickest are chosen.
        let flat = bore.flat && bore.before == Before::Own;
        routes.extend(open.into_iter().filter(|(_, operations, _)| !flat || cuts_shoulder(operations)));
    }
    routes.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
    routes.dedup_by(|a, b| a.1 == b.1);
    // Over a flat floor the quickest that ends with a mill is kept, too: only a mill finishes the wall down to the floor.
    let milled = |(_, operations, _): &Found| operations.last() == Some(&Operation::Mill);
    let to_floor = if bore.flat { routes.iter().skip(MOST).find(|found| milled(found)).cloned() } else { None };
    routes.truncate(MOST);
    if !routes.iter().any(milled) {
        routes.extend(to_floor);
    }
    if routes.is_empty() {
        return Err(Refusal::Not(most_informative(graph.failed, bore)));
    }
    routes.into_iter().map(|(_, operations, rows)| candidate(operations, &rows, shop)).collect()
}

/// The reason nearest to the end of the route that concerns a tool or a stock, not the search itself.
fn most_informative(failed: Vec<Reason>, bore: &Bore) -> Reason {
    let own = |why: &Reason| {
        matches!(why, Reason::Unreachable { .. } | Reason::BoredByAnother { .. } | Reason::NoHoleToOpen { .. })
    };
    let no_path = || Reason::NoPath { it: bore.diameter.it, roughness: bore.roughness };
    failed.into_iter().find(|why| !own(why)).unwrap_or_else(no_path)
}

/// Whether transitions leave a flat shoulder: after a drill a counterbore or a mill cuts it flat over its full width;
/// without a drill boring does it too.
pub(super) fn cuts_shoulder(transitions: &[Operation]) -> bool {
    match transitions {
        [Operation::DrillOut | Operation::Drill, next, ..] => {
            matches!(next, Operation::Mill | Operation::Counterbore)
        }
        [first, ..] => leaves_flat(*first),
        [] => false,
    }
}

/// Whether a transition leaves a flat floor or shoulder.
pub const fn leaves_flat(operation: Operation) -> bool {
    operation.is_boring() || matches!(operation, Operation::Mill | Operation::Counterbore)
}

/// A route as a candidate, with the name of the scheme of A.7 that it equals, if any.
fn candidate(transitions: Vec<Operation>, rows: &[usize], shop: &Shop<'_>) -> Tried<Candidate> {
    let rule = shop.knowledge.table_of::<NextTransition<'_>>()?;
    let names: Vec<&str> = transitions.iter().map(|operation| operation.name()).collect();
    let known = shop.shelf.schemes()?.iter().find(|row| row.transitions == transitions);
    let (table, scheme) = match known {
        Some(row) => (row.row.table.id.clone(), row.scheme.to_owned()),
        None => (rule.id.clone(), names.join(" + ")),
    };
    let mut because = vec![Because::table(rule, Note::new("searched").with("transitions", Figure::operations(names)))];
    // Each transition belongs to its row.
    let steps = rows.iter().filter_map(|index| rule.row(*index)).zip(&transitions);
    because.extend(steps.map(|(row, operation)| {
        Because::row(row, Note::new("searched-step").with("operation", Figure::operation(operation.name())))
    }));
    Ok(Candidate {
        source: RouteSource::Search,
        table,
        scheme,
        transitions,
        finish_elsewhere: false,
        last_resort: false,
        promise: None,
        because,
    })
}

/// The graph while it is built.
struct Graph<'a, 'k> {
    states: DiGraph<SearchState, Edge>,
    known: BTreeMap<(HoleState, Micrometres), NodeIndex>,
    answers: BTreeMap<(HoleState, Micrometres), Vec<usize>>,
    start: Option<NodeIndex>,
    failed: Vec<Reason>,
    /// The rows of the rule `next-transition`.
    rule: Rc<[NextTransition<'k>]>,
    /// The states that a transition may follow, each with the transition that leaves it.
    states_before: Vec<(HoleState, Option<Operation>)>,
    centre: bool,
    bore: &'a Bore,
    sizes: &'a Sizes<'a>,
    cost: &'a Cost<'a>,
    shop: &'a Shop<'k>,
}

impl<'a, 'k> Graph<'a, 'k> {
    fn new(
        bore: &'a Bore,
        sizes: &'a Sizes<'a>,
        cost: &'a Cost<'a>,
        shop: &'a Shop<'k>,
    ) -> Result<Self, KnowledgeError> {
        let (centre, _) = super::scheme::centre_first(bore, shop)?;
        let rule: Rc<[NextTransition<'k>]> = shop.knowledge.rows()?.into();
        let leaves = |state| rule.iter().find(|row| row.leaves == state).map(|row| row.operation);
        let before = HoleState::NAMES.iter().filter(|(_, state)| *state != HoleState::Finished);
        let states_before = before.map(|&(_, state)| (state, leaves(state))).collect();
        Ok(Self {
            states: DiGraph::new(),
            known: BTreeMap::new(),
            answers: BTreeMap::new(),
            start: None,
            failed: Vec::new(),
            rule,
            states_before,
            centre,
            bore,
            sizes,
            cost,
            shop,
        })
    }

    /// The finished cylinder, with every transition that reaches grade and roughness leading to it.
    fn goal(&mut self) -> Tried<NodeIndex> {
        let target = self.shop.aimed(&self.bore.diameter)?;
        let goal = self.states.add_node(SearchState { diameter: target });
        let (asked_it, asked_roughness) = self.bore.required_finish(self.shop)?;
        for row in self.rule.clone().iter() {
            let Some(((grade, roughness), ..)) = accuracy::of_row(row, self.shop)? else { continue };
            if grade > asked_it || roughness > asked_roughness {
                continue;
            }
            self.enter(goal, row, true)?;
        }
        Ok(goal)
    }

    /// Adds the edges of a row that lead into a node, and what leads to their beginnings.
    fn enter(&mut self, node: NodeIndex, row: &NextTransition<'_>, last: bool) -> Tried<()> {
        let operation = row.operation;
        let after =
            if last { self.sizes.last_size(operation, self.bore, self.shop)? } else { self.states[node].diameter };
        for at in 0..self.states_before.len() {
            let (state, previous) = self.states_before[at];
            // Solid metal is drilled without centring only where the rule permits it.
            if state == HoleState::Solid && operation == Operation::Drill && self.centre {
                continue;
            }
            // A state that no transition leaves is a beginning; only the state of this cylinder is used.
            if previous.is_none() && state != accuracy::start(self.bore) {
                continue;
            }
            // A centring spot has no diameter of its own: the rule is queried with that of the cylinder.
            let diameter = if after > Micrometres::ZERO { after } else { self.bore.diameter.nominal };
            if !self.follows(state, diameter)?.contains(&row.row.index) {
                continue;
            }
            let question = BackwardStep {
                operation,
                leaves: after,
                previous,
                bore: self.bore,
                sizes: self.sizes,
                shop: self.shop,
            };
            let steps = if last && operation == Operation::Drill {
                question.last_drill(None).map(|step| vec![step])
            } else {
                question.steps()
            };
            let made = steps.and_then(|steps| {
                // A replaced transition belongs to the edge of its replacement.
                if steps.iter().any(|step| step.operation != operation) {
                    return Err(Refusal::Not(Reason::BoredByAnother { operation }));
                }
                let before = steps.first().map_or(after, |first| first.from);
                (self.cost)(&steps).map(|minutes| (before, minutes))
            });
            let (before, minutes) = match Refusal::split(made)? {
                Ok(made) => made,
                Err(why) => {
                    self.failed.push(why);
                    continue;
                }
            };
            let from = self.node(state, before)?;
            self.states.add_edge(from, node, Edge { operation, minutes: minutes.0, row: row.row.index });
        }
        Ok(())
    }

    /// The rows of the rule whose transitions may follow a state; kept, because every transition into a node asks for
    /// them.
    fn follows(&mut self, state: HoleState, diameter: Micrometres) -> Result<&[usize], KnowledgeError> {
        match self.answers.entry((state, diameter)) {
            Entry::Occupied(known) => Ok(known.into_mut()),
            Entry::Vacant(new) => {
                let answer = accuracy::next_transition(state, diameter, self.bore, self.shop)?.answer;
                Ok(new.insert(answer.winners().map(|winner| winner.index).collect()))
            }
        }
    }

    /// The node of a state, with everything that leads to it.
    fn node(&mut self, state: HoleState, diameter: Micrometres) -> Tried<NodeIndex> {
        let key = (state, diameter);
        if let Some(known) = self.known.get(&key) {
            return Ok(*known);
        }
        let node = self.states.add_node(SearchState { diameter });
        self.known.insert(key, node);
        if state == accuracy::start(self.bore) {
            self.start = Some(node);
            return Ok(node);
        }
        for row in self.rule.clone().iter().filter(|row| row.leaves == state) {
            self.enter(node, row, false)?;
        }
        let entered = self.states.edges_directed(node, Direction::Incoming).next().map(|edge| edge.id());
        if entered.is_none() {
            self.failed.push(Reason::Unreachable { state: state.name().to_owned(), diameter });
        }
        Ok(node)
    }
}
