//! The chains of dimensions as a table: what errs in each, and whether it closes.

use crate::document::{Column, Inlines, Table};
use crate::note::{Figure, Note};
use crate::part::Base;
use crate::plan::{Chain, ChainTerm};
use crate::units::Micrometres;

use super::{Lang, MARK, NONE, column};

/// The chains of a plan.
pub(super) fn table(chains: &[Chain], lang: Lang) -> Table {
    let mm = lang.word("unit-mm");
    let mut table = Table::new([
        Column::text(lang.word("plan-chain-hole")),
        Column::text(lang.word("plan-chain-axis")),
        Column::text(lang.word("plan-chain-from")),
        Column::text(lang.word("plan-chain-sum")),
        Column::number(lang.word("plan-chain-worst"), mm),
        Column::number(lang.word("plan-chain-likely"), mm),
        Column::number(lang.word("plan-chain-tolerance"), mm),
        Column::text(lang.word("plan-chain-closes")),
    ]);
    let worst = figures(chains.iter().map(|chain| chain.worst_mm).collect(), lang);
    let likely = figures(chains.iter().map(|chain| chain.likely_mm).collect(), lang);
    let tolerance = figures(chains.iter().map(|chain| Some(chain.tolerance_mm)).collect(), lang);
    let figures = worst.into_iter().zip(likely).zip(tolerance);
    for (chain, ((worst, likely), tolerance)) in chains.iter().zip(figures) {
        let from = match &chain.from {
            Base::Side(side) => lang.term("side", side.name()).to_owned(),
            Base::Hole(name) => name.clone(),
        };
        let terms = chain.terms.iter().map(|one| term(one, lang)).collect::<Vec<_>>().join("; ");
        let closing = chain.closing.map_or("open", |closing| closing.name());
        let closing = lang.term("chain-closing", closing).to_owned();
        let axis = chain.axis.letter().to_string();
        let texts = [chain.hole.clone(), axis, from, terms].map(Inlines::from);
        table.row(texts.into_iter().chain([worst, likely, tolerance, closing.into()]));
    }
    table.notes.push(lang.word("plan-chains-how").into());
    table
}

/// The figures of a column, where they are known.
fn figures(values: Vec<Option<Micrometres>>, lang: Lang) -> Vec<Inlines> {
    let known: Vec<Micrometres> = values.iter().map(|value| value.unwrap_or_default()).collect();
    let shown = column(&known, lang).into_iter().zip(values);
    shown.map(|(shown, value)| if value.is_some() { shown } else { NONE.into() }).collect()
}

/// A term: what errs, and how much.
fn term(term: &ChainTerm, lang: Lang) -> String {
    let field = Note::new("plan-chain-term")
        .with("what", Figure::word_of("chain-term", term.what.name()))
        .with("field", term.field_mm);
    format!("{}{}", lang.say(&field), if term.unconfirmed { MARK } else { "" })
}
