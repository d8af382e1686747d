//! The shortest sequence of roughing passes over a stepped shaft (the paper), compared with the usual sequences.
//!
//! The steps: [`grid`] makes levels and slices of a shaft, [`optimum`] finds the best order of its passes, [`variants`]
//! makes those for comparison, and [`find`] puts them together into [`Sequences`], which is plain data.

pub mod cost;
pub mod enumeration;
pub mod grid;
pub mod map;
pub mod optimum;
pub mod pass;
pub mod rich;
pub mod toolpath;
pub mod variants;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Figure, Finding, Note, Severity};
use crate::units::Minutes;

use super::length::Half;
use super::point::Point;
use super::schemes::rates;
use super::shaft::{Moves, Rates, Shaft};
use cost::{Cost, Objective, minutes};
use grid::{Grid, Level, Slice};
use optimum::CostToGo;
use pass::{Pass, PassDirection};

/// How many cuts the search over rich moves compares at most: some seconds.
const EFFORT: usize = 4_000_000;

/// The passes of a shaft, as several variants.
#[derive(Clone, Debug, Serialize)]
pub struct Sequences {
    /// The shaft.
    #[serde(flatten)]
    pub shaft: Shaft,
    /// The minimised quantity.
    pub objective: Objective,
    /// The permitted moves of passes.
    pub moves: Moves,
    /// The levels from the bar inwards.
    pub levels: Vec<Level>,
    /// The slices from the free end.
    pub slices: Vec<Slice>,
    /// `longitudinal`, `transverse`, `per-step`, `optimal`, in this order.
    pub variants: Vec<Variant>,
    /// With rich moves, the lower bound that is proven for the optimum. Without them the optimum is exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<rich::SearchProof>,
    /// Remarks for the reader.
    pub findings: Vec<Finding>,
}

/// A sequence of passes.
#[derive(Clone, Debug, Serialize)]
pub struct Variant {
    /// `longitudinal`, `transverse`, `per-step` or `optimal`.
    pub name: &'static str,
    /// The length cut in metal, mm.
    pub cutting_path_mm: Half,
    /// The quantity of the objective: mm, min or passes.
    pub cost: f64,
    /// Its excess over the optimum, per cent.
    pub above_optimum_percent: f64,
    /// The time with feeds, approach, retract and rapids, min.
    pub time_min: Minutes,
    /// The passes in order.
    pub passes: Vec<PassEntry>,
    /// The passes for drawings.
    #[serde(skip)]
    pub drawn: Vec<Pass>,
}

/// A pass in the output.
#[derive(Clone, Debug, Serialize)]
pub struct PassEntry {
    /// Its number, from 1.
    pub number: usize,
    /// Its direction.
    pub kind: PassDirection,
    /// Where the metal begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// Its largest depth, mm: radial of a longitudinal pass, axial of a transverse one.
    pub depth_mm: Half,
    /// Its length in metal, mm.
    pub length_mm: Half,
    /// The reason for it.
    pub reason: Note,
}

/// Finds the sequences of a shaft.
///
/// # Errors
/// The knowledge base lacks a rate of tools.
pub fn find(shaft: &Shaft, objective: Objective, knowledge: &Knowledge) -> Result<Sequences, KnowledgeError> {
    let grid = Grid::of(shaft);
    let (rates, _) = rates::rates(shaft, knowledge)?;
    let mut findings = Vec::new();
    let named = named(&grid, objective);
    let mut optimal = CostToGo::of(&grid, objective).passes();
    let best = total(&optimal, objective, &grid);
    // Only with one direction per step a longitudinal pass can end before its shoulder, so this variant can win
    // (docs/turning.md).
    if let Some((name, passes)) = named.iter().find(|(_, passes)| total(passes, objective, &grid) < best) {
        findings.push(Finding::of_part(
            Severity::Note,
            Note::new("variant-beyond-model").with("variant", Figure::word(*name)),
        ));
        optimal.clone_from(passes);
    }
    let mut proof = None;
    if shaft.roughing.moves == Moves::Rich {
        let (better, proven) = rich::find(&grid, objective, total(&optimal, objective, &grid).main, EFFORT);
        proof = Some(proven);
        if let Some(better) = better {
            optimal = better;
            findings.clear();
        }
    }
    let best = total(&optimal, objective, &grid);
    let all = named.into_iter().chain([("optimal", optimal)]);
    let variants: Vec<Variant> =
        all.map(|(name, passes)| variant(name, passes, rates, objective, &grid, best)).collect();
    if grid.slices.is_empty() {
        findings.push(Finding::of_part(Severity::Note, Note::new("nothing-to-turn")));
    }
    Ok(Sequences {
        shaft: shaft.clone(),
        objective,
        moves: shaft.roughing.moves,
        levels: grid.levels,
        slices: grid.slices,
        variants,
        proof,
        findings,
    })
}

/// The named variants.
pub fn named(grid: &Grid, objective: Objective) -> [(&'static str, Vec<Pass>); 3] {
    [
        ("longitudinal", variants::one_direction(grid, PassDirection::Longitudinal)),
        ("transverse", variants::one_direction(grid, PassDirection::Transverse)),
        ("per-step", variants::per_step(grid, objective)),
    ]
}

fn total(passes: &[Pass], objective: Objective, grid: &Grid) -> Cost {
    variants::total(passes, objective, grid.bar)
}

fn variant(
    name: &'static str,
    passes: Vec<Pass>,
    rates: Rates,
    objective: Objective,
    grid: &Grid,
    best: Cost,
) -> Variant {
    let own = total(&passes, objective, grid);
    let above = if best.main == 0 { 0.0 } else { (own.main as f64 / best.main as f64 - 1.0) * 100.0 };
    let entry = |(index, pass): (usize, &Pass)| PassEntry {
        number: index + 1,
        kind: pass.kind,
        from: pass.from,
        to: pass.to,
        depth_mm: pass.depth,
        length_mm: pass.length(),
        reason: pass.reason.clone(),
    };
    Variant {
        name,
        cutting_path_mm: passes.iter().map(Pass::length).sum(),
        cost: objective.shown(own.main),
        above_optimum_percent: crate::units::round_to(above, 2),
        time_min: minutes(total(&passes, Objective::Time { rates }, grid).main).rounded(4),
        passes: passes.iter().enumerate().map(entry).collect(),
        drawn: passes,
    }
}
