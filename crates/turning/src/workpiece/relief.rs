//! Sizes of reliefs that the file leaves out, from the tables of the standards.

use crate::knowledge::{Input, Knowledge, RowRef};
use crate::note::{Finding, doubtful_row};
use crate::turning::contour::Side;
use crate::units::Micrometres;

/// The sizes of a relief by a table.
pub(super) struct Relief {
    pub width: Micrometres,
    pub depth: Micrometres,
    /// That its row is not confirmed.
    pub finding: Option<Finding>,
}

/// The relief for the grinding wheel in a cylinder of a diameter (ГОСТ 8820-69, table `grinding-relief`), of a width if
/// one is given; none where the standard has none, or leaves a choice.
pub(super) fn grinding(diameter: Micrometres, width: Option<Micrometres>, knowledge: &Knowledge) -> Option<Relief> {
    let answer = knowledge.table("grinding-relief").ok()?.decide(&[("diameter", Input::Length(diameter))]).ok()?;
    let fits = |row: &RowRef<'_>| width.is_none_or(|width| row.length("width") == Ok(width));
    let mut rows = answer.winners().filter(fits);
    let row = rows.next()?;
    if rows.next().is_some() { None } else { relief(row) }
}

/// The normal relief at the end of a thread of a pitch (ГОСТ 10549-80, table `thread-relief`); of a bore the table has
/// none.
pub(super) fn thread(pitch: Micrometres, side: Side, knowledge: &Knowledge) -> Option<Relief> {
    if side == Side::Inner {
        return None;
    }
    let table = knowledge.table("thread-relief").ok()?;
    relief(table.all_rows().find(|row| row.length("pitch") == Ok(pitch))?)
}

fn relief(row: RowRef<'_>) -> Option<Relief> {
    Some(Relief { width: row.length("width").ok()?, depth: row.length("depth").ok()?, finding: doubtful_row(row) })
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

    /// A relief must be deeper than the profile of its thread, 0.6134 P (ISO 68-1: 17/24 of H = 0.866 P), or the tool has
    /// no way out; and not so deep that it weakens the part for nothing.
    #[test]
    fn reliefs_of_threads_are_deeper_than_the_thread() {
        let knowledge = shipped::knowledge().unwrap();
        let table = knowledge.table("thread-relief").unwrap();
        assert!(table.all_rows().count() > 10);
        for row in table.all_rows() {
            let (pitch, depth) = (row.length("pitch").unwrap().to_mm(), row.length("depth").unwrap().to_mm());
            assert!((0.6134..=0.8).contains(&(depth / pitch)), "{pitch}: {depth}");
        }
    }
}
