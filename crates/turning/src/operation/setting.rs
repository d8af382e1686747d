//! The operator's setting before the programs of an operation run: the position of the part in each set-up, the place
//! of each tool, the tip number of the control, and the points where offsets are measured.
//!
//! The programs move the reference point of a tool ([`crate::turning::jobs`]), with the nose already compensated: the
//! offsets of the control give this point, and no radius correction is used.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::contract::Word;
use crate::note::{Figure, IntoFigure, Note};
use crate::tables::controls::lathe::{LatheControl, LatheControls, LatheTipPlaces};
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::jobs::{Body, Job, JobTool, Tip, Work};
use crate::turning::length::Half;
use crate::turning::program::Control;
use crate::turning::tooling::{Hand, Place, ToolKind, TurningTool};
use crate::turning::workpiece::{ThreadLimits, Workpiece};
use crate::turning::zones::Hold;
use crate::units::{Degrees, Micrometres};

use super::ground::{Ground, ground};
use super::turret::{Load, Station, loads, station, stations};
use super::{Grip, Jaws, Operation, SetUpWork, Sized, Sizes, Tailstock};

/// The setting of an operation for a control.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Setting {
    /// The part.
    pub part: String,
    /// The control.
    pub control: String,
    /// The position of the part in each set-up that has a program.
    pub set_ups: Vec<Stand>,
    /// The tools by their places in the turret.
    pub tools: Vec<SetTool>,
    /// The sizes with limits that are turned, with what the operator measures.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub sizes: Vec<SetSize>,
    /// What is turned with an allowance for a later operation.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ground: Vec<Ground>,
    /// The threads that are cut, with what the operator measures.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<SetThread>,
}

/// What is measured of a size.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SetSize {
    /// The set-up that finishes it.
    pub set_up: u8,
    /// The size.
    #[serde(flatten)]
    pub sized: Sized,
}

/// What is measured of a thread.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SetThread {
    /// The set-up that cuts it.
    pub set_up: u8,
    /// Its surface.
    pub surface: SurfaceName,
    /// As the drawing writes it.
    pub thread: String,
    /// Outside or inside.
    pub side: Side,
    /// The limits of its pitch diameter, mm, between which the flanks end in the middle; none where the tables have none of its
    /// class.
    pub pitch_diameter: Option<ThreadLimits>,
    /// The limits of its crests, outside, mm.
    pub crests: Option<ThreadLimits>,
    /// The best wire: it touches the flanks at the pitch diameter, P/√3, mm; outside only.
    pub wire_mm: Option<Micrometres>,
    /// The limits over three of those wires, mm.
    pub over_wires: Option<ThreadLimits>,
    /// Which cycle of the control cuts it, if cycles are requested; or why single passes do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<Note>,
}

/// The limits of a pitch diameter over three wires: M = d2 + 3·dw − √3/2·P, for a profile of 60°. The lead of the thread, which adds
/// less than a micrometre to common threads, is left out.
fn over_wires(limits: &ThreadLimits, wire: Micrometres, pitch: Micrometres) -> ThreadLimits {
    let more = Micrometres::from_mm_rounded(3.0 * wire.to_mm() - TRIANGLE * pitch.to_mm());
    ThreadLimits { least: limits.least + more, most: limits.most + more, ..limits.clone() }
}

/// The height of the triangle of the profile over the pitch, H/P = √3/2 (ISO 68-1).
const TRIANGLE: f64 = 0.866_025_403_784;

/// The position of a part in a set-up. Z 0 is the finished face of its free end.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stand {
    /// The number of the set-up.
    pub set_up: u8,
    /// How it is held.
    pub held: Note,
    /// The length of the stock before Z 0, mm.
    pub face_stock_mm: Half,
    /// Where the jaws or the centre stand, how hard the jaws hold, and how Z 0 is found.
    pub notes: Vec<Note>,
}

/// A tool with its setting.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SetTool {
    /// Its place in the turret, and its shape.
    #[serde(flatten)]
    pub station: Station,
    /// The number of its offset, where several tools share places.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub offset: Option<u32>,
    /// Its insert by ISO 1832, if the catalog has it.
    pub insert: Option<String>,
    /// The set-ups that use it.
    pub set_ups: Vec<u8>,
    /// Its work in them.
    pub works: Vec<Work>,
    /// The tip number of the control, 1 to 9; none if the numbers of the control are not known.
    pub orientation: Option<u8>,
    /// How its offset along X is measured.
    pub x: Note,
    /// How its offset along Z is measured.
    pub z: Note,
}

/// The setting of an operation.
///
/// # Errors
/// There is no such control, or the knowledge base lacks a table.
pub fn setting(operation: &Operation, control: &str, knowledge: &Knowledge) -> Result<Setting, KnowledgeError> {
    let stations = stations(operation);
    let loads = loads(operation, &stations);
    let table = knowledge.table_of::<LatheControls<'_>>()?;
    let known = LatheControl::from_word(control).ok_or_else(|| KnowledgeError::no_row(table, control))?;
    let numbering = knowledge.need(control, |row: &LatheControls<'_>| row.control == known)?.tip_numbering;
    let language = Control::read(control, knowledge)?;
    let part = &operation.workpiece;
    let worked = operation.set_ups.iter().filter(|set_up| !set_up.jobs.is_empty());
    let set_ups = worked.map(|work| {
        let end = operation.set_ups.iter().find_map(|one| one.parted_mm).unwrap_or(part.blank.end());
        let far = end - part.length();
        Stand {
            set_up: work.set_up.number,
            held: work.set_up.because.note.clone(),
            face_stock_mm: if work.set_up.turned_over { far } else { part.blank.face() },
            notes: stand_notes(work, part.length(), &loads, &language),
        }
    });
    let tools = stations.iter().map(|station| {
        let is_of = |job: &Job| self::station(&stations, job).is_some_and(|one| one.seat == station.seat);
        let uses = |set_up: &&SetUpWork| set_up.jobs.iter().any(is_of);
        let mut works = Vec::new();
        for job in operation.set_ups.iter().flat_map(|set_up| &set_up.jobs) {
            if is_of(job) && !works.contains(&job.work) {
                works.push(job.work);
            }
        }
        let tip = station.tool.tip().unwrap_or(ON_AXIS);
        let orientation = match numbering {
            Some(numbering) => {
                let is_it = |row: &LatheTipPlaces| {
                    (row.numbering, row.radial, row.axial) == (numbering, i64::from(tip.radial), i64::from(tip.axial))
                };
                u8::try_from(knowledge.need(&format!("{tip:?}"), is_it)?.number).ok()
            }
            None => None,
        };
        let insert = TurningTool::find(knowledge, &station.tool.designation)?.and_then(|tool| tool.insert);
        Ok(SetTool {
            insert: insert.map(str::to_owned),
            set_ups: operation.set_ups.iter().filter(uses).map(|set_up| set_up.set_up.number).collect(),
            works,
            orientation,
            x: Note::new(along_x(&station.tool)),
            z: Note::new(along_z(&station.tool)),
            offset: (!loads.is_empty()).then(|| language.offset(station.seat)),
            station: station.clone(),
        })
    });
    Ok(Setting {
        part: part.name.clone(),
        control: control.to_owned(),
        set_ups: set_ups.collect(),
        tools: tools.collect::<Result<_, KnowledgeError>>()?,
        sizes: operation.set_ups.iter().flat_map(|set_up| sizes(set_up, &operation.sizes)).collect(),
        ground: ground(operation),
        threads: operation.set_ups.iter().flat_map(|set_up| threads(set_up, part, &language)).collect(),
    })
}

/// The sizes with limits that a set-up finishes.
fn sizes<'a>(set_up: &'a SetUpWork, all: &'a Sizes) -> impl Iterator<Item = SetSize> + 'a {
    let made = |sized: &&Sized| {
        let mut jobs = set_up.jobs.iter().filter(|job| matches!(job.work, Work::Finish | Work::Groove | Work::Face));
        jobs.any(|job| job.surfaces.contains(&sized.surface))
    };
    let number = set_up.set_up.number;
    all.surfaces.iter().filter(made).map(move |sized| SetSize { set_up: number, sized: sized.clone() })
}

/// The threads that a set-up cuts.
fn threads<'a>(
    set_up: &'a SetUpWork,
    part: &'a Workpiece,
    control: &'a Control,
) -> impl Iterator<Item = SetThread> + 'a {
    let jobs = set_up.jobs.iter().filter(|job| matches!(job.work, Work::Thread | Work::Tap));
    let cut = jobs.flat_map(|job| job.surfaces.iter().map(move |surface| (job, surface)));
    cut.filter_map(|(job, surface)| {
        let side = job.side;
        let thread = part.thread_on(surface)?;
        let best = || Micrometres::from_mm_rounded(thread.pitch.to_mm() * 2.0 / 3.0 * TRIANGLE);
        let wire_mm = (side == Side::Outer).then(best);
        Some(SetThread {
            set_up: set_up.set_up.number,
            surface: surface.clone(),
            thread: thread.written.clone(),
            side,
            pitch_diameter: thread.flanks.clone(),
            crests: thread.crests.clone(),
            wire_mm,
            over_wires: wire_mm
                .zip(thread.flanks.as_ref())
                .map(|(wire, limits)| over_wires(limits, wire, thread.pitch)),
            cycle: job.thread.as_ref().map(|cut| match control.thread_cycle(cut, side) {
                Ok(cycle) => Note::new("thread-cycled").with("cycle", cycle),
                Err(why) => Note::new("thread-not-cycled").with("why", why.note()),
            }),
        })
    })
}

/// What the operator sets of a set-up beside its tools.
fn stand_notes(work: &SetUpWork, length: Half, loads: &[Load<'_>], control: &Control) -> Vec<Note> {
    let mut notes: Vec<Note> = work.jaws.iter().map(Jaws::note).collect();
    notes.extend(work.jaws.iter().filter_map(Jaws::bored));
    notes.extend(work.grip.iter().map(Grip::note));
    notes.extend(work.tailstock.iter().map(Tailstock::note));
    if work.set_up.holds_at == Some(Hold::Centres) {
        notes.push(Note::new("set-driver"));
    }
    if work.set_up.turned_over {
        notes.push(Note::new("set-zero-again").with("length", length));
    }
    for load in loads.iter().filter(|load| load.set_up == work.set_up.number) {
        let tools = Figure::list(load.tools.iter().map(|put| put.note(control.offset(put.station.seat)).into_figure()));
        let stops = load.tools.first().map(|put| &put.station.tool).filter(|_| load.before > 0);
        notes.push(match stops {
            Some(first) => Note::new("turret-stop").with("before", &*first.designation).with("tools", tools),
            None => Note::new("turret-begins").with("tools", tools),
        });
    }
    for regrip in work.grip.iter().flat_map(|grip| grip.regrips(&work.jobs)) {
        let tool = work.jobs.get(regrip.before).map(|job| &*job.tool.designation);
        notes.extend(tool.map(|tool| Note::new("jaws-stop").with("before", tool).with("what", regrip.note())));
    }
    notes
}

/// The tip of a drill points along the axis to the chuck.
const ON_AXIS: Tip = Tip { radial: 0, axial: 1 };

/// How X of the reference point is measured.
const fn along_x(tool: &JobTool) -> &'static str {
    match tool.body {
        Body::Insert { works: Place::Inner, .. } => "set-x-bore",
        Body::Insert { .. } => "set-x-diameter",
        Body::Drill { .. } | Body::Reamer { .. } | Body::Tap { .. } | Body::CentreDrill { .. } => "set-x-axis",
    }
}

/// The point angle of a drill that is reground for a flat bottom: it has no point.
const FLAT: Degrees = Degrees(180.0);

/// How Z of the reference point is measured. A face touches the theoretical point if the edge does not lean over it,
/// that is from φ = 90° on.
fn along_z(tool: &JobTool) -> &'static str {
    match tool.body {
        Body::Drill { point_angle_deg, .. } if point_angle_deg >= FLAT => "set-z-front",
        Body::Drill { .. } | Body::CentreDrill { .. } => "set-z-point",
        Body::Reamer { .. } | Body::Tap { .. } => "set-z-front",
        Body::Insert { kind: ToolKind::Threading, .. } => "set-z-thread",
        Body::Insert { kind: ToolKind::Grooving, .. } => "set-z-blade",
        Body::Insert { kind: ToolKind::FaceGrooving, .. } => "set-z-face",
        Body::Insert { hand: Hand::N, .. } => "set-z-nose",
        Body::Insert { lead_angle_deg, .. } if lead_angle_deg < Degrees(90.0) => "set-z-presetter",
        Body::Insert { hand: Hand::L, .. } => "set-z-shoulder",
        Body::Insert { .. } => "set-z-face",
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests look at what notes are told")]
mod tests {
    use super::*;
    use crate::shipped;
    use crate::tables::controls::lathe::TipNumbering;
    use crate::turning::operation::plan;
    use crate::turning::workpiece::read_turned;

    const PART: &str = "shaft: P\nmaterial: steel-45\nblank: {kind: bar, diameter: 50, length: 80, face: 1}\n\
                        machine: 16k20f3\nouter:\n  - {from: {d: 0, z: 0}}\n  - {face: 30}\n  - {cylinder: -40}\n  - \
                        {face: 46}\n  - {cylinder: -50}\n";

    fn of(control: &str) -> Setting {
        let knowledge = shipped::knowledge().unwrap();
        let workpiece = read_turned("part", PART, &knowledge).unwrap();
        setting(&plan(&workpiece, &knowledge).unwrap(), control, &knowledge).unwrap()
    }

    /// A right-hand tool outside: 2 for LinuxCNC (glcanon.py: the nose lies at +X +Z of its point), 3 for Fanuc.
    #[test]
    fn controls_count_the_same_tip_differently() {
        let numbers = |control| of(control).tools.iter().map(|tool| tool.orientation).collect::<Vec<_>>();
        assert!(numbers("linuxcnc").iter().all(|number| *number == Some(2)));
        assert!(numbers("fanuc").iter().all(|number| *number == Some(3)));
        assert!(numbers("sinumerik").iter().all(|number| *number == Some(3)));
        assert!(numbers("nc-201").iter().all(Option::is_none));
    }

    /// 1 mm before the free end; turned over, 80 long with 1 before it and a part of 50: 80 - 1 - 50 = 29.
    #[test]
    fn the_stock_before_each_face_is_that_of_the_blank() {
        let setting = of("linuxcnc");
        let stock: Vec<f64> = setting.set_ups.iter().map(|stand| stand.face_stock_mm.to_mm()).collect();
        assert_eq!(stock, [1.0, 29.0]);
        // Soft jaws and a new zero after turning over, and only then.
        let codes = |stand: &Stand| stand.notes.iter().map(|note| note.code().to_owned()).collect::<Vec<_>>();
        assert_eq!(codes(&setting.set_ups[0]), ["jaws-close", "grip-required"]);
        assert_eq!(codes(&setting.set_ups[1]), ["jaws-close", "jaws-bored", "grip-required", "set-zero-again"]);
        assert!(setting.tools.iter().all(|tool| !tool.set_ups.is_empty() && !tool.works.is_empty()));
    }

    /// Whatever tip a tool can have, both orders have another number for each.
    #[test]
    fn every_place_of_a_tip_has_its_own_number() {
        let knowledge = shipped::knowledge().unwrap();
        let rows = knowledge.rows::<LatheTipPlaces>().unwrap();
        for numbering in [TipNumbering::LinuxCnc, TipNumbering::Common] {
            let of = |row: &&LatheTipPlaces| row.numbering == numbering;
            let mut numbers: Vec<i64> = rows.iter().filter(of).map(|row| row.number).collect();
            let mut places: Vec<_> = rows.iter().filter(of).map(|row| (row.radial, row.axial)).collect();
            numbers.sort_unstable();
            places.sort_unstable();
            places.dedup();
            assert_eq!((numbers, places.len()), ((1..=9).collect(), 9));
        }
    }
}
