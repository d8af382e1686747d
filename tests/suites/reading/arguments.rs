//! Arguments that name what is not there: which there are stands in the message.

use std::fs;

use technolog::program::lathe::recognised;
use technolog_testing::root;

use super::{command, folder};

#[test]
fn what_is_not_there_is_told_with_what_is() {
    let folder = folder("arguments");
    for (name, file) in [("plate.yaml", "examples/plate.yaml"), ("pin.yaml", "examples/turned-pin.yaml")] {
        fs::copy(root().join(file), folder.join(name)).unwrap();
    }
    let part = fs::read_to_string(root().join("examples/plate.yaml")).unwrap();
    fs::write(folder.join("foo.yaml"), part.replace("machine: gf2171", "machine: foo")).unwrap();
    fs::write(folder.join("points.csv"), "0,0\n1,1\n").unwrap();
    fs::write(folder.join("program.nc"), "%\n:01\nN1 M02\n").unwrap();
    for (arguments, message, help) in [
        (
            "order points.csv --machine foo",
            "[unknown-machine]: the catalog has no machine `foo`",
            "there are: gf2171, gf2171-linuxcnc, haas-vf5-50, ir500pmf4",
        ),
        ("order points.csv --metric rapid --machine foo", "[unknown-machine]", "there are: gf2171"),
        ("check program.nc --machine foo", "[unknown-machine]", "there are: gf2171"),
        ("check program.nc --control linuxcnc-lathe --machine gf2171", "[unknown-machine]", "16k20f3"),
        ("check program.nc --control linuxcnc-lathe --machine 16К21Ф3", "[unknown-machine]", "16k20f3"),
        (
            "check program.nc --control fanuc-lathe --part pin.yaml --machine 16А20Ф3",
            "[other-machine]",
            "leave out --machine",
        ),
        ("plan plate.yaml --format pdf", "pdf", "text, markdown, html, json, yaml, hand"),
        ("lookup A.8 it=7 roughness=Ra2,5", "a decimal part stands after a point, `Ra 2.5`", "Ra 2.5 or Ra 1.25"),
        ("program foo.yaml", "--> foo.yaml:5:10", "gf2171, gf2171-linuxcnc, haas-vf5-50, ir500pmf4"),
        ("order foo.yaml", "--> foo.yaml:5:10", "gf2171, gf2171-linuxcnc, haas-vf5-50, ir500pmf4"),
        ("check program.nc --part foo.yaml", "--> foo.yaml:5:10", "gf2171, gf2171-linuxcnc, haas-vf5-50, ir500pmf4"),
        ("explain plate.yaml --hole В", "[unknown-hole]", "the part file has `B`"),
        ("explain plate.yaml --hole zzz", "[unknown-hole]", "A, B"),
        ("explain plate.yaml", "[hole-missing]: which group of holes is meant", "help: there are: A, B"),
        ("table A.18", "[unknown-table]", "`A.18a`, `A.18b`"),
        ("turn pin.yaml --show program --number 9", "[no-such-program]", "help: give one of these with --number: 1: "),
    ] {
        let answer = command(&folder, &arguments.split(' ').collect::<Vec<_>>(), b"");
        assert_eq!((answer.code, answer.answer.as_str()), (Some(2), ""), "{arguments}: {}", answer.beside);
        assert!(answer.beside.contains(message) && answer.beside.contains(help), "{arguments}: {}", answer.beside);
    }
}

/// Machines and tables as people call them, with Cyrillic letters.
#[test]
fn what_is_called_otherwise_is_found() {
    let folder = folder("called");
    let part = fs::read_to_string(root().join("examples/plate.yaml")).unwrap();
    fs::write(folder.join("plate.yaml"), part.replace("machine: gf2171", "machine: ГФ2171")).unwrap();
    fs::write(folder.join("points.csv"), "0,0\n1,1\n").unwrap();
    fs::copy(root().join("examples/turned-sleeve.yaml"), folder.join("sleeve.yaml")).unwrap();
    let written = ["turn", "sleeve.yaml", "--show", "program", "--control", "linuxcnc", "-o", "sleeve.nc"];
    assert_eq!(command(&folder, &written, b"").code, Some(0));
    for arguments in [
        "plan plate.yaml",
        "order points.csv --machine ГФ2171",
        "check sleeve.nc --control linuxcnc-lathe --machine 16К20Ф3",
        "table А.18б",
        "table A.18b",
    ] {
        let answer = command(&folder, &arguments.split(' ').collect::<Vec<_>>(), b"");
        assert!(answer.code != Some(2), "{arguments}: {}", answer.beside);
    }
    // The lathe of the part moves at its own rapids, as the one that is named.
    let times = |more: &[&str]| {
        let check = ["check", "sleeve.nc", "--control", "linuxcnc-lathe", "--format", "json"];
        let answer = command(&folder, &[&check[..], more].concat(), b"").answer;
        serde_json::from_str::<serde_json::Value>(&answer).unwrap()["time"].clone()
    };
    let own = times(&["--part", "sleeve.yaml"]);
    assert!(!own["rapid_min"].is_null(), "{own}");
    let machine = fs::read_to_string(folder.join("sleeve.yaml")).unwrap();
    let machine = machine.lines().find_map(|line| line.strip_prefix("machine: ")).unwrap().trim().to_owned();
    assert_eq!(own, times(&["--machine", &machine]));
}

/// A student checks what `turn` wrote and forgets the control: one message, naming it, instead of a hundred wrong words.
#[test]
fn a_program_of_a_lathe_is_told_from_that_of_a_mill() {
    let folder = folder("lathe-program");
    let part = root().join("examples/turned-sleeve.yaml");
    let part = part.to_str().unwrap();
    for (control, reader) in [("linuxcnc", "linuxcnc-lathe"), ("fanuc", "fanuc-lathe"), ("sinumerik", "sinumerik")] {
        let file = format!("{control}.nc");
        let written = command(&folder, &["turn", part, "--show", "program", "--control", control, "-o", &file], b"");
        assert_eq!(written.code, Some(0), "{}", written.beside);
        let answer = command(&folder, &["check", &file], b"");
        assert_eq!((answer.code, answer.answer.as_str()), (Some(2), ""), "{control}: {}", answer.beside);
        let expected = format!(
            "error[program-of-lathe]: this is a program of a lathe, and 2c42-65 is the control of a mill\n\
             help: name the control of the lathe: --control {reader}\n"
        );
        assert_eq!(answer.beside, expected);
        let answer = command(&folder, &["check", &file, "--control", reader, "--part", part, "--set-up", "1"], b"");
        assert_eq!(answer.code, Some(0), "{control}: {}{}", answer.answer, answer.beside);
    }
}

/// No program of a mill in the repository is taken for one of a lathe.
#[test]
fn no_program_of_a_mill_is_taken_for_one_of_a_lathe() {
    let mut programs = vec![root().join("examples/appendix-g/program.nc")];
    let mut folders: Vec<_> = ["programs", "programs-linuxcnc", "programs-fanuc", "audit-programs", "written", "proof"]
        .map(|name| root().join("tests").join(name))
        .into();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                programs.push(path);
            }
        }
    }
    assert!(programs.len() > 300, "{}", programs.len());
    for path in programs {
        let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
        assert!(recognised(&text).is_empty(), "{}", path.display());
    }
}

/// `turn --show program` writes one set-up: it says which, and how the others are had.
#[test]
fn a_program_of_one_set_up_says_how_the_others_are_had() {
    let folder = folder("one-set-up");
    let part = root().join("examples/turned-sleeve.yaml");
    let part = part.to_str().unwrap();
    for (number, other) in [("1", "2"), ("2", "1")] {
        let answer = command(&folder, &["turn", part, "--show", "program", "--number", number], b"");
        let shown =
            format!("this is program {number} of 2, for set-up {number} only; for the others: --number {other}\n");
        assert!(answer.beside.contains(&shown), "{}", answer.beside);
    }
}

/// A program of a part that is not made whole is not written; `--force` writes it, and its first line says why it must not be run,
/// for every control. Fanuc keeps only what stands behind the number of the program, so it stands there, too.
#[test]
fn a_program_of_an_unfinished_part_is_written_by_force_alone() {
    let folder = folder("unfinished-turned");
    let part = root().join("examples/turned-pin.yaml");
    let part = part.to_str().unwrap();
    for (control, mark) in [("linuxcnc", "(DO NOT RUN: "), ("fanuc", "(DO NOT RUN: "), ("sinumerik", "; DO NOT RUN: ")]
    {
        let asked = ["turn", part, "--show", "program", "--number", "2", "--control", control];
        let answer = command(&folder, &asked, b"");
        assert_eq!((answer.code, answer.answer.as_str()), (Some(1), ""), "{control}: {}", answer.beside);
        assert!(answer.beside.contains("[not-written]") && answer.beside.contains("--force"), "{}", answer.beside);
        let forced = command(&folder, &[&asked[..], &["--force"]].concat(), b"");
        assert_eq!(forced.code, Some(1), "{control}: {}", forced.beside);
        let first = forced.answer.lines().next().unwrap();
        assert!(first.starts_with(mark) && first.is_ascii() && !first.contains('?'), "{control}: {first}");
        assert!(forced.answer.contains("OUTER 7") && forced.answer.contains("THE GROOVE IS NOT CUT"), "{control}");
        let behind = forced.answer.lines().skip_while(|line| !line.starts_with('O')).nth(1);
        assert!(control != "fanuc" || behind.is_some_and(|line| line == first), "{behind:?}");
    }
    // Of a part that is made whole nothing is said.
    let whole = root().join("examples/turned-sleeve.yaml");
    let answer = command(&folder, &["turn", whole.to_str().unwrap(), "--show", "program", "--force"], b"");
    assert!(answer.code == Some(0) && !answer.answer.contains("DO NOT RUN"), "{}", answer.answer);
}

/// A control that is offered only for its setting sheet says so where a program is asked of it, and has the sheet.
#[test]
fn a_control_without_programs_says_what_works() {
    let folder = folder("nc-201");
    let part = root().join("examples/turned-sleeve.yaml");
    let part = part.to_str().unwrap();
    let answer = command(&folder, &["turn", part, "--show", "program", "--control", "nc-201"], b"");
    assert!(
        answer.code == Some(2) && answer.beside.contains("help: the setting sheet is there: --show setting;"),
        "{}",
        answer.beside
    );
    let answer = command(&folder, &["turn", part, "--show", "setting", "--control", "nc-201"], b"");
    assert_eq!(answer.code, Some(0), "{}", answer.beside);
}

/// A finding of the plan has no code of a program to show.
#[test]
fn a_finding_of_the_plan_shows_no_code() {
    let folder = folder("no-code");
    let part = root().join("examples/plate.yaml");
    let answer = command(&folder, &["program", part.to_str().unwrap()], b"");
    assert!(answer.beside.starts_with("note: no height of the fixture is given"), "{}", answer.beside);
    let answer = command(&folder, &["program", part.to_str().unwrap(), "--show", "setting"], b"");
    assert!(
        answer.answer.contains("\n# Clamps [0; -130], [0; 130] (proposed): 1352 N each, screw M10*"),
        "{}",
        answer.answer
    );
    let answer = command(&folder, &["plan", part.to_str().unwrap()], b"");
    assert!(
        answer.answer.contains("Set-up 1: the part on supports of 13 mm, so that tools have room below it"),
        "{}",
        answer.answer
    );
}

/// People type `help` as a word.
#[test]
fn the_word_help_is_the_option() {
    let folder = folder("help");
    for (word, option) in
        [("help", "--help"), ("help turn", "turn --help"), ("--lang en help plan", "--lang en plan --help")]
    {
        let of = |arguments: &str| command(&folder, &arguments.split(' ').collect::<Vec<_>>(), b"");
        let (said, asked) = (of(word), of(option));
        assert_eq!((said.code, &said.answer), (Some(0), &asked.answer), "{word}: {}", said.beside);
        assert!(!said.answer.is_empty(), "{word}");
    }
}
