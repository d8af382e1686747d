//! The size limits of a part: with all of them a plan takes some seconds, and no workshop part has as much.
//! docs/limits.md lists them.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Node;
use technolog_note::{Note, note};

use super::Part;
use super::read::Reader;

/// Points of all groups together, in lists and patterns.
pub const MOST_POINTS: usize = 20_000;
/// Groups of equal holes.
pub const MOST_KINDS: usize = 500;
/// Cylinders of a stepped hole.
pub const MOST_STEPS: usize = 50;
/// Clamps.
pub const MOST_CLAMPS: usize = 100;
/// Obstacles beside them.
pub const MOST_OBSTACLES: usize = 100;
/// Dimensions of the drawing: two for each group, and the sizes of the blank.
pub const MOST_DIMENSIONS: usize = 1002;

/// The things whose number is limited.
#[derive(Clone, Copy)]
pub(super) enum LimitedCount {
    Points,
    Kinds,
    Steps,
    Clamps,
    Obstacles,
    Dimensions,
}

impl LimitedCount {
    const fn maximum(self) -> usize {
        match self {
            Self::Points => MOST_POINTS,
            Self::Kinds => MOST_KINDS,
            Self::Steps => MOST_STEPS,
            Self::Clamps => MOST_CLAMPS,
            Self::Obstacles => MOST_OBSTACLES,
            Self::Dimensions => MOST_DIMENSIONS,
        }
    }

    const fn code(self) -> &'static str {
        match self {
            Self::Points => "too-many-points",
            Self::Kinds => "too-many-kinds",
            Self::Steps => "too-many-steps",
            Self::Clamps => "too-many-clamps",
            Self::Obstacles => "too-many-obstacles",
            Self::Dimensions => "too-many-dimensions",
        }
    }

    /// The fault of a count above the limit, and the remedy.
    fn refusal(self, count: usize) -> Option<(Note, Note)> {
        let most = self.maximum();
        let message = match self {
            Self::Points => note!("part-too-many-points", count = count, most = most),
            Self::Kinds => note!("part-too-many-kinds", count = count, most = most),
            Self::Steps => note!("part-too-many-steps", count = count, most = most),
            Self::Clamps => note!("part-too-many-clamps", count = count, most = most),
            Self::Obstacles => note!("part-too-many-obstacles", count = count, most = most),
            Self::Dimensions => note!("part-too-many-dimensions", count = count, most = most),
        };
        (count > most).then(|| (message, note!("part-check-counts-or-split")))
    }
}

impl Reader<'_> {
    /// Refuses a count above the limit.
    pub(super) fn refuse_more(&mut self, counted: LimitedCount, count: usize, place: &Place) -> Option<()> {
        match counted.refusal(count) {
            Some((message, help)) => self.problems.error_help(counted.code(), message, place, help),
            None => Some(()),
        }
    }

    /// The items of a list up to the limit; a longer list is refused at its first extra item.
    pub(super) fn bounded<'n>(&mut self, counted: LimitedCount, items: &'n [Node]) -> &'n [Node] {
        if let Some(beyond) = items.get(counted.maximum()) {
            let _ = self.refuse_more(counted, items.len(), &beyond.place);
        }
        items.get(..counted.maximum()).unwrap_or(items)
    }

    /// Counts the points of a list or a pattern before they are made; none if they are too many, which is reported
    /// once.
    pub(super) fn room_for(&mut self, points: usize, node: &Node) -> Option<()> {
        let before = self.counted_points;
        self.counted_points = before.saturating_add(points);
        if before > MOST_POINTS {
            return None;
        }
        self.refuse_more(LimitedCount::Points, self.counted_points, &node.place)
    }
}

impl Part {
    /// The count that is above its limit, in words, and the remedy; for a part that was not read by
    /// [`super::read_part`].
    pub fn beyond_bounds(&self) -> Option<(Note, Note)> {
        let points = self.holes.iter().map(|hole| hole.at.len()).sum();
        let steps = self.holes.iter().map(|hole| hole.steps.len()).max().unwrap_or_default();
        let counts = [
            (LimitedCount::Points, points),
            (LimitedCount::Kinds, self.holes.len()),
            (LimitedCount::Steps, steps),
            (LimitedCount::Clamps, self.fixture.clamps.len()),
            (LimitedCount::Obstacles, self.fixture.obstacles.len()),
            (LimitedCount::Dimensions, self.dimensions.len()),
        ];
        counts.into_iter().find_map(|(what, count)| what.refusal(count))
    }
}

#[cfg(test)]
mod tests {
    use technolog_words::Lang;

    use super::*;
    use crate::part::read_part;
    use crate::shipped;

    const HEAD: &str = "part: P\nmaterial: steel-45\nmachine: gf2171\ndatum: {x: left, y: front}\n\
                        blank: {kind: plate, length: 4000, width: 4000, thickness: 60}\n";

    fn group(name: usize, keys: &str) -> String {
        format!("  - {{name: A{name}, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, {keys}}}\n")
    }

    /// Points of a list, 10 mm apart, beginning at a row.
    fn list(points: usize, row: usize) -> String {
        let place = |point: usize| format!("[{}, {}]", 10 + 10 * (point % 390), 10 + 10 * (row + point / 390));
        format!("at: [{}]", (0..points).map(place).collect::<Vec<_>>().join(", "))
    }

    /// The part, or each problem with its code and place.
    fn read(text: &str) -> Result<Part, Vec<String>> {
        let text_of = |problem: &crate::knowledge::Diagnostic| problem.text(|note| Lang::EN.say(note));
        read_part("p", text, &shipped::knowledge().unwrap()).map_err(|problems| problems.iter().map(text_of).collect())
    }

    fn refused(text: &str) -> String {
        let problems = read(text).unwrap_err();
        assert_eq!(problems.len(), 1, "{problems:?}");
        problems.into_iter().next().unwrap()
    }

    #[test]
    fn as_many_points_as_the_bound_are_read_and_one_more_is_refused() {
        let pattern = "pattern: {grid: {start: [10, 2010], columns: 100, rows: 100, step: 10}}";
        let text = |points: usize| {
            let groups = [group(1, &list(points, 0)), group(2, pattern)];
            format!("{HEAD}holes:\n{}", groups.concat().replace("through", "diameter: 5, through"))
        };
        let part = read(&text(10_000)).unwrap();
        assert_eq!(part.holes.iter().map(|hole| hole.at.len()).sum::<usize>(), MOST_POINTS);
        assert_eq!(part.beyond_bounds(), None);
        let messages = refused(&text(10_001));
        assert!(messages.contains("the part has 20001 points, and may have 20000 [too-many-points]; "), "{messages}");
        assert!(messages.starts_with("p:8:"), "at the pattern: {messages}");
        // Reported once, though the pattern after the list is too large as well.
        let messages = refused(&text(100_000));
        assert!(messages.contains("the part has 100000 points") && messages.starts_with("p:7:"), "{messages}");
        let mut part = part;
        let again = part.holes[1].at.clone();
        part.holes[0].at.extend(again);
        let (message, _) = part.beyond_bounds().unwrap();
        assert_eq!(Lang::EN.say(&message), "the part has 30000 points, and may have 20000");
    }

    #[test]
    fn as_many_kinds_of_holes_as_the_bound_are_read_and_one_more_is_refused() {
        let text = |kinds: usize| {
            let groups = (0..kinds).map(|kind| group(kind, &list(1, kind)).replace("through", "diameter: 5, through"));
            format!("{HEAD}holes:\n{}", groups.collect::<String>().replace("[10, ", "[100, "))
        };
        assert_eq!(read(&text(390)).unwrap().holes.len(), 390);
        let messages = refused(&text(MOST_KINDS + 1).replace("4000, width: 4000", "9000, width: 9000"));
        assert!(messages.contains("has 501 kinds of holes, and may have 500 [too-many-kinds]; "), "{messages}");
        assert!(messages.starts_with(&format!("p:{}:5: ", 6 + MOST_KINDS + 1)), "{messages}");
        assert_eq!(read(&text(MOST_KINDS).replace("4000, width: 4000", "9000, width: 9000")).unwrap().holes.len(), 500);
    }

    #[test]
    fn as_many_steps_and_clamps_as_the_bounds_are_read_and_one_more_is_refused() {
        let text = |steps: usize, clamps: usize| {
            let step = |at: usize| format!("{{diameter: {}, length: 1}}", 70 - at);
            let steps: Vec<String> = (0..steps).map(step).collect();
            let clamp = |at: usize| format!("{{at: [{}, 3900]}}", 10 + at);
            let clamps: Vec<String> = (0..clamps).map(clamp).collect();
            let hole = group(1, &format!("diameter: 10, steps: [{}], {}", steps.join(", "), "at: [[100, 100]]"));
            format!("{HEAD}fixture: {{clamps: [{}]}}\nholes:\n{hole}", clamps.join(", "))
        };
        let part = read(&text(MOST_STEPS, MOST_CLAMPS)).unwrap();
        assert_eq!((part.holes[0].steps.len(), part.fixture.clamps.len()), (MOST_STEPS, MOST_CLAMPS));
        let messages = refused(&text(MOST_STEPS + 1, 1));
        assert!(messages.contains("has 51 steps, and may have 50 [too-many-steps]; "), "{messages}");
        let messages = refused(&text(1, MOST_CLAMPS + 1));
        assert!(messages.contains("has 101 clamps, and may have 100 [too-many-clamps]; "), "{messages}");
    }
}
