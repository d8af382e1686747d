//! Programs for LinuxCNC and Fanuc: the motions of LinuxCNC are those of its own interpreter, every rule is broken by some
//! program, and no text makes the check panic.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use proptest::prelude::*;
use technolog::machine::Machine;
use technolog::motion::{Axis, Motion, MotionStep, Position, Sense, Turning};
use technolog::program::setting::Before;
use technolog::program::{Fault, Language, Setting};
use technolog::tables::controls::iso::ActiveComments;
use technolog_testing::KNOWLEDGE;

static LINUXCNC: LazyLock<Language> = LazyLock::new(|| Language::read("linuxcnc", &KNOWLEDGE).unwrap());
static FANUC: LazyLock<Language> = LazyLock::new(|| Language::read("fanuc", &KNOWLEDGE).unwrap());

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn folders(of: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(of)).unwrap().map(|entry| entry.unwrap().path());
    let mut folders: Vec<PathBuf> = entries.filter(|path| path.is_dir()).collect();
    folders.sort();
    folders
}

/// What is true between the motions, and the lines that tests/oracles/linuxcnc.py writes of what rs274 does.
struct Lines {
    at: Position,
    turning: Turning,
    speed: f64,
    coolant: bool,
    tool: u32,
    lines: Vec<String>,
}

impl Lines {
    fn take(&mut self, step: &MotionStep) {
        let moved = std::mem::replace(&mut self.at, step.at) != step.at;
        match &step.motion {
            Motion::Rapid if moved => self.line("rapid", String::new()),
            Motion::Feed { feed_mm_per_min } if moved => self.line("feed", format!(" F{}", feed_mm_per_min.0)),
            Motion::Arc { plane, sense, centre, turns, feed_mm_per_min } => {
                let sense = if *sense == Sense::Clockwise { "clockwise" } else { "counterclockwise" };
                let [a, b] = centre;
                let more = format!(" {sense} {} {a} {b} turns {turns} F{}", plane.name(), feed_mm_per_min.0);
                self.line("arc", more);
            }
            Motion::Dwell { seconds } if *seconds > 0.0 => self.line("dwell", format!(" seconds {seconds}")),
            Motion::Spindle { turning, speed_rpm } => (self.turning, self.speed) = (*turning, speed_rpm.0),
            Motion::Coolant { on } => self.coolant = *on,
            Motion::ToolChange { tool } => {
                self.tool = *tool;
                self.line("tool-change", String::new());
            }
            Motion::Auxiliary { word } => {
                let named = word.strip_prefix("M61 Q").and_then(|number| number.parse().ok());
                self.tool = named.unwrap_or(self.tool);
            }
            _ => {}
        }
    }

    fn line(&mut self, kind: &str, more: String) {
        let at = Axis::ALL.map(|axis| format!("{}{}", axis.letter(), self.at.get(axis))).join(" ");
        let spindle = match self.turning {
            Turning::Stopped => "stopped".to_owned(),
            Turning::Clockwise => format!("clockwise {}", self.speed),
            Turning::Counterclockwise => format!("counterclockwise {}", self.speed),
        };
        let coolant = if self.coolant { "on" } else { "off" };
        self.lines.push(format!("{kind} {at}{more} spindle {spindle} coolant {coolant} T{}", self.tool));
    }
}

/// Whether two lines say the same: words alike, numbers within a micrometre and the rounding of rs274.
fn same(ours: &str, theirs: &str) -> bool {
    let words = |line: &str| line.split(' ').map(str::to_owned).collect::<Vec<_>>();
    let (ours, theirs) = (words(ours), words(theirs));
    let number = |word: &str| word.trim_start_matches(['X', 'Y', 'Z', 'F', 'T']).parse::<f64>().ok();
    ours.len() == theirs.len()
        && ours.iter().zip(&theirs).all(|(a, b)| match (number(a), number(b)) {
            (Some(x), Some(y)) => {
                (x - y).abs() < 0.0016 && a.as_bytes()[0].is_ascii_alphabetic() == b.as_bytes()[0].is_ascii_alphabetic()
            }
            _ => a == b,
        })
}

#[test]
fn the_motions_for_linuxcnc_are_those_of_its_own_interpreter() {
    let (mut motions, mut refused, mut wrong) = (0, 0, Vec::new());
    for folder in folders("tests/programs-linuxcnc") {
        let read = |name: &str| fs::read_to_string(folder.join(name)).ok();
        let Some(theirs) = read("rs274") else { panic!("{} has no rs274: see the README there", folder.display()) };
        let machine = Machine::find(&KNOWLEDGE, read("machine").as_deref().map_or("ir500pmf4", str::trim)).unwrap();
        let setting = read("setting.yaml").map_or_else(Setting::default, |text| LINUXCNC.setting("", &text).unwrap());
        // rs274 has just been started.
        let setting = Setting { before: Before::PoweredOn, ..setting };
        let mut steps = Vec::<MotionStep>::new();
        let faults = LINUXCNC.check(&read("program.ngc").unwrap(), &machine, &setting, &mut steps);
        // What is told as traced otherwise is not the same.
        if faults.iter().any(|fault| fault.code == "traced-as-written") {
            continue;
        }
        let errors: Vec<&str> = faults.iter().filter(|fault| fault.is_error()).map(|fault| fault.code).collect();
        let grave = faults.iter().any(Fault::is_grave);
        let alone = folder.file_name().unwrap().to_string_lossy().starts_with("bad-only");
        if theirs.starts_with("refused") || alone {
            refused += 1;
            if !(if alone { grave } else { !errors.is_empty() }) && !folder.ends_with("bad-only-tool-beyond-magazine") {
                wrong.push(format!("{}: we do not refuse it, {theirs}", folder.display()));
            }
            continue;
        }
        let mut ours = Lines {
            at: setting.start,
            turning: Turning::Stopped,
            speed: 0.0,
            coolant: false,
            tool: 0,
            lines: Vec::new(),
        };
        steps.iter().for_each(|step| ours.take(step));
        let theirs: Vec<&str> = theirs.lines().filter(|line| !line.is_empty()).collect();
        motions += theirs.len();
        let differ = ours.lines.iter().zip(&theirs).find(|(ours, theirs)| !same(ours, theirs));
        if !errors.is_empty() || differ.is_some() || ours.lines.len() != theirs.len() {
            wrong.push(format!(
                "{}: {errors:?}, {} motions of {}, first {differ:?}",
                folder.display(),
                ours.lines.len(),
                theirs.len()
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(motions > 400 && refused > 60, "only {motions} motions and {refused} refusals");
}

/// The rows of a page's table of rules begin with the code.
fn rules(page: &str) -> Vec<String> {
    let page = fs::read_to_string(root().join(page)).unwrap();
    page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next().map(str::to_owned)).collect()
}

#[test]
fn every_rule_is_broken_by_some_program() {
    let mut seen = String::new();
    let of = ["linuxcnc", "fanuc", "haas", "mach3", "grbl"];
    for folder in of.iter().flat_map(|control| folders(&format!("tests/programs-{control}"))) {
        seen.push_str(&fs::read_to_string(folder.join("expected")).unwrap());
    }
    let rules = rules("docs/control-linuxcnc.md");
    assert!(rules.len() > 50, "the page names {} rules", rules.len());
    // Its program is too large to keep: a test of `nc` has a smaller bound.
    // The other is told only where nothing is said of what ran before (`cases::a_program_alone_sets_the_modes_that_it_relies_on`).
    let elsewhere = ["too-many-blocks", "habit-left-over", "limit-not-checked"];
    let broken = |code: &str| elsewhere.contains(&code) || seen.contains(&format!(" {code}"));
    let unbroken: Vec<&String> = rules.iter().filter(|code| !broken(code)).collect();
    assert!(unbroken.is_empty(), "no program breaks {unbroken:?}");
    let faults = seen.lines().filter_map(|line| line.split_once(' ')).filter(|(place, _)| place.contains(':'));
    let unknown: Vec<&str> = faults
        .map(|(_, rest)| rest.split(' ').next().unwrap())
        .filter(|code| !rules.iter().any(|rule| rule == code))
        .collect();
    assert!(unknown.is_empty(), "docs/control-linuxcnc.md does not name {unknown:?}");
}

/// A page of a control says of each rule on which page it rests, or that nobody has confirmed it, or that it is ours.
#[test]
fn every_rule_names_the_page_that_it_rests_on() {
    let mut wrong = Vec::new();
    let mut told = 0;
    for page in ["linuxcnc", "fanuc", "haas", "mach3", "grbl"] {
        let text = fs::read_to_string(root().join(format!("docs/control-{page}.md"))).unwrap();
        // Only tables whose last column says what the rule rests on.
        let mut says = false;
        for line in text.lines() {
            let cells: Vec<&str> = line.trim_matches('|').split(" | ").map(str::trim).collect();
            match line.strip_prefix('|') {
                None => says = false,
                Some(_) if cells.last().is_some_and(|last| ["rests on", "page"].contains(last)) => says = true,
                Some(rest) if rest.starts_with("---") => {}
                Some(_) if says => {
                    told += 1;
                    if !cells.last().is_some_and(|last| names_a_page(last)) {
                        wrong.push(format!("{page}: {line}"));
                    }
                }
                Some(_) => {}
            }
        }
    }
    assert!(told > 150, "only {told} rules");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Of 2С42-65 it is a section of its description, with a star where that is thin.
    let text = fs::read_to_string(root().join("docs/control-2c42-65.md")).unwrap();
    for line in text.lines().filter(|line| line.starts_with("| `")) {
        let section = line.split(" | ").nth(2).unwrap();
        assert!(section.starts_with(|sign: char| sign.is_ascii_digit()) || section == "\\*", "{line}");
    }
}

/// Whether a cell names an address, a page of a named manual, a file of a public source or of the record, a program of rs274
/// that stands here, or says that there is none.
fn names_a_page(cell: &str) -> bool {
    let rs274 = cell.split("rs274: `").skip(1).filter_map(|rest| rest.split('`').next());
    let stands = |name: &str| name.contains('*') || root().join("tests/programs-linuxcnc").join(name).is_dir();
    if !rs274.into_iter().all(stands) {
        return false;
    }
    let words =
        ["rs274", "unconfirmed", "ours", "github", "code index, file", ", p. ", "`grbl/", "`interp_", "](control-"];
    let address = cell.split(['(', ' ', ',']).any(|word| {
        let host = word.split('/').next().unwrap_or_default();
        word.contains('/')
            && host.contains('.')
            && host.chars().all(|sign| sign.is_ascii_alphanumeric() || ".-".contains(sign))
    });
    let others = ["the record of the machine", "as RS274/NGC", "the same list", "the same page"];
    address || words.iter().chain(&others).any(|word| cell.contains(word))
}

#[test]
fn the_command_checks_every_control() {
    for (control, program) in [
        ("2c42-65", "tests/programs/four-holes/program.nc"),
        ("linuxcnc", "tests/programs-linuxcnc/pecks/program.ngc"),
        ("fanuc", "tests/programs-fanuc/pecks/program.nc"),
        ("haas-ngc", "tests/programs-haas/pecks/program.nc"),
        ("mach3", "tests/programs-mach3/cycle-rises/program.nc"),
        ("grbl", "tests/programs-grbl/change-by-hand/program.nc"),
    ] {
        let folder = Path::new(program).parent().unwrap().join("setting.yaml");
        let mut arguments = vec!["check", program, "--control", control, "--machine", "ir500pmf4", "--lang", "en"];
        let setting = folder.to_string_lossy().into_owned();
        if root().join(&folder).exists() {
            arguments.extend(["--setting", &setting]);
        }
        let output =
            Command::new(env!("CARGO_BIN_EXE_technolog")).args(&arguments).current_dir(root()).output().unwrap();
        let text = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert_eq!(output.status.code(), Some(0), "{control}: {text}");
        assert!(text.contains("Time, min\n"), "{control}: {text}");
    }
}

#[test]
fn a_setting_has_only_what_its_control_has() {
    for (language, text, codes) in [
        (&*FANUC, "g83_clearance: 0.5\ng73_retract: 0\n", vec!["bad-value"]),
        (&*LINUXCNC, "g83_clearance: 0.5\n", vec!["unknown-key"]),
        (&*LINUXCNC, "mirror: [X]\nhomed: false\nzeros: {CM1: {x: 1}}\n", vec!["unknown-key"; 3]),
        (&*LINUXCNC, "feed_override: 37\nspeed_override: 49\n", vec!["bad-override"]),
        (&*FANUC, "feed_override: 37\ncorrectors: {401: 1}\n", vec!["bad-override", "bad-corrector"]),
    ] {
        let problems = language.setting("setting.yaml", text).unwrap_err();
        let found: Vec<&str> = problems.iter().map(|problem| problem.code).collect();
        assert_eq!(found, codes, "{text}");
    }
}

fn run(language: &Language, text: &str) -> (Vec<Fault>, Vec<MotionStep>) {
    let machine = Machine::find(&KNOWLEDGE, "ir500pmf4").unwrap();
    let mut steps = Vec::new();
    let faults = language.check(text, &machine, &Setting::default(), &mut steps);
    (faults, steps)
}

/// Repeats of repeats, endless ways and steps of a micrometre end by the budget.
#[test]
fn no_repetition_lasts() {
    for text in [
        "O1\nM98 P2 L9999\nM30\nO2\nM98 P3 L9999\nM99\nO3\nM99\n",
        "O1\nG90 S475 M3 F100\nG0 Z-1\nG99 G81 X1 Z-3 R-2 K99999\nX2 K99999\nX3 K99999\nX4 K99999\nM30\n",
        "O1\nG90 S475 M3 F100\nG83 X1 Z-400 R-1 Q0.001\nX2\nM30\n",
    ] {
        let begin = std::time::Instant::now();
        for language in [&*LINUXCNC, &*FANUC] {
            run(language, &text.replace('K', if std::ptr::eq(language, &*FANUC) { "K" } else { "L" }));
        }
        // Not a measurement: what is not held by the budget takes hours.
        assert!(begin.elapsed().as_secs() < 60, "{text}");
    }
}

/// Words as programs have them, in any order: they reach far more of the interpreter than any bytes do.
fn program() -> impl Strategy<Value = String> {
    let word = prop_oneof![
        prop::sample::select(vec![
            "G0",
            "G1",
            "G2",
            "G3",
            "G4 P1",
            "G17",
            "G18",
            "G19",
            "G20",
            "G21",
            "G28",
            "G30",
            "G40",
            "G43",
            "G49",
            "G53",
            "G54",
            "G55",
            "G61",
            "G64",
            "G73",
            "G80",
            "G81",
            "G82",
            "G83",
            "G84",
            "G85",
            "G86",
            "G89",
            "G90",
            "G91",
            "G94",
            "G98",
            "G99",
            "M0",
            "M1",
            "M3",
            "M4",
            "M5",
            "M6",
            "M7",
            "M8",
            "M9",
            "M19",
            "M29",
            "M98 P2",
            "M98 P20002",
            "M99",
            "H1",
            "L3",
            "K2",
            "P1",
            "Q3",
            "Q.001",
            "R2",
            "R-5",
            "F100",
            "S475",
            "T1",
            "/",
            "%",
            "(a)",
            ";",
            "O2",
            "O100 call",
            "o100 sub\n",
            "o100 endsub\n",
            "o<a> call",
            "o100 return",
            "\nO2\n",
            "\n/",
        ])
        .prop_map(str::to_owned),
        ("[XYZIJKRQP]", -60_i32..60).prop_map(|(address, value)| format!("{address}{value}")),
        ("[XYZ]", -60_000_i32..60_000).prop_map(|(address, value)| format!("{address}{}", f64::from(value) / 1000.0)),
        "[A-Z]-?[0-9]{0,6}[.]?[0-9]{0,7}",
        Just("\n".to_owned()),
        Just("\nN1 ".to_owned()),
    ];
    prop::collection::vec(word, 0..60).prop_map(|words| format!("G90 S475 M3 F100\n{}\nM30\n", words.join(" ")))
}

/// A program of the tests with a stretch of its characters taken out, doubled or put elsewhere.
fn mutated() -> impl Strategy<Value = String> {
    static TEXTS: LazyLock<Vec<String>> = LazyLock::new(|| {
        let linuxcnc = folders("tests/programs-linuxcnc").into_iter().map(|folder| folder.join("program.ngc"));
        let fanuc = folders("tests/programs-fanuc").into_iter().map(|folder| folder.join("program.nc"));
        // Those that use up the budget would only take time.
        let texts = linuxcnc.chain(fanuc).map(|path| fs::read_to_string(path).unwrap());
        texts.filter(|text| !text.contains("L9999")).collect()
    });
    (0..TEXTS.len(), any::<[prop::sample::Index; 3]>(), 0..3_usize).prop_map(|(index, places, how)| {
        let characters: Vec<char> = TEXTS[index].chars().collect();
        let mut cuts = places.map(|place| place.index(characters.len() + 1));
        cuts.sort_unstable();
        let [a, b, c] = cuts;
        let part = |from: usize, to: usize| characters[from..to].iter().collect::<String>();
        let end = characters.len();
        match how {
            0 => part(0, a) + &part(b, end),
            1 => part(0, b) + &part(a, end),
            _ => part(0, a) + &part(b, c) + &part(a, b) + &part(c, end),
        }
    })
}

fn check_program(text: &str) -> Result<(), TestCaseError> {
    for language in [&*LINUXCNC, &*FANUC] {
        let (faults, steps) = run(language, text);
        for fault in faults {
            let line = text.lines().nth((fault.span.line as usize).saturating_sub(1)).unwrap_or_default();
            prop_assert!(fault.span.column as usize <= line.chars().count().max(1), "{fault:?}");
        }
        prop_assert!(steps.len() <= 1_100_000);
    }
    Ok(())
}

proptest! {
    #![proptest_config(technolog_laws::cases!(300))]

    #[test]
    fn no_words_make_it_panic_and_every_place_is_in_the_text(text in program()) {
        check_program(&text)?;
    }

    #[test]
    fn no_mutation_of_a_program_makes_it_panic(text in mutated()) {
        check_program(&text)?;
    }

    #[test]
    fn no_text_makes_it_panic(text in "\\PC{0,80}(\n\\PC{0,40}){0,4}") {
        check_program(&text)?;
    }

    /// Where every word is written, one hole at a time and a cycle that goes on reach the same places.
    #[test]
    fn a_cycle_that_goes_on_is_the_cycle_written_again(points in prop::collection::vec((-90_i32..90, -90_i32..90), 1..12)) {
        let head = "G90 G98 S475 M3 F100\nG0 X0 Y0 Z-10\n";
        let cycle = |x: &i32, y: &i32| format!("G83 X{x} Y{y} Z-40 R-20 Q7\n");
        let again: String = points.iter().map(|(x, y)| cycle(x, y)).collect();
        let on: String = points.iter().enumerate().map(|(index, (x, y))| if index == 0 { cycle(x, y) } else { format!("X{x} Y{y}\n") }).collect();
        for language in [&*LINUXCNC, &*FANUC] {
            let at = |text: &str| -> Vec<_> { run(language, &format!("{head}{text}G80\nM30\n")).1.iter().map(|step| step.at).collect() };
            prop_assert_eq!(at(&again), at(&on));
        }
    }
}

/// F of G93 counts ways in a minute and has no unit of length, so no inches are made of it nor millimetres of them.
#[test]
fn a_feed_by_time_is_read_back_as_it_was_given() {
    let (faults, steps) = run(&LINUXCNC, "G20 G90 G17 S500 M3\nG93 G1 X1 F2\nX#<_feed> F2\nG94 F8\nX0 Y#<_feed>\nM2\n");
    assert!(!faults.iter().any(Fault::is_error), "{faults:?}");
    let fed = steps.iter().filter(|step| matches!(step.motion, Motion::Feed { .. }));
    let at: Vec<String> = fed.map(|step| format!("{} {}", step.at.x, step.at.y)).collect();
    assert_eq!(at, ["25.4 0", "50.8 0", "0 203.2"]);
}

/// G33.1 does not follow the feed switch: with the switch at nothing its pitch is not told as endless.
#[test]
fn a_tap_under_a_feed_switch_at_nothing_has_no_pitch() {
    let machine = Machine::find(&KNOWLEDGE, "ir500pmf4").unwrap();
    let setting = Setting { feed_override: 0, ..Setting::default() };
    let text = "G21 G90 G17 G94 S475 M3\nG33.1 Z-10 K1\nM5\nM2\n";
    let faults = LINUXCNC.check(text, &machine, &setting, &mut Vec::<MotionStep>::new());
    assert!(faults.iter().all(|fault| !fault.is_error() && !fault.code.starts_with("tap-feed")), "{faults:?}");
}

/// What a proof with the part says better is marked: whose feed and speed act, dwells, offsets; not a tool that no M6 brought.
#[test]
fn what_a_proof_says_better_is_marked() {
    for (folder, marked) in [
        ("bad-of-tool-before", vec!["feed-of-tool-before", "speed-of-tool-before"]),
        ("bad-tool-not-brought", vec!["hole-again"]),
        ("bad-only-register", vec!["offset-of-strange-number"]),
    ] {
        let text = fs::read_to_string(root().join("tests/programs-fanuc").join(folder).join("program.nc")).unwrap();
        let faults = run(&FANUC, &text).0;
        assert!(faults.iter().any(|fault| !fault.of_program_alone), "{folder}: {faults:?}");
        let mut codes: Vec<_> = faults.iter().filter(|fault| fault.of_program_alone).map(|fault| fault.code).collect();
        codes.sort_unstable();
        assert_eq!(codes, marked, "{folder}");
    }
}

#[test]
fn no_name_of_a_part_becomes_a_comment_that_acts() {
    let machine = Machine::find(&KNOWLEDGE, "ir500pmf4").unwrap();
    let is_reported = |comment: &str| {
        let text = format!("({comment})\nM2\n");
        let faults = LINUXCNC.check(&text, &machine, &Setting::default(), &mut Vec::<MotionStep>::new());
        faults.iter().any(|fault| ["active-comment", "message-comment"].contains(&fault.code))
    };
    let rows = KNOWLEDGE.rows::<ActiveComments<'_>>().unwrap();
    assert!(rows.len() > 10);
    for ActiveComments { begins, .. } in rows {
        let names = [begins.to_owned(), format!(" {}", begins.to_lowercase()), format!("{begins}file")];
        let mut acted = 0;
        for name in &names {
            acted += usize::from(is_reported(name));
            assert!(!is_reported(&technolog::ascii::ascii(name)), "{name}");
        }
        assert!(acted >= 2, "{begins}");
    }
    assert_eq!(technolog::ascii::ascii("Плита, варіант 1"), "PLYTA, VARIANT 1");
}
