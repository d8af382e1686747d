//! The jobs of a set-up in order, each with its tool, toolpath, speed and feeds. Programs, times, settings, drawings
//! and the proof use only the jobs of an operation.
//!
//! A toolpath is that of the tool's **reference point**, whose position the offsets of the control give:
//!
//! | tool | reference point |
//! |---|---|
//! | turning, boring | its theoretical point: where the tangents to the nose across and along the axis meet |
//! | neutral turning tool | the lowest point of the nose: [`Tip::axial`] is 0 |
//! | grooving | the corner of the blade towards the chuck, as a theoretical point |
//! | face grooving | the corner of the blade towards the axis, as a theoretical point |
//! | threading | the sharp point of the profile |
//! | centre drill, drill | its point on the axis |
//! | core drill, reamer, countersink, tap | the middle of its front |

pub mod along;
mod clock;
pub mod groove;
pub mod hole;
pub mod limits;
pub mod pace;
pub mod part_off;
mod refused;
mod site;
#[cfg(test)]
mod tests;
pub mod thread;

use serde::Serialize;

pub use clock::time;
pub use refused::NoJob;
pub use site::Site;

use crate::note::{Because, Note};
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::cutting::{BladeForce, TurningConditions};
use crate::turning::length::Half;
use crate::turning::point::Vector;
use crate::turning::tooling::{Hand, Place, Shank, ToolKind, TurningTool};
use crate::turning::toolpath::Toolpath;
use crate::units::{Decimal, Degrees, Micrometres, MillimetresPerMinute, Minutes, NewtonMetres};
pub use pace::Pace;

technolog_knowledge::vocabulary! {
    /// The work of a job.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Work {
        /// The free end is faced.
        Face = "face",
        /// A centre hole, or the spot for a drill.
        Centre = "centre",
        /// A hole on the axis.
        Drill = "drill",
        /// The bottom of a hole is made flat.
        Flatten = "flatten",
        /// The chamfer at the mouth of a hole.
        Countersink = "countersink",
        /// A drilled hole is made wider and truer before it is reamed.
        CoreDrill = "core-drill",
        /// Stock is removed down to the rough contour.
        Rough = "rough",
        /// The finished contour.
        Finish = "finish",
        /// A hole on the axis is reamed to size.
        Ream = "ream",
        /// A groove or a relief, with its sides.
        Groove = "groove",
        /// A thread, pass by pass.
        Thread = "thread",
        /// A thread on the axis, with a tap.
        Tap = "tap",
        /// The part is cut off.
        PartOff = "part-off",
    }
}

/// The thread of a job, as the arguments of a control's threading cycle.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThreadCut {
    /// Pitch P, mm.
    pub pitch_mm: Micrometres,
    /// Z of the beginning, before the thread.
    pub from_z_mm: Half,
    /// Z of the end, in the relief or where the tool pulls out.
    pub to_z_mm: Half,
    /// Z where the thread itself begins.
    pub begins_z_mm: Half,
    /// Z where it ends.
    pub ends_z_mm: Half,
    /// Whether the tool is withdrawn over the run-out, because there is no relief behind the thread.
    pub pulled_out: bool,
    /// The radius at which the tool returns between passes.
    pub return_radius_mm: Half,
    /// The radius of the crests, before the first pass.
    pub crest_radius_mm: Half,
    /// The radius of the roots, of the last pass.
    pub root_radius_mm: Half,
    /// Depth of each pass from the crests, radial, ascending; the last is the whole depth; spring passes repeat it.
    pub depths_mm: Vec<Half>,
    /// The same by equal areas, for a cycle of a control, which has no law nearer to the makers'.
    pub cycle_depths_mm: Vec<Half>,
    /// The angle of infeed from the perpendicular to the axis, degrees; 0 is straight in.
    pub infeed_angle_deg: Degrees,
}

/// A job of one tool.
#[derive(Clone, Debug, Serialize)]
pub struct Job {
    /// Its kind of work.
    pub work: Work,
    /// Outside or inside.
    pub side: Side,
    /// Its tool.
    pub tool: JobTool,
    /// The surfaces that it makes or prepares.
    pub surfaces: Vec<SurfaceName>,
    /// The toolpath of the reference point, in the coordinates of the set-up. It begins and ends clear of the metal.
    pub path: Toolpath,
    /// Its speed and feeds.
    #[serde(skip)]
    pub pace: Pace,
    /// Feed, speed, spindle step and loads, if a lathe is named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub conditions: Option<TurningConditions>,
    /// The time of the toolpath with these feeds and speeds, without the first approach to the part.
    pub time_min: Minutes,
    /// The thread that it cuts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thread: Option<ThreadCut>,
    /// The torque of a tap, which has no other conditions; none where it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque_n_m: Option<NewtonMetres>,
    /// What the blade of a groove or of parting presses with, which has no other conditions; none where it is not known.
    #[serde(skip)]
    pub blade: Option<BladeForce>,
    /// Whether it is cut dry.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub dry: bool,
    /// For roughing: the index of its zone and of the work in it.
    #[serde(skip)]
    pub zone: Option<(usize, usize)>,
    /// Notes: its division, its limits.
    pub notes: Vec<Note>,
    /// Its rows.
    pub because: Vec<Because>,
}

impl Job {
    /// A job of a toolpath, with nothing said of it. `rapid` is the rate of its rapids.
    pub(super) fn of(
        work: Work,
        side: Side,
        tool: JobTool,
        path: Toolpath,
        pace: Pace,
        rapid: MillimetresPerMinute,
    ) -> Self {
        Self {
            work,
            side,
            tool,
            surfaces: Vec::new(),
            time_min: pace.time(&path, rapid),
            path,
            pace,
            conditions: None,
            thread: None,
            torque_n_m: None,
            blade: None,
            dry: false,
            zone: None,
            notes: Vec::new(),
            because: Vec::new(),
        }
    }

    /// The diameter that a centre drill opens on a face at `face`: its cone of 60° (ГОСТ 14034) behind the pilot. None for another
    /// tool, and where only the pilot enters.
    pub fn spot_diameter(&self, face: Half) -> Option<Micrometres> {
        let Body::CentreDrill { pilot_mm, pilot_length_mm, body_mm } = self.tool.body else { return None };
        let deepest = self.path.moves.iter().map(|one| one.to.z).max()?;
        let cone = (deepest - face).to_mm() - pilot_length_mm.to_mm();
        let opened = pilot_mm + Micrometres::from_mm_rounded(2.0 * cone * libm::tan(30.0_f64.to_radians()));
        (cone > 0.0).then(|| opened.min(body_mm))
    }
}

/// A tool for programs, settings and proofs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JobTool {
    /// Its designation in the catalog.
    pub designation: String,
    /// Its body.
    #[serde(flatten)]
    pub body: Body,
}

/// The shape of a tool.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "shape", rename_all = "kebab-case")]
pub enum Body {
    /// An insert in a holder or a bar.
    Insert {
        /// Its purpose.
        kind: ToolKind,
        /// The place where it works.
        works: Place,
        /// Its hand.
        hand: Hand,
        /// φ, degrees.
        lead_angle_deg: Degrees,
        /// φ1, degrees.
        trail_angle_deg: Degrees,
        /// r, mm; 0 for a sharp point.
        nose_radius_mm: Micrometres,
        /// Length of the edge, mm.
        edge_mm: Option<Micrometres>,
        /// Width of a blade, mm.
        width_mm: Option<Micrometres>,
        /// The depth of cut that a blade permits, mm.
        blade_depth_mm: Option<Micrometres>,
        /// Square shank: height and width, mm.
        shank_mm: Option<(Micrometres, Micrometres)>,
        /// Diameter of a round bar, mm.
        bar_mm: Option<Micrometres>,
        /// From the tip of a threading insert to its side towards the chuck, mm.
        #[serde(skip)]
        side_mm: Option<Micrometres>,
        /// The smallest bore that a bar enters, mm.
        min_bore_mm: Option<Micrometres>,
    },
    /// A drill on the axis.
    Drill {
        /// Its diameter, mm.
        diameter_mm: Micrometres,
        /// The full angle of its point, degrees.
        point_angle_deg: Degrees,
        /// The usable length of its flutes, mm.
        flute_mm: Option<Micrometres>,
    },
    /// A core drill, a reamer or a countersink.
    Reamer {
        /// Its diameter, mm.
        diameter_mm: Micrometres,
        /// The diameter of its front, where its lead begins, mm.
        front_mm: Micrometres,
        /// The length of its lead, mm.
        lead_mm: Micrometres,
        /// How deep it enters, mm.
        reach_mm: Micrometres,
    },
    /// A machine tap.
    Tap {
        /// The nominal diameter of its thread, mm.
        diameter_mm: Micrometres,
        /// Its pitch, mm.
        pitch_mm: Micrometres,
        /// The diameter of its front and its core, mm: at most the least minor diameter of the thread.
        core_mm: Micrometres,
        /// The length of its lead, mm.
        lead_mm: Micrometres,
        /// The length of its thread, with the lead, mm.
        thread_mm: Micrometres,
        /// Where its shank begins, mm.
        neck_mm: Micrometres,
        /// The diameter of its shank, mm.
        shank_mm: Micrometres,
        /// From its front to its chuck, mm.
        free_mm: Micrometres,
    },
    /// A centre drill of ГОСТ 14034.
    CentreDrill {
        /// Its pilot diameter d, mm.
        pilot_mm: Micrometres,
        /// The length of the pilot, mm.
        pilot_length_mm: Micrometres,
        /// The diameter of its body, mm.
        body_mm: Micrometres,
    },
}

/// The direction from the centre of the nose to the reference point, in nose radii.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tip {
    /// −1 towards the axis, +1 outwards, 0 at the height of the centre.
    pub radial: i8,
    /// +1 towards the chuck, −1 towards the free end.
    pub axial: i8,
}

impl Tip {
    /// The displacement for a nose radius.
    pub fn of(self, nose: Half) -> Vector {
        let nose = nose.to_mm();
        Vector::new(f64::from(self.axial) * nose, f64::from(self.radial) * nose)
    }
}

/// The edge length of an insert whose row has none: shorter than those of the catalog.
pub const UNKNOWN_EDGE: Micrometres = Micrometres::from_mm(10);

impl JobTool {
    /// A turning tool of the catalog.
    pub fn of(tool: &TurningTool<'_>) -> Self {
        let (shank_mm, bar_mm) = match tool.shank {
            Some(Shank::Square { height, width }) => (Some((height, width)), None),
            Some(Shank::Round { diameter }) => (None, Some(diameter)),
            None => (None, None),
        };
        let degrees = |angle: Decimal| Degrees(angle.to_f64());
        Self {
            designation: tool.designation.to_owned(),
            body: Body::Insert {
                kind: tool.kind,
                works: tool.works,
                hand: tool.hand,
                lead_angle_deg: degrees(tool.lead_angle),
                trail_angle_deg: degrees(tool.trail_angle),
                nose_radius_mm: tool.nose_radius.unwrap_or(Micrometres::ZERO),
                edge_mm: tool.edge,
                width_mm: tool.width,
                blade_depth_mm: tool.groove_depth,
                side_mm: tool.insert_side,
                shank_mm,
                bar_mm,
                min_bore_mm: tool.min_bore,
            },
        }
    }

    /// The direction from the centre of its nose to its reference point; none for a tool without a nose.
    pub fn tip(&self) -> Option<Tip> {
        let Body::Insert { kind, works, hand, .. } = self.body else { return None };
        Some(tip(kind, works, hand))
    }

    /// The diameter of a drill, a countersink, a core drill, a reamer or a tap; none for a tool that turns or centres.
    pub const fn diameter(&self) -> Option<Micrometres> {
        match self.body {
            Body::Drill { diameter_mm, .. } | Body::Reamer { diameter_mm, .. } | Body::Tap { diameter_mm, .. } => {
                Some(diameter_mm)
            }
            Body::Insert { .. } | Body::CentreDrill { .. } => None,
        }
    }

    /// Its nose radius, mm; 0 for a drill.
    pub const fn nose_radius(&self) -> Micrometres {
        match self.body {
            Body::Insert { nose_radius_mm, .. } => nose_radius_mm,
            Body::Drill { .. } | Body::Reamer { .. } | Body::Tap { .. } | Body::CentreDrill { .. } => Micrometres::ZERO,
        }
    }
}

/// The reference point of a kind of tool.
pub const fn tip(kind: ToolKind, works: Place, hand: Hand) -> Tip {
    let radial = if matches!(works, Place::Inner) { 1 } else { -1 };
    let axial = match (kind, hand) {
        (ToolKind::Threading, _) => 0,
        (ToolKind::Grooving | ToolKind::FaceGrooving, _) | (_, Hand::R) => 1,
        (_, Hand::L) => -1,
        (_, Hand::N) => 0,
    };
    Tip { radial, axial }
}
