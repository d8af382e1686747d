//! A whole part worked off set-up by set-up, side by side, by every taken way in order: a second opinion on an operation,
//! by the columns of `section.rs`. A bore is looked at inside out.

use technolog::turning::contour::{Contour, Side};
use technolog::turning::length::Half;
use technolog::turning::operation::{Operation, SetUpWork, SideWork};
use technolog::turning::point::Point;
use technolog::turning::toolpath::{Move, Purpose, Toolpath};
use technolog::turning::transitions::Scheme;

use super::section::{Columns, ROUNDING, places, radius_at};

/// What a law says that is broken.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Which law.
    pub law: &'static str,
    /// Set-up, side and zone, and the scheme.
    pub at: String,
    /// How much, mm.
    pub by: f64,
    /// Where, Z of the set-up.
    pub z: f64,
}

/// The metal of one side over the whole blank, as heights above `top`'s zero: outside the radius, inside `top` less it.
struct Metal {
    columns: Columns,
    top: Half,
    side: Side,
}

fn seen_point(point: Point, side: Side, top: Half) -> Point {
    if side == Side::Outer { point } else { Point { radius: top - point.radius, ..point } }
}

fn seen_way(way: &Toolpath, side: Side, top: Half) -> Toolpath {
    if side == Side::Outer {
        return way.clone();
    }
    let moves = way.pieces().map(|(piece, purpose)| {
        let piece = piece.mapped(true, |point| seen_point(point, side, top));
        Move { to: piece.to, curve: piece.curve, purpose }
    });
    Toolpath { moves: moves.collect(), from: seen_point(way.from, side, top) }
}

fn seen(contour: &Contour, side: Side, top: Half) -> Contour {
    if side == Side::Outer { contour.clone() } else { contour.inside_out(top) }
}

/// The height of a blank at a Z, beyond its ends none.
fn height(contour: Option<&Contour>, z: Half) -> f64 {
    contour.and_then(|contour| radius_at(contour, z)).unwrap_or(f64::NEG_INFINITY)
}

impl Metal {
    /// Of the blank, in the coordinates of set-up 1, with columns for every way of a side.
    fn of(operation: &Operation, side: Side, top: Half) -> Self {
        let (length, blank) = (operation.workpiece.length(), &operation.workpiece.blank);
        let (mut corners, mut points) = (Vec::new(), Vec::new());
        for set_up in &operation.set_ups {
            let over = |z: Half| if set_up.set_up.turned_over { length - z } else { z };
            for one in set_up.sides.iter().filter(|one| one.side == side) {
                for contour in [&one.layers.blank, &one.layers.rough] {
                    corners.extend(contour.corners().iter().map(|corner| over(corner.z)));
                }
                let ways = one.zones.iter().flat_map(|zone| &zone.works).filter_map(|work| work.transition());
                points.extend(ways.flat_map(|way| way.path.moves.iter().map(|one| over(one.to.z))));
            }
        }
        let (from, to) = (blank.outer.start().unwrap().z, blank.outer.end().unwrap().z);
        let before = match side {
            Side::Outer => Some(seen(&blank.outer, side, top)),
            Side::Inner => blank.inner.as_ref().map(|inner| seen(inner, side, top)),
        };
        corners.extend(before.iter().flat_map(Contour::corners).map(|corner| corner.z));
        let places = places(&corners, points.into_iter(), from, to);
        let of_bore = |z: &Half| before.as_ref().map_or(top.to_mm(), |inner| height(Some(inner), *z));
        let heights = places.iter().map(of_bore).collect();
        let columns = Columns { rough: Vec::new(), around: Vec::new(), heights, places };
        Self { columns, top, side }
    }

    /// What facing has taken of a bore: where outside nothing stands above it any more.
    fn faced(&mut self, outer: &Self) {
        for (z, height) in self.columns.places.iter().zip(&mut self.columns.heights) {
            let next = outer.columns.places.partition_point(|place| place < z);
            let beside = [next.checked_sub(1), Some(next)].into_iter().flatten();
            let stands = beside.filter_map(|index| outer.columns.heights.get(index)).copied().fold(0.0, f64::max);
            if stands <= self.top.to_mm() - *height + ROUNDING {
                *height = f64::NEG_INFINITY;
            }
        }
    }

    /// Nothing stands before Z = 0 any more.
    fn cut_off(&mut self) {
        let columns = self.columns.places.iter().zip(&mut self.columns.heights);
        columns.filter(|(z, _)| **z < Half::ZERO).for_each(|(_, height)| *height = f64::NEG_INFINITY);
    }

    fn turn_over(&mut self, length: Half) {
        self.columns.places = self.columns.places.iter().rev().map(|z| length - *z).collect();
        self.columns.heights.reverse();
    }
}

/// Place an operation off and tells every fault.
pub fn work_off(operation: &Operation) -> Vec<Fault> {
    let mut faults = Vec::new();
    let top = operation.workpiece.blank.outer.radii().unwrap().1;
    let mut metals = [Side::Outer, Side::Inner].map(|side| Metal::of(operation, side, top));
    // A side that could not be carried out whole is not looked at any more.
    let mut whole = [true, true];
    let mut turned_over = false;
    for set_up in &operation.set_ups {
        if set_up.set_up.turned_over != turned_over {
            metals.iter_mut().for_each(|metal| metal.turn_over(operation.workpiece.length()));
            turned_over = set_up.set_up.turned_over;
        }
        // What stands before a far face that is not planned must be cut off before: a finding says it.
        let number = set_up.set_up.number.to_string();
        let cut_off = operation.findings.iter().map(|finding| &finding.note);
        if cut_off
            .filter(|note| note.code() == "far-face-not-planned")
            .any(|note| note.figure("number").is_some_and(|figure| figure.text() == number))
        {
            metals.iter_mut().for_each(Metal::cut_off);
        }
        for one in &set_up.sides {
            let index = usize::from(one.side == Side::Inner);
            if whole[index] {
                let (found, all) = set_up_off(&mut metals[index], set_up, one);
                faults.extend(found);
                whole[index] = all;
            }
            if one.side == Side::Outer {
                let [outer, inner] = &mut metals;
                inner.faced(outer);
            }
        }
    }
    faults
}

/// One side of a set-up, and whether all of it could be carried out.
fn set_up_off(metal: &mut Metal, set_up: &SetUpWork, one: &SideWork) -> (Vec<Fault>, bool) {
    let (side, top) = (metal.side, metal.top);
    let (rough, blank) = (seen(&one.layers.rough, side, top), seen(&one.layers.blank, side, top));
    let (start, end) = (rough.start().unwrap(), rough.end().unwrap());
    let mut faults = Vec::new();
    let columns = &mut metal.columns;
    // What was drilled, and whether the blank that is reckoned with is what stands.
    for (index, z) in columns.places.iter().enumerate() {
        let reckoned = height(Some(&blank), *z);
        if side == Side::Inner && (reckoned.is_finite() || *z < start.z) {
            columns.heights[index] = columns.heights[index].min(reckoned.max(f64::NEG_INFINITY));
        }
        let over = columns.heights[index] - reckoned;
        if side == Side::Outer && *z <= end.z && over > ROUNDING + 0.001 {
            faults.push(Fault {
                law: "the blank reckoned with is smaller than what stands",
                at: format!("set-up {} {side:?}", set_up.set_up.number),
                by: over,
                z: z.to_mm(),
            });
        }
    }
    // Before the face nothing stays above where the contour begins; behind the end all of it stays.
    let target = |z: Half| {
        if z < start.z {
            Some(start.radius.to_mm())
        } else if z > end.z {
            None
        } else {
            radius_at(&rough, z)
        }
    };
    // A face is cut down to where the blank begins: of a solid bar to the axis, also where a bore comes later.
    let core = blank.start().map_or(start.radius, |first| first.radius.min(start.radius)).to_mm();
    let near = [Half::new(-2), Half::new(-1), Half::ZERO, Half::new(1), Half::new(2)];
    columns.around = columns
        .places
        .iter()
        .map(|z| {
            let radii = near.iter().map(|by| target(*z + *by));
            radii.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), radius| {
                let radius = radius.unwrap_or(if *z > end.z { f64::INFINITY } else { f64::NAN });
                (least.min(if *z < start.z { core } else { radius }), most.max(radius))
            })
        })
        .collect();
    let mut allowed = vec![0.0_f64; columns.places.len()];
    let mut last: Option<Point> = None;
    for zone in &one.zones {
        // What is not cleared stands in the way of all that comes behind it; a finding says that it is not.
        if zone.works.is_empty() {
            return (faults, false);
        }
        for work in &zone.works {
            let Some(transition) = work.transition() else { return (faults, false) };
            let at = format!(
                "set-up {} {side:?} zone {} {} {:.1}..{:.1}",
                set_up.set_up.number,
                zone.zone.number,
                transition.scheme.name(),
                work.stock.from.to_mm(),
                work.stock.to.to_mm()
            );
            for (z, allowed) in columns.places.iter().zip(&mut allowed) {
                if work.stock.from <= *z && *z <= work.stock.to {
                    *allowed = allowed.max(transition.ridges_mm.to_mm());
                }
            }
            let way = seen_way(&transition.path, side, top);
            let axis = if side == Side::Inner { top } else { Half::new(i64::MAX) };
            if way.moves.iter().any(|one| one.to.radius > axis) || way.from.radius > axis {
                faults.push(Fault { law: "a bore's tool goes beyond the axis", at: at.clone(), by: 1.0, z: 0.0 });
            }
            // From the home of the way before to this one, as `programs` goes.
            let mut whole = Toolpath::at(last.unwrap_or(way.from));
            if let Some(last) = last {
                for corner in over(last, way.from, side) {
                    whole.go(corner, Purpose::Rapid);
                }
            }
            // The first move of the way begins there.
            let links = if whole.moves.is_empty() { 0 } else { whole.moves.len() + 1 };
            whole.moves.extend(way.moves.iter().copied());
            last = Some(whole.end());
            let limit = work.levels.depth.to_mm() + 2.0 * ROUNDING;
            let deep = [Scheme::Descent, Scheme::Contour, Scheme::Equidistant].contains(&transition.scheme);
            let mut worst: Vec<Fault> = Vec::new();
            let mut tell = |law: &'static str, by: f64, z: f64| match worst.iter_mut().find(|one| one.law == law) {
                Some(one) if one.by < by => (one.by, one.z) = (by, z),
                Some(_) => {}
                None => worst.push(Fault { law, at: at.clone(), by, z }),
            };
            for (index, (piece, purpose)) in whole.pieces().enumerate() {
                if purpose == Purpose::Rapid {
                    let hit = columns.hit(&piece);
                    if hit > ROUNDING {
                        let law = if index < links {
                            "a way between zones goes through metal"
                        } else {
                            "a rapid goes through metal"
                        };
                        tell(law, hit, piece.to.z.to_mm());
                    }
                    continue;
                }
                let edge = transition.edge.filter(|_| purpose == Purpose::Cut);
                for (column, was, is) in columns.cut(&piece, edge) {
                    let z = columns.places[column].to_mm();
                    let floor = columns.around[column].0;
                    if !deep && was - is > limit {
                        tell("a pass takes more than t_p", was - is - work.levels.depth.to_mm(), z);
                    }
                    if floor.is_infinite() {
                        if was - is > ROUNDING {
                            tell("the tool cuts behind the end of what the set-up turns", was - is, z);
                        }
                    } else if floor - is > ROUNDING {
                        tell("the tool cuts below the rough contour", floor - is, z);
                    }
                }
            }
            faults.extend(worst);
        }
    }
    let mut most: Option<Fault> = None;
    for (index, z) in columns.places.iter().enumerate() {
        let over = columns.heights[index] - columns.around[index].1 - allowed[index];
        if *z <= end.z && over > 2.0 * ROUNDING && most.as_ref().is_none_or(|most| most.by < over) {
            let at = format!("set-up {} {side:?}", set_up.set_up.number);
            most = Some(Fault { law: "metal is left above the rough contour", at, by: over, z: z.to_mm() });
        }
    }
    faults.extend(most);
    (faults, true)
}

/// The way from a home to the next as the programs go it: away from the metal, and along.
fn over(from: Point, to: Point, side: Side) -> Vec<Point> {
    // Seen inside out, out of a bore is towards smaller Z, and off its metal is up as outside.
    let radius = from.radius.max(to.radius);
    let z = if side == Side::Inner { from.z.min(to.z) } else { from.z };
    vec![Point { radius, z }, Point { radius, z: to.z }]
}
