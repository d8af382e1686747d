//! An audit for people is in their language: without paths of a plan file, ids of values, or English in Ukrainian.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::LazyLock;

use serde_json::Value;
use technolog::audit::marks::read_scheme;
use technolog::audit::quantity::Quantity;
use technolog::audit::stated::Stated;
use technolog::audit::{Audit, Audited, Unread, read_plan, rules};
use technolog::document::{self, Document, Format};
use technolog::plan::CuttingMethod;
use technolog::report::Lang;
use technolog::report::audit::{against, many, page};
use technolog_laws::share;
use technolog_testing::{AUDITOR, KNOWLEDGE, planned, read};

fn text(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

/// A plan in that folder.
fn stated(folder: &str, text: &str) -> Stated {
    let files = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder).join(name);
        std::fs::read_to_string(path).map_err(|error| error.to_string())
    };
    read_plan("plan.yaml", text, &KNOWLEDGE, &files).unwrap_or_else(|why| panic!("{why:?}"))
}

/// The worked example, the plan without a slip and with each of the faults, and plans that leave out almost everything.
fn by_hand() -> Vec<Stated> {
    let right = text("tests/audit/right.yaml");
    let faults: Vec<Value> = serde_yaml::from_str(&text("tests/audit/faults.yaml")).unwrap();
    let faulty = |fault: &Value| right.replacen(fault["from"].as_str().unwrap(), fault["to"].as_str().unwrap(), 1);
    let mut texts: Vec<String> = faults.iter().map(faulty).collect();
    let part = right.lines().find(|line| line.starts_with("part: ")).unwrap();
    for rest in [
        "",
        "route:\n  - {row: 1, operation: drill}\n  - {row: 2, operation: tap, hole: A}\ntools:\n  T1: {}\nclamping: {}\n",
        "route:\n  - {row: 1, operation: drill, hole: A, tool: T1}\ntools:\n  T1: {diameter: 11}\nconditions:\n  - {for: 1}\n",
    ] {
        texts.push(format!("{part}\n{rest}"));
    }
    let mut plans: Vec<Stated> = texts.iter().map(|text| stated("tests/audit", text)).collect();
    plans.push(stated("examples/appendix-g", &text("examples/appendix-g/plan.yaml")));
    plans.push(stated("tests/audit", &right));
    plans
}

/// Every scalar of a plan but its part and its reasons, by its pointer.
fn scalars(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                if !["part", "because", "alternatives", "findings", "visiting"].contains(&key.as_str()) {
                    scalars(value, &format!("{path}/{key}"), found);
                }
            }
        }
        Value::Array(items) => {
            found.push(path.to_owned());
            for (at, item) in items.iter().enumerate() {
                scalars(item, &format!("{path}/{at}"), found);
            }
        }
        _ => found.push(path.to_owned()),
    }
}

/// Plans of ours in which something is changed: whatever can be, at least once for each kind of place.
fn spoilt() -> Vec<Stated> {
    let ours = [
        ("examples/plate.yaml", CuttingMethod::Card),
        ("examples/variant-4.yaml", CuttingMethod::Formula),
        ("tests/parts/reamed-iron.yaml", CuttingMethod::Formula),
    ]
    .map(|(part, method)| serde_json::to_value(planned(&read(&text(part)), method)).unwrap());
    let mut places = Vec::new();
    for plan in &ours {
        let mut paths = Vec::new();
        scalars(plan, "", &mut paths);
        let kind = |path: &str| -> String { path.chars().filter(|letter| !letter.is_ascii_digit()).collect() };
        let kinds: BTreeMap<String, String> = paths.into_iter().map(|path| (kind(&path), path)).collect();
        places.extend(kinds.into_iter().map(|(kind, path)| (plan, kind, path)));
    }
    let mut plans = Vec::new();
    for (plan, _, path) in share(places, ours.len(), |(_, kind, _)| kind.clone()) {
        let mut plan = plan.clone();
        let value = plan.pointer_mut(&path).unwrap();
        *value = match &*value {
            Value::Number(number) => Value::from(number.as_f64().unwrap() * 3.0 + 1.0),
            Value::Bool(known) => Value::from(!known),
            Value::String(known) if known == "drill" => Value::from("mill"),
            Value::String(known) if known.parse::<f64>().is_ok() => Value::from("7"),
            Value::String(known) if known == "bore" => Value::from("cone"),
            Value::String(known) => Value::from(format!("{known}9")),
            Value::Array(items) => Value::from(items[..items.len().saturating_sub(1)].to_vec()),
            _ => continue,
        };
        let none = |_: &str| Err("no files here".to_owned());
        // Some changes make a plan that cannot be read.
        if let Ok(stated) = read_plan("plan.json", &plan.to_string(), &KNOWLEDGE, &none) {
            plans.push(stated);
        }
    }
    assert!(plans.len() > 50, "only {} plans of ours could be spoilt", plans.len());
    plans
}

/// What a browser shows of a page.
fn visible(page: &str) -> String {
    let body = page.split_once("</style>").unwrap().1;
    let mut shown = String::new();
    for piece in body.split('<').skip(1) {
        shown.push(' ');
        shown.push_str(piece.split_once('>').unwrap().1);
    }
    [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")]
        .iter()
        .fold(shown, |text, (from, to)| text.replace(from, to))
}

/// A page as each writer gives it out.
fn written(page: &Document) -> Vec<String> {
    let words = document::Words { left_out: "", see_all: "", help: "", figure: "" };
    let written = |format| document::write(page, format, 120, false, &words);
    vec![written(Format::Text), written(Format::Markdown), visible(&written(Format::Html))]
}

/// Every plan with its audit.
static PLANS: LazyLock<Vec<(Stated, Audit)>> = LazyLock::new(|| {
    let codes = Lang::codes();
    let known: Vec<&str> = rules::all().map(|rule| rule.id).chain(codes.iter().map(String::as_str)).collect();
    let scheme = "{points: 1000, deduct: {error: 5, wrong: 4, doubtful: 3, note: 2}, consequences: 1}";
    let scheme = read_scheme("marks.yaml", scheme, &known).unwrap();
    let marked = |stated: Stated| {
        let mut audit = AUDITOR.audit(&stated).unwrap();
        audit.marks = Some(scheme.mark(&audit));
        (stated, audit)
    };
    by_hand().into_iter().chain(spoilt()).map(marked).collect()
});

/// Every page there is, of every plan, by the name of the plan.
fn everything(lang: Lang) -> Vec<(String, String)> {
    let mut all = Vec::new();
    let mut audited = Vec::new();
    for (_, audit) in PLANS.iter() {
        all.extend(written(&page(audit, lang)).into_iter().map(|page| (audit.plan.clone(), page)));
        audited.push(Audited::Plan(Box::new(audit.clone())));
    }
    let none = |_: &str| Err("2".to_owned());
    for broken in ["part: [\n", "tools: {}\n", "part: here.yaml\n", &text("tests/audit/bad.yaml")] {
        let unreadable = read_plan("broken.yaml", broken, &KNOWLEDGE, &none).unwrap_err();
        audited.push(Audited::Unreadable(Unread::new("broken.yaml", &unreadable.problems, lang)));
    }
    all.extend(written(&many::page(&audited, &[], &[], lang)).into_iter().map(|page| ("folder".to_owned(), page)));
    // Some beside another of their kind, and one by hand beside one of ours.
    let pairs = PLANS.chunks_exact(2).step_by(3).map(|pair| (&pair[0].0, &pair[1].0));
    for (a, b) in pairs.chain(PLANS.first().zip(PLANS.last()).map(|(a, b)| (&a.0, &b.0))) {
        let compared = AUDITOR.compare(a, b).unwrap();
        let pages = written(&against::page(&compared, lang)).into_iter();
        all.extend(pages.map(|page| (format!("{} against {}", a.name, b.name), page)));
    }
    all
}

/// The longest runs of letters of an alphabet.
fn runs(text: &str, of: impl Fn(char) -> bool) -> impl Iterator<Item = &str> {
    text.split(move |letter| !of(letter)).filter(|run| !run.is_empty())
}

fn cyrillic(letter: char) -> bool {
    ('\u{400}'..='\u{52f}').contains(&letter)
}

/// A page without what stands in it on purpose: names of the plan and of files, ids of tables and rules where they are
/// named as such, our own commands, and what the spoilt plans say.
fn without_names(plan: &str, page: &str) -> Vec<String> {
    let page = page
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .replace(plan, "")
        .replace("technolog order", "")
        .replace("technolog table NAME", "");
    let of_file = |word: &str| [".yaml", ".yml", ".json", ".nc"].iter().any(|end| word.contains(end));
    let mut before = String::new();
    let mut kept = Vec::new();
    for word in page.split(' ') {
        let bare = word.trim_matches(|letter: char| "()[],;:.«»|*`".contains(letter));
        let named = ["таблиця", "table", "правилом", "правило", "rule"].contains(&before.as_str());
        let by_id = IDS.contains(bare) && (named || bare.contains('-'));
        if !(by_id || of_file(word) || HOLES.contains(&bare) || bare.ends_with('9')) {
            kept.push(word.to_owned());
        }
        before = bare.to_owned();
    }
    kept
}

/// Ids of tables, for `technolog table`, and of rules, for marking schemes.
static IDS: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
    let tables = KNOWLEDGE.tables().map(|table| table.id.clone());
    tables.chain(rules::all().map(|rule| rule.id).map(str::to_owned).chain(Lang::codes())).collect()
});

/// Groups of holes of the plans.
const HOLES: [&str; 3] = ["dowel", "screw", "flange"];

static UKRAINIAN: LazyLock<Vec<(String, String)>> = LazyLock::new(|| everything(Lang::UK));
static ENGLISH: LazyLock<Vec<(String, String)>> = LazyLock::new(|| everything(Lang::EN));

#[test]
fn the_ukrainian_pages_have_no_english() {
    // The largest of figures in a formula; the language of the files and the key that one of them lacks; our command.
    let known = ["max", "YAML", "part", "technolog", "plan"];
    let mut found: BTreeSet<String> = BTreeSet::new();
    for (plan, page) in UKRAINIAN.iter() {
        for word in without_names(plan, page) {
            let mut latin = runs(&word, |letter| letter.is_ascii_alphabetic() || letter == '_');
            if latin.any(|run| run.len() > 2 && !known.contains(&run)) {
                found.insert(format!("{plan}: {word}"));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn the_english_pages_have_no_ukrainian() {
    let symbols = Quantity::ALL.iter().map(|quantity| quantity.symbol());
    let symbols = symbols.chain(rules::all().map(|rule| rule.formula));
    let mut known: BTreeSet<&str> = symbols.flat_map(|symbol| runs(symbol, cyrillic)).collect();
    // The letter of the appendix; standards and a letter of their numbers.
    known.extend(["Г", "ОСТ", "ГОСТ", "ТУ", "И"]);
    let mut found: BTreeSet<String> = BTreeSet::new();
    for (plan, page) in ENGLISH.iter() {
        for word in without_names(plan, page) {
            if runs(&word, cyrillic).any(|run| !known.contains(run)) {
                found.insert(format!("{plan}: {word}"));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// Paths and keys of plan files, which only programs read.
#[test]
fn the_english_pages_have_no_paths() {
    let parts = ["route", "tools", "conditions", "clamping", "times", "holes", "sequence", "program"];
    let mut found: BTreeSet<String> = BTreeSet::new();
    for (plan, page) in ENGLISH.iter() {
        for word in without_names(plan, page) {
            let path = word.split_once('.').is_some_and(|(first, rest)| parts.contains(&first) && !rest.is_empty());
            if path || word.contains('_') {
                found.insert(format!("{plan}: {word}"));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn the_counts_of_the_sections_are_those_of_the_whole() {
    for (_, audit) in PLANS.iter() {
        let summary = &audit.summary;
        let sum = summary.sections.values().fold([0; 5], |sum, own| {
            let own = [own.error, own.wrong, own.doubtful, own.note, own.follow];
            std::array::from_fn(|at| sum[at] + own[at])
        });
        let all = summary.all;
        assert_eq!(sum, [all.error, all.wrong, all.doubtful, all.note, all.follow]);
    }
}
