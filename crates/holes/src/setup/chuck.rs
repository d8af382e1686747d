//! A three-jaw chuck on the table for a round part: which one takes it, how its jaws stand, and how hard they must press.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note};
use crate::part::{Outline, Part, Point};
use crate::plan::{Chuck, HolePlan};
use crate::shop::Shop;
use crate::tables::materials::TableChuck;
use crate::units::{Micrometres, Newtons};
use crate::zone;

use super::vice::{Limits, comes_out};
use super::{Load, loads_of};

/// The first row of `chucks` that takes the part, or why the first one of its diameter does not.
///
/// The part lies on a step of the jaws and is held by the wall of the next one; the jaws stay below the face, so that nothing is in
/// the way of a tool, and are turned so that no tool that comes out below meets one. Its rim is machined, as all planes are (textbook
/// 5.2 item 3).
///
/// # Errors
/// The knowledge base has no answer.
pub fn chuck(part: &Part, holes: &[HolePlan], shop: &Shop<'_>) -> Result<Result<Chuck, Note>, KnowledgeError> {
    let diameter = part.blank.length;
    let rows: Vec<TableChuck<'_>> = shop.knowledge.rows()?;
    let limits = Limits::read(shop)?;
    let loads = loads(part, holes, shop)?;
    let mass = zone::mass(part, shop.knowledge)?.map_or(0.0, |mass| mass.most);
    let job = InChuck { part, holes, loads: &loads, limits: &limits, mass };
    let mut why = None;
    for row in rows.iter().filter(|row| row.part_diameter_min <= diameter && diameter <= row.part_diameter_max) {
        match job.held(row, shop)? {
            Ok(chuck) => return Ok(Ok(chuck)),
            Err(refused) => {
                why.get_or_insert(refused.with("chuck", row.designation.to_owned()).with("step", row.step));
            }
        }
    }
    let least = rows.iter().map(|row| row.part_diameter_min).min().unwrap_or_default();
    let most = rows.iter().map(|row| row.part_diameter_max).max().unwrap_or_default();
    let none = || Note::new("chuck-of-no-size").with("diameter", diameter).with("least", least).with("most", most);
    Ok(Err(why.unwrap_or_else(none)))
}

/// A load with its thrust and how far from the axis of the part it acts.
struct Pressed<'p> {
    load: Load<'p>,
    thrust: Newtons,
    out: Micrometres,
}

/// The loads of all transitions on this machine, each at the place of its hole farthest from the axis.
fn loads<'p>(part: &Part, holes: &'p [HolePlan], shop: &Shop<'_>) -> Result<Vec<Pressed<'p>>, KnowledgeError> {
    let mut all = Vec::new();
    for (plan, hole) in holes.iter().zip(&part.holes) {
        let out = hole.ways().flat_map(|way| [way.from, way.to]).map(|at| at.distance(part.middle())).max();
        // The greatest thrust of the group with each of its torques: no less than what acts together.
        let here = plan.transitions.iter().filter(|transition| !transition.elsewhere);
        let thrust = here.filter_map(|transition| transition.conditions.axial_force_n).map(|force| force.0);
        let thrust = Newtons(thrust.fold(0.0, f64::max));
        let pressed = |(load, _)| Pressed { load, thrust, out: out.unwrap_or_default() };
        all.extend(loads_of(plan, shop)?.into_iter().map(pressed));
    }
    Ok(all)
}

struct InChuck<'a> {
    part: &'a Part,
    holes: &'a [HolePlan],
    loads: &'a [Pressed<'a>],
    limits: &'a Limits,
    mass: f64,
}

impl InChuck<'_> {
    /// The part on that step, or the inequality that fails.
    fn held(&self, row: &TableChuck<'_>, shop: &Shop<'_>) -> Result<Result<Chuck, Note>, KnowledgeError> {
        let (thickness, limits) = (self.part.blank.thickness, self.limits);
        if let Some(height) = self.part.fixture.height.filter(|height| *height != row.part_height) {
            return Ok(Err(Note::new("chuck-not-that-high").with("height", height).with("own", row.part_height)));
        }
        let below_face = thickness - row.jaws_above;
        if below_face < limits.below_face || row.wall < limits.grip {
            let note = Note::new("chuck-no-grip").with("thickness", thickness).with("above", row.jaws_above);
            return Ok(Err(note.with("below_face", limits.below_face)));
        }
        if let Some(hole) = self
            .part
            .holes
            .iter()
            .find(|hole| hole.slot.is_some_and(|slot| slot.open.is_some()) && hole.depth >= below_face)
        {
            let note = Note::new("chuck-slot-over-jaw").with("slot", Figure::called(&hole.name));
            return Ok(Err(note.with("depth", hole.depth).with("below", below_face)));
        }
        let below = self.holes.iter().map(|plan| comes_out(self.part, plan)).max().unwrap_or_default();
        if below > Micrometres::ZERO && below + limits.room_below > row.room {
            let note = Note::new("chuck-no-room-below").with("below", below).with("room", row.room);
            return Ok(Err(note.with("least", limits.room_below)));
        }
        // The next step towards the axis lies as far below the part as this wall is high.
        let steps = if below + limits.room_below > row.wall { row.step } else { 1 };
        let from = (self.part.blank.length.half() - row.ledge.ratio(steps, 1)).max(Micrometres::ZERO);
        let Some(jaw_deg) = self.jaws(row, from) else {
            return Ok(Err(Note::new("chuck-jaws-below").with("width", row.jaw_width)));
        };
        let load_max = shop.machine.load_max_kg;
        if self.mass + row.mass.0 > load_max {
            let note = Note::new("chuck-too-heavy").with("mass", self.mass).with("own", row.mass.0);
            return Ok(Err(note.with("limit", load_max)));
        }
        let Some((force, load)) = self.needed(row) else { return Ok(Err(Note::new("no-chuck-known"))) };
        if force.0 > row.force.0 {
            let note = Note::new("chuck-too-weak").with("force", force.rounded(0).0).with("gives", row.force.0);
            return Ok(Err(note.with("hole", Figure::called(load.hole))));
        }
        let note = Note::new("chuck-holds")
            .with("diameter", self.part.blank.length)
            .with("least", row.part_diameter_min)
            .with("most", row.part_diameter_max)
            .with("step", row.step);
        let mut because = vec![Because::row(row.row, note)];
        because.extend(limits.of_chuck().cloned());
        Ok(Ok(Chuck {
            designation: row.designation.to_owned(),
            table: shop.knowledge.table_of::<TableChuck<'_>>()?.id.clone(),
            diameter_mm: row.diameter,
            step: u32::try_from(row.step).unwrap_or_default(),
            part_height_mm: row.part_height,
            room_mm: row.room,
            grip_mm: row.wall,
            below_face_mm: below_face,
            jaw_deg,
            jaw_width_mm: row.jaw_width,
            jaws_from_mm: from,
            force_n: force.rounded(0),
            hole: load.hole.to_owned(),
            gives_n: row.force,
            mass_kg: row.mass.0,
            because,
        }))
    }

    /// Where the first jaw stands, in steps of 5°: so that holes that come out below keep five times the room from every jaw
    /// under the part that a tool needs, or else at least that room; none where they cannot.
    fn jaws(&self, row: &TableChuck<'_>, from: Micrometres) -> Option<u32> {
        let (part, middle, room) = (self.part, self.part.middle(), self.limits.room_below);
        let (half, radius) = (row.jaw_width.half(), part.blank.length.half());
        // A jaw along +X; the holes are turned back onto it.
        let jaw = Outline::Box(
            Point { x: middle.x + from, y: middle.y - half },
            Point { x: middle.x + radius, y: middle.y + half },
        );
        let through = part.holes.iter().zip(self.holes).filter(|(_, plan)| comes_out(part, plan) > Micrometres::ZERO);
        let ways: Vec<_> = through
            .flat_map(|(hole, _)| {
                let steps = hole.steps.iter().map(|step| step.diameter.nominal);
                let widest = steps.fold(hole.diameter.nominal, Micrometres::max);
                hole.ways().map(move |way| (way, widest.half() - way.thinner))
            })
            .collect();
        let clear = |first: u32, aside: Micrometres| {
            [0, 120, 240].iter().all(|more| {
                let back = -f64::from(first + more);
                ways.iter().all(|(way, reach)| {
                    let [from, to] = [way.from, way.to].map(|at| turned(at, middle, back));
                    !jaw.is_hit(from, to, *reach + aside)
                })
            })
        };
        // At 90° and 30° they stand alike when the part is turned over, so that the chuck stays as it lies.
        let angles = || [90, 30].into_iter().chain((0..24).map(|step| 5 * step));
        [room.ratio(5, 1), room].into_iter().find_map(|aside| angles().find(|first| clear(*first, aside)))
    }

    /// The force Q of all jaws together, N, and the load that needs the most of it, for a part of diameter D gripped as deep as g
    /// with the friction f at the jaws:
    ///
    /// - turning: 2·k·(M + P·e)/D ≤ f·Q, the torque M of a tool and that of its side force P at e from the axis borne by friction
    ///   alone; P takes from one jaw what it gives to the others;
    /// - sliding: k·P ≤ Q/2, for jaws are stops: of three equally stiff ones, each pressing with Q/3, that from which P pushes away
    ///   loses 2/3 of P, and lets go at Q/2;
    /// - tipping by P at the face: 2·√3·k·P·a ≤ Q·g, a from the middle of the grip up to the face: each jaw presses with Q/3 at an
    ///   edge of the grip at worst, and of three at 120° at least √3 count about any line;
    /// - tipping by the thrust T of a tool outside the three supports, steps as wide as the jaws w that reach to the rim: about the
    ///   line between two of them, s = R·cos(60° − asin(w/D)) from the axis, k·T·(e − s) ≤ f·Q/3·(R + s), by the friction of the one
    ///   jaw across from it.
    ///
    /// Statics of a disc between three jaws, with constants of the table `clamping`.
    fn needed(&self, row: &TableChuck<'_>) -> Option<(Newtons, &Load<'_>)> {
        let (k, f) = (self.limits.safety, self.limits.friction);
        let metres = |length: Micrometres| length.to_mm() / 1000.0;
        let (diameter, grip) = (metres(self.part.blank.length), metres(row.wall));
        let arm = metres(self.part.blank.thickness) - grip / 2.0;
        let radius = diameter / 2.0;
        let beside = libm::asin((metres(row.jaw_width) / diameter).min(1.0));
        let line = radius * libm::cos(60.0_f64.to_radians() - beside);
        let force = |one: &Pressed<'_>| {
            let (side, out) = (one.load.side.map_or(0.0, |side| side.0), metres(one.out));
            let turning = 2.0 * k * (one.load.torque.0 + side * out) / (diameter * f);
            let sliding = 2.0 * k * side;
            let tipping = 2.0 * 3.0_f64.sqrt() * k * side * arm / grip;
            let thrust = 3.0 * k * one.thrust.0 * (out - line).max(0.0) / (f * (radius + line));
            turning.max(sliding).max(tipping).max(thrust)
        };
        let forces = self.loads.iter().map(|one| (force(one), &one.load));
        forces.max_by(|one, two| one.0.total_cmp(&two.0)).map(|(force, load)| (Newtons(force), load))
    }
}

/// A point turned about another one, counter-clockwise.
fn turned(at: Point, about: Point, degrees: f64) -> Point {
    let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    let (x, y) = ((at.x - about.x).to_mm(), (at.y - about.y).to_mm());
    Point {
        x: about.x + Micrometres::from_mm_rounded(x * cos - y * sin),
        y: about.y + Micrometres::from_mm_rounded(x * sin + y * cos),
    }
}
