//! Files of cases (docs/cases.md): every one in this repository passes, and none passes by mistake: a changed figure
//! fails at its place. Also the command: what it writes, refuses and prints.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use serde_json::Value;
use technolog::cases::{Asker, CaseFile, Failure, ReadContext, read_cases};
use technolog::knowledge::diagnostic::Place;
use technolog::knowledge::yaml::{Node, NodeKind, parse};
use technolog::parallel;
use technolog::plan::Operation;
use technolog::words::Lang;
use technolog_testing::KNOWLEDGE;

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn read(path: &Path, text: &str) -> CaseFile {
    let codes = Lang::codes();
    let files = |name: &str| fs::read_to_string(path.with_file_name(name)).map_err(|error| error.to_string());
    read_cases(&path.display().to_string(), text, ReadContext { knowledge: &KNOWLEDGE, codes: &codes, files: &files })
}

fn test_files(folder: &str) -> Vec<PathBuf> {
    fn walk(folder: &Path, files: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                walk(&entry, files);
            } else if entry.to_string_lossy().ends_with(".test.yaml") {
                files.push(entry);
            }
        }
    }
    let mut files = Vec::new();
    walk(&root(folder), &mut files);
    files.sort();
    files
}

/// The answers to the cases of a file, all of which can be asked.
fn answers(path: &Path, file: &CaseFile) -> Vec<Value> {
    assert!(file.mistakes.is_empty(), "{}: {:?}", path.display(), file.mistakes);
    let asker = Asker::new(&KNOWLEDGE);
    parallel::map(&file.cases, |case| case.answer(&asker).unwrap(), |_| ())
}

/// What is not as expected, case by case.
fn run(path: &Path, file: &CaseFile) -> Vec<Vec<Failure>> {
    let answers = answers(path, file);
    file.cases.iter().zip(answers).map(|(case, answer)| case.against(&answer, &KNOWLEDGE)).collect()
}

/// A file of cases that was run.
struct Done {
    path: PathBuf,
    text: String,
    file: CaseFile,
    answers: Vec<Value>,
}

fn done(folder: &str) -> Vec<Done> {
    let one = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let file = read(&path, &text);
        Done { answers: answers(&path, &file), path, text, file }
    };
    test_files(folder).into_iter().map(one).collect()
}

/// The cases of holes, of routes, and the examples, run once for all tests.
static DONE: LazyLock<[Vec<Done>; 3]> = LazyLock::new(|| ["tests/holes", "tests/routes", "examples/cases"].map(done));

/// How many cases there are, all of which pass.
fn passing(files: &[Done]) -> usize {
    for Done { file, answers, .. } in files {
        for (case, answer) in file.cases.iter().zip(answers) {
            let failures = case.against(answer, &KNOWLEDGE);
            assert!(failures.is_empty(), "{} {}: {failures:#?}\n{:?}", case.place, case.name, case.because);
        }
    }
    files.iter().map(|done| done.answers.len()).sum()
}

#[test]
fn every_case_of_the_repository_passes() {
    assert_eq!(DONE.each_ref().map(|files| passing(files)), [136, 34, 29], "holes, routes, examples");
    let [rules, catalogs, published] = ["rules", "catalogs", "tests/published"].map(|folder| passing(&done(folder)));
    assert!(rules >= 214 && catalogs >= 43 && published >= 25, "{rules} {catalogs} {published}");
}

/// A scalar of an expectation and what stands in its place for the planted change.
struct Planted {
    changes: Vec<(Place, String)>,
    now: String,
}

/// Every figure and word that is expected, changed so little that it must be told.
fn planted(node: &Node, key: &str, all: &mut Vec<Planted>) {
    let one = |node: &Node, now: String| Planted { changes: vec![(node.place.clone(), now.clone())], now };
    match &node.kind {
        // The opposite of a value, or more values than one: another may do as well.
        _ if ["within", "one_of", "not", "lacks", "none_from"].contains(&key) => {}
        NodeKind::Seq(items) => items.iter().for_each(|item| planted(item, key, all)),
        NodeKind::Map(_) => {
            let number = |key: &str| node.get(key).and_then(Node::text).and_then(|text| text.parse::<f64>().ok());
            if let (Some(is), Some(within)) = (node.get("is"), node.get("within").and_then(Node::text)) {
                let value = number("is").unwrap();
                let by = match within.strip_suffix('%') {
                    Some(share) => value.abs() * share.parse::<f64>().unwrap() / 100.0,
                    None => within.parse().unwrap(),
                };
                all.push(one(is, (value + 3.0 * by).to_string()));
                return;
            }
            match (node.get("from").zip(number("from")), node.get("to").zip(number("to"))) {
                (Some((from, _)), Some((to, value))) => {
                    let now = (value + 1.0).to_string();
                    let changes =
                        vec![(from.place.clone(), now.clone()), (to.place.clone(), (value + 2.0).to_string())];
                    all.push(Planted { changes, now });
                }
                (Some((from, _)), None) => all.push(one(from, "1000000".to_owned())),
                (None, Some((to, _))) => all.push(one(to, "-1000000".to_owned())),
                (None, None) => {
                    let NodeKind::Map(entries) = &node.kind else { return };
                    for (key, inner) in entries {
                        planted(inner, key.text.rsplit('.').next().unwrap(), all);
                    }
                }
            }
        }
        NodeKind::Scalar { text, quoted } => {
            if let Some(now) = other(text) {
                let now = if *quoted { format!("\"{now}\"") } else { now };
                all.push(one(node, now));
            }
        }
    }
}

/// Another text of the same kind; none of a transition that may be missing or be one of two.
fn other(text: &str) -> Option<String> {
    if text.ends_with(" *") || text.contains('|') {
        return None;
    }
    let (before, last) = text.rsplit_once(' ').unwrap_or(("", text));
    Some(match text {
        "true" => "false".to_owned(),
        "false" => "true".to_owned(),
        "absent" => "present".to_owned(),
        "present" | "none" => "absent".to_owned(),
        "tap" => "drill".to_owned(),
        _ if Operation::from_name(text.split(' ').next()?).is_some()
            && !text.contains(|it: char| it.is_ascii_digit()) =>
        {
            "tap".to_owned()
        }
        _ if last.contains("also:") || last.contains("step:") => format!("{text}1"),
        // A hundred-thousandth is told, too.
        _ if last.parse::<f64>().is_ok() && last.contains('.') => format!("{text}00001"),
        _ if last.parse::<f64>().is_ok() && last.len() > 1 && last.starts_with('0') => format!("{text}1"),
        _ if last.parse::<f64>().is_ok() => format!("{before} {last}.00001").trim().to_owned(),
        "elsewhere" | "back" => return None,
        _ if last == "elsewhere" || last == "back" => before.to_owned(),
        _ => format!("{text}x"),
    })
}

/// The byte of a place.
fn byte(text: &str, place: &Place) -> usize {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let before: usize = lines[..place.line as usize - 1].iter().map(|line| line.len()).sum();
    before + lines[place.line as usize - 1].chars().take(place.column as usize - 1).map(char::len_utf8).sum::<usize>()
}

fn changed(text: &str, changes: &[(Place, String)]) -> String {
    let mut text = text.to_owned();
    for (place, now) in changes.iter().rev() {
        let at = byte(&text, place);
        let old: String = text[at..].chars().take(place.width as usize).collect();
        text.replace_range(at..at + old.len(), now);
    }
    text
}

#[test]
fn a_change_of_any_expected_figure_fails_where_it_stands() {
    let mut count = 0;
    for Done { path, text, answers, .. } in DONE.iter().flatten() {
        let tree = parse("cases", text).0.unwrap();
        let NodeKind::Seq(tests) = &tree.get("tests").unwrap().kind else { panic!("{}", path.display()) };
        let all = tests.iter().map(|test| {
            let mut all = Vec::new();
            planted(test.get("expect").unwrap(), "", &mut all);
            all
        });
        let all: Vec<Vec<Planted>> = all.collect();
        // In each round one change in every case that has still one.
        for round in 0..all.iter().map(Vec::len).max().unwrap() {
            let now: Vec<(usize, &Planted)> =
                all.iter().enumerate().filter_map(|(case, all)| Some((case, all.get(round)?))).collect();
            let changes: Vec<(Place, String)> = now.iter().flat_map(|(_, planted)| planted.changes.clone()).collect();
            let file = read(path, &changed(text, &changes));
            assert!(file.mistakes.is_empty(), "{}: {changes:?}: {:?}", path.display(), file.mistakes);
            for (case, Planted { changes, now }) in now {
                let failures = file.cases[case].against(&answers[case], &KNOWLEDGE);
                told_there(&failures, &changes[0].0, now);
                count += 1;
            }
        }
    }
    assert!(count > 450, "{count}");
}

/// Whether what was planted is what fails, and nothing else.
fn told_there(failures: &[Failure], at: &Place, now: &str) {
    let is_of_place =
        |one: &Failure| one.expected.contains(now) && (one.place.line, one.place.column) <= (at.line, at.column);
    assert!(!failures.is_empty() && failures.iter().all(is_of_place), "{at}: {now}: {failures:#?}");
    let places: BTreeSet<&Place> = failures.iter().map(|one| &one.place).collect();
    assert_eq!(places.len(), 1, "{at}: {now}: {failures:#?}");
}

/// What is wrong with a file of cases is told at once, each with its place and what was meant.
#[test]
fn every_mistake_of_a_file_is_told_where_it_stands() {
    let text = "\
table: A.8
tests:
  - {given: {itt: 7}, expect: {schemes: '32'}}
  - {given: {it: 7, diameter: 900, centre_tolerance: 0.2, roughness: Ra 2.5}, expect: none}
  - {given: {it: 7, diameter: 12, centre_tolerance: 0.2, roughness: Ra 2.5}, expect: {scheme: '32'}, sorce: x}
  - {table: materals, given: {it: 7}}
  - {table: A.8, audit: x.yaml}
";
    let found = mistakes(text);
    assert_eq!(
        found,
        [
            "3:14 unknown-key did you mean `it`?",
            "4:13 bad-question `technolog table` shows its columns",
            "5:87 unknown-key did you mean `schemes`?",
            "5:102 unknown-key did you mean `source`?",
            "6:13 unknown-table did you mean `materials`?",
            "7:25 two-questions split it into two cases",
        ]
    );
    let part = "\
part: {material: steel-45, machine: gf2171, blank: {kind: plate, length: 99, width: 99, thickness: 20}}
hole: {through: true, roughness: Ra 12.5, centre_tolerance: 0.2}
tests:
  - {hole: {diameter: 10H12}, expect: {shceme: '07'}}
  - {hole: {diameter: 10H12}, expect: {transitions: [centre-dril, drill 10 bakc]}}
  - hole: {diameter: 10H12}
    expect:
      findings: {none_from: wrnog}
      time.total_min: {is: 3, within: 5%, starts: 4}
      time.machine_min: {from: 5, to: 3}
      tools: {evry: {}, starts: []}
      clamping.force_n: {is: 3, within: -1}
  - {hole: {diametr: 10H12}, expct: {}}
  - {hole: {diameter: 10Q12}, expect: {transitions.1.conditions.feed: 0.1, findings: {lacks: [no-rout]}}}
";
    assert_eq!(
        mistakes(part),
        [
            "4:40 unknown-key did you mean `scheme`?",
            "5:54 bad-value did you mean `centre-drill`?",
            "5:67 bad-value did you mean `back`?",
            "8:29 bad-value did you mean `wrong`?",
            "9:43 unknown-key known here: is, within",
            "10:25 bad-value write the smaller one first",
            "11:15 unknown-key did you mean `every`?",
            "12:41 bad-value write a share such as 5%, or a number above zero in the unit of the figure",
            "13:13 unknown-key did you mean `diameter`?",
            "13:30 unknown-key did you mean `expect`?",
            "14:23 bad-diameter ",
            "14:40 unknown-key known here",
            "14:95 unknown-code did you mean `no-route`?",
        ]
    );
}

/// `line:column code help` of every mistake of a text, the long lists of keys cut.
fn mistakes(text: &str) -> Vec<String> {
    let file = read(&root("tests/x.test.yaml"), text);
    file.mistakes
        .iter()
        .map(|mistake| {
            let technolog::turning::shaft::Mistake::Form(one) = mistake else { panic!("{mistake:?}") };
            let place = one.place.as_ref().unwrap();
            let help = one.help.as_ref().map(|help| Lang::EN.say(help)).unwrap_or_default();
            let help = if help.len() > 90 { "known here" } else { &help };
            format!("{}:{} {} {help}", place.line, place.column, one.code)
        })
        .collect()
}

/// A word that nothing is called by must not pass as something that is not there.
#[test]
fn nothing_passes_because_it_is_misspelt() {
    for (expect, path) in [
        ("{findings: {contains: {colour: red}}}", "colour"),
        ("{findings: {lacks: {colour: red}}}", "colour"),
        ("{colour: absent}", "colour"),
        ("{variants.longitudnal: {cost: 1}}", "variants.longitudnal"),
        ("{variants: {every: {colour: absent}}}", "variants.1.colour"),
        ("{}", ""),
        ("", ""),
    ] {
        let text = format!("turn: ../examples/shaft.yaml\ntests: [{{expect: {expect}}}]\n");
        let path_of_file = root("tests/x.test.yaml");
        let file = read(&path_of_file, &text);
        let failures = run(&path_of_file, &file).remove(0);
        // An empty mapping expects nothing of the keys, and nothing wrong among the findings.
        assert_eq!(failures.is_empty(), expect == "{}", "{expect}: {failures:?}");
        assert!(failures.iter().any(|one| one.path.ends_with(path)) || failures.is_empty(), "{expect}: {failures:?}");
    }
    // Of no rows nothing is said.
    let text = "tests: [{table: A.12, given: {diameter: 999}, expect: {every: {morse: 2}}}]\n";
    let path = root("tests/x.test.yaml");
    assert_eq!(run(&path, &read(&path, text))[0].len(), 1);
    // Of a hole that cannot be made something wrong is found, and nothing was said of it.
    let text = "tests:\n  - {hole: {diameter: 3H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.2}, part: \
                {material: steel-45, machine: gf2171, blank: {kind: plate, length: 99, width: 99, thickness: 80}}, \
                expect: {scheme: absent}}\n";
    let path = root("tests/x.test.yaml");
    let failures = run(&path, &read(&path, text)).remove(0);
    assert!(!failures.is_empty() && failures.iter().all(|one| one.path == "findings"), "{failures:?}");
}

fn technolog(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_technolog")).env_remove("LANG").args(args).output().unwrap()
}

fn code(args: &[&str]) -> (i32, String, String) {
    let output = technolog(args);
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// A folder of this test alone.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cases").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Cases in every way of writing, with nothing expected yet.
const OPEN: &str = "\
# Open cases.
part: {material: steel-45, machine: gf2171, blank: {kind: plate, length: 99, width: 99, thickness: 20}}
tests:
  # in flow style
  - {hole: {diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.2}, because: \"it's {open}\"}
  - {hole: {diameter: 8H9, through: true, roughness: Ra 2.5, centre_tolerance: 0.2},   # a remark }
     name: over several lines,   # and here
    }
  - {hole: {diameter: 8H9, through: true, roughness: Ra 2.5, centre_tolerance: 0.2}, expect: , source: key without value}
  # in block style
  - hole: {diameter: 12H7, through: true, roughness: Ra 2.5, centre_tolerance: 0.2}   # a remark

    name: without the key
  - name: the key alone
    hole: {diameter: 12H7, through: true, roughness: Ra 2.5, centre_tolerance: 0.2}
    expect:   # to be filled in
    because: a reason that stays behind
  - source: in front of it
    hole: {diameter: 3H12, depth: 15, roughness: Ra 12.5, centre_tolerance: 0.2}
    expect: {scheme: , transitions: , findings: , time.total_min: }

  # the last one
  - name: ends with lines of its own
    hole: {diameter: 16H13, through: true, roughness: Ra 12.5, centre_tolerance: 0.2}
    because: |
      two lines,
        # and no remark
  # behind everything
";

#[test]
fn what_is_written_passes_and_nothing_else_changes() {
    let folder = folder("write");
    for (name, text) in [("unix", OPEN.to_owned()), ("windows", OPEN.replace('\n', "\r\n"))] {
        let file = folder.join(format!("{name}.test.yaml"));
        let path = file.to_str().unwrap();
        fs::write(&file, &text).unwrap();
        let (before, page, _) = code(&["test", path]);
        assert_eq!(before, 1, "{page}");
        assert_eq!(fs::read_to_string(&file).unwrap(), text, "without --write nothing is written");
        let (written, page, stderr) = code(&["test", path, "--write", "--lang", "en"]);
        assert_eq!(written, 0, "{page}\n{stderr}");
        assert!(page.contains("7 cases: written"), "{page}");
        let filled = fs::read_to_string(&file).unwrap();
        assert!(is_within(&text, &filled), "{filled}");
        assert_eq!(filled.matches("\r\n").count() > 0, name == "windows");
        assert!(!filled.replace("\r\n", "").contains('\r'));
        assert_eq!(filled.matches("expect:").count(), 7, "{filled}");
        assert_eq!(code(&["test", path]).0, 0);
        assert_eq!(code(&["test", path, "--write"]).0, 0);
        assert_eq!(fs::read_to_string(&file).unwrap(), filled, "written again");
        // Nothing lies beside it.
        assert!(
            fs::read_dir(&folder).unwrap().all(|entry| !entry.unwrap().file_name().to_string_lossy().contains("tmp"))
        );
    }
}

/// Whether one text is the other with something put in.
fn is_within(one: &str, other: &str) -> bool {
    let mut rest = other.chars();
    one.chars().all(|letter| rest.any(|other| other == letter))
}

#[test]
fn a_comment_stays_beside_its_key() {
    let file = folder("comment").join("one.yaml");
    let plate = root("examples/plate.yaml");
    fs::write(&file, format!("tests:\n  - part: {}\n    expect: # hello\n", plate.display())).unwrap();
    assert_eq!(code(&["test", file.to_str().unwrap(), "--write"]).0, 0);
    let filled = fs::read_to_string(&file).unwrap();
    assert!(filled.contains("expect: # hello\n      holes:"), "{filled}");
}

#[test]
fn of_a_file_that_is_not_read_nothing_is_as_expected() {
    let file = folder("unread").join("one.yaml");
    fs::write(&file, "tests: [\n").unwrap();
    let (done, page, _) = code(&["test", file.to_str().unwrap(), "--lang", "en"]);
    assert_eq!(done, 2);
    assert!(page.contains("1 file, 0 cases, unusable files: 1") && !page.contains("as expected"), "{page}");
}

#[test]
fn every_kind_of_answer_can_be_written() {
    let folder = folder("kinds");
    let examples = root("examples").display().to_string();
    let text = format!(
        "tests:\n  - {{table: A.8, given: {{it: 7, diameter: 12, centre_tolerance: 0.2, roughness: Ra 2.5}}}}\n  \
         - {{table: A.8, given: {{it: 6, diameter: 8, centre_tolerance: 0.2, roughness: Ra 2.5}}}}\n  \
         - {{table: A.12, given: {{morse: 2}}}}\n  - part: {examples}/plate.yaml\n  - part: {examples}/variant-2.yaml\n  \
         - turn: {examples}/shaft.yaml\n  - turn: {examples}/shaft.yaml\n    show: operation\n  \
         - turn: {examples}/turned-pin.yaml\n  - audit: {examples}/appendix-g/plan.yaml\n  \
         - program: {examples}/appendix-g/program.nc\n    control: 2c42-65\n    setting: {examples}/appendix-g/setting.yaml\n    \
         part: {examples}/plate.yaml\n  - {{part: {examples}/plate.yaml, expect: {{tools: ~, holes.A: ~, clamping: null}}}}\n"
    );
    let file = folder.join("all.yaml");
    fs::write(&file, &text).unwrap();
    let copy = folder.join("copy.yaml");
    let (done, page, stderr) =
        code(&["test", file.to_str().unwrap(), "--write", "-o", copy.to_str().unwrap(), "--lang", "en"]);
    assert_eq!(done, 0, "{page}\n{stderr}");
    assert_eq!(fs::read_to_string(&file).unwrap(), text, "with -o the file stays");
    assert_eq!(code(&["test", copy.to_str().unwrap()]).0, 0);
    let filled = fs::read_to_string(&copy).unwrap();
    assert!(filled.contains("expect: {finish_elsewhere: false, schemes: [\"32\"]}"), "{filled}");
    assert!(filled.contains("expect: none"), "{filled}");
}

#[test]
fn an_expectation_that_stands_is_never_changed() {
    let folder = folder("stands");
    let file = folder.join("a.test.yaml");
    let text =
        "table: spindle-step\ntests:\n  - {given: {excess: 0}, expect: {take: below}}\n  - {given: {excess: 24}}\n";
    fs::write(&file, text).unwrap();
    let (done, page, _) = code(&["test", file.to_str().unwrap(), "--write", "--lang", "en"]);
    assert_eq!(done, 1, "{page}");
    let expected = text.replace("{excess: 24}}", "{excess: 24}, expect: {take: below}}");
    assert_eq!(fs::read_to_string(&file).unwrap(), expected);
}

#[test]
fn an_output_replaces_no_input() {
    let folder = folder("inputs");
    let (one, other) = (folder.join("a.test.yaml"), folder.join("b.test.yaml"));
    let text = "table: spindle-step\ntests: [{given: {excess: 0}, expect: {take: above}}]\n";
    for file in [&one, &other] {
        fs::write(file, text).unwrap();
    }
    let (one, other) = (one.to_str().unwrap(), other.to_str().unwrap());
    for args in [vec!["test", one, "-o", one], vec!["test", one, "--write", "-o", one]] {
        let (done, _, stderr) = code(&args);
        assert_eq!(done, 2, "{stderr}");
        assert!(stderr.contains("replaces-input"), "{stderr}");
    }
    assert_eq!(code(&["test", one, other, "--write", "-o", folder.join("c").to_str().unwrap()]).0, 2);
    assert_eq!(fs::read_to_string(one).unwrap(), text);
}

#[test]
fn exit_codes_tell_what_passed_from_what_failed_and_what_cannot_be_used() {
    let folder = folder("codes");
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
    let path = folder.to_str().unwrap();
    let (done, _, stderr) = code(&["test", path]);
    assert_eq!(done, 2, "{stderr}");
    assert!(stderr.contains("no-cases"), "{stderr}");
    write("a.test.yaml", "table: spindle-step\ntests: [{given: {excess: 0}, expect: {take: above}}]\n");
    write("part.yaml", "no cases: here\n");
    assert_eq!(code(&["test", path]).0, 0);
    write(
        "b.test.yaml",
        "table: spindle-step\ntests: [{given: {excess: 0}, expect: {take: below}, source: 'a < b & c'}]\n",
    );
    let (done, page, stderr) = code(&["test", path]);
    assert_eq!((done, stderr.as_str()), (1, ""), "{page}");
    assert!(page.contains("b.test.yaml:2:9") && page.contains("очікувалося: below"), "{page}");
    write("c.test.yaml", "table: spindle-stp\ntests: [{given: {excess: 0}}, {given: {excess: 1}}]\n");
    let (done, page, stderr) = code(&["test", path, "--lang", "en"]);
    assert_eq!(done, 2, "{stderr}");
    assert!(page.contains("3 files, 2 cases: 1 failed, unusable files: 1"), "{page}");
    assert_eq!(stderr.matches("did you mean `spindle-step`?").count(), 1, "{stderr}");
    assert_eq!(code(&["test", "nowhere.yaml"]).0, 2);
    assert_eq!(code(&["test", path, "--format", "csv"]).0, 2);

    let (_, json, _) = code(&["test", path, "--format", "json"]);
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((&json["passed"], &json["failed"], &json["unusable"]), (&1.into(), &1.into(), &1.into()));
    let failure = &json["files"][1]["cases"][0]["failures"][0];
    assert_eq!(
        (&failure["path"], &failure["expected"], &failure["came"]),
        (&"take".into(), &"below".into(), &"above".into())
    );
    assert_eq!((&failure["line"], &failure["column"]), (&2.into(), &45.into()));
    assert_eq!(json["files"][2]["mistakes"][0]["code"], "unknown-table");

    let (_, xml, _) = code(&["test", path, "--format", "junit"]);
    assert!(xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"technolog test\" tests=\"3\" failures=\"1\" errors=\"1\">"), "{xml}");
    assert!(xml.contains("a &lt; b &amp; c"), "{xml}");
    well_formed(&xml);
    assert_eq!(code(&["test", path, "--format", "junit"]).1, xml, "the same cases give the same file");
}

/// Every element is closed in its turn, and no text holds a sign of the markup.
fn well_formed(xml: &str) {
    let mut open = Vec::new();
    for piece in xml.split_once("?>").unwrap().1.split('<').skip(1) {
        let (tag, text) = piece.split_once('>').unwrap();
        let entities = ["&lt;", "&gt;", "&amp;", "&quot;", "&apos;", "&#10;", "&#9;"];
        let plain = entities.iter().fold(format!("{tag}{text}"), |text, entity| text.replace(entity, ""));
        assert!(!plain.contains('&') && tag.matches('"').count() % 2 == 0, "{piece}");
        let name = tag.trim_end_matches('/').split(' ').next().unwrap();
        if let Some(name) = name.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "{piece}");
        } else if !tag.ends_with('/') {
            open.push(name.to_owned());
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

/// Every file of docs/cases.md is one, and passes; what it shows of the command is what the command says.
#[test]
fn the_page_about_cases_is_true() {
    let page = fs::read_to_string(root("docs/cases.md")).unwrap();
    let blocks: Vec<&str> = page.split("```yaml\n").skip(1).map(|block| block.split_once("```").unwrap().0).collect();
    assert_eq!(blocks.len(), 5);
    let path = root("docs/cases.test.yaml");
    for block in blocks {
        for (case, failures) in read(&path, block).cases.iter().zip(run(&path, &read(&path, block))) {
            assert!(failures.is_empty(), "{}: {failures:#?}", case.name);
        }
    }
    let folder = folder("page");
    let text = "tests:\n  - hole: {diameter: 10H12, through: true, roughness: Rz 80, centre_tolerance: 0.2}\n    part: {material: \
                steel-45, machine: gf2171, blank: {kind: plate, length: 300, width: 200, thickness: 30}}\n    expect: \
                {scheme: \"16\"}\n    source: a slip, to show what is said\n";
    fs::write(folder.join("tasks.test.yaml"), text).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    let output = command.args(["test", "tasks.test.yaml", "--lang", "en"]).current_dir(&folder).output().unwrap();
    let stdout = String::from_utf8(output.stdout).unwrap();
    assert!(page.contains(&format!("$ technolog test tasks.test.yaml --lang en\n{stdout}```")), "{stdout}");
}
