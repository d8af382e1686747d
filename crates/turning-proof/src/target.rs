//! The finished part for comparison with the stock: the metal that must stay, the metal that may stay, and the
//! nearest edge.

use crate::note::Figure;
use crate::plane::{AlongAxis, Convex, Region, Rule, Vector, Window};
use crate::set_up::{Profile, ProfilePiece, Thread};
use crate::stock::between;

/// How far beyond both ends of a thread its passes may go down to the root, in depths of the thread: half a profile,
/// and a chamfer as deep as the thread.
const RUN: f64 = 2.0;
/// Two steps of the grid of regions, mm: places are no nearer to what they lie beside.
const GRID: f64 = 2e-5;
/// The rounding of a program, mm.
const ROUNDING: f64 = 0.002;
/// Longer than any part, mm.
const BEYOND: f64 = 10_000.0;

/// A chord of the contour, moved out by the allowance.
#[derive(Clone, Copy, Debug)]
struct OutlineEdge {
    from: Vector,
    to: Vector,
    piece: usize,
}

/// The nearest part of the contour to a point.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// The index of its piece.
    pub piece: usize,
    /// The distance, mm; of a piece with limits from the limit that is asked for.
    pub distance: f64,
    /// The distance from what is drawn, mm.
    pub drawn: f64,
    /// Whether it is measured along the normal, not around an outer corner.
    pub square: bool,
}

/// A thread and its place.
#[derive(Clone, Debug)]
pub struct Threaded {
    pub surface: Option<Figure>,
    pub thread: Thread,
    /// Its ends along the axis, mm, ascending.
    pub z: [f64; 2],
    /// Where it ends towards the chuck, mm.
    end: f64,
    /// The radius at which it is drawn, mm.
    drawn: f64,
}

/// The finished part with its allowances.
#[derive(Clone, Debug)]
pub struct Target {
    /// The metal that no tool may cut.
    pub keep: Region,
    /// The metal that no pass of a thread may cut.
    pub keep_thread: Region,
    /// The metal that may remain: the allowances meet at corners.
    pub may_stay: Region,
    /// Its threads.
    pub threads: Vec<Threaded>,
    edges: Vec<OutlineEdge>,
    along: AlongAxis,
    surfaces: Vec<Option<Figure>>,
    bands: Vec<Band>,
    /// How deep the root of the thread on each piece lies under its crest, mm.
    roots: Vec<f64>,
    /// Lines behind which the metal belongs to another set-up.
    open: Vec<[Vector; 2]>,
    /// The straight extension of the shorter of outside and bore, along which the set-up makes nothing.
    extended: Option<[Vector; 2]>,
}

/// The chords of a piece with their normals and offsets.
struct Chain {
    spots: Vec<Vector>,
    /// +1 if the metal is to the left of the chain.
    outwards: f64,
    moved: f64,
    band: Band,
}

/// How far from a piece its limits lie, mm: towards less metal and towards more.
#[derive(Clone, Copy, Debug, Default)]
struct Band {
    less: f64,
    more: f64,
}

impl Band {
    fn of(piece: &ProfilePiece, outwards: f64) -> Self {
        let Some(limits) = piece.limits else { return Self::default() };
        let (from, to) = (piece.path.from().spot(), piece.path.to().spot());
        let out = limits.of(normal(from, to, outwards));
        let [one, other] = [limits.least, limits.most].map(|size| (limits.place(size.0) - limits.of(from)) * out);
        Self { less: (-one.min(other)).max(0.0), more: one.max(other).max(0.0) }
    }
}

impl Chain {
    fn of(piece: &ProfilePiece, outwards: f64) -> Self {
        let spots = piece.path.spots();
        let drawn = spots[0];
        let normal = normal(drawn, spots[1], outwards);
        let sunk = piece.thread.map_or(0.0, |thread| (thread.crest.0 - drawn.r) * normal.r);
        Self { spots, outwards, moved: piece.allowance.0 + sunk, band: Band::of(piece, outwards) }
    }

    fn pairs(&self) -> impl Iterator<Item = (Vector, Vector, Vector)> {
        let by = move |a: Vector, b: Vector| normal(a, b, self.outwards).times(self.moved);
        self.spots.windows(2).map(move |pair| (pair[0], pair[1], by(pair[0], pair[1])))
    }

    /// The strip between a piece and one of its limits, which lies so far towards more metal. It is longer than the piece, so that a
    /// slope beside it may go on to the limit.
    fn strip(&self, by: f64) -> Option<Convex> {
        /// The cotangent of 15°, and a little more.
        const SLOPE: f64 = 4.0;
        let (&from, &to) = (self.spots.first()?, self.spots.last()?);
        let on = to.minus(from).unit().times(SLOPE * by.abs());
        let across = normal(from, to, self.outwards).times(by);
        let (from, to) = (from.minus(on), to.plus(on));
        (by != 0.0).then(|| Convex::hull([from, to, from.plus(across), to.plus(across)])).flatten()
    }

    /// The bands between the chords and their offsets, with the gaps between chords of an arc.
    fn bands(&self) -> impl Iterator<Item = Convex> {
        let next = self.pairs().skip(1).map(Some).chain([None]);
        let bands = self.pairs().zip(next).flat_map(|((a, b, by), next)| {
            let gap = next.and_then(|(_, _, then)| Convex::hull([b, b.plus(by), b.plus(then)]));
            [Convex::hull([a, b, a.plus(by), b.plus(by)]), gap]
        });
        bands.flatten()
    }
}

/// The straight extension of an outside or a bore, of which the other ends farther on: metal that a set-up does not make is as thick
/// as at its beginning. It is added to the shorter one.
fn extend_shorter(outer: &mut Vec<Vector>, bore: &mut Vec<Vector>) -> Option<[Vector; 2]> {
    let (&out, &within) = (outer.last()?, bore.last()?);
    let (shorter, end) = if within.z > out.z {
        (bore, Vector::new(out.z, within.r))
    } else if out.z > within.z && within.r < out.r {
        (outer, Vector::new(within.z, out.r))
    } else {
        return None;
    };
    shorter.push(end);
    shorter.last_chunk().copied()
}

/// The metal behind the wall with which a set-up's contour ends: what is behind it is made elsewhere, but the wall has an inner
/// corner like any other.
fn behind_wall(chain: &[Vector], outwards: f64) -> Option<Convex> {
    /// More than any nose.
    const DEEP: f64 = 5.0;
    let [.., foot, end] = chain else { return None };
    let rises = (end.r - foot.r) * outwards > 0.0 && (end.z - foot.z).abs() < 1e-6;
    let inwards = if outwards > 0.0 { 0.0 } else { foot.r + DEEP };
    let corners = [Vector::new(end.z - DEEP, inwards.min(end.r)), Vector::new(end.z, inwards.max(end.r))];
    rises.then(|| Convex::hull(Convex::rectangle(corners[0], corners[1]))).flatten()
}

fn normal(from: Vector, to: Vector, outwards: f64) -> Vector {
    to.minus(from).unit().right().times(outwards)
}

impl Target {
    pub fn of(profile: &Profile) -> Self {
        let mut chains = Vec::new();
        for (pieces, outwards) in [(&profile.outside, 1.0), (&profile.bore, -1.0)] {
            chains.push(pieces.iter().map(|piece| Chain::of(piece, outwards)).collect::<Vec<_>>());
        }
        let whole = |chain: &[Chain]| -> Vec<Vector> {
            let mut spots: Vec<Vector> = chain.iter().flat_map(|piece| piece.spots.iter().copied()).collect();
            spots.dedup();
            spots
        };
        let (mut outer, mut bore) = (whole(&chains[0]), whole(&chains[1]));
        let mut open = open(&outer, &bore);
        let walls = [behind_wall(&outer, 1.0), behind_wall(&bore, -1.0)];
        let extended = extend_shorter(&mut outer, &mut bore);
        // The part is closed straight across there: what lies behind that is made elsewhere.
        if let (Some(_), Some(&out), Some(&within)) = (extended, outer.last(), bore.last()) {
            open.push([out, within]);
        }
        let bands = |wanted: fn(f64) -> bool| -> Vec<Convex> {
            chains.iter().flatten().filter(|chain| wanted(chain.moved)).flat_map(Chain::bands).collect()
        };
        let sunk = Region::pieces(&bands(|moved| moved < 0.0));
        let stays = Region::pieces(&bands(|moved| moved > 0.0));
        let part = between(&outer, &bore).made(&sunk, Rule::Without).made(&stays, Rule::Either);
        let corners = chains.iter().flat_map(|chain| chain.windows(2).filter_map(corner));
        let corners: Vec<Convex> = corners.chain(walls.into_iter().flatten()).collect();
        let strips = |by: fn(Band) -> f64| -> Vec<Convex> {
            chains.iter().flatten().filter_map(|chain| chain.strip(by(chain.band))).collect()
        };
        let may_stay = part.made(&Region::pieces(&corners), Rule::Either);
        let may_stay = may_stay.made(&Region::pieces(&strips(|band| band.more)), Rule::Either);
        let part = part.made(&Region::pieces(&strips(|band| -band.less)), Rule::Without);

        let threads = threads(profile);
        // Where a chamfer is drawn up to the nominal diameter its crest ends on that of the thread.
        let crests: Vec<Convex> = threads.iter().flat_map(Threaded::crests).collect();
        let keep = part.made(&Region::pieces(&crests), Rule::Without);
        let passes = threads.iter().flat_map(|thread| thread.passes().chain(thread.run_out()));
        let passes: Vec<Convex> = passes.collect();
        let keep_thread = keep.made(&Region::pieces(&passes), Rule::Without);
        let edges = chains.iter().flatten().enumerate().flat_map(|(piece, chain)| {
            chain.pairs().map(move |(a, b, by)| OutlineEdge { from: a.plus(by), to: b.plus(by), piece })
        });
        let edges: Vec<OutlineEdge> = edges.collect();
        let along = AlongAxis::of(edges.iter().map(|edge| [edge.from.z.min(edge.to.z), edge.from.z.max(edge.to.z)]));
        let surfaces = profile.outside.iter().chain(&profile.bore).map(|piece| piece.surface.clone()).collect();
        let bands = chains.iter().flatten().map(|chain| chain.band).collect();
        let root = |piece: &ProfilePiece| piece.thread.map_or(0.0, |thread| (thread.crest.0 - thread.root.0).abs());
        let roots = profile.outside.iter().chain(&profile.bore).map(root).collect();
        Self { keep, keep_thread, may_stay, threads, edges, along, surfaces, bands, roots, open, extended }
    }

    pub fn surface(&self, piece: usize) -> Option<Figure> {
        self.surfaces.get(piece).cloned().flatten()
    }

    /// The nearest edge to each of some points that are cut; of a piece with limits, that of the least metal.
    pub fn nearest_cut(&self, spots: &[Vector]) -> Vec<Nearest> {
        self.beyond(spots, |band| band.less)
    }

    /// The nearest edge to each of some points that are left; of a piece with limits, that of the most metal.
    pub fn nearest_left(&self, spots: &[Vector]) -> Vec<Nearest> {
        self.beyond(spots, |band| band.more)
    }

    /// The nearest edge to each of some points that a pass of a thread cuts: on a thread its root.
    pub fn nearest_threaded(&self, spots: &[Vector]) -> Vec<Nearest> {
        let mut nearest = self.nearest_cut(spots);
        for near in &mut nearest {
            near.distance = (near.distance - self.roots.get(near.piece).copied().unwrap_or(0.0)).max(0.0);
        }
        nearest
    }

    fn beyond(&self, spots: &[Vector], by: fn(Band) -> f64) -> Vec<Nearest> {
        let mut nearest = self.nearest(spots);
        for near in &mut nearest {
            near.distance = (near.distance - self.bands.get(near.piece).map_or(0.0, |band| by(*band))).max(0.0);
        }
        nearest
    }

    /// The nearest edge to each of some points: looked for close by, then ever farther off.
    fn nearest(&self, spots: &[Vector]) -> Vec<Nearest> {
        const CLOSE: [f64; 4] = [0.1, 1.0, 10.0, 100.0];
        let nearest = |&spot: &Vector| {
            let within = |reach: f64| {
                let window = Window::around([spot]).grown(reach);
                let near = self.along.between(window.least.z, window.most.z).into_iter().map(|place| self.edges[place]);
                let near = near.filter(|edge| Window::around([edge.from, edge.to]).meets(window));
                Nearest::of(near, spot).filter(|found| found.distance <= reach)
            };
            let found = CLOSE.into_iter().find_map(within).or_else(|| Nearest::of(self.edges.iter().copied(), spot));
            found.unwrap_or(Nearest { piece: 0, distance: f64::INFINITY, drawn: f64::INFINITY, square: false })
        };
        spots.iter().map(nearest).collect()
    }

    /// Whether metal at a point, at that distance from the contour, belongs to another set-up.
    pub fn is_elsewhere(&self, spot: Vector, distance: f64) -> bool {
        self.open.iter().chain(&self.extended).any(|[from, to]| spot.distance(*from, *to) <= distance + GRID)
    }

    /// The range along the axis that the set-up makes, mm.
    pub fn stretch(&self) -> Window {
        let whole = Window { least: Vector::new(-BEYOND / 2.0, 0.0), most: Vector::new(BEYOND / 2.0, BEYOND / 2.0) };
        let edges = Window::around(self.edges.iter().flat_map(|edge| [edge.from, edge.to]));
        let middle = (edges.least.z + edges.most.z) / 2.0;
        self.open.iter().fold(whole, |mut whole, [from, _]| {
            // A contour that is one face ends there towards the chuck.
            if from.z <= middle {
                whole.least.z = whole.least.z.max(from.z);
            } else {
                whole.most.z = whole.most.z.min(from.z);
            }
            whole
        })
    }
}

impl Nearest {
    /// The first of the nearest; none of no edges.
    fn of(edges: impl Iterator<Item = OutlineEdge>, spot: Vector) -> Option<Self> {
        let each = edges.map(|edge| (spot.distance(edge.from, edge.to), edge));
        let (distance, edge) = each.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let along = edge.to.minus(edge.from).unit();
        let across = along.cross(spot.minus(edge.from)).abs();
        Some(Self { piece: edge.piece, distance, drawn: distance, square: across >= 0.99 * distance })
    }
}

impl Threaded {
    /// The metal that its passes or its tap may remove.
    fn passes(&self) -> impl Iterator<Item = Convex> {
        let passes = self.between(self.thread.crest.0, self.thread.root.0);
        // A tap goes on behind the thread, towards the chuck, and comes from the free end.
        let tapped = self.thread.tap.and_then(|tap| {
            let (crest, nominal) = (self.thread.crest.0, tap.diameter.0 / 2.0 + ROUNDING);
            let from = Vector::new(self.z[0] - tap.run_out.0 - ROUNDING, crest);
            Convex::hull(Convex::rectangle(from, Vector::new(self.z[1] + RUN * (nominal - crest), nominal)))
        });
        passes.into_iter().chain(tapped)
    }

    /// The metal behind it that its passes may remove where it has no relief.
    fn run_out(&self) -> Option<Convex> {
        self.behind(self.thread.root.0)
    }

    /// The metal behind it as far as it may run out, from its drawn diameter to a radius.
    fn behind(&self, radius: f64) -> Option<Convex> {
        let far =
            if self.end > self.z[0] { self.end + self.thread.run_out.0 } else { self.end - self.thread.run_out.0 };
        let [near, far] = [self.end.min(far), self.end.max(far)];
        Convex::hull(Convex::rectangle(Vector::new(near, self.drawn), Vector::new(far, radius)))
    }

    /// The metal between its drawn diameter and its crests, if it is turned lower than drawn: as far as its passes may run out, it may
    /// be turned so, too.
    fn crests(&self) -> impl Iterator<Item = Convex> + use<> {
        let outwards = self.thread.crest.0 - self.thread.root.0;
        let sunk = (self.drawn - self.thread.crest.0) * outwards > 0.0;
        let lower = sunk.then(|| [self.between(self.drawn, self.thread.crest.0), self.behind(self.thread.crest.0)]);
        lower.into_iter().flatten().flatten()
    }

    fn between(&self, from: f64, to: f64) -> Option<Convex> {
        let run = RUN * (from - to).abs();
        Convex::hull(Convex::rectangle(Vector::new(self.z[0] - run, from), Vector::new(self.z[1] + run, to)))
    }
}

fn threads(profile: &Profile) -> Vec<Threaded> {
    let pieces = profile.outside.iter().chain(&profile.bore);
    let threaded = pieces.filter_map(|piece| {
        let (a, b) = (piece.path.from().z.0, piece.path.to().z.0);
        let thread = piece.thread?;
        let drawn = piece.path.from().radius.0;
        Some(Threaded { surface: piece.surface.clone(), thread, z: [a.min(b), a.max(b)], end: b, drawn })
    });
    threaded.collect()
}

/// The area where the allowances of two pieces meet over an outer corner.
fn corner(pair: &[Chain]) -> Option<Convex> {
    let [before, after] = pair else { return None };
    let (a, b, by) = before.pairs().last()?;
    let (_, c, then) = after.pairs().next()?;
    let (along, on) = (b.minus(a).unit(), c.minus(b).unit());
    let turn = along.cross(on);
    let most = before.moved.max(after.moved);
    if turn * before.outwards < 1e-6 || most <= 0.0 {
        return None;
    }
    // A very sharp corner is cut off.
    let far = (then.minus(by).cross(on) / turn).min(4.0 * most);
    Convex::hull([b, b.plus(by), b.plus(then), b.plus(by).plus(along.times(far))])
}

/// Lines where the contour is open: those that close it, and straight lines away from its open ends.
fn open(outer: &[Vector], bore: &[Vector]) -> Vec<[Vector; 2]> {
    let mut lines = Vec::new();
    for (end, other) in [(outer.first(), bore.first()), (outer.last(), bore.last())] {
        let Some(&end) = end else { continue };
        // A blind bore closes itself on the axis.
        let other = other.copied().filter(|other| other.r > 0.0);
        let inner = other.unwrap_or(Vector::new(end.z, 0.0));
        if end.minus(inner).length() > 1e-6 {
            lines.push([end, inner]);
            lines.push([end, Vector::new(end.z, BEYOND)]);
            if let Some(other) = other {
                lines.push([other, Vector::new(other.z, 0.0)]);
            }
        }
    }
    lines
}
