//! The bounds of the parts of the rough zone of a stepped shaft, and the lecture's scheme of passes for each. The
//! rules are in [`zones::kind`](crate::turning::zones::kind), as for contours of any shape.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Because;
use crate::turning::length::Half;
use crate::turning::workpiece::Scheme;
use crate::turning::zones::kind::{Bounds, Circumstances, ClassifiedZone, ZoneKind, alone, scheme, together};

use super::levels::Levels;

/// A zone, with the schemes that suit it.
#[derive(Clone, Debug, Serialize)]
pub struct SchemeZone {
    /// Z of its beginning, mm.
    pub from_z_mm: Half,
    /// Z of its end, mm.
    pub to_z_mm: Half,
    /// Its kind.
    pub zone: ZoneKind,
    /// The schemes, in the order of work; more than one if the zone is worked in parts.
    pub schemes: Vec<Scheme>,
    /// The reason for the kind.
    pub because_zone: Because,
    /// The reason for the schemes.
    pub because: Because,
}

/// The zone over each cylinder, and after them the whole zone if there is more than one.
///
/// # Errors
/// The knowledge base lacks a rule or a row of it.
pub fn zones(levels: &Levels, knowledge: &Knowledge) -> Result<Vec<SchemeZone>, KnowledgeError> {
    let cylinders = &levels.cylinders;
    let mut zones = Vec::new();
    let mut kinds = Vec::new();
    for (index, cylinder) in cylinders.iter().enumerate() {
        // The stock of the next section of a stepped blank is a face ahead too, although not one of the contour.
        let stock_ahead = cylinders.get(index + 1).is_some_and(|next| next.from == cylinder.to);
        // A stepped shaft has no face behind the tool: its cylinders grow towards the chuck.
        let bounds = Bounds { ahead: cylinder.wall.is_some() || stock_ahead, behind: false };
        let classified = alone(bounds, knowledge)?;
        kinds.push((classified.kind, bounds));
        zones.push(zone(knowledge, cylinder.from, cylinder.to, classified)?);
    }
    if let (Some(first), Some(last), true) = (cylinders.first(), cylinders.last(), cylinders.len() > 1) {
        zones.push(zone(knowledge, first.from, last.to, together(&kinds, knowledge)?)?);
    }
    Ok(zones)
}

/// The scheme for a kind of zone. For a stepped contour it is the same for every blank.
fn zone(knowledge: &Knowledge, from: Half, to: Half, classified: ClassifiedZone) -> Result<SchemeZone, KnowledgeError> {
    let stepped = Circumstances { shaped: false, near_part: false, against_stop: false };
    let choice = scheme(&classified, stepped, knowledge)?;
    Ok(SchemeZone {
        from_z_mm: Half::ZERO - from,
        to_z_mm: Half::ZERO - to,
        zone: classified.kind,
        schemes: choice.schemes,
        because_zone: classified.because,
        because: choice.because,
    })
}
