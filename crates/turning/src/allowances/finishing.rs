//! Finishing allowances: from a table, from the errors of the previous pass, or as the file states them (lecture 12.2).

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity};
use crate::tables::turning::part::{FinishTurningAllowanceFor, Pass, SurfaceAfterPassFor};
use crate::turning::contour::{Profile, SurfaceName};
use crate::turning::length::Half;
use crate::units::{Micrometres, Microns};

use super::capability::is_groove;
use super::surfaces::{Place, diameter, on_side, place, query_size};

/// The errors that an allowance must cover, each on one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Errors {
    /// Rz, the height of the roughness after the previous pass; if none, from the table `surface-after-pass`.
    pub roughness_height: Option<Half>,
    /// T, the damaged layer after the previous pass; if none, from the same table.
    pub damaged_layer: Option<Half>,
    /// ρ, the spatial deviations after the previous pass, such as bending and eccentricity.
    pub deviation: Half,
    /// ε, the set-up error of this pass.
    pub setting: Half,
}

/// How finishing allowances are found. An allowance that a surface states itself takes precedence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// By experience and statistics: the table `finish-turning-allowance`.
    Table,
    /// Calculated from errors.
    Analytic(Errors),
    /// As stated for the whole part.
    Stated {
        /// On the diameter of cylinders, cones and arcs.
        on_diameter: Option<Micrometres>,
        /// On faces.
        on_face: Option<Micrometres>,
    },
}

/// The finishing allowance of a surface.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Allowance {
    /// Its name.
    pub surface: SurfaceName,
    /// Where it lies.
    pub place: Place,
    /// On one side, along the normal, mm. None if it is unknown (a finding says so) and for grooves, which are bridged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub allowance_mm: Option<Half>,
    /// Its row, if it comes from a table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub because: Option<Because>,
}

/// The least allowance on one side by Kovan's analytic method (lecture 12.2), from the errors of the actual conditions.
///
/// z_min = Rz + T + √(ρ² + ε²) for surfaces of revolution, whose errors can have any direction (2·z_min on the
/// diameter), and z_min = Rz + T + ρ + ε for faces, whose errors have one direction. Rounded up to half a micrometre.
///
/// Source: Косилова А.Г., Мещеряков Р.К. Справочник технолога-машиностроителя, т. 1, chapter on allowances.
pub fn least(place: Place, roughness_height: Half, damaged_layer: Half, deviation: Half, setting: Half) -> Half {
    let layer = roughness_height + damaged_layer;
    match place {
        Place::Face => layer + deviation + setting,
        Place::Outer | Place::Inner => {
            let both = libm::hypot(deviation.halves() as f64, setting.halves() as f64);
            layer + Half::new(libm::ceil(both - 1e-9) as i64)
        }
    }
}

/// The finishing allowance of each surface; `length` is that of the whole part.
///
/// # Errors
/// The knowledge base lacks a table or a row that must be there.
pub fn finishing(
    profile: &Profile,
    method: Method,
    length: Micrometres,
    knowledge: &Knowledge,
) -> Result<(Vec<Allowance>, Vec<Finding>), KnowledgeError> {
    let (mut allowances, mut findings) = (Vec::new(), Vec::new());
    for surface in &profile.surfaces {
        let place = place(surface, profile.side);
        let (allowance_mm, because) = match surface.stated_allowance {
            Some(stated) => (Some(stated), None),
            None if is_groove(surface.kind) => (None, None),
            None => {
                let result = allowance(place, diameter(surface), length, method, knowledge)?;
                if result.0.is_none() {
                    let note = Note::new("no-finishing-allowance").with("surface", &surface.name);
                    findings.push(Finding::of_part(Severity::Error, note));
                }
                result
            }
        };
        if let Some(doubt) = because.as_ref().and_then(Because::doubt) {
            let finding = Finding::of_part(Severity::Doubtful, doubt);
            if !findings.contains(&finding) {
                findings.push(finding);
            }
        }
        allowances.push(Allowance { surface: surface.name.clone(), place, allowance_mm, because });
    }
    Ok((allowances, findings))
}

/// The finishing allowance on one side for a place and a size, also for a bridge, which is no surface. None if the
/// table has no row for the size or the file states no allowance.
///
/// # Errors
/// The knowledge base lacks a table or a row that must be there.
pub fn allowance(
    place: Place,
    diameter: Micrometres,
    length: Micrometres,
    method: Method,
    knowledge: &Knowledge,
) -> Result<(Option<Half>, Option<Because>), KnowledgeError> {
    match method {
        Method::Table => {
            let (diameter, length) = (query_size(diameter), query_size(length));
            let lookup = knowledge.ask(&FinishTurningAllowanceFor { place_on: place, diameter, length })?;
            let Some(row) = lookup.winner()? else { return Ok((None, None)) };
            let allowance_mm = on_side(place, row.allowance);
            let note = Note::new("finishing-allowance").with("place", place.name()).with("allowance", allowance_mm);
            Ok((Some(allowance_mm), Some(Because::answer(&lookup.answer, note))))
        }
        Method::Stated { on_diameter, on_face } => {
            let stated = if place == Place::Face { on_face } else { on_diameter };
            Ok((stated.map(|stated| on_side(place, stated)), None))
        }
        Method::Analytic(errors) => {
            let lookup = knowledge.ask(&SurfaceAfterPassFor { pass: Pass::Rough })?;
            let row = lookup.need(Pass::Rough.name())?;
            let of = |thickness: Microns| Half::from(thickness.0 / 1000.0);
            let (height, layer) = (of(row.roughness_height), of(row.damaged_layer));
            let (given, stated) = (errors.roughness_height, errors.damaged_layer);
            let allowance_mm =
                least(place, given.unwrap_or(height), stated.unwrap_or(layer), errors.deviation, errors.setting);
            let note = Note::new("analytic-allowance").with("place", place.name()).with("allowance", allowance_mm);
            let because = (given.is_none() || stated.is_none()).then(|| Because::answer(&lookup.answer, note));
            Ok((Some(allowance_mm), because))
        }
    }
}
