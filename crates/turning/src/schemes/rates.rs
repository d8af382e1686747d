//! The rates of the tool if the shaft file gives none: rows of the table `turning-motion`.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, doubtful_row};
use crate::tables::turning::passes::{Motion, TurningMotion, TurningMotionFor};
use crate::turning::shaft::{Rates, Shaft};
use crate::units::{Micrometres, MillimetresPerMinute};
use technolog_note::note;

/// The rates of a shaft file, or those of the table with a finding for each row that is not confirmed.
///
/// # Errors
/// The knowledge base lacks the table or a row of it.
pub fn rates(shaft: &Shaft, knowledge: &Knowledge) -> Result<(Rates, Vec<Finding>), KnowledgeError> {
    match shaft.rates {
        Some(rates) => Ok((rates, Vec::new())),
        None => of_table(knowledge),
    }
}

/// The rates of the table with a finding for each row that is not confirmed.
///
/// # Errors
/// The knowledge base lacks the table or a row of it.
pub fn of_table(knowledge: &Knowledge) -> Result<(Rates, Vec<Finding>), KnowledgeError> {
    let mut findings = Vec::new();
    let mut of = |quantity: Motion| -> Result<TurningMotion<'_>, KnowledgeError> {
        let rule = knowledge.ask(&TurningMotionFor { quantity })?.need(quantity.name())?;
        findings.extend(doubtful_row(rule.row));
        Ok(rule)
    };
    let rates = Rates {
        longitudinal_feed: rate(&of(Motion::LongitudinalFeed)?)?,
        transverse_feed: rate(&of(Motion::TransverseFeed)?)?,
        rapid: rate(&of(Motion::Rapid)?)?,
        approach: distance(&of(Motion::Approach)?)?,
        retract: distance(&of(Motion::Retract)?)?,
    };
    Ok((rates, findings))
}

fn rate(rule: &TurningMotion<'_>) -> Result<MillimetresPerMinute, KnowledgeError> {
    rule.rate.ok_or_else(|| lacks(rule, "a rate"))
}

fn distance(rule: &TurningMotion<'_>) -> Result<Micrometres, KnowledgeError> {
    rule.distance.ok_or_else(|| lacks(rule, "a distance"))
}

fn lacks(rule: &TurningMotion<'_>, what: &str) -> KnowledgeError {
    KnowledgeError::missing(&rule.row.table.id, note!("turned-row-must-have", row = rule.row.number(), what = what))
}
