//! Carries out `docs/adding.md` as written: each recipe in its own copy of `catalogs/` and `rules/`, block by block.
//! Every answer on the page must come from the program; nothing new may collide with the shipped tables; no file may
//! change except those that the recipe lists; at the end `lint` must be clean, and the addition must show where the
//! page says so.
//!
//! The head of the page explains what a block is for. Code is not carried out: the files and names on the page must
//! exist, and its blocks of Rust are also in files of this folder, which compile and run.

mod bench;
mod gauge;
mod kit;
mod page;

use std::collections::BTreeSet;
use std::fs;
use std::sync::LazyLock;

use technolog::knowledge::lint::contracts::hold;
use technolog::knowledge::lint::lint;
use technolog::knowledge::{Knowledge, Source, Table, TableRow};
use technolog::part::read_part;
use technolog::plan::{CuttingMethod, Plan};
use technolog::report::{Doubts, Lang, explain, sheet};
use technolog::{planner, shipped};

use technolog_testing::pages::shown;
use technolog_testing::root;

use bench::Bench;
use page::{Block, Doing, PAGE, blocks, files, quoted, titles};

const OWN_TEXT: &str = include_str!("adding.rs");

/// The page of what is known of every table.
const PROVENANCE: &str = "docs/provenance.md";

/// Carries out a recipe; `shows` is what an answer of a command that is no question to a table shows of it.
fn recipe(title: &str, shows: &str) -> Knowledge {
    let mut bench = Bench::new(title);
    let blocks = blocks(title);
    blocks.iter().for_each(|block| bench.carry_out(block));

    assert!(bench.tried.is_empty(), "{title}: nobody looks at what is tried last");

    let uses = |block: &&Block| {
        let command = block.lines[0].split(' ').nth(2).unwrap_or_default();
        block.doing == Doing::Answer && ["plan", "turn", "check", "program"].contains(&command)
    };
    let shown = blocks.iter().filter(uses).any(|block| block.text().contains(shows));
    assert!(shown || shows.is_empty(), "{title}: no answer shows `{shows}`");

    let own = bench.knowledge();
    assert_eq!(lint(&own), [], "{title}");
    holds_its_tables(title, &bench, &own);
    assert!(sheet_of(&plate(&own), &own) == *PLATE, "{title}: the plan of the worked example is another one");
    own
}

/// Nothing that ships is lost or overlaid, `docs/provenance.md` has the right counts of each new table, and the recipe lists
/// the files that it touches and no others.
fn holds_its_tables(title: &str, bench: &Bench, own: &Knowledge) {
    let shipped = &SHIPPED;
    let provenance = fs::read_to_string(bench.folder.join(PROVENANCE)).unwrap();
    for table in shipped.tables() {
        let same = own.table(&table.id).is_ok_and(|own| own.file == table.file && own.title.en == table.title.en);
        assert!(same, "{title}: the table {} of {} is gone", table.id, table.file);
    }
    for table in own.tables().filter(|table| shipped.table(&table.id).is_err()) {
        let counts = counts(table);
        assert!(provenance.contains(&counts), "{title}: {PROVENANCE} lacks a section with {counts}");
    }
    let counted = own.tables().any(|own| shipped.table(&own.id).map(counts).ok() != Some(counts(own)));
    let changed: BTreeSet<String> = bench
        .touched
        .iter()
        .filter(|path| path.contains('/'))
        .cloned()
        .chain(counted.then(|| PROVENANCE.to_owned()))
        .collect();
    let (new, old): (Vec<_>, Vec<_>) =
        files(title).into_iter().filter(|item| !is_code(&item.paths)).partition(|item| item.new);
    let paths = |items: &[page::Item]| items.iter().flat_map(|item| item.paths.clone()).collect::<BTreeSet<String>>();
    let (new, old) = (paths(&new), paths(&old));
    assert_eq!(new.union(&old).cloned().collect::<BTreeSet<_>>(), changed, "{title}: the files it lists");
    assert!(new.iter().all(|path| !root().join(path).exists()), "{title}: what is new is there already");
    assert!(old.iter().all(|path| root().join(path).exists()), "{title}: what is not new is not there");
}

/// The line of counts of a table, as `docs/provenance.md` writes it.
fn counts(table: &Table) -> String {
    let of = |source: Source| table.rows.iter().filter(|row| row.source == source).count();
    let choices = table.rows.iter().filter(|row| row.is_choice).count();
    format!(
        "`{} · rows {} · seed {} · standard {} · reconstructed {} · unconfirmed {} · corrected {}{}`",
        table.id,
        table.rows.len(),
        of(Source::Seed),
        of(Source::Standard),
        of(Source::Reconstructed),
        table.rows.iter().filter(|row| row.unconfirmed.is_some()).count() - choices,
        table.rows.iter().filter(|row| !row.corrections.is_empty()).count(),
        if choices > 0 { format!(" · choices {choices}") } else { String::new() },
    )
}

/// The plan of a part of this folder.
fn planned(path: &str, knowledge: &Knowledge) -> Plan {
    let text = fs::read_to_string(root().join(path)).unwrap();
    planner::plan(&read_part(path, &text, knowledge).unwrap(), CuttingMethod::default(), knowledge).unwrap()
}

/// The worked example, whose plan no recipe of the page changes.
fn plate(knowledge: &Knowledge) -> Plan {
    planned("examples/plate.yaml", knowledge)
}

fn sheet_of(plan: &Plan, knowledge: &Knowledge) -> String {
    shown(&sheet::page(plan, knowledge, Doubts::EachRow, Lang::EN))
}

static SHIPPED: LazyLock<Knowledge> = LazyLock::new(|| shipped::knowledge().unwrap());
static PLATE: LazyLock<String> = LazyLock::new(|| sheet_of(&plate(&SHIPPED), &SHIPPED));

#[test]
fn how_to_check() {
    recipe("How to check", "Machine GF2171");
}

#[test]
fn a_tool_table() {
    recipe("A tool table", "Ø18 × 180");
}

#[test]
fn a_row_of_a_rule() {
    recipe("A row of a rule", " 2 | Drill 2 holes Ø10H13 (A)");
}

#[test]
fn a_rule_and_the_rust_that_asks_it() {
    let knowledge = recipe("A rule", "");
    assert_eq!(hold(knowledge.table("hole-gauge").unwrap(), gauge::HoleGauge::CONTRACT), []);
    let mut plan = planned("examples/variant-4.yaml", &knowledge);
    for (hole, part) in plan.holes.iter_mut().zip(&plan.part.holes) {
        gauge::measured(hole, part.diameter.it, &knowledge).unwrap();
    }
    for (drawn, hole) in plan.part.holes.iter().zip(&plan.holes) {
        let gauge = if drawn.diameter.it.number() >= 12 {
            "calliper) [hole-gauge, row 1"
        } else {
            "plug-gauge) [hole-gauge, row 2"
        };
        let page = shown(&explain(&plan, hole, &knowledge, Lang::EN).unwrap());
        assert!(page.contains(&format!("hole-gauge (gauge = {gauge}")), "{page}");
    }
}

#[test]
fn a_machine() {
    recipe("A machine", "Machine 2254VMF4");
}

#[test]
fn a_lathe() {
    recipe("A lathe", "Machine: Lathe 16K20T1");
}

#[test]
fn a_turning_tool() {
    recipe("A turning tool", "PTJNR 2525M16");
}

#[test]
fn a_material() {
    recipe("A material", "Сталь 55");
}

#[test]
fn a_material_group() {
    recipe("A material group", "table reaming-feed has no figure for ВТ6");

    // The tables that lint lists before there are any rows are those that the recipe changes.
    let text: String = blocks("A material group").iter().map(Block::text).collect();
    let (_, listed) = text.split_once("leaves a gap in ").unwrap();
    let listed = listed.lines().next().unwrap().split(", ").map(|id| SHIPPED.table(id).unwrap().file.clone());
    let of_grade = ["catalogs/materials.yaml", "catalogs/practice/practice-group.yaml"];
    let own = ["catalogs/vocabularies/material-groups.yaml", PROVENANCE].into_iter().chain(of_grade).map(str::to_owned);
    let changed: BTreeSet<String> = files("A material group").into_iter().flat_map(|item| item.paths).collect();
    assert_eq!(listed.chain(own).collect::<BTreeSet<_>>(), changed);
}

#[test]
fn a_word_or_a_limit_of_a_control() {
    recipe("A word or a limit of a control", "too-many-m");
}

#[test]
fn a_control() {
    recipe("A control", "N15 G53 G0 Z0");
}

#[test]
fn a_page_has_what_it_is_made_of() {
    let plan = plate(&SHIPPED);
    let words = technolog::document::Words { left_out: "", see_all: "", help: "", figure: "" };
    let page = technolog::document::text(&kit::page(&plan, Lang::EN), 120, false, &words);
    assert!(page.contains("Cutter") && !plan.tools.is_empty());
    for tool in &plan.tools {
        let line = page.lines().find(|line| line.contains(&format!("T{} ", tool.number))).unwrap();
        assert!(line.contains(&tool.designation) && line.contains(&tool.holder), "{line}");
    }
}

#[test]
fn the_rust_of_the_page_stands_in_files_that_compile() {
    let compiled = [include_str!("adding/gauge.rs"), include_str!("adding/kit.rs")];
    let all: Vec<Block> = titles().into_iter().flat_map(blocks).filter(|block| block.doing == Doing::Rust).collect();
    for block in &all {
        assert!(compiled.iter().any(|file| file.contains(&block.text())), "{}: stands in no file", block.place);
    }
    // Nothing but the words at the head and the imports is left out on the page.
    for file in compiled {
        let rest = all.iter().fold(file.to_owned(), |rest, block| rest.replace(&block.text(), ""));
        assert!(
            rest.lines().all(|line| line.is_empty() || line.starts_with("//! ") || line.starts_with("use ")),
            "{rest}"
        );
    }
}

/// Recipes that are code, where nothing is carried out: a list of files and of names in them.
const OF_CODE: [&str; 2] = ["A language", "A page"];

#[test]
fn every_recipe_is_carried_out() {
    for title in titles() {
        let carried_out = OWN_TEXT.contains(&format!("recipe(\"{title}\""));
        let to_do = blocks(title).iter().any(|block| block.doing != Doing::Rust);
        assert_eq!(carried_out, to_do, "{title}");
        let recipe = carried_out && title != "How to check" || OF_CODE.contains(&title);
        assert_eq!(recipe, !files(title).is_empty(), "{title}: what files does it touch?");
    }
    let listed: Vec<&str> = PAGE.lines().filter_map(|line| line.strip_prefix("- [")?.split(']').next()).collect();
    assert_eq!(listed, titles());
}

/// Whether a quoted text is a path: it has a folder, and is in one of these.
fn is_path(quoted: &str) -> bool {
    let first = quoted.split('/').next().unwrap_or_default();
    ["catalogs", "rules", "crates", "src", "tests", "docs", "examples"].contains(&first) && quoted.contains('/')
}

/// Whether files are of the program.
fn is_code(paths: &[String]) -> bool {
    paths.iter().all(|path| path.starts_with("crates/") || path.starts_with("src/"))
}

#[test]
fn every_file_that_the_page_names_is_there() {
    let new: BTreeSet<String> =
        titles().into_iter().flat_map(files).filter(|item| item.new).flat_map(|item| item.paths).collect();
    let outside: String = PAGE.split("\n```").step_by(2).collect::<Vec<_>>().join("\n");
    let mut seen = 0;
    for path in quoted(&outside).into_iter().filter(|text| is_path(text) && !text.contains('<')) {
        seen += 1;
        assert!(root().join(&path).exists() || new.contains(&path), "the page names {path}");
    }
    assert!(seen > 60, "only {seen} paths");
    for rest in PAGE.split("--test ").skip(1) {
        let words: Vec<&str> = rest.split([' ', '`']).collect();
        let file = format!("tests/suites/{}/{}.rs", words[0], words[1].trim_end_matches(':'));
        assert!(root().join(&file).exists(), "the page runs tests of {file}");
    }
}

#[test]
fn names_stand_in_the_files_where_the_page_says() {
    let text = |path: &String| fs::read_to_string(root().join(path)).unwrap_or_default();
    let mut seen = 0;
    for title in titles() {
        for item in files(title).iter().filter(|item| OF_CODE.contains(&title) || is_code(&item.paths)) {
            let quotations = quoted(&item.instruction);
            for name in quotations.iter().filter(|name| !is_path(name)) {
                seen += 1;
                let in_heads = item.paths.iter().all(|path| text(path).contains(name.as_str()));
                let elsewhere = quotations.iter().any(|path| is_path(path) && text(path).contains(name.as_str()));
                assert!(in_heads || elsewhere, "{title}: {name} is not in {:?}", item.paths);
            }
        }
    }
    assert!(seen > 15, "only {seen} names");
}
