//! What is written along a contour, item by item, before it is walked: each value with its place, as far as it could be read.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::form::{KeyOf, meant};
use crate::knowledge::yaml::{Fields, Node, NodeKind};
use crate::turning::contour::Side;
use crate::turning::length::Half;
use crate::turning::reading::{LARGEST, Placed, Reader, mistake};
use crate::units::{Decimal, ItGrade, Micrometres, Roughness};

use super::grade;
use super::groove::GrooveForm;
use super::item_file::{
    ArcItem, ChamferItem, ConeItem, CylinderItem, FaceItem, FromItem, GrooveItem, PointFile, Stretch, Surface,
    ThreadItem,
};
use super::thread::{self, Named};

/// The most items of a contour: each closed part is planned with the whole contour beside it, so that time, memory and
/// the answer grow with the square of their number. Of so many items that is seconds and some hundred megabytes.
pub const MOST_ITEMS: usize = 2000;

/// Whose contour is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Whose {
    /// The part's: Z is nowhere before the finished face.
    Part,
    /// The blank's: it may begin before that face, and has neither threads nor grooves.
    Blank,
}

/// What kind of item it is.
#[derive(Clone, Copy)]
enum ItemKind {
    From,
    Face,
    Cylinder,
    Cone,
    Chamfer,
    Arc,
    Thread,
    Groove,
}

/// The kinds, each with the key that says so.
const ITEMS: [(ItemKind, &str); 8] = [
    (ItemKind::From, FromItem::from.name()),
    (ItemKind::Face, FaceItem::face.name()),
    (ItemKind::Cylinder, CylinderItem::cylinder.name()),
    (ItemKind::Cone, ConeItem::cone.name()),
    (ItemKind::Chamfer, ChamferItem::chamfer.name()),
    (ItemKind::Arc, ArcItem::arc.name()),
    (ItemKind::Thread, ThreadItem::thread.name()),
    (ItemKind::Groove, GrooveItem::groove.name()),
];

/// A length as far as it could be read.
pub(super) type Measure = Option<Placed<Micrometres>>;

/// An item of a contour.
pub(super) struct Item {
    pub place: Place,
    pub what: What,
    pub said: Said,
}

/// What an item is.
pub(super) enum What {
    /// Where the contour begins.
    From(To),
    /// Across the axis to a diameter.
    Face(Measure),
    /// Along the axis.
    Cylinder(Along),
    /// Straight to a point.
    Cone { to: To, chamfer: bool },
    /// At 45° over so much of each direction.
    Chamfer(Measure),
    /// Along an arc; whether it is hollow.
    Arc { to: To, radius: Measure, hollow: Option<bool> },
    /// A cylinder with a thread.
    Thread { named: Option<Placed<Named>>, along: Along },
    /// A groove.
    Groove(Option<Written>),
}

/// A point: diameter and Z, the latter as files write it.
#[derive(Default)]
pub(super) struct To {
    pub d: Measure,
    pub z: Measure,
}

/// How far along the axis.
pub(super) enum Along {
    /// To a Z, as files write it.
    Z(Measure),
    /// So long.
    Length(Measure),
}

/// A groove as it is written.
pub(super) struct Written {
    pub kind: GrooveForm,
    pub width: Measure,
    pub depth: Measure,
    pub radius: Measure,
    pub angle: Option<Placed<Decimal>>,
    /// Whether a size that stands in the file could not be read, so that no table is asked for it.
    pub spoilt: bool,
}

/// What an item says of its surface.
#[derive(Default)]
pub(super) struct Said {
    pub name: Option<Placed<String>>,
    pub grade: Option<ItGrade>,
    pub roughness: Option<Roughness>,
    pub allowance: Option<Half>,
}

impl Reader<'_> {
    /// The items of a contour; one that says not what it is is none.
    pub(super) fn items(&mut self, node: &Node, side: Side, whose: Whose) -> Vec<Option<Item>> {
        let Some(nodes) = self.problems.list(node) else { return Vec::new() };
        if nodes.len() < 2 {
            self.fault::<()>(mistake!("no-items"), &node.place);
        }
        if let Some(first_too_many) = nodes.get(MOST_ITEMS) {
            self.fault::<()>(mistake!("too-many-items", count = nodes.len(), most = MOST_ITEMS), &first_too_many.place);
            return Vec::new();
        }
        nodes.iter().map(|node| self.item(node, side, whose)).collect()
    }

    fn item(&mut self, node: &Node, side: Side, whose: Whose) -> Option<Item> {
        let fields = self.problems.open_map(node)?;
        let mut mains = ITEMS.iter().filter(|(_, main)| node.get(main).is_some());
        let Some((kind, main)) = mains.next() else {
            let known = ITEMS.map(|(_, main)| main);
            let said = FaceItem::SAID.map(KeyOf::name);
            let NodeKind::Map(entries) = &node.kind else { return None };
            let mistyped = |key: &str| !said.contains(&key) && meant(key, &known).is_some();
            if entries.iter().any(|(key, _)| mistyped(&key.text)) {
                let all: Vec<&str> = known.into_iter().chain(said).collect();
                fields.finish(&all, &mut self.problems);
                return None;
            }
            return self.fault(mistake!("item-without-surface", known = known.join(", ")), &node.place);
        };
        if let Some((_, other)) = mains.next() {
            return self.fault(mistake!("two-surfaces-in-one", one = main, other = other), &node.place);
        }
        if whose == Whose::Blank && matches!(kind, ItemKind::Thread | ItemKind::Groove) {
            return self.fault(mistake!("item-of-a-part", key = main), &node.place);
        }
        let at = (node, side, whose);
        match kind {
            ItemKind::From => {
                let mut fields = self.problems.map(node)?;
                let point = fields.need(FromItem::from, &mut self.problems);
                let what = What::From(self.to(point, whose));
                fields.finish(&mut self.problems);
                Some(Item { place: node.place.clone(), what, said: Said::default() })
            }
            ItemKind::Face => self.surface(at, FaceItem::face, |reader, value, _| {
                What::Face(reader.diameter(value, FaceItem::face.name()))
            }),
            ItemKind::Cylinder => {
                self.surface(at, CylinderItem::cylinder, |reader, value, _| What::Cylinder(reader.along(value, whose)))
            }
            ItemKind::Cone => self.surface(at, ConeItem::cone, |reader, value, fields| What::Cone {
                to: reader.to(value, whose),
                chamfer: reader.is_chamfer(fields),
            }),
            ItemKind::Chamfer => self.surface(at, ChamferItem::chamfer, |reader, value, _| {
                What::Chamfer(reader.length(value, ChamferItem::chamfer.name()))
            }),
            ItemKind::Arc => self.surface(at, ArcItem::arc, |reader, value, fields| {
                let to = reader.to(value, whose);
                let radius = reader.arc_radius(fields);
                let bulge = fields.need(ArcItem::bulge, &mut reader.problems);
                let hollow = bulge.and_then(|node| reader.choice(node, &[("in", true), ("out", false)]));
                What::Arc { to, radius, hollow }
            }),
            ItemKind::Thread => self.surface(at, ThreadItem::thread, |reader, value, fields| What::Thread {
                named: value.and_then(|node| reader.thread(node)),
                along: reader.thread_end(fields, whose),
            }),
            ItemKind::Groove => {
                self.surface(at, GrooveItem::groove, |reader, value, fields| What::Groove(reader.groove(value, fields)))
            }
        }
    }

    /// An item that is a surface; one of a blank says nothing of itself.
    fn surface<'n, F: Surface>(
        &mut self,
        (node, side, whose): (&'n Node, Side, Whose),
        main: KeyOf<F>,
        read: impl FnOnce(&mut Self, Option<&'n Node>, &mut Fields<'n, F>) -> What,
    ) -> Option<Item> {
        let mut fields = self.problems.map(node)?;
        let value = fields.need(main, &mut self.problems);
        let what = read(self, value, &mut fields);
        let said = match whose {
            Whose::Part => {
                let said = self.said(&mut fields, side);
                fields.finish(&mut self.problems);
                said
            }
            Whose::Blank => {
                let own = F::KEYS.len() - F::SAID.len();
                fields.finish_among(&F::KEYS[..own], &mut self.problems);
                Said::default()
            }
        };
        Some(Item { place: node.place.clone(), what, said })
    }

    fn said<F: Surface>(&mut self, fields: &mut Fields<'_, F>, side: Side) -> Said {
        let [name, grade, roughness, allowance] = F::SAID;
        let name = fields.take(name).and_then(|node| Some((self.name(node)?, node.place.clone())));
        let grade = fields.take(grade).and_then(|node| {
            let text = self.problems.text(node)?;
            match grade::read(text, side) {
                Ok(grade) => Some(grade),
                Err(code) => self.fault(mistake!(code, grade = text), &node.place),
            }
        });
        let roughness = fields.take(roughness).and_then(|node| self.problems.scalar(node));
        let allowance = fields.take(allowance).and_then(|node| self.not_below_zero(node, allowance.name()));
        Said { name, grade, roughness, allowance: allowance.map(Half::of) }
    }

    /// A length that may be zero.
    pub(super) fn not_below_zero(&mut self, node: &Node, key: &str) -> Option<Micrometres> {
        let length = self.problems.scalar::<Micrometres>(node)?;
        if length < Micrometres::ZERO {
            return self.fault(mistake!("below-zero", key = key, length = length), &node.place);
        }
        self.not_too_large((length, node.place.clone()), key).map(|(length, _)| length)
    }

    fn not_too_large(&mut self, (length, place): Placed<Micrometres>, key: &str) -> Measure {
        if length.abs() > LARGEST {
            return self.fault(mistake!("length-too-large", key = key, length = length, most = LARGEST), &place);
        }
        Some((length, place))
    }

    /// A diameter, zero on the axis.
    fn diameter(&mut self, node: Option<&Node>, key: &str) -> Measure {
        let node = node?;
        let diameter = self.problems.scalar::<Micrometres>(node)?;
        if diameter < Micrometres::ZERO {
            return self.fault(mistake!("negative-diameter", key = key, diameter = diameter), &node.place);
        }
        self.not_too_large((diameter, node.place.clone()), key)
    }

    /// A Z, negative towards the chuck.
    fn z(&mut self, node: Option<&Node>, key: &str, whose: Whose) -> Measure {
        let node = node?;
        let z = self.problems.scalar::<Micrometres>(node)?;
        if whose == Whose::Part && z > Micrometres::ZERO {
            return self.fault(mistake!("z-before-the-face", z = z), &node.place);
        }
        self.not_too_large((z, node.place.clone()), key)
    }

    fn to(&mut self, node: Option<&Node>, whose: Whose) -> To {
        let Some(mut fields) = node.and_then(|node| self.problems.map(node)) else { return To::default() };
        let d = fields.need(PointFile::d, &mut self.problems);
        let z = fields.need(PointFile::z, &mut self.problems);
        fields.finish(&mut self.problems);
        To { d: self.diameter(d, PointFile::d.name()), z: self.z(z, PointFile::z.name(), whose) }
    }

    fn along(&mut self, node: Option<&Node>, whose: Whose) -> Along {
        match node {
            Some(node) if matches!(node.kind, NodeKind::Map(_)) => {
                let Some(mut fields) = self.problems.map(node) else { return Along::Length(None) };
                let length = self.need(&mut fields, Stretch::length);
                fields.finish(&mut self.problems);
                Along::Length(length)
            }
            node => Along::Z(self.z(node, CylinderItem::cylinder.name(), whose)),
        }
    }

    fn is_chamfer(&mut self, fields: &mut Fields<'_, ConeItem>) -> bool {
        let kind =
            fields.take(ConeItem::kind).and_then(|node| self.choice(node, &[("cone", false), ("chamfer", true)]));
        kind.unwrap_or(false)
    }

    /// The radius of an arc. Programs of controls write that of the greater part of a circle with a minus.
    fn arc_radius(&mut self, fields: &mut Fields<'_, ArcItem>) -> Measure {
        let node = fields.need(ArcItem::radius, &mut self.problems)?;
        match node.text().and_then(|text| text.parse::<Micrometres>().ok()) {
            Some(radius) if radius < Micrometres::ZERO => {
                self.fault(mistake!("arc-over-half-a-circle", radius = radius), &node.place)
            }
            _ => self.length(Some(node), ArcItem::radius.name()),
        }
    }

    fn thread(&mut self, node: &Node) -> Option<Placed<Named>> {
        let text = self.problems.text(node)?;
        match thread::read(text, self.knowledge) {
            Ok(named) => Some((named, node.place.clone())),
            Err(code) => self.fault(mistake!(code, thread = text), &node.place),
        }
    }

    /// Where a thread ends: by `to` or by `length`.
    fn thread_end(&mut self, fields: &mut Fields<'_, ThreadItem>, whose: Whose) -> Along {
        match (fields.take(ThreadItem::to), fields.take(ThreadItem::length)) {
            (None, None) => {
                let _ = fields.need(ThreadItem::to, &mut self.problems);
                Along::Z(None)
            }
            (None, length) => Along::Length(self.length(length, ThreadItem::length.name())),
            (to, None) => Along::Z(self.z(to, ThreadItem::to.name(), whose)),
            (to, Some(length)) => {
                self.fault::<()>(mistake!("end-said-twice"), &length.place);
                Along::Z(self.z(to, ThreadItem::to.name(), whose))
            }
        }
    }

    fn groove(&mut self, node: Option<&Node>, fields: &mut Fields<'_, GrooveItem>) -> Option<Written> {
        let mut spoilt = false;
        let mut size = |key: KeyOf<GrooveItem>, reader: &mut Self| {
            let node = fields.take(key)?;
            let size = reader.length(Some(node), key.name());
            spoilt |= size.is_none();
            size
        };
        let (width, depth, radius) =
            (size(GrooveItem::width, self), size(GrooveItem::depth, self), size(GrooveItem::radius, self));
        let angle = fields.take(GrooveItem::angle).and_then(|node| {
            let angle = self.problems.scalar::<Decimal>(node);
            spoilt |= angle.is_none();
            Some((angle?, node.place.clone()))
        });
        let kind = self.choice(node?, &GrooveForm::NAMES)?;
        Some(Written { kind, width, depth, radius, angle, spoilt })
    }
}
