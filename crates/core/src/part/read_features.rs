//! Reads the features of a hole besides its cylinders: openings at the entry, a groove, and its state in the blank.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node, NodeKind};
use crate::units::{Decimal, Micrometres};
use technolog_note::note;

use super::check::BoreSpan;
use super::file::hole as form;
use super::read::Reader;
use super::{BlankHole, Cone, Counterbore, Countersink, Groove};

/// Millionths in a thousandth: decimals are exact to the one, angles to the other.
const MILLIONTHS_IN_THOUSANDTH: i64 = 1000;
/// Half a turn, thousandths of a degree.
const HALF_TURN: i64 = 180_000;
/// The angle of a countersink that gives none, thousandths of a degree: that of the usual screw head.
const COUNTERSINK_ANGLE: u32 = 90_000;

/// The features of a group, each with the place its mistakes are reported at.
#[derive(Default)]
pub(super) struct Features {
    pub cone: Option<(Cone, Place)>,
    pub counterbore: Option<(Counterbore, Place)>,
    pub countersink: Option<(Countersink, Place)>,
    pub face: Option<(Micrometres, Place)>,
    pub groove: Option<(Groove, Place)>,
    pub state: BlankHole,
    pub state_diameter: Option<Place>,
    /// Whether the file says, rightly or not, that the blank has the hole.
    pub opened: bool,
    pub outer_wall: bool,
}

impl Features {
    /// The sections that they remove besides the cylinders. A face is no opening: faces may overlap and extend beyond
    /// an edge.
    pub fn spans(&self) -> Vec<BoreSpan> {
        let mut spans = Vec::new();
        // A cone narrows at once, so only its mouth counts.
        let mouths = [
            self.cone.as_ref().map(|(cone, _)| cone.diameter),
            self.countersink.as_ref().map(|(countersink, _)| countersink.diameter),
        ];
        spans.extend(
            mouths
                .into_iter()
                .flatten()
                .map(|diameter| BoreSpan::new(diameter, Micrometres::ZERO, Micrometres::new(1))),
        );
        if let Some((counterbore, _)) = &self.counterbore {
            spans.push(BoreSpan::new(counterbore.diameter, Micrometres::ZERO, counterbore.depth));
        }
        if let Some((groove, _)) = &self.groove {
            spans.push(BoreSpan::new(groove.diameter, groove.depth, groove.depth + groove.width));
        }
        spans
    }
}

impl Reader<'_> {
    pub(super) fn features(&mut self, fields: &mut Fields<'_, form::Hole>) -> Features {
        let mut features = Features {
            cone: self.placed(fields, form::Hole::cone, Self::cone),
            counterbore: self.placed(fields, form::Hole::counterbore, Self::counterbore),
            countersink: self.placed(fields, form::Hole::countersink, Self::countersink),
            face: self.placed(fields, form::Hole::face, Self::face),
            groove: self.placed(fields, form::Hole::groove, Self::groove),
            ..Features::default()
        };
        self.state(fields, &mut features);
        features
    }

    fn placed<T>(
        &mut self,
        fields: &mut Fields<'_, form::Hole>,
        key: KeyOf<form::Hole>,
        read: impl FnOnce(&mut Self, &Node) -> Option<T>,
    ) -> Option<(T, Place)> {
        let node = fields.take(key)?;
        Some((read(self, node)?, node.place.clone()))
    }

    fn cone(&mut self, node: &Node) -> Option<Cone> {
        let mut fields = self.problems.map(node)?;
        let diameter = self.need_size(&mut fields, form::Cone::diameter);
        let angle_node = fields.take(form::Cone::angle);
        let taper_node = fields.take(form::Cone::taper);
        let angle = match (angle_node, taper_node) {
            (Some(angle), None) => self.angle(angle),
            (None, Some(taper)) => self.taper(taper),
            (Some(_), Some(taper)) => {
                let message = note!("part-angle-taper-both-say-how");
                self.problems.error_help("bad-value", message, &taper.place, note!("part-keep-one-them"))
            }
            (None, None) => {
                let help = note!("part-taper-difference-diameters-over-length");
                self.problems.missing(form::Cone::angle, &node.place, help)
            }
        };
        fields.finish(self.problems);
        Some(Cone { diameter: diameter?, angle_millideg: angle? })
    }

    fn counterbore(&mut self, node: &Node) -> Option<Counterbore> {
        let mut fields = self.problems.map(node)?;
        let diameter = fields.need(form::Counterbore::diameter, self.problems).and_then(|node| self.free_size(node));
        let depth = self.need_size(&mut fields, form::Counterbore::depth);
        fields.finish(self.problems);
        Some(Counterbore { diameter: diameter?, depth: depth? })
    }

    fn countersink(&mut self, node: &Node) -> Option<Countersink> {
        let mut fields = self.problems.map(node)?;
        let diameter = self.need_size(&mut fields, form::Countersink::diameter);
        let angle = fields.take(form::Countersink::angle).map_or(Some(COUNTERSINK_ANGLE), |node| self.angle(node));
        fields.finish(self.problems);
        Some(Countersink { diameter: diameter?, angle_millideg: angle? })
    }

    fn face(&mut self, node: &Node) -> Option<Micrometres> {
        if !matches!(node.kind, NodeKind::Map(_)) {
            return self.positive(node, "face");
        }
        let mut fields = self.problems.map(node)?;
        let diameter = self.need_size(&mut fields, form::FaceKeys::diameter);
        fields.finish(self.problems);
        diameter
    }

    fn groove(&mut self, node: &Node) -> Option<Groove> {
        let mut fields = self.problems.map(node)?;
        let diameter = self.need_size(&mut fields, form::Groove::diameter);
        let (width, depth) =
            (self.need_size(&mut fields, form::Groove::width), self.need_size(&mut fields, form::Groove::depth));
        fields.finish(self.problems);
        Some(Groove { diameter: diameter?, width: width?, depth: depth? })
    }

    /// A full angle between 0 and 180 degrees, as thousandths of a degree.
    fn angle(&mut self, node: &Node) -> Option<u32> {
        let angle: Decimal = self.problems.scalar(node)?;
        let thousandths = angle.millionths() / MILLIONTHS_IN_THOUSANDTH;
        let exact = angle.millionths() % MILLIONTHS_IN_THOUSANDTH == 0;
        match u32::try_from(thousandths) {
            Ok(millideg) if exact && 0 < thousandths && thousandths < HALF_TURN => Some(millideg),
            _ => {
                let message = note!("part-angle-must-lie-between-degrees", angle = angle);
                let help = note!("part-give-full-angle-cone-degrees");
                self.problems.error_help("bad-value", message, &node.place, help)
            }
        }
    }

    /// The full angle of a taper, the difference of two diameters over the length between them: twice the
    /// arctangent of its half.
    fn taper(&mut self, node: &Node) -> Option<u32> {
        let text = self.problems.text(node)?;
        let help = note!("part-give-difference-diameters-over-length");
        let taper: Decimal = match text.parse() {
            Ok(taper) => taper,
            Err(error) => return self.problems.error_help("bad-value", error, &node.place, help),
        };
        let millideg = (2.0 * libm::atan(taper.to_f64() / 2.0).to_degrees() * 1000.0).round() as i64;
        match u32::try_from(millideg) {
            Ok(angle) if 0 < millideg && millideg < HALF_TURN => Some(angle),
            _ => self.problems.error_help("bad-value", note!("part-taper-no-cone", taper = taper), &node.place, help),
        }
    }

    /// Reads `state`, `state_diameter` and `outer_wall`, which depend on each other.
    fn state(&mut self, fields: &mut Fields<'_, form::Hole>, features: &mut Features) {
        type Kind = Option<fn(Micrometres) -> BlankHole>;
        let choices: &[(&str, Kind)] =
            &[("solid", None), ("cast", Some(BlankHole::Cast)), ("pre-machined", Some(BlankHole::PreMachined))];
        let kind = fields.take(form::Hole::state).map_or(Some(None), |node| self.choice(node, choices));
        features.opened = !matches!(kind, Some(None));
        let wall_node = fields.take(form::Hole::outer_wall);
        let outer_wall = wall_node.and_then(|node| self.problems.boolean(node)) == Some(true);
        let remedy = note!("part-say-state-cast-state-pre");
        let diameter_node = match kind {
            Some(Some(_)) => fields.need(form::Hole::state_diameter, self.problems),
            _ => fields.take(form::Hole::state_diameter),
        };
        let diameter = diameter_node.and_then(|node| self.positive(node, "state_diameter"));
        match kind {
            Some(Some(make)) => {
                features.outer_wall = outer_wall;
                features.state = diameter.map_or(BlankHole::Solid, make);
                features.state_diameter = diameter_node.map(|node| node.place.clone());
            }
            Some(None) => {
                if let Some(node) = diameter_node {
                    let message = note!("part-state-diameter-given-but-blank");
                    self.problems.error_help::<()>("bad-value", message, &node.place, remedy.clone());
                }
                if let (Some(node), true) = (wall_node, outer_wall) {
                    let message = note!("part-outer-wall-true-for-holes");
                    self.problems.error_help::<()>("bad-value", message, &node.place, remedy);
                }
            }
            None => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{Hole, read_part};
    use crate::shipped;

    /// A blind hole Ø10H12, 30 mm deep, with these keys; its mistakes as text.
    fn read(keys: &str) -> Result<Hole, Vec<String>> {
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 200, width: 100, thickness: 40}}\n\
             holes:\n  - {{name: A, diameter: 10H12, depth: 30, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[0, 0]], {keys}}}\n"
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

    #[test]
    fn every_feature_is_read() {
        let hole = read(
            "counterbore: {diameter: 15, depth: 9}, countersink: {diameter: 12}, face: 24, \
             groove: {diameter: 11, width: 2, depth: 12.5}, state: cast, state_diameter: 6, outer_wall: true",
        )
        .unwrap();
        assert_eq!(hole.counterbore, Some(Counterbore { diameter: um(15), depth: um(9) }));
        assert_eq!(hole.countersink, Some(Countersink { diameter: um(12), angle_millideg: 90_000 }));
        assert_eq!((hole.face, read("face: {diameter: 24}").unwrap().face), (Some(um(24)), Some(um(24))));
        assert_eq!(hole.groove, Some(Groove { diameter: um(11), width: um(2), depth: Micrometres::new(12_500) }));
        assert_eq!((hole.state, hole.outer_wall), (BlankHole::Cast(um(6)), true));
        let pre = read("state: pre-machined, state_diameter: 9.999").unwrap();
        assert_eq!((pre.state, pre.outer_wall), (BlankHole::PreMachined(Micrometres::new(9_999)), false));
    }

    /// Textbook, l. 218-219: twist drills are made up to 80 mm. A hole that the blank has may be wider.
    #[test]
    fn solid_metal_is_not_opened_wider_than_drills_go() {
        let text = |hole: &str| {
            format!(
                "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 400, width: 300, thickness: 40}}\n\
                 holes:\n  - {{name: A, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[0, 0]], {hole}}}\n"
            )
        };
        let knowledge = shipped::knowledge().unwrap();
        for (hole, said) in [
            ("diameter: 80H12", None),
            ("diameter: 160H7, state: cast, state_diameter: 150", None),
            ("steps: [{diameter: 100H9, depth: 10}, {diameter: 60H9}], state: pre-machined, state_diameter: 50", None),
            ("diameter: 81H12", Some("Ø81 in solid metal is more than Ø80")),
            ("steps: [{diameter: 100H9, depth: 10}, {diameter: 60H9}]", Some("Ø100 in solid metal is more than Ø80")),
            ("diameter: 161H7, state: cast, state_diameter: 150", Some("Ø161 is outside Ø3 to Ø160")),
            // What the file says wrongly of the blank is the one mistake.
            ("diameter: 100H7, state: cast", Some("`state_diameter` is missing")),
        ] {
            let read = read_part("part", &text(hole), &knowledge);
            let problems = read.err().unwrap_or_default();
            let problems: Vec<_> =
                problems.iter().map(|one| one.text(|note| technolog_words::Lang::EN.say(note))).collect();
            match said {
                None => assert!(problems.is_empty(), "{hole}: {problems:?}"),
                Some(said) => assert!(problems.len() == 1 && problems[0].contains(said), "{hole}: {problems:?}"),
            }
        }
    }

    #[test]
    fn a_taper_is_an_angle() {
        for (keys, angle) in [
            ("{diameter: 10.6, taper: 0.02}", 1_146),
            ("{diameter: 12, angle: 60.5}", 60_500),
            ("{diameter: 12, taper: 2}", 90_000),
            // Exactly to the bottom.
            ("{diameter: 11.5, taper: 0.05}", 2_864),
        ] {
            assert_eq!(read(&format!("cone: {keys}")).unwrap().cone.unwrap().angle_millideg, angle, "{keys}");
        }
    }

    #[test]
    fn what_is_wrong_with_a_feature_is_said_once() {
        for (keys, words) in [
            ("counterbore: {diameter: 10, depth: 5}", "[too-narrow]"),
            ("counterbore: {diameter: 15, depth: 30}", "counterbore is 30 deep, and Ø10 only to 30"),
            ("counterbore: {diameter: 15}", "`depth` is missing"),
            ("countersink: {diameter: 9}", "[too-narrow]"),
            ("countersink: {diameter: 20, angle: 10}", "[too-deep]"),
            ("countersink: {diameter: 20, angle: 180}", "between 0 and 180"),
            ("countersink: {diameter: 20, angle: 90.0001}", "three decimal places"),
            ("countersink: {diameter: 20, angle: -90}", "between 0 and 180"),
            ("cone: {diameter: 10, angle: 60}", "[too-narrow]"),
            ("cone: {diameter: 12, taper: 0.02}", "[too-deep]"),
            ("cone: {diameter: 12}", "`taper: 0.02`"),
            ("cone: {diameter: 12, taper: 0.2, angle: 3}", "keep one of them"),
            ("cone: {diameter: 12, taper: 1:50}", "0.02 for 1:50"),
            ("cone: {diameter: 12, taper: 0}", "not a cone"),
            ("face: 10", "[too-narrow]"),
            ("countersink: {diameter: 20}, face: 20", "the hole there Ø20"),
            ("groove: {diameter: 10, width: 2, depth: 5}", "[too-narrow]"),
            ("groove: {diameter: 12, width: 2, depth: 29}", "reaches to 31"),
            ("state: cast", "`state_diameter` is missing"),
            ("state: cast, state_diameter: 10", "[bad-diameter]"),
            ("state: cast, state_diameter: -1", "above zero"),
            ("state_diameter: 5", "the blank is solid"),
            ("state: solid, outer_wall: true", "the blank is solid"),
            ("state: forged, state_diameter: 5, outer_wall: true", "`forged` is not known"),
        ] {
            let problems = read(keys).map(|hole| panic!("{keys}: {hole:?}")).unwrap_err();
            assert_eq!(problems.len(), 1, "{keys}: {problems:?}");
            assert!(problems[0].contains(words), "{keys}: {problems:?}");
        }
    }

    #[test]
    fn features_of_a_stepped_hole_are_held_against_its_first_step() {
        let steps = "steps: [{diameter: 20, length: 10}, {diameter: 10H12, length: 20}]";
        assert!(
            read(&format!(
                "{steps}, counterbore: {{diameter: 30, depth: 5}}, groove: {{diameter: 11, width: 2, depth: 15}}"
            ))
            .is_ok()
        );
        for wrong in [
            "counterbore: {diameter: 15, depth: 5}",
            "counterbore: {diameter: 30, depth: 10}",
            "countersink: {diameter: 20}",
            "groove: {diameter: 15, width: 2, depth: 9}",
        ] {
            assert_eq!(read(&format!("{steps}, {wrong}")).unwrap_err().len(), 1, "{wrong}");
        }
    }
}
