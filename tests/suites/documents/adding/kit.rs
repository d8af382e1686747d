//! The Rust of the recipe for a page. The block of the page stands here as it is.

use technolog::plan::{Plan, ToolPlan};
use technolog::report::{Lang, grid};

/// What the store brings to the machine.
pub fn page(plan: &Plan, lang: Lang) -> String {
    let head = [("Гніздо", "Place"), ("Інструмент", "Cutter"), ("Оправка", "Holder")];
    let head = head.map(|(uk, en)| lang.pick(uk, en).to_owned());
    let row = |tool: &ToolPlan| vec![format!("T{}", tool.number), tool.designation.clone(), tool.holder.clone()];
    grid::table(&head, &plan.tools.iter().map(row).collect::<Vec<_>>(), 2)
}
