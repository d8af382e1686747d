//! Removes stock motion by motion.

use crate::Cuts;
use crate::fault::{Fault, Faults, What};
use crate::note::Figure;
use crate::plane::{AlongAxis, Convex, Region, Rule, Vector, Window};
use crate::set_up::{IndexedNear, Motion, MotionKind, Piece, SetUp};
use crate::stock::Stock;
use crate::target::Target;
use crate::threads::Pass;
use crate::tool::{Cutter, Outline, Tool};
use crate::units::{At, Block, Mm};

/// Thinner overlaps are ignored, mm: ten times the error of a chord.
pub const TOLERANCE: f64 = 0.005;

/// How much of the wall of a hole is looked at behind the flutes of a drill, mm.
const WALL: f64 = 0.1;

/// The number of swept pieces that are collected before they are subtracted from the stock together, which is faster
/// than one by one; and so many corners of the stock for each piece, because all of it is gone through then.
const BATCH: usize = 128;
const CORNERS_A_PIECE: usize = 16;

/// The result after all motions.
pub struct Carried<'s> {
    set_up: &'s SetUp,
    outlines: Vec<Outline>,
    bodies: Vec<(Figure, Region)>,
    pub target: Target,
    /// The whole part, where the target is a stretch of it.
    finished: Option<Target>,
    pub stock: Stock,
    /// Cut, but not yet subtracted from the stock.
    waiting: Waiting,
    /// Cuts of thread passes by the current tool: not subtracted from the stock, whose crests stay.
    threaded: Vec<Convex>,
    /// The motions that met metal, and where.
    cuts: Vec<(Window, usize)>,
    /// The radius of the deepest pass through the middle of each thread, mm.
    passes: Vec<Option<f64>>,
    /// Where passes went deep enough for each thread: stretches along Z, ascending, mm.
    pub(crate) full: Vec<Vec<[f64; 2]>>,
    /// The passes that cut each thread.
    in_step: Vec<Vec<Pass>>,
    /// How often the spindle has turned since its mark, after a pass that the next motion may go on from.
    turned: Option<f64>,
    /// Z to which a tap has cut each thread in full.
    pub(crate) tapped: Vec<Option<f64>>,
    /// What its tools cut.
    pub chips: Cuts,
    /// How far from the stock the turret turns.
    pub indexed: Vec<IndexedNear>,
    pub faults: Faults,
}

impl<'s> Carried<'s> {
    /// Simulates all motions.
    pub fn through(set_up: &'s SetUp) -> Self {
        let target = Target::of(&set_up.profile);
        let body = |outline: &[At]| Region::enclosed([outline.iter().map(|at| at.spot()).collect()]);
        let mut carried = Self {
            set_up,
            outlines: set_up.tools.iter().map(Outline::of).collect(),
            bodies: set_up.bodies.iter().map(|of| (of.name.clone(), body(&of.outline))).collect(),
            stock: set_up.stock.clone(),
            waiting: Waiting::default(),
            threaded: Vec::new(),
            cuts: Vec::new(),
            passes: vec![None; target.threads.len()],
            full: vec![Vec::new(); target.threads.len()],
            in_step: vec![Vec::new(); target.threads.len()],
            turned: None,
            tapped: vec![None; target.threads.len()],
            target,
            finished: set_up.finished.as_ref().map(Target::of),
            chips: Cuts::default(),
            indexed: Vec::new(),
            faults: Faults::default(),
        };
        for (index, motion) in set_up.motions.iter().enumerate() {
            if index > 0 && set_up.motions[index - 1].tool != motion.tool {
                carried.threaded.clear();
            }
            carried.turn_turret(index);
            carried.carry(index, motion);
        }
        carried.take_off();
        carried.turn_turret(set_up.motions.len());
        carried.hold_threads();
        carried
    }

    /// The largest nose radius that cut near a piece of metal, mm; 0 if none did.
    pub fn nose_at(&self, spots: &[Vector]) -> f64 {
        // A cut edge lies on the grid, and its chords coincide with those of the sweep.
        const TOUCH: f64 = 0.002;
        let along = AlongAxis::of(spots.iter().map(|spot| [spot.z, spot.z]));
        let inside = |window: Window| {
            let places = along.between(window.least.z, window.most.z).into_iter().map(|place| spots[place]);
            places.filter(move |spot| window.meets(Window { least: *spot, most: *spot }))
        };
        let near = self.cuts.iter().filter(|(cut, _)| inside(cut.grown(TOUCH)).next().is_some());
        let touches = |piece: &Convex| inside(piece.window().grown(TOUCH)).any(|spot| piece.distance(spot) <= TOUCH);
        near.fold(0.0, |roundest, &(_, index)| {
            let motion = &self.set_up.motions[index];
            let nose = self.tool(motion).cutter.nose_radius().0;
            let cuts = || self.swept(&self.outlines[motion.tool].cuts, motion);
            if nose > roundest && cuts().iter().any(touches) { nose } else { roundest }
        })
    }

    /// The last motion that cut at a point of the stock's edge.
    pub(crate) fn cut_at(&self, spot: Vector) -> Option<&'s Motion> {
        const TOUCH: f64 = 0.002;
        let window = Window::around([spot]).grown(TOUCH);
        let touches = |index: usize| {
            let motion = &self.set_up.motions[index];
            let cuts = self.swept(&self.outlines[motion.tool].cuts, motion);
            cuts.iter().any(|piece| piece.window().meets(window) && piece.distance(spot) <= TOUCH)
        };
        let mut near = self.cuts.iter().rev().filter(|(cut, _)| cut.meets(window)).map(|(_, index)| *index);
        near.find(|index| touches(*index)).map(|index| &self.set_up.motions[index])
    }

    /// The pieces of the contour, and whether they are of the outside.
    pub(crate) fn drawn(&self) -> impl Iterator<Item = (&'s crate::set_up::ProfilePiece, bool)> {
        let profile = &self.set_up.profile;
        profile.outside.iter().map(|piece| (piece, true)).chain(profile.bore.iter().map(|piece| (piece, false)))
    }

    pub(crate) fn tool(&self, motion: &Motion) -> &'s Tool {
        &self.set_up.tools[motion.tool]
    }

    pub(crate) fn fault(&mut self, what: What, motion: &Motion, at: At) {
        self.faults.add(Fault::of_tool(what, &self.tool(motion).designation, at, motion.block));
    }

    fn swept(&self, pieces: &[Convex], motion: &Motion) -> Vec<Convex> {
        let spots = motion.path.spots();
        let each = spots.windows(2).flat_map(|ends| pieces.iter().map(|piece| piece.swept(ends[0], ends[1])));
        each.flat_map(Convex::folded).collect()
    }

    fn carry(&mut self, index: usize, motion: &Motion) {
        let outline = &self.outlines[motion.tool];
        let (cuts, holds) = (self.swept(&outline.cuts, motion), self.swept(&outline.holds, motion));
        self.hold_bodies(motion, &cuts, &holds);
        if motion.kind != MotionKind::Thread {
            self.turned = None;
        }
        match motion.kind {
            MotionKind::Rapid => {
                // Back along the axis at the depth of its pass, a point goes through the crests of its thread.
                let crests = motion.path.from().spot().minus(motion.path.to().spot());
                let along = crests.z.abs() > crests.r.abs();
                if let Some((width, at)) = self.met(&cuts, &[], !along) {
                    self.fault(What::RapidCut { width }, motion, at);
                }
                self.hold_holder(motion, &holds, &[]);
            }
            MotionKind::Feed | MotionKind::Thread if self.tool(motion).is_tap() => {
                self.hold_axis(motion, &cuts);
                self.hold_profile(motion, &cuts, true);
                self.tap(motion, &cuts, &holds);
            }
            MotionKind::Feed => {
                self.hold_axis(motion, &cuts);
                self.hold_profile(motion, &cuts, false);
                self.hold_holder(motion, &holds, &cuts);
                self.hold_flutes(motion);
                let window = around(&cuts, self.stock.0.window());
                let metal = self.stock.0.about(&cuts, window);
                if !metal.is_empty() {
                    if self.set_up.measures_cuts {
                        self.remember_depth(motion, &metal.made(&Region::pieces(&cuts), Rule::Both));
                    }
                    self.cuts.push((around(&cuts, window), index));
                    needed(&cuts, &metal).for_each(|piece| self.waiting.add(&piece));
                }
                if self.waiting.count >= BATCH.max(self.stock.0.corners() / CORNERS_A_PIECE) {
                    self.take_off();
                }
            }
            MotionKind::Thread => {
                self.hold_profile(motion, &cuts, true);
                self.hold_holder(motion, &holds, &cuts);
                self.remember_pass(motion);
                self.remember_turns(motion);
                self.threaded.extend(cuts);
            }
        }
    }

    pub(crate) fn take_off(&mut self) {
        if let Some(cut) = std::mem::take(&mut self.waiting).together() {
            self.stock.0 = self.stock.0.made(&cut, Rule::Without);
        }
    }

    /// Where pieces meet uncut metal: the width and the place. `cut` is the cut of the motion itself.
    pub(crate) fn overlap(&self, pieces: &[Convex], cut: &[Convex]) -> Option<(Mm, At)> {
        self.met(pieces, cut, true)
    }

    /// The same; the grooves of the current thread are free, or as full as they are between its turns.
    fn met(&self, pieces: &[Convex], cut: &[Convex], grooves: bool) -> Option<(Mm, At)> {
        if !may_meet(&self.stock.0, pieces) {
            return None;
        }
        let metal = self.stock.0.about(pieces, around(pieces, self.stock.0.window()));
        let met = metal.made(&Region::pieces(pieces), Rule::Both);
        thickest(&met)?;
        let window = met.window();
        let near = |piece: &&Convex| piece.window().meets(window);
        let threaded = self.threaded.iter().filter(|_| grooves);
        let free = Region::pieces(threaded.chain(cut).filter(near)).beside(self.waiting.within(window));
        thickest(&met.made(&free, Rule::Without))
    }

    fn hold_holder(&mut self, motion: &Motion, holds: &[Convex], cut: &[Convex]) {
        if let Some((width, at)) = self.overlap(holds, cut) {
            self.fault(What::Holder { width, kind: motion.kind }, motion, at);
        }
    }

    fn hold_bodies(&mut self, motion: &Motion, cuts: &[Convex], holds: &[Convex]) {
        for (name, body) in &self.bodies {
            let near = |piece: &&Convex| piece.window().meets(body.window());
            let pieces: Vec<&Convex> = cuts.iter().chain(holds).filter(near).collect();
            if pieces.is_empty() {
                continue;
            }
            if let Some((width, at)) = thickest(&body.made(&Region::pieces(pieces), Rule::Both)) {
                let (tool, body) = (&self.set_up.tools[motion.tool].designation, name.clone());
                self.faults.add(Fault::of_tool(What::Struck { body, width }, tool, at, motion.block));
            }
        }
    }

    /// Checks that a drill cuts on the axis and along it.
    fn hold_axis(&mut self, motion: &Motion, cuts: &[Convex]) {
        let (from, to) = (motion.path.from(), motion.path.to());
        let on_axis = from.radius.0.abs() <= TOLERANCE && to.radius.0.abs() <= TOLERANCE;
        let tool = self.tool(motion);
        if tool.cutter.turns_on_axis() && !on_axis && self.overlap(cuts, &[]).is_some() {
            self.fault(What::OffAxis, motion, to);
        }
    }

    /// Checks that a tool on the axis goes no deeper than its flutes, its cone or its reach: the hole closes round the shank behind
    /// them, and chips have no way out.
    fn hold_flutes(&mut self, motion: &Motion) {
        let tool = self.tool(motion);
        let (from, to) = (motion.path.from(), motion.path.to());
        let Some((radius, length)) = tool.cutter.shank_on_axis().filter(|_| to.z.0 < from.z.0) else { return };
        let begin = to.z.0 + length;
        let wall = self.stock.0.window();
        let ring = Convex::rectangle(Vector::new(begin, radius), Vector::new(wall.most.z.max(begin), radius + WALL));
        let Some(ring) = Convex::hull(ring).filter(|_| wall.most.z - begin > TOLERANCE) else { return };
        if let Some((_, at)) = self.overlap(std::slice::from_ref(&ring), &[]) {
            let closed = self.stock.0.within(ring.window()).made(&Region::pieces([&ring]), Rule::Both).window();
            self.fault(What::Buried { depth: Mm(closed.most.z - begin) }, motion, at);
        }
    }

    /// Checks how deep a motion cuts into the finished part: into what this set-up makes, then into what others make.
    fn hold_profile(&mut self, motion: &Motion, cuts: &[Convex], thread: bool) {
        let mut found = gouges(&self.target, kept(&self.target, thread), thread, motion, cuts);
        if let Some(whole) = self.finished.as_ref().filter(|whole| may_meet(kept(whole, thread), cuts)) {
            let near = kept(whole, thread).within(around(cuts, whole.keep.window()));
            let made_here = kept(&self.target, thread).within(near.window());
            found.extend(gouges(whole, &near.made(&made_here, Rule::Without), thread, motion, cuts));
        }
        for gouge in found {
            self.faults.add(gouge);
        }
    }

    /// The distance of the tool from the stock at the changes before a motion.
    fn turn_turret(&mut self, before: usize) {
        for one in self.set_up.indexed.iter().filter(|one| one.after == before) {
            self.take_off();
            let edges: Vec<Convex> = self.outlines[one.tool].cuts.clone();
            let spots = edges.iter().flat_map(|piece| piece.corners().to_vec()).map(|spot| spot.plus(one.at.spot()));
            let nearest = |spot: Vector| self.stock.0.edges().map(move |(from, to)| spot.distance(from, to));
            let distance = spots.flat_map(nearest).fold(f64::INFINITY, f64::min);
            if distance.is_finite() {
                self.indexed.push(IndexedNear { block: one.block, tool: one.tool, distance: Mm(distance) });
            }
        }
    }

    /// The depth of a straight cut: its area over the length along which it cuts, so that the last turn before a wall counts no more
    /// than it lasts. What is thinner than the crests between two turns of a feed is air.
    fn remember_depth(&mut self, motion: &Motion, cut: &Region) {
        const CRESTS: f64 = 0.05;
        let edged = matches!(self.tool(motion).cutter, Cutter::Insert { .. });
        let (from, to) = (motion.path.from().spot(), motion.path.to().spot());
        if !matches!(motion.path, Piece::Line { .. }) {
            self.chips.blocks.insert(motion.block);
            return;
        }
        let cut = cut.made(&self.waiting.within(cut.window()), Rule::Without);
        let along = to.minus(from).unit();
        let ends = cut.chains().flatten().map(|spot| spot.minus(from).dot(along));
        let (least, most) =
            ends.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), at| (least.min(at), most.max(at)));
        let depth = cut.area() / (most - least.max(0.0));
        if depth > CRESTS {
            self.chips.blocks.insert(motion.block);
        }
        let deepest = |known: Option<&(Mm, Block)>| known.is_none_or(|known| known.0.0 < depth);
        if edged && depth.is_finite() && deepest(self.chips.depths.get(&motion.tool)) {
            self.chips.depths.insert(motion.tool, (Mm(depth), motion.block));
        }
    }

    fn remember_pass(&mut self, motion: &Motion) {
        let (from, to) = (motion.path.from().spot(), motion.path.to().spot());
        let tool = &self.set_up.tools[motion.tool];
        for ((thread, deepest), full) in self.target.threads.iter().zip(&mut self.passes).zip(&mut self.full) {
            if !thread.is_cut_by(tool) {
                continue;
            }
            full.extend(thread.deep(from, to));
            let middle = (thread.z[0] + thread.z[1]) / 2.0;
            if from.z.min(to.z) > middle || from.z.max(to.z) < middle || from.z == to.z {
                continue;
            }
            let here = from.r + (to.r - from.r) * (middle - from.z) / (to.z - from.z);
            let outwards = thread.thread.root.0 > thread.thread.crest.0;
            let deeper = |known: f64| if outwards { known.max(here) } else { known.min(here) };
            *deepest = Some(deepest.map_or(here, deeper));
        }
    }

    /// Counts the turns of the spindle through a pass: from its mark, or on from the pass before without a stop between them.
    fn remember_turns(&mut self, motion: &Motion) {
        let (from, to) = (motion.path.from().spot(), motion.path.to().spot());
        let Some(lead) = motion.lead.filter(|lead| lead.0 > 0.0) else { return };
        let begun = self.turned.unwrap_or(motion.start.0 / 360.0);
        self.turned = Some(begun + to.minus(from).length() / lead.0);
        for (thread, passes) in self.target.threads.iter().zip(&mut self.in_step) {
            match thread.pass(motion, &self.set_up.tools[motion.tool], begun) {
                Some(Ok(pass)) => passes.push(pass),
                Some(Err(fault)) => self.faults.add(fault),
                None => {}
            }
        }
    }

    fn hold_threads(&mut self) {
        for (thread, passes) in self.target.threads.iter().zip(&self.in_step) {
            thread.out_of_step(passes).into_iter().for_each(|fault| self.faults.add(fault));
        }
        let passes = self.passes.iter().zip(&self.full);
        for ((thread, (pass, full)), tapped) in self.target.threads.iter().zip(passes).zip(&self.tapped) {
            if let Some(to) = tapped {
                let left = to - thread.z[0];
                if left > TOLERANCE {
                    self.faults.add(thread.fault(What::ThreadShort { left: Mm(left) }));
                }
                continue;
            }
            let (crest, shallow) = (thread.thread.crest.0, thread.thread.shallow.0);
            let left = (pass.unwrap_or(crest) - shallow) * (crest - shallow).signum();
            if left > TOLERANCE {
                self.faults.add(thread.fault(What::ThreadShallow { left: Mm(left) }));
            } else if let Some([to, from]) = thread.widest_gap(full) {
                let part = What::ThreadPart { left: Mm(from - to), from_z: Mm(from), to_z: Mm(to) };
                self.faults.add(thread.fault(part));
            }
        }
    }
}

/// The metal that a motion must not cut.
const fn kept(target: &Target, thread: bool) -> &Region {
    if thread { &target.keep_thread } else { &target.keep }
}

/// Where a motion cuts into metal that must stay.
fn gouges(target: &Target, keep: &Region, thread: bool, motion: &Motion, cuts: &[Convex]) -> Vec<Fault> {
    if !may_meet(keep, cuts) {
        return Vec::new();
    }
    let local = keep.about(cuts, around(cuts, keep.window()));
    let pieces = local.made(&Region::pieces(cuts), Rule::Both);
    let gouge = |piece: Region| {
        let spots = samples(&piece, 16);
        let nearest = if thread { target.nearest_threaded(&spots) } else { target.nearest_cut(&spots) };
        let deepest = nearest.iter().zip(&spots).max_by(|a, b| a.0.distance.total_cmp(&b.0.distance));
        let (near, &spot) = deepest.filter(|(near, _)| near.distance > TOLERANCE)?;
        let (surface, depth, at) = (target.surface(near.piece), Mm(near.distance), At::of(spot));
        Some(Fault::of_surface(What::Gouge { depth }, surface, Some(at), Some(motion.block)))
    };
    pieces.outer_pieces().filter_map(gouge).collect()
}

/// What of some pieces is needed to take them off the metal around them: they reach far beyond it, and would cross all others of
/// their pass there.
fn needed(pieces: &[Convex], metal: &Region) -> impl Iterator<Item = Convex> {
    /// So that no edge of a piece that is left runs along one of the metal, mm.
    const BESIDE: f64 = 0.01;
    let window = metal.window().grown(BESIDE);
    pieces.iter().filter(move |piece| piece.window().meets(window)).filter_map(move |piece| piece.within(window))
}

/// Unites swept pieces in pairs, then the pairs, and so on: pieces of one pass overlap, and a union of all of them at
/// once would have too many crossings.
#[derive(Default)]
struct Waiting {
    count: usize,
    /// With the number of pieces in each, the largest first.
    parts: Vec<(usize, Region)>,
}

impl Waiting {
    fn add(&mut self, piece: &Convex) {
        self.count += 1;
        let mut part = (1, Region::pieces([piece]));
        while let Some((count, before)) = self.parts.pop_if(|(count, _)| *count <= part.0) {
            part = (count + part.0, before.made(&part.1, Rule::Either));
        }
        self.parts.push(part);
    }

    /// What lies in a window; its parts may overlap.
    fn within(&self, window: Window) -> Region {
        self.parts.iter().map(|(_, part)| part.within(window)).fold(Region::default(), Region::beside)
    }

    fn together(self) -> Option<Region> {
        self.parts.into_iter().map(|(_, part)| part).reduce(|all, part| all.made(&part, Rule::Either))
    }
}

/// Whether a region and some pieces may have metal in common.
fn may_meet(region: &Region, pieces: &[Convex]) -> bool {
    pieces.iter().any(|piece| region.may_meet(piece))
}

/// The window of the pieces that meet another one.
fn around(pieces: &[Convex], of: Window) -> Window {
    pieces.iter().map(Convex::window).filter(|window| window.meets(of)).fold(Window::NONE, Window::with)
}

/// For an overlap: the least width of its widest piece, and its middle. An overlap that is thin everywhere is only a
/// contact.
pub(crate) fn thickest(shared: &Region) -> Option<(Mm, At)> {
    let sized = shared.outer_pieces().filter_map(|piece| {
        let thickness = 2.0 * piece.area() / piece.around();
        let hull = Convex::hull(piece.chains().flatten())?;
        let window = hull.window();
        let middle = window.least.plus(window.most).times(0.5);
        (thickness > TOLERANCE).then(|| (Mm(hull.width()), At::of(middle)))
    });
    sized.max_by(|a, b| a.0.0.total_cmp(&b.0.0))
}

/// Points on the edge of a region, every 0.5 mm or at most `most` on each side of it; corners are among them.
pub fn samples(region: &Region, most: usize) -> Vec<Vector> {
    let edge = |(from, to): (Vector, Vector)| {
        let path = to.minus(from);
        let parts = ((path.length() / 0.5).ceil() as usize).clamp(2, most);
        (0..parts).map(move |part| from.plus(path.times(part as f64 / parts as f64)))
    };
    region.edges().flat_map(edge).collect()
}
