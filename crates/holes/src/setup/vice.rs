//! A vice for a part on whose face straps find no place: which one takes it, how deep it grips, and how hard it must press.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note};
use crate::part::{Along, Part, Point};
use crate::plan::{HolePlan, Vice};
use crate::shop::Shop;
use crate::tables::materials::{ClampingConstant, MachineVice, Parallels};
use crate::units::{Micrometres, Newtons};

use super::{Load, constant, loads_of};

/// The first vice of `vices` that takes the part, or why the first one does not, which is the one whose figures are known best.
///
/// The part stands on parallels, or where no tool comes out below it on the ways; its jaws stay below the face, so that nothing is
/// in the way of a tool. Its sides are machined, as all planes are (textbook 5.2 item 3).
///
/// # Errors
/// The knowledge base has no answer.
pub fn vice(part: &Part, holes: &[HolePlan], shop: &Shop<'_>) -> Result<Result<Vice, Note>, KnowledgeError> {
    let rows: Vec<MachineVice<'_>> = shop.knowledge.rows()?;
    let parallels: Vec<Parallels<'_>> = shop.knowledge.rows()?;
    let limits = Limits::read(shop)?;
    let mut loads = Vec::new();
    for plan in holes {
        loads.extend(loads_of(plan, shop)?.into_iter().map(|(load, _)| load));
    }
    let job = InVice { part, holes, loads: &loads, limits: &limits, parallels: &parallels };
    let mut why = None;
    for row in &rows {
        for jaws in [Along::X, Along::Y] {
            match job.held(row, jaws, shop)? {
                Ok(vice) => return Ok(Ok(vice)),
                Err(refused) => {
                    why.get_or_insert(refused.with("vice", row.designation.to_owned()));
                }
            }
        }
    }
    Ok(Err(why.unwrap_or_else(|| Note::new("no-vice-known"))))
}

/// How far a tool comes out of a group of holes below the part.
pub(super) fn comes_out(part: &Part, plan: &HolePlan) -> Micrometres {
    let ends = plan.transitions.iter().filter(|one| !one.elsewhere).map(|transition| transition.end());
    (ends.max().unwrap_or_default() - part.blank.thickness).max(Micrometres::ZERO)
}

/// The constants of the table `clamping` that a vice is held by.
pub(super) struct Limits {
    pub safety: f64,
    pub friction: f64,
    pub grip: Micrometres,
    grip_share: f64,
    pub below_face: Micrometres,
    pub room_below: Micrometres,
    because: Vec<Because>,
}

impl Limits {
    pub(super) fn read(shop: &Shop<'_>) -> Result<Self, KnowledgeError> {
        let mut because = Vec::new();
        let mut read = |wanted| -> Result<f64, KnowledgeError> {
            let (value, why) = constant(wanted, shop)?;
            because.push(why);
            Ok(value)
        };
        let safety = read(ClampingConstant::Safety)?;
        // Jaws are ground steel, as a support.
        let friction = read(ClampingConstant::SupportFriction)?;
        let [grip, below_face, room_below] = [
            read(ClampingConstant::ViceGrip)?,
            read(ClampingConstant::ViceBelowFace)?,
            read(ClampingConstant::ViceRoomBelow)?,
        ]
        .map(Micrometres::from_mm_rounded);
        let grip_share = read(ClampingConstant::ViceGripShare)?;
        Ok(Self { safety, friction, grip, grip_share, below_face, room_below, because })
    }

    /// Why a chuck is held to them: a share of the height, read last, is not asked of one.
    pub(super) fn of_chuck(&self) -> impl Iterator<Item = &Because> {
        self.because.iter().take(self.because.len().saturating_sub(1))
    }
}

struct InVice<'a, 'k> {
    part: &'a Part,
    holes: &'a [HolePlan],
    loads: &'a [Load<'a>],
    limits: &'a Limits,
    parallels: &'a [Parallels<'k>],
}

impl InVice<'_, '_> {
    /// How far a tool comes out below the part.
    fn below(&self) -> Micrometres {
        self.holes.iter().map(|plan| comes_out(self.part, plan)).max().unwrap_or_default()
    }

    /// The part in that vice with its jaws along that axis, or the inequality that fails.
    fn held(&self, row: &MachineVice<'_>, jaws: Along, shop: &Shop<'_>) -> Result<Result<Vice, Note>, KnowledgeError> {
        let blank = &self.part.blank;
        let (along, between) = match jaws {
            Along::X => (blank.length, blank.width),
            Along::Y => (blank.width, blank.length),
        };
        if along > row.jaw_width || between > row.opening {
            let note = Note::new("vice-too-small").with("along", along).with("jaws", row.jaw_width);
            return Ok(Err(note.with("between", between).with("opening", row.opening)));
        }
        let on = match self.parallels(row, jaws) {
            Ok(on) => on,
            Err(why) => return Ok(Err(why)),
        };
        let raised = on.map_or(Micrometres::ZERO, |(on, _)| on.height);
        let grip = row.jaw_height - raised;
        if let Some(note) = self.slot_over_jaw(jaws, blank.thickness - grip) {
            return Ok(Err(note));
        }
        let needed = self.needed(between, grip);
        let Some((force, load)) = needed else { return Ok(Err(Note::new("no-vice-known"))) };
        if force.0 > row.force.0 {
            let note = Note::new("vice-too-weak").with("force", force.rounded(0).0).with("gives", row.force.0);
            return Ok(Err(note));
        }
        let note = Note::new("vice-holds")
            .with("between", between)
            .with("opening", row.opening)
            .with("along", along)
            .with("jaws", row.jaw_width);
        let table = shop.knowledge.table_of::<MachineVice<'_>>()?;
        let mut because = vec![Because::row(row.row, note)];
        because.extend(on.map(|(on, _)| {
            Because::row(on.row, Note::new("vice-parallels").with("height", on.height).with("below", self.below()))
        }));
        because.extend(self.limits.because.iter().cloned());
        Ok(Ok(Vice {
            designation: row.designation.to_owned(),
            table: table.id.clone(),
            jaws_along: jaws,
            jaw_width_mm: row.jaw_width,
            opened_mm: between,
            bed_height_mm: row.bed_height,
            parallels_mm: on.map(|(on, _)| on.height),
            thickest_parallels_mm: on.map(|(on, beside)| on.thickest.min(beside)),
            grip_mm: grip,
            below_face_mm: blank.thickness - grip,
            force_n: force.rounded(0),
            hole: load.hole.to_owned(),
            gives_n: row.force,
            because,
        }))
    }

    /// The lowest parallels that leave the tools room below the part and the jaws a grip below the face, with the room beside the
    /// holes above them; none where the part lies on the ways.
    fn parallels(&self, row: &MachineVice<'_>, jaws: Along) -> Result<Option<(&Parallels<'_>, Micrometres)>, Note> {
        let (thickness, limits, below) = (self.part.blank.thickness, self.limits, self.below());
        let most = (thickness - limits.below_face).min(row.jaw_height);
        let least = limits.grip.max(Micrometres::from_mm_rounded(limits.grip_share * thickness.to_mm()));
        // The height of the file is that of the ways and the parallels.
        let given = self.part.fixture.height.map(|height| height - row.bed_height);
        let fits = |raised: Micrometres| {
            let grip = row.jaw_height - raised;
            grip <= most && grip >= least && given.is_none_or(|given| raised == given)
        };
        if below == Micrometres::ZERO && fits(Micrometres::ZERO) {
            return Ok(None);
        }
        let room = if below > Micrometres::ZERO { below + limits.room_below } else { Micrometres::ZERO };
        let standing = self.parallels.iter().filter(|one| one.height >= room && fits(one.height));
        let note = || {
            let note = match self.part.fixture.height {
                Some(height) => Note::new("vice-not-that-high").with("height", height).with("ways", row.bed_height),
                // The jaws would stand over the face, or grip nothing.
                None => Note::new("vice-no-grip")
                    .with("thickness", thickness)
                    .with("below_face", limits.below_face)
                    .with("parallels", room.max(self.parallels.iter().map(|one| one.height).min().unwrap_or_default())),
            };
            note.with("jaws", row.jaw_height).with("below", below).with("least", least).with("most", most)
        };
        let lowest = standing.min_by_key(|one| one.height).ok_or_else(note)?;
        match self.room_beside(jaws, lowest.length) {
            Some(beside) if beside >= lowest.thinnest => Ok(Some((lowest, beside))),
            beside => {
                let note = Note::new("vice-parallels-in-the-way").with("beside", beside.unwrap_or_default());
                Err(note.with("thinnest", lowest.thinnest))
            }
        }
    }

    /// The least distance from a jaw to the edge of a hole that comes out below; none where a hole lies beyond the end of the
    /// parallels.
    fn room_beside(&self, jaws: Along, parallels: Micrometres) -> Option<Micrometres> {
        let (blank, datum, middle) = (&self.part.blank, &self.part.datum, self.part.middle());
        let mut room = blank.length.max(blank.width);
        let through =
            self.part.holes.iter().zip(self.holes).filter(|(_, plan)| comes_out(self.part, plan) > Micrometres::ZERO);
        for (hole, _) in through {
            let widest =
                hole.steps.iter().map(|step| step.diameter.nominal).fold(hole.diameter.nominal, Micrometres::max);
            let ends = hole.ways().flat_map(|way| [(way.from, way.thinner), (way.to, way.thinner)]);
            for (at, thinner) in ends {
                let (from_jaw, to_end) = match jaws {
                    Along::X => (side(at.y - datum.front, blank.width), (at.x - middle.x).abs()),
                    Along::Y => (side(at.x - datum.left, blank.length), (at.y - middle.y).abs()),
                };
                if to_end > parallels.half() {
                    return None;
                }
                room = room.min(from_jaw + thinner - widest.half());
            }
        }
        Some(room)
    }

    /// An open slot that runs out over a jaw deeper than the jaws lie below the face.
    fn slot_over_jaw(&self, jaws: Along, below_face: Micrometres) -> Option<Note> {
        let (blank, datum) = (&self.part.blank, &self.part.datum);
        let over = |at: Point| match jaws {
            Along::X => at.y <= datum.front || at.y >= datum.front + blank.width,
            Along::Y => at.x <= datum.left || at.x >= datum.left + blank.length,
        };
        let slots = self.part.holes.iter().filter_map(|hole| Some((hole, hole.slot?)));
        let mut runs_out = slots.filter(|(hole, slot)| hole.at.iter().any(|at| slot.outside(*at).any(over)));
        let (hole, _) = runs_out.find(|(hole, _)| hole.depth >= below_face)?;
        let note = Note::new("vice-slot-over-jaw").with("slot", Figure::called(&hole.name));
        Some(note.with("depth", hole.depth).with("below", below_face))
    }

    /// The force of the jaws, N, and the load that needs the most of it, with the part `between` thick between them and gripped as
    /// deep as `grip`:
    ///
    /// - turning: the friction of both jaws is a couple on the arm between them: k·M ≤ f·Q·between;
    /// - sliding along the jaws: k·P ≤ 2·f·Q;
    /// - tipping over the jaws, which press at the edge of the grip at worst: k·P·a ≤ Q·grip/2, a from the middle of the grip up to
    ///   the face.
    ///
    /// Statics of a block between two flat jaws; the thrust is borne by what the part stands on.
    fn needed(&self, between: Micrometres, grip: Micrometres) -> Option<(Newtons, &Load<'_>)> {
        let (k, f) = (self.limits.safety, self.limits.friction);
        let [between, grip, thickness] =
            [between, grip, self.part.blank.thickness].map(|length| length.to_mm() / 1000.0);
        let arm = thickness - grip / 2.0;
        let force = |load: &Load<'_>| {
            let side = load.side.map_or(0.0, |side| side.0);
            let turning = k * load.torque.0 / (f * between);
            turning.max(k * side / (2.0 * f)).max(2.0 * k * side * arm / grip)
        };
        let forces = self.loads.iter().map(|load| (force(load), load));
        forces.max_by(|one, two| one.0.total_cmp(&two.0)).map(|(force, load)| (Newtons(force), load))
    }
}

/// The distance to the nearer of two sides.
fn side(from: Micrometres, size: Micrometres) -> Micrometres {
    from.min(size - from)
}
