//! Merges the head of a file into each of its cases: the values of a case have priority.

use std::collections::BTreeMap;

use crate::knowledge::yaml::{Node, NodeKind};

/// A mapping with the missing keys of another; mappings inside both are merged in the same way.
pub fn over(own: &Node, head: &Node) -> Node {
    let (NodeKind::Map(own_entries), NodeKind::Map(head_entries)) = (&own.kind, &head.kind) else { return own.clone() };
    let mut entries = own_entries.clone();
    let places: BTreeMap<&str, usize> =
        own_entries.iter().enumerate().map(|(place, (key, _))| (key.text.as_str(), place)).collect();
    for (key, inherited) in head_entries {
        match places.get(key.text.as_str()) {
            Some(&place) => entries[place].1 = over(&own_entries[place].1, inherited),
            None => entries.push((key.clone(), inherited.clone())),
        }
    }
    Node { kind: NodeKind::Map(entries), place: own.place.clone() }
}

/// A mapping without some keys.
pub fn without(node: &Node, keys: &[&str]) -> Node {
    let NodeKind::Map(entries) = &node.kind else { return node.clone() };
    let entries = entries.iter().filter(|(key, _)| !keys.contains(&key.text.as_str())).cloned().collect();
    Node { kind: NodeKind::Map(entries), place: node.place.clone() }
}
