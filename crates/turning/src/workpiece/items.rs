//! The items of a contour as in the file: each value with its place, as far as it could be read.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::form::{Form, KeyOf, similar_key};
use crate::knowledge::yaml::{Fields, Node, NodeKind};
use crate::turning::contour::{Field, Side};
use crate::turning::length::Half;
use crate::turning::reading::{LARGEST, Placed, Reader, mistake};
use crate::units::{Decimal, Deviation, ItGrade, Micrometres, Roughness};
use technolog_core::part::Deviations;

use super::grade;
use super::item_file::{
    ArcItem, Bulge, ChamferItem, ConeItem, ConeKind, CylinderItem, FaceItem, FromItem, GrooveItem, GrooveKind,
    LimitsFile, PointFile, Stretch, Surface, ThreadItem,
};
use super::thread::{self, ThreadSize};

/// The most items of a contour. Each closed part is planned with the levels of the whole contour, so time, memory and
/// the answer grow with the square of their number. At this bound that is seconds and some hundred megabytes.
pub const MOST_ITEMS: usize = 2000;

/// The largest deviation from a nominal size.
const MOST_DEVIATION: Micrometres = Micrometres::from_mm(10);

/// The owner of the contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owner {
    /// The part: Z is never before the finished face.
    Part,
    /// The blank: it may begin before that face, and has neither threads nor grooves.
    Blank,
}

/// Where an item stands: its node, the side of its contour, and who owns that.
type ItemAt<'n> = (&'n Node, Side, Owner);

/// A kind of items.
struct ItemKind {
    /// The key that it is known by.
    main: &'static str,
    /// All its keys.
    keys: fn() -> Vec<&'static str>,
    /// Whether a blank has such items, too.
    of_blank: bool,
    read: fn(&mut Reader<'_>, ItemAt<'_>) -> Option<ContourItem>,
}

const fn kind<F: Form>(
    main: KeyOf<F>,
    of_blank: bool,
    read: fn(&mut Reader<'_>, ItemAt<'_>) -> Option<ContourItem>,
) -> ItemKind {
    ItemKind { main: main.name(), keys: || F::KEYS.iter().map(|key| key.name()).collect(), of_blank, read }
}

/// The kinds.
static ITEMS: [ItemKind; 8] = [
    kind(FromItem::from, true, |reader, (node, _, owner)| {
        let mut fields = reader.problems.map(node)?;
        let point = fields.need(FromItem::from, &mut reader.problems);
        let shape = ItemShape::From(reader.to(point, owner));
        fields.finish(&mut reader.problems);
        Some(ContourItem { place: node.place.clone(), shape, attributes: Attributes::default() })
    }),
    kind(FaceItem::face, true, |reader, at| {
        reader.surface(at, FaceItem::face, |reader, value, fields| {
            let limits = fields.take(FaceItem::limits).and_then(|node| reader.limits(node, at.2));
            ItemShape::Face(reader.diameter(value, FaceItem::face.name()), limits)
        })
    }),
    kind(CylinderItem::cylinder, true, |reader, at| {
        reader.surface(at, CylinderItem::cylinder, |reader, value, fields| {
            let limits = fields.take(CylinderItem::limits).and_then(|node| reader.limits(node, at.2));
            ItemShape::Cylinder(reader.along(value, at.2), limits)
        })
    }),
    kind(ConeItem::cone, true, |reader, at| {
        reader.surface(at, ConeItem::cone, |reader, value, fields| {
            let to = reader.to(value, at.2);
            let kind = fields.take(ConeItem::kind).and_then(|node| reader.choice(node, ConeKind::NAMES));
            ItemShape::Cone { to, chamfer: kind == Some(ConeKind::Chamfer) }
        })
    }),
    kind(ChamferItem::chamfer, true, |reader, at| {
        reader.surface(at, ChamferItem::chamfer, |reader, value, _| {
            ItemShape::Chamfer(reader.length(value, ChamferItem::chamfer.name()))
        })
    }),
    kind(ArcItem::arc, true, |reader, at| {
        reader.surface(at, ArcItem::arc, |reader, value, fields| {
            let to = reader.to(value, at.2);
            let radius = reader.arc_radius(fields);
            let bulge = fields.need(ArcItem::bulge, &mut reader.problems);
            let bulge = bulge.and_then(|node| reader.choice(node, Bulge::NAMES));
            ItemShape::Arc { to, radius, bulge }
        })
    }),
    kind(ThreadItem::thread, false, |reader, at| {
        reader.surface(at, ThreadItem::thread, |reader, value, fields| {
            let size = value.and_then(|node| reader.thread(node, at.1));
            ItemShape::Thread { size, along: reader.thread_end(fields, at.2) }
        })
    }),
    kind(GrooveItem::groove, false, |reader, at| {
        reader.surface(at, GrooveItem::groove, |reader, value, fields| ItemShape::Groove(reader.groove(value, fields)))
    }),
];

/// A length as far as it could be read.
pub(super) type Measure = Option<Placed<Micrometres>>;

/// An item of a contour.
pub(super) struct ContourItem {
    pub place: Place,
    pub shape: ItemShape,
    pub attributes: Attributes,
}

/// The shape of an item.
pub(super) enum ItemShape {
    /// Where the contour begins.
    From(EndPoint),
    /// Across the axis to a diameter; the limits of its Z.
    Face(Measure, Option<Placed<Deviations>>),
    /// Along the axis; the limits of its diameter.
    Cylinder(Along, Option<Placed<Deviations>>),
    /// Straight to a point.
    Cone { to: EndPoint, chamfer: bool },
    /// At 45° over so much of each direction.
    Chamfer(Measure),
    /// Along an arc.
    Arc { to: EndPoint, radius: Measure, bulge: Option<Bulge> },
    /// A cylinder with a thread.
    Thread { size: Option<Placed<ThreadSize>>, along: Along },
    /// A groove.
    Groove(Option<GrooveValues>),
}

/// A point: diameter and Z with the sign of the file.
#[derive(Default)]
pub(super) struct EndPoint {
    pub d: Measure,
    pub z: Measure,
}

/// The length along the axis.
pub(super) enum Along {
    /// To a Z, as written in files.
    Z(Measure),
    /// By a length.
    Length(Measure),
}

/// A groove as written.
pub(super) struct GrooveValues {
    pub kind: GrooveKind,
    pub width: Measure,
    pub depth: Measure,
    pub radius: Measure,
    pub angle: Option<Placed<Decimal>>,
    /// Whether a size in the file could not be read. Then no table is asked for it.
    pub unreadable: bool,
}

/// The attributes of an item's surface.
#[derive(Default)]
pub(super) struct Attributes {
    pub name: Option<Placed<String>>,
    pub grade: Option<ItGrade>,
    pub field: Option<Field>,
    pub roughness: Option<Roughness>,
    pub allowance: Option<Half>,
}

impl Reader<'_> {
    /// The items of a contour; none for one without a key of a surface.
    pub(super) fn items(&mut self, node: &Node, side: Side, owner: Owner) -> Vec<Option<ContourItem>> {
        let Some(node) = &self.drawn(node, side) else { return Vec::new() };
        let Some(nodes) = self.problems.list(node) else { return Vec::new() };
        if nodes.len() < 2 {
            self.fault::<()>(mistake!("no-items"), &node.place);
        }
        if let Some(first_too_many) = nodes.get(MOST_ITEMS) {
            self.fault::<()>(mistake!("too-many-items", count = nodes.len(), most = MOST_ITEMS), &first_too_many.place);
            return Vec::new();
        }
        nodes.iter().map(|node| self.item(node, side, owner)).collect()
    }

    fn item(&mut self, node: &Node, side: Side, owner: Owner) -> Option<ContourItem> {
        let mut fields = self.problems.open_map(node)?;
        let mut kinds = ITEMS.iter().filter(|kind| node.get(kind.main).is_some());
        let Some(kind) = kinds.next() else {
            let known = ITEMS.each_ref().map(|kind| kind.main);
            let attributes = FaceItem::ATTRIBUTES.map(KeyOf::name);
            let NodeKind::Map(entries) = &node.kind else { return None };
            let mistyped = |key: &str| similar_key(key, &known).filter(|_| !attributes.contains(&key));
            if let Some(main) = entries.iter().find_map(|(key, _)| mistyped(&key.text)) {
                // The other keys of such an item are no faults.
                let kind = ITEMS.iter().find(|kind| kind.main == main);
                let keys = kind.map_or_else(Vec::new, |kind| (kind.keys)());
                for key in &keys {
                    fields.take(*key);
                }
                let others = known.into_iter().filter(|key| !keys.contains(key));
                let all: Vec<&str> = others.chain(keys.iter().copied()).collect();
                fields.finish(&all, &mut self.problems);
                return None;
            }
            return self.fault(mistake!("item-without-surface", known = known.join(", ")), &node.place);
        };
        if let Some(other) = kinds.next() {
            return self.fault(mistake!("two-surfaces-in-one", one = kind.main, other = other.main), &node.place);
        }
        if owner == Owner::Blank && !kind.of_blank {
            return self.fault(mistake!("item-of-a-part", key = kind.main), &node.place);
        }
        (kind.read)(self, (node, side, owner))
    }

    /// An item that is a surface; one of a blank has no attributes.
    fn surface<'n, F: Surface>(
        &mut self,
        (node, side, owner): ItemAt<'n>,
        main: KeyOf<F>,
        read: impl FnOnce(&mut Self, Option<&'n Node>, &mut Fields<'n, F>) -> ItemShape,
    ) -> Option<ContourItem> {
        let mut fields = self.problems.map(node)?;
        let value = fields.need(main, &mut self.problems);
        let shape = read(self, value, &mut fields);
        let attributes = match owner {
            Owner::Part => {
                let attributes = self.attributes(&mut fields, side);
                fields.finish(&mut self.problems);
                attributes
            }
            Owner::Blank => {
                let own = F::KEYS.len() - F::ATTRIBUTES.len();
                fields.finish_among(&F::KEYS[..own], &mut self.problems);
                Attributes::default()
            }
        };
        Some(ContourItem { place: node.place.clone(), shape, attributes })
    }

    fn attributes<F: Surface>(&mut self, fields: &mut Fields<'_, F>, side: Side) -> Attributes {
        let [name, grade, roughness, allowance] = F::ATTRIBUTES;
        let name = fields.take(name).and_then(|node| Some((self.name(node)?, node.place.clone())));
        let grade = fields.take(grade).and_then(|node| {
            let text = self.problems.text(node)?;
            let known = |field: &Field| field.is_known(self.knowledge).unwrap_or(true);
            match grade::read(text, side) {
                Ok((_, Some(field))) if !known(&field) => self.fault(mistake!("bad-grade", grade = text), &node.place),
                Ok(grade) => Some(grade),
                Err(code) => self.fault(mistake!(code, grade = text), &node.place),
            }
        });
        let (grade, field) = grade.map_or((None, None), |(grade, field)| (Some(grade), field));
        let roughness = fields.take(roughness).and_then(|node| self.problems.scalar(node));
        let allowance = fields.take(allowance).and_then(|node| self.not_below_zero(node, allowance.name()));
        Attributes { name, grade, field, roughness, allowance: allowance.map(Half::of) }
    }

    /// The limits of a size: the upper one lies above the lower one.
    fn limits(&mut self, node: &Node, owner: Owner) -> Option<Placed<Deviations>> {
        if owner == Owner::Blank {
            return self.fault(mistake!("item-of-a-part", key = CylinderItem::limits.name()), &node.place);
        }
        let mut fields = self.problems.map(node)?;
        let upper = fields.need(LimitsFile::upper, &mut self.problems);
        let lower = fields.need(LimitsFile::lower, &mut self.problems);
        fields.finish(&mut self.problems);
        let Deviation(upper) = upper.and_then(|node| self.problems.scalar(node))?;
        let Deviation(lower) = lower.and_then(|node| self.problems.scalar(node))?;
        if upper <= lower {
            return self.fault(mistake!("limits-crossed", upper = upper, lower = lower), &node.place);
        }
        if upper.abs().max(lower.abs()) > MOST_DEVIATION {
            return self.fault(mistake!("limits-too-far", upper = upper, lower = lower), &node.place);
        }
        Some((Deviations { upper, lower }, node.place.clone()))
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
    fn z(&mut self, node: Option<&Node>, key: &str, owner: Owner) -> Measure {
        let node = node?;
        let z = self.problems.scalar::<Micrometres>(node)?;
        if owner == Owner::Part && z > Micrometres::ZERO {
            return self.fault(mistake!("z-before-the-face", z = z), &node.place);
        }
        self.not_too_large((z, node.place.clone()), key)
    }

    fn to(&mut self, node: Option<&Node>, owner: Owner) -> EndPoint {
        let Some(mut fields) = node.and_then(|node| self.problems.map(node)) else { return EndPoint::default() };
        let d = fields.need(PointFile::d, &mut self.problems);
        let z = fields.need(PointFile::z, &mut self.problems);
        fields.finish(&mut self.problems);
        EndPoint { d: self.diameter(d, PointFile::d.name()), z: self.z(z, PointFile::z.name(), owner) }
    }

    fn along(&mut self, node: Option<&Node>, owner: Owner) -> Along {
        match node {
            Some(node) if matches!(node.kind, NodeKind::Map(_)) => {
                let Some(mut fields) = self.problems.map(node) else { return Along::Length(None) };
                let length = self.need(&mut fields, Stretch::length);
                fields.finish(&mut self.problems);
                Along::Length(length)
            }
            node => Along::Z(self.z(node, CylinderItem::cylinder.name(), owner)),
        }
    }

    /// The radius of an arc. In programs of controls a negative radius means the greater part of a circle.
    fn arc_radius(&mut self, fields: &mut Fields<'_, ArcItem>) -> Measure {
        let node = fields.need(ArcItem::radius, &mut self.problems)?;
        match node.text().and_then(|text| text.parse::<Micrometres>().ok()) {
            Some(radius) if radius < Micrometres::ZERO => {
                self.fault(mistake!("arc-over-half-a-circle", radius = radius), &node.place)
            }
            _ => self.length(Some(node), ArcItem::radius.name()),
        }
    }

    fn thread(&mut self, node: &Node, side: Side) -> Option<Placed<ThreadSize>> {
        let text = self.problems.text(node)?;
        match thread::read(text, self.knowledge) {
            Ok(named) if named.has_class_of_other_side(side) => {
                let code = match side {
                    Side::Outer => "outer-thread-with-class-of-bores",
                    Side::Inner => "inner-thread-with-class-of-shafts",
                };
                // What follows from its size, its relief for one, is still right.
                self.fault::<()>(mistake!(code, thread = text), &node.place);
                Some((named, node.place.clone()))
            }
            Ok(named) => Some((named, node.place.clone())),
            Err(code) => self.fault(mistake!(code, thread = text), &node.place),
        }
    }

    /// Where a thread ends: by `to` or by `length`.
    fn thread_end(&mut self, fields: &mut Fields<'_, ThreadItem>, owner: Owner) -> Along {
        match (fields.take(ThreadItem::to), fields.take(ThreadItem::length)) {
            (None, None) => {
                let _ = fields.need(ThreadItem::to, &mut self.problems);
                Along::Z(None)
            }
            (None, length) => Along::Length(self.length(length, ThreadItem::length.name())),
            (to, None) => Along::Z(self.z(to, ThreadItem::to.name(), owner)),
            (to, Some(length)) => {
                self.fault::<()>(mistake!("end-said-twice"), &length.place);
                Along::Z(self.z(to, ThreadItem::to.name(), owner))
            }
        }
    }

    fn groove(&mut self, node: Option<&Node>, fields: &mut Fields<'_, GrooveItem>) -> Option<GrooveValues> {
        let mut unreadable = false;
        let mut size = |key: KeyOf<GrooveItem>, reader: &mut Self| {
            let node = fields.take(key)?;
            let size = reader.length(Some(node), key.name());
            unreadable |= size.is_none();
            size
        };
        let (width, depth, radius) =
            (size(GrooveItem::width, self), size(GrooveItem::depth, self), size(GrooveItem::radius, self));
        let angle = fields.take(GrooveItem::angle).and_then(|node| {
            let angle = self.problems.scalar::<Decimal>(node);
            unreadable |= angle.is_none();
            Some((angle?, node.place.clone()))
        });
        let kind = self.choice(node?, GrooveKind::NAMES)?;
        Some(GrooveValues { kind, width, depth, radius, angle, unreadable })
    }
}
