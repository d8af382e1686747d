//! Tools as convex pieces around their reference point.

use std::f64::consts::FRAC_PI_2;

use super::{Cutter, Hand, Holder, Side, Tool};
use crate::plane::{Convex, Vector, chords, turned};

/// The length of shanks, bars and drills, mm: the turret behind them is not known.
const FAR: f64 = 100.0;
/// The length of a bar, for the depth of bores, mm.
const BAR: f64 = 500.0;

/// A tool with its reference point at zero.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// The cutting parts.
    pub cuts: Vec<Convex>,
    /// The parts that must not touch metal.
    pub holds: Vec<Convex>,
}

impl Outline {
    /// Drawn as for a right-hand tool outside, with its point towards the axis and the chuck, then mirrored.
    pub fn of(tool: &Tool) -> Self {
        let (cuts, holds, side, hand) = match tool.cutter {
            Cutter::Insert { lead_angle, trail_angle, nose_radius, edge_length, hand, side } => {
                let angles = [lead_angle.0, trail_angle.0].map(f64::to_radians);
                let (edges, [main, second]) = insert(angles, nose_radius.0, edge_length.0, hand);
                let behind = Vector::new(main.z.max(second.z), main.r.max(second.r));
                (vec![edges], held(tool.holder, behind, &[main, second]), side, hand)
            }
            Cutter::Blade { width, corner_radius, depth, side } => {
                let blade = rounded(width.0, corner_radius.0, depth.0);
                let root = [Vector::new(0.0, depth.0), Vector::new(width.0, depth.0)];
                (vec![blade], held_blade(tool.holder, depth.0, &root), side, Hand::Right)
            }
            Cutter::FaceBlade { width, corner_radius, depth } => {
                let swap = |spot: Vector| Vector::new(spot.r, spot.z);
                let blade = rounded(width.0, corner_radius.0, depth.0).into_iter().map(swap).collect();
                (vec![blade], vec![behind_face(tool.holder, depth.0)], Side::Outside, Hand::Right)
            }
            Cutter::Thread { angle, reach, beside, side } => {
                let slope = libm::tan((angle.0 / 2.0).to_radians());
                let half = slope * reach.0;
                let ahead = half.min(beside.0);
                let root = [Vector::new(-ahead, reach.0), Vector::new(half, reach.0)];
                let point = vec![Vector::default(), Vector::new(-ahead, ahead / slope), root[0], root[1]];
                (vec![point], held(tool.holder, Vector::new(half, reach.0), &root), side, Hand::Right)
            }
            Cutter::Drill { diameter, point_angle, flute } => {
                let (cuts, shank) = drill(diameter.0 / 2.0, point_angle.0, flute.0);
                (vec![cuts], vec![shank], Side::Outside, Hand::Right)
            }
            Cutter::Reamer { diameter, front, lead, reach } => {
                let (radius, front) = (diameter.0 / 2.0, front.0 / 2.0);
                let edges = [(0.0, 0.0), (0.0, front), (lead.0, radius), (reach.0, radius), (reach.0, 0.0)];
                let cuts = edges.map(|(z, r)| Vector::new(z, r)).to_vec();
                let shank = Convex::rectangle(Vector::new(reach.0, 0.0), Vector::new(reach.0 + FAR, radius));
                (vec![cuts], vec![shank.to_vec()], Side::Outside, Hand::Right)
            }
            Cutter::Tap { diameter, core, lead, thread, neck, shank, free, .. } => {
                let (radius, core, shank) = (diameter.0 / 2.0, core.0 / 2.0, shank.0 / 2.0);
                let edges = [(0.0, 0.0), (0.0, core), (lead.0, radius), (thread.0, radius), (thread.0, 0.0)];
                let cuts = edges.map(|(z, r)| Vector::new(z, r)).to_vec();
                // A chuck is about twice as thick as what it holds.
                let body = [(0.0, neck.0, core), (neck.0, free.0, shank), (free.0, free.0 + FAR, 2.0 * shank)];
                let body = body.map(|(z, to, r)| Convex::rectangle(Vector::new(z, 0.0), Vector::new(to, r)).to_vec());
                (vec![cuts], body.to_vec(), Side::Outside, Hand::Right)
            }
            Cutter::CentreDrill { pilot, pilot_length, body } => {
                let (pilot, length, body) = (pilot.0 / 2.0, pilot_length.0, body.0 / 2.0);
                let (cuts, _) = drill(pilot, CENTRE_POINT, length);
                let cone = length + (body - pilot) / libm::tan(30_f64.to_radians());
                let sides = [(length, 0.0), (length, pilot), (cone, body), (cone, 0.0)].map(|(z, r)| Vector::new(z, r));
                let shank = Convex::rectangle(Vector::new(cone, 0.0), Vector::new(cone + FAR, body));
                (vec![cuts, sides.to_vec()], vec![shank.to_vec()], Side::Outside, Hand::Right)
            }
        };
        let mirror = |spot: Vector| {
            let z = if hand == Hand::Left { -spot.z } else { spot.z };
            Vector::new(z, if side == Side::Inside { -spot.r } else { spot.r })
        };
        let hulls = |pieces: Vec<Vec<Vector>>| {
            pieces.into_iter().filter_map(|piece| Convex::hull(piece.into_iter().map(mirror))).collect()
        };
        Self { cuts: hulls(cuts), holds: hulls(holds) }
    }
}

/// The full angle of a centre drill's point, degrees (ГОСТ 14952).
const CENTRE_POINT: f64 = 120.0;

/// The nose and both edges, and where the edges end.
fn insert([lead, trail]: [f64; 2], nose: f64, edge: f64, hand: Hand) -> (Vec<Vector>, [Vector; 2]) {
    let centre = if hand == Hand::Neutral { Vector::new(0.0, nose) } else { Vector::new(nose, nose) };
    let main = Vector::new(-libm::cos(lead), libm::sin(lead));
    let second = Vector::new(libm::cos(trail), libm::sin(trail));
    // Outward normals of the insert: the main edge faces the feed, the other one the surface.
    let (ahead, below) = (main.right().times(-1.0), second.right());
    let touching = [ahead, below].map(|normal| centre.plus(normal.times(nose)));
    let sharp = centre.plus(ahead.plus(below).times(nose / (1.0 + ahead.dot(below))));
    let least = touching[0].minus(sharp).length();
    let ends = [main, second].map(|along| sharp.plus(along.times(edge.max(least))));
    let mut spots = vec![touching[0]];
    if nose > 0.0 {
        spots.extend(chords(centre, touching[0], touching[1], turned(centre, touching[0], touching[1], true)));
        // The points of the nose that make cylinders and faces are exact, not on a chord.
        let makes = |path: &Vector| ahead.cross(*path) >= 0.0 && path.cross(below) >= 0.0;
        let ways = [Vector::new(-1.0, 0.0), Vector::new(0.0, -1.0)];
        spots.extend(ways.into_iter().filter(makes).map(|path| centre.plus(path.times(nose))));
    }
    spots.extend(ends);
    (spots, ends)
}

/// A blade with its corner at zero, cutting towards the axis.
fn rounded(width: f64, corner: f64, depth: f64) -> Vec<Vector> {
    let corner = corner.min(width / 2.0);
    let mut spots = vec![Vector::new(0.0, depth), Vector::new(width, depth)];
    for (centre, begin) in [(corner, -2.0 * FRAC_PI_2), (width - corner, -FRAC_PI_2)] {
        let centre = Vector::new(centre, corner);
        let from = centre.towards(begin, corner);
        spots.push(from);
        if corner > 0.0 {
            spots.extend(chords(centre, from, centre.towards(begin + FRAC_PI_2, corner), FRAC_PI_2));
        }
    }
    spots
}

/// A holder whose head ends at the ends of the edges. The head of a bar has run out into the bar one diameter behind them.
fn held(holder: Holder, behind: Vector, edges: &[Vector]) -> Vec<Vec<Vector>> {
    let hull = |body: [Vector; 4]| body.into_iter().chain(edges.iter().copied()).collect();
    match holder {
        Holder::None => Vec::new(),
        Holder::Shank { width, set_back } => {
            let far = Vector::new(set_back.0 + width.0, behind.r + FAR);
            vec![hull(Convex::rectangle(Vector::new(set_back.0, behind.r), far))]
        }
        Holder::Bar { diameter, stands_out } => {
            let to = |long: f64| Vector::new(behind.z + long, stands_out.0 + diameter.0);
            let bar = |long: f64| Convex::rectangle(Vector::new(behind.z, stands_out.0), to(long));
            vec![hull(bar(diameter.0)), bar(BAR).to_vec()]
        }
    }
}

/// A blade's holder begins where the blade ends; a bar is as near to the chuck as the blade.
fn held_blade(holder: Holder, depth: f64, root: &[Vector]) -> Vec<Vec<Vector>> {
    match holder {
        Holder::Bar { diameter, .. } => {
            vec![Convex::rectangle(Vector::new(0.0, depth), Vector::new(BAR, depth + diameter.0)).to_vec()]
        }
        Holder::None | Holder::Shank { .. } => held(holder, Vector::new(0.0, depth), root),
    }
}

/// Behind a blade parallel to the axis: a shank perpendicular to the axis, a bar parallel to it.
fn behind_face(holder: Holder, depth: f64) -> Vec<Vector> {
    let far = match holder {
        Holder::None => return Vec::new(),
        Holder::Shank { width, .. } => Vector::new(depth + width.0, FAR),
        Holder::Bar { diameter, .. } => Vector::new(depth + BAR, diameter.0),
    };
    Convex::rectangle(Vector::new(depth, 0.0), far).to_vec()
}

/// The cutting part of a drill, and its shank.
fn drill(radius: f64, point_angle: f64, flute: f64) -> (Vec<Vector>, Vec<Vector>) {
    let point = (radius / libm::tan((point_angle / 2.0).to_radians())).min(flute);
    let cuts = [(0.0, 0.0), (point, radius), (flute, radius), (flute, 0.0)].map(|(z, r)| Vector::new(z, r));
    let shank = Convex::rectangle(Vector::new(flute, 0.0), Vector::new(flute + FAR, radius));
    (cuts.to_vec(), shank.to_vec())
}
