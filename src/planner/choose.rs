//! Which route every group takes, all groups together: the stated order of routes.
//!
//! A route that holds grade, roughness and position goes before one that does not; then the total time
//! decides, with the tool changes it adds to those of the other groups; then the places of the magazine it
//! adds; then its cost, where the machine's record has a rate; then the way (tables, complexes, search) and
//! the names, so that the order is total and no file's order matters.

use std::collections::{BTreeMap, BTreeSet};

use crate::note::Note;
use crate::part::Part;
use crate::plan::{Alternative, Operation, Way};
use crate::shop::Shop;
use crate::units::{Micrometres, Minutes, round_to};

use super::fit::Fitted;
use super::options::{Choice, Options};

/// The most rounds of reconsidering; it ends by itself long before.
const ROUNDS: usize = 6;

/// A tool as the magazine counts it; the centring drill is one for all holes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum ToolKey {
    CentreDrill,
    Cutter { designation: String, table: String, size: Micrometres, holder: String },
}

/// By what routes are ranked, best first.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Rank {
    misses: bool,
    /// Places count before time while the magazine overflows.
    crowding: usize,
    /// Millionths of a minute.
    time: i64,
    new_tools: usize,
    /// Millionths of the machine's currency.
    cost: i64,
    way: Way,
    table: String,
    scheme: String,
    operations: Vec<(Operation, Micrometres)>,
}

/// The groups' options with what is chosen of each.
pub(super) struct Chooser<'a, 'k> {
    pub options: Vec<Option<Options>>,
    /// The index of the chosen route of each group.
    pub chosen: Vec<Option<usize>>,
    keys: Vec<Vec<BTreeSet<ToolKey>>>,
    used: BTreeMap<ToolKey, usize>,
    shop: &'a Shop<'k>,
    change: f64,
    crowded: bool,
}

impl<'a, 'k> Chooser<'a, 'k> {
    pub fn new(part: &Part, shop: &'a Shop<'k>) -> Self {
        let groups = part.holes.len();
        // A tool change takes the table to the change position and back (textbook 5.2 item 11.1).
        let middle = part.middle();
        let away = crate::sequence::tool_change_point(part, &shop.machine).distance(middle);
        let change = shop.machine.tool_change.0 + 2.0 * away.to_mm() / shop.machine.rapid.0;
        Self {
            options: (0..groups).map(|_| None).collect(),
            chosen: vec![None; groups],
            keys: vec![Vec::new(); groups],
            used: BTreeMap::new(),
            shop,
            change,
            crowded: false,
        }
    }

    /// Takes on a group: the best of its routes beside the tools chosen so far.
    pub fn add(&mut self, group: usize, options: Options) {
        self.keys[group] = options.choices.iter().map(|choice| tool_keys(&choice.steps)).collect();
        self.options[group] = Some(options);
        if let Some(best) = self.best(group) {
            self.take(group, Some(best));
        }
    }

    /// The drills that the chosen routes have in the magazine.
    pub fn drills(&self) -> Vec<Micrometres> {
        let mut drills: Vec<Micrometres> = self
            .taken()
            .flat_map(|choice| &choice.steps)
            .filter(|fitted| fitted.step.operation == Operation::Drill && fitted.step.also.is_none())
            .map(|fitted| fitted.step.diameter)
            .collect();
        drills.sort_unstable();
        drills.dedup();
        drills
    }

    fn taken(&self) -> impl Iterator<Item = &Choice> {
        self.options.iter().zip(&self.chosen).filter_map(|(options, chosen)| options.as_ref()?.choices.get((*chosen)?))
    }

    /// Reconsiders every group beside all the others until nothing gets better; then, if the magazine does not
    /// suffice, once more with its places before the time.
    pub fn settle(&mut self, order: &[usize]) {
        self.rounds(order);
        if self.used.len() > self.shop.machine.magazine {
            let (before, tools) = (self.chosen.clone(), self.used.len());
            self.crowded = true;
            self.rounds(order);
            self.crowded = false;
            if self.used.len() >= tools || self.used.len() > self.shop.machine.magazine {
                // Fewer tools alone are worth no slower routes: it must fit.
                for (group, choice) in before.into_iter().enumerate() {
                    self.take(group, choice);
                }
            }
        }
    }

    fn rounds(&mut self, order: &[usize]) {
        for _ in 0..ROUNDS {
            let mut changed = false;
            for &group in order {
                let before = self.chosen[group];
                self.take(group, None);
                let best = self.best(group);
                self.take(group, best);
                if best != before {
                    if self.lends_still() {
                        changed = true;
                    } else {
                        self.take(group, before);
                    }
                }
            }
            if !changed {
                break;
            }
        }
    }

    /// Whether every drill that a route borrows from another group is still there.
    fn lends_still(&self) -> bool {
        let drills = self.drills_of_others();
        drills.into_iter().all(|found| found)
    }

    fn drills_of_others(&self) -> Vec<bool> {
        let mut met = Vec::new();
        for (group, options) in self.options.iter().enumerate() {
            let Some(choice) = options.as_ref().and_then(|options| options.choices.get(self.chosen[group]?)) else {
                continue;
            };
            let Some(borrowed) = choice.borrowed else { continue };
            let others = self.options.iter().enumerate().filter(|(other, _)| *other != group);
            let lent = others
                .filter_map(|(other, options)| options.as_ref()?.choices.get(self.chosen[other]?))
                .flat_map(|choice| &choice.steps)
                .any(|fitted| fitted.step.operation == Operation::Drill && fitted.step.diameter == borrowed);
            met.push(lent);
        }
        met
    }

    fn take(&mut self, group: usize, choice: Option<usize>) {
        if let Some(old) = self.chosen[group].take() {
            for key in &self.keys[group][old] {
                if let Some(count) = self.used.get_mut(key) {
                    *count -= 1;
                    if *count == 0 {
                        self.used.remove(key);
                    }
                }
            }
        }
        if let Some(new) = choice {
            for key in &self.keys[group][new] {
                *self.used.entry(key.clone()).or_insert(0) += 1;
            }
        }
        self.chosen[group] = choice;
    }

    fn best(&self, group: usize) -> Option<usize> {
        let options = self.options[group].as_ref()?;
        (0..options.choices.len()).min_by_key(|index| self.rank(group, *index, &options.choices[*index]))
    }

    fn new_tools(&self, group: usize, index: usize) -> usize {
        self.keys[group][index].iter().filter(|key| !self.used.contains_key(*key)).count()
    }

    /// Time of the group with the tool changes that its new tools add.
    fn total(&self, group: usize, index: usize, choice: &Choice) -> Minutes {
        Minutes(choice.own.0 + self.change * self.new_tools(group, index) as f64)
    }

    fn rank(&self, group: usize, index: usize, choice: &Choice) -> Rank {
        let new_tools = self.new_tools(group, index);
        let total = self.total(group, index, choice).0;
        let rate = self.shop.machine.minute_rate.unwrap_or_default();
        Rank {
            misses: !choice.meets(),
            crowding: if self.crowded { new_tools } else { 0 },
            time: (total * 1e6) as i64,
            new_tools,
            cost: (total * rate * 1e6) as i64,
            way: choice.candidate.way,
            table: choice.candidate.table.clone(),
            scheme: choice.candidate.scheme.clone(),
            operations: Options::operations(choice),
        }
    }

    /// The group's time and the routes it was weighed against, best first, with why each lost.
    pub fn weighed(&mut self, group: usize) -> Option<Weighed> {
        let chosen = self.chosen[group]?;
        // Beside the tools of the others.
        self.take(group, None);
        let weighed = self.weigh(group, chosen);
        self.take(group, Some(chosen));
        weighed
    }

    fn weigh(&self, group: usize, chosen: usize) -> Option<Weighed> {
        let options = self.options[group].as_ref()?;
        let winner = &options.choices[chosen];
        let time = self.total(group, chosen, winner);
        let mut others: Vec<usize> = (0..options.choices.len()).filter(|index| *index != chosen).collect();
        others.sort_by_key(|index| self.rank(group, *index, &options.choices[*index]));
        let mut alternatives: Vec<Alternative> = Vec::new();
        for index in others {
            let other = &options.choices[index];
            let total = self.total(group, index, other);
            let more = total.0 - time.0;
            let why = match (winner.meets(), other.meets()) {
                (true, false) => other.misses.first().cloned().unwrap_or_else(|| Note::new("misses-unknown")),
                _ if more > 5e-4 => Note::new("lost-by-time").with("slower", format!("{more:.3}")),
                _ if more < -5e-4 => Note::new("lost-by-places").with("quicker", format!("{:.3}", -more)),
                _ => Note::new("lost-by-order"),
            };
            alternatives.push(Alternative {
                way: other.candidate.way,
                table: other.candidate.table.clone(),
                scheme: other.candidate.scheme.clone(),
                operations: Options::operations(other),
                time_min: Some(total.rounded(3)),
                new_tools: Some(self.new_tools(group, index)),
                meets: other.meets(),
                why,
            });
        }
        let margin = alternatives
            .first()
            .and_then(|runner_up| runner_up.time_min)
            .map(|runner_up| Minutes(runner_up.0 - time.0).rounded(3));
        alternatives.extend(options.refused.iter().cloned());
        let cost = self.shop.machine.minute_rate.map(|rate| round_to(time.0 * rate, 2));
        Some(Weighed { time: time.rounded(3), cost, margin, alternatives })
    }
}

/// What a group's route was weighed against.
pub(super) struct Weighed {
    pub time: Minutes,
    /// In the currency of the machine's record.
    pub cost: Option<f64>,
    pub margin: Option<Minutes>,
    pub alternatives: Vec<Alternative>,
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
