//! The contract between a table and its row type, on two small tables.

#![allow(dead_code, reason = "a field is read by the test or by nobody")]

use crate::contract::Word;
use crate::lint::contracts;
use crate::units::{Micrometres, Newtons};
use crate::{Knowledge, SourceFile, TableRow};

crate::vocabulary! {
    /// The state of a face before the cut.
    pub enum Entry {
        /// Machined before.
        Machined = "machined",
        /// As cast or rolled.
        Rough = "rough",
    }
}

crate::rows! {
    /// Approach and overrun of a tool.
    pub struct Approach of One("approach") asked by ApproachFor { entry: Entry, through: bool } {
        overrun: Micrometres,
    }
    /// A screw of a clamp.
    pub struct ClampScrew of One("clamp-screws") complete entry {
        entry: Entry,
        safe_distance: Option<Micrometres>,
        force: Newtons,
    } shown { thread }
}

const APPROACH: &str = r#"table: approach
title: {uk: т, en: t}
kind: decision
place: test
columns:
  - {name: entry, type: enum, values: [machined, rough], role: input}
  - {name: through, type: bool, role: input}
  - {name: overrun, type: length, unit: mm, role: output}
rows:
  - {entry: rough, through: "-", overrun: 3, source: seed}
"#;

const SCREWS: &str = r#"table: clamp-screws
title: {uk: т, en: t}
kind: catalog
place: test
key: [thread]
columns:
  - {name: thread, type: text}
  - {name: entry, type: text}
  - {name: safe_distance, type: length, unit: mm, optional: true}
  - {name: force, type: number, unit: N}
rows:
  - {thread: M8, entry: machined, force: 100, source: seed}
  - {thread: M10, entry: rough, safe_distance: 40, force: 200, source: seed}
"#;

fn read(approach: &str, screws: &str) -> Knowledge {
    let file = |path, text| SourceFile { path, text };
    Knowledge::from_sources(&[file("approach.yaml", approach), file("screws.yaml", screws)]).unwrap()
}

#[test]
fn a_row_is_a_value_and_a_question_is_typed() {
    let knowledge = read(APPROACH, SCREWS);
    assert_eq!(contracts::check(&knowledge, CONTRACTS), []);
    let answer = knowledge.ask(&ApproachFor { entry: Entry::Rough, through: true }).unwrap();
    assert_eq!(answer.need("this face").unwrap().overrun, Micrometres::new(3000));
    let none = knowledge.ask(&ApproachFor { entry: Entry::Machined, through: true }).unwrap();
    assert!(none.winner().unwrap().is_none());
    let screws: Vec<ClampScrew<'_>> = knowledge.rows().unwrap();
    assert_eq!(screws[0].safe_distance, None);
    assert_eq!((screws[1].entry, screws[1].force), (Entry::Rough, Newtons(200.0)));
    assert!(ClampScrew::CONTRACT.fields[1].shape.optional);
    assert_eq!(Entry::from_word("polished"), None);
}

#[test]
fn a_table_that_is_not_what_the_code_reads_is_named_with_its_place() {
    let thread = [("name: thread", "name: threat"), ("[thread]", "[threat]"), ("{thread:", "{threat:")];
    type Case<'a> = (&'a str, &'a [(&'a str, &'a str)], &'a str, &'a str);
    let cases: [Case<'_>; 11] = [
        (APPROACH, &[("overrun", "overran")], "missing-column", "6:1"),
        (APPROACH, &[("name: overrun, type: length", "name: overrun, type: number")], "broken-contract", "8:5"),
        (APPROACH, &[("[machined, rough]", "[machined, rough, cast]")], "broken-contract", "6:5"),
        (
            APPROACH,
            &[("type: bool, role: input", "type: bool, role: output"), ("\"-\"", "true")],
            "broken-contract",
            "7:5",
        ),
        (SCREWS, &[("unit: N}", "unit: kW}")], "broken-contract", "10:5"),
        (SCREWS, &[("unit: N}", "unit: N, optional: true}")], "broken-contract", "10:5"),
        (
            SCREWS,
            &[("unit: N}", "unit: N, list: true}"), ("100", "[100]"), ("200", "[200]")],
            "broken-contract",
            "10:5",
        ),
        (SCREWS, &[("entry: machined", "entry: polished")], "broken-contract", "8:5"),
        (SCREWS, &[("entry: machined", "entry: rough")], "missing-row", "8:5"),
        (
            SCREWS,
            &[("  - {name: force", "  - {name: colour, type: text, optional: true}\n  - {name: force")],
            "unread-column",
            "10:5",
        ),
        (SCREWS, &thread, "missing-column", "7:1"),
    ];
    for (of, edits, code, place) in cases {
        let changed = edits.iter().fold(of.to_owned(), |text, (from, to)| text.replace(from, to));
        let knowledge = if of == APPROACH { read(&changed, SCREWS) } else { read(APPROACH, &changed) };
        let findings = contracts::check(&knowledge, CONTRACTS);
        let found = findings.iter().any(|finding| {
            let at = finding.place.as_ref().map(ToString::to_string).unwrap_or_default();
            finding.code == code && at.ends_with(&format!(":{place}"))
        });
        assert!(found, "{edits:?}: {findings:?}");
    }
}

#[test]
fn a_table_that_is_asked_and_absent_is_named() {
    let only = Knowledge::from_sources(&[SourceFile { path: "approach.yaml", text: APPROACH }]).unwrap();
    let findings = contracts::check(&only, CONTRACTS);
    assert_eq!(findings.iter().map(|finding| finding.code).collect::<Vec<_>>(), ["absent-table"]);
    assert!(technolog_words::Lang::EN.say(&findings[0].message).contains("clamp-screws"));
}

/// Names of which code reads some.
mod names {
    use crate::contract::{Named, Use};
    use crate::lint::contracts;
    use crate::{Knowledge, SourceFile};

    crate::vocabulary! {
        /// A constant that code reads.
        pub enum Constant {
            /// Of one face on another.
            Friction = "friction",
        }
    }

    crate::rows! {
        /// A constant.
        pub struct ConstantRow of One("constants") complete name {
            name: Named<'t, Constant>,
            use_ as "use": Use,
        } shown { value }
    }

    const CONSTANTS: &str = r#"table: constants
title: {uk: т, en: t}
kind: catalog
place: test
key: [name]
columns:
  - {name: name, type: text}
  - {name: value, type: number, unit: "1"}
  - {name: use, type: enum, values: [planning, documentation]}
rows:
  - {name: friction, value: 0.25, use: planning, source: seed}
  - {name: mass, value: 2, use: documentation, source: seed}
"#;

    fn read(text: &str) -> Knowledge {
        Knowledge::from_sources(&[SourceFile { path: "constants.yaml", text }]).unwrap()
    }

    #[test]
    fn what_a_named_row_is_for_is_what_code_reads() {
        let knowledge = read(CONSTANTS);
        assert_eq!(contracts::check(&knowledge, CONTRACTS), []);
        let rows: Vec<ConstantRow<'_>> = knowledge.rows().unwrap();
        assert!(rows[0].name.is(Constant::Friction) && rows[1].name == Named::Other("mass"));
        assert_eq!(contracts::for_people(knowledge.table("constants").unwrap(), CONTRACTS[0]), ["mass"]);
        for (from, to, code, named) in [
            ("use: documentation", "use: planning", "wrong-use", "`mass`"),
            ("use: planning", "use: documentation", "wrong-use", "`friction`"),
            ("name: friction", "name: fricton", "missing-row", "`friction`"),
        ] {
            let findings = contracts::check(&read(&CONSTANTS.replace(from, to)), CONTRACTS);
            let found = findings
                .iter()
                .any(|finding| finding.code == code && technolog_words::Lang::EN.say(&finding.message).contains(named));
            assert!(found, "{to}: {findings:?}");
        }
    }
}
