//! Support points of a toolpath, with their names.

use serde::Serialize;

use crate::turning::length::Half;
use crate::turning::numbering::Numbering;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::Micrometres;

use super::builder::SupportPointRole;

/// A support point of a toolpath.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SupportPoint {
    /// Its name: 0 is home, the others are numbered in the order of the first visit, as in fig. 12.4 of the lecture. A
    /// point that is visited again keeps its name.
    pub name: String,
    /// Diameter, mm.
    pub diameter_mm: Micrometres,
    /// Z, mm: negative towards the chuck.
    pub z_mm: Half,
    /// The purpose of the motion that ends here; none at the beginning.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub purpose: Option<Purpose>,
    /// Its role.
    pub role: SupportPointRole,
}

/// The support points of a toolpath.
pub fn points(path: &Toolpath, roles: &[SupportPointRole]) -> Vec<SupportPoint> {
    let mut numbers = Numbering::after(0);
    numbers.put(path.from, "0");
    let from = std::iter::once((path.from, None));
    let all = from.chain(path.moves.iter().map(|one| (one.to, Some(one.purpose))));
    let points = all.zip(roles).map(|((at, purpose), role)| SupportPoint {
        name: numbers.name(at),
        diameter_mm: at.radius.diameter(),
        z_mm: Half::ZERO - at.z,
        purpose,
        role: *role,
    });
    points.collect()
}
