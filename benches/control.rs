//! How long the check of a program takes. The target, for one core: a program that fills the control's 32 KB in under
//! 5 ms, its trace written as text.

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]

use std::fmt::Write;
use std::hint::black_box;

use criterion::{Criterion, Throughput};
use technolog::machine::Machine;
use technolog::motion::time::Clock;
use technolog::motion::trace::Trace;
use technolog::program::Setting;
use technolog::program::control_2c42_65::{Control, check};
use technolog::shipped;

const MEMORY: usize = 32 * 1024;

/// Blocks until the memory is full: holes, a contour, calls.
fn program() -> String {
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

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let knowledge = shipped::knowledge().unwrap();
    let machine = Machine::find(&knowledge, "gf2171").unwrap();
    let text = program();
    let setting = Setting::default();
    let mut group = criterion.benchmark_group("check");
    group.throughput(Throughput::Bytes(text.len() as u64));
    group.bench_function("a program of 32 KB", |bench| {
        bench.iter(|| {
            let control = Control::read(&knowledge).unwrap();
            let mut sink = (Trace::default(), Clock::new(&machine, setting.start));
            let faults = check(black_box(&text), &control, &machine, &setting, &mut sink);
            assert!(faults.iter().all(|fault| !fault.is_error()), "{:?}", faults.first());
            sink
        });
    });
    group.finish();
    criterion.final_summary();
}
