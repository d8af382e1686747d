//! The time of a plan against the clock of the program that is written from it.

use technolog::motion::time::Clock;
use technolog::motion::{MotionStep, Position};
use technolog::program::Language;
use technolog_testing::proof_bench::ProofBench;
use technolog_testing::{KNOWLEDGE, read};

/// A part of one to three groups, the same on every run for a number.
fn part(number: usize) -> String {
    let sizes = [5, 6, 8, 10, 12, 16, 20, 25, 30];
    let fits = [("H7", "Ra 1.25"), ("H9", "Ra 3.2"), ("H11", "Ra 6.3"), ("H12", "Ra 12.5"), ("H14", "Ra 12.5")];
    let mut text = format!(
        "part: P\nmaterial: {}\nmachine: {}\nblank: {{kind: plate, length: 400, width: 300, thickness: 40}}\nholes:\n",
        ["steel-45", "cast-iron-sch20", "steel-20"][number % 3],
        ["gf2171", "ir500pmf4"][number / 3 % 2],
    );
    for group in 0..=number % 3 {
        let pick = number * 7 + group * 5;
        let (size, (fit, ra)) = (sizes[pick % sizes.len()], fits[pick / 2 % fits.len()]);
        let depth = if pick.is_multiple_of(4) { "depth: 24" } else { "through: true" };
        let points: Vec<String> =
            (0..=pick % 4).map(|at| format!("[{}, {}]", 60 * at as i64 - 150, 80 * group as i64 - 90)).collect();
        let hole = if pick.is_multiple_of(7) {
            format!("thread: M{}", [6, 8, 10][pick % 3])
        } else {
            format!("diameter: {size}{fit}, roughness: {ra}")
        };
        let at = points.join(", ");
        text += &format!("  - {{name: H{group}, {hole}, {depth}, centre_tolerance: 0.3, at: [{at}]}}\n");
    }
    text
}

/// On the machine's own control, within 2 % each: programs round feeds down to whole millimetres a minute. A control that comes
/// back nearer to the metal between pecks, as LinuxCNC does, is quicker than that.
#[test]
fn a_plan_takes_as_long_as_its_program() {
    let control = Language::read("2c42-65", &KNOWLEDGE).unwrap();
    let mut ratios = Vec::new();
    for number in 0..400 {
        // As many as the assertion asks for, and some more.
        if ratios.len() > 200 {
            break;
        }
        let bench = ProofBench::of(&read(&part(number)));
        if bench.job.setups.is_empty() {
            continue;
        }
        let text = bench.written(&control);
        let mut sink = (Vec::<MotionStep>::new(), Clock::new(&bench.machine, Position::default()));
        control.check(&text, &bench.machine, &bench.setting, &mut sink);
        let time = bench.plan.time;
        let ratio = (time.total_min.0 - time.hand_min.0) / sink.1.times().total_min.0;
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}: {time:?}, {:?}\n{}", sink.1.times(), part(number));
        ratios.push(ratio);
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    println!("{} to {}, {median} in the middle", ratios[0], ratios[ratios.len() - 1]);
    assert!(ratios.len() > 200 && (median - 1.0).abs() < 0.005, "{median} of {}", ratios.len());
}
