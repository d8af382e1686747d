//! What is known of tapped metric threads wherever the hole is: the name of the thread, its drill, and the limits of the hole under
//! it.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef, TableError};
use crate::tables::standards::{
    CoarseThread, FineThread, MinorDiameterConstant, ThreadDeviations, ThreadMinorDiameter,
};
use crate::units::Micrometres;

/// The hole that is drilled for a tap.
#[derive(Clone, Debug)]
pub struct TapHole<'k> {
    /// The thread as the tables of taps and drills name it: `M10` with the coarse pitch, `M10x1.25`.
    pub id: String,
    /// The diameter of its drill, mm.
    pub drill: Micrometres,
    /// The row of the drill; none where it is the size less the pitch, which is the rule of the tables.
    pub row: Option<RowRef<'k>>,
}

/// The coarse thread of a size, of the table `tap-drills`; none where it has no such size.
///
/// # Errors
/// The table is broken.
pub fn coarse(size: Micrometres, knowledge: &Knowledge) -> Result<Option<CoarseThread<'_>>, TableError> {
    let id = format!("M{size}");
    knowledge.find(|row: &CoarseThread<'_>| row.thread == id)
}

/// The hole for a tap: by `tap-drills` for the coarse pitch, by `tap-drills-fine` for another, and where these have no row the size
/// less the pitch, as in ISO practice.
///
/// # Errors
/// A table is broken.
pub fn tap_hole(size: Micrometres, pitch: Micrometres, knowledge: &Knowledge) -> Result<TapHole<'_>, TableError> {
    if let Some(row) = coarse(size, knowledge)?.filter(|row| row.pitch == pitch) {
        return Ok(TapHole { id: row.thread.to_owned(), drill: row.diameter, row: Some(row.row) });
    }
    let id = format!("M{size}x{pitch}");
    let fine = knowledge.find(|row: &FineThread<'_>| row.thread == id)?;
    let drill = fine.as_ref().map_or(size - pitch, |row| row.diameter);
    Ok(TapHole { id, drill, row: fine.map(|row| row.row) })
}

/// The least and the largest minor diameter of an internal thread 6H, between which the hole under it lies.
///
/// D1 = d − a·P at least. Its tolerance is that of the table `thread-deviations`; for pitches beyond it the formula of ISO 965-1,
/// which the table rounds: b·P − c·P^e µm below a pitch of 1 mm, f·P^g µm from it on (table `thread-minor-diameter`).
///
/// # Errors
/// The table lacks a constant.
pub fn minor_diameter(
    size: Micrometres,
    pitch: Micrometres,
    knowledge: &Knowledge,
) -> Result<(Micrometres, Micrometres), KnowledgeError> {
    use MinorDiameterConstant as C;
    let constant = |name: C| -> Result<f64, KnowledgeError> {
        Ok(knowledge.need(name.name(), |row: &ThreadMinorDiameter<'_>| row.name.is(name))?.value)
    };
    let p = pitch.to_mm();
    let tolerance = if let Some(row) = knowledge.find(|row: &ThreadDeviations<'_>| row.pitch == pitch)? {
        row.minor_6
    } else if p < constant(C::CoarseFrom)? {
        let fine = constant(C::FineLinear)? * p - constant(C::FinePower)? * libm::pow(p, constant(C::FineExponent)?);
        Micrometres::from_mm_rounded(fine / 1000.0)
    } else {
        let coarse = constant(C::CoarseFactor)? * libm::pow(p, constant(C::CoarseExponent)?);
        Micrometres::from_mm_rounded(coarse / 1000.0)
    };
    let smallest = Micrometres::from_mm_rounded(size.to_mm() - constant(C::MinorHeight)? * p);
    Ok((smallest, smallest + tolerance))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    /// Drills of ГОСТ 19257-73 and ISO 2306; limits of 6H by engineersedge.com, metric-internal-thread-sizes1 (ASME B1.13M), M6 and M8
    /// by scribd.com/document/604040407; M20 and M36 by the least diameter of the profile and the tolerance of ГОСТ 16093-81. Published
    /// limits are rounded by themselves.
    #[test]
    fn holes_under_threads_are_those_of_the_standards() {
        let knowledge = shipped::knowledge().unwrap();
        let um = Micrometres::new;
        for (size, pitch, id, drill, limits) in [
            (6_000, 1_000, "M6", 5_000, (4_917, 5_153)),
            (8_000, 1_250, "M8", 6_800, (6_647, 6_912)),
            (10_000, 1_500, "M10", 8_500, (8_376, 8_676)),
            (10_000, 1_250, "M10x1.25", 8_800, (8_647, 8_912)),
            (12_000, 1_750, "M12", 10_200, (10_106, 10_441)),
            (16_000, 1_500, "M16x1.5", 14_500, (14_376, 14_676)),
            (20_000, 2_500, "M20", 17_500, (17_294, 17_744)),
            (36_000, 4_000, "M36", 32_000, (31_670, 32_270)),
        ] {
            let hole = tap_hole(um(size), um(pitch), &knowledge).unwrap();
            assert_eq!((hole.id.as_str(), hole.drill.micrometres()), (id, drill));
            let (least, most) = minor_diameter(um(size), um(pitch), &knowledge).unwrap();
            let near = |found: Micrometres, wanted: i64| (found.micrometres() - wanted).abs() <= 1;
            assert!(near(least, limits.0) && near(most, limits.1), "{id}: {least} {most}");
            assert!((least..=most).contains(&hole.drill), "{id}");
        }
    }
}
