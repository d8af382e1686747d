//! Whether clamps at those places hold the part against turning and tipping, whatever force the screws give.

use crate::error::KnowledgeError;
use crate::note::{Figure, Finding, Note, Severity};
use crate::part::{Part, Point};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::units::{Micrometres, NewtonMetres, Newtons, round_to};

/// What the transitions ask of the clamps together, and what one of them gives.
#[derive(Clone, Copy)]
pub(super) struct Hold<'p> {
    /// The largest torque of a transition.
    pub torque: NewtonMetres,
    /// The largest side force of a transition, where one pushes the part.
    pub side: Newtons,
    /// The hole of the largest torque.
    pub hole: &'p str,
    /// The force of one screw.
    pub bears: Newtons,
    /// Safety factor k of the table `clamping`.
    pub safety: f64,
    /// Friction of a clamp and of the support under it, f + f2.
    pub friction: f64,
}

/// What does not hold with clamps at those places.
///
/// - Turning: the part turns about one clamp, and friction at the others holds it: k·M ≤ (f + f2)·W·Σl, N·m, l the
///   distances from that clamp to the others; under a single clamp nothing does.
/// - Tipping: a side force P at the top face turns the part over an edge, against W times the distances of the clamps
///   from it: k·P·h ≤ W·Σa, N·m, h the thickness of the blank; a disc over a line that touches its rim.
///
/// Feet that overlap are no two clamps; that all stand by one side is a doubt. Both balances are statics of a plate on a
/// flat support, with the constants of the table `clamping`.
///
/// # Errors
/// The knowledge base lacks a convention.
pub(super) fn faults(
    part: &Part,
    clamps: &[Point],
    hold: Hold<'_>,
    shop: &Shop<'_>,
) -> Result<Vec<Finding>, KnowledgeError> {
    let mut faults = Vec::new();
    let metres = |length: Micrometres| length.to_mm() / 1000.0;
    let overlapping = overlap(part, shop.convention(HoleDefault::ClampInset)?);
    faults.extend(overlapping.map(|note| Finding::of_part(Severity::Error, note)));
    let moment = hold.safety * hold.torque.0;
    let to_others = clamps.iter().map(|one| clamps.iter().map(|other| metres(one.distance(*other))).sum::<f64>());
    let lever = to_others.fold(f64::INFINITY, f64::min);
    let holds = hold.friction * hold.bears.0 * lever;
    if moment > holds {
        let code = if clamps.len() == 1 { "one-clamp-turns" } else { "clamps-turn" };
        let least = moment / (hold.friction * hold.bears.0) * 1000.0;
        let note = Note::new(code)
            .with("hole", Figure::called(hold.hole))
            .with("moment", round_to(moment, 1))
            .with("holds", round_to(holds, 1))
            .with("least", Micrometres::from_mm_rounded(least.ceil()));
        faults.push(Finding::of_part(Severity::Error, note));
    }
    let tips = hold.safety * hold.side.0 * metres(part.blank.thickness);
    let from_edges = match part.blank.is_round() {
        true => from_tangent(part, clamps),
        false => edges(part, clamps).map(metres).fold(f64::INFINITY, f64::min),
    };
    let holds = hold.bears.0 * from_edges;
    if tips > holds {
        let note = Note::new("clamps-tip")
            .with("side", hold.side.rounded(0).0)
            .with("moment", round_to(tips, 1))
            .with("holds", round_to(holds, 1));
        faults.push(Finding::of_part(Severity::Error, note));
    }
    if let Some((beyond, width)) = one_side(part, clamps, shop.share(HoleDefault::ClampSideShare)?) {
        let note = Note::new("clamps-one-side").with("beyond", beyond).with("width", width);
        faults.push(Finding::of_part(Severity::Doubtful, note));
    }
    Ok(faults)
}

/// The two nearest clamps of the file whose outlines overlap; a clamp without one stands on a foot about its point.
fn overlap(part: &Part, foot: Micrometres) -> Option<Note> {
    let clamps = &part.fixture.clamps;
    let pairs = clamps.iter().enumerate().flat_map(|(at, one)| clamps[at + 1..].iter().map(move |two| (one, two)));
    let overlapping = pairs.filter(|(one, two)| one.outline(foot).overlaps(&two.outline(foot)));
    let (one, two) = overlapping.min_by_key(|(one, two)| one.at.distance(two.at))?;
    if one.outline.or(two.outline).is_some() {
        let note = Note::new("clamp-outlines-overlap").with("one", one.at.shown());
        return Some(note.with("other", two.at.shown()));
    }
    Some(Note::new("clamps-overlap").with("distance", one.at.distance(two.at)).with("least", foot + foot))
}

/// The sums of the distances of the clamps from each of the four edges.
fn edges<'p>(part: &'p Part, clamps: &'p [Point]) -> impl Iterator<Item = Micrometres> + 'p {
    let (blank, datum) = (&part.blank, &part.datum);
    let sum = |of: &dyn Fn(&Point) -> Micrometres| clamps.iter().map(of).fold(Micrometres::ZERO, |sum, one| sum + one);
    let (left, front) = (sum(&|at| at.x - datum.left), sum(&|at| at.y - datum.front));
    let all = |size: Micrometres| size.ratio(clamps.len() as i64, 1);
    [left, front, all(blank.length) - left, all(blank.width) - front].into_iter()
}

/// The least sum of the distances of the clamps from a line that touches the rim of a disc: n·R − |Σr|, r from its axis to each of n
/// clamps, m.
fn from_tangent(part: &Part, clamps: &[Point]) -> f64 {
    let (middle, radius) = (part.middle(), part.blank.length.half().to_mm());
    let (x, y) =
        clamps.iter().fold((0.0, 0.0), |(x, y), at| (x + (at.x - middle.x).to_mm(), y + (at.y - middle.y).to_mm()));
    (clamps.len() as f64 * radius - libm::hypot(x, y)) / 1000.0
}

/// How far from a clamp the part goes on, and its width that way, where all clamps stand within `share` of its width
/// from one side.
fn one_side(part: &Part, clamps: &[Point], share: f64) -> Option<(Micrometres, Micrometres)> {
    let (blank, datum) = (&part.blank, &part.datum);
    // From the left, the right, the front and the back.
    let from = clamps.iter().map(|at| {
        let (left, front) = (at.x - datum.left, at.y - datum.front);
        [left, blank.length - left, front, blank.width - front]
    });
    let farthest = from.reduce(|one, two| std::array::from_fn(|side| one[side].max(two[side])))?;
    let widths = [blank.length, blank.length, blank.width, blank.width];
    let sides = farthest.into_iter().zip(widths);
    let found = sides.filter(|(farthest, width)| farthest.to_mm() < share * width.to_mm());
    found.map(|(farthest, width)| (width - farthest, width)).max()
}
