//! A plan of the program as tables, to begin with and to change: what `write` makes of it, a table for each part of the plan.

use technolog_core::lang::Lang;
use technolog_core::words::operation_noun;
use technolog_sheets::{Row, Sheet};

use crate::knowledge::yaml::{Node, NodeKind, parse};
use crate::plan::Plan;

use super::super::write::by_hand;
use super::columns::{Column, Of};
use super::heads::titled;
use super::sections::{Kind, title};

/// The plan as tables, in the words of a language; `part` is the path of its part, relative to the place of the new file.
pub fn by_tables(plan: &Plan, part: &str, lang: Lang) -> Vec<Sheet> {
    let (Some(root), _) = parse("", &by_hand(plan, part)) else { return Vec::new() };
    let mut sheets = vec![lines(Kind::Plan, &root, lang)];
    for (kind, key) in Kind::NAMED.into_iter().filter(|(kind, _)| *kind != Kind::Plan) {
        let Some(node) = root.get(key) else { continue };
        sheets.push(match kind {
            Kind::Clamping | Kind::Program | Kind::Times => lines(kind, node, lang),
            _ => table(kind, node, lang),
        });
    }
    sheets
}

/// A name and a value in each row.
fn lines(kind: Kind, node: &Node, lang: Lang) -> Sheet {
    let of = kind.forms().first().copied().unwrap_or(Of::Plan);
    let columns = of
        .columns()
        .into_iter()
        .filter(|column| Kind::NAMED.iter().all(|(_, key)| *key != column.key || *key == "plan"));
    let rows = columns.filter_map(|column| {
        // Whose work it is, is left to be filled in.
        let own = matches!(column.key, "student" | "group" | "variant").then(String::new);
        let value = node.get(column.key).map(|value| cell(column, value, lang)).or(own)?;
        Some(vec![titled(column, lang), value])
    });
    sheet(kind, rows.collect(), lang)
}

/// A head, and a row for each item.
fn table(kind: Kind, node: &Node, lang: Lang) -> Sheet {
    let items: Vec<Vec<(Column, String)>> = match &node.kind {
        NodeKind::Seq(items) => items.iter().map(|item| cells(kind, item, lang)).collect(),
        NodeKind::Map(entries) => entries
            .iter()
            .map(|(key, item)| {
                let number = (Column { of: Of::Place, key: "tool" }, key.text.clone());
                std::iter::once(number).chain(cells(kind, item, lang)).collect()
            })
            .collect(),
        NodeKind::Scalar { .. } => Vec::new(),
    };
    let all = kind.forms().iter().flat_map(|of| of.columns());
    let used: Vec<Column> = all.filter(|column| items.iter().flatten().any(|(own, _)| own == column)).collect();
    let head = used.iter().map(|column| titled(*column, lang)).collect();
    let row = |item: &Vec<(Column, String)>| {
        let text = |column: &Column| {
            item.iter().find(|(own, _)| own == column).map_or_else(String::new, |(_, text)| text.clone())
        };
        used.iter().map(text).collect()
    };
    sheet(kind, std::iter::once(head).chain(items.iter().map(row)).collect(), lang)
}

fn cells(kind: Kind, item: &Node, lang: Lang) -> Vec<(Column, String)> {
    let NodeKind::Map(entries) = &item.kind else { return Vec::new() };
    let of = match kind {
        Kind::Route => Of::Row,
        Kind::Tools => Of::Tool,
        _ => Of::Conditions,
    };
    let mut found = Vec::new();
    for (key, node) in entries {
        let Some(column) = of.columns().into_iter().find(|column| column.key == key.text) else { continue };
        match &node.kind {
            NodeKind::Map(inner) if column.key == "holder" => {
                for (key, node) in inner {
                    let own = match key.text.as_str() {
                        "designation" => Some(column),
                        text => Of::Holder.columns().into_iter().find(|column| column.key == text),
                    };
                    found.extend(own.map(|own| (own, cell(own, node, lang))));
                }
            }
            _ => found.push((column, cell(column, node, lang))),
        }
    }
    found
}

/// A value as a cell: lists with semicolons, points apart by a stroke, operations by their names.
fn cell(column: Column, node: &Node, lang: Lang) -> String {
    let text = |node: &Node| node.text().unwrap_or_default().to_owned();
    let list = |node: &Node| match &node.kind {
        NodeKind::Seq(items) => items.iter().map(text).collect::<Vec<_>>().join("; "),
        _ => text(node),
    };
    match &node.kind {
        NodeKind::Seq(items) if column.key == "at" => items.iter().map(list).collect::<Vec<_>>().join(" / "),
        NodeKind::Seq(_) => list(node),
        _ if column.key == "operation" => operation_noun(&text(node), lang).to_owned(),
        _ if matches!(column.key, "cutting" | "scope") => {
            let own = text(node);
            lang.find(&format!("written-{own}")).map_or(own.clone(), str::to_owned)
        }
        _ => text(node),
    }
}

fn sheet(kind: Kind, rows: Vec<Vec<String>>, lang: Lang) -> Sheet {
    let rows = (1..).zip(rows).map(|(line, cells)| Row { line, cells }).collect();
    let name = title(kind, lang);
    let mut letters = name.chars();
    let name = letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default();
    Sheet { name, rows }
}
