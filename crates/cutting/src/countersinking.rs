//! Counterboring, countersinking and chamfering.

use crate::error::Tried;
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::units::MillimetresPerRev;

use super::{Cut, DraftConditions, drilling, feed, figures};

/// Conditions by the coefficients of core drilling (Косилова/Мещеряков т.2, tables 29, 30, 32; facts 1.2-1.4).
///
/// The handbook has no coefficients for tools that widen the mouth of a hole; the rule `stand-in-operation` takes
/// those of core drilling, whose teeth and depth of cut are nearest. The feed has a table of its own,
/// `counterboring-feed`.
///
/// - V = Cv·D^q / (T^m·t^x·s^y)·Kv, m/min;
/// - M = 10·Cm·D^q·t^x·s^y·Kp, N·m; P = 10·Cp·D^q·t^x·s^y·Kp, N;
/// - t = (D - d)/2, mm: for a cone that of its full depth, where the load is largest.
pub(super) fn draft(cut: &Cut, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    let (instead, reason) = figures::stand_in_operation(cut.operation, shop)?;
    let mut feed = feed::tabulated(cut, shop)?.with_feed(taken);
    feed.because.push(reason);
    drilling::by_tables(&Cut { operation: instead, ..*cut }, feed, shop)
}
