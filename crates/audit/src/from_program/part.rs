//! The part of a program without a part: the holes that it makes, and nothing else. What depends on a drawing is not judged then.

use std::collections::{BTreeMap, BTreeSet};

use crate::knowledge::Knowledge;
use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Problems;
use crate::part::{Part, read_part_node};
use crate::program::seen::SeenCut;
use crate::units::Micrometres;

use super::super::sheet::made::{self, MadeHole};
use super::told::ToldTools;

/// A part of the holes of a program: points at which the same tools work are one group. None where the holes make no part: there is
/// none, or too many.
///
/// `untold` is the widest hole of which nothing is told.
pub(super) fn made(
    file: &str,
    seen: &[SeenCut],
    told: &ToldTools,
    untold: Micrometres,
    knowledge: &Knowledge,
) -> Option<Part> {
    let mut tools: BTreeMap<[Micrometres; 2], (BTreeSet<usize>, Micrometres)> = BTreeMap::new();
    for cut in seen {
        let (sections, deepest) = tools.entry(cut.at).or_default();
        sections.insert(cut.section);
        *deepest = (*deepest).min(cut.deepest);
    }
    let mut groups: BTreeMap<&BTreeSet<usize>, Vec<([Micrometres; 2], Micrometres)>> = BTreeMap::new();
    for (at, (sections, deepest)) in &tools {
        groups.entry(sections).or_default().push((*at, *deepest));
    }
    let points: Vec<[f64; 2]> = tools.keys().map(|at| at.map(Micrometres::to_mm)).collect();
    let apart = |[x, y]: [f64; 2]| {
        let other = points.iter().filter(|other| **other != [x, y]);
        other.map(|[a, b]| libm::hypot(a - x, b - y)).fold(f64::INFINITY, f64::min)
    };
    let nearest = points.iter().copied().map(apart).fold(f64::INFINITY, f64::min);
    let reach = points.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
    let side = libm::ceil((reach + 50.0) * 2.0);
    let mut holes = Vec::new();
    for (number, (sections, own)) in (1_u32..).zip(&groups) {
        let of = seen.iter().filter(|cut| sections.contains(&cut.section));
        let size = of.filter_map(|cut| told.of(cut.tool)?.diameter).fold(0.0, f64::max);
        let size = if size > 0.0 { size } else { untold.to_mm() }.min(nearest * 0.9);
        let deepest = own.iter().map(|(_, deepest)| deepest.to_mm()).fold(0.0, f64::min);
        holes.push(MadeHole {
            name: number.to_string(),
            diameter: format!("{size}H14"),
            depth: (-deepest).max(1.0),
            at: own.iter().map(|(at, _)| at.map(Micrometres::to_mm)).collect(),
        });
    }
    let deepest = tools.values().map(|(_, deepest)| -deepest.to_mm()).fold(10.0, f64::max);
    let place = Place { file: file.into(), line: 1, column: 1, width: 1 };
    let node = made::part(file, &holes, [side, side, libm::ceil(deepest + 20.0)], |_| None, &place);
    let mut problems = Problems::default();
    read_part_node(&node, knowledge, &mut problems).filter(|_| problems.0.is_empty())
}
