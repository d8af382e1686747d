//! The number of decisions with reasons per second, and the times of the lint, of loading and of a plan.
//!
//! `cargo bench` runs all of it; `cargo bench -- query` one group. Targets, each on one core: a million decisions
//! with reasons per second, the whole lint under 100 ms, loading under 3 ms, a whole `technolog plan` under 20 ms, a
//! part of a thousand holes of forty kinds under 1 s, linear in the number of kinds.

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]

use std::hint::black_box;

use criterion::{BenchmarkGroup, Criterion, Throughput, measurement::WallTime};
use technolog::knowledge::{Column, ColumnType, Input, Knowledge, Table, lint, load};
use technolog::plan::CuttingMethod;
use technolog::units::{ItGrade, Micrometres, Roughness};
use technolog::{part, planner, shipped};
use technolog_testing::kinds;

/// Questions per iteration, all different, so that neither branches nor caches learn one answer.
const QUESTIONS: usize = 1024;

const PLATE: &str = include_str!("../examples/plate.yaml");

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let knowledge = shipped::knowledge().unwrap();

    let mut query = criterion.benchmark_group("query");
    query.throughput(Throughput::Elements(QUESTIONS as u64));
    decisions(&mut query, "60 rows, 4 inputs", &load::table_from_text("sixty.yaml", &sixty_rows()).unwrap());
    decisions(&mut query, "table A.8", knowledge.table("A.8").unwrap());
    query.finish();

    criterion.bench_function("lint", |bench| {
        bench.iter(|| {
            let (knowledge, problems) = Knowledge::read_sources(black_box(shipped::SOURCES));
            (lint::lint(&knowledge), problems)
        });
    });
    criterion.bench_function("load", |bench| bench.iter(shipped::knowledge));
    criterion.bench_function("plan", |bench| {
        bench.iter(|| {
            let part = part::read_part("plate.yaml", black_box(PLATE), &knowledge).unwrap();
            planner::plan(&part, CuttingMethod::default(), &knowledge)
        });
    });

    // All of them 25 holes a kind: the time a kind is the throughput, which stays as the kinds grow.
    let mut many = criterion.benchmark_group("plan-kinds");
    many.sample_size(20);
    for number in [10, 20, 40] {
        let part = part::read_part("kinds.yaml", &kinds::part_of_kinds(number), &knowledge).unwrap();
        many.throughput(Throughput::Elements(number as u64));
        many.bench_function(number.to_string(), |bench| {
            bench.iter(|| planner::plan(black_box(&part), CuttingMethod::default(), &knowledge));
        });
    }
    many.finish();
    criterion.final_summary();
}

/// Queries a table with every question and reads the whole answer: the row that applies, and for each other row the
/// column that failed.
fn decisions(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, table: &Table) {
    let mut random = Random(1);
    let questions: Vec<Vec<_>> = (0..QUESTIONS).map(|_| question(table, &mut random)).collect();
    group.bench_function(name, |bench| {
        bench.iter(|| {
            for inputs in &questions {
                let answer = table.decide(black_box(inputs)).unwrap();
                let lost = answer.rejected().map(|(row, column)| row.index + column.name.len()).sum::<usize>();
                black_box((answer.winner(), lost));
            }
        });
    });
}

/// An input for each input column, evenly from its domain.
fn question<'t>(table: &'t Table, random: &mut Random) -> Vec<(&'t str, Input<'t>)> {
    table.inputs().map(|(_, column)| (column.name.as_str(), input(column, random))).collect()
}

fn input<'t>(column: &'t Column, random: &mut Random) -> Input<'t> {
    let allowed = column.allowed();
    let intervals = allowed.intervals();
    let (low, high) = intervals[random.below(intervals.len() as u64) as usize];
    let rank = low + random.below(high.abs_diff(low) + 1) as i64;
    match column.ty {
        ColumnType::Enum => Input::Text(&column.values[rank as usize]),
        ColumnType::Bool => Input::Bool(rank == 1),
        ColumnType::It => Input::Grade(ItGrade::new(rank as u8).unwrap()),
        ColumnType::Roughness => Input::Roughness(Roughness::from_ra_nanometres(rank as u32)),
        ColumnType::Length => Input::Length(Micrometres::new(rank)),
        _ => Input::Int(rank),
    }
}

/// A decision table of sixty rows that cover their domain once: 5 diameters × 3 depths × 2 groups of
/// grades × 2 states.
fn sixty_rows() -> String {
    let mut text = String::from(
        r#"table: sixty
title: {uk: шістдесят рядків, en: sixty rows}
kind: decision
place: bench
columns:
  - {name: diameter, type: length, unit: mm, role: input, domain: "(0..100]"}
  - {name: depth, type: length, unit: mm, role: input, domain: "(0..300]"}
  - {name: it, type: it, role: input, domain: "[6..14]"}
  - {name: state, type: enum, values: [solid, cast], role: input}
  - {name: scheme, type: int, role: output}
rows:
"#,
    );
    let mut scheme = 0;
    for diameter in ["<= 6", "(6..15]", "(15..30]", "(30..50]", "> 50"] {
        for depth in ["<= 20", "(20..80]", "> 80"] {
            for it in ["[6..9]", "[10..14]"] {
                for state in ["solid", "cast"] {
                    scheme += 1;
                    text.push_str(&format!(
                        "  - {{diameter: \"{diameter}\", depth: \"{depth}\", it: \"{it}\", state: {state}, \
                         scheme: {scheme}, source: seed}}\n"
                    ));
                }
            }
        }
    }
    text
}

/// The same numbers in every run (a linear congruence; its high bits are even enough here).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }
}
