//! The size limits of a file of cases; docs/limits.md lists them.

use technolog_note::note;

use crate::knowledge::yaml::{Key, MOST_VALUES, Node, NodeKind, Problems};

/// Cases of a file.
pub const MOST_CASES: usize = 5_000;
/// The most parts of a key such as `a.b`, each a key inside the one before.
pub const MOST_WORDS: usize = 16;

/// Whether a key is within the limit; a longer one is refused.
pub(super) fn segments(key: &Key, problems: &mut Problems) -> bool {
    let count = key.text.split('.').count();
    if count > MOST_WORDS {
        let message = note!("case-too-many-words", count = count, most = MOST_WORDS);
        problems.error_help::<()>("too-deep", message, &key.place, note!("case-write-keys-within"));
    }
    count <= MOST_WORDS
}

/// The cases up to the limit; a longer list is refused at its first extra item. None if the head would be too large
/// when it is read for every case.
pub(super) fn cases<'n>(tests: &'n [Node], head: &Node, problems: &mut Problems) -> &'n [Node] {
    if let Some(beyond) = tests.get(MOST_CASES) {
        let message = note!("case-too-many-cases", count = tests.len(), most = MOST_CASES);
        problems.error_help::<()>("too-many-cases", message, &beyond.place, note!("yaml-make-several-files"));
    }
    let tests = tests.get(..MOST_CASES).unwrap_or(tests);
    let all = values(head).saturating_mul(tests.len());
    if all > MOST_VALUES {
        let message = note!("case-head-too-large", count = all, most = MOST_VALUES);
        problems.error_help::<()>("too-many-values", message, &head.place, note!("case-write-in-the-cases"));
        return &[];
    }
    tests
}

/// The number of values in a tree, with keys.
fn values(node: &Node) -> usize {
    match &node.kind {
        NodeKind::Scalar { .. } => 1,
        NodeKind::Seq(items) => 1 + items.iter().map(values).sum::<usize>(),
        NodeKind::Map(entries) => 1 + entries.iter().map(|(_, node)| 1 + values(node)).sum::<usize>(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::knowledge::yaml::parse;

    /// How many cases are read, and the codes and places of what is wrong.
    fn read(head: &str, count: usize) -> (usize, Vec<String>) {
        let head = parse("t", head).0.unwrap();
        let tests = parse("t", &"- a\n".repeat(count)).0.unwrap();
        let NodeKind::Seq(tests) = &tests.kind else { panic!("no list") };
        let mut problems = Problems::default();
        let read = cases(tests, &head, &mut problems).len();
        let shown =
            |problem: &crate::knowledge::Diagnostic| format!("{} {}", problem.place.as_ref().unwrap(), problem.code);
        (read, problems.0.iter().map(shown).collect())
    }

    #[test]
    fn the_cases_are_bounded_and_what_their_head_makes_of_them() {
        assert_eq!(read("a: 1\n", MOST_CASES), (MOST_CASES, vec![]));
        assert_eq!(read("a: 1\n", MOST_CASES + 1), (MOST_CASES, vec!["t:5001:3 too-many-cases".to_owned()]));
        // With the list, its key and the mapping it has a thousand values.
        let head = format!("a: [{}]\n", "1, ".repeat(997));
        let most = MOST_VALUES / 1_000;
        assert_eq!(read(&head, most), (most, vec![]));
        assert_eq!(read(&head, most + 1), (0, vec!["t:1:1 too-many-values".to_owned()]));
    }
}
