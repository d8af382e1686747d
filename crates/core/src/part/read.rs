//! The part file: YAML to [`Part`], collecting every mistake.

use crate::knowledge::Knowledge;
use crate::knowledge::diagnostic::{Diagnostic, Severity, nearest};
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node, NodeKind, Problems, parse};
use crate::machine::{Machine, id_of};
use crate::material::{self, MaterialState};
use crate::units::{Decimal, Micrometres};
use technolog_note::note;

use super::check;
use super::file::{self, PartFile};
use super::stated;
use super::{Base, Blank, BlankKind, Datum, Dimension, Entry, Fixture, Part, Point};

/// Reads a part file.
///
/// # Errors
/// Every mistake of the file, each with its place and what to do.
pub fn read_part(file: &str, text: &str, knowledge: &Knowledge) -> Result<Part, Vec<Diagnostic>> {
    let (root, diagnostics) = parse(file, text);
    let mut problems = Problems(diagnostics);
    let part = root.and_then(|root| Reader::new(knowledge, &mut problems).part(&root));
    let broken = problems.0.iter().any(|problem| problem.severity == Severity::Error);
    match part {
        Some(part) if !broken => Ok(part),
        _ => {
            problems.0.sort_by(|a, b| a.place.cmp(&b.place));
            Err(problems.0)
        }
    }
}

/// Reads a part inside another file, such as a plan. Mistakes go to `problems`; after a mistake there may be no part.
pub fn read_part_node(node: &Node, knowledge: &Knowledge, problems: &mut Problems) -> Option<Part> {
    Reader::new(knowledge, problems).part(node)
}

pub(super) struct Reader<'a> {
    pub(super) knowledge: &'a Knowledge,
    pub(super) problems: &'a mut Problems,
    /// Points of the lists and patterns read so far.
    pub(super) counted_points: usize,
}

impl<'a> Reader<'a> {
    pub(super) const fn new(knowledge: &'a Knowledge, problems: &'a mut Problems) -> Self {
        Self { knowledge, problems, counted_points: 0 }
    }
}

impl Reader<'_> {
    fn part(&mut self, root: &Node) -> Option<Part> {
        let mut fields = self.problems.map(root)?;
        let name = fields.need(PartFile::part, self.problems).and_then(|node| self.name(node));
        let material = fields.need(PartFile::material, self.problems).and_then(|node| self.stated_material(node));
        let blank = fields.need(PartFile::blank, self.problems).and_then(|node| self.blank(node));
        let machine = fields.need(PartFile::machine, self.problems).and_then(|node| self.machine(node));
        let datum_node = fields.take(PartFile::datum);
        let entry = match fields.take(PartFile::entry) {
            Some(node) => self.choice(node, Entry::NAMES),
            None => Some(Entry::default()),
        };
        let fixture_node = fields.take(PartFile::fixture);
        let position_tolerance = self.size(&mut fields, PartFile::position_tolerance);
        let mass_kg = fields.take(PartFile::mass).and_then(|node| self.mass(node));
        let dimensions_node = fields.take(PartFile::dimensions);
        let slots_node = fields.take(PartFile::slots);
        // A part may have slots alone.
        let holes_node = match fields.means(PartFile::slots) {
            true => fields.take(PartFile::holes),
            false => fields.need(PartFile::holes, self.problems),
        };
        fields.finish(self.problems);

        let datum = match (datum_node, blank) {
            (Some(node), Some(blank)) => self.datum(node, &blank),
            (None, Some(blank)) => {
                Some(Datum { left: -blank.length.half(), front: -blank.width.half(), top: Micrometres::ZERO })
            }
            _ => None,
        };
        let (mut clamps, mut pins) = (Vec::new(), Vec::new());
        let fixture = match fixture_node {
            Some(node) => self.fixture(node, &mut clamps, &mut pins),
            None => Some(Fixture::default()),
        };
        if let (Some(node), Some(blank), Some(Some(_))) =
            (fixture_node, blank, fixture.as_ref().map(|fixture| fixture.holding))
            && !blank.is_round()
        {
            let help = note!("part-leave-holding-out");
            self.problems.error_help::<()>("bad-value", note!("part-chuck-holds-discs"), &node.place, help);
        }
        let mut groups = holes_node.map(|node| self.groups(node, blank.as_ref())).unwrap_or_default();
        groups.extend(slots_node.map(|node| self.slots(node, blank.as_ref(), datum.as_ref())).unwrap_or_default());
        check::check_names(&groups, self.problems);
        if let (Some(blank), Some(datum)) = (&blank, &datum) {
            check::check_geometry(&groups, blank, datum, self.problems);
            check::check_clamps(&clamps, &groups, blank, datum, self.problems);
            check::check_pins(&pins, &groups, blank, datum, self.problems);
        }
        let dimensions = dimensions_node.map(|node| self.dimensions(node, &groups)).unwrap_or_default();
        let from_side = |one: &&Dimension| matches!((&one.from, &one.to), (Base::Side(_), _) | (_, Base::Side(_)));
        if let (Some(node), Some(true)) = (dimensions_node, blank.map(|blank| blank.is_round()))
            && dimensions.iter().any(|one| from_side(&one))
        {
            let help = note!("part-dimension-between-holes");
            self.problems.error_help::<()>("bad-value", note!("part-disc-has-no-sides"), &node.place, help);
        }
        let (material, material_state) = material?;
        Some(Part {
            part: name?,
            material,
            material_state,
            blank: blank?,
            machine: machine?,
            datum: datum?,
            entry: entry?,
            fixture: fixture?,
            position_tolerance,
            mass_kg,
            dimensions,
            holes: groups.into_iter().map(|group| group.hole).collect::<Option<_>>()?,
        })
    }

    /// A text that is not empty.
    pub(super) fn name(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.name(node)?;
        if text.is_empty() {
            return self.problems.error("bad-value", note!("part-name-must-empty"), &node.place);
        }
        Some(text.to_owned())
    }

    pub(super) fn choice<T: Copy>(&mut self, node: &Node, choices: &[(&str, T)]) -> Option<T> {
        choice(node, choices, self.problems)
    }

    /// A length above zero.
    pub(super) fn positive(&mut self, node: &Node, what: &str) -> Option<Micrometres> {
        let length: Micrometres = self.problems.scalar(node)?;
        if length <= Micrometres::ZERO {
            let message = note!("part-must-above-zero", what = what, length = length);
            return self.problems.error_help(
                "bad-value",
                message,
                &node.place,
                note!("part-give-millimetres-without-sign"),
            );
        }
        Some(length)
    }

    /// The length above zero of a key that may be absent.
    pub(super) fn size<F>(&mut self, fields: &mut Fields<'_, F>, key: KeyOf<F>) -> Option<Micrometres> {
        fields.take(key).and_then(|node| self.positive(node, key.name()))
    }

    /// The length above zero of a key that must be there.
    pub(super) fn need_size<F>(&mut self, fields: &mut Fields<'_, F>, key: KeyOf<F>) -> Option<Micrometres> {
        fields.need(key, self.problems).and_then(|node| self.positive(node, key.name()))
    }

    fn mass(&mut self, node: &Node) -> Option<f64> {
        let mass: Decimal = self.problems.scalar(node)?;
        if mass.millionths() <= 0 {
            return self.problems.error("bad-value", note!("part-mass-must-above-zero-kg"), &node.place);
        }
        Some(mass.to_f64())
    }

    /// A material by its name, or by its name and state.
    fn stated_material(&mut self, node: &Node) -> Option<(String, Option<MaterialState>)> {
        let grade = stated::grade(node).and_then(|node| self.material(node));
        let state = stated::state(node, grade.as_deref(), self.problems, self.knowledge)?;
        Some((grade?, state))
    }

    /// The id of a material, by itself or by an alias.
    pub(super) fn material(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.to_owned();
        let near = match material::named(self.knowledge, &text) {
            Ok(id) => return Some(id),
            Err(near) => near,
        };
        let help = match near {
            Some(near) => note!("part-did-you-mean-technolog-table", near = near),
            None => note!("part-technolog-table-materials-lists-them"),
        };
        self.problems.error_help("unknown-material", note!("part-unknown-material", text = text), &node.place, help)
    }

    pub(super) fn machine(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.to_owned();
        let known: Vec<&str> = Machine::ids(self.knowledge).collect();
        let id = id_of(&text);
        if known.contains(&id.as_str()) {
            return Some(id);
        }
        let help = match nearest(&id, known.iter().copied()) {
            Some(near) => note!("cli-did-you-mean", name = near),
            None => note!("part-known-machines", known = known.join(", ")),
        };
        self.problems.error_help("unknown-machine", note!("part-unknown-machine", text = text), &node.place, help)
    }

    pub(super) fn blank(&mut self, node: &Node) -> Option<Blank> {
        let mut fields = self.problems.map(node)?;
        let kind = match fields.need(file::Blank::kind, self.problems) {
            Some(node) => self.choice(node, &[("plate", BlankKind::Plate), ("disc", BlankKind::Disc)]),
            None => None,
        };
        // Without a kind that can be read the sizes say which it is.
        let round = kind.map_or_else(|| fields.means(file::Blank::diameter), |kind| kind == BlankKind::Disc);
        let thickness = self.need_size(&mut fields, file::Blank::thickness);
        if !round {
            let length = self.need_size(&mut fields, file::Blank::length);
            let width = self.need_size(&mut fields, file::Blank::width);
            fields.finish_among(
                &[file::Blank::kind, file::Blank::length, file::Blank::width, file::Blank::thickness],
                self.problems,
            );
            return Some(Blank { kind: kind?, length: length?, width: width?, thickness: thickness?, bore: None });
        }
        let diameter = self.need_size(&mut fields, file::Blank::diameter);
        let bore_node = fields.take(file::Blank::bore);
        fields.finish_among(
            &[file::Blank::kind, file::Blank::diameter, file::Blank::bore, file::Blank::thickness],
            self.problems,
        );
        let bore = bore_node.and_then(|node| self.positive(node, file::Blank::bore.name()));
        let (kind, diameter, thickness) = (kind?, diameter?, thickness?);
        if let (Some(node), Some(wide)) = (bore_node, bore.filter(|bore| *bore >= diameter)) {
            let message = note!("part-bore-of-ring-too-wide", bore = wide, diameter = diameter);
            return self.problems.error("bad-value", message, &node.place);
        }
        Some(Blank { kind, length: diameter, width: diameter, thickness, bore })
    }

    pub(super) fn datum(&mut self, node: &Node, blank: &Blank) -> Option<Datum> {
        let mut fields = self.problems.map(node)?;
        let (x_node, y_node) = (fields.take(file::Datum::x), fields.take(file::Datum::y));
        // A round blank has no sides to count from.
        let off = [x_node, y_node].into_iter().flatten().find(|node| node.text() != Some("centre"));
        if let Some(node) = off.filter(|_| blank.is_round()) {
            let help = note!("part-leave-zero-at-axis");
            self.problems.error_help::<()>("bad-value", note!("part-disc-has-zero-at-axis"), &node.place, help);
            return None;
        }
        let x = x_node.map(|node| self.zero(node, ["left", "centre", "right"], blank.length));
        let y = y_node.map(|node| self.zero(node, ["front", "centre", "back"], blank.width));
        let z = fields.take(file::Datum::z).map(|node| self.zero(node, ["bottom", "middle", "top"], blank.thickness));
        fields.finish(self.problems);
        let left = x.unwrap_or(Some(-blank.length.half()))?;
        let front = y.unwrap_or(Some(-blank.width.half()))?;
        let bottom = z.unwrap_or(Some(-blank.thickness))?;
        Some(Datum { left, front, top: bottom + blank.thickness })
    }

    /// The coordinate of a side in the datum: the zero is given by a word or by its distance from that side.
    fn zero(&mut self, node: &Node, names: [&str; 3], size: Micrometres) -> Option<Micrometres> {
        let text = self.problems.text(node)?;
        match names.iter().position(|name| *name == text) {
            Some(0) => Some(Micrometres::ZERO),
            Some(1) => Some(-size.half()),
            Some(_) => Some(-size),
            None => match text.parse::<Micrometres>() {
                Ok(distance) => Some(-distance),
                Err(_) => {
                    let message = note!("part-neither-nor-distance-mm", text = text, names = names.join(", "));
                    self.problems.error("bad-value", message, &node.place)
                }
            },
        }
    }

    pub(super) fn point(&mut self, node: &Node) -> Option<Point> {
        if node.get("r").is_some() || node.get("angle").is_some() {
            return self.polar(node);
        }
        if let NodeKind::Map(_) = node.kind {
            let help = note!("part-write-point-in-brackets", example = point_of_mapping(node));
            return self.problems.error_help("bad-value", note!("part-point-is-a-mapping"), &node.place, help);
        }
        match self.problems.list(node)? {
            [x, y] => {
                let (x, y) = (self.problems.scalar(x), self.problems.scalar(y));
                Some(Point { x: x?, y: y? })
            }
            other => {
                let message = note!("part-point-has-two-coordinates-x", other = other.len());
                let help = note!("part-separate-coordinates-with-comma-decimals");
                self.problems.error_help("bad-value", message, &node.place, help)
            }
        }
    }
}

impl Reader<'_> {
    /// A point by its distance from the zero of the drawing and the angle from X to Y, to a micrometre.
    fn polar(&mut self, node: &Node) -> Option<Point> {
        let mut fields = self.problems.map(node)?;
        let radius = fields.need(file::PolarPoint::r, self.problems).and_then(|node| self.problems.scalar(node));
        let angle: Option<Decimal> =
            fields.need(file::PolarPoint::angle, self.problems).and_then(|node| self.problems.scalar(node));
        fields.finish(self.problems);
        let (radius, angle): (Micrometres, f64) = (radius?, angle?.to_f64().to_radians());
        let along = |share: f64| Micrometres::from_mm_rounded(radius.to_mm() * share);
        Some(Point { x: along(libm::cos(angle)), y: along(libm::sin(angle)) })
    }
}

/// The point meant by `{x: 10,5, y: 3}`, in brackets; an example if there are no two numbers. A decimal comma makes a
/// key without a value of the decimals.
fn point_of_mapping(node: &Node) -> String {
    let NodeKind::Map(entries) = &node.kind else { return String::new() };
    let coordinate = |name: &str| {
        let at = entries.iter().position(|(key, _)| key.text.eq_ignore_ascii_case(name))?;
        let text = entries[at].1.text()?;
        let decimals = entries.get(at + 1).filter(|(key, node)| {
            node.is_null() && !text.contains('.') && key.text.bytes().all(|byte| byte.is_ascii_digit())
        });
        let number = decimals.map_or_else(|| text.replace(',', "."), |(key, _)| format!("{text}.{}", key.text));
        number.parse::<Micrometres>().ok()
    };
    match (coordinate("x"), coordinate("y")) {
        (Some(x), Some(y)) => format!("[{x}, {y}]"),
        _ => "[10.5, 3]".to_owned(),
    }
}

/// The value that a word stands for.
pub(super) fn choice<T: Copy>(node: &Node, choices: &[(&str, T)], problems: &mut Problems) -> Option<T> {
    let text = problems.text(node)?;
    if let Some((_, value)) = choices.iter().find(|(name, _)| *name == text) {
        return Some(*value);
    }
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    let message = note!("part-known-here", text = text);
    let help = match nearest(text, names.iter().copied()) {
        Some(near) => note!("cli-did-you-mean", name = near),
        None => note!("part-may", names = names.join(", ")),
    };
    problems.error_help("bad-value", message, &node.place, help)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{BlankHole, Bottom, CentreTolerance};
    use crate::shipped;
    use crate::units::ItGrade;

    const PART: &str = "part: П
material: Сталь 45
blank: {kind: plate, length: 200, width: 101.001, thickness: 40}
machine: gf2171
datum: {}
holes:
  - name: A
    diameter: 10H12
    depth: 30
    roughness: Ra 12.5
    centre_tolerance: 0.46
    at: [[0, 0], [20, 0]]
";

    fn read(from: &str, to: &str) -> Part {
        let text = PART.replacen(from, to, 1);
        assert!(PART.contains(from), "{from}");
        read_part("part", &text, &shipped::knowledge().unwrap()).unwrap_or_else(|problems| panic!("{to}: {problems:?}"))
    }

    fn um(value: i64) -> Micrometres {
        Micrometres::new(value)
    }

    #[test]
    fn what_is_left_out_has_its_default() {
        let part = read("", "");
        assert_eq!(part.material, "steel-45");
        assert_eq!(part.datum, Datum { left: um(-100_000), front: um(-50_500), top: um(0) });
        assert_eq!((part.entry, part.fixture), (Entry::Machined, Fixture::default()));
        let hole = &part.holes[0];
        assert!(!hole.through && !hole.skin && hole.bottom == Bottom::Free);
        assert!(hole.thread.is_none() && hole.steps.is_empty() && hole.state == BlankHole::Solid && !hole.outer_wall);
        assert_eq!(read("depth: 30", "through: true").holes[0].depth, um(40_000));
    }

    #[test]
    fn a_diameter_is_read_with_its_field_or_its_limits() {
        for (written, upper, lower, it, shown) in [
            ("10H12", 150, 0, 12, "10H12"),
            ("10Н12", 150, 0, 12, "10H12"),
            ("Ø 10 H12", 150, 0, 12, "10 H12"),
            ("10", 220, 0, 13, "10"),
            ("{nominal: 10, upper: 0.15, lower: 0}", 150, 0, 12, "10 +0.15/0"),
            // Between grade 11 (0.09) and grade 12 (0.15) only the finer is held.
            ("{nominal: 10, upper: 0.149, lower: 0}", 149, 0, 11, "10 +0.149/0"),
            ("{nominal: 10, upper: -0.02, lower: -0.11}", -20, -110, 11, "10 -0.02/-0.11"),
            ("{nominal: 10, upper: 0.05, lower: -0.05}", 50, -50, 11, "10 +0.05/-0.05"),
        ] {
            let diameter = &read("10H12", written).holes[0].diameter;
            assert_eq!(diameter.nominal, um(10_000), "{written}");
            assert_eq!((diameter.upper, diameter.lower), (um(upper), um(lower)), "{written}");
            assert_eq!((diameter.it.number(), diameter.written.as_str()), (it, shown), "{written}");
        }
    }

    #[test]
    fn a_comma_in_a_diameter_is_answered_with_the_diameter_that_is_meant() {
        let knowledge = crate::shipped::knowledge().unwrap();
        for (written, example) in [("10,5H7", "`10.5H7`"), ("Ø10,5", "`10.5`"), ("tenH7", "`10H12`")] {
            let why = super::super::ToleratedDiameter::parse(written, &knowledge).unwrap_err();
            let message = technolog_words::Lang::EN.say(&why);
            assert!(message.ends_with(&format!("write {example}")), "{written}: {message}");
        }
    }

    #[test]
    fn a_centre_tolerance_is_a_width_or_a_grade() {
        let grade = CentreTolerance::Grade { it: ItGrade::new(12).unwrap() };
        for written in ["IT12", "IT 12", "ІТ12", "it12"] {
            assert_eq!(read("0.46", written).holes[0].centre_tolerance, grade, "{written}");
        }
        assert_eq!(read("", "").holes[0].centre_tolerance, CentreTolerance::Width(um(460)));
    }

    #[test]
    fn a_zero_lies_at_a_side_or_at_a_distance_from_it() {
        for (datum, left, front, top) in [
            ("{x: left, y: front, z: bottom}", 0, 0, 40_000),
            ("{x: right, y: back, z: top}", -200_000, -101_001, 0),
            ("{x: centre, y: centre, z: middle}", -100_000, -50_500, 20_000),
            ("{x: 100, y: 20, z: 40}", -100_000, -20_000, 0),
        ] {
            // There is no hole at the zeros, so that corners do not matter.
            let text = PART.replace("{}", datum).replace("[[0, 0], [20, 0]]", "[[0, 0]]");
            let (root, _) = parse("part", &text);
            let mut problems = Problems::default();
            let knowledge = shipped::knowledge().unwrap();
            let mut reader = Reader::new(&knowledge, &mut problems);
            let root = root.unwrap();
            let blank = reader.blank(root.get("blank").unwrap()).unwrap();
            let read = reader.datum(root.get("datum").unwrap(), &blank).unwrap();
            assert_eq!(read, Datum { left: um(left), front: um(front), top: um(top) }, "{datum}");
        }
    }

    #[test]
    fn look_alike_letters_and_other_line_ends_are_read() {
        let part = read("datum: {}", "fixture: {clamps: [{at: [50, 0], screw: М10}]}");
        assert_eq!(part.fixture.clamps[0].screw.as_deref(), Some("M10"));
        assert_eq!(read("Ra 12.5", "Rа 12.5").holes[0].roughness, "Ra 12.5".parse().unwrap());
        let knowledge = shipped::knowledge().unwrap();
        for text in [PART.replace('\n', "\r\n"), format!("\u{feff}{PART}")] {
            assert_eq!(read_part("part", &text, &knowledge).unwrap(), read("", ""));
        }
    }

    #[test]
    fn a_key_that_asks_for_nothing_changes_nothing() {
        let hole = read("    at:", "    outer_wall: false\n    state: solid\n    steps: []\n    thread:\n    at:");
        assert_eq!(hole, read("", ""));
    }

    const MANY_KEYS: &str = "part: П
material: Сталь 45
machine: gf2171
blank: {kind: plate, length: 200, width: 100, thickness: 40}
holes:
  - {name: A, diameter: 10, depth: 30, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[0, 0]], chamfer: 1}
  - name: B
    thread: M12
    through: true
    centre_tolerance: 0.46
    face: 30
    counterbore: {diameter: 20, depth: 9}
    pattern: {line: {start: [50, 0], count: 2, step: 35}}
  - {name: D, through: true, centre_tolerance: 0.46, at: [[0, 30]], steps: [{diameter: 10, depth: 20, roughness: Ra 6.3}, {diameter: 9, roughness: Ra 6.3}]}
  - name: C
    diameter: 10
    depth: 30
    roughness: Ra 12.5
    centre_tolerance: 0.46
    countersink: {diameter: 17}
    at: [[-50, 0]]
";

    #[test]
    fn a_key_in_ukrainian_is_one_fault_and_names_the_key() {
        let knowledge = shipped::knowledge().unwrap();
        for (key, typed) in [
            ("part", "назва"),
            ("material", "матеріал"),
            ("blank", "заготовка"),
            ("length", "довжина"),
            ("width", "ширина"),
            ("thickness", "товщина"),
            ("machine", "верстат"),
            ("holes", "отвори"),
            ("name", "назва"),
            ("diameter", "діаметр"),
            ("depth", "глибина"),
            ("roughness", "шорсткість"),
            ("centre_tolerance", "допуск"),
            ("at", "точки"),
            ("thread", "різь"),
            ("pattern", "розташування"),
            ("steps", "ступені"),
            ("chamfer", "фаска"),
            ("counterbore", "цеківка"),
            ("countersink", "зенківка"),
            ("face", "торець"),
            ("through", "наскрізний"),
            ("count", "кількість"),
            ("step", "крок"),
        ] {
            let from = MANY_KEYS.find(&format!("{key}:")).unwrap();
            let text = format!("{}{typed}{}", &MANY_KEYS[..from], &MANY_KEYS[from + key.len()..]);
            let problems = read_part("part", &text, &knowledge).unwrap_err();
            let meant = note!("cli-did-you-mean", name = key);
            assert_eq!(problems.len(), 1, "{typed}: {problems:?}");
            assert_eq!((problems[0].code, &problems[0].help), ("unknown-key", &Some(meant)), "{typed}");
        }
    }
}
