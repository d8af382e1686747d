//! Divides a hole into its main cylinder and the openings at its ends.
//!
//! Every complex hole is a row of cylinders on one axis (textbook 1.1.1, figure 1.1). The narrowest is the main
//! cylinder: it is made in the metal of the blank. The wider ones are opened after it.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::part::{BlankHole, Bottom, Face, Hole, Part, Thread, ToleratedDiameter};
use crate::plan::{Feature, Operation};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::tables::rules::BlankState;
use crate::tables::tools::CutterRow;
use crate::units::{ItGrade, Micrometres, Roughness};
use crate::zone;
use technolog_note::note;

use super::StepLocation;

/// A hole as the planner sees it.
#[derive(Clone, Debug)]
pub struct Task {
    /// The narrowest cylinder.
    pub main: Bore,
    /// The wider cylinders, each opened from the one inside it: first those of the entry face, from the narrowest
    /// outwards, then those of the back face.
    pub wider: Vec<Bore>,
    /// Chamfers, countersinks and faces, with their places.
    pub edges: Vec<EdgeCut>,
    /// What no axial tool can make.
    pub impossible: Vec<Note>,
    /// Requirements of the drawing that are probably a mistake.
    pub doubtful: Vec<Note>,
}

/// A cylinder of a hole.
#[derive(Clone, Debug)]
pub struct Bore {
    /// Its place in the hole.
    pub place: StepLocation,
    /// Its diameter with tolerance; under a thread, that of the tapping hole.
    pub diameter: ToleratedDiameter,
    /// Roughness limit.
    pub roughness: Roughness,
    /// What is there before it is made.
    pub before: Before,
    /// Whether its floor or shoulder must be flat.
    pub flat: bool,
    /// Whether it is deeper than any core drill of its size reaches.
    pub beyond_core_drills: bool,
    /// Its thread.
    pub thread: Option<Thread>,
    /// The depth of the full thread below the face: a blind hole is drilled deeper than that.
    pub thread_depth: Micrometres,
}

/// What is there before a cylinder is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Before {
    /// The hole of the blank, if any.
    Blank(BlankHole),
    /// The narrower cylinder of the same hole.
    Own,
}

impl Before {
    /// Whether the blank has a cast or forged hole there.
    pub const fn is_cast(self) -> bool {
        matches!(self, Self::Blank(BlankHole::Cast(_)))
    }

    /// Whether the cylinder is begun in solid metal.
    pub fn is_solid(self) -> bool {
        self == Self::Blank(BlankHole::Solid)
    }

    /// The same state as tables name it.
    pub fn state(self) -> BlankState {
        if self.is_solid() { BlankState::Solid } else { BlankState::WithHole }
    }
}

/// A conical or flat cut at the edge of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeCut {
    /// Chamfer, countersink, cone or face.
    pub feature: Feature,
    /// The face it is at.
    pub face: Face,
    /// How far below the face its widest circle lies.
    pub start: Micrometres,
    /// The cylinder above the edge, through which the cutter enters; absent at the face.
    pub entry_cylinder: Option<Micrometres>,
    /// Whether the drawing requires it; the chamfer of a thread is added by the planner.
    pub required: bool,
    /// The diameter of the cylinder it is cut at, before finishing.
    pub cylinder_diameter: Micrometres,
    /// Its widest diameter.
    pub diameter: Micrometres,
    /// Its full angle, thousandths of a degree; 180° for a face.
    pub angle_millideg: u32,
}

impl EdgeCut {
    /// Depth of the cone: (D - d)/2 / tan(φ/2); the depth of a face is its stock.
    pub fn depth(&self, face_stock: Micrometres) -> Micrometres {
        if self.feature == Feature::Face {
            return face_stock;
        }
        let half = f64::from(self.angle_millideg) / 1000.0 / 2.0;
        Micrometres::from_mm_rounded(
            (self.diameter - self.cylinder_diameter).to_mm() / 2.0 / libm::tan(half.to_radians()),
        )
    }
}

/// A right angle: chamfers are 45° to the axis.
const RIGHT: u32 = 90_000;

/// Divides a hole into cylinders and edges; under a blind thread it goes deeper by the usual run-out.
///
/// # Errors
/// The knowledge lacks a convention.
pub fn task(hole: &Hole, part: &Part, shop: &Shop<'_>) -> Result<Task, KnowledgeError> {
    task_with_run_out(hole, part, HoleDefault::ThreadRunoutPitches, shop)
}

/// Whether no core drill of a hole's size reaches its end, on its own flutes or on an arbor that follows it in. How thin one of its
/// size may be is the convention `core-drill-least-share`.
fn beyond_core_drills(hole: &Hole, part: &Part, shop: &Shop<'_>) -> Result<bool, KnowledgeError> {
    let nominal = hole.diameter.nominal;
    let needed = hole.depth + zone::approach(part, hole.through, shop.knowledge)?.overrun;
    let thinnest = Micrometres::from_mm_rounded(nominal.to_mm() * shop.share(HoleDefault::CoreDrillLeastShare)?);
    let of_size = |own: Micrometres| own <= nominal && own >= thinnest;
    let reaches = |row: &CutterRow<'_>| row.bore.is_some() || row.flute_length.is_none_or(|flutes| flutes >= needed);
    let core_drills = shop.shelf.cutters_for(Operation::CoreDrill)?;
    Ok(!core_drills.into_iter().any(|row| row.diameter.is_some_and(of_size) && reaches(row)))
}

/// As [`task`], with the convention that says how many pitches the run-out of a blind thread has.
///
/// # Errors
/// As for [`task`].
pub fn task_with_run_out(
    hole: &Hole,
    part: &Part,
    run_out: HoleDefault,
    shop: &Shop<'_>,
) -> Result<Task, KnowledgeError> {
    let thickness = part.blank.thickness;
    // The first teeth of a tap cut no full thread: a blind hole is drilled deeper by their length.
    let runout = match hole.thread.as_ref().filter(|_| !hole.through) {
        Some(thread) => Micrometres::from_mm_rounded(thread.pitch.to_mm() * shop.share(run_out)?),
        None => Micrometres::ZERO,
    };
    let main = Bore {
        place: StepLocation {
            feature: Feature::Bore,
            step: None,
            face: Face::Entry,
            start: Micrometres::ZERO,
            depth: hole.depth + runout,
            through: hole.through,
        },
        diameter: hole.diameter.clone(),
        roughness: hole.roughness,
        before: Before::Blank(hole.state),
        flat: !hole.through && hole.bottom == Bottom::Flat && hole.thread.is_none(),
        beyond_core_drills: beyond_core_drills(hole, part, shop)?,
        thread: hole.thread.clone(),
        thread_depth: hole.depth,
    };
    let mut wider = Vec::new();
    let mut edges = Vec::new();
    let mut impossible = Vec::new();
    if hole.thread.is_some() && !hole.through && hole.bottom == Bottom::Flat {
        impossible.push(Note::new("flat-under-thread").with("depth", hole.depth).with("drilled", main.place.depth));
    }
    for face in [Face::Entry, Face::Back] {
        let mut own: Vec<(usize, &crate::part::HoleStep)> =
            hole.steps.iter().enumerate().filter(|(_, step)| step.face == face).collect();
        own.sort_by_key(|(_, step)| step.diameter.nominal);
        for (position, (index, step)) in own.iter().copied().enumerate() {
            // The edge lies at the floor of the cylinder around it, or at the face.
            let edge_at = own.get(position + 1).map(|(_, around)| (around.depth, around.diameter.nominal));
            wider.push(Bore {
                place: StepLocation {
                    feature: Feature::Step,
                    step: Some(index + 1),
                    face,
                    start: Micrometres::ZERO,
                    depth: step.depth,
                    through: false,
                },
                diameter: step.diameter.clone(),
                roughness: step.roughness,
                before: Before::Own,
                // A tapped hole ends in the cone of its drill.
                flat: step.bottom == Bottom::Flat && step.thread.is_none(),
                beyond_core_drills: false,
                thread: step.thread.clone(),
                thread_depth: step.depth,
            });
            let chamfer = step.chamfer.or(thread_chamfer(step.thread.as_ref(), shop)?);
            if let Some(chamfer) = chamfer {
                let edge = chamfer_edge(face, edge_at, step.diameter.nominal, chamfer);
                edges.push(EdgeCut { required: step.chamfer.is_some(), ..edge });
            }
        }
    }
    if let Some(counterbore) = hole.counterbore {
        // A counterbore has no tolerance of its own: a free size (textbook 1.1.1).
        let diameter = ToleratedDiameter::free(counterbore.diameter, shop.knowledge)
            .map_err(|why| KnowledgeError::missing("it-grades", why))?;
        wider.push(Bore {
            place: StepLocation {
                feature: Feature::Counterbore,
                step: None,
                face: Face::Entry,
                start: Micrometres::ZERO,
                depth: counterbore.depth,
                through: false,
            },
            diameter,
            roughness: shop.roughness(HoleDefault::CounterboreRa)?,
            before: Before::Own,
            flat: true,
            beyond_core_drills: false,
            thread: None,
            thread_depth: counterbore.depth,
        });
    }
    // The widest cylinder at the entry edge.
    let outermost = wider
        .iter()
        .filter(|bore| bore.place.face == Face::Entry)
        .map(|bore| bore.diameter.nominal)
        .max()
        .unwrap_or(hole.diameter.nominal);
    if let Some(sink) = hole.countersink {
        edges.push(EdgeCut {
            feature: Feature::Countersink,
            face: Face::Entry,
            start: Micrometres::ZERO,
            entry_cylinder: None,
            required: true,
            cylinder_diameter: outermost,
            diameter: sink.diameter,
            angle_millideg: sink.angle_millideg,
        });
    }
    if let Some(cone) = hole.cone {
        edges.push(EdgeCut {
            feature: Feature::Cone,
            face: Face::Entry,
            start: Micrometres::ZERO,
            entry_cylinder: None,
            required: true,
            cylinder_diameter: hole.diameter.nominal,
            diameter: cone.diameter,
            angle_millideg: cone.angle_millideg,
        });
    }
    // The edge of the main cylinder lies at the floor of the narrowest cylinder around it, or at the face.
    let above = wider
        .iter()
        .filter(|bore| bore.place.face == Face::Entry)
        .min_by_key(|bore| bore.diameter.nominal)
        .map(|bore| (bore.place.depth, bore.diameter.nominal));
    let main_edge = |chamfer: Micrometres| chamfer_edge(Face::Entry, above, hole.diameter.nominal, chamfer);
    match (hole.chamfer, hole.countersink) {
        // With a counterbore, the chamfer of a hole without steps is at the entry.
        (Some(chamfer), None) if hole.counterbore.is_some() && hole.steps.is_empty() => {
            edges.push(chamfer_edge(Face::Entry, None, outermost, chamfer));
        }
        (Some(chamfer), None) => edges.push(main_edge(chamfer)),
        (Some(chamfer), Some(_)) => impossible.push(Note::new("chamfer-in-countersink").with("chamfer", chamfer)),
        (None, _) => {}
    }
    let own_chamfer = hole.chamfer.is_some() && (hole.counterbore.is_none() || !hole.steps.is_empty());
    if let (Some(chamfer), false) = (thread_chamfer(hole.thread.as_ref(), shop)?, own_chamfer)
        && (hole.countersink.is_none() || above.is_some())
    {
        edges.push(EdgeCut { required: false, ..main_edge(chamfer) });
    }
    if let Some(face) = hole.face {
        edges.push(EdgeCut {
            feature: Feature::Face,
            face: Face::Entry,
            start: Micrometres::ZERO,
            entry_cylinder: None,
            required: true,
            cylinder_diameter: outermost,
            diameter: face,
            angle_millideg: 2 * RIGHT,
        });
    }
    if let Some(groove) = hole.groove {
        impossible.push(
            Note::new("groove-not-axial")
                .with("diameter", groove.diameter)
                .with("width", groove.width)
                .with("depth", groove.depth),
        );
    }
    // A cylinder entered from the back begins where the blank ends.
    for bore in wider.iter().filter(|bore| bore.place.face == Face::Back && bore.place.depth >= thickness) {
        impossible.push(Note::new("step-too-deep").with("depth", bore.place.depth).with("limit", thickness));
    }
    // A lead-in narrower than its thread has no effect.
    let lead_in = |thread: &Thread, edge: &&EdgeCut| edge.feature == Feature::Chamfer && edge.diameter < thread.size;
    let around_main = |edge: &&EdgeCut| edge.required && edge.cylinder_diameter == hole.diameter.nominal;
    let doubtful = hole.thread.iter().flat_map(|thread| {
        let narrow = edges.iter().filter(around_main).find(|edge| lead_in(thread, edge));
        narrow.map(|edge| {
            Note::new("chamfer-inside-thread").with("diameter", edge.diameter).with("thread", &thread.written)
        })
    });
    let doubtful = doubtful.collect();
    Ok(Task { main, wider, edges, impossible, doubtful })
}

/// `at` is how deep the edge lies, and the diameter of the cylinder above it, through which the cutter enters.
fn chamfer_edge(
    face: Face,
    at: Option<(Micrometres, Micrometres)>,
    around: Micrometres,
    chamfer: Micrometres,
) -> EdgeCut {
    EdgeCut {
        feature: Feature::Chamfer,
        face,
        start: at.map_or(Micrometres::ZERO, |(depth, _)| depth),
        entry_cylinder: at.map(|(_, diameter)| diameter),
        required: true,
        cylinder_diameter: around,
        diameter: around + chamfer + chamfer,
        angle_millideg: RIGHT,
    }
}

/// A thread begins with a chamfer as deep as its pitch, where the drawing gives none.
fn thread_chamfer(thread: Option<&Thread>, shop: &Shop<'_>) -> Result<Option<Micrometres>, KnowledgeError> {
    let Some(thread) = thread else { return Ok(None) };
    let pitches = shop.share(HoleDefault::ThreadChamferPitches)?;
    // Wider than the thread, so that the first teeth of the tap begin outside it: the hole is narrower by a pitch.
    Ok(Some(Micrometres::from_mm_rounded(thread.pitch.to_mm() * pitches).max(thread.pitch.half())))
}

impl Bore {
    /// Whether it has a flat floor of its own, made in solid metal; a flat shoulder has a hole in its middle.
    pub fn has_floor(&self) -> bool {
        self.flat && !self.place.through && self.before.is_solid()
    }

    /// The grade and roughness required of its own surface: under a thread what drilling leaves, as A.10 drills it.
    ///
    /// # Errors
    /// A.1 lacks its first row.
    pub fn required_finish(&self, shop: &Shop<'_>) -> Result<(ItGrade, Roughness), KnowledgeError> {
        if self.thread.is_none() {
            return Ok((self.diameter.it, self.roughness));
        }
        let drilled = super::accuracy::drilling(shop)?;
        let grade = drilled
            .it_coarsest
            .ok_or_else(|| KnowledgeError::missing(&drilled.row.table.id, note!("order-grade-drilling")))?;
        Ok((grade, Roughness::from_ra(drilled.ra_coarsest)))
    }

    /// Why a chamfer is there although the drawing has none.
    pub fn chamfer_reason(&self, shop: &Shop<'_>) -> Option<Because> {
        let thread = self.thread.as_ref()?;
        let row = shop.default_row(HoleDefault::ThreadChamferPitches).ok()?;
        Some(Because::row(row.row, Note::new("thread-chamfer").with("pitch", thread.pitch)))
    }
}
