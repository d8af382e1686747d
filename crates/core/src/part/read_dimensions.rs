//! Reads the dimensions of the drawing, and whether they hang together.

use technolog_note::{Figure, note};

use super::check::Group;
use super::file;
use super::limits::LimitedCount;
use super::read::Reader;
use super::{Along, Base, Dimension, Side};
use crate::knowledge::diagnostic::{Place, nearest};
use crate::knowledge::yaml::Node;

impl Reader<'_> {
    /// The dimensions of a file; those that contradict each other or the holes are told.
    pub(super) fn dimensions(&mut self, node: &Node, groups: &[Group]) -> Vec<Dimension> {
        let nodes = self.problems.list(node).unwrap_or_default();
        let mut read: Vec<(Dimension, Place)> = Vec::new();
        for node in self.bounded(LimitedCount::Dimensions, nodes) {
            let Some(dimension) = self.dimension(node, groups) else { continue };
            if let Some(known) = read.iter().map(|(known, _)| known).find(|known| same_end(known, &dimension)) {
                let message = note!(
                    "part-dimensioned-twice",
                    hole = shown(&dimension.to),
                    axis = dimension.axis.letter(),
                    other = shown(&known.from)
                );
                let help = note!("part-keep-the-dimension-of-the-drawing");
                self.problems.error_help::<()>("dimensioned-twice", message, &node.place, help);
                continue;
            }
            read.push((dimension, node.place.clone()));
        }
        self.circles(&read);
        read.into_iter().map(|(dimension, _)| dimension).collect()
    }

    fn dimension(&mut self, node: &Node, groups: &[Group]) -> Option<Dimension> {
        let mut fields = self.problems.map(node)?;
        let from_node = fields.need(file::Dimension::from, self.problems);
        let to_node = fields.need(file::Dimension::to, self.problems);
        let axis_node = fields.take(file::Dimension::axis);
        let tolerance_node = fields.need(file::Dimension::tolerance, self.problems);
        fields.finish(self.problems);
        let from = from_node.and_then(|node| self.base(node, groups));
        let to = to_node.and_then(|node| self.base(node, groups));
        let axis = match axis_node {
            Some(node) => Some((self.choice(node, &[("x", Along::X), ("y", Along::Y)])?, &node.place)),
            None => None,
        };
        let tolerance = tolerance_node.and_then(|node| self.width(node, "tolerance"));
        let (from, to) = (from?, to?);
        let axis = self.axis_of([&from, &to], axis, &node.place)?;
        // Of which of its holes a dimension would begin nobody can tell.
        if let Base::Hole(name) = &from {
            let group = groups.iter().find(|group| named(group, name))?;
            let mut along = group.points.iter().map(|(at, _)| axis.of(*at));
            let first = along.next()?;
            if along.any(|other| other != first) {
                let message = note!("part-dimension-from-many", hole = Figure::called(name), axis = axis.letter());
                let help = note!("part-split-the-group");
                return self.problems.error_help("bad-value", message, &from_node?.place, help);
            }
        }
        Some(Dimension { from, to, axis, tolerance_mm: tolerance? })
    }

    /// A side by its word, or a group of holes by its name.
    fn base(&mut self, node: &Node, groups: &[Group]) -> Option<Base> {
        let text = self.problems.name(node)?;
        if let Some((_, side)) = Side::NAMES.iter().find(|(name, _)| *name == text) {
            return Some(Base::Side(*side));
        }
        if let Some(group) = groups.iter().find(|group| named(group, text)) {
            // To which of its ends or walls it goes nobody can tell.
            if group.slot.is_some() {
                let message = note!("part-dimension-of-slot", name = Figure::called(text));
                return self.problems.error("bad-value", message, &node.place);
            }
            return Some(Base::Hole(text.to_owned()));
        }
        let names = || groups.iter().filter_map(|group| group.name.as_ref()).map(|(name, _)| name.as_str());
        let known = || Side::NAMES.iter().map(|(name, _)| *name).chain(names());
        let help = match nearest(text, known()) {
            Some(near) => note!("cli-did-you-mean", name = near),
            None => note!("part-dimension-ends", sides = Side::NAMES.map(|(name, _)| name).join(", ")),
        };
        self.problems.error_help("unknown-base", note!("part-unknown-base", text = text), &node.place, help)
    }

    /// The axis of a dimension: that of its side, or the one that the file says between two holes.
    fn axis_of(&mut self, ends: [&Base; 2], said: Option<(Along, &Place)>, place: &Place) -> Option<Along> {
        let of_side = |base: &Base| match base {
            Base::Side(side) => Some(side.axis()),
            Base::Hole(_) => None,
        };
        if ends[0] == ends[1] {
            let message = note!("part-dimension-to-itself", base = shown(ends[0]));
            return self.problems.error("bad-value", message, place);
        }
        let axes: Vec<Along> = ends.into_iter().filter_map(of_side).chain(said.map(|(axis, _)| axis)).collect();
        match axes[..] {
            [axis, ref rest @ ..] if rest.iter().all(|other| *other == axis) => Some(axis),
            [] => {
                let help = note!("part-say-axis");
                self.problems.missing(file::Dimension::axis, place, help)
            }
            _ => {
                let message = note!("part-dimension-across", from = shown(ends[0]), to = shown(ends[1]));
                self.problems.error("bad-value", message, said.map_or(place, |(_, place)| place))
            }
        }
    }

    /// Dimensions that lead back to where they begin dimension nothing; the first is told.
    fn circles(&mut self, read: &[(Dimension, Place)]) {
        for (dimension, place) in read {
            let before =
                |base: &Base| read.iter().map(|(one, _)| one).find(|one| one.axis == dimension.axis && one.to == *base);
            let mut at = Some(dimension);
            for _ in 0..=read.len() {
                at = at.and_then(|one| before(&one.from));
            }
            if at.is_some() {
                let message = note!("part-dimensions-in-a-circle", hole = shown(&dimension.to));
                let help = note!("part-keep-the-dimension-of-the-drawing");
                self.problems.error_help::<()>("bad-value", message, place, help);
                return;
            }
        }
    }
}

fn named(group: &Group, name: &str) -> bool {
    group.name.as_ref().is_some_and(|(own, _)| own == name)
}

/// Two dimensions of one coordinate; a size of the blank is the same from either side.
fn same_end(one: &Dimension, other: &Dimension) -> bool {
    let size = |dimension: &Dimension| matches!((&dimension.from, &dimension.to), (Base::Side(_), Base::Side(_)));
    one.axis == other.axis && (one.to == other.to && !size(one) && !size(other) || size(one) && size(other))
}

/// A side as the file writes it, or the name of a group.
fn shown(base: &Base) -> Figure {
    match base {
        Base::Side(side) => Figure::word_of("side", side.name()),
        Base::Hole(name) => Figure::called(name),
    }
}
