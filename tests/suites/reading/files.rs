//! Which files are read: no more of them than the bound, and no deeper.

use std::fs::{self, File};
use std::path::Path;
use std::process::Command;

use technolog::knowledge::input::MOST_BYTES;
use technolog_testing::root;

use super::{command, folder};

/// What is nested too deep, by the way in which it is.
const NESTED: [(&str, &str); 4] = [("block", "- "), ("flow", "["), ("mapping", "{a: "), ("key", "? ")];

/// How deep.
const DEPTH: usize = 100_000;

/// A plan that is read, with its part beside it.
fn plan(folder: &Path) {
    // Named so that a folder does not take it for a plan.
    fs::copy(root().join("examples/plate.yaml"), folder.join("plate.part")).unwrap();
    let text = fs::read_to_string(root().join("tests/audit/right.yaml")).unwrap();
    let line =
        |line: &str| if line.starts_with("part: ") { "part: plate.part\n".to_owned() } else { format!("{line}\n") };
    let kept: String = text.lines().take_while(|line| !line.starts_with("program:")).map(line).collect();
    fs::write(folder.join("plan.yaml"), kept).unwrap();
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

/// Larger than the bound, and nothing on the disk.
fn huge(path: &Path) {
    File::create(path).unwrap().set_len(MOST_BYTES as u64 + 1).unwrap();
}

#[test]
fn a_folder_of_plans_gets_its_table_whatever_is_in_it() {
    let folder = folder("audit");
    plan(&folder);
    for (name, open) in NESTED {
        fs::write(folder.join(format!("{name}.yaml")), format!("route:\n  {}", open.repeat(DEPTH))).unwrap();
        fs::write(folder.join(format!("{name}-alone.yaml")), open.repeat(DEPTH)).unwrap();
    }
    fs::write(folder.join("answer.json"), "{\"part\": ".repeat(DEPTH)).unwrap();
    pipe(&folder.join("pipe.yaml"));
    huge(&folder.join("zeros.yaml"));
    let whole = fs::read_to_string(folder.join("plan.yaml")).unwrap();
    let part = whole.lines().find(|line| line.starts_with("part: ")).unwrap();
    for (name, other) in [("of-pipe", "pipe.yaml"), ("of-zeros", "zeros.yaml"), ("of-device", "/dev/zero")] {
        fs::write(folder.join(format!("{name}.yaml")), whole.replace(part, &format!("part: {other}"))).unwrap();
    }
    let answer = command(&folder, &["audit", ".", "--allow-outside", "--format", "json"], b"");
    assert_eq!(answer.code, Some(2), "{}", answer.beside);
    let rows: Vec<serde_json::Value> = serde_json::from_str(&answer.answer).unwrap();
    let of = |file: &str| rows.iter().find(|row| row["file"] == format!("./{file}")).unwrap();
    assert_eq!(rows.len(), 15);
    assert!(of("plan.yaml")["unreadable"].is_null());
    for (name, _) in NESTED {
        for file in [format!("{name}.yaml"), format!("{name}-alone.yaml")] {
            assert_eq!(of(&file)["unreadable"][0]["code"], "too-deep", "{file}");
        }
    }
    assert_eq!(of("answer.json")["unreadable"][0]["code"], "too-deep");
    assert_eq!(of("zeros.yaml")["unreadable"][0]["code"], "too-large");
    for (file, why) in [
        ("pipe.yaml", "a pipe or a device"),
        ("of-pipe.yaml", "a pipe or a device"),
        ("of-device.yaml", "a pipe or a device"),
        ("of-zeros.yaml", "larger than 32 MB"),
    ] {
        let problem = &of(file)["unreadable"][0];
        assert_eq!(problem["code"], "unreadable", "{file}");
        assert!(problem["message"].as_str().unwrap().contains(why), "{file}: {problem}");
    }
    // The table is one with every row, whoever reads it.
    let table = command(&folder, &["audit", "."], b"").answer;
    assert!(rows.iter().all(|row| table.contains(row["file"].as_str().unwrap())), "{table}");
}

#[test]
fn every_command_refuses_what_is_too_deep_or_too_large() {
    let folder = folder("commands");
    fs::write(folder.join("deep.yaml"), "[{a: ".repeat(DEPTH)).unwrap();
    fs::write(folder.join("deep.test.yaml"), "tests:\n  ".to_owned() + &"- ".repeat(DEPTH)).unwrap();
    fs::write(folder.join("plan.yaml"), "part: part.yaml\n").unwrap();
    huge(&folder.join("zeros.yaml"));
    huge(&folder.join("zeros.nc"));
    for (arguments, code) in [
        (vec!["plan", "deep.yaml"], "too-deep"),
        (vec!["turn", "deep.yaml"], "too-deep"),
        (vec!["order", "deep.yaml"], "too-deep"),
        (vec!["program", "deep.yaml"], "too-deep"),
        (vec!["audit", "deep.yaml"], "too-deep"),
        (vec!["audit", "plan.yaml", "--marks", "deep.yaml"], "too-deep"),
        (vec!["test", "deep.test.yaml"], "too-deep"),
        (vec!["plan", "zeros.yaml"], "too-large"),
        (vec!["turn", "zeros.yaml"], "too-large"),
        (vec!["order", "zeros.nc"], "too-large"),
        (vec!["check", "zeros.nc"], "too-large"),
        (vec!["test", "zeros.yaml"], "too-large"),
    ] {
        let answer = command(&folder, &arguments, b"");
        assert_eq!(answer.code, Some(2), "{arguments:?}: {}", answer.beside);
        assert!(answer.beside.contains(&format!("error[{code}]: ")), "{arguments:?}: {}", answer.beside);
        assert!(
            answer.beside.contains(&format!(" --> {}:", arguments.last().unwrap())),
            "{arguments:?}: {}",
            answer.beside
        );
    }
    fs::write(folder.join("end.nc"), "%\nM30\n%\n").unwrap();
    let setting = command(&folder, &["check", "end.nc", "--control", "linuxcnc", "--setting", "deep.yaml"], b"");
    assert!(setting.beside.contains("error[too-deep]: "), "{}", setting.beside);
}

#[test]
fn a_command_reads_a_pipe_as_a_file_up_to_the_bound() {
    let folder = folder("pipes");
    let part = fs::read(root().join("examples/plate.yaml")).unwrap();
    let answer = command(&folder, &["plan", "/dev/stdin"], &part);
    assert_eq!(answer.code, Some(0), "{}", answer.beside);
    assert!(answer.answer.contains("Machining plan"), "{}", answer.answer);
    let answer = command(&folder, &["plan", "/dev/stdin"], &vec![b'#'; MOST_BYTES + 1]);
    assert!(answer.beside.contains("error[too-large]: "), "{}", answer.beside);
    // What the shell's `<(…)` gives is a pipe that it has opened.
    let answer = command(&folder, &["plan", "/dev/fd/0"], &part);
    assert_eq!(answer.code, Some(0), "{}", answer.beside);
}

#[test]
fn a_knowledge_folder_has_files_only_and_is_walked_once() {
    let folder = folder("knowledge");
    for inside in ["catalogs", "rules"] {
        fs::create_dir_all(folder.join("base").join(inside)).unwrap();
    }
    let base = folder.join("base/catalogs");
    fs::write(base.join("deep.yaml"), "[".repeat(DEPTH)).unwrap();
    // Each of two links back doubles what a walk through them finds.
    std::os::unix::fs::symlink(".", base.join("again")).unwrap();
    std::os::unix::fs::symlink(".", base.join("once-more")).unwrap();
    let answer = command(&folder, &["lint", "--knowledge", "base"], b"");
    assert_eq!(answer.answer.matches("error[too-deep]: ").count(), 1, "{}{}", answer.answer, answer.beside);
    pipe(&base.join("pipe.yaml"));
    huge(&base.join("zeros.yaml"));
    let answer = command(&folder, &["lint", "--knowledge", "base"], b"");
    assert_eq!(answer.code, Some(2));
    assert!(answer.beside.contains("pipe.yaml: this is not a file but a pipe or a device"), "{}", answer.beside);
    assert!(answer.beside.contains("error[too-large]: "), "{}", answer.beside);
}

/// A rule of the shop over the shipped one: a step of the spindle below the computed speed always. The other tables stay, the last layer
/// is on top, and a mistake in a layer is shown with its own file.
#[test]
fn tables_of_a_shop_lie_over_those_that_are_shipped() {
    let folder = folder("layers");
    let shipped = fs::read_to_string(root().join("rules/spindle-step.yaml")).unwrap();
    let below = shipped.replace("take: above,", "take: below,");
    for (layer, text) in
        [("shop", &below), ("again", &shipped), ("broken", &below.replace("take: below", "take: beside"))]
    {
        for inside in ["catalogs", "rules"] {
            fs::create_dir_all(folder.join(layer).join(inside)).unwrap();
        }
        fs::write(folder.join(layer).join("rules/spindle-step.yaml"), text).unwrap();
    }
    let ask = ["lookup", "spindle-step", "excess=5", "beyond_practice=false", "--format", "json"];
    for (layers, taken) in
        [(&[][..], "above"), (&["--with", "shop"], "below"), (&["--with", "shop", "--with", "again"], "above")]
    {
        let answer = command(&folder, &[&ask[..], layers].concat(), b"");
        let shown = answer.answer.contains(&format!("\"{taken}\""));
        assert!(answer.code == Some(0) && shown, "{layers:?}: {}{}", answer.answer, answer.beside);
    }
    let other = command(&folder, &["lookup", "A.11", "diameter=8", "--with", "shop"], b"");
    assert_eq!(other.code, Some(0), "{}", other.beside);
    for (layer, named) in [("broken", "broken/rules/spindle-step.yaml:"), ("nowhere", "nowhere")] {
        let answer = command(&folder, &[&ask[..], &["--with", layer]].concat(), b"");
        assert!(answer.code == Some(2) && answer.beside.contains(named), "{layer}: {}", answer.beside);
    }
}
