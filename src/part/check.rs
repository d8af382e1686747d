//! What must hold between the values of a part: names unique, holes inside the blank, points apart,
//! clamps on the blank and beside the holes.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Problems;
use crate::units::Micrometres;

use super::{Blank, Datum, Hole, Point};

/// A group of holes as far as it could be read, with the places its mistakes are reported at, so that
/// a slip in one key does not hide a slip in another.
pub(super) struct Group {
    pub name: Option<(String, Place)>,
    pub diameter: Option<Micrometres>,
    pub depth: Option<(Micrometres, Place)>,
    pub through: Option<bool>,
    /// The list of points.
    pub at: Option<Place>,
    pub points: Vec<(Point, Place)>,
    /// The whole, when nothing of it was missing.
    pub hole: Option<Hole>,
}

impl Group {
    fn label(&self) -> &str {
        self.name.as_ref().map_or("?", |(name, _)| name)
    }
}

/// No two groups of one name.
pub(super) fn names(groups: &[Group], problems: &mut Problems) {
    for (index, group) in groups.iter().enumerate() {
        let Some((name, place)) = &group.name else { continue };
        if groups[..index].iter().any(|other| other.name.as_ref().is_some_and(|(known, _)| known == name)) {
            let message = format!("two groups of holes are named `{name}`");
            problems.error_help::<()>("duplicate-name", message, place, "name each group once");
        }
    }
}

/// Depths against the thickness, every hole inside the blank, no two holes in each other.
pub(super) fn geometry(groups: &[Group], blank: &Blank, datum: &Datum, problems: &mut Problems) {
    for group in groups {
        depth(group, blank, problems);
        inside(group, blank, datum, problems);
    }
    apart(groups, problems);
}

/// Every clamp presses on the blank, and not on a hole.
pub(super) fn clamps(
    clamps: &[(Point, Place)],
    groups: &[Group],
    blank: &Blank,
    datum: &Datum,
    problems: &mut Problems,
) {
    for (point, place) in clamps {
        if reaches_out(*point, Micrometres::ZERO, blank, datum) {
            let message = format!("the clamp at [{}, {}] is not on the blank", point.x, point.y);
            problems.error_help::<()>("outside-blank", message, place, extent(blank, datum));
        }
        let under = groups.iter().find(|group| {
            let radius = group.diameter.unwrap_or_default().half();
            group.points.iter().any(|(hole, _)| hole.distance(*point) < radius)
        });
        if let Some(group) = under {
            let message = format!("the clamp at [{}, {}] presses on hole {}", point.x, point.y, group.label());
            problems.error_help::<()>("clamp-on-hole", message, place, "put it beside the hole");
        }
    }
}

fn depth(group: &Group, blank: &Blank, problems: &mut Problems) {
    let (Some((depth, place)), Some(through)) = (&group.depth, group.through) else { return };
    let (name, thickness) = (group.label(), blank.thickness);
    if through && *depth != thickness {
        let message = format!("hole {name}: a through hole is {depth} deep, but the blank is {thickness} thick");
        problems.error_help::<()>("bad-depth", message, place, "leave `depth` out, or make it the thickness");
    } else if !through && *depth >= thickness {
        let message = format!("hole {name}: a blind hole is {depth} deep in a blank {thickness} thick");
        problems.error_help::<()>("bad-depth", message, place, "say `through: true`, or make it shallower");
    }
}

fn inside(group: &Group, blank: &Blank, datum: &Datum, problems: &mut Problems) {
    let Some(diameter) = group.diameter else { return };
    let outside: Vec<&(Point, Place)> =
        group.points.iter().filter(|(point, _)| reaches_out(*point, diameter.half(), blank, datum)).collect();
    let what = format!("hole {}: Ø{diameter}", group.label());
    if let (Some(at), true) = (&group.at, outside.len() > 1 && outside.len() == group.points.len()) {
        // All of them: one mistake, in the datum or the blank, not one in each point.
        let message = format!("{what} is not inside the blank at any of its {} points", outside.len());
        let help = format!("{}; `datum` says where its zeros lie", extent(blank, datum));
        problems.error_help::<()>("outside-blank", message, at, help);
        return;
    }
    for (point, place) in outside {
        let message = format!("{what} at [{}, {}] is not inside the blank", point.x, point.y);
        problems.error_help::<()>("outside-blank", message, place, extent(blank, datum));
    }
}

/// Whether a circle reaches beyond the blank.
fn reaches_out(point: Point, radius: Micrometres, blank: &Blank, datum: &Datum) -> bool {
    let (right, back) = (datum.left + blank.length, datum.front + blank.width);
    point.x - radius < datum.left
        || point.x + radius > right
        || point.y - radius < datum.front
        || point.y + radius > back
}

fn extent(blank: &Blank, datum: &Datum) -> String {
    let (right, back) = (datum.left + blank.length, datum.front + blank.width);
    format!("the blank reaches from X {} to {right} and from Y {} to {back}", datum.left, datum.front)
}

/// A hole that runs into one before it.
struct Meeting<'g> {
    point: Point,
    place: &'g Place,
    other: &'g Group,
    other_place: &'g Place,
    distance: Micrometres,
    needed: Micrometres,
}

fn apart(groups: &[Group], problems: &mut Problems) {
    for (index, group) in groups.iter().enumerate() {
        let meetings: Vec<Meeting<'_>> =
            (0..group.points.len()).filter_map(|number| meeting(group, number, &groups[..index])).collect();
        let Some(first) = meetings.first() else { continue };
        let (same_other, itself) =
            (meetings.iter().all(|meeting| std::ptr::eq(meeting.other, first.other)), std::ptr::eq(first.other, group));
        let every_one = meetings.len() + usize::from(itself) == group.points.len();
        if let (Some(at), true) = (&group.at, meetings.len() > 1 && same_other && every_one) {
            // Points copied from another group, or a wrong diameter: one mistake, not one in each point.
            let message = if itself {
                format!("the holes of {} run into each other", group.label())
            } else {
                let (name, other) = (group.label(), first.other.label());
                format!("every hole of {name} runs into hole {other} at line {}", first.other_place.line)
            };
            let help = format!("mind the diameter, and the points: {}", first.gap());
            problems.error_help::<()>("holes-meet", message, at, help);
            continue;
        }
        for meeting in meetings {
            let Meeting { point, place, other, other_place, .. } = meeting;
            let message = format!(
                "hole {} at [{}, {}] runs into hole {} at line {}",
                group.label(),
                point.x,
                point.y,
                other.label(),
                other_place.line
            );
            problems.error_help::<()>("holes-meet", message, place, meeting.gap());
        }
    }
}

impl Meeting<'_> {
    fn gap(&self) -> String {
        format!("the centres are {} mm apart, and the holes need {}", self.distance, self.needed)
    }
}

/// The first hole of the groups before, or of the points before in its own group, that a hole runs into.
fn meeting<'g>(group: &'g Group, number: usize, before: &'g [Group]) -> Option<Meeting<'g>> {
    let (point, place) = &group.points[number];
    let diameter = group.diameter?;
    let others = before.iter().map(|other| (other, other.points.as_slice()));
    others.chain([(group, &group.points[..number])]).find_map(|(other, points)| {
        let needed = (diameter + other.diameter?).half();
        points.iter().find_map(|(other_point, other_place)| {
            // Most holes are far apart along one axis; that costs no root.
            let (x, y) = ((point.x - other_point.x).abs(), (point.y - other_point.y).abs());
            let distance = Some(point.distance(*other_point)).filter(|_| x < needed && y < needed)?;
            (distance < needed).then_some(Meeting { point: *point, place, other, other_place, distance, needed })
        })
    })
}
