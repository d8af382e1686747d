//! The proof that a program makes its part: right programs, Appendix Г, and programs with one word changed.
//!
//! A folder of `tests/proof` holds `program.nc` and `part`, the path of the part that it makes as planned.

#![allow(clippy::unwrap_used, reason = "clippy allows it in tests, but not in the functions they share")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use technolog::job::{self, Job};
use technolog::knowledge::Knowledge;
use technolog::machine::Machine;
use technolog::motion::time::Clock;
use technolog::motion::{Axis, Position, Step};
use technolog::part::read_part;
use technolog::plan::{CuttingMethod, Plan};
use technolog::planner;
use technolog::program::Fault;
use technolog::program::control_2c42_65::{Control, Setting, check};
use technolog::program::proof::{Asked, Proof, prove};
use technolog::shipped;
use technolog::shop::Shop;
use technolog::units::Micrometres;

#[path = "common/mutants.rs"]
mod mutants;

use mutants::{Run, Score, score};

static KNOWLEDGE: LazyLock<Knowledge> = LazyLock::new(|| shipped::knowledge().unwrap());
static CONTROL: LazyLock<Control> = LazyLock::new(|| Control::read(&KNOWLEDGE).unwrap());

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

/// A part as programs are held against it.
struct Held {
    plan: Plan,
    job: Job,
    machine: Machine<'static>,
    setting: Setting,
}

impl Held {
    fn new(path: &str) -> Self {
        let text = fs::read_to_string(root().join(path)).unwrap();
        let part = read_part(path, &text, &KNOWLEDGE).unwrap();
        let plan = planner::plan(&part, CuttingMethod::default(), &KNOWLEDGE).unwrap();
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        let job = job::make(&plan, &shop).unwrap();
        let mut setting = Setting { correctors: job.correctors.iter().copied().collect(), ..Setting::default() };
        for (setup, zero) in job.setups.iter().zip(&mut setting.zeros) {
            *zero = Axis::ALL.map(|axis| Some(setup.zero.get(axis)));
        }
        Self { plan, job, machine: Machine::find(&KNOWLEDGE, "gf2171").unwrap(), setting }
    }

    fn run(&self, text: &str) -> (Vec<Fault>, Proof, Run) {
        let mut sink = (Vec::<Step>::new(), Clock::new(&self.machine, self.setting.start));
        let faults = check(text, &CONTROL, &self.machine, &self.setting, &mut sink);
        let (steps, clock) = sink;
        let zeros: Vec<Position> = self.job.setups.iter().map(|setup| setup.zero).collect();
        let proof = prove(
            &steps,
            &Asked {
                plan: &self.plan,
                job: &self.job,
                zeros: &zeros,
                start: self.setting.start,
                overrun: Micrometres::from_mm(3),
                own_correctors: false,
            },
        );
        let said = faults.iter().map(|fault| format!("{:?} {:?}", fault.severity, fault.note));
        let said = said.chain(proof.findings.iter().map(|finding| format!("{:?} {:?}", finding.severity, finding.note)));
        let run = Run::of(&steps, self.setting.start, said, format!("{:?}", clock.times()));
        (faults, proof, run)
    }
}

/// The right programs: folder, program, part.
fn right() -> Vec<(String, String, Held)> {
    let mut folders: Vec<PathBuf> =
        fs::read_dir(root().join("tests/proof")).unwrap().map(|entry| entry.unwrap().path()).collect();
    folders.sort();
    let read = |path: PathBuf| fs::read_to_string(path).unwrap();
    folders
        .into_iter()
        .map(|folder| {
            let name = folder.file_name().unwrap().to_string_lossy().into_owned();
            (name, read(folder.join("program.nc")), Held::new(read(folder.join("part")).trim()))
        })
        .collect()
}

#[test]
fn of_a_right_program_nothing_is_said_and_every_stop_is_visited_in_the_order_of_the_job() {
    let programs = right();
    assert!(programs.len() > 2);
    for (name, text, held) in programs {
        let (faults, proof, _) = held.run(&text);
        assert!(faults.is_empty(), "{name}: {faults:?}");
        assert!(proof.findings.is_empty(), "{name}: {:?}", proof.findings);
        let visited: Vec<_> =
            proof.visits.iter().map(|visit| (visit.hole.as_str(), visit.transition, visit.pass, visit.at)).collect();
        let planned: Vec<_> =
            held.job.stops().map(|(.., stop)| (stop.hole.as_str(), stop.transition, stop.pass, stop.at)).collect();
        assert_eq!(visited, planned, "{name}");
    }
}

/// Delete, swap or alter any one word of a program, and something is said, or the program does the same.
#[test]
fn no_word_can_be_changed_unnoticed() {
    let mut kinds: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    let mut unnoticed = Vec::new();
    for (name, text, held) in right() {
        let Score { kinds: own, unnoticed: mut more } = score(&name, &text, |text| held.run(text).2);
        for (kind, counts) in own {
            let all = kinds.entry(kind).or_default();
            for (all, count) in all.iter_mut().zip(counts) {
                *all += count;
            }
        }
        unnoticed.append(&mut more);
    }
    let mut report = String::from("kind          noticed  same  unnoticed\n");
    for (kind, [noticed, same, missed]) in &kinds {
        report.push_str(&format!("{kind:<12} {noticed:>8} {same:>5} {missed:>10}\n"));
    }
    println!("{report}");
    assert!(unnoticed.is_empty(), "{report}{}", unnoticed.join("\n"));
}
