//! Shafts for tests and benches.

use petgraph::algo::dijkstra;
use petgraph::graph::DiGraph;
use proptest::prelude::*;
use technolog::note::Note;
use technolog::tables::turning::part::StockKind;
use technolog::turning::length::Half;
use technolog::turning::passes::cost::Objective;
use technolog::turning::passes::grid::Grid;
use technolog::turning::passes::optimum::moves;
use technolog::turning::passes::pass::{Pass, PassDirection};
use technolog::turning::point::Point;
use technolog::turning::shaft::{Blank, Division, Moves, Rates, Roughing, Shaft, Step};
use technolog::turning::workpiece::{Workpiece, read_turned};
use technolog::units::{Micrometres, MillimetresPerMinute};

use crate::KNOWLEDGE;

/// A shaft by micrometres: the bar, the steps as diameter and length, the depths.
pub fn shaft(bar: i64, steps: &[(i64, i64)], longitudinal: i64, transverse: i64, division: Division) -> Shaft {
    let length = steps.iter().map(|(_, length)| length).sum();
    Shaft {
        blank: Blank { kind: StockKind::Bar, diameter: Micrometres::new(bar), length: Micrometres::new(length) },
        blank_steps: Vec::new(),
        steps: steps
            .iter()
            .map(|&(diameter, length)| Step { diameter: Micrometres::new(diameter), length: Micrometres::new(length) })
            .collect(),
        roughing: Roughing {
            longitudinal_depth: Micrometres::new(longitudinal),
            transverse_depth: Micrometres::new(transverse),
            division,
            moves: Moves::Basic,
        },
        rates: None,
    }
}

/// Its workpiece: what the reader makes of its file.
pub fn workpiece(shaft: &Shaft) -> Workpiece {
    let steps = |steps: &[Step]| {
        let all = steps.iter().map(|step| format!("{{diameter: {}, length: {}}}", step.diameter, step.length));
        all.collect::<Vec<_>>().join(", ")
    };
    let Blank { kind, diameter, length } = shaft.blank;
    let of_blank =
        if shaft.blank_steps.is_empty() { String::new() } else { format!(", steps: [{}]", steps(&shaft.blank_steps)) };
    let Roughing { longitudinal_depth, transverse_depth, division, .. } = shaft.roughing;
    let text = format!(
        "shaft: shaft\nmaterial: steel-45\nblank: {{kind: {}, diameter: {diameter}, length: {length}{of_blank}}}\nsteps: [{}]\n\
         roughing: {{longitudinal_depth: {longitudinal_depth}, transverse_depth: {transverse_depth}, division: {}}}\n",
        kind.name(),
        steps(&shaft.steps),
        division.name()
    );
    read_turned("shaft", &text, &KNOWLEDGE).unwrap_or_else(|mistakes| panic!("{text}{mistakes:?}"))
}

/// Any shaft whose levels and slices together are at most so many.
pub fn shafts(most: usize) -> impl Strategy<Value = Shaft> {
    let step = (0_i64..25_000, 1_i64..20_000);
    let steps = prop::collection::vec(step, 1..5);
    (steps, 1_i64..30_000, 1_000_i64..6_000, 1_000_i64..6_000, any::<bool>(), any::<bool>())
        .prop_map(|(steps, first, longitudinal, transverse, equal, whole)| {
            // Diameters grow towards the chuck; whole millimetres meet depths exactly now and then.
            let unit = if whole { 1_000 } else { 1 };
            let round = |value: i64| (value / unit + 1) * unit;
            let mut diameter = round(first);
            let mut all = Vec::new();
            for (rise, length) in steps {
                all.push((diameter, round(length)));
                diameter += round(rise) - unit;
            }
            let division = if equal { Division::Equal } else { Division::Full };
            shaft(diameter + round(first), &all, round(longitudinal), round(transverse), division)
        })
        .prop_filter("few levels and slices", move |shaft| {
            let grid = Grid::of(shaft);
            grid.levels.len() + grid.slices.len() <= most
        })
}

/// Rates that differ from one another, so that times tell which was taken.
pub fn rates() -> Rates {
    Rates {
        longitudinal_feed: MillimetresPerMinute(100.0),
        transverse_feed: MillimetresPerMinute(80.0),
        rapid: MillimetresPerMinute(5000.0),
        approach: Micrometres::from_mm(2),
        retract: Micrometres::new(500),
    }
}

/// The shortest way by petgraph, the making of its graph counted in: a node for each state. Only for objectives that do not
/// ask where the pass before ended.
pub fn by_petgraph(grid: &Grid, per_pass: u64) -> u64 {
    let width = grid.slices.len() + 1;
    let mut graph = DiGraph::<(), u64>::new();
    let nodes: Vec<_> = (0..(grid.levels.len() + 1) * width).map(|_| graph.add_node(())).collect();
    let end = graph.add_node(());
    for levels in 0..=grid.levels.len() {
        for slices in 0..width {
            let here = nodes[levels * width + slices];
            let Some([longitudinal, transverse]) = moves(grid, levels, slices) else {
                graph.add_edge(here, end, 0);
                continue;
            };
            let cost = |length: Half| length.halves().unsigned_abs() + per_pass;
            graph.add_edge(here, nodes[(levels + 1) * width + slices], cost(longitudinal.length));
            graph.add_edge(here, nodes[levels * width + slices + 1], cost(transverse.length));
        }
    }
    dijkstra(&graph, nodes[0], Some(end), |edge| *edge.weight())[&end]
}

/// Every objective.
pub fn objectives(per_pass: Half, rates: Rates) -> [Objective; 4] {
    [Objective::Path, Objective::PathAndPasses { per_pass_mm: per_pass }, Objective::Time { rates }, Objective::Passes]
}

/// All combinations of one direction per step, each as its passes: written down again from the definition.
pub fn combinations(grid: &Grid) -> Vec<Vec<Pass>> {
    let count = grid.cylinders.len();
    (0..1_usize << count)
        .map(|choice| {
            let mut passes = Vec::new();
            for (index, cylinder) in grid.cylinders.iter().enumerate() {
                let mut add = |kind, from, to, depth| {
                    passes.push(Pass { kind, from, to, depth, removed: Vec::new(), reason: Note::new("test") });
                };
                if choice >> index & 1 == 0 {
                    let mut outer = grid.bar;
                    for level in grid.levels.iter().take_while(|level| level.from > cylinder.radius) {
                        let at = |z| Point { radius: level.to, z };
                        add(PassDirection::Longitudinal, at(cylinder.from), at(cylinder.to), outer - level.to);
                        outer = level.to;
                    }
                } else {
                    for slice in grid.slices.iter().filter(|slice| cylinder.from < slice.to && slice.to <= cylinder.to)
                    {
                        let at = |radius| Point { radius, z: slice.to };
                        add(PassDirection::Transverse, at(grid.bar), at(cylinder.radius), slice.to - slice.from);
                    }
                }
            }
            passes
        })
        .collect()
}
