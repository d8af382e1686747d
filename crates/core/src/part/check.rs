//! Checks between the values of a part: unique names, holes inside the blank, centres apart, clamps on the blank and
//! beside the holes.

use std::collections::{BTreeMap, BTreeSet};
use technolog_note::{Figure, IntoFigure, Note, note};

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Problems;
use crate::units::Micrometres;

use super::{Blank, Datum, Hole, PinHole, Point, Slot, Way};

/// A section of a hole with one diameter; depths are measured from the entry face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BoreSpan {
    pub diameter: Micrometres,
    pub from: Micrometres,
    pub to: Micrometres,
}

impl BoreSpan {
    /// The end of a hole whose depth could not be read: outside every blank.
    pub const FAR: Micrometres = Micrometres::from_mm(1_000_000_000);

    pub const fn new(diameter: Micrometres, from: Micrometres, to: Micrometres) -> Self {
        Self { diameter, from, to }
    }
}

/// The key that says where the holes of a group are.
pub(super) struct Centres {
    pub place: Place,
    /// Whether it is a pattern, whose points have no places in the file.
    pub pattern: bool,
}

/// A group of holes with what could be read, and the places where its mistakes are reported, so that a mistake in one
/// key does not hide one in another.
pub(super) struct Group {
    pub name: Option<(String, Place)>,
    /// The sections of a hole of the group, with its openings and its groove; none if they are not known.
    pub spans: Vec<BoreSpan>,
    pub depth: Option<(Micrometres, Place)>,
    pub through: Option<bool>,
    pub at: Option<Centres>,
    pub points: Vec<(Point, Place)>,
    /// How it runs on from its point, where it is a slot.
    pub slot: Option<Slot>,
    /// The whole hole, if nothing was missing.
    pub hole: Option<Hole>,
}

impl Group {
    fn label(&self) -> Figure {
        self.name.as_ref().map_or_else(|| "?".into_figure(), |(name, _)| Figure::called(name))
    }

    /// The lines over which its axes extend, with their places.
    fn ways(&self) -> impl Iterator<Item = (Way, &Place)> {
        let (slot, width) = (self.slot.unwrap_or_default(), self.widest().unwrap_or_default());
        self.points.iter().flat_map(move |(at, place)| slot.ways(*at, width).into_iter().map(move |way| (way, place)))
    }

    /// The widest diameter anywhere in the hole.
    fn widest(&self) -> Option<Micrometres> {
        self.spans.iter().map(|span| span.diameter).max()
    }

    /// The widest diameter at the entry face.
    fn mouth(&self) -> Option<Micrometres> {
        self.spans.iter().filter(|span| span.from == Micrometres::ZERO).map(|span| span.diameter).max()
    }

    /// The least distance between a hole of this group and one of another: at each common depth, the sum of the
    /// radii.
    fn needs(&self, other: &Self) -> Option<Micrometres> {
        let pairs = self.spans.iter().flat_map(|span| other.spans.iter().map(move |theirs| (span, theirs)));
        let beside = pairs.filter(|(own, theirs)| own.from < theirs.to && theirs.from < own.to);
        beside.map(|(own, theirs)| (own.diameter + theirs.diameter).half()).max()
    }
}

/// No two groups of one name.
pub(super) fn check_names(groups: &[Group], problems: &mut Problems) {
    let mut known = BTreeSet::new();
    for (name, place) in groups.iter().filter_map(|group| group.name.as_ref()) {
        if !known.insert(name) {
            let message = note!("part-two-groups-holes-named", name = name);
            problems.error_help::<()>("duplicate-name", message, place, note!("part-name-each-group-once"));
        }
    }
}

/// Checks depths against the thickness, every hole inside the blank, no two holes in each other.
pub(super) fn check_geometry(groups: &[Group], blank: &Blank, datum: &Datum, problems: &mut Problems) {
    for group in groups {
        depth(group, blank, problems);
        match group.slot {
            None => inside(group, blank, datum, problems),
            Some(_) => slot_inside(group, blank, datum, problems),
        }
    }
    apart(groups, problems);
    slots_apart(groups, problems);
}

/// Both ends of a slot and all corners of a pocket inside the blank; of a slot that is open its closed end, or the middle of one that
/// goes across the part.
fn slot_inside(group: &Group, blank: &Blank, datum: &Datum, problems: &mut Problems) {
    let Some(width) = group.widest() else { return };
    if let Some(slot) = group.slot.filter(|slot| slot.open.is_some()) {
        for (at, place) in &group.points {
            let far = slot.far(*at);
            let middle = Point { x: (at.x + far.x).half(), y: (at.y + far.y).half() };
            let (end, code) = match slot.closed(*at).next() {
                Some(end) => (end, "part-slot-inside-blank"),
                None => (middle, "part-slot-across-blank"),
            };
            if reaches_out(end, width.half(), blank, datum) {
                let note =
                    Note::new(code).with("name", group.label()).with("width", width).with("x", end.x).with("y", end.y);
                problems.error_help::<()>("outside-blank", note, place, extent(blank, datum));
            }
        }
        return;
    }
    let ends = group.ways().flat_map(|(way, place)| [way.from, way.to].map(|end| (end, way.thinner, place)));
    let mut out = ends.filter(|(end, thinner, _)| reaches_out(*end, width.half() - *thinner, blank, datum));
    if let Some((end, thinner, place)) = out.next() {
        let message = match thinner {
            Micrometres::ZERO => {
                note!("part-slot-inside-blank", name = group.label(), width = width, x = end.x, y = end.y)
            }
            _ => note!("part-pocket-inside-blank", name = group.label(), x = end.x, y = end.y),
        };
        problems.error_help::<()>("outside-blank", message, place, extent(blank, datum));
    }
}

/// No slot in a hole or in a slot that stands before it in the file.
fn slots_apart(groups: &[Group], problems: &mut Problems) {
    for (index, group) in groups.iter().enumerate().filter(|(_, group)| group.slot.is_some()) {
        // Holes stand before slots, whatever their order in the file.
        let met = groups[..index].iter().find_map(|other| {
            let needed = group.needs(other)?;
            let near =
                |(way, place)| other.ways().map(move |(theirs, _)| (theirs.apart(way), place)).min_by_key(|one| one.0);
            let (distance, place) = group.ways().filter_map(near).min_by_key(|one| one.0)?;
            (distance < needed).then_some((other, place, distance, needed))
        });
        if let Some((other, place, distance, needed)) = met {
            let code = if other.slot.is_some() { "part-slot-runs-into-slot" } else { "part-slot-runs-into-hole" };
            let message = note!(code, label = group.label(), other = other.label());
            let help = note!("part-middles-mm-apart-need", distance = distance, needed = needed);
            problems.error_help::<()>("holes-meet", message, place, help);
        }
    }
}

/// Checks that every clamp presses on the blank, and not on a hole.
pub(super) fn check_clamps(
    clamps: &[(Point, Place)],
    groups: &[Group],
    blank: &Blank,
    datum: &Datum,
    problems: &mut Problems,
) {
    for (point, place) in clamps {
        if reaches_out(*point, Micrometres::ZERO, blank, datum) {
            let message = note!("part-clamp-at-on-blank", x = point.x, y = point.y);
            problems.error_help::<()>("outside-blank", message, place, extent(blank, datum));
        }
        let under = groups.iter().find(|group| {
            let radius = group.mouth().unwrap_or_default().half();
            group.ways().any(|(way, _)| way.distance(*point) < radius)
        });
        if let Some(group) = under {
            let slot = group.slot.is_some();
            let code = if slot { "part-clamp-at-presses-on-slot" } else { "part-clamp-at-presses-on-hole" };
            let message = note!(code, x = point.x, y = point.y, label = group.label());
            problems.error_help::<()>("clamp-on-hole", message, place, note!("part-put-beside-hole"));
        }
    }
}

/// Checks that the holes of pins lie in the blank, clear of each other and of the holes that are made: seen from above, as what
/// is drilled through comes out at the face that the pins stand on.
pub(super) fn check_pins(
    pins: &[(PinHole, Place)],
    groups: &[Group],
    blank: &Blank,
    datum: &Datum,
    problems: &mut Problems,
) {
    for (index, (pin, place)) in pins.iter().enumerate() {
        let (at, radius) = (pin.at, pin.diameter.nominal.half());
        if reaches_out(at, radius, blank, datum) {
            let message = note!("part-pin-at-inside-blank", x = at.x, y = at.y, diameter = pin.diameter.nominal);
            problems.error_help::<()>("outside-blank", message, place, extent(blank, datum));
        }
        let made = groups.iter().find_map(|group| {
            let needed = radius + group.widest()?.half();
            group.points.iter().any(|(hole, _)| hole.distance(at) < needed).then(|| group.label())
        });
        if let Some(label) = made {
            let message = note!("part-pin-at-meets-hole", x = at.x, y = at.y, label = label);
            problems.error_help::<()>("holes-meet", message, place, note!("part-pins-take-finished-holes"));
        }
        let earlier = pins.iter().take(index);
        if earlier.into_iter().any(|(other, _)| other.at.distance(at) < radius + other.diameter.nominal.half()) {
            let message = note!("part-pins-meet", x = at.x, y = at.y);
            problems.error_help::<()>("holes-meet", message, place, note!("part-pins-far-apart"));
        }
    }
}

/// A hole less deep than this cannot be centred: the spot is not wider than the hole is deep.
const LEAST_DEPTH: Micrometres = Micrometres::new(100);

fn depth(group: &Group, blank: &Blank, problems: &mut Problems) {
    let (Some((depth, place)), Some(through)) = (&group.depth, group.through) else { return };
    let (name, thickness) = (group.label(), blank.thickness);
    if through && *depth != thickness {
        let message = note!("part-hole-through-hole-deep-but", name = name, depth = depth, thickness = thickness);
        problems.error_help::<()>("bad-depth", message, place, note!("part-leave-depth-out-make-thickness"));
    } else if !through && *depth >= thickness {
        let message = note!("part-hole-blind-hole-deep-blank", name = name, depth = depth, thickness = thickness);
        problems.error_help::<()>("bad-depth", message, place, note!("part-say-through-true-make-shallower"));
    } else if *depth < LEAST_DEPTH {
        let message = note!("part-hole-mm-deep-mark-no", name = name, depth = depth);
        let help = note!("part-mind-unit-depths-mm-least", least = LEAST_DEPTH);
        problems.error_help::<()>("bad-depth", message, place, help);
    }
}

fn inside(group: &Group, blank: &Blank, datum: &Datum, problems: &mut Problems) {
    let Some(diameter) = group.widest() else { return };
    let outside: Vec<&(Point, Place)> =
        group.points.iter().filter(|(point, _)| reaches_out(*point, diameter.half(), blank, datum)).collect();
    let (name, wide) = (group.label(), diameter);
    if let (Some(at), Some((first, _)), true) = (&group.at, outside.first(), outside.len() > 1) {
        // If all points are outside, the mistake is in the datum or the blank, and is reported once.
        if outside.len() == group.points.len() {
            let message =
                note!("part-inside-blank-at-any-points", name = name, diameter = wide, outside = outside.len());
            let help = note!("part-datum-says-where-zeros-lie", extent = extent(blank, datum));
            problems.error_help::<()>("outside-blank", message, &at.place, help);
            return;
        }
        // Also one mistake: the points of a pattern cannot be corrected one by one.
        if at.pattern {
            let (number, all) = (outside.len(), group.points.len());
            let first = note!("part-first-at", x = first.x, y = first.y);
            let message = note!(
                "part-inside-blank-at-points",
                name = name,
                diameter = wide,
                number = number,
                all = all,
                first = first
            );
            problems.error_help::<()>("outside-blank", message, &at.place, extent(blank, datum));
            return;
        }
    }
    for (point, place) in outside {
        let message = note!("part-at-inside-blank", name = name, diameter = wide, x = point.x, y = point.y);
        problems.error_help::<()>("outside-blank", message, place, extent(blank, datum));
    }
}

/// Whether a circle extends beyond the blank.
fn reaches_out(point: Point, radius: Micrometres, blank: &Blank, datum: &Datum) -> bool {
    blank.to_edge(datum, point) < radius
}

fn extent(blank: &Blank, datum: &Datum) -> Note {
    if blank.is_round() {
        return match blank.bore {
            Some(bore) => note!("part-ring-reaches", bore = bore, diameter = blank.length),
            None => note!("part-disc-reaches", diameter = blank.length),
        };
    }
    let (right, back) = (datum.left + blank.length, datum.front + blank.width);
    note!("part-blank-reaches-from-x-from", left = datum.left, right = right, front = datum.front, back = back)
}

/// A hole that overlaps an earlier one.
struct Meeting<'g> {
    point: Point,
    place: &'g Place,
    other: &'g Group,
    other_place: &'g Place,
    distance: Micrometres,
    needed: Micrometres,
}

fn apart(groups: &[Group], problems: &mut Problems) {
    let mut cells = Cells::new(groups);
    for (index, group) in groups.iter().enumerate().filter(|(_, group)| group.slot.is_none()) {
        let meetings = cells.meetings(index);
        let Some(first) = meetings.first() else { continue };
        let (same_other, itself) =
            (meetings.iter().all(|meeting| std::ptr::eq(meeting.other, first.other)), std::ptr::eq(first.other, group));
        let every_one = meetings.len() + usize::from(itself) == group.points.len();
        if let (Some(at), true) = (&group.at, meetings.len() > 1 && same_other && every_one) {
            // Points copied from another group, or a wrong diameter, are one mistake, not one for each point.
            let message = if itself {
                note!("part-holes-run-into-each-other", label = group.label())
            } else {
                let (name, other) = (group.label(), first.other.label());
                note!("part-every-hole-runs-into-hole", name = name, other = other, line = first.other_place.line)
            };
            let help = note!("part-mind-diameter-points", gap = first.gap());
            problems.error_help::<()>("holes-meet", message, &at.place, help);
            continue;
        }
        if let Some(at) = group.at.as_ref().filter(|at| at.pattern && meetings.len() > 1) {
            let (number, all) = (meetings.len(), group.points.len());
            let message = first
                .note("part-holes-run-into-others-first")
                .with("number", number)
                .with("all", all)
                .with("label", group.label());
            problems.error_help::<()>("holes-meet", message, &at.place, first.gap());
            continue;
        }
        for meeting in meetings {
            let message = meeting.note("part-hole-runs-into-hole").with("label", group.label());
            problems.error_help::<()>("holes-meet", message, meeting.place, meeting.gap());
        }
    }
}

impl Meeting<'_> {
    fn gap(&self) -> Note {
        note!("part-centres-mm-apart-holes-need", distance = self.distance, needed = self.needed)
    }
}

impl Meeting<'_> {
    fn note(&self, code: &'static str) -> Note {
        let Self { point, other, other_place, .. } = self;
        note!(code, x = point.x, y = point.y, other = other.label(), line = other_place.line)
    }
}

/// A square of the top face, by its column and row.
type Cell = (i64, i64);
/// A hole, by its group and its point, in the order of the file.
type HoleNumber = (usize, usize);

/// Holes of similar width, by squares of about that width.
type Squares = BTreeMap<Cell, Vec<HoleNumber>>;

/// The holes checked so far, separately for each width: one wide hole does not make the squares of small ones larger.
struct Cells<'g> {
    groups: &'g [Group],
    of_width: BTreeMap<i64, Squares>,
}

impl<'g> Cells<'g> {
    const fn new(groups: &'g [Group]) -> Self {
        Self { groups, of_width: BTreeMap::new() }
    }

    /// For every hole of a group, the first earlier hole that it overlaps.
    fn meetings(&mut self, index: usize) -> Vec<Meeting<'g>> {
        let groups = self.groups;
        let group = &groups[index];
        let Some(widest) = group.widest().map(Micrometres::micrometres) else { return Vec::new() };
        let needed: Vec<Option<Micrometres>> = groups[..=index].iter().map(|other| group.needs(other)).collect();
        let width = square(widest);
        let mut meetings = Vec::new();
        for (number, (point, place)) in group.points.iter().enumerate() {
            let around = self.of_width.iter().flat_map(|(width, squares)| around(squares, *width, *point, widest));
            // In a square the holes are in the order of the file, so its first is the earliest.
            let met = around.filter_map(|holes| {
                holes.iter().find_map(|&(other, at)| {
                    let (needed, (other_point, _)) = (needed[other]?, &groups[other].points[at]);
                    // Most holes are far apart along one axis, which needs no square root.
                    let (x, y) = ((point.x - other_point.x).abs(), (point.y - other_point.y).abs());
                    let distance = Some(point.distance(*other_point)).filter(|_| x < needed && y < needed)?;
                    (distance < needed).then_some(((other, at), distance, needed))
                })
            });
            if let Some(((other, at), distance, needed)) = met.min() {
                let (other, other_place) = (&groups[other], &groups[other].points[at].1);
                meetings.push(Meeting { point: *point, place, other, other_place, distance, needed });
            }
            let squares = self.of_width.entry(width).or_default();
            squares.entry(cell(*point, width)).or_default().push((index, number));
        }
        meetings
    }
}

/// The side of the squares for holes of a width: at least the width, and less than twice the width.
fn square(width: i64) -> i64 {
    let side = u64::try_from(width).unwrap_or_default().max(1).checked_next_power_of_two();
    side.and_then(|side| i64::try_from(side).ok()).unwrap_or(i64::MAX)
}

fn cell(point: Point, side: i64) -> Cell {
    (point.x.micrometres().div_euclid(side), point.y.micrometres().div_euclid(side))
}

/// The squares with holes that a hole of some width may overlap.
fn around(squares: &Squares, side: i64, point: Point, width: i64) -> Box<dyn Iterator<Item = &Vec<HoleNumber>> + '_> {
    // The holes in the squares are not wider than the side.
    let reach = Micrometres::new(width.saturating_add(side)).half();
    let low = cell(Point { x: point.x - reach, y: point.y - reach }, side);
    let high = cell(Point { x: point.x + reach, y: point.y + reach }, side);
    let columns = low.0..=high.0;
    // Around a wide hole there may be fewer squares with holes than columns of squares.
    if usize::try_from(high.0 - low.0).is_ok_and(|columns| columns > squares.len()) {
        let near = move |(column, row): Cell| columns.contains(&column) && (low.1..=high.1).contains(&row);
        return Box::new(squares.iter().filter(move |(cell, _)| near(**cell)).map(|(_, holes)| holes));
    }
    let of_column = move |column| squares.range((column, low.1)..=(column, high.1)).map(|(_, holes)| holes);
    Box::new(columns.flat_map(of_column))
}

#[cfg(test)]
mod tests {
    use crate::part::read_part;
    use crate::shipped;

    const HEAD: &str = "part: P
material: steel-45
blank: {kind: plate, length: 1000, width: 1000, thickness: 40}
machine: gf2171
datum: {x: left, y: front}
holes:
";

    fn problems(holes: &str) -> Vec<String> {
        let knowledge = shipped::knowledge().unwrap();
        let problems = read_part("part", &format!("{HEAD}{holes}"), &knowledge).err().unwrap_or_default();
        problems.iter().map(|problem| problem.text(|note| technolog_words::Lang::EN.say(note))).collect()
    }

    fn hole(name: &str, keys: &str) -> String {
        format!("  - {{name: {name}, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, {keys}}}\n")
    }

    #[test]
    fn holes_meet_where_both_are_at_one_depth() {
        // Wide at the entry, beside one that is wide at the back.
        let entry = hole("A", "steps: [{diameter: 30, length: 15}, {diameter: 10}], at: [[100, 100]]");
        let back =
            |x: i64| hole("B", &format!("steps: [{{diameter: 10, length: 25}}, {{diameter: 30}}], at: [[{x}, 100]]"));
        assert_eq!(problems(&format!("{entry}{}", back(121))), [""; 0]);
        assert_eq!(problems(&format!("{entry}{}", back(119))).len(), 1);
        for opening in
            ["counterbore: {diameter: 30, depth: 5}", "countersink: {diameter: 30}", "cone: {diameter: 30, angle: 90}"]
        {
            let wide = hole("A", &format!("diameter: 10, {opening}, at: [[100, 100]]"));
            let plain = |x: i64| hole("B", &format!("diameter: 10, at: [[{x}, 100]]"));
            assert_eq!(problems(&format!("{wide}{}", plain(121))), [""; 0], "{opening}");
            assert_eq!(problems(&format!("{wide}{}", plain(119))).len(), 1, "{opening}");
            let edge = hole("A", &format!("diameter: 10, {opening}, at: [[14, 100]]"));
            assert!(problems(&edge)[0].contains("Ø30 at [14, 100]"), "{opening}");
        }
        assert_eq!(problems(&hole("A", "diameter: 10, face: 30, at: [[10, 10], [30, 10]]")), [""; 0]);
    }

    #[test]
    fn the_first_hole_of_the_file_that_is_run_into_is_named() {
        let three = ["A", "B", "C"].map(|name| hole(name, "diameter: 80, at: [[500, 500]]")).concat();
        let found = problems(&three);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|one| one.contains("into hole A at line 7")), "{found:?}");
    }

    #[test]
    fn a_mistake_in_a_pattern_is_told_once() {
        let grid = |step: &str| format!("pattern: {{grid: {{start: [100, 100], columns: 10, rows: 3, step: {step}}}}}");
        let outside = problems(&hole("A", &format!("diameter: 10, {}", grid("[100, 20]"))));
        assert_eq!(outside.len(), 1);
        assert!(outside[0].contains("3 of its 30 points, the first at [1000, 100]"), "{outside:?}");
        let meeting = problems(&hole("A", &format!("diameter: 20, {}", grid("[15, 25]"))));
        assert_eq!(meeting.len(), 1);
        assert!(
            meeting[0].contains("27 of the 30 holes of A run into others; the first: at [115, 100]"),
            "{meeting:?}"
        );
    }

    #[test]
    fn holes_of_every_width_are_held_against_each_other() {
        // In either order, a small hole beside a wide one is found if it is slightly too near.
        for (wide, small) in [("80", "3"), ("64", "4"), ("16", "16"), ("33", "31")] {
            let half = |text: &str| text.parse::<f64>().unwrap() / 2.0;
            let apart = half(wide) + half(small);
            for (shift, count) in [(0.0, 0), (-0.002, 1)] {
                let first = hole("A", &format!("diameter: {wide}, at: [[500, 500]]"));
                let second = hole("B", &format!("diameter: {small}, at: [[{:.3}, 500]]", 500.0 - apart - shift));
                assert_eq!(problems(&format!("{first}{second}")).len(), count, "{wide} {small} {shift}");
                assert_eq!(problems(&format!("{second}{first}")).len(), count, "{small} {wide} {shift}");
            }
        }
    }

    #[test]
    fn a_thousand_holes_beside_a_wide_one_are_all_looked_at() {
        let wide = hole("W", "diameter: 80, at: [[900, 900]]");
        let many = hole("M", "diameter: 3, pattern: {grid: {start: [10, 10], columns: 40, rows: 25, step: 5}}");
        assert_eq!(problems(&format!("{wide}{many}")), [""; 0]);
        let one_more = hole("O", "diameter: 3, at: [[206, 131]]");
        assert!(problems(&format!("{wide}{many}{one_more}"))[0].contains("runs into hole M"));
    }
}
