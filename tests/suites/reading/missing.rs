//! Where a key is missing the message says what to add: with that, word for word, the file is read.

use technolog::knowledge::yaml::{Node, NodeKind, parse};
use technolog::part::read_part;
use technolog::turning::shaft::Mistake;
use technolog::turning::workpiece::read_turned;
use technolog::words::Lang;
use technolog_testing::KNOWLEDGE;

const PART: &str = "part: P\nmaterial: {grade: steel-45, hardness: 200}\nmachine: gf2171\nblank: {kind: plate, length: 400, width: 200, thickness: 40}\nholes: [{name: A, diameter: {nominal: 10, upper: 0.1, lower: 0}, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, pattern: {grid: {start: [0, 0], columns: 2, rows: 1, step: 30}}}, {name: B, diameter: 10, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, pattern: {circle: {centre: [0, 0], diameter: 100, count: 3}}}]\n";
const SHAFT: &str = "shaft: S\nmaterial: steel-45\nblank: {kind: bar, diameter: 65, length: 34}\nsteps: [{diameter: 40, length: 16}, {diameter: 50, length: 18}]\nroughing: {longitudinal_depth: 4, transverse_depth: 3.5}\nrates: {longitudinal_feed: 180, transverse_feed: 150, rapid: 6000}\n";
const TURNED: &str = "shaft: S\nmaterial: steel-45\nblank: {kind: bar, diameter: 65, length: 62}\nouter: [{from: {d: 40, z: 0}}, {cylinder: -60}]\nallowances: {method: table}\nrates: {longitudinal_feed: 180, transverse_feed: 150, rapid: 6000}\n";

/// What is said of a file: that a key is missing, with what to add, and everything else.
fn missing_and_others(text: &str, turned: bool) -> (Vec<String>, Vec<String>) {
    let problems = if turned {
        let mistakes = read_turned("f", text, &KNOWLEDGE).err().unwrap_or_default();
        let form = |mistake| match mistake {
            Mistake::Form(problem) => Some(problem),
            Mistake::Meaning(..) => None,
        };
        mistakes.into_iter().filter_map(form).collect()
    } else {
        read_part("f", text, &KNOWLEDGE).err().unwrap_or_default()
    };
    let texts = problems.iter().map(|problem| problem.text(|note| Lang::EN.say(note)));
    texts.partition(|problem| problem.contains("[missing-key]"))
}

/// A node as one line, without the entry of a path of keys and numbers, or with another text there.
fn written(node: &Node, path: &[usize], instead: &str) -> String {
    let item = |at: usize, node: &Node| {
        let rest = path.split_first().filter(|(first, _)| **first == at).map(|(_, rest)| rest);
        match rest {
            Some([]) => (Some(instead.to_owned()).filter(|text| !text.is_empty()), true),
            Some(rest) => (Some(written(node, rest, instead)), false),
            None => (Some(written(node, &[], "")), false),
        }
    };
    match &node.kind {
        NodeKind::Scalar { text, .. } => text.clone(),
        NodeKind::Seq(items) => {
            let items: Vec<String> = items.iter().enumerate().filter_map(|(at, node)| item(at, node).0).collect();
            format!("[{}]", items.join(", "))
        }
        NodeKind::Map(entries) => {
            let entries = entries.iter().enumerate().filter_map(|(at, (key, node))| match item(at, node) {
                (entry, true) => entry,
                (entry, false) => entry.map(|value| format!("{}: {value}", key.text)),
            });
            format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
        }
    }
}

/// The paths of all entries of mappings.
fn paths(node: &Node) -> Vec<Vec<usize>> {
    let children: Vec<(&Node, bool)> = match &node.kind {
        NodeKind::Scalar { .. } => Vec::new(),
        NodeKind::Seq(items) => items.iter().map(|node| (node, false)).collect(),
        NodeKind::Map(entries) => entries.iter().map(|(_, node)| (node, true)).collect(),
    };
    let of_child = |(at, (node, entry)): (usize, (&Node, bool))| {
        let below = paths(node).into_iter().map(move |path| [vec![at], path].concat());
        entry.then(|| vec![at]).into_iter().chain(below).collect::<Vec<_>>()
    };
    children.into_iter().enumerate().flat_map(of_child).collect()
}

#[test]
fn what_is_to_be_added_makes_the_file_good() {
    let mut tried = 0;
    for (text, turned) in [(PART, false), (SHAFT, true), (TURNED, true)] {
        assert_eq!(missing_and_others(text, turned), (vec![], vec![]), "{text}");
        let root = parse("f", text).0.unwrap();
        for path in paths(&root) {
            let (missing, _) = missing_and_others(&written(&root, &path, ""), turned);
            let [problem] = missing.as_slice() else { continue };
            let example = problem.rsplit_once("for example `").and_then(|(_, rest)| rest.strip_suffix('`'));
            // Where one of two keys is wanted both are named.
            let Some(example) = example else {
                assert!(problem.contains("`depth: "), "{problem}");
                continue;
            };
            let mended = written(&root, &path, example);
            let (missing, other) = missing_and_others(&mended, turned);
            let formal = |text: &String| ["[bad-", "[unknown-"].iter().any(|code| text.contains(code));
            assert!(missing.is_empty() && !other.iter().any(formal), "{problem}: {mended}: {missing:?} {other:?}");
            tried += 1;
        }
    }
    assert!(tried > 35, "{tried}");
}
