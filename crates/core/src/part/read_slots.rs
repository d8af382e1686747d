//! The slots of a part file.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Fields, Node};
use crate::units::Micrometres;
use technolog_note::note;

use super::check::{BoreSpan, Centres, Group};
use super::file::slot::{self as form, Open};
use super::limits::LimitedCount;
use super::read::Reader;
use super::read_pattern::Turn;
use super::{Blank, BlankHole, Bottom, Datum, Hole, OpenEnds, Point, Slot};

/// How the file says where a slot runs.
enum Run {
    /// By the middles of its end radii.
    Ends(Point, Point),
    /// By its middle, its length over all and its direction.
    Middle(Point, Micrometres, Turn),
}

impl Run {
    /// The middle of its first end radius, and how it runs on from there; none where it is no longer than wide, which only a pocket
    /// along the axes may be.
    fn placed(self, width: Micrometres, corner: Option<Micrometres>) -> Option<(Point, Slot)> {
        let (from, to) = match self {
            Self::Ends(from, to) => (from, to),
            Self::Middle(middle, length, turn) if corner.is_some() && length == width => {
                let along = turn.place(middle, 1.0, 0.0);
                let slot = Slot { corner, ..Slot::default() };
                return (along.x == middle.x || along.y == middle.y).then_some((middle, slot));
            }
            Self::Middle(middle, length, _) if length <= width => (middle, middle),
            Self::Middle(middle, length, turn) => {
                let half = (length - width).to_mm() / 2.0;
                (turn.place(middle, -half, 0.0), turn.place(middle, half, 0.0))
            }
        };
        (from != to).then(|| (from, Slot { x: to.x - from.x, y: to.y - from.y, corner, open: None }))
    }
}

/// A slot with its open ends moved out of the blank by what `beyond` says of the way to an end; the first end is open then. None where
/// it does not leave the blank there.
fn opened(
    at: Point,
    slot: Slot,
    open: Open,
    beyond: impl Fn(Point, Point) -> Option<Micrometres>,
) -> Option<(Point, Slot)> {
    let far = slot.far(at);
    let (first, other) = if matches!(open, Open::To) { (far, at) } else { (at, far) };
    let out = beyond(other, first)?;
    let far = match open {
        Open::Both => Some(beyond(first, other)?),
        Open::From | Open::To => None,
    };
    let moved = |from: Point, to: Point, out: Micrometres| {
        let length = from.distance(to).to_mm();
        let on = |from: Micrometres, to: Micrometres| {
            Micrometres::from_mm_rounded(to.to_mm() + (to - from).to_mm() * out.to_mm() / length)
        };
        Point { x: on(from.x, to.x), y: on(from.y, to.y) }
    };
    let (begin, end) = (moved(other, first, out), far.map_or(other, |far| moved(first, other, far)));
    let run = Slot { x: end.x - begin.x, y: end.y - begin.y, corner: None, open: Some(OpenEnds { first: out, far }) };
    Some((begin, run))
}

/// How far beyond `to`, on the way from `from`, a circle of that radius stands beside the blank; none where `to` lies inside of it, or
/// where the way leaves it at so flat an angle that the circle is still over it after eight of its radii.
fn run_out(from: Point, to: Point, radius: Micrometres, blank: &Blank, datum: &Datum) -> Option<Micrometres> {
    let [left, front] = [datum.left, datum.front].map(Micrometres::to_mm);
    let [length, width] = [blank.length, blank.width].map(Micrometres::to_mm);
    let whole = from.distance(to).to_mm();
    let radius = radius.to_mm();
    let (along_x, along_y) = ((to.x - from.x).to_mm() / whole, (to.y - from.y).to_mm() / whole);
    let away = |on: f64| {
        let (x, y) = (to.x.to_mm() + on * along_x - left, to.y.to_mm() + on * along_y - front);
        match blank.is_round() {
            true => libm::hypot(x - length / 2.0, y - width / 2.0) - length / 2.0,
            false => libm::hypot((-x).max(x - length).max(0.0), (-y).max(y - width).max(0.0)),
        }
    };
    let inside = match blank.is_round() {
        // A point of a rim is written to a micrometre.
        true => away(0.0) < -0.001,
        false => blank.to_edge(datum, to) > Micrometres::ZERO,
    };
    if inside || away(8.0 * radius) < radius {
        return None;
    }
    // The distance from a plate or a disc does not fall along a straight way out of it.
    let (mut near, mut far) = (0.0, 8.0 * radius);
    while far - near > 1e-6 {
        let middle = (near + far) / 2.0;
        if away(middle) < radius { near = middle } else { far = middle }
    }
    Some(Micrometres::from_mm_rounded(far))
}

impl Reader<'_> {
    /// The slots as groups of one hole each, which runs on.
    pub(super) fn slots(&mut self, node: &Node, blank: Option<&Blank>, datum: Option<&Datum>) -> Vec<Group> {
        let items = self.problems.list(node).unwrap_or_default();
        self.bounded(LimitedCount::Kinds, items).iter().filter_map(|item| self.slot(item, blank, datum)).collect()
    }

    fn slot(&mut self, node: &Node, blank: Option<&Blank>, datum: Option<&Datum>) -> Option<Group> {
        let mut fields = self.problems.map(node)?;
        let place = fields.place;
        let name_node = fields.need(form::Slot::name, self.problems);
        let name = name_node.and_then(|node| self.name(node));
        let run = self.run(&mut fields);
        let width_node = fields.need(form::Slot::width, self.problems);
        let width = width_node.and_then(|node| self.diameter(node));
        let corner = self.corner(&mut fields, width.as_ref().map(|width| width.nominal));
        let said_open = fields.means(form::Slot::open);
        let open = self.open(&mut fields);
        let through = match fields.take(form::Slot::through) {
            Some(node) => self.problems.boolean(node),
            None => (!fields.means(form::Slot::through)).then_some(false),
        };
        let depth_node = fields.take(form::Slot::depth);
        let depth = match (depth_node, through, blank) {
            (Some(node), ..) => self.positive(node, "depth"),
            (None, Some(true), Some(blank)) => Some(blank.thickness),
            (None, Some(false), _) => {
                self.problems.missing(form::Slot::depth, place, note!("part-slot-has-depth-or-goes-through"))
            }
            _ => None,
        };
        let roughness = fields.need(form::Slot::roughness, self.problems).and_then(|node| self.roughness(node));
        let tolerance_node = fields.need(form::Slot::centre_tolerance, self.problems);
        let centre_tolerance = tolerance_node.and_then(|node| self.centre_tolerance(node));
        fields.finish(self.problems);

        let (at, slot) = match (run, &width, corner) {
            (Some(run), Some(width), Some(corner)) => match run.placed(width.nominal, corner) {
                Some((at, slot)) => (Some(at), Some(slot)),
                None if corner.is_some() => {
                    let message =
                        note!("part-pocket-length", name = name.as_deref().unwrap_or("?"), width = width.nominal);
                    return self.problems.error_help("bad-value", message, place, note!("part-pocket-turn"));
                }
                None => {
                    let message =
                        note!("part-slot-is-a-hole", name = name.as_deref().unwrap_or("?"), width = width.nominal);
                    return self.problems.error_help("bad-value", message, place, note!("part-slot-length-over-all"));
                }
            },
            _ => (None, None),
        };
        let (at, slot) = match (open, at.zip(slot), blank.zip(datum), &width) {
            (None, placed, ..) if !said_open => placed.unzip(),
            (Some((node, open)), Some((at, slot)), Some((blank, datum)), Some(width)) => {
                let beyond = |from: Point, to: Point| run_out(from, to, width.nominal.half(), blank, datum);
                match opened(at, slot, open, beyond) {
                    Some(placed) => Some(placed).unzip(),
                    None => {
                        let message = note!("part-slot-open-end", name = name.as_deref().unwrap_or("?"));
                        return self.problems.error_help(
                            "bad-value",
                            message,
                            &node.place,
                            note!("part-slot-open-help"),
                        );
                    }
                }
            }
            _ => (None, None),
        };
        let end = depth.unwrap_or(BoreSpan::FAR);
        let spans = width.iter().map(|width| BoreSpan::new(width.nominal, Micrometres::ZERO, end)).collect();
        let mut group = Group {
            name: name.clone().zip(name_node.map(|node| node.place.clone())),
            spans,
            depth: depth.zip(depth_node.map(|node| node.place.clone())),
            through,
            at: Some(Centres { place: place.clone(), pattern: false }),
            points: at.into_iter().map(|at| (at, place.clone())).collect(),
            slot: Some(slot.unwrap_or_default()),
            hole: None,
        };
        if let (Some(name), Some(diameter), Some(through), Some(depth)) = (name, width, through, depth)
            && let (Some(roughness), Some(centre_tolerance)) = (roughness, centre_tolerance)
            && let (Some(at), Some(slot)) = (at, slot)
        {
            group.hole = Some(Hole {
                name,
                diameter,
                depth,
                through,
                // A mill leaves it so.
                bottom: Bottom::Flat,
                roughness,
                centre_tolerance,
                chamfer: None,
                skin: false,
                thread: None,
                cone: None,
                counterbore: None,
                countersink: None,
                face: None,
                groove: None,
                state: BlankHole::Solid,
                outer_wall: false,
                steps: Vec::new(),
                slot: Some(slot),
                at: vec![at],
            });
        }
        Some(group)
    }

    /// Which ends are open.
    fn open<'n>(&mut self, fields: &mut Fields<'n, form::Slot>) -> Option<(&'n Node, Open)> {
        let node = fields.take(form::Slot::open)?;
        if fields.means(form::Slot::centre) || fields.means(form::Slot::length) || fields.means(form::Slot::corner) {
            return self.problems.error_help(
                "bad-value",
                note!("part-slot-open-by-ends"),
                &node.place,
                note!("part-slot-open-help"),
            );
        }
        let ends = [("from", Open::From), ("to", Open::To), ("both", Open::Both)];
        Some((node, self.choice(node, &ends)?))
    }

    /// The radius of the corners of a pocket, `Some(None)` of a slot; none where it is wrong.
    fn corner(
        &mut self,
        fields: &mut Fields<'_, form::Slot>,
        width: Option<Micrometres>,
    ) -> Option<Option<Micrometres>> {
        let Some(node) = fields.take(form::Slot::corner) else { return Some(None) };
        if fields.means(form::Slot::from) || fields.means(form::Slot::to) {
            let help = note!("part-pocket-by-centre");
            return self.problems.error_help("bad-value", note!("part-pocket-has-no-end-radii"), &node.place, help);
        }
        let corner = self.positive(node, "corner")?;
        if width.is_some_and(|width| corner >= width.half()) {
            let message = note!("part-pocket-corner", corner = corner, width = width.unwrap_or_default());
            return self.problems.error_help("bad-value", message, &node.place, note!("part-pocket-is-a-slot"));
        }
        Some(Some(corner))
    }

    /// Where it runs: said in one of two ways, and not in both.
    fn run(&mut self, fields: &mut Fields<'_, form::Slot>) -> Option<Run> {
        let by_ends = [form::Slot::from, form::Slot::to].map(|key| fields.means(key)) != [false; 2];
        let place: &Place = fields.place;
        if !by_ends && ![form::Slot::centre, form::Slot::length].iter().any(|key| fields.means(*key)) {
            return self.problems.missing(form::Slot::from, place, note!("part-slot-runs-somewhere"));
        }
        if by_ends {
            let foreign = [form::Slot::centre, form::Slot::length, form::Slot::angle];
            let said: Vec<(&str, &Node)> =
                foreign.into_iter().filter_map(|key| Some((key.name(), fields.take(key)?))).collect();
            let from = fields.need(form::Slot::from, self.problems).and_then(|node| self.point(node));
            let to = fields.need(form::Slot::to, self.problems).and_then(|node| self.point(node));
            if let Some((key, node)) = said.first() {
                let message = note!("part-slot-run-said-twice", key = *key);
                return self.problems.error_help("bad-value", message, &node.place, note!("part-keep-one-them"));
            }
            return Some(Run::Ends(from?, to?));
        }
        let centre = fields.need(form::Slot::centre, self.problems).and_then(|node| self.point(node));
        let length = self.need_size(fields, form::Slot::length);
        let angle = self.direction(fields, form::Slot::angle);
        Some(Run::Middle(centre?, length?, Turn::of_degrees(angle?)))
    }
}

#[cfg(test)]
mod tests {
    use crate::part::{OpenEnds, Part, Point, Slot, read_part};
    use crate::shipped;
    use crate::units::Micrometres;

    fn read(run: &str, more: &str) -> Result<Part, Vec<String>> {
        let text = format!(
            "part: P
material: steel-45
blank: {{kind: plate, length: 200, width: 100, thickness: 20}}
machine: gf2171
{more}
slots:
  - {{name: S, {run}, roughness: Ra 12.5, centre_tolerance: 0.4}}
"
        );
        let knowledge = shipped::knowledge().unwrap();
        read_part("part", &text, &knowledge).map_err(|problems| {
            let say = |note: &crate::note::Note| technolog_words::Lang::EN.say(note);
            problems.iter().map(|problem| problem.text(say)).collect()
        })
    }

    /// By hand: along a radius the middle of the mill stands its own radius, 6 mm, beyond the rim, at 106 of 100 mm; towards 3 : 4 at
    /// (63.6, 84.8). Beside the axis it leaves the rim aslant: from (80, 60) on along X until x² + 60² = 106², 87.384, 7.384 further.
    #[test]
    fn a_slot_runs_out_over_the_rim_of_a_disc() {
        let head = "part: P\nmaterial: steel-45\nblank: {kind: disc, diameter: 200, thickness: 20}\nmachine: gf2171\n";
        let knowledge = shipped::knowledge().unwrap();
        let begin = |run: &str| {
            let slot = format!("{{name: S, {run}, width: 12H12, depth: 8, roughness: Ra 12.5, centre_tolerance: 0.4}}");
            let part = read_part(
                "part",
                &format!("{head}fixture: {{own: chuck, height: 120}}\nslots:\n  - {slot}\n"),
                &knowledge,
            );
            part.ok().map(|part| part.holes[0].at[0])
        };
        let point = |x: i64, y: i64| Some(Point { x: Micrometres::new(x), y: Micrometres::new(y) });
        assert_eq!(begin("from: [40, 0], to: [100, 0], open: to"), point(106_000, 0));
        assert_eq!(begin("from: [30, 40], to: [60, 80], open: to"), point(63_600, 84_800));
        assert_eq!(begin("from: [0, 60], to: [80, 60], open: to"), point(87_384, 60_000));
        assert_eq!(begin("from: [30, 40], to: [57, 76], open: to"), None, "5 mm inside the rim");
    }

    #[test]
    fn both_ways_to_write_a_slot_say_the_same() {
        let mm = |mm: i64| Micrometres::from_mm(mm);
        let slot = |run: &str| {
            let part = read(&format!("{run}, width: 12H12, depth: 8"), "").unwrap();
            (part.holes[0].at[0], part.holes[0].slot.unwrap())
        };
        let lies = (Point { x: mm(-20), y: mm(10) }, Slot { x: mm(40), ..Slot::default() });
        assert_eq!(slot("from: [-20, 10], to: [20, 10]"), lies);
        assert_eq!(slot("centre: [0, 10], length: 52"), lies, "the length is over all");
        let stands = (Point { x: mm(0), y: mm(-10) }, Slot { y: mm(20), ..Slot::default() });
        // Open ends: 6 mm beyond the edge stands the middle of a mill as wide as the slot, and under 3 : 4 across an edge along X 7.5 mm
        // further along.
        let open = |x: i64, y: i64, first: i64, far: Option<i64>| {
            let um = Micrometres::new;
            Slot { x: um(x), y: um(y), corner: None, open: Some(OpenEnds { first: um(first), far: far.map(um) }) }
        };
        let to_right = (Point { x: mm(106), y: mm(0) }, open(-46_000, 0, 6_000, None));
        assert_eq!(slot("from: [60, 0], to: [100, 0], open: to"), to_right);
        assert_eq!(slot("from: [100, 0], to: [60, 0], open: from"), to_right);
        let across = (Point { x: mm(20), y: mm(-56) }, open(0, 112_000, 6_000, Some(6_000)));
        assert_eq!(slot("from: [20, -50], to: [20, 50], open: both"), across);
        let oblique = (Point { x: Micrometres::new(49_500), y: mm(56) }, open(-34_500, -46_000, 7_500, None));
        assert_eq!(slot("from: [15, 10], to: [45, 50], open: to"), oblique);
        assert_eq!(slot("centre: [0, 0], length: 32, angle: 90"), stands);
    }

    #[test]
    fn what_is_wrong_with_a_slot_is_told_once_each() {
        let hole = |at: &str| {
            format!(
                "holes:\n  - {{name: A, diameter: 10, through: true, roughness: Ra 12.5, centre_tolerance: 0.4, at: [{at}]}}"
            )
        };
        for (run, more, words) in [
            ("from: [0, 0], to: [40, 0], angle: 30, width: 12, depth: 5", "", "both by `from` and `to` and by `angle`"),
            ("from: [0, 0], width: 12, depth: 5", "", "`to`"),
            ("width: 12, depth: 5", "", "`from`"),
            ("centre: [0, 0], length: 12, width: 12, depth: 5", "", "is a round hole"),
            ("from: [0, 0], to: [0, 0], width: 12, depth: 5", "", "is a round hole"),
            ("from: [0, 0], to: [96, 0], width: 12, depth: 5", "", "is not inside the blank"),
            ("from: [0, 0], to: [99, 0], open: to, width: 12, depth: 5", "", "does not leave the blank"),
            ("from: [0, 0], to: [100, 0], open: from, width: 12, depth: 5", "", "does not leave the blank"),
            ("from: [96, 0], to: [100, 0], open: to, width: 12, depth: 5", "", "is not inside the blank"),
            ("from: [-100, 46], to: [100, 46], open: both, width: 12, depth: 5", "", "in its middle"),
            ("from: [0, 0], to: [100, 0], open: left, width: 12, depth: 5", "", "`left`"),
            ("centre: [80, 0], length: 60, open: both, width: 12, depth: 5", "", "`from` and `to`"),
            ("from: [0, 0], to: [40, 0], width: 12", "", "`depth`"),
            ("centre: [0, 0], length: 60, width: 40, corner: 20, depth: 5", "", "corner of 20 mm"),
            ("from: [0, 0], to: [40, 0], width: 40, corner: 8, depth: 5", "", "no end radii"),
            ("centre: [0, 0], length: 30, width: 40, corner: 8, depth: 5", "", "at least as long as it is wide"),
            (
                "centre: [0, 0], length: 40, angle: 30, width: 40, corner: 8, depth: 5",
                "",
                "at least as long as it is wide",
            ),
            ("centre: [60, 20], length: 60, angle: 45, width: 40, corner: 8, depth: 5", "", "is not inside the blank"),
            (
                "centre: [0, 0], length: 60, width: 40, corner: 8, depth: 5",
                &hole("[33, 18]"),
                "slot S runs into hole A",
            ),
            ("from: [0, 0], to: [40, 0], width: 12, depth: 20", "", "blind"),
            ("from: [0, 0], to: [40, 0], width: 12, depth: 5", &hole("[20, 10]"), "slot S runs into hole A"),
            (
                "from: [0, 0], to: [40, 0], width: 12, depth: 5",
                "fixture: {clamps: [{at: [20, 5]}, {at: [-90, 0]}]}",
                "presses on slot S",
            ),
            (
                "from: [0, 0], to: [40, 0], width: 12, depth: 5",
                "dimensions: [{from: left, to: S, tolerance: 0.2}]",
                "dimension of a slot",
            ),
        ] {
            let problems = read(run, more).unwrap_err();
            assert!(problems.len() == 1 && problems[0].contains(words), "{run} {more}: {problems:?}");
        }
        assert!(read("from: [0, 0], to: [40, 0], width: 12, depth: 5", &hole("[20, 11]")).is_ok(), "they touch");
        let pocket = "centre: [0, 0], length: 60, width: 40, corner: 8, depth: 5";
        assert!(read(pocket, &hole("[35, 18]")).is_ok(), "beside its end wall");
    }
}
