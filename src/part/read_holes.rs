//! The groups of holes in a part file.

use crate::knowledge::Column;
use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Node, NodeKind};
use crate::units::ItGrade;

use super::check::Group;
use super::read::{COUNTERBORE, COUNTERSINK, DIAMETER, HOLE, NOT_PLANNED, PATTERN, Reader};
use super::{Blank, BlankHole, Bottom, CentreTolerance, Hole, Point, ToleratedDiameter};

impl Reader<'_> {
    pub(super) fn groups(&mut self, node: &Node, blank: Option<&Blank>) -> Vec<Group> {
        let items = self.problems.list(node).unwrap_or_default();
        if items.is_empty() && matches!(node.kind, NodeKind::Seq(_)) {
            self.problems.error_help::<()>(
                "bad-value",
                "the part has no holes",
                &node.place,
                "give at least one group",
            );
        }
        items.iter().filter_map(|item| self.group(item, blank)).collect()
    }

    fn group(&mut self, node: &Node, blank: Option<&Blank>) -> Option<Group> {
        let mut fields = self.problems.map(node)?;
        let name_node = fields.need("name", self.problems);
        let name = name_node.and_then(|node| self.name(node));
        let diameter = fields.need("diameter", self.problems).and_then(|node| self.diameter(node));
        let through = match fields.take("through") {
            Some(node) => self.problems.boolean(node),
            None => Some(false),
        };
        let depth_node = fields.take("depth");
        let depth = match (depth_node, through, blank) {
            (Some(node), ..) => self.positive(node, "depth"),
            (None, Some(true), Some(blank)) => Some(blank.thickness),
            (None, Some(false), _) => self.problems.error_help(
                "missing-key",
                "the key `depth` is missing",
                fields.place,
                "a blind hole has a depth; a through hole `through: true`",
            ),
            _ => None,
        };
        let bottom = match fields.take("bottom") {
            Some(node) => self.choice(node, &[("flat", Bottom::Flat), ("free", Bottom::Free)]),
            None => Some(Bottom::default()),
        };
        let roughness = fields.need("roughness", self.problems).and_then(|node| self.problems.scalar(node));
        let centre_tolerance =
            fields.need("centre_tolerance", self.problems).and_then(|node| self.centre_tolerance(node));
        let chamfer = fields.take("chamfer").and_then(|node| self.positive(node, "chamfer"));
        let skin = match fields.take("skin") {
            Some(node) => self.problems.boolean(node),
            None => Some(false),
        };
        let mut not_planned = Vec::new();
        for &key in NOT_PLANNED {
            if let Some(node) = fields.take(key)
                && self.asks_for_more(key, node)
            {
                not_planned.push(key.to_owned());
            }
        }
        let patterned = not_planned.iter().any(|key| key == "pattern");
        let at_node = if patterned { fields.take("at") } else { fields.need("at", self.problems) };
        if let (Some(node), true) = (at_node, patterned) {
            let message = "`at` and `pattern` both say where the holes are";
            self.problems.error_help::<()>("bad-value", message, &node.place, "keep one of them");
        }
        let points = at_node.map(|node| self.points(node)).unwrap_or_default();
        fields.finish(HOLE, self.problems);
        let mut group = Group {
            name: name.clone().zip(name_node.map(|node| node.place.clone())),
            diameter: diameter.as_ref().map(|diameter| diameter.nominal),
            depth: depth.zip(depth_node.map(|node| node.place.clone())),
            through,
            at: at_node.map(|node| node.place.clone()),
            points,
            hole: None,
        };
        if let (Some(name), Some(diameter), Some(depth), Some(through)) = (name, diameter, depth, through)
            && let (Some(bottom), Some(roughness), Some(skin)) = (bottom, roughness, skin)
            && let Some(centre_tolerance) = centre_tolerance
        {
            let at = group.points.iter().map(|(point, _)| *point).collect();
            group.hole = Some(Hole {
                name,
                diameter,
                depth,
                through,
                bottom,
                roughness,
                centre_tolerance,
                chamfer,
                skin,
                thread: None,
                cone: None,
                counterbore: None,
                countersink: None,
                face: None,
                groove: None,
                state: BlankHole::Solid,
                outer_wall: false,
                steps: Vec::new(),
                at,
            });
        }
        Some(group)
    }

    /// Checks a key that is not planned yet, and says whether its value asks for something.
    fn asks_for_more(&mut self, key: &str, node: &Node) -> bool {
        match key {
            "thread" => self.name(node).is_some(),
            "state" => {
                let solid = self.choice(node, &[("solid", true), ("cast", false), ("pre-machined", false)]);
                solid == Some(false)
            }
            "state_diameter" => self.positive(node, key).is_some(),
            "outer_wall" => self.problems.boolean(node) == Some(true),
            "counterbore" => self.feature(node, COUNTERBORE),
            "countersink" => self.feature(node, COUNTERSINK),
            "pattern" => self.pattern(node),
            "steps" => {
                let items = self.problems.list(node).unwrap_or_default();
                items.iter().filter(|item| self.problems.map(item).is_some()).count() > 0
            }
            _ => self.problems.map(node).is_some(),
        }
    }

    /// A feature at the entry: sizes that must all be there, mm or degrees.
    fn feature(&mut self, node: &Node, sizes: &[&str]) -> bool {
        let Some(mut fields) = self.problems.map(node) else { return false };
        for name in sizes {
            if let Some(node) = fields.need(name, self.problems) {
                self.positive(node, name);
            }
        }
        fields.finish(sizes, self.problems);
        true
    }

    fn pattern(&mut self, node: &Node) -> bool {
        let Some(mut fields) = self.problems.map(node) else { return false };
        let kinds =
            PATTERN.iter().filter(|kind| fields.take(kind).is_some_and(|node| self.problems.map(node).is_some()));
        let count = kinds.count();
        fields.finish(PATTERN, self.problems);
        if count > 1 {
            self.problems.error_help::<()>("bad-value", "a pattern is of one kind", &node.place, "keep one of them");
        }
        true
    }

    fn points(&mut self, node: &Node) -> Vec<(Point, Place)> {
        let items = self.problems.list(node).unwrap_or_default();
        let scalars = items.iter().all(|item| matches!(item.kind, NodeKind::Scalar { .. }));
        if matches!(node.kind, NodeKind::Seq(_)) && scalars {
            let message =
                if items.is_empty() { "the group has no points" } else { "a list of points is expected here" };
            let help = "give each point in brackets of its own: [[X, Y], [X, Y]]";
            self.problems.error_help::<()>("bad-value", message, &node.place, help);
            return Vec::new();
        }
        items.iter().filter_map(|item| self.point(item).map(|point| (point, item.place.clone()))).collect()
    }

    fn diameter(&mut self, node: &Node) -> Option<ToleratedDiameter> {
        let diameter = if matches!(node.kind, NodeKind::Map(_)) {
            let mut fields = self.problems.map(node)?;
            let nominal = fields.need("nominal", self.problems).and_then(|node| self.positive(node, "nominal"));
            let upper = fields.need("upper", self.problems).and_then(|node| self.problems.scalar(node));
            let lower = fields.need("lower", self.problems).and_then(|node| self.problems.scalar(node));
            fields.finish(DIAMETER, self.problems);
            ToleratedDiameter::from_limits(nominal?, upper?, lower?, self.knowledge)
        } else {
            ToleratedDiameter::parse(self.problems.text(node)?, self.knowledge)
        };
        match diameter {
            Ok(diameter) => Some(diameter),
            Err(message) => self.problems.error("bad-diameter", message, &node.place),
        }
    }

    fn centre_tolerance(&mut self, node: &Node) -> Option<CentreTolerance> {
        // Cyrillic ІТ looks like the Latin letters and is typed as often.
        let text = self.problems.text(node)?.to_uppercase().replace('І', "I").replace('Т', "T");
        if let Some(grade) = text.strip_prefix("IT") {
            let it = grade.trim().parse().ok().and_then(ItGrade::new).filter(|it| (5..=14).contains(&it.number()));
            if it.is_none() {
                let message = format!("`{text}` is outside IT5 to IT14, which the table it-grades covers");
                return self.problems.error("bad-value", message, &node.place);
            }
            return it.map(|it| CentreTolerance::Grade { it });
        }
        let width = self.positive(node, "centre_tolerance")?;
        // The columns of the scheme tables end there; such a figure is a slip of the decimal point.
        let columns = self.knowledge.table("A.8").map(|table| table.columns.as_slice()).unwrap_or_default();
        let domain = columns.iter().find(|column| column.name == "centre_tolerance").map(Column::allowed);
        if domain.is_some_and(|domain| !domain.contains(width.micrometres())) {
            let message = format!("{width} mm is coarser than any tolerance of the tables A.8 and A.9");
            let help = "give the full width of the tolerance in mm, `0.46`, or a grade, `IT12`";
            return self.problems.error_help("bad-value", message, &node.place, help);
        }
        Some(CentreTolerance::Width(width))
    }
}
