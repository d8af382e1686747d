//! General advice in figures: long parts lengthwise, discs crosswise. The shaft is stretched along its axis, and the
//! variants are calculated for each ratio of length to diameter.

use serde::Serialize;

use crate::turning::shaft::Shaft;
use crate::units::{Micrometres, round_to};

use super::cost::Objective;
use super::grid::{Grid, MOST_STATES, states};
use super::named;
use super::optimum::CostToGo;
use super::pass::PassDirection;
use super::variants::total;

/// The variants at one ratio of length to diameter.
#[derive(Clone, Debug, Serialize)]
pub struct Ratio {
    /// Length of all steps over the diameter of the blank.
    pub length_to_diameter: f64,
    /// Length of all steps, mm.
    pub length_mm: Micrometres,
    /// The excess of each named variant over the optimum, per cent: longitudinal, transverse, per step.
    pub above_optimum_percent: [f64; 3],
    /// The best of the three; among equals the first.
    pub winner: &'static str,
    /// The excess of the worse of longitudinal and transverse over the better one, per cent.
    pub margin_percent: f64,
}

/// The ratios of the map: ten for each power of ten, from a disc of 0.1 to a shaft of 10.
const RATIOS: [f64; 21] =
    [0.1, 0.125, 0.16, 0.2, 0.25, 0.315, 0.4, 0.5, 0.63, 0.8, 1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0, 10.0];

/// The map of a shaft. A ratio with a grid that would be too fine is left out.
pub fn map(shaft: &Shaft, objective: Objective) -> Vec<Ratio> {
    RATIOS.iter().filter_map(|ratio| at(shaft, objective, *ratio)).collect()
}

fn at(shaft: &Shaft, objective: Objective, ratio: f64) -> Option<Ratio> {
    let whole: Micrometres = shaft.steps.iter().map(|step| step.length).sum();
    let factor = ratio * shaft.blank.diameter.to_mm() / whole.to_mm();
    let mut stretched = shaft.clone();
    for step in &mut stretched.steps {
        step.length = Micrometres::from_mm_rounded(step.length.to_mm() * factor).max(Micrometres::new(1));
    }
    if states(&stretched) > MOST_STATES {
        return None;
    }
    let grid = Grid::of(&stretched);
    let costs = named(&grid, objective).map(|(name, passes)| (name, total(&passes, objective, grid.bar).main));
    let model = CostToGo::of(&grid, objective).optimum().main;
    let best = costs.iter().map(|(_, cost)| *cost).fold(model, u64::min);
    if best == 0 {
        return None;
    }
    let above = |cost: u64, least: u64| round_to((cost as f64 / least as f64 - 1.0) * 100.0, 1);
    let [(_, along), (_, across), _] = costs;
    let winner = costs.iter().min_by_key(|(_, cost)| *cost).map_or("optimal", |(name, _)| *name);
    Some(Ratio {
        length_to_diameter: ratio,
        length_mm: stretched.steps.iter().map(|step| step.length).sum(),
        above_optimum_percent: costs.map(|(_, cost)| above(cost, best)),
        winner,
        margin_percent: above(along.max(across), along.min(across)),
    })
}

/// Whether longitudinal or transverse passes alone are better for the longest shafts of the map, and the ratio of
/// length to diameter from which on they are.
pub fn settled(map: &[Ratio]) -> Option<(PassDirection, f64)> {
    let better = |ratio: &Ratio| match ratio.above_optimum_percent {
        [along, across, _] if along <= across => PassDirection::Longitudinal,
        _ => PassDirection::Transverse,
    };
    let last = better(map.last()?);
    let since = map.iter().rev().take_while(|ratio| better(ratio) == last).last()?;
    Some((last, since.length_to_diameter))
}
