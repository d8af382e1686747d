//! The column *ours* of docs/hand-plans.md against the plans of today.
//!
//! `UPDATE_DOCS=1 cargo test --test documents hand_plans::` writes what differs anew. Then read the differences that the page
//! tells: they are written by hand.

use std::fs;

use technolog::motion::time::Clock;
use technolog::motion::{MotionStep, Position};
use technolog::plan::{Plan, Transition};
use technolog::program::Language;
use technolog_testing::proof_bench::ProofBench;
use technolog_testing::{KNOWLEDGE, read, root};

/// What stands for a transition: from its diameter to the unit of its time.
fn of_transition(transition: &Transition) -> (String, String) {
    let short = |value: f64| format!("{value:.3}").trim_end_matches('0').trim_end_matches('.').to_owned();
    let or_dash =
        |value: Option<f64>, digits| value.map_or_else(|| "–".to_owned(), |value| format!("{value:.digits$}"));
    let conditions = &transition.conditions;
    let head = format!("Ø{}: s ", short(transition.diameter_mm.to_mm()));
    let text = format!(
        "{head}{}, v {:.1}, n {:.0}, F {:.0}; {} N; {} N·m; {} kW; {:.2} min",
        short(conditions.feed_mm_per_rev.0),
        conditions.speed_m_per_min.0,
        conditions.spindle_rpm.0,
        conditions.feed_mm_per_min.0,
        or_dash(conditions.axial_force_n.map(|force| force.0), 0),
        or_dash(conditions.torque_n_m.map(|torque| torque.0), 1),
        or_dash(conditions.power_kw.map(|power| power.0), 2),
        conditions.machine_time_min.0,
    );
    (head, text)
}

/// What stands for the times of a plan and of its program.
fn of_times(plan: &Plan, bench: &ProofBench) -> (String, String) {
    let control = Language::read("2c42-65", &KNOWLEDGE).unwrap();
    let mut sink = (Vec::<MotionStep>::new(), Clock::new(&bench.machine, Position::default()));
    control.check(&bench.written(&control), &bench.machine, &bench.setting, &mut sink);
    let head = "Times of ours: machine time ".to_owned();
    let out = match plan.time.feed_out_min.0 {
        none if none < 0.005 => String::new(),
        out => format!(" and {out:.2} of other motions at feed"),
    };
    let text = format!(
        "{head}{:.2} min{out}; with rapids and tool changes {:.2} min by the plan, {:.2} min",
        plan.time.machine_min.0,
        plan.time.total_min.0,
        sink.1.times().total_min.0,
    );
    (head, text)
}

#[test]
fn the_page_of_hand_plans_has_the_figures_of_today() {
    let path = root().join("docs/hand-plans.md");
    let old = fs::read_to_string(&path).unwrap();
    let mut sections: Vec<String> = old.split("\n## ").map(str::to_owned).collect();
    let mut differs = Vec::new();
    for number in 1..=10 {
        let part = read(&fs::read_to_string(root().join(format!("examples/hand-plans/{number}.yaml"))).unwrap());
        let bench = ProofBench::of(&part);
        let section = sections.iter_mut().find(|section| section.starts_with(&format!("{number}. "))).unwrap();
        let transitions = bench.plan.holes.iter().flat_map(|hole| &hole.transitions).map(of_transition);
        for (head, text) in transitions.chain([of_times(&bench.plan, &bench)]) {
            if section.contains(&text) {
                continue;
            }
            differs.push(format!("{number}: {text}"));
            let end = if head.starts_with('Ø') { " min" } else { " by its program" };
            let begin = section.find(&head).unwrap_or_else(|| panic!("{number} has no {head}"));
            let length = section[begin..].find(end).unwrap() + if end == " min" { end.len() } else { 0 };
            section.replace_range(begin..begin + length, &text);
        }
    }
    let update = std::env::var("UPDATE_DOCS").is_ok_and(|value| value == "1");
    if update {
        fs::write(&path, sections.join("\n## ")).unwrap();
    }
    assert!(update || differs.is_empty(), "old, UPDATE_DOCS=1 writes it anew:\n{}", differs.join("\n"));
}

#[test]
fn the_differences_name_no_spindle_speed_that_their_table_lacks() {
    let page = fs::read_to_string(root().join("docs/hand-plans.md")).unwrap();
    let sections: Vec<(&str, &str)> =
        page.split("\n## ").filter_map(|section| section.split_once("\nDifferences:")).collect();
    assert_eq!(sections.len(), 10);
    for (table, prose) in sections {
        let figures: Vec<&str> = table.split(|letter: char| !letter.is_ascii_digit() && letter != '.').collect();
        let before = prose.split(" 1/min").collect::<Vec<_>>();
        for speed in before[..before.len() - 1].iter().filter_map(|text| text.rsplit(' ').next()) {
            let title = table.lines().next().unwrap_or_default();
            assert!(figures.contains(&speed), "{title}: {speed} 1/min is of another day");
        }
    }
}
