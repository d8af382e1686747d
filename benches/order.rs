//! The length of paths and the time for finding them, with lower bounds.
//!
//! `cargo bench --bench order` prints one line per pattern, metric and effort; the clock is read here, never by the
//! search. `-- growth` measures four sizes of scattered points, `-- tours` what one, three and ten seconds find on drilling
//! problems and on many points. `cargo bench --bench order -- csv FOLDER` writes the patterns as lists of points instead, so
//! that other programs can be measured on them (`tests/oracles/fast_tsp.py`).

#![allow(clippy::unwrap_used, reason = "a bench that cannot begin has nothing to measure")]

use std::time::Instant;

use technolog::machine::Rapid;
use technolog::part::Point;
use technolog::sequence::bound::{lower_bound, rounds};
use technolog::sequence::list::read_list;
use technolog::sequence::metric::Metric;
use technolog::sequence::tour::{Effort, Space, nearest_rule, path, path_while, usual_tries};
use technolog::units::MillimetresPerMinute;
use technolog_testing::patterns;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(at) = arguments.iter().position(|argument| argument == "csv") {
        return write(&arguments[at + 1]);
    }
    if arguments.iter().any(|argument| argument == "growth") {
        return growth();
    }
    if arguments.iter().any(|argument| argument == "tours") {
        return tours();
    }
    let rapid = Metric::Rapid(Rapid { rate: MillimetresPerMinute(7000.0), acceleration: None });
    println!("pattern      metric  points  effort  length mm   nearest mm   bound mm  over bound  time s  (bound s)");
    // Cargo tells a bench `--bench`; `-- mixed` measures the patterns of that name alone.
    let chosen = arguments.iter().skip(1).find(|argument| !argument.starts_with('-'));
    for (name, points) in patterns::all() {
        if chosen.is_some_and(|chosen| !name.contains(chosen.as_str())) {
            continue;
        }
        for (word, metric) in [("euclid", Metric::Euclid), ("rapid", rapid)] {
            let space = Space::closed(&points, metric);
            let book = nearest_rule(&space).cost;
            let (mut rows, mut best) = (Vec::new(), i64::MAX);
            let efforts = if points.len() <= 13 { vec![1] } else { vec![1, 5, 20] };
            for effort in efforts {
                let start = Instant::now();
                let found = path(&space, Effort(effort));
                rows.push((effort, found.cost, start.elapsed().as_secs_f64()));
                best = best.min(found.cost);
            }
            let start = Instant::now();
            let bound = lower_bound(&space, best, rounds(space.nodes()));
            let spent = start.elapsed().as_secs_f64();
            for (effort, cost, time) in rows {
                println!(
                    "{name:<12} {word:<7} {:>6} {effort:>7} {:>10.3} {:>12.3} {:>10.3} {:>10.2} % {time:>7.4}  ({spent:.2})",
                    points.len(),
                    cost as f64 / 1000.0,
                    book as f64 / 1000.0,
                    bound as f64 / 1000.0,
                    (cost as f64 / bound as f64 - 1.0) * 100.0,
                );
            }
        }
    }
}

/// How the time of a search grows with the points, of a given number of tries and with the bound.
fn growth() {
    println!("points  tries  open  seconds  bound s  over bound");
    for count in [2_500, 5_000, 10_000, 20_000] {
        let points = patterns::random(count);
        for (word, space) in
            [("no", Space::closed(&points, Metric::Euclid)), ("yes", Space::open(&points, Metric::Euclid))]
        {
            let start = Instant::now();
            let found = path_while(&space, &mut |tries| tries < usual_tries(count));
            let search = start.elapsed().as_secs_f64();
            let bound = lower_bound(&space, found.cost, rounds(count));
            let spent = start.elapsed().as_secs_f64() - search;
            let over = (found.cost as f64 / bound as f64 - 1.0) * 100.0;
            println!("{count:>6} {:>6} {word:>5} {search:>8.3} {spent:>8.3} {over:>8.2} %", found.tries);
        }
    }
}

/// The drilling problems of TSPLIB whose shortest tours are known, and scattered points of the same and of larger sizes.
fn tours() {
    println!("points             open  length mm  over shortest  over bound  time s  tries");
    let drilled = |name: &str| {
        let file = format!("{}/tests/tours/{name}.tsp", env!("CARGO_MANIFEST_DIR"));
        read_list(name, &std::fs::read_to_string(file).unwrap()).unwrap().points
    };
    for (name, points, metric, shortest, all_seconds) in [
        ("d198", drilled("d198"), Metric::EuclidWhole, Some(15_780), &[1.0][..]),
        ("657 scattered", patterns::random(657), Metric::Euclid, None, &[1.0, 10.0]),
        ("d1291", drilled("d1291"), Metric::EuclidWhole, Some(50_801), &[1.0, 3.0]),
        ("1300 scattered", patterns::random(1_300), Metric::Euclid, None, &[1.0, 3.0]),
        ("20000 scattered", patterns::random(20_000), Metric::Euclid, None, &[1.0, 10.0]),
    ] {
        for (word, space) in [("no", Space::closed(&points, metric)), ("yes", Space::open(&points, metric))] {
            for seconds in all_seconds {
                let start = Instant::now();
                let found = path_while(&space, &mut |_| start.elapsed().as_secs_f64() < *seconds);
                let spent = start.elapsed().as_secs_f64();
                let bound = lower_bound(&space, found.cost, rounds(points.len()));
                let over = |least: i64| format!("{:.3} %", (found.cost as f64 / least as f64 - 1.0) * 100.0);
                // Of open paths nobody has published the shortest.
                let known = shortest.filter(|_| word == "no").map_or_else(String::new, |known| over(known * 1000));
                println!(
                    "{name:<18} {word:>4} {:>10.3} {known:>14} {:>11} {spent:>7.2} {:>6}",
                    found.cost as f64 / 1000.0,
                    over(bound),
                    found.tries
                );
            }
        }
    }
}

/// Every pattern as `FOLDER/name.csv`.
fn write(folder: &str) {
    std::fs::create_dir_all(folder).unwrap();
    for (name, points) in patterns::all() {
        let line = |point: &Point| format!("{},{}\n", point.x, point.y);
        let text: String = points.iter().map(line).collect();
        std::fs::write(format!("{folder}/{name}.csv"), format!("x,y\n{text}")).unwrap();
    }
}
