//! Where the program's zero lies in the drawing. Most programs have that of the drawing; a corner or the lower face is seen from the
//! points, where just one place fits them all.

use std::collections::BTreeSet;

use crate::motion::Position;
use crate::part::Part;
use crate::program::seen::SeenCut;
use crate::units::Micrometres;

use super::Placed;

/// How many points of a program are tried as points of the drawing.
const TRIED: usize = 8;

/// Points that differ by no more are one.
const SAME: i64 = 20;

fn near(a: Micrometres, b: Micrometres) -> bool {
    (a - b).abs().micrometres() <= SAME
}

/// The group of holes at a point of the drawing.
fn hole_at(part: &Part, x: Micrometres, y: Micrometres) -> Option<&str> {
    let here = |hole: &&crate::part::Hole| hole.at.iter().any(|at| near(at.x, x) && near(at.y, y));
    part.holes.iter().find(here).map(|hole| hole.name.as_str())
}

/// Whether a cut stands at a point of the drawing.
pub(super) fn is_at(cut: &SeenCut, [x, y]: [Micrometres; 2], shift: Position) -> bool {
    near(cut.at[0] + shift.x, x) && near(cut.at[1] + shift.y, y)
}

/// Whether most points of a program are those of the drawing taken for inches.
pub(super) fn is_in_inches(seen: &[SeenCut], part: &Part) -> bool {
    let points: BTreeSet<[Micrometres; 2]> = seen.iter().map(|cut| cut.at).collect();
    let in_mm = |length: Micrometres| length.ratio(10, 254);
    let own = points.iter().filter(|at| hole_at(part, in_mm(at[0]), in_mm(at[1])).is_some());
    // A single point at the zero is the same in both.
    points.len() > 1 && own.count() * 2 > points.len()
}

/// What is added to the program's coordinates to have the drawing's.
pub(super) fn shift(seen: &[SeenCut], part: &Part) -> Position {
    let points: BTreeSet<[Micrometres; 2]> = seen.iter().map(|cut| cut.at).collect();
    let fits = |dx: Micrometres, dy: Micrometres| {
        points.iter().filter(|at| hole_at(part, at[0] + dx, at[1] + dy).is_some()).count()
    };
    let mut moved = Position::default();
    // A slip in one point, or a point of something else, leaves most of them where they belong.
    let most = |count: usize| count * 2 > points.len();
    if points.len() > 1 && !most(fits(Micrometres::ZERO, Micrometres::ZERO)) {
        let drawn: Vec<_> = part.holes.iter().flat_map(|hole| &hole.at).collect();
        let mut found: Vec<(usize, [Micrometres; 2])> = points
            .iter()
            .take(TRIED)
            .flat_map(|own| drawn.iter().map(move |at| [at.x - own[0], at.y - own[1]]))
            .map(|[dx, dy]| (fits(dx, dy), [dx, dy]))
            .filter(|(count, _)| most(*count))
            .collect();
        found.sort();
        found.dedup();
        let best = found.last().copied();
        let second = found.iter().rev().nth(1).map_or(0, |(count, _)| *count);
        if let Some((_, [dx, dy])) = best.filter(|(count, _)| *count > second) {
            (moved.x, moved.y) = (dx, dy);
        }
    }
    // With the zero on the lower face most feeds begin a whole thickness and more above the upper one.
    let (top, thickness) = (part.datum.top, part.blank.thickness);
    let high = seen.iter().filter(|cut| cut.begin - thickness >= top).count();
    let reaches = seen.iter().any(|cut| cut.deepest - thickness < top);
    if high * 2 > seen.len() && reaches {
        moved.z = -thickness;
    }
    moved
}

/// The cuts at points of the drawing, and how many points of others there are.
pub(super) fn placed(seen: Vec<SeenCut>, part: &Part, shift: Position) -> (Vec<Placed>, usize) {
    let (mut placed, mut elsewhere) = (Vec::new(), BTreeSet::new());
    for cut in seen {
        let hole = hole_at(part, cut.at[0] + shift.x, cut.at[1] + shift.y).map(str::to_owned);
        match hole {
            Some(hole) => placed.push(Placed { cut, hole }),
            None => _ = elsewhere.insert(cut.at),
        }
    }
    (placed, elsewhere.len())
}
