//! How the time of whole commands grows with their input: four sizes each, and the exponent between the smallest and
//! the largest.
//!
//! `cargo bench --bench growth` prints a line for each kind of input; `-- contour` measures those of that name alone. A command
//! that reads a large file is timed with its start, so small times are those of any command.

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]
#![allow(clippy::disallowed_methods, reason = "an exponent that is printed need not be the same everywhere")]

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

/// A kind of input: its name, the command, the sizes, and how a file of that size is made.
struct Growth {
    name: &'static str,
    /// `FILE` stands for the file.
    command: &'static [&'static str],
    ending: &'static str,
    sizes: [usize; 4],
    text: fn(usize) -> String,
}

const ALL: &[Growth] = &[
    Growth {
        name: "plan-holes",
        command: &["plan", "FILE"],
        ending: "yaml",
        sizes: [2_500, 5_000, 10_000, 20_000],
        text: holes,
    },
    Growth {
        name: "program-holes",
        command: &["program", "FILE"],
        ending: "yaml",
        sizes: [2_500, 5_000, 10_000, 20_000],
        text: holes,
    },
    Growth { name: "plan-kinds", command: &["plan", "FILE"], ending: "yaml", sizes: [10, 20, 40, 80], text: kinds },
    Growth {
        name: "part-faults",
        command: &["plan", "FILE"],
        ending: "yaml",
        sizes: [250, 500, 1_000, 2_000],
        text: faults,
    },
    Growth {
        name: "part-keys",
        command: &["plan", "FILE"],
        ending: "yaml",
        sizes: [2_500, 5_000, 10_000, 20_000],
        text: keys,
    },
    Growth {
        name: "program-faults",
        command: &["check", "FILE", "--control", "linuxcnc"],
        ending: "nc",
        sizes: [12_500, 25_000, 50_000, 100_000],
        text: program,
    },
    Growth {
        name: "order-closed",
        command: &["order", "FILE", "--closed"],
        ending: "csv",
        sizes: [2_500, 5_000, 10_000, 20_000],
        text: points,
    },
    Growth {
        name: "order-open",
        command: &["order", "FILE"],
        ending: "csv",
        sizes: [2_500, 5_000, 10_000, 20_000],
        text: points,
    },
    Growth {
        name: "turn-contour",
        command: &["turn", "FILE"],
        ending: "yaml",
        sizes: [125, 250, 500, 1_000],
        text: contour,
    },
];

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("growth");
    fs::create_dir_all(&folder).unwrap();
    println!("{:<16} {:>44} {:>36} {:>9}", "input", "sizes", "seconds", "exponent");
    for growth in
        ALL.iter().filter(|one| chosen.is_empty() || chosen.iter().any(|name| one.name.contains(name.as_str())))
    {
        let seconds = growth.sizes.map(|size| {
            let file = folder.join(format!("{}-{size}.{}", growth.name, growth.ending));
            fs::write(&file, (growth.text)(size)).unwrap();
            (0..3).map(|_| run(growth.command, &file)).fold(f64::INFINITY, f64::min)
        });
        let exponent = (seconds[3] / seconds[0]).ln() / (growth.sizes[3] as f64 / growth.sizes[0] as f64).ln();
        let shown = |all: &[String]| all.join(" / ");
        let sizes = shown(&growth.sizes.map(|size| size.to_string()));
        let times = shown(&seconds.map(|time| format!("{time:.3}")));
        println!("{:<16} {sizes:>44} {times:>36} {exponent:>9.2}", growth.name);
    }
}

fn run(command: &[&str], file: &Path) -> f64 {
    let start = Instant::now();
    let status = Command::new(env!("CARGO_BIN_EXE_technolog"))
        .args(["--lang", "en"])
        .args(command.iter().map(|word| if *word == "FILE" { file.as_os_str() } else { word.as_ref() }))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .unwrap();
    assert!(status.code().is_some(), "{command:?} was killed");
    start.elapsed().as_secs_f64()
}

const HEAD: &str = "part: P\nmaterial: steel-45\nmachine: gf2171\n";

/// Equal holes in rows of 160.
fn holes(count: usize) -> String {
    let mut text = format!("{HEAD}blank: {{kind: plate, length: 520, width: 400, thickness: 10}}\nholes:\n");
    text += "  - name: A\n    diameter: 3H12\n    depth: 10\n    through: true\n    roughness: Ra 12.5\n";
    text += "    centre_tolerance: 0.46\n    at:\n";
    for at in 0..count {
        let (x, y) = (-250_000 + (at % 160) as i64 * 3_150, -195_000 + (at / 160) as i64 * 3_100);
        writeln!(text, "      - [{}, {}]", millimetres(x), millimetres(y)).unwrap();
    }
    text
}

/// Kinds of holes that differ in diameter, grade and depth.
fn kinds(count: usize) -> String {
    let mut text = format!("{HEAD}blank: {{kind: plate, length: 500, width: 300, thickness: 40}}\nholes:\n");
    for at in 0..count {
        let diameter = [6, 8, 10, 12, 14, 16, 18, 20, 5, 7][at % 10];
        let (grade, roughness) = [("H12", "12.5"), ("H9", "2.5"), ("H8", "2.5"), ("H11", "6.3")][at / 10 % 4];
        let (depth, x, y) = (20 + at % 7, -230 + (at % 20) as i64 * 24, -120 + (at / 20) as i64 * 30);
        writeln!(
            text,
            "  - {{name: K{at}, diameter: {diameter}{grade}, depth: {depth}, roughness: Ra {roughness}, \
             centre_tolerance: 0.4, at: [[{x}, {y}]]}}"
        )
        .unwrap();
    }
    text
}

/// Points with decimal commas, all in one line.
fn faults(count: usize) -> String {
    let points = vec!["[1,5, 2]"; count].join(", ");
    format!(
        "{HEAD}blank: {{kind: plate, length: 500, width: 300, thickness: 40}}\nholes:\n  - {{name: A, at: [{points}]}}\n"
    )
}

/// The same key again and again.
fn keys(count: usize) -> String {
    format!("{HEAD}{}", "blank: 1\n".repeat(count))
}

/// A program with three faults in every block, for a control whose memory holds them all.
fn program(count: usize) -> String {
    let mut text = "%\nO1\n".to_owned();
    (1..=count).for_each(|block| writeln!(text, "N{} X1 Q9 Ж3", block % 9_999).unwrap());
    text + "M30\n%\n"
}

/// Points without an order: a multiplier walks over a square.
fn points(count: usize) -> String {
    let mut text = "x,y\n".to_owned();
    for at in 0..count as i64 {
        writeln!(text, "{},{}", millimetres(at * 7_919_113 % 400_003), millimetres(at * 104_729_021 % 300_007))
            .unwrap();
    }
    text
}

/// A shaft of many low steps.
fn contour(count: usize) -> String {
    let steps = count as i64 / 2;
    let length = millimetres(600 * steps + 5_000);
    let mut text =
        format!("shaft: S\nmaterial: steel-45\nblank: {{kind: bar, diameter: 130, length: {length}, face: 1.5}}\n");
    text += "machine: 16k20f3\nouter:\n  - {from: {d: 0, z: 0}}\n";
    for step in 1..=steps {
        let (d, z) = (millimetres(20_000 + 200 * step), millimetres(-600 * step));
        writeln!(text, "  - {{face: {d}}}\n  - {{cylinder: {z}}}").unwrap();
    }
    text + "roughing: {limiting_depth: 4}\nallowances: {method: stated, on_diameter: 0.8, on_face: 0.4}\n"
}

/// Thousandths as millimetres.
fn millimetres(thousandths: i64) -> String {
    format!("{}{}.{:03}", if thousandths < 0 { "-" } else { "" }, thousandths.abs() / 1000, thousandths.abs() % 1000)
}
