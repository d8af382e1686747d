//! Clamping: the force that holds the part against torques and side forces, and the screw that gives this force.
//!
//! - `hold`: whether the places of the clamps hold it against turning and tipping;
//! - `fixture`: its kind, and how table, fixture and part are located;
//! - `pins`: the pins of a part that lies on holes;
//! - `places`: where straps may stand;
//! - `vice`: a vice, where clamps find no place;
//! - `chuck`: a chuck on the table, the same for round parts;
//! - `chains`: zeros by the dimensions of the drawing, and whether their chains close.

mod chains;
mod chuck;
mod fixture;
mod hold;
mod pins;
mod places;
mod vice;

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::note::{Because, Figure, Finding, IntoFigure, Note, Severity};
use crate::part::{Face, Fixture, Outline, Part, Point};
use crate::plan::{Chuck, Clamping, HolePlan, Operation, OwnFixture, Plan, Strap, Transition, Vice};
use crate::shop::{Shop, convention};
use crate::tables::controls::Convention;
use crate::tables::holes::HoleDefault;
use crate::tables::materials::{ClampScrew, Clamping as Constant, ClampingConstant, StrapRow};
use crate::tables::rules::{ClampingLoadFor, PartLoad};
use crate::units::{Micrometres, NewtonMetres, Newtons, round_to};

/// The clamping of a planned part: W = k·M/(f·d) (textbook 5.2 item 7), and where the rule `clamping-load` says that a
/// transition pushes the part aside, W = k·P/(f + f2) with P = 2·M/D if that is more; the largest value over all holes.
///
/// d is the distance from the hole to the nearest clamp, D the diameter on which the edges cut; k, f and f2 are rows of
/// `clamping`. The force is divided over the clamps. The screw is the smallest of `clamp-screws` that bears it at 80 MPa and is not thinner than
/// `least-screw`.
///
/// Clamps of the file that are not enough, or that stand where they cannot hold the part (`hold`), are returned with the inequality that fails. Where the file has none,
/// places are tried until one set holds. Where none holds, no clamps are returned, because a tool would hit them; the
/// finding says that another fixture is needed.
///
/// # Errors
/// The knowledge base has no answer.
pub fn clamping(
    part: &Part,
    holes: &[HolePlan],
    shop: &Shop<'_>,
) -> Result<(Option<Clamping>, Vec<Finding>), KnowledgeError> {
    if part.fixture.own.is_some() {
        return Ok((None, Vec::new()));
    }
    let inset = shop.convention(HoleDefault::ClampInset)?;
    let combined = shop.share(HoleDefault::ClampPairsCombined)? as usize;
    if !part.fixture.clamps.is_empty() {
        let clamps = part.fixture.clamps.iter().map(|clamp| clamp.at).collect();
        let Some((clamping, faults)) = clamped(part, holes, clamps, false, shop)? else {
            return Ok((None, Vec::new()));
        };
        return Ok((Some(clamping), faults));
    }
    // Of each number of straps what is wrong with the first set, which has the most room to the holes.
    let mut whys: BTreeMap<usize, Note> = BTreeMap::new();
    let mut torque = NewtonMetres(0.0);
    for clamps in proposals(part, inset, combined, &shop.machine) {
        let count = clamps.len();
        let Some((clamping, faults)) = clamped(part, holes, clamps, true, shop)? else { break };
        let Some(Finding { note: why, .. }) = faults.into_iter().next() else {
            return Ok((Some(clamping), Vec::new()));
        };
        torque = clamping.torque_n_m;
        whys.entry(count).or_insert(why);
    }
    let told = |(clamps, why): (usize, Note)| {
        Note::new("straps-of-number").with("clamps", clamps).with("why", why).into_figure()
    };
    let none = whys.is_empty();
    let why = Figure::List(whys.into_iter().map(told).collect(), "; ");
    let note = Note::new("no-place-for-clamps").with("torque", torque.rounded(1).0).with("why", why);
    let finding = (!none).then(|| Finding::of_part(Severity::Wrong, note));
    Ok((None, finding.into_iter().collect()))
}

/// The clamps of the second set-up, by what is cut there, with the part turned over: proposed as those of the first. None where nothing
/// is cut there, or the file says what holds it: a fixture of its own, or obstacles of that set-up.
///
/// # Errors
/// The knowledge base has no answer.
pub fn second_clamping(
    part: &Part,
    holes: &[HolePlan],
    shop: &Shop<'_>,
) -> Result<(Option<Clamping>, Vec<Finding>), KnowledgeError> {
    let back: Vec<HolePlan> = holes.iter().map(|plan| of_face(plan, Face::Back)).collect();
    let given = part.fixture.own.is_some() || part.fixture.obstacles.iter().any(|one| one.set_up == 2);
    if given || back.iter().all(|plan| plan.transitions.is_empty()) {
        return Ok((None, Vec::new()));
    }
    let (clamping, findings) = clamping(&turned(part), &back, shop)?;
    let of_second = |own: Finding| Finding { note: Note::new("in-second-set-up").with("why", own.note), ..own };
    Ok((clamping, findings.into_iter().map(of_second).collect()))
}

/// The part as it lies in the second set-up, without the clamps of the first.
fn turned(part: &Part) -> Part {
    let mut turned = part.clone();
    turned.fixture.clamps.clear();
    for at in turned.holes.iter_mut().flat_map(|hole| &mut hole.at) {
        *at = part.turned_over(*at);
    }
    for slot in turned.holes.iter_mut().filter_map(|hole| hole.slot.as_mut()) {
        slot.x = -slot.x;
    }
    turned
}

/// All sets of clamps that hold the part while it is cut from a face, as they are proposed one after another where the file has none.
///
/// # Errors
/// The knowledge base has no answer.
pub fn clampings(
    part: &Part,
    holes: &[HolePlan],
    face: Face,
    shop: &Shop<'_>,
) -> Result<Vec<Clamping>, KnowledgeError> {
    let inset = shop.convention(HoleDefault::ClampInset)?;
    let combined = shop.share(HoleDefault::ClampPairsCombined)? as usize;
    let own: Vec<HolePlan> = holes.iter().map(|plan| of_face(plan, face)).collect();
    let turned = (face == Face::Back).then(|| turned(part));
    let part = turned.as_ref().unwrap_or(part);
    let mut sets = Vec::new();
    for kind in [proposals, uneven] {
        for places in kind(part, inset, combined, &shop.machine) {
            if let Some((clamping, faults)) = clamped(part, &own, places, true, shop)?
                && faults.is_empty()
            {
                sets.push(clamping);
            }
        }
        if !sets.is_empty() {
            break;
        }
    }
    Ok(sets)
}

/// Three or four straps that stand where the holes leave them room, for a part that no symmetric set and no vice holds; none where
/// the file says what holds it, or where none of these would.
///
/// # Errors
/// The knowledge base has no answer.
pub fn uneven_clamping(
    part: &Part,
    holes: &[HolePlan],
    face: Face,
    shop: &Shop<'_>,
) -> Result<Option<Clamping>, KnowledgeError> {
    if part.fixture.own.is_some() || (face == Face::Entry && !part.fixture.clamps.is_empty()) {
        return Ok(None);
    }
    Ok(clampings(part, holes, face, shop)?.into_iter().next())
}

/// A group of holes with what is done here from one face.
pub fn of_face(plan: &HolePlan, face: Face) -> HolePlan {
    let transitions = plan.transitions.iter().filter(|one| !one.elsewhere && one.face == face).cloned().collect();
    HolePlan { transitions, ..plan.clone() }
}

/// A device whose jaws hold the part at its sides, in both set-ups.
#[derive(Clone, Debug)]
pub enum Jaws {
    /// Two flat ones.
    Vice(Vice),
    /// Three about a round part.
    Chuck(Chuck),
}

impl Jaws {
    /// Sets them in a plan, which has no clamps then.
    pub fn hold(self, plan: &mut Plan) {
        (plan.clamping, plan.setup.second_clamping) = (None, None);
        match self {
            Self::Vice(vice) => plan.setup.vice = Some(vice),
            Self::Chuck(chuck) => plan.setup.chuck = Some(chuck),
        }
    }
}

/// The jaws of the tables that hold the part, or why none do: between two flat ones a disc would roll.
///
/// # Errors
/// The knowledge base has no answer.
pub fn jaws(part: &Part, holes: &[HolePlan], shop: &Shop<'_>) -> Result<Result<Jaws, Note>, KnowledgeError> {
    Ok(match part.blank.is_round() {
        true => chuck(part, holes, shop)?.map(Jaws::Chuck).map_err(|why| Note::new("no-chuck").with("why", why)),
        false => vice(part, holes, shop)?.map(Jaws::Vice).map_err(|why| Note::new("no-vice").with("why", why)),
    })
}

/// Jaws for a part that no clamps hold: where the file names neither clamps nor what else stands there, and `findings` of
/// [`clamping`] say that clamps find no place. The finding then goes; where no jaws take the part either, or none at the height
/// of the file, another one says why.
///
/// # Errors
/// The knowledge base has no answer.
pub fn jaws_instead(
    part: &Part,
    holes: &[HolePlan],
    findings: &mut Vec<Finding>,
    shop: &Shop<'_>,
) -> Result<Option<Jaws>, KnowledgeError> {
    // Of a file without clamps there is no other finding.
    let Fixture { clamps, obstacles, pins, .. } = &part.fixture;
    // Jaws and pins would each put the part where the other does not.
    if !clamps.is_empty() || !obstacles.is_empty() || !pins.is_empty() || findings.is_empty() {
        return Ok(None);
    }
    match jaws(part, holes, shop)? {
        Ok(jaws) => {
            findings.clear();
            Ok(Some(jaws))
        }
        Err(why) => {
            // Nobody may begin to cut a part that nothing holds; a fixture of the shop's own is for the file to name.
            findings.push(Finding::of_part(Severity::Wrong, why));
            Ok(None)
        }
    }
}

/// The fixture of the shop's own that the file names, with the largest torque and side force that it must hold; none where it names
/// none, or nothing is cut.
///
/// # Errors
/// The knowledge base has no answer.
pub fn own(part: &Part, holes: &[HolePlan], shop: &Shop<'_>) -> Result<Option<OwnFixture>, KnowledgeError> {
    let Some(name) = &part.fixture.own else { return Ok(None) };
    let mut loads = Vec::new();
    for plan in holes {
        loads.extend(loads_of(plan, shop)?);
    }
    let side = loads.iter().filter_map(|(load, _)| load.side).max_by(|one, two| one.0.total_cmp(&two.0));
    let worst = loads.iter().max_by(|(one, _), (two, _)| one.torque.0.total_cmp(&two.torque.0));
    let Some((load, _)) = worst else { return Ok(None) };
    let (safety, why) = constant(ClampingConstant::Safety, shop)?;
    Ok(Some(OwnFixture {
        name: name.clone(),
        hole: load.hole.to_owned(),
        torque_n_m: load.torque,
        side_force_n: side.map(|side| side.rounded(0)),
        safety,
        because: vec![why],
    }))
}

use places::{blocked, proposals, uneven};

pub use chains::{Chains, chains};
pub use chuck::chuck;
pub use fixture::{fixture, held_by, locating};
pub use vice::vice;

/// The force that a transition needs, by the formula that asks for more.
struct Need<'p> {
    force: f64,
    torque: NewtonMetres,
    /// The side force, where it governs.
    side: Option<Newtons>,
    hole: &'p str,
    distance: Micrometres,
    why: Because,
}

/// A constant of the table `clamping`, and its row as a reason.
fn constant(wanted: ClampingConstant, shop: &Shop<'_>) -> Result<(f64, Because), KnowledgeError> {
    let row = shop.knowledge.need(wanted.name(), |row: &Constant<'_>| row.name.is(wanted))?;
    Ok((row.maximum, Because::row(row.row, Note::new(wanted.name()).with("value", row.maximum))))
}

/// What a transition does to the part, wherever it is held.
struct Load<'p> {
    torque: NewtonMetres,
    /// The side force, where it pushes.
    side: Option<Newtons>,
    operation: Operation,
    hole: &'p str,
}

/// The loads of all transitions of a group on this machine that have a torque, each with the row that says what it does.
fn loads_of<'p, 'k>(plan: &'p HolePlan, shop: &Shop<'k>) -> Result<Vec<(Load<'p>, RowRef<'k>)>, KnowledgeError> {
    let mut loads = Vec::new();
    // On another machine the part is clamped anew.
    for transition in plan.transitions.iter().filter(|transition| !transition.elsewhere) {
        let Some(torque) = transition.conditions.torque_n_m.filter(|torque| torque.0 > 0.0) else { continue };
        let operation = transition.operation;
        let load = shop.knowledge.ask(&ClampingLoadFor { operation })?.need(operation.name())?;
        let side = (load.load == PartLoad::Pushes).then(|| side_force(transition, torque)).flatten();
        loads.push((Load { torque, side, operation, hole: &plan.name }, load.row));
    }
    Ok(loads)
}

/// P = 2·M/D: D is the diameter of a mill, or of the hole that a bar's edge leaves.
fn side_force(transition: &Transition, torque: NewtonMetres) -> Option<Newtons> {
    let on = match transition.operation {
        Operation::Mill => transition.tool.diameter_mm,
        _ => transition.diameter_mm,
    };
    (on > Micrometres::ZERO).then(|| Newtons(2.0 * torque.0 / (on.to_mm() / 1000.0)))
}

/// The clamping with clamps at those places, and the conditions that do not hold.
fn clamped(
    part: &Part,
    holes: &[HolePlan],
    clamps: Vec<Point>,
    proposed: bool,
    shop: &Shop<'_>,
) -> Result<Option<(Clamping, Vec<Finding>)>, KnowledgeError> {
    let ((k, safety), (f, friction)) =
        (constant(ClampingConstant::Safety, shop)?, constant(ClampingConstant::Friction, shop)?);
    let (f2, of_support) = constant(ClampingConstant::SupportFriction, shop)?;
    let (rounding, _) = constant(ClampingConstant::SafetyRounding, shop)?;
    let inset = shop.convention(HoleDefault::ClampInset)?;

    let mut worst: Option<Need<'_>> = None;
    let (mut turns, mut pushes) = ((NewtonMetres(0.0), ""), Newtons(0.0));
    for (plan, hole) in holes.iter().zip(&part.holes) {
        // The point nearest to a clamp needs the most against turning; against sliding all need the same.
        let distances = hole.ways().flat_map(|way| clamps.iter().map(move |clamp| way.nearest(*clamp)));
        let Some(distance) = distances.filter(|distance| *distance > Micrometres::ZERO).min() else { continue };
        for (Load { torque, side, operation, .. }, row) in loads_of(plan, shop)? {
            let by_book = k * torque.0 / (f * distance.to_mm() / 1000.0);
            if torque.0 > turns.0.0 {
                turns = (torque, plan.name.as_str());
            }
            pushes.0 = pushes.0.max(side.map_or(0.0, |side| side.0));
            // What governs, by the larger force.
            let side = side.filter(|side| k * side.0 / (f + f2) > by_book);
            let force = side.map_or(by_book, |side| k * side.0 / (f + f2));
            if worst.as_ref().is_some_and(|known| force <= known.force) {
                continue;
            }
            let note = match side {
                Some(side) => Note::new("clamping-pushes")
                    .with("side", side.rounded(0).0)
                    .with("force", Newtons(force).rounded(0).0),
                None => Note::new("clamping-turns"),
            };
            let note = note
                .with("operation", Figure::operation(operation.name()))
                .with("torque", torque.rounded(2).0)
                .with("by_book", Newtons(by_book).rounded(0).0);
            worst = Some(Need { force, torque, side, hole: &plan.name, distance, why: Because::row(row, note) });
        }
    }
    let Some(Need { force, torque, side, hole, distance, why }) = worst else { return Ok(None) };
    let (thinnest, no_thinner) = constant(ClampingConstant::LeastScrew, shop)?;
    let each = Newtons(force / clamps.len().max(1) as f64);
    let screws: Vec<ClampScrew<'_>> = shop.knowledge.rows()?;
    let thick = |screw: &&ClampScrew<'_>| screw.nominal_diameter.to_mm() >= thinnest;
    let straps: Vec<StrapRow<'_>> = shop.knowledge.rows()?;
    let slot = shop.machine.slot_width;
    // A screw that the file names is one that the shop has, whatever its bolt stands in.
    let named = part.fixture.clamps.iter().find_map(|clamp| clamp.screw.clone());
    let slot = slot.filter(|_| named.is_none());
    let fits = |screw: &&ClampScrew<'_>| {
        let strap = straps.iter().find(|strap| strap.screw == screw.thread);
        slot.zip(strap).is_none_or(|(slot, strap)| strap.slot <= slot)
    };
    let strong = screws.iter().filter(thick).filter(fits).find(|screw| screw.force_80.0 >= each.0);
    let strongest = screws.iter().rfind(fits);
    // The safety factor is printed to one decimal: a screw that lacks less than that leaves a factor that rounds to it.
    let short = |bears: Newtons| {
        if bears.0 * k < each.0 * (k - rounding) { Severity::Error } else { Severity::Doubtful }
    };
    // What would hold with the same screws: more of them, or less torque, to which the force is proportional.
    let count = clamps.len();
    let remedied = |note: Note, bears: Newtons| {
        let enough = libm::ceil(force / bears.0).max(1.0);
        let most = torque.0 * bears.0 * count as f64 / force;
        note.with("enough", round_to(enough, 0))
            .with("share", Newtons(force / enough).rounded(0).0)
            .with("torque", torque.rounded(2).0)
            .with("most", round_to(libm::floor(most * 10.0) / 10.0, 1))
    };
    let mut faults = Vec::new();
    if let (None, Some(strongest)) = (strong, strongest) {
        let note = match slot {
            Some(slot) => Note::new("no-screw-for-slot")
                .with("slot", slot)
                .with("screw", strongest.thread)
                .with("bears", strongest.force_80.0),
            None => Note::new("no-screw").with("screw", strongest.thread).with("bears", strongest.force_80.0),
        };
        let note = note.with("force", each.rounded(0).0).with("clamps", clamps.len());
        faults.push(Finding::of_part(short(strongest.force_80), remedied(note, strongest.force_80)));
    }
    // Where no screw bears the force, the strongest is shown.
    let screw = match strong.or(strongest) {
        Some(screw) => screw,
        None => return Err(KnowledgeError::no_row(shop.knowledge.table_of::<ClampScrew<'_>>()?, "a screw")),
    };
    // The screws of the drawing are kept; the plan then says which screw would be enough.
    let shown = screws.iter().find(|screw| named.as_deref() == Some(screw.thread)).unwrap_or(screw);
    let (name, most) = (screw.thread, shown.force_80);
    let note = Note::new("screw").with("needed", name).with("taken", shown.thread).with("bears", most.0);
    let mut because = vec![why, safety, friction];
    because.extend(side.map(|_| of_support));
    because.extend([no_thinner, Because::row(shown.row, note)]);
    let strap = straps.iter().find(|strap| proposed && strap.screw == shown.thread);
    because.extend(strap.map(|strap| {
        let note =
            Note::new("strap").with("screw", strap.screw).with("width", strap.width).with("height", strap.stands);
        Because::row(strap.row, note)
    }));
    let clamping = Clamping {
        torque_n_m: torque,
        side_force_n: side.map(|side| side.rounded(0)),
        hole: hole.to_owned(),
        distance_mm: distance,
        force_n: Newtons(force).rounded(0),
        force_per_clamp_n: each.rounded(0),
        screw: shown.thread.to_owned(),
        screw_bears_n: most,
        clamps,
        proposed,
        strap: strap.map(|strap| Strap { width_mm: strap.width, length_mm: strap.length, height_mm: strap.stands }),
        safe_distance_mm: shown.safe_distance,
        because,
    };
    if let Some(note) = narrow_ring(part, inset).filter(|_| proposed) {
        faults.push(Finding::of_part(Severity::Error, note));
    }
    faults.extend(beside_strap(part, holes, &clamping, shop)?);
    if let Some((name, distance, needed)) = blocked(part, &clamping.clamps, inset) {
        let note = Note::new("clamp-near-hole").with("distance", distance).with("needed", needed);
        let note = note.with("hole", Figure::called(name));
        faults.push(Finding::of_part(Severity::Error, note));
    }
    if strong.is_some() && most.0 < each.0 {
        let note = Note::new("screw-too-weak")
            .with("screw", &clamping.screw)
            .with("bears", most.0)
            .with("force", clamping.force_per_clamp_n.0)
            .with("needed", name);
        faults.push(Finding::of_part(short(most), remedied(note, most)));
    }
    let hold = hold::Hold { torque: turns.0, side: pushes, hole: turns.1, bears: most, safety: k, friction: f + f2 };
    faults.extend(hold::faults(part, &clamping.clamps, hold, shop)?);
    Ok(Some((clamping, faults)))
}

/// A ring on which the foot of a strap, as far as the inset to both sides, does not stand.
fn narrow_ring(part: &Part, inset: Micrometres) -> Option<Note> {
    let (width, least) = ((part.blank.length - part.blank.bore?).half(), inset + inset);
    (width < least).then(|| Note::new("ring-too-narrow").with("width", width).with("least", least))
}

/// Two straps that overlap, or a hole whose tools come nearer to one than the margin of the convention.
fn beside_strap(
    part: &Part,
    holes: &[HolePlan],
    clamping: &Clamping,
    shop: &Shop<'_>,
) -> Result<Option<Finding>, KnowledgeError> {
    let Some(strap) = clamping.strap else { return Ok(None) };
    let side = Micrometres::from_mm_rounded(convention(Convention::ObstacleSide, shop.knowledge)?.0);
    let straps: Vec<Outline> = clamping.clamps.iter().map(|at| strap.standing(*at, part).outline).collect();
    for (at, one) in straps.iter().enumerate() {
        if let Some(other) = (at + 1..straps.len()).find(|other| one.overlaps(&straps[*other])) {
            let shown = |index: usize| clamping.clamps.get(index).map(|at| at.shown());
            let note = Note::new("straps-overlap").with("one", shown(at).unwrap_or_default());
            let note = note.with("other", shown(other).unwrap_or_default());
            return Ok(Some(Finding::of_part(Severity::Error, note)));
        }
    }
    let near = holes.iter().zip(&part.holes).find(|(plan, hole)| {
        let here = plan.transitions.iter().filter(|one| !one.elsewhere);
        let widest = here.map(|one| one.diameter_mm.max(one.tool.diameter_mm)).max().unwrap_or_default();
        let room = widest.max(hole.diameter.nominal).half() + side;
        hole.ways().any(|way| straps.iter().any(|strap| strap.is_hit(way.from, way.to, room - way.thinner)))
    });
    Ok(near.map(|(plan, _)| {
        let note = Note::new("strap-near-hole").with("screw", &clamping.screw).with("width", strap.width_mm);
        let note = note.with("least", side).with("hole", Figure::called(&plan.name));
        Finding::of_part(Severity::Error, note)
    }))
}
