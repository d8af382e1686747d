//! The time of an audit. Target: 1,000 plans of the size of Appendix Г in under 2 s on two cores, so 4 ms each.

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]

use std::hint::black_box;
use std::path::Path;

use criterion::Criterion;
use technolog::audit::{Auditor, read_plan};
use technolog::{planner, shipped};

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let knowledge = shipped::knowledge().unwrap();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/appendix-g");
    let text = std::fs::read_to_string(folder.join("plan.yaml")).unwrap();
    let files = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
    let stated = read_plan("plan.yaml", &text, &knowledge, &files).unwrap();
    let ours = planner::plan(&stated.part, stated.method, &knowledge).unwrap();

    let mut group = criterion.benchmark_group("audit");
    group.bench_function("reading a plan file", |bench| {
        bench.iter(|| read_plan("plan.yaml", black_box(&text), &knowledge, &files).unwrap());
    });
    group.bench_function("our own plan beside it", |bench| {
        bench.iter(|| planner::plan(black_box(&stated.part), stated.method, &knowledge).unwrap());
    });
    group.bench_function("a plan beside ours", |bench| {
        bench.iter(|| Auditor::new(&knowledge).unwrap().audit_beside(black_box(&stated), &ours).unwrap());
    });
    let auditor = Auditor::new(&knowledge).unwrap();
    group.bench_function("one of many plans", |bench| {
        bench.iter(|| auditor.audit(black_box(&stated)).unwrap());
    });
    group.finish();
    criterion.final_summary();
}
