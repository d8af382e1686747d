//! Reads the shaft file into a [`Shaft`], with every mistake.

use crate::knowledge::Knowledge;
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node};
use crate::turning::reading::{Mistake, Placed, Reader, given, mistake};
use crate::units::{Micrometres, MillimetresPerMinute};

use super::check;
use super::file::{self, ShaftFile};
use super::shape::{self, BlankShape};
use super::{Blank, BlankKind, Division, Holding, Moves, Rates, Roughing, Shaft, Step};

/// The approach if the file gives rates and no approach, mm: a choice of the program; the lecture names δ without a
/// figure.
const APPROACH: Micrometres = Micrometres::from_mm(2);
/// The retract if the file gives rates and no retract: 0.5 mm (lecture 12.4).
const RETRACT: Micrometres = Micrometres::new(500);

/// Reads a shaft file.
///
/// # Errors
/// Every mistake of the file, each with its place, in the order of the file.
pub fn read_shaft(file: &str, text: &str, knowledge: &Knowledge) -> Result<Shaft, Vec<Mistake>> {
    let (mut reader, root) = Reader::open(file, text, knowledge);
    let shaft = root.and_then(|root| reader.shaft(&root));
    reader.close(shaft)
}

/// A step, as far as it could be read.
pub(crate) struct PlacedStep {
    pub(crate) diameter: Option<Placed<Micrometres>>,
    pub(crate) length: Option<Placed<Micrometres>>,
}

impl PlacedStep {
    /// The step, if all of it could be read.
    pub(super) fn whole(self) -> Option<Step> {
        Some(Step { diameter: self.diameter?.0, length: self.length?.0 })
    }
}

/// A blank, as far as it could be read.
#[derive(Default)]
struct PlacedBlank {
    kind: Option<BlankKind>,
    diameter: Option<Placed<Micrometres>>,
    length: Option<Placed<Micrometres>>,
    shape: Option<BlankShape>,
}

impl Reader<'_> {
    pub(crate) fn shaft(&mut self, root: &Node) -> Option<Shaft> {
        let mut fields = self.problems.map(root)?;
        let name = fields.need(ShaftFile::shaft, &mut self.problems).and_then(|node| self.name(node));
        let material = fields.need(ShaftFile::material, &mut self.problems).and_then(|node| self.stated_material(node));
        let blank_node = fields.need(ShaftFile::blank, &mut self.problems);
        let machine = given(fields.take(ShaftFile::machine), |node| self.lathe(node));
        let holding = given(fields.take(ShaftFile::holding), |node| self.choice(node, Holding::NAMES));
        let steps_node = fields.need(ShaftFile::steps, &mut self.problems);
        let roughing_node = fields.need(ShaftFile::roughing, &mut self.problems);
        let rates_node = fields.take(ShaftFile::rates);
        fields.finish(&mut self.problems);

        let PlacedBlank { kind, diameter, length, shape } =
            blank_node.map(|node| self.stepped_blank(node)).unwrap_or_default();
        let steps = steps_node.map(|node| self.steps(node)).unwrap_or_default();
        let roughing = roughing_node.and_then(|node| self.depths(node));
        let rates = given(rates_node, |node| self.rates(node));
        check::steps(&steps, diameter.as_ref(), length.as_ref(), self);
        if let Some(shape) = &shape {
            shape::check(shape, kind, &steps, diameter.as_ref(), length.as_ref(), self);
        }
        let (material, material_state) = material?;
        let shaft = Shaft {
            shaft: name?,
            material,
            material_state,
            machine: machine?,
            blank: Blank { kind: kind?, diameter: diameter?.0, length: length?.0 },
            blank_steps: shape.map_or(Some(Vec::new()), BlankShape::whole)?,
            holding: holding?.unwrap_or_default(),
            steps: steps.into_iter().map(PlacedStep::whole).collect::<Option<_>>()?,
            roughing: roughing?,
            rates: rates?,
        };
        if let Some(node) = roughing_node.filter(|_| self.meant.is_empty()) {
            check::grid(&shaft, &node.place, self);
        }
        Some(shaft)
    }

    fn stepped_blank(&mut self, node: &Node) -> PlacedBlank {
        let Some(mut fields) = self.problems.map(node) else { return PlacedBlank::default() };
        let kind = fields.need(file::Blank::kind, &mut self.problems).and_then(|node| match node.text() {
            // A tube has a bore, which the short form cannot describe.
            Some("tube") => self.fault(mistake!("tube-with-steps"), &node.place),
            _ => self.choice(node, BlankKind::NAMES),
        });
        let diameter = self.need(&mut fields, file::Blank::diameter);
        let length = self.need(&mut fields, file::Blank::length);
        let shape = fields
            .take(file::Blank::steps)
            .map(|node| BlankShape { steps: self.steps(node), place: node.place.clone() });
        fields.finish(&mut self.problems);
        PlacedBlank { kind, diameter, length, shape }
    }

    pub(crate) fn steps(&mut self, node: &Node) -> Vec<PlacedStep> {
        let Some(nodes) = self.problems.list(node) else { return Vec::new() };
        if nodes.is_empty() {
            self.fault::<()>(mistake!("no-steps"), &node.place);
        }
        let mut steps = Vec::new();
        for node in nodes {
            let Some(mut fields) = self.problems.map(node) else { continue };
            let diameter = self.need(&mut fields, file::Step::diameter);
            let length = self.need(&mut fields, file::Step::length);
            fields.finish(&mut self.problems);
            steps.push(PlacedStep { diameter, length });
        }
        steps
    }

    fn depths(&mut self, node: &Node) -> Option<Roughing> {
        let mut fields = self.problems.map(node)?;
        let longitudinal = self.need(&mut fields, file::Roughing::longitudinal_depth);
        let transverse = self.need(&mut fields, file::Roughing::transverse_depth);
        let division = given(fields.take(file::Roughing::division), |node| self.choice(node, Division::NAMES));
        let moves = given(fields.take(file::Roughing::moves), |node| self.choice(node, Moves::NAMES));
        fields.finish(&mut self.problems);
        Some(Roughing {
            longitudinal_depth: longitudinal?.0,
            transverse_depth: transverse?.0,
            division: division?.unwrap_or_default(),
            moves: moves?.unwrap_or_default(),
        })
    }

    fn rates(&mut self, node: &Node) -> Option<Rates> {
        let mut fields = self.problems.map(node)?;
        let keys = [
            file::Rates::longitudinal_feed,
            file::Rates::transverse_feed,
            file::Rates::rapid,
            file::Rates::approach,
            file::Rates::retract,
        ];
        let rates = self.rates_of(&mut fields, keys);
        fields.finish(&mut self.problems);
        rates
    }

    /// The rates that every form of the file knows.
    pub(crate) fn rates_of<F>(
        &mut self,
        fields: &mut Fields<'_, F>,
        [longitudinal, transverse, rapid, approach, retract]: [KeyOf<F>; 5],
    ) -> Option<Rates> {
        let longitudinal = self.need(fields, longitudinal);
        let transverse = self.need(fields, transverse);
        let rapid = self.need(fields, rapid);
        let mut optional = |key: KeyOf<F>, default: Micrometres, reader: &mut Self| match fields.take(key) {
            None => Some(default),
            Some(node) => reader.length(Some(node), key.name()).map(|(length, _)| length),
        };
        let approach = optional(approach, APPROACH, self);
        let retract = optional(retract, RETRACT, self);
        Some(Rates {
            longitudinal_feed: MillimetresPerMinute(longitudinal?.0.to_mm()),
            transverse_feed: MillimetresPerMinute(transverse?.0.to_mm()),
            rapid: MillimetresPerMinute(rapid?.0.to_mm()),
            approach: approach?,
            retract: retract?,
        })
    }
}
