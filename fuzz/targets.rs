//! What every fuzz target does with a text, and what must hold of it: shared by the targets of the fuzzer and by
//! `tests/suites/reading/fuzz.rs`, which runs each of them in every `cargo test`.
//!
//! Whatever the text is, reading it ends, does not panic, and names places inside it; every sentence has its words in both
//! languages, and no page has a sign that nobody sees. The work is bounded by the size of the text: how long a run may take
//! and how much memory it may have is told to the fuzzer by its options.

#[path = "one_check.rs"]
pub mod one_check;

use std::sync::LazyLock;

use technolog::audit::marks::read_scheme;
use technolog::audit::{Auditor, Unreadable, read_plan, rules};
use technolog::cases::{ReadContext, read_cases};
use technolog::document::{self, Document, Format};
use technolog::knowledge::input::{text_of, unseen};
use technolog::knowledge::{Diagnostic, Knowledge, Place, SourceFile};
use technolog::machine::Machine;
use technolog::motion::MotionStep;
use technolog::note::Note;
use technolog::part::{Part, read_part};
use technolog::plan::CuttingMethod;
use technolog::program::iso::{self, check_within};
use technolog::program::{Language, Setting};
use technolog::report::{self, Lang};
use technolog::sequence::list::read_list;
use technolog::turning::shaft::Mistake;
use technolog::turning::workpiece::read_turned;
use technolog::{planner, shipped};

/// What is done with a text.
type Target = fn(&str);

/// Every target by its name, which is that of its folder in `corpus/` and of its file in `fuzz_targets/`.
pub const TARGETS: [(&str, Target); 13] = [
    ("part", part),
    ("shaft", turned),
    ("contour", turned),
    ("plan", plan),
    ("marks", marks),
    ("setting", setting),
    ("list", list),
    ("tables", tables),
    ("cases", cases),
    ("check", |text| one_check::one_check(text.as_bytes())),
    ("linuxcnc", |text| iso("linuxcnc", text)),
    ("fanuc", |text| iso("fanuc", text)),
    ("whole", whole),
];

/// No more of an input is looked at, bytes.
const MOST_INPUT: usize = 64 * 1024;
/// Problems of a byte: an empty mapping may lack every key.
const PROBLEMS_PER_BYTE: usize = 8;
/// So many problems of a text are said: the words of one after the other are the same, and slow in a debug build.
const MOST_SAID: usize = 12;
/// Blocks and motions of a program.
const BUDGET: usize = 4_000;
/// What is planned has no more points and kinds of holes.
const MOST_PLANNED: usize = 40;
/// What is audited has no more rows.
const MOST_ROWS: usize = 40;

static KNOWLEDGE: LazyLock<Knowledge> = LazyLock::new(|| shipped::knowledge().expect("the shipped tables are sound"));
static AUDITOR: LazyLock<Auditor<'static>> = LazyLock::new(|| Auditor::new(&KNOWLEDGE).expect("tables of audits"));
static CODES: LazyLock<Vec<String>> = LazyLock::new(Lang::codes);

/// Runs a target.
///
/// # Panics
/// There is no such target, or something that must hold does not.
pub fn run(target: &str, bytes: &[u8]) {
    let (_, own) = TARGETS.iter().find(|(name, _)| *name == target).expect("the table has every target");
    let bytes = &bytes[..bytes.len().min(MOST_INPUT)];
    if let Err(problem) = text_of("bytes", bytes.to_vec()) {
        check_texts(&[problem], &String::from_utf8_lossy(bytes));
    }
    own(&String::from_utf8_lossy(bytes));
}

fn part(text: &str) {
    if let Err(problems) = read_part("part.yaml", text, &KNOWLEDGE) {
        check_texts(&problems, text);
    }
}

fn turned(text: &str) {
    if let Err(mistakes) = read_turned("shaft.yaml", text, &KNOWLEDGE) {
        self::mistakes(&mistakes, text);
    }
}

fn plan(text: &str) {
    const PLATE: &str = include_str!("../examples/plate.yaml");
    let files = |name: &str| if name.ends_with("plate.yaml") { Ok(PLATE.to_owned()) } else { Err("none".to_owned()) };
    match read_plan("plan.yaml", text, &KNOWLEDGE, &files) {
        Err(Unreadable { problems, .. }) => check_texts(&problems, &(text.to_owned() + PLATE)),
        Ok(stated) if stated.rows.len() > MOST_ROWS || !is_small(&stated.part) => {}
        Ok(stated) => {
            let Ok(found) = AUDITOR.audit(&stated) else { return };
            LANGS.iter().for_each(|lang| shown(&report::audit::page(&found, *lang)));
        }
    }
}

fn marks(text: &str) {
    let known: Vec<&str> = rules::all().map(|rule| rule.id).chain(CODES.iter().map(String::as_str)).collect();
    if let Err(problems) = read_scheme("marks.yaml", text, &known) {
        check_texts(&problems, text);
    }
}

fn setting(text: &str) {
    for control in Language::names(&KNOWLEDGE) {
        let language = Language::read(control, &KNOWLEDGE).expect("the control has its tables");
        if let Err(problems) = language.setting("setting.yaml", text) {
            check_texts(&problems, text);
        }
    }
}

fn list(text: &str) {
    let Err(faults) = read_list("list", text) else { return };
    inside(faults.iter().map(|fault| fault.place.as_ref()), text);
    in_words(faults.iter().map(|fault| &fault.note), text);
    counted(faults.len(), text);
}

fn tables(text: &str) {
    for path in ["catalogs/table.yaml", "catalogs/vocabularies/words.yaml", "rules/table.test.yaml"] {
        let (knowledge, problems) = Knowledge::read_sources(&[SourceFile { path, text }]);
        check_texts(&problems, text);
        assert!(knowledge.to_bytes().is_ok(), "what is read can be compiled");
    }
}

fn cases(text: &str) {
    let around = ReadContext { knowledge: &KNOWLEDGE, codes: &CODES, files: &|_| Err("none".to_owned()) };
    mistakes(&read_cases("cases.test.yaml", text, around).mistakes, text);
}

fn iso(control: &str, text: &str) {
    let control = iso::Control::read(control, &KNOWLEDGE).expect("the control has its tables");
    let machine = Machine::find(&KNOWLEDGE, "ir500pmf4").expect("the machine has its record");
    let mut steps = Vec::<MotionStep>::new();
    let faults = check_within(BUDGET, text, &control, Some(&machine), &Setting::default(), &mut steps);
    assert!(steps.len() <= 2 * BUDGET, "the budget of motions");
    let lines: Vec<&str> = text.lines().collect();
    for fault in &faults {
        let line = lines.get((fault.span.line as usize).saturating_sub(1)).map_or(0, |line| line.chars().count());
        let end = (fault.span.column + fault.span.width - 1) as usize;
        assert!(fault.span.column >= 1 && end <= line.max(1), "{fault:?} is outside its line");
    }
    for fault in faults.iter().take(MOST_SAID) {
        assert!(Lang::EN.remedy(&fault.note).is_some(), "{} has no remedy", fault.code);
    }
    in_words(faults.iter().map(|fault| &fault.note), text);
    counted(faults.len(), text);
}

/// What `technolog plan` does, from the text of the part to the pages.
fn whole(text: &str) {
    let part = match read_part("part.yaml", text, &KNOWLEDGE) {
        Ok(part) if is_small(&part) => part,
        Ok(_) => return,
        Err(problems) => return check_texts(&problems, text),
    };
    let plan = planner::plan(&part, CuttingMethod::Formula, &KNOWLEDGE).expect("the shipped tables answer");
    LANGS.iter().for_each(|lang| shown(&report::sheet::page(&plan, &KNOWLEDGE, report::Doubts::EachRow, *lang)));
}

const LANGS: [Lang; 2] = [Lang::UK, Lang::EN];

fn is_small(part: &Part) -> bool {
    part.holes.iter().map(|hole| hole.at.len() + hole.steps.len()).sum::<usize>() <= MOST_PLANNED
}

fn mistakes(mistakes: &[Mistake], text: &str) {
    inside(mistakes.iter().map(Mistake::place), text);
    let notes = mistakes.iter().map(|mistake| match mistake {
        Mistake::Form(problem) => &problem.message,
        Mistake::Meaning(_, note, _) => note,
    });
    in_words(notes, text);
    counted(mistakes.len(), text);
}

fn check_texts(problems: &[Diagnostic], text: &str) {
    inside(problems.iter().map(|problem| problem.place.as_ref()), text);
    in_words(problems.iter().flat_map(|problem| [Some(&problem.message), problem.help.as_ref()]).flatten(), text);
    counted(problems.len(), text);
}

fn counted(problems: usize, text: &str) {
    let most = PROBLEMS_PER_BYTE * text.len() + 64;
    assert!(problems <= most, "{problems} problems of {} bytes", text.len());
}

/// Places are in lines that the text has, or in the one behind its end.
fn inside<'p>(places: impl Iterator<Item = Option<&'p Place>>, text: &str) {
    let lines = text.split(['\n', '\r']).count();
    for place in places.flatten() {
        assert!((1..=lines + 1).contains(&(place.line as usize)), "{place:?} of {lines} lines");
    }
}

/// Sentences have words in both languages, and no name of a figure stands where the figure should.
fn in_words<'n>(notes: impl Iterator<Item = &'n Note>, text: &str) {
    for (note, lang) in notes.take(MOST_SAID).flat_map(|note| LANGS.map(|lang| (note, lang))) {
        let sentence = lang.say(note);
        assert!(!sentence.is_empty(), "{note} has no words");
        assert!(!sentence.contains("{$") && !sentence.contains("{ $") || text.contains('$'), "{sentence}");
    }
}

/// A page can be written in every form, and shows nothing that nobody sees.
fn shown(page: &Document) {
    let words = document::Words { left_out: "left out", see_all: "", help: "help", figure: "figure" };
    for format in Format::ALL {
        let text = document::write(page, format, 100, false, &words);
        assert_eq!(unseen(&text), None, "{format:?}");
    }
}
