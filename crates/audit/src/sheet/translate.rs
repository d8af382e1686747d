//! Keys of a plan by hand in another language: `маршрут`, `перехід`, `подача`. They are renamed where they stand, so that every other
//! reader knows one set of keys.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::{Key, Node, NodeKind};

use super::columns::{Column, Of};
use super::{entry, map};

/// The tree of a plan with the keys of the format. Keys of the format itself are left as they are.
pub(crate) fn keys(root: &mut Node) {
    rename(root, Of::Plan);
}

fn rename(node: &mut Node, of: Of) {
    let place = node.place.clone();
    let NodeKind::Map(entries) = &mut node.kind else { return };
    let columns = of.columns();
    gather(entries, of, &columns, &place);
    for (key, value) in entries {
        if !key.text.is_ascii() {
            let called: Vec<&Column> = columns.iter().filter(|column| is_called(**column, &key.text)).collect();
            let named = called.iter().find(|column| column.is_named(&key.text)).copied();
            let only = if let [only] = called.as_slice() { Some(*only) } else { named };
            if let Some(column) = only {
                key.text = column.key.to_owned();
            }
        }
        match (of, key.text.as_str()) {
            (Of::Plan, "route") => items(value, Of::Row),
            (Of::Plan, "tools") => values(value, Of::Tool),
            (Of::Plan, "conditions") => items(value, Of::Conditions),
            (Of::Plan, "clamping") => rename(value, Of::Clamping),
            (Of::Plan, "program") => rename(value, Of::Program),
            (Of::Plan, "times") => rename(value, Of::Times),
            (Of::Tool, "holder") => rename(value, Of::Holder),
            (Of::Conditions, "card") => rename(value, Of::Card),
            (Of::Conditions, "factors") => rename(value, Of::Factors),
            _ => {}
        }
    }
}

/// Keys of a holder or a card that stand in the mapping around it, as the columns of a table do, go into one of their own.
fn gather(entries: &mut Vec<(Key, Node)>, of: Of, columns: &[Column], place: &Place) {
    let (inner, name) = match of {
        Of::Tool => (Of::Holder, "holder"),
        Of::Conditions => (Of::Card, "card"),
        _ => return,
    };
    let inner = inner.columns();
    // `holder: T1` is the holder of another tool, anything else its number.
    let is_place = |text: &str| text.trim_start_matches(['T', 'Т']).parse::<u32>().is_ok_and(|number| number < 1000);
    let is_inner = |(key, value): &(Key, Node)| {
        let called = |columns: &[Column]| columns.iter().any(|column| column.is_called(&key.text, true));
        let outer = columns.iter().find(|column| column.is_called(&key.text, true));
        let is_number =
            || outer.is_some_and(|outer| outer.key == name) && value.text().is_some_and(|own| !is_place(own));
        !key.text.is_ascii() && (outer.is_none() && called(&inner) || is_number())
    };
    if entries.iter().any(is_inner) && !entries.iter().any(|(key, _)| key.text == name) {
        let (mut own, rest): (Vec<_>, Vec<_>) = std::mem::take(entries).into_iter().partition(is_inner);
        for (key, _) in &mut own {
            if columns.iter().any(|column| column.key == name && column.is_called(&key.text, true)) {
                key.text = "designation".to_owned();
            }
        }
        *entries = rest;
        entries.push(entry(name, map(own, place)));
    }
}

/// By its own names; in the mapping of a holder or a card its key is enough, `довжина`.
fn is_called(column: Column, name: &str) -> bool {
    let bare = Column { of: Of::Row, key: column.key };
    column.is_called(name, true)
        || matches!(column.of, Of::Holder | Of::Card | Of::Factors) && bare.is_called(name, true)
}

fn items(node: &mut Node, of: Of) {
    if let NodeKind::Seq(items) = &mut node.kind {
        items.iter_mut().for_each(|item| rename(item, of));
    }
}

fn values(node: &mut Node, of: Of) {
    if let NodeKind::Map(entries) = &mut node.kind {
        entries.iter_mut().for_each(|(_, value)| rename(value, of));
    }
}
