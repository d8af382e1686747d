//! What is turned with an allowance that another machine takes off.

use serde::Serialize;

use crate::tables::turning::part::LaterOperation;
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::jobs::Work;
use crate::turning::length::Half;
use crate::units::Micrometres;

use super::{Operation, SetUpWork, sizes};

/// A surface as it leaves the lathe for a later operation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ground {
    /// The set-up that turns it; none where no tool does.
    pub set_up: Option<u8>,
    /// The surface.
    pub surface: SurfaceName,
    /// The later operation.
    pub operation: LaterOperation,
    /// The diameter of the drawing, mm; none of a face.
    pub nominal_mm: Option<Micrometres>,
    /// The field or the deviations of the drawing, which the later operation holds.
    pub fit: String,
    /// The diameter that is turned, mm: that of the drawing with the allowance on both sides.
    pub turned_mm: Option<Micrometres>,
    /// What is left on one side, mm.
    pub allowance_mm: Half,
}

/// Every surface of an operation that another machine finishes.
pub fn ground(operation: &Operation) -> Vec<Ground> {
    let part = &operation.workpiece;
    let profiles = || std::iter::once(&part.outer).chain(&part.inner);
    let of = |one: &super::Elsewhere| {
        let found = |profile: &'_ crate::turning::contour::Profile| {
            profile.surfaces.iter().find(|surface| surface.name == one.surface).cloned()
        };
        let (side, surface) = profiles().find_map(|profile| Some((profile.side, found(profile)?)))?;
        let turns = |set_up: &&SetUpWork| {
            let mut jobs = set_up.jobs.iter().filter(|job| matches!(job.work, Work::Finish | Work::Face));
            jobs.any(|job| job.surfaces.contains(&one.surface))
        };
        let nominal_mm = surface.cylinder().map(|piece| piece.from.radius.diameter());
        let both = one.allowance_mm.diameter();
        Some(Ground {
            set_up: operation.set_ups.iter().find(turns).map(|set_up| set_up.set_up.number),
            surface: one.surface.clone(),
            operation: one.operation,
            nominal_mm,
            fit: sizes::written(&surface),
            turned_mm: nominal_mm.map(|size| if side == Side::Outer { size + both } else { size - both }),
            allowance_mm: one.allowance_mm,
        })
    };
    operation.elsewhere.iter().filter_map(of).collect()
}
