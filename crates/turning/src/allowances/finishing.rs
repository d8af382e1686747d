//! The finishing allowances: by a table, by the errors of the pass before, or as the file states them (lecture 12.2).

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity};
use crate::tables::turning::part::{FinishTurningAllowanceFor, Pass, SurfaceAfterPassFor};
use crate::turning::contour::{Profile, SurfaceName};
use crate::turning::length::Half;
use crate::units::{Micrometres, Microns};

use super::capability::is_groove;
use super::surfaces::{Place, asked, diameter, on_side, place};

/// The errors that an allowance must cover, each on one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Errors {
    /// Rz, the height of the roughness that the pass before leaves; none: of the table `surface-after-pass`.
    pub roughness_height: Option<Half>,
    /// T, the damaged layer that it leaves; none: of the same table.
    pub damaged_layer: Option<Half>,
    /// ρ, the deviations in space that it leaves: bending, being off the axis.
    pub deviation: Half,
    /// ε, the error of setting the part up for this pass.
    pub setting: Half,
}

/// How finishing allowances are found. What a surface states itself goes before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// By experience and statistics: the table `finish-turning-allowance`.
    Table,
    /// By reckoning from errors.
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
    /// On one side, along the normal, mm; none where it is unknown (a finding says so) and for grooves, which are bridged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub allowance_mm: Option<Half>,
    /// The row that it rests on, where it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub because: Option<Because>,
}

/// The least allowance on one side (the analytic method of Кован, lecture 12.2: errors of the concrete conditions).
///
/// z_min = Rz + T + √(ρ² + ε²) for surfaces of revolution, whose errors have any direction (2·z_min on the diameter), and
/// z_min = Rz + T + ρ + ε for faces, whose errors have one. Rounded up to half a micrometre.
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
                let found = allowance(place, diameter(surface), length, method, knowledge)?;
                if found.0.is_none() {
                    let note = Note::new("no-finishing-allowance").with("surface", &surface.name);
                    findings.push(Finding::of_part(Severity::Error, note));
                }
                found
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

/// The finishing allowance at a place, on one side, for what is no surface of its own too, such as a bridge; none where the
/// table has no row for its size or the file states none.
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
            let (diameter, length) = (asked(diameter), asked(length));
            let told = knowledge.ask(&FinishTurningAllowanceFor { place_on: place, diameter, length })?;
            let Some(row) = told.winner()? else { return Ok((None, None)) };
            let found = on_side(place, row.allowance);
            let note = Note::new("finishing-allowance").with("place", place.name()).with("allowance", found);
            Ok((Some(found), Some(Because::answer(&told.answer, note))))
        }
        Method::Stated { on_diameter, on_face } => {
            let stated = if place == Place::Face { on_face } else { on_diameter };
            Ok((stated.map(|stated| on_side(place, stated)), None))
        }
        Method::Analytic(errors) => {
            let told = knowledge.ask(&SurfaceAfterPassFor { pass: Pass::Rough })?;
            let row = told.need(Pass::Rough.name())?;
            let of = |thickness: Microns| Half::from(thickness.0 / 1000.0);
            let (height, layer) = (of(row.roughness_height), of(row.damaged_layer));
            let (given, stated) = (errors.roughness_height, errors.damaged_layer);
            let found =
                least(place, given.unwrap_or(height), stated.unwrap_or(layer), errors.deviation, errors.setting);
            let note = Note::new("analytic-allowance").with("place", place.name()).with("allowance", found);
            let because = (given.is_none() || stated.is_none()).then(|| Because::answer(&told.answer, note));
            Ok((Some(found), because))
        }
    }
}
