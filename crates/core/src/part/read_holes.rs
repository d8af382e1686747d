//! The groups of holes in a part file.

use crate::knowledge::Column;
use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Fields, Node, NodeKind};
use crate::tables::holes::{SchemesOfMainHole, SchemesOfMainHoleFor};
use crate::units::{ItGrade, Micrometres, Roughness};
use technolog_note::note;

use super::arrange_steps::Cylinders;
use super::check::{BoreSpan, Centres, Group};
use super::file::hole as form;
use super::limits::LimitedCount;
use super::read::Reader;
use super::read_diameter::Sized;
use super::read_steps::GroupValues;
use super::tolerance::largest;
use super::{Blank, Bottom, CentreTolerance, Hole, Point};

impl Reader<'_> {
    pub(super) fn groups(&mut self, node: &Node, blank: Option<&Blank>) -> Vec<Group> {
        let items = self.problems.list(node).unwrap_or_default();
        if items.is_empty() && matches!(node.kind, NodeKind::Seq(_)) {
            self.problems.error_help::<()>(
                "bad-value",
                note!("part-part-has-no-holes"),
                &node.place,
                note!("part-give-at-least-one-group"),
            );
        }
        self.bounded(LimitedCount::Kinds, items).iter().filter_map(|item| self.group(item, blank)).collect()
    }

    fn group(&mut self, node: &Node, blank: Option<&Blank>) -> Option<Group> {
        let mut fields = self.problems.map(node)?;
        let name_node = fields.need(form::Hole::name, self.problems);
        let name = name_node.and_then(|node| self.name(node));
        let steps_node = fields.take(form::Hole::steps);
        let steps = steps_node.and_then(|node| self.problems.list(node)).unwrap_or_default();
        // An empty list requires nothing; a value that is no list was still meant to give the diameters.
        let stepped = steps_node.map_or_else(
            || fields.means(form::Hole::steps),
            |node| !matches!(&node.kind, NodeKind::Seq(items) if items.is_empty()),
        );
        let sized = self.sized(&mut fields, form::Hole::thread, form::Hole::diameter, !stepped);
        let through = match fields.take(form::Hole::through) {
            Some(node) => self.problems.boolean(node),
            None => (!fields.means(form::Hole::through)).then_some(false),
        };
        let depth_node = fields.take(form::Hole::depth);
        let depth = match (depth_node, through, blank) {
            (Some(node), ..) => self.positive(node, "depth"),
            (None, Some(true), Some(blank)) => Some(blank.thickness),
            (None, Some(false), _) if !stepped => {
                let help = note!("part-blind-hole-has-depth-through");
                self.problems.missing(form::Hole::depth, fields.place, help)
            }
            _ => None,
        };
        let bottom = match fields.take(form::Hole::bottom) {
            Some(node) => self.choice(node, &[("flat", Bottom::Flat), ("free", Bottom::Free)]),
            None => None,
        };
        // A thread has a roughness of its own, and steps may each have one.
        let free = stepped || fields.means(form::Hole::thread);
        let roughness =
            if free { fields.take(form::Hole::roughness) } else { fields.need(form::Hole::roughness, self.problems) };
        let roughness = roughness.map(|node| self.roughness(node));
        let centre_tolerance =
            fields.need(form::Hole::centre_tolerance, self.problems).and_then(|node| self.centre_tolerance(node));
        let chamfer_node = fields.take(form::Hole::chamfer);
        let chamfer = chamfer_node.and_then(|node| Some((self.positive(node, "chamfer")?, node.place.clone())));
        let skin = match fields.take(form::Hole::skin) {
            Some(node) => self.problems.boolean(node),
            None => Some(false),
        };
        let features = self.features(&mut fields);
        let (at, points) = self.centres(&mut fields);
        let place = fields.place;

        let size_place = sized.as_ref().map(|sized| sized.place.clone());
        let alone = sized.as_ref().filter(|_| !stepped).map(|sized| sized.diameter.clone());
        let cylinders = if stepped {
            let through = through.unwrap_or(true);
            // A `depth` of a through hole that is not the thickness is reported at the key itself.
            let depth = if through { blank.map(|blank| blank.thickness) } else { depth };
            let values = GroupValues { diameter: sized, through, depth, roughness, bottom, chamfer, place };
            self.steps(steps, values)
        } else {
            self.cylinder(sized, depth, roughness, bottom, chamfer)
        };
        if let Some(known) = cylinders.as_ref().filter(|_| !features.opened) {
            self.within_drills(known, size_place.as_ref().unwrap_or(place));
        }
        let narrowest = cylinders.as_ref().map(|known| &known.diameter).or(alone.as_ref());
        let mut spans = match (&cylinders, &alone) {
            (Some(known), _) => known.spans.clone(),
            (None, Some(diameter)) => {
                vec![BoreSpan::new(diameter.nominal, Micrometres::ZERO, depth.unwrap_or(BoreSpan::FAR))]
            }
            (None, None) => Vec::new(),
        };
        if let Some(diameter) = narrowest {
            // A hole that is already drilled for its thread is still tapped.
            let threaded = cylinders.as_ref().is_some_and(|known| known.thread.is_some());
            let too_wide = if threaded { diameter.largest() + Micrometres::new(1) } else { diameter.smallest() };
            self.fit_features(&features, &spans, too_wide);
            self.face_on_blank(&features, blank);
            spans.extend(features.spans());
        }

        // Only now, so that a mistyped key is not reported as missing too.
        fields.finish(self.problems);

        let mut group = Group {
            name: name.clone().zip(name_node.map(|node| node.place.clone())),
            spans,
            depth: depth.zip(depth_node.map(|node| node.place.clone())),
            through,
            at,
            points,
            slot: None,
            hole: None,
        };
        if let (Some(name), Some(cylinders), Some(through)) = (name, cylinders, through)
            && let (Some(skin), Some(centre_tolerance)) = (skin, centre_tolerance)
        {
            group.hole = Some(Hole {
                name,
                diameter: cylinders.diameter,
                depth: cylinders.depth,
                through,
                bottom: cylinders.bottom,
                roughness: cylinders.roughness,
                centre_tolerance,
                chamfer: cylinders.chamfer,
                skin,
                thread: cylinders.thread,
                cone: features.cone.map(|(cone, _)| cone),
                counterbore: features.counterbore.map(|(counterbore, _)| counterbore),
                countersink: features.countersink.map(|(countersink, _)| countersink),
                face: features.face.map(|(face, _)| face),
                groove: features.groove.map(|(groove, _)| groove),
                state: features.state,
                outer_wall: features.outer_wall,
                steps: cylinders.steps,
                slot: None,
                at: group.points.iter().map(|(point, _)| *point).collect(),
            });
        }
        Some(group)
    }

    /// Reports a hole in solid metal that is wider than the drills of the catalogs (table `hole-defaults`).
    fn within_drills(&mut self, cylinders: &Cylinders, place: &Place) {
        let steps = cylinders.steps.iter().map(|step| step.diameter.nominal);
        let widest = steps.fold(cylinders.diameter.nominal, Micrometres::max);
        match largest(self.knowledge) {
            Ok((solid, opened)) if widest > solid => {
                let message = note!("part-solid-wider-than-drills", nominal = widest, largest = solid);
                let help = note!("part-say-blank-has-hole", largest = opened);
                self.problems.error_help::<()>("bad-diameter", message, place, help);
            }
            Ok(_) => {}
            Err(message) => {
                self.problems.error::<()>("bad-diameter", message, place);
            }
        }
    }

    /// The one cylinder of a hole without steps.
    fn cylinder(
        &mut self,
        sized: Option<Sized>,
        depth: Option<Micrometres>,
        roughness: Option<Option<Roughness>>,
        bottom: Option<Bottom>,
        chamfer: Option<(Micrometres, Place)>,
    ) -> Option<Cylinders> {
        let sized = sized?;
        let roughness = match roughness {
            Some(stated) => stated,
            None if sized.thread.is_some() => self.thread_roughness(&sized.place),
            None => None,
        };
        let depth = depth?;
        Some(Cylinders {
            spans: vec![BoreSpan::new(sized.widest(), Micrometres::ZERO, depth)],
            diameter: sized.diameter,
            thread: sized.thread,
            depth,
            bottom: bottom.unwrap_or_default(),
            roughness: roughness?,
            chamfer: chamfer.map(|(chamfer, _)| chamfer),
            steps: Vec::new(),
        })
    }

    /// The centres, from `at` or from `pattern`. The points of a pattern have its place.
    fn centres(&mut self, fields: &mut Fields<'_, form::Hole>) -> (Option<Centres>, Vec<(Point, Place)>) {
        let pattern = fields.take(form::Hole::pattern);
        let at = match fields.means(form::Hole::pattern) {
            true => fields.take(form::Hole::at),
            false => fields.need(form::Hole::at, self.problems),
        };
        if let (Some(node), Some(_)) = (at, pattern) {
            let message = note!("part-at-pattern-both-say-where");
            self.problems.error_help::<()>("bad-value", message, &node.place, note!("part-keep-one-them"));
        }
        match (pattern, at) {
            (Some(node), _) => {
                let points = self.pattern(node).into_iter().map(|point| (point, node.place.clone())).collect();
                (Some(Centres { place: node.place.clone(), pattern: true }), points)
            }
            (None, Some(node)) => (Some(Centres { place: node.place.clone(), pattern: false }), self.points(node)),
            (None, None) => (None, Vec::new()),
        }
    }

    fn points(&mut self, node: &Node) -> Vec<(Point, Place)> {
        let items = self.problems.list(node).unwrap_or_default();
        let scalars = items.iter().all(|item| matches!(item.kind, NodeKind::Scalar { .. }));
        if matches!(node.kind, NodeKind::Seq(_)) && scalars {
            let message = if items.is_empty() {
                note!("part-group-has-no-points")
            } else {
                note!("part-list-points-expected-here")
            };
            let help = note!("part-give-each-point-brackets-own");
            self.problems.error_help::<()>("bad-value", message, &node.place, help);
            return Vec::new();
        }
        if self.room_for(items.len(), node).is_none() {
            return Vec::new();
        }
        items.iter().filter_map(|item| self.point(item).map(|point| (point, item.place.clone()))).collect()
    }

    /// The full width of a tolerance; half of it with a sign is what drawings have.
    pub(super) fn width(&mut self, node: &Node, what: &str) -> Option<Micrometres> {
        let half = self.problems.text(node)?.strip_prefix('±').map(|half| half.trim().replace(',', "."));
        if let Some(Ok(half)) = half.map(|half| half.parse::<Micrometres>()) {
            let text = self.problems.text(node)?.to_owned();
            let message = note!("part-tolerance-is-a-width", text = text, width = (half + half).to_string());
            return self.problems.error("bad-value", message, &node.place);
        }
        self.positive(node, what)
    }

    pub(super) fn centre_tolerance(&mut self, node: &Node) -> Option<CentreTolerance> {
        // Cyrillic ІТ looks like the Latin letters and is typed as often.
        let text = self.problems.text(node)?.to_uppercase().replace('І', "I").replace('Т', "T");
        if let Some(grade) = text.strip_prefix("IT") {
            let it = grade.trim().parse().ok().and_then(ItGrade::new).filter(|it| (5..=14).contains(&it.number()));
            if it.is_none() {
                let message = note!("part-outside-which-table-grades-covers", text = text);
                return self.problems.error("bad-value", message, &node.place);
            }
            return it.map(|it| CentreTolerance::Grade { it });
        }
        let width = self.width(node, "centre_tolerance")?;
        // The columns of the scheme tables end there; a larger figure is a misplaced decimal point.
        let tables = self.knowledge.tables_of::<SchemesOfMainHole<'_>>();
        let mut domains = tables.filter_map(SchemesOfMainHoleFor::centre_tolerance).map(Column::allowed);
        if domains.any(|domain| !domain.contains(width.micrometres())) {
            let message = note!("part-mm-coarser-than-any-tolerance", width = width);
            let help = note!("part-give-full-width-tolerance-mm");
            return self.problems.error_help("bad-value", message, &node.place, help);
        }
        Some(CentreTolerance::Width(width))
    }
}
