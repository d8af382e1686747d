//! The part of a program without a part: the holes that it makes, and nothing else. What depends on a drawing is not judged then.

use std::collections::{BTreeMap, BTreeSet};

use crate::knowledge::Knowledge;
use crate::part::{Part, read_part};
use crate::program::seen::SeenCut;
use crate::units::Micrometres;

use super::super::sheet::STAND_INS;
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
    let mut holes = String::new();
    for (number, (sections, own)) in (1..).zip(&groups) {
        let of = seen.iter().filter(|cut| sections.contains(&cut.section));
        let size = of.filter_map(|cut| told.of(cut.tool)?.diameter).fold(0.0, f64::max);
        let size = if size > 0.0 { size } else { untold.to_mm() }.min(nearest * 0.9);
        let deepest = own.iter().map(|(_, deepest)| deepest.to_mm()).fold(0.0, f64::min);
        let at: Vec<String> = own.iter().map(|([x, y], _)| format!("[{x}, {y}]")).collect();
        holes.push_str(&format!(
            "  - {{name: \"{number}\", diameter: {size}H14, depth: {}, roughness: Rz 80, centre_tolerance: 1, at: [{}]}}\n",
            (-deepest).max(1.0),
            at.join(", ")
        ));
    }
    let deepest = tools.values().map(|(_, deepest)| -deepest.to_mm()).fold(10.0, f64::max);
    let [(_, material), (_, machine)] = STAND_INS;
    let text = format!(
        "part: {file:?}\nmaterial: {material}\nmachine: {machine}\nblank: {{kind: plate, length: {side}, width: {side}, \
         thickness: {}}}\nholes:\n{holes}",
        libm::ceil(deepest + 20.0)
    );
    read_part(file, &text, knowledge).ok()
}
