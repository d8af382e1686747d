//! Tests that a renamed, retyped or removed column of a table that code reads is always reported.

use technolog_knowledge::contract::Contract;
use technolog_knowledge::knowledge::Knowledge;
use technolog_knowledge::lint::contracts::hold;
use technolog_knowledge::table::Cell;
use technolog_knowledge::units::Unit;
use technolog_knowledge::{ColumnType, SourceFile, Table};
use technolog_shipped::SOURCES;

use super::cutters::lacking;
use super::{all, check};

fn shipped() -> Knowledge {
    Knowledge::from_sources(SOURCES).unwrap()
}

/// All shipped tables with the contracts of the code that reads them.
fn tables_with_contracts() -> Vec<(Table, &'static Contract)> {
    let contracts = all();
    let own = shipped().into_tables();
    own.filter_map(|table| {
        let contract = contracts.iter().find(|contract| contract.is_of(&table))?;
        Some((table, *contract))
    })
    .collect()
}

#[test]
fn the_shipped_tables_are_what_the_code_reads() {
    assert_eq!(check(&shipped()), []);
}

#[test]
fn every_table_has_one_contract() {
    let contracts = all();
    for table in shipped().tables() {
        let of: Vec<&str> =
            contracts.iter().filter(|contract| contract.is_of(table)).map(|contract| contract.row).collect();
        assert_eq!(of.len(), 1, "table {}: {of:?}", table.id);
    }
}

#[test]
fn every_renamed_column_is_found() {
    let mut renamed = 0;
    for (mut table, contract) in tables_with_contracts() {
        for index in 0..table.columns.len() {
            let name = std::mem::replace(&mut table.columns[index].name, "renamed_column".to_owned());
            let findings = hold(&table, contract);
            let found = |code: &str, about: &str| {
                findings.iter().any(|finding| {
                    finding.code == code
                        && technolog_words::Lang::EN.say(&finding.message).contains(&format!("`{about}`"))
                })
            };
            assert!(found("unread-column", "renamed_column"), "{}: {name} renamed", table.id);
            table.columns[index].name = name;
            renamed += 1;
        }
    }
    assert!(renamed > 1000, "only {renamed} columns");
}

#[test]
fn a_renamed_column_of_a_table_by_itself_is_missed_too() {
    for (mut table, contract) in
        tables_with_contracts().into_iter().filter(|(table, contract)| contract.which.id() == table.id)
    {
        for index in 0..table.columns.len() {
            let name = std::mem::replace(&mut table.columns[index].name, "renamed_column".to_owned());
            let findings = hold(&table, contract);
            let missed = findings.iter().any(|finding| {
                finding.code == "missing-column"
                    && technolog_words::Lang::EN.say(&finding.message).contains(&format!("`{name}`"))
            });
            assert!(missed, "{}: {name} renamed: {findings:?}", table.id);
            table.columns[index].name = name;
        }
    }
}

#[test]
fn every_column_of_another_type_or_unit_is_found_where_it_is_read() {
    for (mut table, contract) in tables_with_contracts() {
        for index in 0..table.columns.len() {
            let name = table.columns[index].name.clone();
            let read = contract.inputs.iter().chain(contract.fields).any(|column| column.name == name);
            if !read {
                continue;
            }
            let (ty, unit) = (table.columns[index].ty, table.columns[index].unit);
            let other = if ty == ColumnType::Bool { ColumnType::Int } else { ColumnType::Bool };
            table.columns[index].ty = other;
            assert_ne!(hold(&table, contract), [], "{}: {name} as {}", table.id, other.name());
            table.columns[index].ty = ty;
            if matches!(ty, ColumnType::Number) {
                table.columns[index].unit = if unit == Unit::Kilogram { Unit::Newton } else { Unit::Kilogram };
                assert_ne!(hold(&table, contract), [], "{}: {name} in another unit", table.id);
                table.columns[index].unit = unit;
            }
        }
    }
}

/// The shipped sources with one file changed.
fn changed(path: &str, change: impl Fn(&str) -> String) -> Knowledge {
    let files: Vec<(String, String)> = SOURCES
        .iter()
        .map(|file| (file.path.to_owned(), if file.path == path { change(file.text) } else { file.text.to_owned() }))
        .collect();
    let files: Vec<SourceFile<'_>> = files.iter().map(|(path, text)| SourceFile { path, text }).collect();
    Knowledge::from_sources(&files).unwrap()
}

/// The codes and messages of what is found.
fn found(knowledge: &Knowledge) -> Vec<String> {
    check(knowledge)
        .into_iter()
        .map(|finding| format!("{}: {}", finding.code, technolog_words::Lang::EN.say(&finding.message)))
        .collect()
}

#[test]
fn a_record_that_does_not_say_what_it_is_of_is_found() {
    let knowledge = changed("catalogs/machines/gf2171.yaml", |text| {
        text.replace("laws:\n  - {law: record, schema: machine-quantities}\n", "")
    });
    assert_eq!(found(&knowledge), ["no-record: table machine-gf2171: it has no law `record`, so nothing reads it"]);
}

#[test]
fn a_table_that_is_none_of_cutters_is_found_where_the_rule_names_it() {
    let path = "catalogs/tools/drills-small-cylindrical.yaml";
    let knowledge = changed(path, |text| {
        let tool = text.lines().find(|line| line.starts_with("tool:")).unwrap();
        text.replace(&format!("{tool}\n"), "")
    });
    assert_eq!(
        found(&knowledge),
        ["no-cutters: table tool-tables, row 2: drills-small-cylindrical is not a table of cutters"]
    );
}

#[test]
fn a_cutter_that_lacks_what_planning_asks_is_found() {
    for (path, column, lack) in [
        ("a11-drills-cylindrical-shank", "flute_length", "without `reach`, `flute_length`"),
        ("a11-drills-cylindrical-shank", "designation", "without `designation`"),
        ("a12-drills-morse-shank", "diameter", "without `diameter`"),
        ("a12-drills-morse-shank", "morse", "without `morse`, and"),
        ("a13-step-drills-screw-head-cylindrical-shank", "step_length", "without `step_diameter` and"),
        ("a19-core-drills-shell", "bore", "without `bore` and"),
        ("a21-countersinks-conical", "cone_angle", "without `cone_angle` and"),
        ("boring-bars", "bar_diameter", "without `diameter_min`"),
        ("taps-machine", "shank_diameter", "without `thread`, `shank_diameter`"),
    ] {
        let mut table =
            shipped().into_tables().find(|table| table.file == format!("catalogs/tools/{path}.yaml")).unwrap();
        let index = table.column_index(column).unwrap();
        table.rows[0].cells[index] = Cell::Empty;
        let findings = lacking(&table, table.tool.as_ref().unwrap());
        assert!(
            findings.iter().any(|finding| technolog_words::Lang::EN.say(&finding.message).contains(lack)),
            "{path} {column}: {findings:?}"
        );
    }
}
