//! A section of metal as vertical columns, cut down by toolpaths: a second opinion on what a toolpath leaves,
//! independent of the code that makes toolpaths. And random zones for property tests.

use proptest::prelude::*;
use technolog::turning::contour::{Contour, Curve, Piece, Side, Turn};
use technolog::turning::length::Half;
use technolog::turning::point::Point;
use technolog::turning::toolpath::{Purpose, Toolpath};
use technolog::turning::transitions::{Feeds, Settings, Stock, Tool};
use technolog::units::{Degrees, MillimetresPerMinute};

/// What rounding of points to half a micrometre may do, mm.
pub const ROUNDING: f64 = 0.0015;

/// How far beside a point of a contour or a way a column stands: 3 µm, as far as slots are wall for the room under test.
pub const BESIDE: Half = Half::new(6);

pub fn mm(value: f64) -> Half {
    Half::from(value)
}

pub fn at(radius: f64, z: f64) -> Point {
    Point { radius: mm(radius), z: mm(z) }
}

pub fn settings(depth: f64) -> Settings {
    let rate = MillimetresPerMinute;
    Settings {
        depth: mm(depth),
        approach: mm(2.0),
        retract: mm(0.5),
        feeds: Feeds {
            main: rate(180.0),
            infeed: rate(90.0),
            pick_up: rate(120.0),
            semi_finish: rate(150.0),
            finish: rate(60.0),
            rapid: rate(6000.0),
        },
    }
}

pub fn tool(nose_radius: f64) -> Tool {
    Tool { nose_radius: mm(nose_radius), main: Degrees(95.0), secondary: Degrees(90.0) }
}

/// The radius of a piece at a Z in mm, between its ends: a line by its slope, an arc by its own circle.
fn on(piece: &Piece, z: f64) -> f64 {
    let (x0, y0) = (piece.from.z.to_mm(), piece.from.radius.to_mm());
    let (x1, y1) = (piece.to.z.to_mm(), piece.to.radius.to_mm());
    match piece.curve {
        Curve::Line => y0 + (y1 - y0) * (z - x0) / (x1 - x0),
        Curve::Arc { radius, turn } => {
            // The centre: on the middle line of the chord, to the left of the way where the arc turns left.
            let (dx, dy) = (x1 - x0, y1 - y0);
            let chord = (dx * dx + dy * dy).sqrt();
            let radius = radius.to_mm();
            let height = (radius * radius - chord * chord / 4.0).max(0.0).sqrt();
            let side = if turn == Turn::Left { 1.0 } else { -1.0 };
            let (cx, cy) = ((x0 + x1) / 2.0 - side * dy / chord * height, (y0 + y1) / 2.0 + side * dx / chord * height);
            let half = (radius * radius - (z - cx) * (z - cx)).max(0.0).sqrt();
            // For at most half a circle the chord lies between the two points of the circle, and the centre on the other
            // side of it: above where the way turns left and does not run back.
            if (turn == Turn::Left) == (dx > 0.0) { cy - half } else { cy + half }
        }
    }
}

/// The radius of a contour at a Z, of the pieces that pass it; the greatest where a face stands on it.
pub fn radius_at(contour: &Contour, z: Half) -> Option<f64> {
    let over = contour.pieces.iter().filter(|piece| piece.from.z != piece.to.z);
    let over = over.filter(|piece| piece.from.z <= z && z <= piece.to.z);
    over.map(|piece| on(piece, z.to_mm())).reduce(f64::max)
}

/// Where columns stand: on a grid, and [`BESIDE`] to each side of every corner and of every point of a way, but on no
/// corner, where a face has more than one radius.
pub fn places(corners: &[Half], points: impl Iterator<Item = Half>, from: Half, to: Half) -> Vec<Half> {
    let beside = corners.iter().copied().chain(points).flat_map(|z| [z - BESIDE, z + BESIDE]);
    let mut places: Vec<Half> = beside.collect();
    places.extend((0..).map(|step| from + Half::new(211 + 997 * step)).take_while(|z| *z < to));
    let turning = |z: Half| corners.iter().any(|corner| (*corner - z).halves().abs() < 5);
    places.retain(|z| from + Half::new(5) < *z && *z < to - Half::new(5) && !turning(*z));
    places.sort();
    places.dedup();
    places
}

/// Metal as columns.
#[derive(Clone)]
pub struct Columns {
    pub places: Vec<Half>,
    pub heights: Vec<f64>,
    pub rough: Vec<f64>,
    /// The least and the greatest radius of the rough contour a micrometre to each side.
    pub around: Vec<(f64, f64)>,
}

impl Columns {
    /// Of a zone.
    pub fn of(stock: &Stock, toolpath: &Toolpath) -> Self {
        let corners: Vec<Half> =
            [&stock.rough, &stock.blank].into_iter().flat_map(Contour::corners).map(|corner| corner.z).collect();
        let places = places(&corners, toolpath.moves.iter().map(|one| one.to.z), stock.from, stock.to);
        let around = |z: &Half| {
            let near = [Half::new(-2), Half::new(-1), Half::ZERO, Half::new(1), Half::new(2)];
            let radii = near.iter().filter_map(|by| radius_at(&stock.rough, *z + *by));
            radii.fold((f64::INFINITY, 0.0_f64), |(least, most), radius| (least.min(radius), most.max(radius)))
        };
        Self {
            heights: places.iter().map(|z| radius_at(&stock.blank, *z).unwrap()).collect(),
            rough: places.iter().map(|z| radius_at(&stock.rough, *z).unwrap()).collect(),
            around: places.iter().map(around).collect(),
            places,
        }
    }

    /// Place a motion off. Tells every column that it takes from: its place, how high it was, and how high it is.
    pub fn cut(&mut self, piece: &Piece, edge: Option<Half>) -> Vec<(usize, f64, f64)> {
        let mut taken = Vec::new();
        let (from, to) = (piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z));
        let from = if from == to { from - edge.unwrap_or_default() } else { from };
        for (index, z) in self.places.iter().enumerate() {
            if *z < from || *z > to || piece.from.z == piece.to.z && edge.is_none() {
                continue;
            }
            let left = if piece.from.z == piece.to.z { piece.to.radius.to_mm() } else { on(piece, z.to_mm()) };
            if left < self.heights[index] {
                taken.push((index, self.heights[index], left));
                self.heights[index] = left;
            }
        }
        taken
    }

    /// How deep a rapid goes into metal, mm: 0 or less where it does not. An upright one may touch a wall at one side.
    pub fn hit(&self, piece: &Piece) -> f64 {
        let (from, to) = (piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z));
        let near = |z: Half| self.places.partition_point(|place| *place < z);
        if from == to {
            let low = piece.from.radius.min(piece.to.radius).to_mm();
            let (before, behind) = (near(from).checked_sub(1), near(from));
            let at = |index: usize| {
                let close = self.places.get(index).is_some_and(|place| (*place - from).halves().abs() <= 14);
                // The column stands a little aside: on a slope its height differs by what the slope rises there.
                close.then(|| self.heights[index] - 3.0 * (self.around[index].1 - self.around[index].0))
            };
            // Beyond the ends of the zone is air.
            if before.is_none() || behind == self.places.len() {
                return f64::NEG_INFINITY;
            }
            let heights: Vec<f64> = [before.and_then(at), at(behind)].into_iter().flatten().collect();
            return heights.into_iter().reduce(f64::min).map_or(f64::NEG_INFINITY, |height| height - low);
        }
        let inside = self.places.iter().zip(&self.heights).filter(|(z, _)| from < **z && **z < to);
        inside.map(|(z, height)| height - on(piece, z.to_mm())).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// What a way does to a zone.
pub struct Worked {
    pub columns: Columns,
    /// The most that a motion goes below the rough contour.
    pub below: f64,
    /// The most that a rapid goes into metal.
    pub hit: f64,
    /// The most that one motion at a feed takes off a column.
    pub depth: f64,
    /// The most that is left above the rough contour.
    pub left: f64,
}

/// Place a whole way off.
pub fn simulate(stock: &Stock, toolpath: &Toolpath, edge: Option<Half>) -> Worked {
    let mut columns = Columns::of(stock, toolpath);
    let (mut below, mut hit, mut depth) = (f64::NEG_INFINITY, f64::NEG_INFINITY, 0.0_f64);
    for (piece, purpose) in toolpath.pieces() {
        if purpose == Purpose::Rapid {
            hit = hit.max(columns.hit(&piece));
            continue;
        }
        for (index, was, is) in columns.cut(&piece, edge.filter(|_| purpose == Purpose::Cut)) {
            depth = depth.max(was - is);
            below = below.max(columns.around[index].0 - is);
        }
    }
    let over = columns.heights.iter().zip(&columns.around);
    let left = over.map(|(height, (_, rough))| height - rough).fold(0.0, f64::max);
    Worked { columns, below, hit, depth, left }
}

/// A part of a random contour: what it is, how long, and how high.
#[derive(Clone, Copy, Debug)]
pub enum Part {
    Cylinder(i64),
    Cone(i64, i64),
    Face(i64),
    Fillet(i64),
    Ball(i64),
    /// Down by a quarter that begins upright (a fillet walked down), and one that begins level.
    FilletDown(i64),
    BallDown(i64),
}

/// A contour of parts in half micrometres, from a radius; parts that would leave the radii 4 to 40 mm are dropped.
pub fn contour(start: i64, parts: &[Part]) -> Contour {
    let mut contour = Contour { side: Side::Outer, pieces: Vec::new() };
    let mut here = Point { radius: Half::new(start), z: Half::ZERO };
    for part in parts {
        let by = |radius: i64, z: i64| Point { radius: here.radius + Half::new(radius), z: here.z + Half::new(z) };
        let piece = match *part {
            Part::Cylinder(length) => Piece::line(here, by(0, length)),
            Part::Cone(height, length) => Piece::line(here, by(height, length)),
            Part::Face(height) => Piece::line(here, by(height, 0)),
            Part::Fillet(size) => Piece::arc(here, by(size, size), Half::new(size), Turn::Left),
            Part::Ball(size) => Piece::arc(here, by(size, size), Half::new(size), Turn::Right),
            Part::FilletDown(size) => Piece::arc(here, by(-size, size), Half::new(size), Turn::Left),
            Part::BallDown(size) => Piece::arc(here, by(-size, size), Half::new(size), Turn::Right),
        };
        let faces = piece.is_face() && contour.pieces.last().is_some_and(|last| last.is_face());
        if (8_000..=80_000).contains(&piece.to.radius.halves()) && !piece.is_nothing() && !faces {
            here = piece.to;
            contour.pieces.push(piece);
        }
    }
    if contour.pieces.iter().all(|piece| piece.is_face()) {
        contour.pieces.push(Piece::line(here, Point { z: here.z + Half::new(10_000), ..here }));
    }
    // A contour that begins with a face up or ends with one down has none there: nothing stands over it.
    while contour.pieces.first().is_some_and(|piece| piece.is_face()) {
        contour.pieces.remove(0);
    }
    contour
}

fn part() -> impl Strategy<Value = Part> {
    prop_oneof![
        (400_i64..20_000).prop_map(Part::Cylinder),
        (-16_000_i64..16_000, 1_500_i64..20_000).prop_map(|(height, length)| Part::Cone(height, length)),
        (-12_000_i64..16_000).prop_map(Part::Face),
        (600_i64..10_000).prop_map(Part::Fillet),
        (600_i64..10_000).prop_map(Part::Ball),
        (600_i64..10_000).prop_map(Part::FilletDown),
        (600_i64..10_000).prop_map(Part::BallDown),
    ]
}

/// The zone of a contour under a bar so much above its highest point, or where `second` is given under a blank that is
/// larger by so much behind the share of its length. Where `wall`, the contour ends with a face up to the blank.
pub fn zone(mut rough: Contour, above: i64, second: Option<(i64, i64)>, wall: bool) -> Stock {
    let (from, to) = (rough.start().unwrap().z, rough.end().unwrap().z);
    let top = rough.radii().unwrap().1 + Half::new(above);
    let mut corners = vec![Point { radius: top, z: from }];
    let mut last = top;
    if let Some((larger, share)) = second {
        let z = Half::new(from.halves() + (to - from).halves() * share / 100);
        last = top + Half::new(larger);
        corners.extend([Point { radius: top, z }, Point { radius: last, z }]);
    }
    corners.push(Point { radius: last, z: to });
    let end = rough.end().unwrap();
    if wall && !rough.pieces.last().unwrap().is_face() {
        rough.pieces.push(Piece::line(end, Point { radius: last, z: end.z }));
    }
    let pieces: Vec<Piece> = rough.pieces.into_iter().filter(|piece| !piece.is_nothing()).collect();
    Stock { rough: Contour { side: Side::Outer, pieces }, blank: Contour::through(Side::Outer, &corners), from, to }
}

/// Any zone of lines and arcs.
pub fn zones() -> impl Strategy<Value = Stock> {
    let second = prop_oneof![Just(None), (1_000_i64..12_000, 10_i64..90).prop_map(Some)];
    (10_000_i64..50_000, prop::collection::vec(part(), 1..8), 0_i64..12_000, second, any::<bool>())
        .prop_map(|(start, parts, above, second, wall)| zone(contour(start, &parts), above, second, wall))
        .prop_filter("a zone without length", |stock| stock.from < stock.to)
        // Between two corners that are nearer than that no column stands that would see what is done there.
        .prop_filter("strips too narrow for a column", |stock| {
            let faces = stock.blank.pieces.iter().filter(|piece| piece.is_face());
            let near = |z: Half| {
                stock.rough.corners().iter().any(|corner| (corner.z - z).halves().abs() < 2 * BESIDE.halves())
            };
            faces.map(|face| face.from.z).all(|z| !near(z))
        })
}

/// A closed zone: the contour falls from the surface of a bar and rises to it again, by lines and arcs. No flank is
/// upright in its middle: there the rounding of points may part where a pass ended from where the next begins, and the
/// tool then goes round through air.
pub fn valleys() -> impl Strategy<Value = Stock> {
    let down = prop_oneof![
        (500_i64..8_000, 1_500_i64..9_000).prop_map(|(height, length)| Part::Cone(-height, length)),
        (600_i64..6_000).prop_map(Part::FilletDown),
        (500_i64..9_000).prop_map(|height| Part::Face(-height)),
    ];
    let up = prop_oneof![
        (500_i64..8_000, 1_500_i64..9_000).prop_map(|(height, length)| Part::Cone(height, length)),
        (600_i64..6_000).prop_map(Part::Fillet),
        (600_i64..6_000).prop_map(Part::Ball),
    ];
    let flank = |part| prop::collection::vec(part, 1..4);
    let valley = (flank(down.boxed()), 1_000_i64..20_000, flank(up.boxed())).prop_map(|(down, floor, up)| {
        let parts: Vec<Part> =
            [Part::Cylinder(3_000)].into_iter().chain(down).chain([Part::Cylinder(floor)]).chain(up).collect();
        let rough = contour(60_000, &parts);
        // Up to the bar again, with a wall, and a land behind it.
        let (end, bar) = (rough.end().unwrap(), rough.radii().unwrap().1);
        let mut pieces = rough.pieces;
        let land = Point { radius: bar, z: end.z };
        pieces.push(Piece::line(end, land));
        pieces.push(Piece::line(land, Point { z: end.z + Half::new(3_000), ..land }));
        pieces.retain(|piece| !piece.is_nothing());
        zone(Contour { side: Side::Outer, pieces }, 0, None, false)
    });
    valley.prop_filter("it rises above the bar", |stock| stock.rough.radii().unwrap().1 == Half::new(60_000))
}

/// Rising steps, each at least as long as all stock is high, so that [`steps_beside`] has no corners to lose.
pub fn steps() -> impl Strategy<Value = Stock> {
    let step = (21.0_f64..40.0, 1.0_f64..6.0);
    (prop::collection::vec(step, 1..4), 1.0_f64..4.0, any::<bool>()).prop_map(|(steps, above, wall)| {
        let (mut points, mut radius, mut z) = (vec![at(10.0, 0.0)], 10.0, 0.0);
        for (index, (length, height)) in steps.iter().enumerate() {
            z += length;
            points.push(at(radius, z));
            if index + 1 < steps.len() {
                radius += height;
                points.push(at(radius, z));
            }
        }
        zone(Contour::through(Side::Outer, &points), mm(above).halves(), None, wall)
    })
}

/// The exact equidistant of rising steps: faces forward, cylinders outwards, round about the corners between. Where a
/// face is lower than the distance, the cylinder before it meets the arc about its corner.
pub fn steps_beside(steps: &Contour, distance: Half) -> Option<Contour> {
    let mut beside = Contour { side: Side::Outer, pieces: Vec::new() };
    let mut here = Point { radius: steps.start()?.radius + distance, z: steps.start()?.z };
    let mut go = |to: Point, arc: bool, here: &mut Point| {
        let piece = if arc { Piece::arc(*here, to, distance, Turn::Right) } else { Piece::line(*here, to) };
        if !piece.is_nothing() {
            beside.pieces.push(piece);
        }
        *here = to;
    };
    for (index, piece) in steps.pieces.iter().enumerate() {
        if !piece.is_face() {
            let last = index + 1 == steps.pieces.len();
            if last {
                go(Point { z: piece.to.z, ..here }, false, &mut here);
            }
            continue;
        }
        let (height, ends) = (piece.to.radius - piece.from.radius, index + 1 == steps.pieces.len());
        let off = if height >= distance {
            distance
        } else {
            let (d, h) = (distance.to_mm(), height.to_mm());
            mm((2.0 * d * h - h * h).sqrt())
        };
        go(Point { z: piece.from.z - off, ..here }, false, &mut here);
        if height >= distance {
            go(Point { radius: piece.to.radius, ..here }, false, &mut here);
        }
        if !ends {
            go(Point { radius: piece.to.radius + distance, z: piece.from.z }, true, &mut here);
        }
    }
    Some(beside)
}
