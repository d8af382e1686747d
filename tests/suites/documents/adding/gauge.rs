//! The Rust of the recipe for a rule. The blocks of the page stand here as they are.

use technolog::error::KnowledgeError;
use technolog::knowledge::{Knowledge, rows, vocabulary};
use technolog::note::{Because, Note};
use technolog::plan::HolePlan;
use technolog::units::{ItGrade, Micrometres};

vocabulary! {
    /// What a hole is measured with.
    pub enum Gauge {
        Calliper = "calliper",
        Plug = "plug-gauge",
        Bore = "bore-gauge",
    }
}

rows! {
    /// What a hole is measured with.
    pub struct HoleGauge of One("hole-gauge") asked by HoleGaugeFor {
        it: ItGrade,
        diameter: Micrometres,
    } {
        gauge: Gauge,
    }
}

/// The last transition of a group of holes says with what they are measured.
pub fn measured(hole: &mut HolePlan, it: ItGrade, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
    let Some(last) = hole.transitions.last_mut() else { return Ok(()) };
    let answer = knowledge.ask(&HoleGaugeFor { it, diameter: last.diameter_mm })?;
    let gauge = answer.need("this hole")?.gauge;
    last.because.push(Because::answer(&answer.answer, Note::new("hole-gauge").with("gauge", gauge.name())));
    Ok(())
}
