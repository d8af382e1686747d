//! For a hole that nothing makes: the nearest depth at which the same hole can be made.

use crate::error::{KnowledgeError, Refusal};
use crate::note::Note;
use crate::part::{Hole, Part};
use crate::plan::Preference;
use crate::shop::Shop;
use crate::tooling::DrillSize;
use crate::units::Micrometres;

use super::options;

/// What a millimetre is.
const MM: i64 = 1000;

/// The deepest hole of the same size, in whole millimetres, that can be made; of a through hole the thickest blank. None where no
/// depth helps, and for stepped holes, of which more than one depth may be meant.
pub(super) fn depth(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Result<Option<Note>, KnowledgeError> {
    if !hole.steps.is_empty() {
        return Ok(None);
    }
    let works = |depth: i64| -> Result<bool, KnowledgeError> {
        let depth = Micrometres::new(depth * MM);
        let mut hole = hole.clone();
        let mut part = part.clone();
        hole.depth = depth;
        if hole.through {
            part.blank.thickness = depth;
        }
        let opening = hole.counterbore.map(|counterbore| counterbore.depth).unwrap_or_default();
        if depth <= opening {
            return Ok(false);
        }
        let found = Refusal::split(options::options(&hole, &part, preference, drills, shop))?;
        Ok(found.is_ok_and(|found| !found.choices.is_empty() && found.impossible.is_empty()))
    };
    let mut fails = (hole.depth.micrometres() + MM - 1) / MM;
    let mut makes = None;
    for quarters in [3, 2, 1] {
        let depth = share_of(hole.depth, quarters);
        if depth < 1 || depth >= fails {
            continue;
        }
        if works(depth)? {
            makes = Some(depth);
            break;
        }
        fails = depth;
    }
    let Some(mut makes) = makes else { return Ok(None) };
    while fails - makes > 1 {
        let between = makes + (fails - makes) / 2;
        if works(between)? {
            makes = between;
        } else {
            fails = between;
        }
    }
    let code = if hole.through { "nearest-thickness" } else { "nearest-depth" };
    let wanted = Note::new(code).with("depth", Micrometres::new(makes * MM));
    Ok(Some(wanted.with("asked", hole.depth)))
}

/// That many quarters of a depth, in whole millimetres.
fn share_of(depth: Micrometres, quarters: i64) -> i64 {
    depth.micrometres() * quarters / 4 / MM
}
