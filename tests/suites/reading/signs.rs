//! Signs that nobody should see: refused where people name things, and shown as others wherever they come from.

use std::fs;

use technolog::document::cleaned;
use technolog::knowledge::input::unseen;
use technolog::part::read_part;
use technolog::plan::CuttingMethod;
use technolog::report::{Doubts, sheet};
use technolog::words::Lang;
use technolog_testing::pages::shown_at;
use technolog_testing::{KNOWLEDGE, planned, read, root};

use super::{Said, command, folder};

/// What steers a terminal, turns a line, and ends one.
const SIGNS: [(&str, &str); 4] =
    [(r"\e[2J", "control-character"), (r"\u202E", "control-character"), (r"\n", "line-break"), (r"\t", "line-break")];

fn part(name: &str, hole: &str) -> String {
    format!(
        "part: {name}\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 400, width: 200, thickness: 40}}\n\
         holes:\n  - {{name: {hole}, diameter: 10, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, at: [[50, 0]]}}\n"
    )
}

/// A file with a sign in a text of it, by the name of the file.
fn spoilt(sign: &str) -> Vec<(&'static str, String)> {
    let text = |text: &str| format!("\"a{sign}{text}\"");
    let example = |file: &str| fs::read_to_string(root().join(file)).unwrap();
    // Beside the plan: it names no other files.
    let plate = "plate.part";
    let plan = example("tests/audit/right.yaml").replacen("../../examples/plate.yaml", plate, 1);
    vec![
        ("part.yaml", part(&text("b"), "A")),
        ("hole.yaml", part("P", &text("b"))),
        ("tool.plan.yaml", plan.replacen("035-2317-0103", &text("b"), 1)),
        ("name.plan.yaml", plan.replacen("Плита без описок", &text("b"), 1)),
        ("marks.yaml", format!("scheme: {}\npoints: 10\n", text("b"))),
        ("shaft.yaml", example("examples/shaft.yaml").replacen("shaft: ", &format!("shaft: {} # ", text("b")), 1)),
        (
            "contour.yaml",
            example("examples/turned-pin.yaml").replacen("shaft: ", &format!("shaft: {} # ", text("b")), 1),
        ),
        (
            "case.test.yaml",
            format!("tests:\n  - {{name: {}, table: A.8, given: {{it: 7}}, expect: none}}\n", text("b")),
        ),
        ("setting.yaml", format!("{}: 1\n", text("b"))),
    ]
}

fn run(folder: &std::path::Path, file: &str) -> Said {
    let arguments: &[&str] = match file {
        "marks.yaml" => &["audit", "sound.yaml", "--marks", file],
        "setting.yaml" => &["check", "end.nc", "--control", "linuxcnc", "--setting", file],
        _ if file.ends_with(".plan.yaml") => &["audit", file],
        _ if file.ends_with(".test.yaml") => &["test", file],
        "shaft.yaml" | "contour.yaml" => &["turn", file],
        _ => &["plan", file],
    };
    command(folder, arguments, b"")
}

/// Whether a terminal shows every sign of a text.
fn visible(text: &str) -> bool {
    unseen(text).is_none() && !text.contains('\t')
}

#[test]
fn no_name_has_a_sign_that_nobody_sees() {
    let folder = folder("signs");
    fs::write(folder.join("sound.yaml"), "part: x.yaml\n").unwrap();
    fs::copy(root().join("examples/plate.yaml"), folder.join("plate.part")).unwrap();
    fs::write(folder.join("end.nc"), "%\nM30\n%\n").unwrap();
    for (sign, code) in SIGNS {
        for (file, text) in spoilt(sign) {
            fs::write(folder.join(file), &text).unwrap();
            let answer = run(&folder, file);
            assert_eq!(answer.code, Some(2), "{file} {sign}: {}", answer.beside);
            assert!(answer.beside.contains(&format!("error[{code}]: ")), "{file} {sign}: {}", answer.beside);
            assert!(answer.beside.contains(&format!(" --> {file}:")), "{file} {sign}: {}", answer.beside);
            assert!(visible(&answer.answer) && visible(&answer.beside), "{file} {sign}: {}", answer.beside);
        }
    }
}

#[test]
fn a_plan_of_ours_has_names_of_one_line() {
    let folder = folder("own-plans");
    fs::write(folder.join("part.yaml"), part("P", "A")).unwrap();
    let plan = command(&folder, &["plan", "part.yaml", "--format", "json"], b"").answer;
    for (sign, code) in SIGNS {
        // JSON writes ESC otherwise than YAML.
        let sign = sign.replace(r"\e", r"\u001b");
        let spoilt = plan.replacen("\"part\": \"P\"", &format!("\"part\": \"a{sign}b\""), 1);
        assert_ne!(spoilt, plan);
        fs::write(folder.join("plan.json"), spoilt).unwrap();
        let answer = command(&folder, &["audit", "plan.json"], b"");
        assert!(
            answer.code == Some(2) && answer.beside.contains(&format!("error[{code}]: ")),
            "{sign}: {}",
            answer.beside
        );
    }
}

#[test]
fn what_is_refused_is_what_writers_do_not_show() {
    for sign in (0..=0x10_FFFF).filter_map(char::from_u32).filter(|sign| !matches!(sign, '\n' | '\t')) {
        let text = sign.to_string();
        let hidden = cleaned(&text) != text;
        assert_eq!(unseen(&text).is_some(), hidden, "U+{:04X}", u32::from(sign));
    }
}

#[test]
fn the_name_of_a_file_steers_nothing() {
    let folder = folder("file-names");
    let name = "a\u{1b}[2J\u{202e}b.yaml";
    fs::create_dir_all(folder.join("plans")).unwrap();
    fs::write(folder.join("plans").join(name), "part: [\n").unwrap();
    fs::write(folder.join("plans/c\u{1b}.yaml"), "a: 1\n").unwrap();
    let path = format!("plans/{name}");
    for arguments in
        [["plan", path.as_str()], ["audit", &path], ["audit", "plans"], ["check", &path], ["plan", "--no\u{1b}"]]
    {
        let answer = command(&folder, &arguments, b"");
        assert!(
            visible(&answer.answer) && visible(&answer.beside),
            "{arguments:?}: {}{}",
            answer.answer,
            answer.beside
        );
        assert!((answer.answer + &answer.beside).contains('\u{fffd}'), "{arguments:?}");
    }
    // Programs get the name as it is, in figures; whatever a terminal may be shown has another sign in its place.
    let json = command(&folder, &["audit", "plans", "--format", "json"], b"").answer;
    assert!(visible(&json) && json.contains(r"a\u001b[2J\u202eb.yaml"), "{json}");
    let read: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(read[0]["file"], format!("plans/{name}"));
    let case = "c\u{9b}2J\u{202e}.test.yaml";
    fs::write(folder.join("plans").join(case), "tests: [{table: A.8, given: {it: 7}, expect: {scheme: 99}}]\n")
        .unwrap();
    for arguments in [
        &["audit", "plans", "--format", "yaml"][..],
        &["test", "plans", "--format", "json"],
        &["test", "plans", "--format", "junit"],
        &["test", "plans", "--format", "html"],
    ] {
        let answer = command(&folder, arguments, b"");
        assert!(!answer.answer.is_empty() && visible(&answer.answer), "{arguments:?}: {}", answer.answer);
    }
}

#[test]
fn a_sign_of_no_width_in_a_key_is_shown() {
    let folder = folder("no-width");
    let text = part("P", "A").replacen("material:", "mate\u{200b}rial:", 1);
    fs::write(folder.join("part.yaml"), text).unwrap();
    let stderr = command(&folder, &["plan", "part.yaml"], b"").beside;
    assert!(stderr.contains("unknown key `mate\\u{200b}rial`"), "{stderr}");
    assert!(stderr.contains("did you mean `material`?"), "{stderr}");
}

/// Else two groups would have the same name for all who read the plan.
#[test]
fn a_sign_of_no_width_in_a_name_is_refused() {
    for sign in [r"\u200B", r"\u00AD", r"\u2060", r"\uFEFF", r"\u115F", r"\u3164", r"\U000E0041"] {
        for (text, place) in [(part(&format!("\"P{sign}\""), "A"), "1:7"), (part("P", &format!("\"A{sign}\"")), "6:12")]
        {
            let problems = read_part("p", &text, &KNOWLEDGE).unwrap_err();
            let [problem] = &problems[..] else { panic!("{sign}: {problems:?}") };
            let at = problem.place.as_ref().unwrap();
            assert_eq!((problem.code, format!("{}:{}", at.line, at.column).as_str()), ("control-character", place));
        }
    }
}

#[test]
fn marks_of_markdown_html_and_xml_in_a_name_are_only_read() {
    let folder = folder("marks");
    let name = r#"'<i>|`*_&"'"#;
    fs::write(folder.join("part.yaml"), part(name, name)).unwrap();
    for arguments in [
        &["plan", "part.yaml", "--format", "html"][..],
        &["plan", "part.yaml", "--format", "markdown"],
        &["order", "part.yaml", "--format", "svg"],
        &["program", "part.yaml", "--show", "cycles"],
        &["program", "part.yaml", "--show", "backplot"],
        &["explain", "part.yaml", "--hole", r#"<i>|`*_&""#, "--format", "markdown"],
    ] {
        let answer = command(&folder, arguments, b"").answer;
        assert!(!answer.is_empty() && !answer.replace(r"\<i", "").contains("<i>"), "{arguments:?}: {answer}");
        let marks = answer.split('&').skip(1).all(|behind| {
            ["amp;", "lt;", "gt;", "quot;", "#39;", "#32;"].iter().any(|known| behind.starts_with(known))
        });
        assert!(marks || arguments.contains(&"markdown"), "{arguments:?}: {answer}");
    }
}

#[test]
fn names_that_look_alike_are_told() {
    let of = |first: &str, second: &str| {
        let text = part("P", first);
        let group = text.lines().last().unwrap().replace(first, second).replace("[[50, 0]]", "[[-50, 0]]");
        planned(&read(&(text.clone() + &group + "\n")), CuttingMethod::Formula)
    };
    let findings_of = |plan: &technolog::plan::Plan| {
        let own = plan.findings.iter().filter(|finding| finding.note.code() == "names-look-alike");
        own.map(|finding| Lang::EN.say(&finding.note)).collect::<Vec<_>>()
    };
    // The second is Cyrillic.
    let plan = of("Ax1", "Ах1");
    let message = "2 groups are named Ax1: their letters look the same, but some are Latin and some Cyrillic; write all names \
                in one alphabet";
    assert_eq!(findings_of(&plan), [message]);
    assert!(!plan.has_errors(), "it is planned all the same");
    let page = shown_at(200, &sheet::page(&plan, &KNOWLEDGE, Doubts::Counted, Lang::EN));
    assert!(page.contains("2 groups are named Ax1"), "{page}");
    assert_eq!(findings_of(&of("A1", "A2")), [""; 0]);
    assert!(read_part("p", &part("P", "А"), &KNOWLEDGE).is_ok());
}
