//! Why the other routes of a group lost.

use crate::error::KnowledgeError;
use crate::note::Note;
use crate::plan::Alternative;
use crate::tables::holes::HoleDefault;
use crate::units::{Minutes, round_to};

use super::super::options::{Choice, Options, RefusedRoute};
use super::{Chooser, SAME, drills_of, minutes};

impl Chooser<'_, '_> {
    /// The group's time, and the routes it was compared with, best first, each with the reason why it lost.
    ///
    /// # Errors
    /// The conventions lack the share of a near tie.
    pub fn comparison(&mut self, group: usize) -> Result<Option<ComparedRoutes>, KnowledgeError> {
        let near_tie = self.shop.share(HoleDefault::NearTieShare)?;
        let Some(chosen) = self.chosen[group] else { return Ok(None) };
        // The time beside the tools of the other groups.
        self.take(group, None);
        let compared = self.compare(group, chosen, near_tie);
        self.take(group, Some(chosen));
        Ok(compared)
    }

    fn compare(&self, group: usize, chosen: usize, near_tie: f64) -> Option<ComparedRoutes> {
        let options = self.options[group].as_ref()?;
        let winner = &options.choices[chosen];
        let time = self.time(group, chosen, winner);
        let mut alternatives: Vec<Alternative> = Vec::new();
        for index in self.ranked(group).into_iter().filter(|index| *index != chosen) {
            let other = &options.choices[index];
            let total = self.time(group, index, other);
            let more = total.0 - time.0;
            let why = match (winner.meets_requirements(), other.meets_requirements()) {
                _ if self.other_way(group, other) && more < -SAME => {
                    Note::new("lost-by-preference").with("quicker", minutes(-more))
                }
                (true, false) => other.misses.first().cloned().unwrap_or_else(|| Note::new("misses-unknown")),
                _ if other.at_best.len() > winner.at_best.len() => {
                    other.at_best.first().cloned().unwrap_or_else(|| Note::new("misses-unknown"))
                }
                _ if other.stops_high(self.bar_gap) && !winner.stops_high(self.bar_gap) => {
                    Note::new("lost-by-floor").with("left", other.over_floor()).with("instead", winner.over_floor())
                }
                _ if more > SAME && more <= near_tie * time.0 => Note::new("lost-by-little")
                    .with("slower", minutes(more))
                    .with("percent", round_to(near_tie * 100.0, 1)),
                _ if more > SAME => Note::new("lost-by-time").with("slower", minutes(more)),
                _ if more < -SAME => {
                    let code = if self.brings_drill(group, other) { "lost-by-two-passes" } else { "lost-by-borrowing" };
                    Note::new(code).with("quicker", minutes(-more))
                }
                _ => Note::new("lost-by-order"),
            };
            alternatives.push(Alternative {
                source: other.candidate.source,
                table: other.candidate.table.clone(),
                scheme: other.candidate.scheme.clone(),
                operations: Options::operations(other),
                time_min: Some(total.rounded(3)),
                new_tools: Some(self.new_tools(group, index)),
                meets: other.meets_requirements(),
                why,
            });
        }
        let margin = alternatives
            .first()
            .and_then(|runner_up| runner_up.time_min)
            .map(|runner_up| Minutes(runner_up.0 - time.0).rounded(3));
        alternatives.extend(options.refused.iter().map(RefusedRoute::to_alternative));
        let cost = self.shop.machine.minute_rate.map(|rate| round_to(time.0 * rate, 2));
        Some(ComparedRoutes { time: time.rounded(3), cost, margin, alternatives })
    }

    /// Whether a route brings a drill into the magazine with which another hole, drilled at once, must be drilled twice.
    fn brings_drill(&self, group: usize, route: &Choice) -> bool {
        let others = (0..self.chosen.len()).filter(|other| *other != group).filter_map(|other| self.choice(other));
        others.filter_map(|choice| choice.instead_of).any(|drill| drills_of(route).any(|own| own == drill))
    }
}

/// The routes that a group's route was compared with.
pub(in crate::planner) struct ComparedRoutes {
    pub time: Minutes,
    /// In the currency of the machine's record.
    pub cost: Option<f64>,
    pub margin: Option<Minutes>,
    pub alternatives: Vec<Alternative>,
}
