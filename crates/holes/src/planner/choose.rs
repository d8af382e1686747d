//! Chooses the routes of all groups together, in the documented order of routes.
//!
//! A route that reaches grade, roughness and position is preferred to one that does not, and one that reaches them
//! ordinarily to one that reaches them only at best, and one that a bar or a mill finishes down to a flat floor to one whose
//! reamer ends higher. Then these decide, in turn: the total time, with the tool changes that the route adds and the loading by hand
//! of what the magazine has no place for; the magazine places it adds; the source of the route (tables, complexes, search) and the
//! names. So the order is total and does not depend on the order of the file. Cost is time multiplied by the
//! machine's rate, so it never decides alone.
//!
//! First each group takes its best route beside the chosen routes of the others, until no single change helps. Then,
//! for each tool, every group that can use it takes it, or every group that uses it gives it up; a change that
//! improves the whole part is kept.

mod compared;

pub(super) use compared::ComparedRoutes;

use std::collections::{BTreeMap, BTreeSet};

use crate::error::KnowledgeError;
use crate::job::Hands;
use crate::note::Figure;
use crate::part::Part;
use crate::plan::{Operation, Preference, RouteSource};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::units::{Micrometres, Minutes};

use super::fit::Fitted;
use super::options::{Choice, Options};

/// The most rounds of improvement. Each round must improve the whole part, so the loop ends in any case.
const ROUNDS: usize = 8;

/// A tool as the magazine counts it; all holes share one centring drill.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum ToolKey {
    CentreDrill,
    Cutter { designation: String, table: String, size: Micrometres, holder: String },
}

/// Times that differ by less than this are printed as equal, min.
const SAME: f64 = 5e-4;

/// The ranking of the routes of a group, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Rank {
    /// The route is not from the tables, although the tables are preferred and have one.
    other_way: bool,
    misses: bool,
    /// The number of requirements that the route reaches only at best.
    at_best: usize,
    /// It leaves more unfinished over a flat floor than bars do: reamers end higher, by their lead.
    over_floor: bool,
    /// Time, millionths of a minute.
    time: i64,
    new_tools: usize,
    /// Rank by source, table, scheme and transitions.
    name: usize,
}

/// The score of the whole part, compared in this order: groups that do not take the tables although the tables are
/// preferred; groups without a route or with a route that misses a requirement; requirements reached only at best;
/// time.
type Total = (usize, usize, usize, i64);

/// The options of all groups and the route chosen for each group.
pub(super) struct Chooser<'a, 'k> {
    pub options: Vec<Option<Options>>,
    /// The index of the chosen route of each group.
    pub chosen: Vec<Option<usize>>,
    /// The tools of each route, by number.
    tools: Vec<Vec<Vec<usize>>>,
    /// The rank of each route among the names of its group.
    names: Vec<Vec<usize>>,
    numbers: BTreeMap<ToolKey, usize>,
    /// How many chosen routes use each tool.
    used: Vec<usize>,
    shop: &'a Shop<'k>,
    change: f64,
    /// How far above a flat floor a bar stops.
    bar_gap: Micrometres,
    /// The time to put one tool beyond the magazine in by hand.
    load_tool: Minutes,
    preference: Preference,
}

impl<'a, 'k> Chooser<'a, 'k> {
    /// Nothing chosen yet.
    ///
    /// # Errors
    /// The conventions lack the gap over a flat floor.
    pub fn new(part: &Part, preference: Preference, shop: &'a Shop<'k>) -> Result<Self, KnowledgeError> {
        let bar_gap = shop.convention(HoleDefault::FlatFloorGap)?;
        let groups = part.holes.len();
        // A tool change takes the table to the change position and back (textbook 5.2 item 11.1).
        let middle = part.middle();
        let away = crate::sequence::tool_change_point(part, &shop.machine).distance(middle);
        let change = shop.machine.tool_change.0 + 2.0 * away.to_mm() / shop.machine.rapid.0;
        Ok(Self {
            options: (0..groups).map(|_| None).collect(),
            chosen: vec![None; groups],
            tools: vec![Vec::new(); groups],
            names: vec![Vec::new(); groups],
            numbers: BTreeMap::new(),
            used: Vec::new(),
            shop,
            change,
            bar_gap,
            load_tool: Hands::read(shop.knowledge)?.load_tool,
            preference,
        })
    }

    /// Adds a group with its best route for the tools chosen so far.
    pub fn add(&mut self, group: usize, options: Options) {
        for choice in &options.choices {
            let mut own = Vec::new();
            for key in tool_keys(&choice.steps) {
                let next = self.numbers.len();
                own.push(*self.numbers.entry(key).or_insert(next));
            }
            self.tools[group].push(own);
        }
        self.used.resize(self.numbers.len(), 0);
        self.names[group] = by_name(&options.choices);
        self.options[group] = Some(options);
        let best = self.ranked(group).first().copied();
        self.take(group, best);
    }

    /// The drills that the chosen routes have in the magazine.
    pub fn drills(&self) -> Vec<Micrometres> {
        let mut drills: Vec<Micrometres> =
            (0..self.chosen.len()).filter_map(|group| self.choice(group)).flat_map(drills_of).collect();
        drills.sort_unstable();
        drills.dedup();
        drills
    }

    /// The chosen route of a group.
    pub fn choice(&self, group: usize) -> Option<&Choice> {
        self.options[group].as_ref()?.choices.get(self.chosen[group]?)
    }

    /// Reconsiders every group, then every tool, until nothing improves.
    pub fn settle(&mut self, order: &[usize]) {
        for _ in 0..ROUNDS {
            let before = self.total();
            self.rounds(order);
            for tool in 0..self.used.len() {
                self.all_take(tool, order);
                self.all_drop(tool, order);
            }
            if self.total() >= before {
                break;
            }
        }
    }

    /// Every group that can use a tool takes its best route with it; kept when the whole part gets better.
    fn all_take(&mut self, tool: usize, order: &[usize]) {
        let users = |group: &usize| self.tools[*group].iter().any(|own| own.contains(&tool));
        if order.iter().filter(|group| users(group)).count() > 1 {
            self.try_all(order, |own| own.contains(&tool));
        }
    }

    /// Every group that uses a tool takes its best route without it; kept when the whole part gets better.
    fn all_drop(&mut self, tool: usize, order: &[usize]) {
        if self.used[tool] > 1 {
            self.try_all(order, |own| !own.contains(&tool));
        }
    }

    fn try_all(&mut self, order: &[usize], wanted: impl Fn(&[usize]) -> bool) {
        let (before, total) = (self.chosen.clone(), self.total());
        for &group in order {
            let old = self.chosen[group];
            self.take(group, None);
            let best = self.ranked(group).into_iter().find(|index| wanted(&self.tools[group][*index]));
            self.take(group, best.or(old));
        }
        self.rounds(order);
        if !self.all_fit() || self.total() >= total {
            self.restore(&before);
        }
    }

    /// Changes single groups: each takes its best route that does not remove a drill that another group borrows.
    fn rounds(&mut self, order: &[usize]) {
        for _ in 0..ROUNDS {
            let mut changed = false;
            for &group in order {
                let old = self.chosen[group];
                self.take(group, None);
                let ranked = self.ranked(group);
                let mut taken = None;
                for index in ranked {
                    self.take(group, Some(index));
                    if self.all_fit() {
                        taken = Some(index);
                        break;
                    }
                }
                if taken.is_none() {
                    self.take(group, old);
                }
                changed |= self.chosen[group] != old;
            }
            if !changed {
                break;
            }
        }
    }

    fn restore(&mut self, chosen: &[Option<usize>]) {
        for (group, choice) in chosen.iter().enumerate() {
            self.take(group, *choice);
        }
    }

    fn tools_used(&self) -> usize {
        self.used.iter().filter(|count| **count > 0).count()
    }

    fn total(&self) -> Total {
        let own: f64 =
            (0..self.chosen.len()).filter_map(|group| self.choice(group)).map(|choice| choice.own_time.0).sum();
        let missing = (0..self.chosen.len())
            .filter(|group| self.choice(*group).is_none_or(|it| !it.meets_requirements()))
            .count();
        let at_best = (0..self.chosen.len()).filter_map(|group| self.choice(group)).map(|it| it.at_best.len()).sum();
        let other = (0..self.chosen.len())
            .filter(|group| self.choice(*group).is_some_and(|choice| self.other_way(*group, choice)))
            .count();
        let used = self.tools_used();
        (other, missing, at_best, micro(own + self.change * used as f64 + self.loading(used).0))
    }

    /// Whether another group has the drill in the magazine.
    fn has_elsewhere(&self, drill: Micrometres, group: usize) -> bool {
        let others = (0..self.chosen.len()).filter(|other| *other != group).filter_map(|other| self.choice(other));
        others.flat_map(drills_of).any(|own| own == drill)
    }

    /// Whether a route agrees with the rule of two-pass drilling, given the routes of the other groups.
    fn fits(&self, group: usize, choice: &Choice) -> bool {
        choice.borrowed.is_none_or(|drill| self.has_elsewhere(drill, group))
            && choice.instead_of.is_none_or(|drill| !self.has_elsewhere(drill, group))
    }

    /// Whether every chosen route agrees with that rule.
    fn all_fit(&self) -> bool {
        (0..self.chosen.len()).all(|group| self.choice(group).is_none_or(|choice| self.fits(group, choice)))
    }

    fn take(&mut self, group: usize, choice: Option<usize>) {
        if let Some(old) = self.chosen[group].take() {
            for tool in &self.tools[group][old] {
                self.used[*tool] -= 1;
            }
        }
        if let Some(new) = choice {
            for tool in &self.tools[group][new] {
                self.used[*tool] += 1;
            }
        }
        self.chosen[group] = choice;
    }

    /// The routes of a group that agree with the routes of the others, best first.
    fn ranked(&self, group: usize) -> Vec<usize> {
        let Some(options) = &self.options[group] else { return Vec::new() };
        let mut fitting: Vec<usize> =
            (0..options.choices.len()).filter(|index| self.fits(group, &options.choices[*index])).collect();
        fitting.sort_by_key(|index| self.rank(group, *index, &options.choices[*index]));
        fitting
    }

    fn new_tools(&self, group: usize, index: usize) -> usize {
        self.tools[group][index].iter().filter(|tool| self.used[**tool] == 0).count()
    }

    /// Time of the group with the tool changes and the loading by hand that its new tools add.
    fn time(&self, group: usize, index: usize, choice: &Choice) -> Minutes {
        let (used, new) = (self.tools_used(), self.new_tools(group, index));
        let loading = self.loading(used + new).0 - self.loading(used).0;
        Minutes(choice.own_time.0 + self.change * new as f64 + loading)
    }

    /// The time to load by hand what so many tools have no place for in the magazine.
    fn loading(&self, tools: usize) -> Minutes {
        let beyond = tools.saturating_sub(self.shop.machine.magazine);
        Minutes(self.load_tool.0 * beyond as f64)
    }

    /// Whether the tables are preferred and have a route for the group, and this route is not from the tables.
    fn other_way(&self, group: usize, choice: &Choice) -> bool {
        let of_tables = |choice: &Choice| choice.candidate.source == RouteSource::Tables;
        let have = || self.options[group].as_ref().is_some_and(|options| options.choices.iter().any(of_tables));
        self.preference == Preference::Tables && !of_tables(choice) && have()
    }

    fn rank(&self, group: usize, index: usize, choice: &Choice) -> Rank {
        let new_tools = self.new_tools(group, index);
        Rank {
            other_way: self.other_way(group, choice),
            misses: !choice.meets_requirements(),
            at_best: choice.at_best.len(),
            over_floor: choice.stops_high(self.bar_gap),
            time: micro(self.time(group, index, choice).0),
            new_tools,
            name: self.names[group][index],
        }
    }
}

/// Time in whole millionths of a minute, so that times are compared exactly.
fn micro(minutes: f64) -> i64 {
    (minutes * 1e6) as i64
}

/// The rank of each route by source, table, scheme and transitions.
fn by_name(choices: &[Choice]) -> Vec<usize> {
    let key = |index: &usize| {
        let choice = &choices[*index];
        let candidate = &choice.candidate;
        (candidate.source, candidate.table.clone(), candidate.scheme.clone(), Options::operations(choice))
    };
    let mut order: Vec<usize> = (0..choices.len()).collect();
    order.sort_by_cached_key(key);
    let mut places = vec![0; choices.len()];
    for (place, index) in order.into_iter().enumerate() {
        places[index] = place;
    }
    places
}

/// The drills of a route that other groups may borrow from the magazine.
fn drills_of(choice: &Choice) -> impl Iterator<Item = Micrometres> + '_ {
    let plain = |fitted: &&Fitted| fitted.step.operation == Operation::Drill && fitted.step.also.is_none();
    choice.steps.iter().filter(plain).map(|fitted| fitted.step.diameter)
}

fn tool_keys(steps: &[Fitted]) -> BTreeSet<ToolKey> {
    steps
        .iter()
        .filter(|fitted| !fitted.step.elsewhere)
        .map(|fitted| match &fitted.tool {
            None => ToolKey::CentreDrill,
            Some(tool) => ToolKey::Cutter {
                designation: tool.designation.clone(),
                table: tool.table.clone(),
                size: tool.size,
                holder: tool.assembly.holder.clone(),
            },
        })
        .collect()
}

/// A difference of times as it is printed: rounded to half a second, but a small one is never printed as zero.
fn minutes(more: f64) -> Figure {
    Figure::fixed(more, if more < 0.05 { 3 } else { 2 })
}
