//! The part file: YAML to [`Part`], collecting every mistake.

use crate::knowledge::diagnostic::{Diagnostic, Place, Severity, nearest};
use crate::knowledge::yaml::{Fields, Node, NodeKind, Problems, parse};
use crate::knowledge::{Knowledge, Table};
use crate::units::{Decimal, ItGrade, Micrometres};

use super::check::{self, Placed};
use super::{
    Blank, BlankKind, Bottom, CentreTolerance, Clamp, Datum, Entry, Fixture, Hole, Part, Point, ToleratedDiameter,
};

const PART: &[&str] =
    &["part", "material", "blank", "machine", "datum", "entry", "fixture", "position_tolerance", "mass", "holes"];
const BLANK: &[&str] = &["kind", "length", "width", "thickness"];
const HOLE: &[&str] = &[
    "name",
    "diameter",
    "depth",
    "through",
    "bottom",
    "roughness",
    "centre_tolerance",
    "chamfer",
    "skin",
    "at",
    "cone",
    "thread",
    "counterbore",
    "countersink",
    "state",
    "state_diameter",
    "outer_wall",
    "steps",
    "pattern",
];
/// Keys of the format that this version reads and does not plan.
const NOT_PLANNED: &[&str] =
    &["cone", "thread", "counterbore", "countersink", "state_diameter", "outer_wall", "steps", "pattern"];

/// Reads a part file.
///
/// # Errors
/// Every mistake of the file, each with its place and what to do.
pub fn read_part(file: &str, text: &str, knowledge: &Knowledge) -> Result<Part, Vec<Diagnostic>> {
    let (root, diagnostics) = parse(file, text);
    let mut problems = Problems(diagnostics);
    let part = root.and_then(|root| Reader { knowledge, problems: &mut problems }.part(&root));
    let broken = problems.0.iter().any(|problem| problem.severity == Severity::Error);
    match part {
        Some(part) if !broken => Ok(part),
        _ => {
            problems.0.sort_by(|a, b| a.place.cmp(&b.place));
            Err(problems.0)
        }
    }
}

struct Reader<'a> {
    knowledge: &'a Knowledge,
    problems: &'a mut Problems,
}

impl Reader<'_> {
    fn part(&mut self, root: &Node) -> Option<Part> {
        let mut fields = self.problems.map(root)?;
        let name = self.need_text(&mut fields, "part");
        let material = fields.need("material", self.problems).and_then(|node| self.known(node, "materials", "id"));
        let blank = fields.need("blank", self.problems).and_then(|node| self.blank(node));
        let machine = fields.need("machine", self.problems).and_then(|node| self.machine(node));
        let datum_node = fields.take("datum");
        let entry = match fields.take("entry") {
            Some(node) => self.choice(node, &[("machined", Entry::Machined), ("rough", Entry::Rough)]),
            None => Some(Entry::default()),
        };
        let fixture_node = fields.take("fixture");
        let position_tolerance =
            fields.take("position_tolerance").and_then(|node| self.positive(node, "position_tolerance"));
        let mass_kg = fields.take("mass").and_then(|node| self.mass(node));
        let holes_node = fields.need("holes", self.problems);
        fields.finish(PART, self.problems);

        let datum = match (datum_node, blank) {
            (Some(node), Some(blank)) => self.datum(node, &blank),
            (None, Some(blank)) => {
                Some(Datum { left: -blank.length.half(), front: -blank.width.half(), top: Micrometres::ZERO })
            }
            _ => None,
        };
        let fixture = match fixture_node {
            Some(node) => self.fixture(node),
            None => Some(Fixture::default()),
        };
        let holes = holes_node.map(|node| self.holes(node, blank.as_ref()));
        if let (Some(holes), Some(blank), Some(datum)) = (&holes, &blank, &datum) {
            check::geometry(holes, blank, datum, self.problems);
        }
        let holes = holes?;
        Some(Part {
            part: name?,
            material: material?,
            blank: blank?,
            machine: machine?,
            datum: datum?,
            entry: entry?,
            fixture: fixture?,
            position_tolerance,
            mass_kg,
            holes: holes.into_iter().map(|placed| placed.hole).collect(),
        })
    }

    fn need_text(&mut self, fields: &mut Fields<'_>, name: &str) -> Option<String> {
        fields.need(name, self.problems).and_then(|node| self.problems.text(node)).map(str::to_owned)
    }

    fn choice<T: Copy>(&mut self, node: &Node, choices: &[(&str, T)]) -> Option<T> {
        let text = self.problems.text(node)?;
        if let Some((_, value)) = choices.iter().find(|(name, _)| *name == text) {
            return Some(*value);
        }
        let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
        let message = format!("`{text}` is none of {}", names.join(", "));
        self.problems.error("bad-value", message, &node.place)
    }

    /// A length above zero.
    fn positive(&mut self, node: &Node, what: &str) -> Option<Micrometres> {
        let length: Micrometres = self.problems.scalar(node)?;
        if length <= Micrometres::ZERO {
            let message = format!("`{what}` is {length}: it must be above zero");
            return self.problems.error_help("bad-value", message, &node.place, "give millimetres, without a sign");
        }
        Some(length)
    }

    fn mass(&mut self, node: &Node) -> Option<f64> {
        let mass: Decimal = self.problems.scalar(node)?;
        if mass.millionths() <= 0 {
            return self.problems.error("bad-value", "`mass` must be above zero, in kg", &node.place);
        }
        Some(mass.to_f64())
    }

    /// The key of a row in a catalog, or one of its aliases.
    fn known(&mut self, node: &Node, table: &str, column: &str) -> Option<String> {
        let text = self.problems.text(node)?.to_owned();
        let catalog: &Table = match self.knowledge.table(table) {
            Ok(catalog) => catalog,
            Err(error) => return self.problems.error("knowledge", error.to_string(), &node.place),
        };
        if catalog.find(column, &text).is_some() {
            return Some(text);
        }
        let alias = self.knowledge.table("material-aliases").ok().and_then(|aliases| aliases.find("alias", &text));
        if let Some(id) = alias.and_then(|row| row.text("id").ok()) {
            return Some(id.to_owned());
        }
        let names: Vec<&str> = catalog.all_rows().filter_map(|row| row.text(column).ok()).collect();
        let help = match nearest(&text, names.iter().copied()) {
            Some(near) => format!("did you mean `{near}`? `technolog table {table}` lists them all"),
            None => format!("`technolog table {table}` lists them"),
        };
        self.problems.error_help("unknown-material", format!("unknown material `{text}`"), &node.place, help)
    }

    fn machine(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.to_owned();
        if self.knowledge.table(&format!("machine-{text}")).is_ok() {
            return Some(text);
        }
        let known: Vec<&str> = self
            .knowledge
            .tables()
            .filter_map(|table| table.id.strip_prefix("machine-"))
            .filter(|id| *id != "quantities")
            .collect();
        let help = format!("known machines: {}", known.join(", "));
        self.problems.error_help("unknown-machine", format!("unknown machine `{text}`"), &node.place, help)
    }

    fn blank(&mut self, node: &Node) -> Option<Blank> {
        let mut fields = self.problems.map(node)?;
        let kind = match fields.need("kind", self.problems) {
            Some(node) => self.choice(node, &[("plate", BlankKind::Plate)]),
            None => None,
        };
        let mut side = |name: &str, reader: &mut Self| {
            fields.need(name, reader.problems).and_then(|node| reader.positive(node, name))
        };
        let (length, width, thickness) = (side("length", self), side("width", self), side("thickness", self));
        fields.finish(BLANK, self.problems);
        Some(Blank { kind: kind?, length: length?, width: width?, thickness: thickness? })
    }

    fn datum(&mut self, node: &Node, blank: &Blank) -> Option<Datum> {
        let mut fields = self.problems.map(node)?;
        let x = fields.take("x").map(|node| self.zero(node, ["left", "centre", "right"], blank.length));
        let y = fields.take("y").map(|node| self.zero(node, ["front", "centre", "back"], blank.width));
        let z = fields.take("z").map(|node| self.zero(node, ["bottom", "middle", "top"], blank.thickness));
        fields.finish(&["x", "y", "z"], self.problems);
        let left = x.unwrap_or(Some(-blank.length.half()))?;
        let front = y.unwrap_or(Some(-blank.width.half()))?;
        let bottom = z.unwrap_or(Some(-blank.thickness))?;
        Some(Datum { left, front, top: bottom + blank.thickness })
    }

    /// The coordinate of a side seen from a zero named by word, or given as the zero's distance from that side.
    fn zero(&mut self, node: &Node, names: [&str; 3], size: Micrometres) -> Option<Micrometres> {
        let text = self.problems.text(node)?;
        match names.iter().position(|name| *name == text) {
            Some(0) => Some(Micrometres::ZERO),
            Some(1) => Some(-size.half()),
            Some(_) => Some(-size),
            None => match text.parse::<Micrometres>() {
                Ok(distance) => Some(-distance),
                Err(_) => {
                    let message = format!("`{text}` is neither {} nor a distance in mm", names.join(", "));
                    self.problems.error("bad-value", message, &node.place)
                }
            },
        }
    }

    fn fixture(&mut self, node: &Node) -> Option<Fixture> {
        let mut fields = self.problems.map(node)?;
        let height = fields.take("height").and_then(|node| self.positive(node, "height"));
        let clamps_node = fields.take("clamps");
        fields.finish(&["height", "clamps"], self.problems);
        let mut clamps = Vec::new();
        for node in clamps_node.and_then(|node| self.problems.list(node)).unwrap_or_default() {
            let Some(mut fields) = self.problems.map(node) else { continue };
            let at = fields.need("at", self.problems).and_then(|node| self.point(node));
            let screw = fields.take("screw").and_then(|node| self.screw(node));
            fields.finish(&["at", "screw"], self.problems);
            clamps.extend(at.map(|at| Clamp { at, screw }));
        }
        Some(Fixture { height, clamps })
    }

    fn screw(&mut self, node: &Node) -> Option<String> {
        // Cyrillic М is typed as often as the Latin letter.
        let text = self.problems.text(node)?.replace('М', "M");
        let table = self.knowledge.table("clamp-screws").ok()?;
        if table.find("thread", &text).is_some() {
            return Some(text);
        }
        let names: Vec<&str> = table.all_rows().filter_map(|row| row.text("thread").ok()).collect();
        let message = format!("no clamp screw `{text}`");
        self.problems.error_help("unknown-screw", message, &node.place, format!("known are {}", names.join(", ")))
    }

    fn point(&mut self, node: &Node) -> Option<Point> {
        match self.problems.list(node)? {
            [x, y] => {
                let (x, y) = (self.problems.scalar(x), self.problems.scalar(y));
                Some(Point { x: x?, y: y? })
            }
            other => {
                let message = format!("a point has two coordinates [X, Y], not {}", other.len());
                self.problems.error("bad-value", message, &node.place)
            }
        }
    }

    fn holes(&mut self, node: &Node, blank: Option<&Blank>) -> Vec<Placed> {
        let mut holes: Vec<Placed> = Vec::new();
        let items = self.problems.list(node).unwrap_or_default();
        if items.is_empty() && matches!(node.kind, NodeKind::Seq(_)) {
            self.problems.error::<()>("bad-value", "the part has no holes", &node.place);
        }
        for item in items {
            let Some(placed) = self.hole(item, blank) else { continue };
            if holes.iter().any(|known| known.hole.name == placed.hole.name) {
                let message = format!("two groups of holes are named `{}`", placed.hole.name);
                self.problems.error_help::<()>("duplicate-name", message, &item.place, "name each group once");
            }
            holes.push(placed);
        }
        holes
    }

    fn hole(&mut self, node: &Node, blank: Option<&Blank>) -> Option<Placed> {
        let mut fields = self.problems.map(node)?;
        let name = self.need_text(&mut fields, "name");
        let diameter = fields.need("diameter", self.problems).and_then(|node| self.diameter(node));
        let through = match fields.take("through") {
            Some(node) => self.problems.boolean(node),
            None => Some(false),
        };
        let depth_node = fields.take("depth");
        let depth_place = depth_node.map_or_else(|| node.place.clone(), |node| node.place.clone());
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
        let mut not_planned: Vec<String> =
            NOT_PLANNED.iter().filter(|key| fields.take(key).is_some()).map(|&key| key.to_owned()).collect();
        if let Some(state) = fields.take("state") {
            let known = [("solid", false), ("cast", true), ("pre-machined", true)];
            if self.choice(state, &known) == Some(true) {
                not_planned.push("state".to_owned());
            }
        }
        let patterned = not_planned.iter().any(|key| key == "pattern");
        let at_node = if patterned { fields.take("at") } else { fields.need("at", self.problems) };
        let (at, at_places) = at_node.map(|node| self.points(node)).unwrap_or_default();
        fields.finish(HOLE, self.problems);
        Some(Placed {
            hole: Hole {
                name: name?,
                diameter: diameter?,
                depth: depth?,
                through: through?,
                bottom: bottom?,
                roughness: roughness?,
                centre_tolerance: centre_tolerance?,
                chamfer,
                skin: skin?,
                not_planned,
                at,
            },
            depth_place,
            at_places,
        })
    }

    fn points(&mut self, node: &Node) -> (Vec<Point>, Vec<Place>) {
        let items = self.problems.list(node).unwrap_or_default();
        if items.is_empty() && matches!(node.kind, NodeKind::Seq(_)) {
            self.problems.error::<()>("bad-value", "the group has no points", &node.place);
        }
        items.iter().filter_map(|item| self.point(item).map(|point| (point, item.place.clone()))).unzip()
    }

    fn diameter(&mut self, node: &Node) -> Option<ToleratedDiameter> {
        let diameter = if matches!(node.kind, NodeKind::Map(_)) {
            let mut fields = self.problems.map(node)?;
            let nominal = fields.need("nominal", self.problems).and_then(|node| self.positive(node, "nominal"));
            let upper = fields.need("upper", self.problems).and_then(|node| self.problems.scalar(node));
            let lower = fields.need("lower", self.problems).and_then(|node| self.problems.scalar(node));
            fields.finish(&["nominal", "upper", "lower"], self.problems);
            ToleratedDiameter::from_limits(nominal?, upper?, lower?, self.knowledge)
        } else {
            ToleratedDiameter::parse(self.problems.text(node)?, self.knowledge)
        };
        let diameter = match diameter {
            Ok(diameter) => diameter,
            Err(message) => return self.problems.error("bad-diameter", message, &node.place),
        };
        let (smallest, largest) = (Micrometres::from_mm(3), Micrometres::from_mm(80));
        if diameter.nominal < smallest || diameter.nominal > largest {
            let message = format!("Ø{} is outside Ø{smallest} to Ø{largest}", diameter.nominal);
            let help = "no drill of the catalogs begins a hole outside this range";
            return self.problems.error_help("bad-diameter", message, &node.place, help);
        }
        Some(diameter)
    }

    fn centre_tolerance(&mut self, node: &Node) -> Option<CentreTolerance> {
        let text = self.problems.text(node)?;
        if text.starts_with("IT") {
            let it: ItGrade = self.problems.scalar(node)?;
            if !(5..=14).contains(&it.number()) {
                return self.problems.error("bad-value", format!("IT {it} is outside IT 5 to IT 14"), &node.place);
            }
            return Some(CentreTolerance::Grade { it });
        }
        self.positive(node, "centre_tolerance").map(CentreTolerance::Width)
    }
}
