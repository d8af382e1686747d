//! What commands read and write: no input is ever replaced, nothing is left beside an answer, nothing is waited for.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn example(name: &str) -> String {
    fs::read_to_string(root().join("examples").join(name)).unwrap()
}

fn run(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    command.current_dir(folder).env_remove("COLUMNS").args(["--lang", "en"]).args(args).output().unwrap()
}

fn complaint(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A folder with a part, its program, a plan that names them, a setting, marks, a list of points, cases and knowledge.
fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("files").join(name);
    // There is none at the first run.
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join("know")).unwrap();
    for (file, text) in [
        ("part.yaml", example("plate.yaml")),
        ("shaft.yaml", example("shaft.yaml")),
        ("program.nc", example("appendix-g/program.nc")),
        ("setting.yaml", example("appendix-g/setting.yaml")),
        ("plan.yaml", example("appendix-g/plan.yaml").replace("../plate.yaml", "part.yaml")),
        ("marks.yaml", example("marks.yaml")),
        ("points.csv", "x,y\n0,0\n10,0\n10,10\n".to_owned()),
        ("one.test.yaml", "part: part.yaml\ncases:\n  - expect: {holes: {A: {scheme: \"1\"}}}\n".to_owned()),
    ] {
        fs::write(folder.join(file), text).unwrap();
    }
    let tables = root().join("tests/small-knowledge");
    for file in ["catalogs/drills.yaml", "catalogs/schemes.yaml", "catalogs/scheme-for-hole.yaml", "rules/coolant.yaml"]
    {
        fs::create_dir_all(folder.join("know").join(file).parent().unwrap()).unwrap();
        fs::copy(tables.join(file), folder.join("know").join(file)).unwrap();
    }
    folder
}

fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file())
        .map(|path| (path.clone(), fs::read(&path).unwrap()))
        .collect();
    files.sort();
    files
}

/// Every command that reads files, with each file that it reads named as the place of the answer.
const READING: &[(&str, &str)] = &[
    ("plan part.yaml", "part.yaml"),
    ("plan part.yaml --format html", "part.yaml"),
    ("explain part.yaml --hole A1 --format text", "part.yaml"),
    ("order part.yaml --format json", "part.yaml"),
    ("order points.csv --format json", "points.csv"),
    ("turn shaft.yaml --format json", "shaft.yaml"),
    ("program part.yaml", "part.yaml"),
    ("check program.nc --setting setting.yaml", "program.nc"),
    ("check program.nc --setting setting.yaml", "setting.yaml"),
    ("check program.nc --part part.yaml", "part.yaml"),
    ("audit plan.yaml", "plan.yaml"),
    ("audit plan.yaml", "part.yaml"),
    ("audit plan.yaml", "program.nc"),
    ("audit plan.yaml", "setting.yaml"),
    ("audit plan.yaml --marks marks.yaml", "marks.yaml"),
    ("audit plan.yaml --against plan.yaml", "plan.yaml"),
    ("audit .", "plan.yaml"),
    ("test one.test.yaml", "one.test.yaml"),
    ("test one.test.yaml", "part.yaml"),
    ("table --knowledge know", "know/catalogs/drills.yaml"),
    ("lint --knowledge know", "know/rules/coolant.yaml"),
];

#[test]
fn no_input_is_replaced_by_the_answer() {
    let folder = scratch("inputs");
    let before = [contents(&folder), contents(&folder.join("know/catalogs"))];
    for (command, input) in READING {
        let absolute = folder.join(input).display().to_string();
        for output in [(*input).to_owned(), format!("know/../{input}"), absolute] {
            // The ending of the file requires a form that not every command has: that is another refusal.
            let mut args: Vec<&str> = command.split(' ').collect();
            args.extend(["-o", &output]);
            let answer = run(&folder, &args);
            assert_eq!(answer.status.code(), Some(2), "{args:?}: {}", complaint(&answer));
            assert_eq!([contents(&folder), contents(&folder.join("know/catalogs"))], before, "{args:?}");
        }
    }
}

#[cfg(unix)]
#[test]
fn no_input_is_replaced_through_a_link() {
    let folder = scratch("links");
    std::os::unix::fs::symlink("part.yaml", folder.join("soft.yaml")).unwrap();
    fs::hard_link(folder.join("part.yaml"), folder.join("hard.yaml")).unwrap();
    let before = contents(&folder);
    for (input, output) in
        [("part.yaml", "soft.yaml"), ("part.yaml", "hard.yaml"), ("soft.yaml", "part.yaml"), ("hard.yaml", "soft.yaml")]
    {
        let answer = run(&folder, &["plan", input, "-o", output]);
        assert_eq!(answer.status.code(), Some(2), "{input} {output}");
        assert!(complaint(&answer).contains("replaces-input"), "{}", complaint(&answer));
        assert_eq!(contents(&folder), before);
    }
    // What is no input is replaced through its link.
    std::os::unix::fs::symlink("old.yaml", folder.join("answer.yaml")).unwrap();
    fs::write(folder.join("old.yaml"), "old").unwrap();
    assert_eq!(run(&folder, &["plan", "part.yaml", "-o", "answer.yaml"]).status.code(), Some(0));
    assert!(fs::symlink_metadata(folder.join("answer.yaml")).unwrap().is_symlink());
    assert_ne!(fs::read_to_string(folder.join("old.yaml")).unwrap(), "old");
}

#[test]
fn a_file_that_may_not_be_written_stays() {
    let folder = scratch("read-only");
    let file = folder.join("answer.json");
    fs::write(&file, "mine").unwrap();
    let mut permissions = fs::metadata(&file).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&file, permissions).unwrap();
    let answer = run(&folder, &["plan", "part.yaml", "-o", "answer.json"]);
    assert_eq!(answer.status.code(), Some(2));
    assert!(complaint(&answer).contains("not permitted"), "{}", complaint(&answer));
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_to_no_file_stays() {
    let folder = scratch("dangling");
    std::os::unix::fs::symlink("nothing/answer.json", folder.join("answer.json")).unwrap();
    std::os::unix::fs::symlink("round.json", folder.join("round.json")).unwrap();
    for file in ["answer.json", "round.json"] {
        let answer = run(&folder, &["plan", "part.yaml", "-o", file]);
        assert_eq!(answer.status.code(), Some(2), "{file}");
        assert!(complaint(&answer).contains("a link that leads to no file"), "{}", complaint(&answer));
        assert!(fs::symlink_metadata(folder.join(file)).unwrap().is_symlink(), "{file}");
    }
}

#[cfg(unix)]
#[test]
fn an_answer_keeps_who_may_read_it_and_no_more() {
    use std::os::unix::fs::PermissionsExt;
    let folder = scratch("modes");
    let file = folder.join("answer.json");
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o6750)).unwrap();
    fs::hard_link(&file, folder.join("other.json")).unwrap();
    assert_eq!(run(&folder, &["plan", "part.yaml", "-o", "answer.json"]).status.code(), Some(0));
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o7777, 0o750);
    // The other name of the old file keeps what it had.
    assert_eq!(fs::read_to_string(folder.join("other.json")).unwrap(), "old");
}

#[test]
fn what_a_killed_run_left_goes_with_the_next() {
    let folder = scratch("stale");
    let stale = folder.join(".answer.json.4711-0.technolog-tmp");
    let busy = folder.join(".answer.json.4712-0.technolog-tmp");
    let other = folder.join(".answer.json.mine.technolog-tmp");
    for file in [&stale, &busy, &other] {
        fs::write(file, "half").unwrap();
    }
    // Somebody writes the same file at this moment.
    let open = fs::File::open(&busy).unwrap();
    open.lock().unwrap();
    assert_eq!(run(&folder, &["plan", "part.yaml", "-o", "answer.json"]).status.code(), Some(0));
    assert_eq!([stale, busy, other].map(|file| file.exists()), [false, true, true]);
}

#[test]
fn an_audit_of_a_folder_may_be_written_into_it_twice() {
    let folder = scratch("twice");
    for _ in 0..2 {
        let answer = run(&folder, &["audit", ".", "-o", "results.json"]);
        assert_eq!(answer.status.code(), Some(1), "{}", complaint(&answer));
    }
}

#[test]
fn a_plan_names_files_of_its_folder_only() {
    let folder = scratch("outside");
    let plans = folder.join("plans");
    fs::create_dir_all(&plans).unwrap();
    let plan = |part: &str| format!("part: {part}\nroute:\n  - {{row: 2, operation: drill, hole: A, count: 6}}\n");
    let secret = Path::new(env!("CARGO_TARGET_TMPDIR")).join("files").join("secret.txt");
    fs::write(&secret, "root:secret\n").unwrap();
    let outside = ["../../secret.txt".to_owned(), secret.display().to_string()];
    for part in &outside {
        fs::write(plans.join("plan.yaml"), plan(part)).unwrap();
        let answer = run(&plans, &["audit", "plan.yaml"]);
        assert_eq!(answer.status.code(), Some(2), "{part}");
        assert!(complaint(&answer).contains("--allow-outside"), "{}", complaint(&answer));
        assert!(!complaint(&answer).contains("root:secret"), "{}", complaint(&answer));
        // Through a folder the row of the plan says it.
        let table = run(&folder, &["audit", "plans"]);
        assert_eq!(table.status.code(), Some(2));
        let output = [table.stdout, table.stderr].concat();
        assert!(!String::from_utf8(output).unwrap().contains("root:secret"));
        let allowed = run(&plans, &["audit", "plan.yaml", "--allow-outside"]);
        assert!(complaint(&allowed).contains("secret.txt"), "{}", complaint(&allowed));
        assert!(!complaint(&allowed).contains("--allow-outside"), "{}", complaint(&allowed));
    }
    // Of the folder that is audited, or that the program is run in, plans may share files.
    fs::write(plans.join("plan.yaml"), plan("../part.yaml")).unwrap();
    assert_ne!(run(&folder, &["audit", "plans/plan.yaml"]).status.code(), Some(2));
    assert_ne!(run(&root(), &["audit", folder.to_str().unwrap()]).status.code(), Some(2));
    assert_eq!(run(&plans, &["audit", "plan.yaml"]).status.code(), Some(2));
    for (part, why) in [("../plans", "a folder"), ("nothing.yaml", "no such file")] {
        fs::write(plans.join("plan.yaml"), plan(part)).unwrap();
        let answer = run(&plans, &["audit", "plan.yaml"]);
        assert_eq!(answer.status.code(), Some(2));
        assert!(complaint(&answer).contains(why), "{}", complaint(&answer));
    }
}

/// Whether there is a file elsewhere is no business of whoever sent the plan.
#[cfg(unix)]
#[test]
fn what_is_outside_is_not_told_to_exist() {
    let folder = scratch("existence");
    let plans = folder.join("plans");
    fs::create_dir_all(&plans).unwrap();
    for (link, to) in [("there.yaml", "../part.yaml"), ("nowhere.yaml", "../nothing.yaml"), ("up", "..")] {
        std::os::unix::fs::symlink(to, plans.join(link)).unwrap();
    }
    fs::copy(folder.join("part.yaml"), plans.join("own.yaml")).unwrap();
    let absolute = |name: &str| folder.join(name).display().to_string();
    for (there, nowhere) in [
        ("../part.yaml", "../nothing.yaml"),
        ("there.yaml", "nowhere.yaml"),
        ("up/part.yaml", "up/nothing.yaml"),
        ("../part.yaml", "../nothing/part.yaml"),
        ("../plans/../part.yaml", "nothing/../../part.yaml"),
        (&absolute("part.yaml"), &absolute("nothing.yaml")),
    ] {
        for key in ["part", "program"] {
            let messages = [there, nowhere].map(|name| {
                let text = match key {
                    "part" => format!("part: {name}\n"),
                    _ => format!("part: own.yaml\nprogram: {{file: {name}, control: 2c42-65}}\n"),
                };
                fs::write(plans.join("plan.yaml"), text).unwrap();
                let answer = run(&plans, &["audit", "plan.yaml"]);
                assert_eq!(answer.status.code(), Some(2), "{key} {name}");
                let message = complaint(&answer).replace(name, "NAME");
                assert!(message.contains("outside the folder"), "{key} {name}: {message}");
                // What is marked is as long as the name.
                message.replace('^', "")
            });
            assert_eq!(messages[0], messages[1], "{key} {there} {nowhere}");
        }
    }
}

#[test]
fn cases_name_files_of_their_folder_only() {
    let folder = scratch("outside-cases");
    let cases = folder.join("cases");
    fs::create_dir_all(cases.join("inner")).unwrap();
    let secret = Path::new(env!("CARGO_TARGET_TMPDIR")).join("files").join("secret-of-cases.txt");
    fs::write(&secret, "root:secret\n").unwrap();
    fs::write(cases.join("plan.yaml"), format!("part: {}\nroute: []\n", secret.display())).unwrap();
    for arguments in [
        format!("part: {}", secret.display()),
        "turn: ../../secret-of-cases.txt".to_owned(),
        format!("audit: {}", secret.display()),
        // A plan that a case names names a file itself.
        "audit: plan.yaml".to_owned(),
        format!("program: {}, control: linuxcnc", secret.display()),
        format!("program: ../program.nc, control: 2c42-65, setting: {}", secret.display()),
    ] {
        fs::write(cases.join("one.test.yaml"), format!("tests:\n  - {{{arguments}, expect: {{}}}}\n")).unwrap();
        let answer = run(&cases, &["test", "one.test.yaml"]);
        assert_eq!(answer.status.code(), Some(2), "{arguments}");
        let message = complaint(&answer);
        assert!(message.contains("--allow-outside") && !message.contains("root:secret"), "{message}");
        let allowed = run(&cases, &["test", "one.test.yaml", "--allow-outside"]);
        let message = complaint(&allowed);
        assert!(!message.contains("--allow-outside"), "{arguments}: {message}");
    }
    // Of the folder that is named, or that the program is run in, cases may share files.
    let shared = "tests:\n  - {part: ../../part.yaml, expect: {holes.A.scheme: \"1\"}}\n";
    fs::write(cases.join("inner/one.test.yaml"), shared).unwrap();
    fs::remove_file(cases.join("one.test.yaml")).unwrap();
    // It is wrong by itself.
    fs::remove_file(folder.join("one.test.yaml")).unwrap();
    assert_ne!(run(&folder, &["test", "cases/inner/one.test.yaml"]).status.code(), Some(2));
    assert_ne!(run(&root(), &["test", folder.to_str().unwrap()]).status.code(), Some(2));
    assert_eq!(run(&cases, &["test", "inner"]).status.code(), Some(2));
}

#[cfg(unix)]
#[test]
fn nothing_is_waited_for() {
    let folder = scratch("waiting");
    let plans = folder.join("plans");
    fs::create_dir_all(&plans).unwrap();
    // A device with no end, named by a plan and standing in a folder; a link that goes round.
    fs::write(plans.join("plan.yaml"), "part: zero.yaml\nroute: []\n").unwrap();
    std::os::unix::fs::symlink("/dev/zero", plans.join("zero.yaml")).unwrap();
    std::os::unix::fs::symlink(".", plans.join("round")).unwrap();
    for (args, why) in [
        (&["audit", "plans/plan.yaml", "--allow-outside"][..], "not a file but a pipe or a device"),
        (&["audit", "plans/plan.yaml"], "outside the folder"),
        (&["audit", "plans"], "pipe or a device"),
    ] {
        let answer = run(&folder, args);
        assert_eq!(answer.status.code(), Some(2));
        let output = String::from_utf8([answer.stdout, answer.stderr].concat()).unwrap();
        let output = output.split(['|', ' ', '\n']).filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
        assert!(output.contains(why), "{output}");
    }
    // Nor is it on the command line; what a shell has opened for the program is no name of a pipe.
    assert!(Command::new("mkfifo").arg(folder.join("pipe")).status().unwrap().success());
    for file in ["/dev/zero", "pipe", "/proc/kmsg", "/proc/self/status"] {
        for command in ["plan", "turn", "check", "order", "audit", "test"] {
            let answer = run(&folder, &[command, file]);
            assert_eq!(answer.status.code(), Some(2), "{command} {file}");
            assert!(complaint(&answer).contains("pipe or a device"), "{command}: {}", complaint(&answer));
        }
    }
    std::os::unix::fs::symlink(".", folder.join("know/catalogs/round")).unwrap();
    assert_eq!(run(&folder, &["table", "--knowledge", "know"]).status.code(), Some(0));
}

#[test]
fn a_form_that_a_command_does_not_have_is_refused() {
    for (command, format) in [
        ("turn examples/turned-pin.yaml --show program", "json"),
        ("turn examples/turned-pin.yaml --show cycle", "svg"),
        ("program examples/plate.yaml --show backplot", "json"),
        ("program examples/plate.yaml", "yaml"),
        ("test --write examples/cases/plate.test.yaml", "csv"),
    ] {
        let args: Vec<&str> = command.split(' ').chain(["--format", format]).collect();
        let answer = run(&root(), &args);
        assert_eq!((answer.status.code(), answer.stdout.len()), (Some(2), 0), "{args:?}");
        assert!(complaint(&answer).contains("no-format"), "{}", complaint(&answer));
    }
}

/// Whoever opens a picture or a document would find plain text in it.
#[test]
fn an_ending_that_promises_another_form_is_refused() {
    let folder = scratch("endings");
    fs::copy(root().join("examples/plate.yaml"), folder.join("part.yaml")).unwrap();
    for (command, file, known) in [
        ("plan part.yaml", "p.pdf", "writes .txt"),
        ("plan part.yaml", "p.DOCX", ".html"),
        ("plan part.yaml", "p.nc", ".html"),
        ("plan part.yaml --format text", "p.png", ".yaml, .yml"),
        ("program part.yaml", "p.dxf", ".txt, .json"),
        ("table A.8", "t.xlsx", ".csv"),
    ] {
        let args: Vec<&str> = command.split(' ').chain(["-o", file, "--lang", "en"]).collect();
        let answer = run(&folder, &args);
        let message = complaint(&answer);
        assert_eq!(answer.status.code(), Some(2), "{args:?}");
        assert!(message.contains("alien-ending") && message.contains(known), "{message}");
        assert!(!folder.join(file).exists());
    }
    for file in ["p.nc", "p.tap", "p.ngc", "p", "p.txt", "p.2"] {
        let answer = run(&folder, &["program", "part.yaml", "-o", file]);
        assert!(answer.status.code() == Some(0) && folder.join(file).exists(), "{file}: {}", complaint(&answer));
    }
}

#[test]
fn names_and_arguments_do_not_steer_the_terminal() {
    let folder = scratch("signs");
    fs::write(folder.join("n\u{1b}[31m\u{202e}.yaml"), "x: 1\n").unwrap();
    for args in [&["audit", "."][..], &["plan", "\u{1b}[31m"], &["plan", "part.yaml", "--format", "\u{1b}[31m"]] {
        let message = complaint(&run(&folder, args));
        assert!(!message.is_empty() && !message.contains(['\u{1b}', '\u{202e}']), "{message:?}");
    }
}
