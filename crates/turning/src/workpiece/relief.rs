//! Sizes of reliefs that the file leaves out, from the tables of the standards.

use crate::knowledge::Knowledge;
use crate::note::{Finding, doubtful_row};
use crate::tables::standards::{GrindingReliefFor, ThreadRelief};
use crate::turning::contour::Side;
use crate::units::Micrometres;

/// The sizes of a relief by a table.
pub(super) struct Relief {
    pub width: Micrometres,
    pub depth: Micrometres,
    /// A finding that its row is not confirmed.
    pub finding: Option<Finding>,
}

/// The relief for the grinding wheel in a cylinder of a diameter (ГОСТ 8820-69, table `grinding-relief`), of a width if
/// one is given. None if the standard has none, or leaves a choice.
pub(super) fn grinding(diameter: Micrometres, width: Option<Micrometres>, knowledge: &Knowledge) -> Option<Relief> {
    let mut rows = knowledge.ask(&GrindingReliefFor { diameter }).ok()?.winners().ok()?;
    rows.retain(|row| width.is_none_or(|width| row.width == width));
    match rows.as_slice() {
        [one] => Some(Relief { width: one.width, depth: one.depth, finding: doubtful_row(one.row) }),
        _ => None,
    }
}

/// The normal relief at the end of a thread of a pitch (ГОСТ 10549-80, table `thread-relief`); the table has none for
/// bores.
pub(super) fn thread(pitch: Micrometres, side: Side, knowledge: &Knowledge) -> Option<Relief> {
    if side == Side::Inner {
        return None;
    }
    let row = knowledge.find(|row: &ThreadRelief<'_>| row.pitch == pitch).ok()??;
    Some(Relief { width: row.width, depth: row.depth, finding: doubtful_row(row.row) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    #[test]
    fn the_standards_give_the_sizes() {
        let knowledge = shipped::knowledge().unwrap();
        let mm = |text: &str| text.parse::<Micrometres>().unwrap();
        let of = |relief: Option<Relief>| relief.map(|relief| (relief.width.to_string(), relief.depth.to_string()));
        let some = |width: &str, depth: &str| Some((width.to_owned(), depth.to_owned()));
        assert_eq!(of(grinding(mm("40"), None, &knowledge)), some("3", "0.25"));
        assert_eq!(of(grinding(mm("50"), None, &knowledge)), some("3", "0.25"));
        assert_eq!(of(grinding(mm("50.001"), None, &knowledge)), some("5", "0.5"));
        assert_eq!(of(grinding(mm("8"), None, &knowledge)), None, "up to 10 the standard leaves three widths");
        assert_eq!(of(grinding(mm("8"), Some(mm("2")), &knowledge)), some("2", "0.25"));
        assert_eq!(of(grinding(mm("40"), Some(mm("4")), &knowledge)), None);
        assert_eq!(of(thread(mm("2"), Side::Outer, &knowledge)), some("5", "1.5"));
        assert_eq!(of(thread(mm("2"), Side::Inner, &knowledge)), None);
        assert_eq!(of(thread(mm("2.1"), Side::Outer, &knowledge)), None);
    }

    /// A relief must be deeper than the profile of its thread, 0.6134 P (ISO 68-1: 17/24 of H = 0.866 P), so that the
    /// tool can leave the thread, but not so deep that it weakens the part without need.
    #[test]
    fn reliefs_of_threads_are_deeper_than_the_thread() {
        let knowledge = shipped::knowledge().unwrap();
        let rows: Vec<ThreadRelief<'_>> = knowledge.rows().unwrap();
        assert!(rows.len() > 10);
        for row in rows {
            let (pitch, depth) = (row.pitch.to_mm(), row.depth.to_mm());
            assert!((0.6134..=0.8).contains(&(depth / pitch)), "{pitch}: {depth}");
        }
    }
}
