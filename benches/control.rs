//! The time of a program check. Target, on one core: a program that fills the control's 32 KB in under 5 ms, with its
//! trace as text.
//!
//! Three ways to fill the memory: typical programs; the shortest blocks, each of which runs a cycle, which makes the
//! most steps that 32 KB can make without repeats; and the longest blocks.

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]

use std::fmt::Write;
use std::hint::black_box;

use criterion::{Criterion, Throughput};
use technolog::machine::Machine;
use technolog::motion::time::Clock;
use technolog::motion::trace::Trace;
use technolog::program::Language;
use technolog::program::Setting;
use technolog::shipped;

const MEMORY: usize = 32 * 1024;

/// Blocks until the memory is full: holes, a contour, calls.
fn mixed() -> String {
    let mut text = String::from(":01\nN1 G90 G54 G0 X0 Y0 S500 M3 F250\n");
    let mut number: usize = 2;
    while text.len() < MEMORY - 120 {
        let (x, y) = (number % 400, number % 150);
        let _ = match number % 4 {
            0 => writeln!(text, "N{number} G0 X{x}.5 Y{y} G81 U2 Z-15 I5 F100"),
            1 => writeln!(text, "N{number} G80 G1 X{x} Y-{y}.25 F250"),
            2 => writeln!(text, "N{number} G2 G91 X10 Y10 J10"),
            _ => writeln!(text, "N{number} G90 G0 X-{x} P02"),
        };
        number += 1;
    }
    text.push_str("N9999 G80 M02\n:02\nN1 G91 Y1 G90 M99\n");
    text
}

/// Blocks of three characters and no number: a motion and a hole each, every one elsewhere.
fn shortest() -> String {
    let mut text = String::from(":01\nN1 G90 G54 G0 X-450 Y0 Z20 S500 M3\nN2 G91 G81 U-18 Z-15 I33 F100\n");
    while text.len() < MEMORY - 20 {
        text.push_str("X.1\n");
    }
    text.push_str("G80 M02\n");
    text
}

/// Blocks of nearly 128 characters, full of words.
fn longest() -> String {
    let mut text = String::from(":01\nN1 G90 G54 G0 X0 Y0 Z20 S500 M3\n");
    let mut number: usize = 2;
    while text.len() < MEMORY - 160 {
        let _ = writeln!(
            text,
            "N{number:04} G01 G17 G90 G40 X+0{:03}.120 Y-0{:03}.250 Z+20.000 F250 S500 T01 D01 H00 R01 Q02 M03 M08 \
             G81 U+2.0 Z-15.0 I+5.0 E10 F100",
            number % 400,
            number % 150
        );
        number += 1;
    }
    text.push_str("N9999 G80 M02\n");
    text
}

/// Two holes in one short block, as often as the budget of a run allows with room to spare: 20,000 motions.
fn repeated() -> String {
    String::from(
        ":01\nN1 G90 G54 G0 X0 Y0 Z20 S500 M3 F100\nN2 L100 P02\nN3 G80 M02\n:02\nN1 G90 X0\nN2 G91 L39 X1 G81 U-18 Z-15 I33\n\
         N3 G80 M99\n",
    )
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let knowledge = shipped::knowledge().unwrap();
    let machine = Machine::find(&knowledge, "gf2171").unwrap();
    let setting = Setting::default();
    let mut group = criterion.benchmark_group("check");
    for (name, text) in [
        ("a program of 32 KB", mixed()),
        ("32 KB of the shortest blocks", shortest()),
        ("32 KB of long blocks", longest()),
        ("20,000 motions by repeats", repeated()),
    ] {
        group.throughput(Throughput::Bytes(text.len() as u64));
        group.bench_function(name, |bench| {
            bench.iter(|| {
                let control = Language::read("2c42-65", &knowledge).unwrap();
                let mut sink = (Trace::default(), Clock::new(&machine, setting.start));
                let faults = control.check(black_box(&text), &machine, &setting, &mut sink);
                assert!(faults.iter().all(|fault| !fault.is_error()), "{:?}", faults.first());
                sink
            });
        });
    }
    group.finish();
    criterion.final_summary();
}
