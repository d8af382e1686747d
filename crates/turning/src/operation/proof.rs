//! Checks an operation with the turning proof: simulates the in-process stock through its jobs, set-up by set-up. The
//! proof is independent of the planner; here jobs are only converted for it.

use technolog_turning_proof as proof;

use crate::note::{Figure, Finding, IntoFigure, Note, Severity};
use crate::turning::contour::{Contour, Curve, Piece, Profile, Side, Surface, SurfaceKind, Turn};
use crate::turning::jobs::hole::point_length;
use crate::turning::jobs::{Body, Job, JobTool, UNKNOWN_EDGE};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::tooling::{Hand, Place, ToolKind};
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{Degrees, Micrometres};
use proof::{At, Block, Cutter, Fault, Holder, Mm, Motion, MotionKind, Sense, SetUp, Stock};

use super::unfinished::{undone, undone_on_axis};
use super::{Axial, Operation, SetUpWork, Tailstock};

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
        proven.push(prove_set_up(operation, &proven, set_up, motions));
    }
    proven
}

/// The motions of a job; those along a thread are in step with the spindle.
fn of_job(job: &Job, tool: usize) -> Vec<Motion> {
    let lead = job.pace.feeds().map(|feeds| Mm(feeds.thread.0));
    let in_step = |motion: Motion| Motion { lead: lead.filter(|_| motion.kind == MotionKind::Thread), ..motion };
    motions(&job.path, tool).into_iter().map(in_step).collect()
}

/// Simulates given motions of a set-up on the stock after the earlier set-ups, with the tools of its jobs by index.
pub fn prove_set_up(operation: &Operation, before: &[Proven], set_up: &SetUpWork, motions: Vec<Motion>) -> Proven {
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
        let outer = chain(&whole_blank(&workpiece.blank.outer, inner));
        (Stock::between(&outer, &inner.map(chain).unwrap_or_default()), false)
    });
    if set_up.set_up.turned_over != over {
        stock = stock.turned_over(Mm(workpiece.length().to_mm()));
    }
    let task = SetUp {
        profile: profile(operation, set_up),
        stock,
        bodies: bodies(set_up),
        tools: set_up.jobs.iter().map(|job| tool(&job.tool)).collect(),
        motions,
    };
    Proven { set_up: number, proof: proof::prove(&task) }
}

/// The bodies that hold the part in a set-up: the jaws with the chuck behind them, or the tailstock.
fn bodies(set_up: &SetUpWork) -> Vec<proof::Body> {
    if let Some(tailstock) = &set_up.tailstock {
        return tailstock_bodies(tailstock);
    }
    let Some((jaws, body)) = set_up.jaws.and_then(|jaws| Some((jaws, jaws.body?))) else { return Vec::new() };
    let (front, grips) = (-jaws.front_mm.to_mm(), jaws.grips_mm.to_mm() / 2.0);
    let face = front - body.out_mm.to_mm();
    let block = |name, from: f64, to: f64, radius: f64| proof::Body {
        name: Figure::word(name),
        outline: [(from, grips), (from, radius), (to, radius), (to, grips)]
            .map(|(z, radius)| At::new(Mm(z), Mm(radius)))
            .to_vec(),
    };
    vec![
        block("body-jaws", front, face, body.sweep_mm.to_mm() / 2.0),
        block("body-chuck", face, face - FAR, body.chuck_mm.to_mm() / 2.0),
    ]
}

/// The centre, from its cone at the face to the quill, and the quill.
fn tailstock_bodies(tailstock: &Tailstock) -> Vec<proof::Body> {
    let face = -tailstock.face_mm.to_mm();
    let [mouth, body, quill] =
        [tailstock.mouth_mm, tailstock.body_mm, tailstock.quill_mm].map(|diameter| diameter.to_mm() / 2.0);
    let (cone, off) = (face + tailstock.cone_mm(), face + tailstock.quill_off_mm());
    let outline = |name, corners: &[(f64, f64)]| proof::Body {
        name: Figure::word(name),
        outline: corners.iter().map(|&(z, radius)| At::new(Mm(z), Mm(radius))).collect(),
    };
    vec![
        outline(CENTRE, &[(face, 0.0), (face, mouth), (cone, body), (off, body), (off, 0.0)]),
        outline(QUILL, &[(off, 0.0), (off, quill), (off + FAR, quill), (off + FAR, 0.0)]),
    ]
}

/// The bodies of the tailstock by name.
const CENTRE: &str = "body-centre";
const QUILL: &str = "body-quill";

/// Whether a tool hits the tailstock. Its size is not confirmed, and a thinner centre may be used.
fn meets_tailstock(fault: &Fault) -> bool {
    matches!(fault, Fault::Struck { body, .. } if [CENTRE, QUILL].into_iter().any(|name| *body == Figure::word(name)))
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
    let standing = standing.filter(|(_, (_, fault))| matches!(fault, Fault::Stands { .. }));
    standing.map(|(set_up, (severity, fault))| finding_of(set_up, severity, fault)).collect()
}

fn finding_of(set_up: u8, severity: Severity, fault: &Fault) -> Finding {
    Finding::of_part(severity, fault.note().with("number", set_up))
}

/// The findings of one set-up.
fn findings_of(operation: &Operation, one: &Proven) -> Vec<Finding> {
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

/// The reported faults of a set-up with their severity, whoever made its motions.
pub fn told<'a>(
    operation: &'a Operation,
    set_up: u8,
    proof: &'a proof::Proof,
) -> impl Iterator<Item = (Severity, &'a Fault)> {
    let works: Vec<&SetUpWork> = operation.set_ups.iter().filter(|one| one.set_up.number == set_up).collect();
    let of_sides = |work: &&&'a SetUpWork| work.sides.iter().flat_map(|side| undone(work, side)).collect::<Vec<_>>();
    let undone: Vec<_> = works.iter().flat_map(|work| [of_sides(&work), undone_on_axis(work)]).flatten().collect();
    let stretches = works.iter().flat_map(|work| [&work.set_up.outer, &work.set_up.inner]).flatten();
    let axial = || works.iter().filter_map(|work| work.axial.as_ref());
    let left = || axial().flat_map(|axial| &axial.left);
    let names = stretches.flat_map(|stretch| &stretch.profile.surfaces).map(|surface| &surface.name);
    let names = names.filter(|name| !left().any(|other| other == *name)).chain(axial().flat_map(Axial::far));
    let own: Vec<Figure> =
        names.filter(|name| undone.iter().all(|(other, _)| other != name)).map(|name| name.into_figure()).collect();
    let is_told = move |fault: &&Fault| match fault {
        // The end of an allowance for another machine lies on the slope beside it.
        Fault::Stands { surface, thickness, at, .. }
            if beside_allowance(operation, surface.as_ref(), *thickness, *at).is_some() =>
        {
            false
        }
        Fault::Stands { surface, .. }
        | Fault::Corner { surface, .. }
        | Fault::ThreadShallow { surface, .. }
        | Fault::ThreadShort { surface, .. } => surface.as_ref().is_none_or(|surface| own.contains(surface)),
        unsafe_fault => is_unsafe(operation, unsafe_fault) || meets_tailstock(unsafe_fault),
    };
    let severity = |fault: &Fault| match fault {
        fault if fault.is_mild() => Severity::Note,
        fault if meets_tailstock(fault) => Severity::Doubtful,
        _ => Severity::Wrong,
    };
    proof.faults.iter().filter(is_told).map(move |fault| (severity(fault), fault))
}

/// Whether a fault would damage the part or cause a collision.
fn is_unsafe(operation: &Operation, fault: &Fault) -> bool {
    match fault {
        Fault::Stands { .. } | Fault::Corner { .. } | Fault::ThreadShallow { .. } | Fault::ThreadShort { .. } => false,
        Fault::Gouge { surface, depth, at, .. } => !is_mouth(operation, surface.as_ref(), *depth, *at),
        Fault::Struck { .. } => !meets_tailstock(fault),
        Fault::RapidCut { .. } | Fault::Holder { .. } | Fault::OffAxis { .. } => true,
        Fault::TapBlocked { .. } | Fault::TapOutOfStep { .. } | Fault::TapHoleWide { .. } => true,
    }
}

/// The blocks in which a set-up is unsafe, with the fault in each.
pub(super) fn unsafe_places(operation: &Operation, proven: &Proven) -> Vec<(usize, Note)> {
    let Ok(proof) = &proven.proof else { return Vec::new() };
    let found = proof.faults.iter().filter(|fault| is_unsafe(operation, fault));
    found.filter_map(|fault| Some((fault.block()?.0, fault.note()))).collect()
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
fn is_mouth(operation: &Operation, surface: Option<&Figure>, depth: Mm, at: At) -> bool {
    beside_allowance(operation, surface, depth, at).is_some_and(|profile| is_outside(profile, at))
}

/// The profile of a surface beside one with an allowance for another machine, if a place on it is near the end of that allowance
/// and what stands or is cut there is no thicker.
fn beside_allowance<'a>(operation: &'a Operation, surface: Option<&Figure>, depth: Mm, at: At) -> Option<&'a Profile> {
    let surface = surface?;
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

/// The blank from the axis or its bore at the free end; a bar that is drawn only by its cylinder gets its face.
fn whole_blank(outer: &Contour, inner: Option<&Contour>) -> Contour {
    let mut whole = outer.clone();
    let within = inner.and_then(Contour::start).map_or(Half::ZERO, |start| start.radius);
    if let Some(start) = outer.start().filter(|start| start.radius > within) {
        whole.pieces.insert(0, Piece::line(Point { radius: within, z: start.z }, start));
    }
    whole
}

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

fn chain(contour: &Contour) -> Vec<proof::Piece> {
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
        block: Block(index + 1),
    };
    pieces.map(moved).collect()
}

/// The required profile after a set-up. After the last one it is the whole part, seen from its free end; before that
/// the range that the set-up turns.
fn profile(operation: &Operation, set_up: &SetUpWork) -> proof::Profile {
    let workpiece = &operation.workpiece;
    let last = operation.set_ups.last().is_some_and(|last| last.set_up.number == set_up.set_up.number);
    let seen = |profile: &Profile| {
        if set_up.set_up.turned_over { profile.turned_over(workpiece.length()) } else { profile.clone() }
    };
    let (outer, inner) = if last {
        (Some(seen(&workpiece.outer)), workpiece.inner.as_ref().map(seen))
    } else {
        let own = |side: &Option<crate::turning::zones::TurnedSide>| side.as_ref().map(|side| side.profile.clone());
        (own(&set_up.set_up.outer), own(&set_up.set_up.inner))
    };
    let pieces =
        |profile: &Profile| (0..profile.surfaces.len()).flat_map(|at| surface_pieces(profile, at, operation)).collect();
    let bore: Vec<proof::ProfilePiece> = inner.as_ref().map(pieces).unwrap_or_default();
    let mut outside: Vec<proof::ProfilePiece> = outer.as_ref().map(pieces).unwrap_or_default();
    // The file may leave out the face of the end.
    let within = bore.first().map_or(Mm(0.0), |first| first.path.from().radius);
    if let Some(first) = outside.first().map(|first| first.path.from()).filter(|first| first.radius.0 > within.0) {
        let face = proof::Piece::Line { from: At::new(first.z, within), to: first };
        outside.insert(0, proof::ProfilePiece::new(face, None));
    }
    proof::Profile { outside, bore }
}

fn surface_pieces(profile: &Profile, at: usize, operation: &Operation) -> Vec<proof::ProfilePiece> {
    let surface = &profile.surfaces[at];
    let later = operation.elsewhere.iter().find(|one| one.surface == surface.name);
    let thread = (surface.kind == SurfaceKind::Thread).then(|| thread(profile, at, operation)).flatten();
    let piece = |piece: &Piece| proof::ProfilePiece {
        path: proof_piece(piece),
        surface: Some((&surface.name).into_figure()),
        allowance: Mm(later.map_or(0.0, |one| one.allowance_mm.to_mm())),
        thread,
    };
    // A drawn cone at the bottom of a drilled hole stands for the point of the drill, whatever its angle.
    let axial = operation.set_ups.iter().filter_map(|set_up| set_up.axial.as_ref());
    if axial.into_iter().any(|axial| axial.is_point(&surface.name)) {
        return surface.pieces.iter().map(|one| piece(&as_drilled(one))).collect();
    }
    surface.pieces.iter().map(piece).collect()
}

/// A cone to the axis as the point of a drill leaves it.
fn as_drilled(cone: &Piece) -> Piece {
    let tip = |wall: Point, axis: Point| {
        let length = point_length(wall.radius);
        Point { z: if axis.z > wall.z { wall.z + length } else { wall.z - length }, ..axis }
    };
    match (cone.from.radius, cone.to.radius) {
        (_, Half::ZERO) => Piece::line(cone.from, tip(cone.from, cone.to)),
        (Half::ZERO, _) => Piece::line(tip(cone.to, cone.from), cone.to),
        _ => *cone,
    }
}

/// The crests of a thread are its surface as it is turned. Its passes must come between the limits of the pitch diameter: the
/// tip of a pass lies H/2 − r = √3/4 · P − r beyond the pitch line that it makes, with the nose radius r of the tool.
fn thread(profile: &Profile, at: usize, operation: &Operation) -> Option<proof::Thread> {
    let surface = &profile.surfaces[at];
    let name = surface.name.to_string();
    let thread = operation.workpiece.threads.iter().find(|thread| thread.surface == name)?;
    let crest = surface.pieces.first()?.from.radius.to_mm();
    let inside = crest < thread.size.to_mm() / 2.0 - 1e-6;
    let basic = thread.basic_pitch_diameter();
    let (least, most) = thread.flanks.as_ref().map_or((basic, basic), |limits| (limits.least, limits.most));
    let beyond = libm::sqrt(3.0) / 4.0 * thread.pitch.to_mm() - threading_nose(surface, operation);
    let tip = |pitch_diameter: Micrometres, outwards: f64| pitch_diameter.to_mm() / 2.0 + outwards * beyond;
    let (shallow, root) = if inside {
        (tip(least, 1.0) - ROUNDING, tip(most, 1.0) + ROUNDING)
    } else {
        (tip(most, -1.0) + ROUNDING, tip(least, -1.0) - ROUNDING)
    };
    // It is drawn at the nominal diameter and turned to the middle of what its tolerance leaves.
    let turned = thread.crests.as_ref().map_or(crest, |crests| crests.middle_radius().to_mm());
    let run_out = Mm(run_out(profile, at, thread.longest_run_out));
    let mm = |length: Micrometres| Mm(length.to_mm());
    let tap = thread.tapped.as_ref().map(|tapped| proof::TapLimits {
        diameter: mm(thread.size),
        pitch: mm(thread.pitch),
        largest_hole: mm(tapped.largest_hole_mm),
        run_out: mm(tapped.run_out_mm),
    });
    Some(proof::Thread { crest: Mm(turned), shallow: Mm(shallow), root: Mm(root), run_out, tap })
}

/// How far a thread may cut into the metal behind it: as the standard allows, but not into a seat, mm.
fn run_out(profile: &Profile, at: usize, longest: Option<Micrometres>) -> f64 {
    /// The coarsest grade of a seat.
    const SEAT: u8 = 9;
    let Some(longest) = longest.map(Micrometres::to_mm) else { return 0.0 };
    let Some(end) = profile.surfaces[at].pieces.last().map(|last| last.to.z.to_mm()) else { return 0.0 };
    let mut behind = profile.surfaces.iter().skip(at + 1);
    let seat = behind.find(|next| next.grade.is_some_and(|grade| grade.number() <= SEAT));
    let seat = seat.and_then(|seat| seat.pieces.first()).map(|first| (first.from.z.to_mm() - end).abs());
    seat.map_or(longest, |seat| seat.min(longest))
}

/// The nose radius of the tool that cuts a thread, mm; a sharp point where none does.
fn threading_nose(surface: &Surface, operation: &Operation) -> f64 {
    let mut jobs = operation.set_ups.iter().flat_map(|work| &work.jobs);
    let job = jobs.find(|job| job.thread.is_some() && job.surfaces.contains(&surface.name));
    match job.map(|job| &job.tool.body) {
        Some(Body::Insert { nose_radius_mm, .. }) => nose_radius_mm.to_mm(),
        _ => 0.0,
    }
}

fn tool(tool: &JobTool) -> proof::Tool {
    let mm = |length: Micrometres| Mm(length.to_mm());
    let degrees = |angle: Degrees| proof::Degrees(angle.0);
    let (cutter, holder) = match &tool.body {
        Body::Drill { diameter_mm, point_angle_deg, flute_mm } => {
            // If the length is unknown, the whole edge cuts.
            let flute = flute_mm.map_or(Mm(1000.0), mm);
            let point_angle = degrees(*point_angle_deg);
            (Cutter::Drill { diameter: mm(*diameter_mm), point_angle, flute }, Holder::None)
        }
        Body::Reamer { diameter_mm, front_mm, lead_mm, reach_mm } => {
            let (diameter, front, lead, reach) = (mm(*diameter_mm), mm(*front_mm), mm(*lead_mm), mm(*reach_mm));
            (Cutter::Reamer { diameter, front, lead, reach }, Holder::None)
        }
        Body::Tap { diameter_mm, pitch_mm, core_mm, lead_mm, thread_mm, neck_mm, shank_mm, free_mm } => {
            let (diameter, pitch, core, lead) = (mm(*diameter_mm), mm(*pitch_mm), mm(*core_mm), mm(*lead_mm));
            let (thread, neck, shank, free) = (mm(*thread_mm), mm(*neck_mm), mm(*shank_mm), mm(*free_mm));
            (Cutter::Tap { diameter, pitch, core, lead, thread, neck, shank, free }, Holder::None)
        }
        Body::CentreDrill { pilot_mm, pilot_length_mm, body_mm } => (
            Cutter::CentreDrill { pilot: mm(*pilot_mm), pilot_length: mm(*pilot_length_mm), body: mm(*body_mm) },
            Holder::None,
        ),
        Body::Insert {
            kind,
            works,
            hand,
            lead_angle_deg,
            trail_angle_deg,
            nose_radius_mm,
            edge_mm,
            width_mm,
            blade_depth_mm,
            side_mm,
            shank_mm,
            bar_mm,
            min_bore_mm,
        } => {
            let side = if *works == Place::Inner { proof::Side::Inside } else { proof::Side::Outside };
            let hand = match hand {
                Hand::R => proof::Hand::Right,
                Hand::L => proof::Hand::Left,
                Hand::N => proof::Hand::Neutral,
            };
            let (width, depth) = (width_mm.map_or(Mm(0.0), mm), blade_depth_mm.map_or(Mm(0.0), mm));
            let corner_radius = mm(*nose_radius_mm);
            let cutter = match kind {
                ToolKind::Turning | ToolKind::Boring => Cutter::Insert {
                    lead_angle: degrees(*lead_angle_deg),
                    trail_angle: degrees(*trail_angle_deg),
                    nose_radius: mm(*nose_radius_mm),
                    edge_length: mm(edge_mm.unwrap_or(UNKNOWN_EDGE)),
                    hand,
                    side,
                },
                ToolKind::Grooving => Cutter::Blade { width, corner_radius, depth, side },
                ToolKind::FaceGrooving => Cutter::FaceBlade { width, corner_radius, depth },
                ToolKind::Threading => {
                    let reach = mm(edge_mm.unwrap_or(UNKNOWN_EDGE));
                    Cutter::Thread { angle: proof::Degrees(60.0), reach, beside: side_mm.map_or(reach, mm), side }
                }
            };
            let blade = matches!(kind, ToolKind::Grooving | ToolKind::FaceGrooving);
            let holder = match (shank_mm, bar_mm) {
                (Some((_, width)), _) if blade => Holder::shank_of_blade(mm(*width)),
                (Some((_, width)), _) => Holder::shank(mm(*width), hand),
                (None, Some(bar)) => {
                    // If the smallest bore is unknown, a quarter more than the diameter of the bar.
                    let least = min_bore_mm.map_or(Mm(bar.to_mm() * 1.25), mm);
                    Holder::bar(mm(*bar), least)
                }
                (None, None) => Holder::None,
            };
            (cutter, holder)
        }
    };
    proof::Tool { designation: tool.designation.clone(), cutter, holder }
}

/// The largest error of a depth by rounding of a path, mm.
const ROUNDING: f64 = 0.002;
