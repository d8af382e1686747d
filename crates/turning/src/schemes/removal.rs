//! The removal schemes for stepped shafts (lecture 12.4, l. 684-790): in which order the tool removes the pieces
//! between horizontals and verticals.

use crate::turning::length::Half;
use crate::turning::point::Point;

use super::levels::{Cylinder, Levels};
use super::path::{SchemePath, Vertex};

pub use crate::tables::turning::passes::Removal as Scheme;

/// The toolpath over a zone, from home and back, with the approach δ and the retract.
pub fn path(scheme: Scheme, levels: &Levels, approach: Half, retract: Half) -> Vec<Vertex> {
    let largest = levels.cylinders.iter().map(|one| one.blank).max().unwrap_or_default();
    let mut path = SchemePath::new(largest, approach, retract);
    for section in levels.sections() {
        match scheme {
            Scheme::Verticals => verticals(levels, section, &mut path),
            Scheme::Levels => by_levels(levels, section, &mut path),
            Scheme::HorizontalsA => {
                // All levels but the last of each cylinder, which the pass along the contour removes.
                let counts = section.iter().map(|one| levels.count(one) - 1);
                straight(levels, section, &counts.collect::<Vec<_>>(), &mut path);
                contour(section, &mut path);
            }
            Scheme::HorizontalsB => {
                let counts = section.iter().map(|one| levels.full(one));
                straight(levels, section, &counts.collect::<Vec<_>>(), &mut path);
                contour(section, &mut path);
            }
        }
    }
    path.home()
}

/// Cylinder after cylinder, each level by level. The last pass of a cylinder goes up its face, and on along the stock
/// of the next cylinder to the first level of that one, where the tool is already at the metal.
fn verticals(levels: &Levels, section: &[Cylinder], path: &mut SchemePath) {
    for (index, cylinder) in section.iter().enumerate() {
        for level in 1..=levels.count(cylinder) {
            if level > 1 || index == 0 {
                let radius = levels.horizontal(cylinder, level).max(cylinder.radius);
                path.start(Point { radius, z: cylinder.from });
            }
            path.along(cylinder.to);
        }
        if let Some(wall) = cylinder.wall {
            path.corner(wall);
        }
        if let Some(next) = section.get(index + 1) {
            path.rise(levels.horizontal(next, 1).max(next.radius));
        }
    }
}

/// Level after level over all cylinders. If a cylinder ends above a level, the tool goes up the face and on along that
/// cylinder; where it reaches the surface of a cylinder, it cleans the face at its end.
fn by_levels(levels: &Levels, section: &[Cylinder], path: &mut SchemePath) {
    let Some(first) = section.first() else { return };
    for level in 1..=levels.count(first) {
        let (above, at) = (levels.horizontal(first, level - 1), levels.horizontal(first, level));
        let over: Vec<_> = section.iter().take_while(|one| one.radius < above).collect();
        path.start(Point { radius: at.max(first.radius), z: first.from });
        for (index, cylinder) in over.iter().enumerate() {
            // The pass goes straight on if the next cylinder is under this level too.
            let on_surface = at <= cylinder.radius;
            let ends = on_surface || over.get(index + 1).is_none_or(|next| next.radius > at);
            if !ends {
                continue;
            }
            path.along(cylinder.to);
            match (over.get(index + 1), cylinder.wall) {
                (Some(next), _) => path.corner(next.radius),
                (None, Some(wall)) if on_surface => path.corner(wall),
                _ => {}
            }
        }
    }
}

/// Straight passes, a number for each cylinder. The numbers fall towards the chuck, so a level ends at the first
/// cylinder that does not have it.
fn straight(levels: &Levels, section: &[Cylinder], counts: &[i64], path: &mut SchemePath) {
    let Some(first) = section.first() else { return };
    for level in 1..=counts.first().copied().unwrap_or(0) {
        let over = section.iter().zip(counts).take_while(|(_, count)| **count >= level);
        if let Some((last, _)) = over.last() {
            path.start(Point { radius: levels.horizontal(first, level), z: first.from });
            path.along(last.to);
        }
    }
}

/// One pass along the whole contour of a section.
fn contour(section: &[Cylinder], path: &mut SchemePath) {
    let Some(first) = section.first() else { return };
    path.start(Point { radius: first.radius, z: first.from });
    for cylinder in section {
        path.along(cylinder.to);
        if let Some(wall) = cylinder.wall {
            path.corner(wall);
        }
    }
}
