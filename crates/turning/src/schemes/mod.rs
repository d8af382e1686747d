//! The schemes by which the rough zone of a stepped shaft is cleared (lecture 12.4), each as a toolpath.
//!
//! [`removal`] puts the passes of a scheme in order, [`path`] makes points of them, [`report`] names and measures
//! these; [`zones`] classifies the zones and gives the scheme of passes for each; [`find`] puts all together.

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
use super::levels::Levels;
use super::shaft::{Rates, Shaft};
use path::Vertex;
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
    /// The levels, for drawings.
    #[serde(skip)]
    pub levels: Levels,
}

/// The split of the rough zone.
#[derive(Clone, Debug, Serialize)]
pub struct Splitting {
    /// The limiting depth, mm.
    pub limiting_depth_mm: Half,
    /// The one depth t_p of all passes, mm.
    pub depth_mm: Half,
    /// The stock over each cylinder, from the free end.
    pub cylinders: Vec<CylinderEntry>,
    /// The horizontals of each section, from the blank inwards.
    pub horizontals: Vec<HorizontalsEntry>,
    /// The rates and distances of the paths.
    pub rates: Rates,
}

/// The stock over a cylinder.
#[derive(Clone, Debug, Serialize)]
pub struct CylinderEntry {
    /// Its diameter after roughing, mm.
    pub diameter_mm: Micrometres,
    /// The diameter of the blank over it, mm.
    pub blank_diameter_mm: Micrometres,
    /// Z of its beginning, mm.
    pub from_z_mm: Half,
    /// Z of its end, mm.
    pub to_z_mm: Half,
    /// The stock, radial, mm.
    pub stock_mm: Half,
    /// The fewest passes that the limiting depth allows.
    pub passes: i64,
    /// The stock divided equally over them, mm.
    pub mean_depth_mm: Half,
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
    /// The path, for drawings.
    #[serde(skip)]
    pub path: Vec<Vertex>,
}

/// Finds levels, zones and schemes of a shaft.
///
/// # Errors
/// The knowledge base lacks one of the rules.
pub fn find(shaft: &Shaft, knowledge: &Knowledge) -> Result<Schemes, KnowledgeError> {
    let levels = Levels::of(shaft);
    let (rates, mut findings) = rates::rates(shaft, knowledge)?;
    let zones = zones::zones(&levels, knowledge)?;
    let mut schemes = Vec::new();
    if !levels.sections.is_empty() {
        for (_, scheme) in Scheme::NAMES {
            schemes.push(entry(*scheme, &levels, &rates, knowledge)?);
        }
    } else {
        findings.clear();
    }
    Ok(Schemes { splitting: splitting(&levels, rates), zones, schemes, findings, levels })
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
        path,
    })
}

fn splitting(levels: &Levels, rates: Rates) -> Splitting {
    let cylinder = |one: super::levels::CylinderStock| CylinderEntry {
        diameter_mm: one.cylinder.radius.diameter(),
        blank_diameter_mm: one.blank.diameter(),
        from_z_mm: Half::ZERO - one.cylinder.from,
        to_z_mm: Half::ZERO - one.cylinder.to,
        stock_mm: one.stock,
        passes: one.passes,
        mean_depth_mm: one.mean,
    };
    let horizontals = levels.sections.iter().map(|section| {
        let first = section.cylinders.first();
        let lowest = first.map_or(section.blank, |first| first.radius);
        let count = first.map_or(0, |first| levels.count(section, first));
        let at = |level| levels.horizontal(section, level).max(lowest).diameter();
        HorizontalsEntry { from_z_mm: Half::ZERO - section.from(), diameters_mm: (1..=count).map(at).collect() }
    });
    Splitting {
        limiting_depth_mm: levels.limit,
        depth_mm: levels.depth,
        cylinders: levels.stocks().into_iter().map(cylinder).collect(),
        horizontals: horizontals.collect(),
        rates,
    }
}
