//! Every way of roughing a stepped shaft in one table, and the one to take: the sequences of passes ([`passes`], the
//! paper) and the removal schemes ([`schemes`], the lecture).
//!
//! All have the same rates, distances and stock, so their times can be compared. A way holds unless the rule
//! `pass-direction` refuses it, or the proof finds that its program damages something. The quickest of those that hold and
//! leave no metal standing is recommended; where all leave some, the quickest that holds.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::material::MaterialState;
use crate::note::{Because, Figure, Finding, Note, Severity};
use crate::tables::turning::part::BlankShape;
use crate::tables::turning::passes::{PassDirectionFor, Passes};
use crate::units::{Minutes, round_to};

use super::length::Half;
use super::operation::{self, Operation, by_way};
use super::passes::cost::Objective;
use super::passes::pass::PassDirection;
use super::passes::{self, Sequences, Variant};
use super::point::Point;
use super::schemes::removal::{self, Scheme};
use super::schemes::{self, SchemeEntry, Schemes};
use super::shaft::{Holding, Rates, Shaft};
use super::toolpath::{Purpose, Toolpath};
use super::workpiece::Workpiece;

/// The ways of roughing a shaft, with all that they are made of.
#[derive(Clone, Debug, Serialize)]
pub struct Ways {
    /// The name of the shaft.
    pub shaft: String,
    /// The id of its material.
    pub material: String,
    /// The id of its lathe, as in the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub machine: Option<String>,
    /// The hardness or strength of its material, if the file gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material_state: Option<MaterialState>,
    /// The way of clamping.
    pub holding: Holding,
    /// The sequences of longitudinal and transverse passes.
    #[serde(flatten)]
    pub sequences: Sequences,
    /// The levels, zones and removal schemes.
    #[serde(flatten)]
    pub schemes: Schemes,
    /// The ways side by side; none if there is no stock.
    pub ways: Vec<Way>,
    /// What the rule `pass-direction` says of the shaft.
    pub pass_direction: Because,
    /// The answer; none if there is no stock.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recommended: Option<Recommended>,
    /// What is wrong with the operation of the shaft, whichever way is taken; doubtful only where no lathe is named. The findings
    /// beside it are of the ways alone.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub operation_findings: Vec<Finding>,
    /// The operation of the shaft, whose tool and conditions the program of a way has.
    #[serde(skip)]
    pub operation: Operation,
}

/// A way of roughing.
#[derive(Clone, Debug, Serialize)]
pub struct Way {
    /// `longitudinal`, `transverse`, `per-step`, `optimal`, `verticals`, `levels`, `horizontals-a` or `horizontals-b`.
    pub name: &'static str,
    /// The length at the working feed from the metal on, mm.
    pub cutting_path_mm: Half,
    /// The number of its passes.
    pub passes: usize,
    /// How many of these run across the axis.
    pub transverse_passes: usize,
    /// Feeds and rapids together.
    pub time_min: Minutes,
    /// Why it does not hold; none if it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Note>,
    /// Where it leaves metal that a finishing pass must take; none if it leaves none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leaves: Option<Note>,
    /// Decides among ways of the same time, the least first.
    #[serde(skip)]
    preference: i64,
}

/// The way to take.
#[derive(Clone, Debug, Serialize)]
pub struct Recommended {
    /// Its name; none if no way holds.
    pub variant: Option<&'static str>,
    /// The next best that holds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next: Option<&'static str>,
    /// By how much it is quicker than that, min.
    pub margin_min: Minutes,
    /// The same as a share of the next best's time, per cent.
    pub margin_percent: f64,
    /// The reason.
    pub because: Because,
}

/// Finds the ways of a workpiece; none if it is no stepped shaft. The objective is that of the search for the optimal sequence.
///
/// # Errors
/// The knowledge base lacks a table or a row.
pub fn find(
    workpiece: &Workpiece,
    objective: Objective,
    knowledge: &Knowledge,
) -> Result<Option<Ways>, KnowledgeError> {
    match &workpiece.shaft {
        Some(shaft) => of_shaft(shaft, workpiece, objective, knowledge).map(Some),
        None => Ok(None),
    }
}

fn of_shaft(
    shaft: &Shaft,
    workpiece: &Workpiece,
    objective: Objective,
    knowledge: &Knowledge,
) -> Result<Ways, KnowledgeError> {
    let sequences = passes::find(shaft, objective, knowledge)?;
    let schemes = schemes::find(workpiece, shaft, knowledge)?;
    let question = PassDirectionFor { blank_shape: BlankShape::of(shaft.blank.kind), holding: workpiece.holding };
    let asked = knowledge.ask(&question)?;
    let allowed = asked.need(workpiece.holding.name())?.direction;
    let pass_direction = Because::answer(&asked.answer, Note::new(code(allowed)));
    let operation = operation::plan(workpiece, knowledge)?;
    let wrong = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    // A shaft without a lathe is a question about its ways; what its operation lacks is told and does not spoil the answer.
    let severity = |finding: &Finding| if workpiece.machine.is_some() { finding.severity } else { Severity::Doubtful };
    let operation_findings = wrong.map(|one| Finding { severity: severity(one), ..one.clone() }).collect();
    let mut ways = Ways {
        shaft: workpiece.name.clone(),
        material: workpiece.material.clone(),
        machine: workpiece.machine.clone(),
        material_state: workpiece.material_state,
        holding: workpiece.holding,
        sequences,
        schemes,
        ways: Vec::new(),
        pass_direction,
        recommended: None,
        operation_findings,
        operation,
    };
    let findings = ways.schemes.findings.clone();
    ways.sequences.findings.extend(findings);
    if ways.schemes.schemes.is_empty() {
        return Ok(ways);
    }
    if allowed == Passes::Contour {
        ways.sequences.findings.push(Finding::of_part(Severity::Doubtful, Note::new("contour-passes-elsewhere")));
    }
    let all = (5..).zip(&ways.sequences.variants).map(|(preference, one)| of_variant(one, preference, allowed));
    let mut all: Vec<Way> = all.chain(ways.schemes.schemes.iter().map(of_scheme)).collect();
    for way in &mut all {
        if way.refused.is_none()
            && let Some(operation) = ways.operation_by(way.name)
        {
            let faults = by_way::faults(&ways.operation, &operation);
            way.refused = faults.damage.map(|why| Note::new("way-by-proof").with("why", why));
            way.leaves = faults.leaves;
        }
    }
    ways.ways = all;
    ways.recommended = Some(ways.recommend());
    Ok(ways)
}

impl Ways {
    /// Whether something is wrong with the operation of the shaft.
    pub fn is_wrong(&self) -> bool {
        self.operation_findings.iter().any(|finding| finding.severity <= Severity::Wrong)
    }

    /// The toolpath of a way, by name; a cut to the axis goes on by `beyond`, one along the last cylinder by the
    /// approach, so that the round of the nose is not left at its end.
    pub fn toolpath(&self, name: &str, distances: &Rates, beyond: Half) -> Option<Toolpath> {
        let shaft = &self.sequences.shaft;
        let approach = Half::of(distances.approach);
        let mut path = match self.sequences.variants.iter().find(|variant| variant.name == name) {
            Some(variant) => {
                let bar = Half::radius_of(shaft.blank.diameter);
                passes::toolpath::toolpath(&variant.drawn, bar, distances, beyond)
            }
            None => {
                let (_, scheme) = Scheme::NAMES.iter().find(|(known, _)| *known == name)?;
                let retract = Half::of(distances.retract);
                schemes::path::toolpath(&removal::path(*scheme, &self.schemes.splitting.levels, approach, retract))
            }
        };
        let z = shaft.steps.iter().map(|step| Half::of(step.length)).sum();
        let radius = Half::radius_of(shaft.steps.last()?.diameter);
        run_on(&mut path, Point { radius, z }, approach);
        Some(path)
    }

    /// The operation of the shaft with a way, by name, as its roughing; none if the operation has no tool for roughing.
    pub fn operation_by(&self, name: &str) -> Option<Operation> {
        by_way::by_way(self, name)
    }

    /// The quickest of the ways that hold, those that leave no metal standing before the others.
    fn recommend(&self) -> Recommended {
        let hold = || self.ways.iter().filter(|way| way.refused.is_none());
        let clean: Vec<&Way> = hold().filter(|way| way.leaves.is_none()).collect();
        let mut order = if clean.is_empty() { hold().collect() } else { clean };
        order.sort_by(|a, b| a.time_min.0.total_cmp(&b.time_min.0).then(a.preference.cmp(&b.preference)));
        let (best, next) = (order.first(), order.get(1));
        let margin = best.zip(next).map_or(0.0, |(best, next)| next.time_min.0 - best.time_min.0);
        let percent = next.map_or(0.0, |next| margin / next.time_min.0 * 100.0);
        let code = match (best, next) {
            (None, _) => "way-none",
            (_, None) => "way-only",
            _ if margin > 0.0 => "way-quickest",
            _ => "way-as-quick",
        };
        let named = |note: Note, key: &'static str, way: Option<&&Way>| match way {
            Some(way) => note.with(key, Figure::word(way.name)),
            None => note,
        };
        let note = named(named(Note::new(code), "variant", best), "rival", next);
        let note = match best {
            Some(best) => note.with("time", round_to(best.time_min.0, 3)).with("length", best.cutting_path_mm),
            None => note,
        };
        let note = note.with("margin", round_to(margin, 4)).with("percent", round_to(percent, 1));
        Recommended {
            variant: best.map(|way| way.name),
            next: next.map(|way| way.name),
            margin_min: Minutes(round_to(margin, 4)),
            margin_percent: round_to(percent, 2),
            because: Because { note, ..self.pass_direction.clone() },
        }
    }
}

/// Lets cuts along the last cylinder, and those up the face behind it, go on past its end.
fn run_on(path: &mut Toolpath, end: Point, by: Half) {
    let (mut before, mut runs) = (path.from, false);
    for one in &mut path.moves {
        let along = one.to == end && before.radius == end.radius;
        runs = one.purpose != Purpose::Rapid && one.to.z == end.z && (along || runs);
        before = one.to;
        if runs {
            one.to.z = one.to.z + by;
        }
    }
}

const fn code(allowed: Passes) -> &'static str {
    match allowed {
        Passes::Lengthwise => "take-lengthwise",
        Passes::Searched => "take-searched",
        Passes::Contour => "take-contour",
    }
}

/// A sequence of passes. Its passes take a full cylinder, along or across.
fn of_variant(variant: &Variant, preference: i64, allowed: Passes) -> Way {
    let across = variant.passes.iter().filter(|pass| pass.kind == PassDirection::Transverse).count();
    let refused = match allowed {
        Passes::Lengthwise if across > 0 => Some(Note::new("way-across")),
        Passes::Contour => Some(Note::new("way-full-cylinder")),
        Passes::Lengthwise | Passes::Searched => None,
    };
    Way {
        name: variant.name,
        cutting_path_mm: variant.cutting_path_mm,
        passes: variant.passes.len(),
        transverse_passes: across,
        time_min: variant.time_min,
        refused,
        leaves: None,
        preference,
    }
}

/// A removal scheme. Its passes run along the axis, under each diameter of the blank.
fn of_scheme(scheme: &SchemeEntry) -> Way {
    Way {
        name: scheme.name,
        cutting_path_mm: scheme.measures.cutting_mm,
        passes: scheme.measures.passes,
        transverse_passes: 0,
        time_min: scheme.measures.time_min,
        refused: None,
        leaves: None,
        preference: scheme.preference,
    }
}
