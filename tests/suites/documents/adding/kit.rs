//! The Rust of the recipe for a page. The block of the page stands here as it is.

use technolog::document::{Column, Document, Table};
use technolog::plan::Plan;
use technolog::report::Lang;

/// What the store brings to the machine.
pub fn page(plan: &Plan, lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), plan.part.part.as_str());
    let head = ["cli-tool", "plan-cutter", "plan-holder"].map(|key| Column::text(lang.word(key)));
    let mut table = Table::new(head);
    for tool in &plan.tools {
        table.row([format!("T{}", tool.number), tool.designation.clone(), tool.holder.clone()]);
    }
    page.push(table);
    page
}
