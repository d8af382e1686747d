//! Stepped holes: the cylinders as written, from the entry face inwards; [`super::arrange_steps`] finds the main one.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Fields, Node};
use crate::units::{Micrometres, Roughness};
use technolog_note::{Note, note};

use super::Bottom;
use super::arrange_steps::{Cylinder, Cylinders};
use super::file::hole as form;
use super::limits::LimitedCount;
use super::read::Reader;
use super::read_diameter::Sized;

/// The values of the group besides its steps.
pub(super) struct GroupValues<'a> {
    /// Its own diameter or thread, if it gives one.
    pub diameter: Option<Sized>,
    pub through: bool,
    /// The blank's thickness, or a blind hole's `depth`.
    pub depth: Option<Micrometres>,
    /// The roughness of cylinders that give none: absent, unreadable or given.
    pub roughness: Option<Option<Roughness>>,
    pub bottom: Option<Bottom>,
    pub chamfer: Option<(Micrometres, Place)>,
    /// Where the group begins.
    pub place: &'a Place,
}

/// The help for every mistake in the depths of steps.
pub(super) fn depth_or_length() -> Note {
    note!("part-depth-counts-from-entry-face-2")
}

impl Reader<'_> {
    /// The cylinders of a stepped hole.
    pub(super) fn steps(&mut self, items: &[Node], whole: GroupValues<'_>) -> Option<Cylinders> {
        if self.bounded(LimitedCount::Steps, items).len() < items.len() {
            return None;
        }
        let mut cylinders = Vec::new();
        // The end of the step before; unknown after a mistake.
        let mut start = Some(Micrometres::ZERO);
        for (index, item) in items.iter().enumerate() {
            let (cylinder, end) = self.step(item, index + 1, index + 1 == items.len(), start, &whole);
            cylinders.push(cylinder);
            start = end;
        }
        let mut cylinders: Vec<Cylinder> = cylinders.into_iter().collect::<Option<_>>()?;
        let written_end = cylinders.last()?.end;
        let inner = self.innermost(&mut cylinders, &whole)?;
        if !inner && let Some(depth) = whole.depth.filter(|depth| *depth != written_end) {
            let message = if whole.through {
                note!("part-steps-end-at-but-blank", written_end = written_end, depth = depth)
            } else {
                note!("part-steps-end-at-but-hole", written_end = written_end, depth = depth)
            };
            let place = &cylinders.last()?.place;
            return self.problems.error_help("bad-depth", message, place, depth_or_length());
        }
        self.check_narrowing(&cylinders, whole.through)?;
        self.arrange(cylinders, whole)
    }

    /// One step, and where it ends.
    fn step(
        &mut self,
        node: &Node,
        number: usize,
        last: bool,
        start: Option<Micrometres>,
        whole: &GroupValues<'_>,
    ) -> (Option<Cylinder>, Option<Micrometres>) {
        let Some(mut fields) = self.problems.map(node) else { return (None, None) };
        let sized = self.sized(&mut fields, form::Step::thread, form::Step::diameter, true);
        let end = self.step_end(&mut fields, number, last, start, whole);
        let roughness = match (fields.take(form::Step::roughness), whole.roughness) {
            (Some(node), _) => self.roughness(node),
            (None, Some(default)) => default,
            (None, None) => match &sized {
                Some(Sized { thread: Some(_), place, .. }) => self.thread_roughness(place),
                Some(_) => {
                    let help = note!("part-give-here-hole-for-all");
                    self.problems.missing(form::Step::roughness, &node.place, help)
                }
                None => None,
            },
        };
        let bottoms = &[("flat", Bottom::Flat), ("free", Bottom::Free)];
        let bottom = fields.take(form::Step::bottom).and_then(|node| self.choice(node, bottoms));
        let chamfer = self.size(&mut fields, form::Step::chamfer);
        fields.finish(self.problems);
        let cylinder = sized.zip(end).zip(roughness).map(|((sized, end), roughness)| Cylinder {
            diameter: sized.diameter,
            thread: sized.thread,
            roughness,
            bottom,
            chamfer,
            end,
            place: node.place.clone(),
        });
        (cylinder, end)
    }

    fn step_end(
        &mut self,
        fields: &mut Fields<'_, form::Step>,
        number: usize,
        last: bool,
        start: Option<Micrometres>,
        whole: &GroupValues<'_>,
    ) -> Option<Micrometres> {
        match (fields.take(form::Step::depth), fields.take(form::Step::length)) {
            (Some(_), Some(node)) => {
                let message = note!("part-depth-length-both-say-where");
                self.problems.error_help("bad-value", message, &node.place, note!("part-keep-one-them"))
            }
            (None, Some(node)) => {
                let length = self.positive(node, "length")?;
                Some(start? + length)
            }
            (Some(node), None) => {
                let end = self.positive(node, "depth")?;
                if let Some(start) = start.filter(|start| end <= *start) {
                    let message = note!("part-step-ends-at-one-before", number = number, end = end, start = start);
                    return self.problems.error_help("bad-depth", message, &node.place, depth_or_length());
                }
                Some(end)
            }
            (None, None) if last && whole.through => {
                let end = whole.depth?;
                if let Some(start) = start.filter(|start| end <= *start) {
                    let message = note!("part-step-before-last-ends-at", start = start, end = end);
                    return self.problems.error_help("bad-depth", message, fields.place, depth_or_length());
                }
                Some(end)
            }
            (None, None) => {
                let help = note!("part-length-only-last-step-through");
                self.problems.missing(form::Step::depth, fields.place, help)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::part::{Bottom, Face, Hole, read_part};
    use crate::shipped;
    use crate::units::Micrometres;

    /// A group with these keys in a plate 40 mm thick; its mistakes as text.
    fn read(keys: &str) -> Result<Hole, Vec<String>> {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 200, width: 100, thickness: 40}}\n\
             holes:\n  - {{name: A, centre_tolerance: 0.5, at: [[0, 0]], {keys}}}\n"
        );
        match read_part("part", &text, &shipped::knowledge().unwrap()) {
            Ok(mut part) => Ok(part.holes.remove(0)),
            Err(problems) => {
                Err(problems.iter().map(|problem| problem.text(|note| technolog_words::Lang::EN.say(note))).collect())
            }
        }
    }

    fn um(mm: i64) -> Micrometres {
        Micrometres::from_mm(mm)
    }

    /// The steps beside the main cylinder: diameter, face, depth.
    fn steps(hole: &Hole) -> Vec<(Micrometres, Face, Micrometres)> {
        hole.steps.iter().map(|step| (step.diameter.nominal, step.face, step.depth)).collect()
    }

    #[test]
    fn the_narrowest_cylinder_is_the_main_one() {
        let (ra, entry, back) = ("roughness: Ra 12.5", Face::Entry, Face::Back);
        for (keys, diameter, depth, through, expected) in [
            (
                "steps: [{diameter: 20, length: 10}, {diameter: 10H12, length: 15}]",
                10,
                25,
                false,
                vec![(20, entry, 10)],
            ),
            (
                "steps: [{diameter: 20, depth: 10}, {diameter: 10, depth: 25}], depth: 25",
                10,
                25,
                false,
                vec![(20, entry, 10)],
            ),
            ("through: true, steps: [{diameter: 20, depth: 10}, {diameter: 10}]", 10, 40, true, vec![(20, entry, 10)]),
            ("through: true, steps: [{diameter: 10, depth: 30}, {diameter: 20}]", 10, 40, true, vec![(20, back, 10)]),
            (
                "through: true, steps: [{diameter: 30, length: 5}, {diameter: 20, length: 5}, {diameter: 10, length: 12}, \
                 {diameter: 15, depth: 30}, {diameter: 25}]",
                10,
                40,
                true,
                vec![(30, entry, 5), (20, entry, 10), (15, back, 18), (25, back, 10)],
            ),
            // The own diameter of the hole, among the steps and after the last.
            (
                "diameter: 10, through: true, steps: [{diameter: 20, depth: 10}, {diameter: 10}]",
                10,
                40,
                true,
                vec![(20, entry, 10)],
            ),
            ("diameter: 10, through: true, steps: [{diameter: 20, depth: 10}]", 10, 40, true, vec![(20, entry, 10)]),
            ("diameter: 10, depth: 30, steps: [{diameter: 20, depth: 10}]", 10, 30, false, vec![(20, entry, 10)]),
        ] {
            let hole = read(&format!("{ra}, {keys}")).unwrap_or_else(|problems| panic!("{keys}: {problems:?}"));
            assert_eq!((hole.diameter.nominal, hole.depth, hole.through), (um(diameter), um(depth), through), "{keys}");
            let expected: Vec<_> = expected.into_iter().map(|(wide, face, deep)| (um(wide), face, um(deep))).collect();
            assert_eq!(steps(&hole), expected, "{keys}");
        }
    }

    #[test]
    fn a_step_has_what_it_says_and_else_what_the_hole_says() {
        let hole = read(
            "roughness: Ra 12.5, chamfer: 1, depth: 30, bottom: flat, steps: [{diameter: 30H11, depth: 5, bottom: free}, \
             {diameter: 20, depth: 10, roughness: Ra 2.5, chamfer: 0.5}, {diameter: 10, depth: 30}]",
        )
        .unwrap();
        let [first, second] = hole.steps.as_slice() else { panic!("{:?}", hole.steps) };
        assert_eq!(
            (first.bottom, first.chamfer, first.roughness),
            (Bottom::Free, Some(um(1)), "Ra 12.5".parse().unwrap())
        );
        assert_eq!((second.bottom, second.roughness), (Bottom::Flat, "Ra 2.5".parse().unwrap()));
        assert_eq!(second.chamfer, Some(Micrometres::new(500)));
        assert_eq!((hole.bottom, hole.chamfer, first.diameter.written.as_str()), (Bottom::Flat, None, "30H11"));
    }

    #[test]
    fn a_thread_says_the_diameter_of_its_hole_and_its_step() {
        // ISO 965-2: the minor diameter of M8-6H is 6.912 at most.
        for keys in ["", "diameter: 8, ", "diameter: 6.8, ", "diameter: Ø8, roughness: Ra 6.3, "] {
            let hole = read(&format!("{keys}thread: M8-6H, depth: 20")).unwrap();
            let diameter = &hole.diameter;
            assert_eq!((diameter.nominal, diameter.upper), (Micrometres::new(6_800), Micrometres::new(112)), "{keys}");
            assert_eq!((diameter.it.number(), diameter.to_string().as_str()), (9, "M8-6H"), "{keys}");
            assert_eq!(hole.roughness, "Ra 6.3".parse().unwrap());
            assert_eq!(hole.thread.map(|thread| thread.id).as_deref(), Some("M8"));
        }
        assert_eq!(read("thread: M3, depth: 8").unwrap().diameter.nominal, Micrometres::new(2_500));
        let stepped =
            read("through: true, steps: [{thread: M20, length: 15}, {diameter: 10, roughness: Ra 12.5}]").unwrap();
        assert_eq!(stepped.steps[0].thread.as_ref().unwrap().id, "M20");
        assert_eq!((stepped.steps[0].diameter.nominal, stepped.thread), (Micrometres::new(17_500), None));
        let own = read("thread: M8, through: true, steps: [{diameter: 20, length: 15, roughness: Ra 12.5}]").unwrap();
        assert_eq!((own.diameter.nominal, own.depth), (Micrometres::new(6_800), um(40)));
        assert!(own.thread.is_some() && own.steps[0].thread.is_none());
    }

    #[test]
    fn what_is_wrong_with_steps_is_said_once() {
        let ra = "roughness: Ra 12.5";
        for (keys, words) in [
            ("steps: [{diameter: 20, depth: 10}, {diameter: 10, depth: 5}]", "`length` is the step's own"),
            (
                "depth: 30, steps: [{diameter: 20, depth: 10}, {diameter: 10, depth: 20}]",
                "end at 20, but the hole is 30",
            ),
            (
                "through: true, steps: [{diameter: 20, depth: 10}, {diameter: 10, length: 20}]",
                "end at 30, but the blank is 40",
            ),
            ("through: true, steps: [{diameter: 20, depth: 40}, {diameter: 10}]", "[bad-depth]"),
            ("steps: [{diameter: 20, depth: 10}, {diameter: 10}]", "only the last step of a through hole"),
            ("steps: [{diameter: 20, depth: 10, length: 10}]", "keep one of them"),
            ("steps: [{depth: 10}]", "`diameter` is missing"),
            ("steps: [{diameter: 20, depth: 10}, {diameter: 20, depth: 20}]", "join the two"),
            ("steps: [{diameter: 10, depth: 10}, {diameter: 20, depth: 20}]", "[inner-step]"),
            (
                "through: true, steps: [{diameter: 10, depth: 10}, {diameter: 20, depth: 20}, {diameter: 8}]",
                "[inner-step]",
            ),
            (
                "through: true, steps: [{diameter: 10, depth: 9}, {diameter: 20, depth: 20}, {diameter: 10}]",
                "give it as `groove`",
            ),
            ("diameter: 20, steps: [{diameter: 20, depth: 10}, {diameter: 10, depth: 20}]", "wider than Ø10"),
            (
                "diameter: 10H7, steps: [{diameter: 20, depth: 10}, {diameter: 10, depth: 20}]",
                "Ø10H7 of the hole is Ø10 in",
            ),
            ("diameter: 10, steps: [{diameter: 20, depth: 10}]", "`depth` is missing"),
            ("diameter: 10, depth: 10, steps: [{diameter: 20, depth: 10}]", "leaves nothing"),
            ("steps: [{diameter: 20, depth: 10, deep: 1}]", "[unknown-key]"),
            ("chamfer: 1, steps: [{diameter: 20, depth: 10, chamfer: 2}]", "2 in the first step"),
            ("steps: 5", "a list is expected"),
            ("thread: M8, diameter: 7, depth: 20", "M8 is Ø8 and the hole under it Ø6.8"),
            ("thread: M9, depth: 20", "[unknown-thread]"),
        ] {
            let problems = read(&format!("{ra}, {keys}")).map(|hole| panic!("{keys}: {hole:?}")).unwrap_err();
            assert_eq!(problems.len(), 1, "{keys}: {problems:?}");
            assert!(problems[0].contains(words), "{keys}: {problems:?}");
        }
        let without = read("depth: 10, steps: [{diameter: 20, depth: 10}]").unwrap_err();
        assert!(without[0].contains("`roughness` is missing") && without.len() == 1, "{without:?}");
    }
}
