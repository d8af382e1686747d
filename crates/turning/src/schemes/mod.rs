//! The schemes by which the rough zone of a stepped shaft is cleared (lecture 12.4), each as a toolpath.
//!
//! [`levels`] splits the stock, [`removal`] puts the passes of a scheme in order, [`path`] makes points of them, [`report`]
//! names and measures these; [`zones`] classifies the zones and gives the scheme of passes for each; [`find`] puts all
//! together.

pub mod levels;
pub mod path;
pub mod rates;
pub mod removal;
pub mod report;
pub mod zones;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note};
use crate::tables::turning::passes::RemovalSchemeFor;
use crate::units::Micrometres;

use super::length::Half;
use super::shaft::{Rates, Shaft};
use super::workpiece::Workpiece;
use levels::{Cylinder, Levels};
use removal::Scheme;
use report::{SchemeMeasures, SchemePoint};
use zones::SchemeZone;

/// The levels of a shaft, its zones and its schemes.
#[derive(Clone, Debug, Serialize)]
pub struct Schemes {
    /// The split of the rough zone.
    pub splitting: Splitting,
    /// The zone over each cylinder, and the whole one.
    pub zones: Vec<SchemeZone>,
    /// The schemes in the order of the lecture; none if there is no stock.
    pub schemes: Vec<SchemeEntry>,
    /// Findings for the reader; an answer lists them with all other findings.
    #[serde(skip)]
    pub findings: Vec<Finding>,
}

/// The split of the rough zone.
#[derive(Clone, Debug, Serialize)]
pub struct Splitting {
    /// The levels.
    #[serde(flatten)]
    pub levels: Levels,
    /// The horizontals of each section, from the blank inwards.
    pub horizontals: Vec<HorizontalsEntry>,
    /// The rates and distances of the paths.
    pub rates: Rates,
}

/// The horizontals of a section.
#[derive(Clone, Debug, Serialize)]
pub struct HorizontalsEntry {
    /// Z of the section's beginning, mm.
    pub from_z_mm: Half,
    /// Their diameters, mm.
    pub diameters_mm: Vec<Micrometres>,
}

/// A scheme.
#[derive(Clone, Debug, Serialize)]
pub struct SchemeEntry {
    /// `verticals`, `levels`, `horizontals-a` or `horizontals-b`.
    pub name: &'static str,
    /// Its lengths and its time.
    #[serde(flatten)]
    pub measures: SchemeMeasures,
    /// The points of the tool path in order, from home and back.
    pub points: Vec<SchemePoint>,
    /// Its description, and its source.
    pub because: Because,
    /// Its rank in the preference of the lecture.
    #[serde(skip)]
    pub preference: i64,
}

/// Finds levels, zones and schemes of a workpiece that is a stepped shaft.
///
/// # Errors
/// The knowledge base lacks one of the rules.
pub fn find(workpiece: &Workpiece, shaft: &Shaft, knowledge: &Knowledge) -> Result<Schemes, KnowledgeError> {
    let levels = Levels::of(workpiece, shaft.roughing.longitudinal_depth);
    let (rates, mut findings) = rates::rates(shaft, knowledge)?;
    let zones = zones::zones(&levels, knowledge)?;
    let mut schemes = Vec::new();
    if !levels.cylinders.is_empty() {
        for (_, scheme) in Scheme::NAMES {
            schemes.push(entry(*scheme, &levels, &rates, knowledge)?);
        }
    } else {
        findings.clear();
    }
    let horizontals = levels.sections().filter_map(|section| horizontals(&levels, section)).collect();
    Ok(Schemes { splitting: Splitting { levels, horizontals, rates }, zones, schemes, findings })
}

fn entry(scheme: Scheme, levels: &Levels, rates: &Rates, knowledge: &Knowledge) -> Result<SchemeEntry, KnowledgeError> {
    let rule = knowledge.ask(&RemovalSchemeFor { scheme })?.need(scheme.name())?;
    let path = removal::path(scheme, levels, Half::of(rates.approach), Half::of(rates.retract));
    Ok(SchemeEntry {
        name: scheme.name(),
        measures: report::measure(&path, rates),
        points: report::points(&path, levels),
        because: Because::row(rule.row, Note::new(format!("scheme-{}", scheme.name()))),
        preference: rule.preference,
    })
}

/// The horizontals of a section down to its smallest cylinder, the first.
fn horizontals(levels: &Levels, section: &[Cylinder]) -> Option<HorizontalsEntry> {
    let first = section.first()?;
    let at = |level| levels.horizontal(first, level).max(first.radius).diameter();
    let diameters_mm = (1..=levels.count(first)).map(at).collect();
    Some(HorizontalsEntry { from_z_mm: Half::ZERO - first.from, diameters_mm })
}
