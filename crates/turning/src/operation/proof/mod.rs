//! Checks an operation with the turning proof: simulates the in-process stock through its jobs, set-up by set-up. The
//! proof is independent of the planner; here jobs are only converted for it.

use technolog_turning_proof as proof;

use crate::note::{Figure, Finding, IntoFigure, Note, Severity};
use crate::turning::contour::{Contour, Curve, Piece, Profile, Side, SurfaceName, Turn};
use crate::turning::jobs::Job;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::turning::workpiece::SteadyRest;
use proof::{At, Block, Fault, Mm, Motion, MotionKind, Sense, SetUp, Stock, What};

mod profile;
mod tool;

use super::unfinished::undone;
use super::{Axial, Operation, SetUpWork, Tailstock};
use profile::profiles;
pub(crate) use tool::tool;

/// The result of the proof for each set-up, in the order of work.
#[derive(Clone, Debug)]
pub struct Proven {
    /// The number of the set-up.
    pub set_up: u8,
    /// The result; or why there is none.
    pub proof: Result<proof::Proof, proof::Refused>,
}

/// Simulates the jobs of all set-ups on the blank.
pub fn prove(operation: &Operation) -> Vec<Proven> {
    let mut proven = Vec::new();
    for set_up in &operation.set_ups {
        let jobs = set_up.jobs.iter().enumerate();
        let mut motions: Vec<Motion> = jobs.flat_map(|(index, job)| of_job(job, index)).collect();
        for (number, motion) in (1..).zip(&mut motions) {
            motion.block = Block(number);
        }
        proven.push(prove_set_up(operation, &proven, set_up, motions, None));
    }
    proven
}

/// The motions of a job; those along a thread are in step with the spindle.
fn of_job(job: &Job, tool: usize) -> Vec<Motion> {
    let lead = job.pace.feeds().map(|feeds| Mm(feeds.thread.0));
    let in_step = |motion: Motion| Motion { lead: lead.filter(|_| motion.kind == MotionKind::Thread), ..motion };
    motions(&job.path, tool).into_iter().map(in_step).collect()
}

/// Simulates given motions of a set-up on the stock after the earlier set-ups, with the tools of its jobs by index, and the changes
/// between them. With these, which may be none, it is somebody's program, and what its tools take off is measured.
pub fn prove_set_up(
    operation: &Operation,
    before: &[Proven],
    set_up: &SetUpWork,
    motions: Vec<Motion>,
    indexed: Option<Vec<proof::Indexed>>,
) -> Proven {
    let workpiece = &operation.workpiece;
    let number = set_up.set_up.number;
    let earlier = operation.set_ups.iter().zip(before).take_while(|(work, _)| work.set_up.number != number);
    let left = earlier.filter_map(|(work, one)| {
        let left = one.proof.as_ref().ok()?.left.clone();
        // The rest of a bar stays in the chuck.
        let left = if work.parted_mm.is_some() { left.before(Mm(-workpiece.length().to_mm())) } else { left };
        Some((left, work.set_up.turned_over))
    });
    let (mut stock, over) = left.last().unwrap_or_else(|| {
        let inner = workpiece.blank.inner.as_ref();
        let within = inner.and_then(Contour::start).map_or(Half::ZERO, |start| start.radius);
        // A bar that is drawn only by its cylinder gets its face.
        let outer = chain(&workpiece.blank.outer.clone().with_face(within));
        (Stock::between(&outer, &inner.map(chain).unwrap_or_default()), false)
    });
    if set_up.set_up.turned_over != over {
        stock = stock.turned_over(Mm(workpiece.length().to_mm()));
    }
    let (profile, finished) = profiles(operation, set_up);
    let task = SetUp {
        profile,
        finished,
        stock,
        bodies: bodies(set_up),
        tools: set_up.jobs.iter().map(|job| tool(&job.tool)).collect(),
        motions,
        measures_cuts: indexed.is_some(),
        indexed: indexed.unwrap_or_default(),
    };
    Proven { set_up: number, proof: proof::prove(&task) }
}

/// The bodies that hold the part in a set-up: the jaws with the chuck behind them, and the tailstock.
fn bodies(set_up: &SetUpWork) -> Vec<proof::Body> {
    let tailstock = set_up.tailstock.iter().flat_map(tailstock_bodies);
    chuck_bodies(set_up).into_iter().chain(tailstock).chain(set_up.set_up.rest.map(rest_body)).collect()
}

/// A body by the corners of its outline, Z and radius.
fn body(name: &'static str, corners: &[(f64, f64)]) -> proof::Body {
    let outline = corners.iter().map(|&(z, radius)| At::new(Mm(z), Mm(radius))).collect();
    proof::Body { name: Figure::word(name), outline }
}

/// A steady rest, from its seat outwards: its frame is round the part, and no tool passes it.
fn rest_body(rest: SteadyRest) -> proof::Body {
    let ([front, back], seat) = (rest.sides().map(|z| -z.to_mm()), rest.seat_mm.to_mm() / 2.0);
    body("body-rest", &[(front, seat), (front, FAR), (back, FAR), (back, seat)])
}

fn chuck_bodies(set_up: &SetUpWork) -> Vec<proof::Body> {
    let Some((jaws, chuck)) = set_up.jaws.and_then(|jaws| Some((jaws, jaws.body?))) else { return Vec::new() };
    let (front, grips) = (-jaws.front_mm.to_mm(), jaws.grips_mm.to_mm() / 2.0);
    let face = front - chuck.out_mm.to_mm();
    let block =
        |name, from: f64, to: f64, radius: f64| body(name, &[(from, grips), (from, radius), (to, radius), (to, grips)]);
    vec![
        block("body-jaws", front, face, chuck.sweep_mm.to_mm() / 2.0),
        block("body-chuck", face, face - FAR, chuck.chuck_mm.to_mm() / 2.0),
    ]
}

/// The centre, from its cone at the face to the quill, and the quill.
fn tailstock_bodies(tailstock: &Tailstock) -> Vec<proof::Body> {
    let face = -tailstock.face_mm.to_mm();
    let [mouth, thick, quill] =
        [tailstock.mouth_mm, tailstock.body_mm, tailstock.quill_mm].map(|diameter| diameter.to_mm() / 2.0);
    let (cone, off) = (face + tailstock.cone_mm(), face + tailstock.quill_off_mm());
    vec![
        body(CENTRE, &[(face, 0.0), (face, mouth), (cone, thick), (off, thick), (off, 0.0)]),
        body(QUILL, &[(off, 0.0), (off, quill), (off + FAR, quill), (off + FAR, 0.0)]),
    ]
}

/// The bodies of the tailstock by name.
const CENTRE: &str = "body-centre";
const QUILL: &str = "body-quill";

/// Whether a tool hits the centre of the tailstock in a set-up.
pub(super) fn meets_centre(operation: &Operation, set_up: u8) -> bool {
    let meets = |fault: &Fault| matches!(&fault.what, What::Struck { body, .. } if *body == Figure::word(CENTRE));
    let own = operation.proven.iter().filter(|one| one.set_up == set_up);
    own.filter_map(|one| one.proof.as_ref().ok()).any(|proof| proof.faults.iter().any(meets))
}

/// The assumed length of a chuck, mm: no toolpath goes beyond it.
const FAR: f64 = 500.0;

/// The findings of a proof. Metal that a nose leaves in a corner is a note, everything else is wrong. Remaining metal
/// and incomplete threads are reported for the set-up that turns the surface, unless a finding already says that
/// nothing finishes it.
pub(super) fn findings(operation: &Operation) -> Vec<Finding> {
    operation.proven.iter().flat_map(|proven| findings_of(operation, proven)).collect()
}

/// The findings about metal that is left standing.
pub(super) fn standing(operation: &Operation) -> Vec<Finding> {
    let proven = operation.proven.iter().filter_map(|one| Some((one.set_up, one.proof.as_ref().ok()?)));
    let standing = proven.flat_map(|(set_up, proof)| told(operation, set_up, proof).map(move |one| (set_up, one)));
    let standing = standing.filter(|(_, (_, fault))| matches!(fault.what, What::Stands { .. }));
    standing.map(|(set_up, (severity, fault))| finding_of(set_up, severity, fault)).collect()
}

fn finding_of(set_up: u8, severity: Severity, fault: &Fault) -> Finding {
    Finding::of_part(severity, fault.note().with("number", set_up))
}

/// The findings of one set-up.
pub(super) fn findings_of(operation: &Operation, one: &Proven) -> Vec<Finding> {
    match &one.proof {
        Ok(proof) => told(operation, one.set_up, proof)
            .map(|(severity, fault)| finding_of(one.set_up, severity, fault))
            .collect(),
        Err(refused) => vec![Finding::of_part(
            Severity::Wrong,
            Note::new("turning-not-proven").with("number", one.set_up).with("why", refused.note()),
        )],
    }
}

/// The reported faults of the jobs of a set-up with their severity. What they leave undone is told by their plan.
fn told<'a>(
    operation: &'a Operation,
    set_up: u8,
    proof: &'a proof::Proof,
) -> impl Iterator<Item = (Severity, &'a Fault)> {
    let works = operation.set_ups.iter().filter(|one| one.set_up.number == set_up);
    told_but(operation, set_up, proof, works.flat_map(undone).map(|undone| undone.name).collect())
}

/// The reported faults of a set-up with their severity, if somebody else made its motions: what these leave of any surface is
/// told, whatever our plan of it does.
pub fn told_of_program<'a>(
    operation: &'a Operation,
    set_up: u8,
    proof: &'a proof::Proof,
) -> impl Iterator<Item = (Severity, &'a Fault)> {
    told_but(operation, set_up, proof, Vec::new())
}

/// The reported faults; nothing is said of what is left of some surfaces.
fn told_but<'a>(
    operation: &'a Operation,
    set_up: u8,
    proof: &'a proof::Proof,
    undone: Vec<&SurfaceName>,
) -> impl Iterator<Item = (Severity, &'a Fault)> {
    let works: Vec<&SetUpWork> = operation.set_ups.iter().filter(|one| one.set_up.number == set_up).collect();
    let stretches = works.iter().flat_map(|work| [&work.set_up.outer, &work.set_up.inner]).flatten();
    let axial = || works.iter().filter_map(|work| work.axial.as_ref());
    let left = || axial().flat_map(|axial| &axial.left);
    let names = stretches.flat_map(|stretch| &stretch.profile.surfaces).map(|surface| &surface.name);
    let names = names.filter(|name| !left().any(|other| other == *name)).chain(axial().flat_map(Axial::far));
    let own: Vec<Figure> = names.filter(|name| !undone.contains(name)).map(|name| name.into_figure()).collect();
    let is_told = move |fault: &&Fault| match fault.what {
        // The end of an allowance for another machine lies on the slope beside it.
        What::Stands { thickness, .. } if beside_allowance(operation, fault, thickness).is_some() => false,
        What::Stands { .. }
        | What::OffSize { missing: false, .. }
        | What::Corner { .. }
        | What::ThreadShallow { .. }
        | What::ThreadPart { .. }
        | What::ThreadShort { .. } => fault.surface().is_none_or(|surface| own.contains(surface)),
        _ => is_unsafe(operation, fault),
    };
    let severity = |fault: &Fault| match fault {
        fault if fault.is_mild() => Severity::Note,
        _ => Severity::Wrong,
    };
    proof.faults.iter().filter(is_told).map(move |fault| (severity(fault), fault))
}

/// Whether a fault would damage the part or cause a collision.
fn is_unsafe(operation: &Operation, fault: &Fault) -> bool {
    match fault.what {
        What::Stands { .. } | What::Corner { .. } | What::ThreadShallow { .. } => false,
        What::OffSize { missing, .. } => missing,
        What::ThreadPart { .. } | What::ThreadShort { .. } => false,
        What::Gouge { depth } => !is_mouth(operation, fault, depth),
        What::Struck { .. } | What::RapidCut { .. } | What::Holder { .. } | What::OffAxis => true,
        What::TapBlocked { .. } | What::TapOutOfStep { .. } | What::TapHoleWide { .. } => true,
        What::ThreadLead { .. } | What::ThreadPhase { .. } | What::Buried { .. } => true,
    }
}

/// The blocks in which a set-up is unsafe, with the fault in each.
pub(super) fn unsafe_places(operation: &Operation, proven: &Proven) -> Vec<(usize, Note)> {
    let Ok(proof) = &proven.proof else { return Vec::new() };
    let found = proof.faults.iter().filter(|fault| is_unsafe(operation, fault));
    found.filter_map(|fault| Some((fault.block?.0, fault.note()))).collect()
}

/// Why no program of a set-up is written: the first fault of the proof that makes it unsafe, or why there is no proof.
pub fn rejects(operation: &Operation, set_up: u8) -> Option<Note> {
    rejected(operation, operation.proven.iter().find(|one| one.set_up == set_up)?)
}

/// The first fault of a proof that makes a set-up unsafe, or why there is no proof.
pub fn rejected(operation: &Operation, proven: &Proven) -> Option<Note> {
    match &proven.proof {
        Ok(proof) => proof.faults.iter().find(|fault| is_unsafe(operation, fault)).map(Fault::note),
        Err(refused) => Some(refused.note()),
    }
}

/// Whether the cut removes only the end of an allowance that is left for another machine: the wall of a groove or a thread, or a
/// slope beside that surface, goes on through it.
fn is_mouth(operation: &Operation, fault: &Fault, depth: Mm) -> bool {
    let beside = beside_allowance(operation, fault, depth).zip(fault.at);
    beside.is_some_and(|(profile, at)| is_outside(profile, at))
}

/// The profile of a surface beside one with an allowance for another machine, if a place on it is near the end of that allowance
/// and what stands or is cut there is no thicker.
fn beside_allowance<'a>(operation: &'a Operation, fault: &Fault, depth: Mm) -> Option<&'a Profile> {
    let (surface, at) = (fault.surface()?, fault.at?);
    let sides = operation.set_ups.iter().flat_map(|set_up| [&set_up.set_up.outer, &set_up.set_up.inner]).flatten();
    sides.map(|side| &side.profile).find(|profile| {
        operation.elsewhere.iter().any(|one| {
            let allowance = one.allowance_mm.to_mm();
            let near = BESIDE * allowance + 0.01;
            let Some(index) = profile.surfaces.iter().position(|other| other.name == one.surface) else { return false };
            let beside = profile.surfaces.iter().skip(index.saturating_sub(1)).take(if index == 0 { 2 } else { 3 });
            let mut ends = profile.surfaces[index].pieces.iter().flat_map(|piece| [piece.from, piece.to]);
            depth.0 <= allowance + ROUNDING
                && beside.into_iter().any(|other| (&other.name).into_figure() == *surface)
                && ends
                    .any(|end| (end.z.to_mm() + at.z.0).abs() < near && (end.radius.to_mm() - at.radius.0).abs() < near)
        })
    })
}

/// Whether a place lies outside of the finished part, so that what is cut there is allowance.
fn is_outside(profile: &Profile, at: At) -> bool {
    let Some((least, most)) = profile.contour().radii_at(Half::from(-at.z.0)) else { return true };
    match profile.side {
        Side::Outer => at.radius.0 >= least.to_mm() - ROUNDING,
        Side::Inner => at.radius.0 <= most.to_mm() + ROUNDING,
    }
}

/// How far along a slope of 15° goes on through an allowance, in allowances.
const BESIDE: f64 = 3.8;

fn at(point: Point) -> At {
    At::new(Mm(-point.z.to_mm()), Mm(point.radius.to_mm()))
}

/// A piece, with Z away from the chuck: a left turn towards the chuck is clockwise there.
fn proof_piece(piece: &Piece) -> proof::Piece {
    let (from, to) = (at(piece.from), at(piece.to));
    match (piece.curve, piece.centre()) {
        (Curve::Arc { turn, .. }, Some(centre)) => proof::Piece::Arc {
            from,
            to,
            centre: At::new(Mm(-centre.z), Mm(centre.radius)),
            sense: if turn == Turn::Left { Sense::Clockwise } else { Sense::Counterclockwise },
        },
        _ => proof::Piece::Line { from, to },
    }
}

pub(crate) fn chain(contour: &Contour) -> Vec<proof::Piece> {
    contour.pieces.iter().map(proof_piece).collect()
}

/// The motions of a toolpath by a tool. Blocks count from 1.
pub fn motions(path: &Toolpath, tool: usize) -> Vec<Motion> {
    let kind = |purpose| match purpose {
        Purpose::Rapid => MotionKind::Rapid,
        Purpose::Thread => MotionKind::Thread,
        _ => MotionKind::Feed,
    };
    let pieces = path.pieces().enumerate();
    let moved = |(index, (piece, purpose)): (usize, (Piece, Purpose))| Motion {
        kind: kind(purpose),
        path: proof_piece(&piece),
        tool,
        lead: None,
        start: proof::Degrees(0.0),
        block: Block(index + 1),
    };
    pieces.map(moved).collect()
}

/// The largest error of a depth by rounding of a path, mm.
const ROUNDING: f64 = 0.002;
