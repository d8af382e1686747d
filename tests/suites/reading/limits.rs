//! How much a file may say: as much as the bound is read, and one more is refused where it stands.

use std::fmt::Write as _;
use std::fs;

use technolog::audit::limits::{MOST_FACTORS, MOST_ROWS, MOST_TOOLS};
use technolog::audit::read_plan;
use technolog::cases::limits::{MOST_CASES, MOST_WORDS};
use technolog::knowledge::Diagnostic;
use technolog::knowledge::input::MOST_MB;
use technolog::knowledge::yaml::{LONGEST_NAME, MOST_DEPTH, MOST_VALUES};
use technolog::part::limits;
use technolog::program::MOST_OPERATIONS;
use technolog::program::iso::MOST_BLOCKS;
use technolog::sequence::list;
use technolog::words::Lang;
use technolog_testing::{KNOWLEDGE, root};

fn texts(problems: &[Diagnostic]) -> Vec<String> {
    problems.iter().map(|one| one.text(|note| Lang::EN.say(note))).collect()
}

/// What is wrong with a plan whose part is sound.
fn problems_of_plan(plan: &str) -> Vec<String> {
    const PART: &str = "part:\n  part: P\n  material: steel-45\n  machine: gf2171\n  \
        blank: {kind: plate, length: 200, width: 100, thickness: 40}\n  \
        holes: [{name: A, diameter: 10, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[0, 0]]}]\n";
    let read = read_plan("p", &format!("{PART}{plan}"), &KNOWLEDGE, &|name| Err(name.to_owned()));
    read.err().map(|unreadable| texts(&unreadable.problems)).unwrap_or_default()
}

/// The lines of so many of a kind, from 1.
fn lines(head: &str, count: usize, one: impl Fn(usize) -> String) -> String {
    (1..=count).fold(format!("{head}:\n"), |mut text, number| {
        let _ = writeln!(text, "  {}", one(number));
        text
    })
}

#[test]
fn of_a_plan_the_rows_and_tools_are_bounded() {
    let rows = |count| lines("route", count, |row| format!("- {{row: {row}, operation: drill, hole: A}}"));
    let conditions = |count| lines("conditions", count, |row| format!("- {{for: {row}, feed: 0.1}}"));
    let tools = |count| lines("tools", count, |tool| format!("T{tool}: {{diameter: 10}}"));
    assert_eq!(problems_of_plan(&(rows(MOST_ROWS) + &conditions(MOST_ROWS) + &tools(MOST_TOOLS))), [""; 0]);
    let refused = |plan: String, line: usize, words: &str| {
        let problems = problems_of_plan(&plan);
        assert_eq!(problems.len(), 1, "{problems:?}");
        assert!(problems[0].starts_with(&format!("p:{line}:")) && problems[0].contains(words), "{problems:?}");
    };
    // The head of the part has six lines, that of the list one.
    refused(rows(MOST_ROWS + 1), 7 + MOST_ROWS + 1, "3001 rows, and a plan may have 3000 [too-many-rows]; ");
    refused(tools(MOST_TOOLS + 1), 7 + MOST_TOOLS + 1, "501 tools, and a plan may have 500 [too-many-tools]; ");
    let twice = rows(1) + &lines("conditions", MOST_ROWS + 1, |_| "- {for: 1}".to_owned());
    assert_eq!(problems_of_plan(&twice).len(), MOST_ROWS, "each but the first, and one for those beyond");
    let named = format!("conditions: [{{for: [{}]}}]\n", "1, ".repeat(MOST_ROWS + 1));
    refused(rows(1) + &named, 9, "[too-many-rows]");
    let factors = |count| {
        let names = (1..=count).map(|number| format!("f{number}: 1")).collect::<Vec<_>>().join(", ");
        rows(1) + &format!("conditions: [{{for: 1, factors: {{feed: {{{names}}}}}}}]\n")
    };
    assert_eq!(problems_of_plan(&factors(MOST_FACTORS)), [""; 0]);
    refused(factors(MOST_FACTORS + 1), 9, "101 factors, and a figure may have 100 [too-many-factors]; ");
}

#[test]
fn a_key_of_many_words_is_bounded() {
    let folder = super::folder("words");
    let run = |count: usize| {
        let key = vec!["a"; count].join(".");
        fs::write(folder.join("a.test.yaml"), format!("tests:\n  - {{hole: {{diameter: 10, roughness: Ra 12.5}}, part: {{material: steel-45, machine: gf2171, blank: {{kind: plate, length: 100, width: 100, thickness: 20}}}}, expect: {{{key}: 1}}}}\n")).unwrap();
        super::command(&folder, &["test", "a.test.yaml"], b"").beside
    };
    assert!(!run(MOST_WORDS).contains("too-deep"), "{}", run(MOST_WORDS));
    for count in [MOST_WORDS + 1, 100_000] {
        let answer = run(count);
        assert!(answer.contains("error[too-deep]: ") && answer.contains(&format!("{count} words")), "{answer}");
    }
}

#[test]
fn of_many_rows_that_may_be_meant_the_first_are_listed() {
    let rows = lines("route", 1_000, |row| format!("- {{row: {row}, operation: drill, hole: A}}"));
    let problems = problems_of_plan(&(rows + "conditions: [{for: 1001}]\n"));
    assert_eq!(problems.len(), 1, "{problems:?}");
    assert!(
        problems[0].ends_with("its rows are 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, …")
    );
}

#[test]
fn the_pages_say_the_bounds() {
    // In the order of the pages; of the control 2С42-65 and of the run the tables of `programs` hold the figures.
    let bounds = [
        ("too-large", MOST_MB),
        ("too-deep", MOST_DEPTH),
        ("too-many-values", MOST_VALUES),
        ("too-long", LONGEST_NAME),
        ("too-many-points", limits::MOST_POINTS),
        ("too-many-kinds", limits::MOST_KINDS),
        ("too-many-steps", limits::MOST_STEPS),
        ("too-many-clamps", limits::MOST_CLAMPS),
        ("too-many-obstacles", limits::MOST_OBSTACLES),
        ("too-many-dimensions", limits::MOST_DIMENSIONS),
        ("too-many-points", list::MOST_POINTS),
        ("too-many-rows", MOST_ROWS),
        ("too-many-tools", MOST_TOOLS),
        ("too-many-factors", MOST_FACTORS),
        ("too-many-cases", MOST_CASES),
        ("too-deep", MOST_WORDS),
        ("too-many-values", MOST_VALUES),
        ("too-many-blocks", MOST_BLOCKS),
        ("not-carried-out", MOST_OPERATIONS),
    ];
    for page in ["docs/limits.md", "docs/uk/limits.md"] {
        let text = fs::read_to_string(root().join(page)).unwrap();
        let cells = text.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix("` |")?.split_once(" | "));
        let counts = cells.filter_map(|(_, rest)| {
            let (bound, code) = rest.split_once(" | `")?;
            Some((code, bound.replace([',', ' ', '\u{a0}'], "").parse::<usize>().ok()?))
        });
        let stated: Vec<(&str, usize)> =
            counts.filter(|(code, _)| !["memory-full", "run-too-long"].contains(code)).collect();
        assert_eq!(stated, bounds, "{page}");
    }
}
