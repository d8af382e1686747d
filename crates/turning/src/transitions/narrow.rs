//! The least width along the axis that counts.

use crate::turning::length::Half;

/// Anything narrower than this along the axis does not count, metal or air: 3 µm.
///
/// Points are rounded to half a micrometre. Where an arc is perpendicular to the axis, that is nothing along the axis
/// and much across it: 0.5 µm before the end of a quarter of 5 mm the arc is √(2·5·0.0005) = 0.07 mm higher. So
/// between such an arc and a face, between two arcs, or between two cuts that end on one, there are slots and slivers
/// as wide as the rounding of the ends on both sides, two or three half micrometres each: less than 3 µm together. No
/// tool enters such a slot and no level begins in it, so it counts as wall. A sliver of that width is not worth a
/// pass: the next pass removes it, or it breaks off.
pub const NARROW: Half = Half::new(6);

/// Whether a range of Z is narrower than [`NARROW`].
pub fn is_narrow(from: Half, to: Half) -> bool {
    to - from < NARROW
}
