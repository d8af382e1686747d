//! Reads how a part is held: its clamps, and what else stands over its face.

use technolog_note::note;

use super::file;
use super::limits::LimitedCount;
use super::read::Reader;
use super::{Clamp, Fixture, Holding, Obstacle, PinHole, Point};
use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Node;
use crate::tables::materials::ClampScrew;

impl Reader<'_> {
    /// Reads the fixture; the points of the clamps are added to `placed` with their places, and the holes of pins to `pinned`.
    pub(super) fn fixture(
        &mut self,
        node: &Node,
        placed: &mut Vec<(Point, Place)>,
        pinned: &mut Vec<(PinHole, Place)>,
    ) -> Option<Fixture> {
        let mut fields = self.problems.map(node)?;
        let height = self.size(&mut fields, file::Fixture::height);
        let clamps_node = fields.take(file::Fixture::clamps);
        let pins = fields.take(file::Fixture::pins);
        let obstacles = fields.take(file::Fixture::obstacles);
        let retract = self.size(&mut fields, file::Fixture::retract);
        let own_node = fields.take(file::Fixture::own);
        let holding_node = fields.take(file::Fixture::holding);
        fields.finish(self.problems);
        let own = own_node.and_then(|node| self.name(node));
        if let (Some(own), Some(_)) = (own_node, clamps_node) {
            let help = note!("part-keep-one-them");
            self.problems.error_help::<()>("bad-value", note!("part-own-fixture-and-clamps"), &own.place, help);
        }
        let holding = holding_node.and_then(|node| self.choice(node, Holding::NAMES));
        // Each of them says otherwise what holds the part, or where it lies.
        if let (Some(node), Some(_)) = (holding_node, own_node.or(clamps_node).or(pins)) {
            let help = note!("part-keep-one-them");
            self.problems.error_help::<()>("bad-value", note!("part-chuck-and-other-holding"), &node.place, help);
        }
        if let (Some(pins), None) = (pins, height) {
            let help = note!("part-pins-say-height");
            self.problems.error_help::<()>("missing-key", note!("part-pins-need-height"), &pins.place, help);
        }
        // What a fixture of the shop's own has under the part nobody can guess.
        if let (Some(own), None, None) = (own_node, height, pins) {
            let help = note!("part-pins-say-height");
            self.problems.error_help::<()>("missing-key", note!("part-own-needs-height"), &own.place, help);
        }
        pinned.extend(pins.map(|node| self.pins(node)).unwrap_or_default());
        let obstacles = obstacles.map(|node| self.obstacles(node)).unwrap_or_default();
        let mut clamps = Vec::new();
        let nodes = clamps_node.and_then(|node| self.problems.list(node)).unwrap_or_default();
        for node in self.bounded(LimitedCount::Clamps, nodes) {
            let Some(mut fields) = self.problems.map(node) else { continue };
            let at_node = fields.need(file::Clamp::at, self.problems);
            let at = at_node.and_then(|node| self.point(node));
            placed.extend(at.zip(at_node.map(|node| node.place.clone())));
            let screw = fields.take(file::Clamp::screw).and_then(|node| self.screw(node));
            let height = self.size(&mut fields, file::Clamp::height);
            let outline = fields.take(file::Clamp::outline).and_then(|node| self.outline(node));
            fields.finish(self.problems);
            clamps.extend(at.map(|at| Clamp { at, screw, height, outline }));
        }
        let pins = pinned.iter().map(|(pin, _)| pin.clone()).collect();
        Some(Fixture { height, clamps, pins, obstacles, retract, own, holding })
    }

    /// One or two holes of pins: a third pin would hold what two hold already.
    fn pins(&mut self, node: &Node) -> Vec<(PinHole, Place)> {
        let nodes = self.problems.list(node).unwrap_or_default();
        if !(1..=2).contains(&nodes.len()) {
            let message = note!("part-one-or-two-pins", count = nodes.len());
            self.problems.error::<()>("bad-value", message, &node.place);
            return Vec::new();
        }
        let mut pins = Vec::new();
        for node in nodes {
            let Some(mut fields) = self.problems.map(node) else { continue };
            let at = fields.need(file::PinHole::at, self.problems).and_then(|node| self.point(node));
            let diameter = fields.need(file::PinHole::diameter, self.problems).and_then(|node| self.diameter(node));
            fields.finish(self.problems);
            pins.extend(at.zip(diameter).map(|(at, diameter)| (PinHole { at, diameter }, node.place.clone())));
        }
        pins
    }

    fn obstacles(&mut self, node: &Node) -> Vec<Obstacle> {
        let nodes = self.problems.list(node).unwrap_or_default();
        let mut obstacles = Vec::new();
        for node in self.bounded(LimitedCount::Obstacles, nodes) {
            let Some(mut fields) = self.problems.map(node) else { continue };
            let outline = fields.need(file::Obstacle::outline, self.problems).and_then(|node| self.outline(node));
            let height = self.need_size(&mut fields, file::Obstacle::height);
            let set_up = match fields.take(file::Obstacle::set_up) {
                None => Some(1),
                Some(node) => self.set_up(node),
            };
            fields.finish(self.problems);
            if let (Some(outline), Some(height), Some(set_up)) = (outline, height, set_up) {
                obstacles.push(Obstacle { outline, height, set_up });
            }
        }
        obstacles
    }

    fn set_up(&mut self, node: &Node) -> Option<u32> {
        let number = self.problems.scalar::<i64>(node)?;
        match u32::try_from(number) {
            Ok(number @ 1..=2) => Some(number),
            _ => self.problems.error("bad-value", note!("part-set-up-is-1-or-2", number = number), &node.place),
        }
    }

    /// Two opposite corners of a rectangle, the lowest first.
    fn outline(&mut self, node: &Node) -> Option<[Point; 2]> {
        let corners: Vec<Point> = self.problems.list(node)?.iter().filter_map(|node| self.point(node)).collect();
        match corners[..] {
            [a, b] if a.x != b.x && a.y != b.y => {
                Some([Point { x: a.x.min(b.x), y: a.y.min(b.y) }, Point { x: a.x.max(b.x), y: a.y.max(b.y) }])
            }
            _ => self.problems.error("bad-value", note!("part-outline-has-two-corners"), &node.place),
        }
    }

    pub(super) fn screw(&mut self, node: &Node) -> Option<String> {
        // Cyrillic М is typed as often as the Latin letter.
        let text = self.problems.text(node)?.replace('М', "M");
        let screws: Vec<ClampScrew<'_>> = self.knowledge.rows().ok()?;
        let names: Vec<&str> = screws.iter().map(|screw| screw.thread).collect();
        if names.contains(&text.as_str()) {
            return Some(text);
        }
        let message = note!("part-no-clamp-screw", text = text);
        self.problems.error_help(
            "unknown-screw",
            message,
            &node.place,
            note!("planfile-known", known = names.join(", ")),
        )
    }
}
