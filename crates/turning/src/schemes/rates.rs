//! How fast the tool moves, where the shaft file says nothing: rows of the table `turning-motion`.

use crate::error::KnowledgeError;
use crate::knowledge::{Input, Knowledge, RowRef};
use crate::note::{Finding, doubtful_row};
use crate::turning::shaft::{Rates, Shaft};
use crate::units::{MillimetresPerMinute, Unit};

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
    let table = knowledge.table("turning-motion")?;
    let mut findings = Vec::new();
    let mut of = |name: &str| -> Result<RowRef<'_>, KnowledgeError> {
        let answer = table.decide(&[("quantity", Input::Text(name))])?;
        let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(table, name))?;
        findings.extend(doubtful_row(row));
        Ok(row)
    };
    let rates = Rates {
        longitudinal_feed: MillimetresPerMinute(of("longitudinal-feed")?.number_in("rate", Unit::MillimetrePerMinute)?),
        transverse_feed: MillimetresPerMinute(of("transverse-feed")?.number_in("rate", Unit::MillimetrePerMinute)?),
        rapid: MillimetresPerMinute(of("rapid")?.number_in("rate", Unit::MillimetrePerMinute)?),
        approach: of("approach")?.length("distance")?,
        retract: of("retract")?.length("distance")?,
    };
    Ok((rates, findings))
}
