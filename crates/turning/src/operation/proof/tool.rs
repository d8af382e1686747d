//! The tool of a job as the proof sees it.

use technolog_turning_proof as proof;

use crate::turning::jobs::{Body, JobTool, UNKNOWN_EDGE};
use crate::turning::tooling::{Hand, Place, ToolKind};
use crate::units::{Degrees, Micrometres};
use proof::{Cutter, Holder, Mm};

pub(crate) fn tool(tool: &JobTool) -> proof::Tool {
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
