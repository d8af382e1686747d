//! How narrow is too narrow to be there at all.

use crate::turning::length::Half;

/// Along the axis nothing narrower than this counts, metal or air: 3 µm.
///
/// Points are rounded to half a micrometre. Where an arc is upright that is nothing along the axis and much across it: at
/// 0.5 µm before the end of a quarter of 5 mm it stands √(2·5·0.0005) = 0.07 mm higher. So between such an arc and a face,
/// between two arcs, or between two cuts that end on one, slots and slivers appear that are one rounding of the ends of
/// either side wide, two or three half micrometres each: less than 3 µm together. No tool goes into such a slot and no
/// level begins in it: it is wall. And a sliver no wider is not worth a pass: it is gone with the next one or breaks off.
pub const NARROW: Half = Half::new(6);

/// Whether a stretch of Z is narrower than [`NARROW`].
pub fn is_narrow(from: Half, to: Half) -> bool {
    to - from < NARROW
}
