//! Tries every order of passes, as the paper does: tests and benches compare the optimum with it.

use super::cost::{Cost, Objective};
use super::grid::Grid;
use super::optimum::moves;
use super::pass::PassEnd;

/// The cheapest of all orders, and how many orders there are. Their number grows like that of the paths through a grid:
/// 10 levels and 10 slices have 184,756.
pub fn enumerate(grid: &Grid, objective: Objective) -> (Option<Cost>, u64) {
    let mut search = Search { grid, objective, best: None, orders: 0 };
    search.from(0, 0, None, Cost::ZERO);
    (search.best, search.orders)
}

struct Search<'g> {
    grid: &'g Grid,
    objective: Objective,
    best: Option<Cost>,
    orders: u64,
}

impl Search<'_> {
    fn from(&mut self, levels: usize, slices: usize, before: Option<PassEnd>, spent: Cost) {
        let Some(moves) = moves(self.grid, levels, slices) else {
            self.orders += 1;
            let spent = spent.plus(self.objective.home(before, self.grid.bar));
            self.best = Some(self.best.map_or(spent, |best| best.min(spent)));
            return;
        };
        for (made, (levels, slices)) in moves.into_iter().zip([(levels + 1, slices), (levels, slices + 1)]) {
            let cost = self.objective.pass(made.start, made.length, before, self.grid.bar);
            let end = PassEnd { kind: made.start.kind, at: made.end };
            self.from(levels, slices, Some(end), spent.plus(cost));
        }
    }
}
