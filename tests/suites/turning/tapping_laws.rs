//! Random bushings, studs and sleeves with a thread on the axis: each is tapped and proven, or it is told why not.

use std::collections::BTreeMap;

use proptest::prelude::*;
use technolog::audit::turned::read_back;
use technolog::note::Severity;
use technolog::turning::jobs::Work;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::{Operation, plan};
use technolog::turning::workpiece::read_turned;
use technolog_testing::KNOWLEDGE;

/// Threads: as drawings write them, size, pitch and drill, µm (ISO 724, ГОСТ 19257).
const THREADS: [(&str, i64, i64, i64); 14] = [
    ("M4", 4_000, 700, 3_300),
    ("M5", 5_000, 800, 4_200),
    ("M6", 6_000, 1_000, 5_000),
    ("M8", 8_000, 1_250, 6_800),
    ("M10", 10_000, 1_500, 8_500),
    ("M10x1", 10_000, 1_000, 9_000),
    ("M12-6H", 12_000, 1_750, 10_200),
    ("M12x1.25", 12_000, 1_250, 10_800),
    ("M14", 14_000, 2_000, 12_000),
    ("M16x1.5", 16_000, 1_500, 14_500),
    ("M20", 20_000, 2_500, 17_500),
    ("M24", 24_000, 3_000, 21_000),
    ("M27", 27_000, 3_000, 24_000),
    ("M18x1", 18_000, 1_000, 17_000),
];

/// What stands behind a thread.
#[derive(Clone, Copy, Debug)]
enum Behind {
    /// The thread ends with the part, with or without a chamfer.
    Open { chamfer: bool },
    /// So many tenths of a pitch of plain hole, then a cone or a flat bottom.
    Bottom { tenths: i64, flat: bool },
    /// Plain hole to the end of the part.
    PlainThrough,
}

#[derive(Clone, Debug)]
struct Draft {
    thread: usize,
    /// Where it is drawn between the minor diameter and the drill, percent.
    drawn: i64,
    /// Length of the thread in tenths of its diameter.
    long: i64,
    chamfer: bool,
    /// A wider bore before it: its radius over that of the mouth, and its depth, µm.
    seat: Option<(i64, i64)>,
    behind: Behind,
    /// Drawn from the other end.
    over: bool,
    material: &'static str,
    lathe: &'static str,
}

fn mm(um: i64) -> String {
    let sign = if um < 0 { "-" } else { "" };
    format!("{sign}{}.{:03}", um.abs() / 1000, um.abs() % 1000)
}

impl Draft {
    /// The corners of the bore, diameter and depth, with the index of the thread's line.
    fn bore(&self) -> (Vec<(i64, i64)>, usize, i64) {
        let (_, size, pitch, drill) = THREADS[self.thread];
        let minor = size - pitch * 10_825 / 10_000;
        // Whole half micrometres of the radius, and no narrower than the minor diameter.
        let hole = ((minor + (drill - minor) * self.drawn / 100 + 1) / 2 * 2).min(drill);
        let mut corners = Vec::new();
        let mut z = 0;
        let mouth = if self.chamfer { (size + pitch / 2) / 2 * 2 } else { hole };
        if let Some((over, deep)) = self.seat {
            // Seats are of whole millimetres, as drills are.
            let seat = (mouth + 2 * over) / 1000 * 1000 + 1000;
            corners.push((seat, 0));
            corners.push((seat, deep));
            z = deep;
        }
        corners.push((mouth, z));
        if self.chamfer {
            z += (mouth - hole) / 2;
            corners.push((hole, z));
        }
        let thread = corners.len() - 1;
        z += size * self.long / 10 / 2 * 2;
        corners.push((hole, z));
        let length = match self.behind {
            Behind::Open { chamfer: false } => z,
            Behind::Open { chamfer: true } => {
                let wide = (size + pitch / 2) / 2 * 2;
                z += (wide - hole) / 2;
                corners.push((wide, z));
                z
            }
            Behind::Bottom { tenths, flat } => {
                z += pitch * tenths / 10 / 2 * 2;
                corners.push((hole, z));
                let point = if flat { 0 } else { (hole as f64 / 2.0 / 59_f64.to_radians().tan()) as i64 };
                corners.push((0, z + point));
                z + point + 15_000
            }
            Behind::PlainThrough => {
                z += 20_000;
                corners.push((hole, z));
                z
            }
        };
        (corners, thread, length)
    }

    fn text(&self) -> String {
        let (name, size, ..) = THREADS[self.thread];
        let (mut corners, mut thread, length) = self.bore();
        let blind = corners.last().is_some_and(|last| last.0 == 0);
        if self.over && !blind {
            corners = corners.into_iter().rev().map(|(d, z)| (d, length - z)).collect();
            thread = corners.len() - 2 - thread;
        }
        let widest = corners.iter().map(|corner| corner.0).max().unwrap_or_default();
        let outside = (widest + size + 16_000) / 1000 * 1000;
        let mut text = format!(
            "shaft: Random\nmaterial: {}\nblank: {{kind: bar, diameter: {}, length: {}, face: 1}}\nmachine: {}\nouter:\n",
            self.material,
            mm(outside + 4_000),
            mm(length + 45_000),
            self.lathe
        );
        let first = corners[0].0;
        text += &format!("  - {{from: {{d: {}, z: 0}}}}\n  - {{face: {}}}\n", mm(first), mm(outside - 2_000));
        text += &format!("  - {{chamfer: 1}}\n  - {{cylinder: -{}}}\n", mm(length));
        text += &format!("inner:\n  - {{from: {{d: {}, z: 0}}}}\n", mm(first));
        for (index, pair) in corners.windows(2).enumerate() {
            let ((d0, z0), (d1, z1)) = (pair[0], pair[1]);
            text += &match () {
                () if index == thread => format!("  - {{thread: {name}, to: -{}}}\n", mm(z1)),
                () if d0 == d1 => format!("  - {{cylinder: -{}}}\n", mm(z1)),
                () if z0 == z1 => format!("  - {{face: {}}}\n", mm(d1)),
                () if d1 == 0 => format!("  - {{cone: {{d: 0, z: -{}}}}}\n", mm(z1)),
                () => format!("  - {{cone: {{d: {}, z: -{}}}, kind: chamfer}}\n", mm(d1), mm(z1)),
            };
        }
        text
    }
}

fn drafts() -> impl Strategy<Value = Draft> {
    let behind = prop_oneof![
        any::<bool>().prop_map(|chamfer| Behind::Open { chamfer }),
        (10_i64..90, any::<bool>()).prop_map(|(tenths, flat)| Behind::Bottom { tenths, flat }),
        Just(Behind::PlainThrough),
    ];
    let seat = prop::option::weighted(0.3, (1_000_i64..9_000, 3_000_i64..30_000).prop_map(|(r, z)| (r / 2 * 2, z)));
    let made = (0..THREADS.len(), 0_i64..=100, 5_i64..40, any::<bool>(), seat, behind, any::<bool>());
    let of = (
        prop::sample::select(vec!["steel-45", "cast-iron-sch20", "bronze-brazh9-4", "aluminium-d16", "steel-40x"]),
        prop::sample::select(vec!["16k20f3", "16a20f3", "16b16t1"]),
    );
    (made, of).prop_map(|((thread, drawn, long, chamfer, seat, behind, over), (material, lathe))| Draft {
        thread,
        drawn,
        long,
        chamfer,
        seat,
        behind,
        over,
        material,
        lathe,
    })
}

fn planned(text: &str) -> Result<Operation, String> {
    let turned = read_turned("part", text, &KNOWLEDGE).map_err(|faults| format!("{faults:?}"))?;
    Ok(plan(&turned, &KNOWLEDGE).unwrap())
}

fn wrong(operation: &Operation) -> Vec<String> {
    let wrong = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    wrong.map(|finding| finding.note.code().to_owned()).collect()
}

fn is_cut(operation: &Operation) -> bool {
    let mut jobs = operation.set_ups.iter().flat_map(|one| &one.jobs);
    jobs.any(|job| matches!(job.work, Work::Tap | Work::Thread))
}

/// What must hold of any such part.
fn law(text: &str) -> Result<(), String> {
    let operation = planned(text)?;
    let wrong = wrong(&operation);
    // Where the bore itself cannot be made, that is told and not the thread in it.
    let says = |codes: &[&str]| wrong.iter().any(|code| codes.contains(&code.as_str()));
    if !is_cut(&operation) && !says(&["thread-not-cut", "bore-too-narrow-to-drill", "swept-thread-shallow"]) {
        return Err(format!("silent: {wrong:?}"));
    }
    // Nothing that would break a tap or the part, but where the bore before it could not be made.
    let undone = ["surface-not-finished", "bore-too-narrow-to-drill", "no-bar-for-bore", "swept-stands"];
    let broken = ["swept-tap-blocked", "swept-tap-out-of-step", "swept-tap-hole-wide", "swept-thread-short"];
    if says(&["swept-gouge"]) || (says(&broken) && !says(&undone)) {
        return Err(format!("planned against its proof: {wrong:?}"));
    }
    for control in ["linuxcnc", "fanuc", "sinumerik"] {
        for written in programs(&operation, control, Form::Motions, None, &KNOWLEDGE).unwrap() {
            if let Ok(files) = written.files
                && let Some(why) = read_back(&operation, written.set_up, control, &files, &KNOWLEDGE).unwrap()
            {
                return Err(format!("{control} {}: {why:?}", written.set_up));
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(technolog_laws::cases!(25))]

    #[test]
    fn a_thread_on_the_axis_is_cut_and_proven_or_told(draft in drafts()) {
        let text = draft.text();
        prop_assert!(law(&text).is_ok(), "{:?}\n{}", law(&text), text);
    }
}

/// How random threads fare: `CASES=200 SEED=2 cargo test --test turning tapping_laws::survey -- --ignored --nocapture`.
#[test]
#[ignore = "prints a survey: CASES says of how many parts"]
fn survey() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
    let Some(count) = std::env::var("CASES").ok().and_then(|text| text.parse::<usize>().ok()) else { return };
    let seed = std::env::var("SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let mut runner = TestRunner::new_with_rng(Config::default(), TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]));
    let mut seen: BTreeMap<String, (usize, String)> = BTreeMap::new();
    for _ in 0..count {
        let text = drafts().new_tree(&mut runner).unwrap().current().text();
        let found = std::panic::catch_unwind(|| match (law(&text), planned(&text)) {
            (Err(why), _) => vec![format!("LAW {}", why.chars().take(90).collect::<String>())],
            (_, Ok(operation)) if wrong(&operation).is_empty() => vec!["whole".to_owned()],
            (_, Ok(operation)) => {
                let mut all = wrong(&operation);
                all.sort();
                all.dedup();
                vec![all.join(" ")]
            }
            (_, Err(why)) => vec![why],
        });
        for what in found.unwrap_or_else(|_| vec!["PANIC".to_owned()]) {
            let entry = seen.entry(what).or_insert_with(|| (0, text.clone()));
            entry.0 += 1;
        }
    }
    for (what, (count, text)) in &seen {
        println!("{count:5} {what}");
        if what != "whole" {
            println!("{text}\n");
        }
    }
}
