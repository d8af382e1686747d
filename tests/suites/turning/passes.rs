//! `technolog turn`: the paper's shaft, the laws of every sequence of passes, and bad shaft files.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use proptest::prelude::*;
use serde_json::Value;
use technolog::knowledge::input::text_of;
use technolog::turning::length::Half;
use technolog::turning::passes::cost::{Cost, Objective};
use technolog::turning::passes::enumeration::enumerate;
use technolog::turning::passes::grid::{Grid, states};
use technolog::turning::passes::optimum::CostToGo;
use technolog::turning::passes::pass::{Pass, PassDirection, legs};
use technolog::turning::passes::rich::staircase::{Lines, Stairs};
use technolog::turning::passes::variants::{per_step, total};
use technolog::turning::passes::{find, named, rich};
use technolog::turning::point::Point;
use technolog::turning::shaft::{Division, Mistake, Rates, Shaft};
use technolog::turning::workpiece::read_turned;
use technolog::units::Micrometres;
use technolog_testing::shafts::{by_petgraph, objectives, rates, shaft, shafts};
use technolog_testing::{KNOWLEDGE, shafts};

fn run(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).env_remove("LANG").arg("turn").args(args).output().unwrap()
}

fn text(args: &[&str]) -> String {
    let output = run(args);
    // 1: nothing holds some of these shafts.
    assert!(matches!(output.status.code(), Some(0 | 1)), "{args:?}");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{args:?}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&text(&[args, &["--format", "json"]].concat())).unwrap()
}

fn variant<'v>(answer: &'v Value, name: &str) -> &'v Value {
    answer["variants"].as_array().unwrap().iter().find(|variant| variant["name"] == name).unwrap()
}

fn path(answer: &Value, name: &str) -> f64 {
    variant(answer, name)["cutting_path_mm"].as_f64().unwrap()
}

/// The paper, results: 100 mm lengthwise, 107.5 mm crosswise, and 98.5 mm with the first step crosswise to Ø40 and the
/// rest lengthwise to Ø50.
#[test]
fn the_paper_s_shaft_gives_the_paper_s_figures() {
    let answer = json(&["examples/shaft.yaml"]);
    assert_eq!(path(&answer, "longitudinal"), 100.0);
    assert_eq!(path(&answer, "transverse"), 107.5);
    assert_eq!(path(&answer, "per-step"), 98.5);
    let passes = variant(&answer, "per-step")["passes"].as_array().unwrap();
    let kinds: Vec<&str> = passes.iter().map(|pass| pass["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, [["transverse"; 5].as_slice(), &["longitudinal"; 2]].concat());
    assert!(passes[..5].iter().all(|pass| pass["to"]["diameter_mm"] == 40));
    assert_eq!(passes[6]["to"]["diameter_mm"], 50);
}

/// By hand: two levels over both steps (2 × 34), the first level of the thinner step (16), and then its last millimetre
/// in five slices (5 × 1).
#[test]
fn the_free_optimum_of_the_paper_s_shaft_is_shorter_than_the_paper_s() {
    let answer = json(&["examples/shaft.yaml"]);
    assert_eq!(path(&answer, "optimal"), 2.0 * 34.0 + 16.0 + 5.0);
    let lengths: Vec<f64> = variant(&answer, "optimal")["passes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|pass| pass["length_mm"].as_f64().unwrap())
        .collect();
    assert_eq!(lengths, [34.0, 34.0, 16.0, 1.0, 1.0, 1.0, 1.0, 1.0]);
    let grid = Grid::of(&example("shaft"));
    let (best, orders) = enumerate(&grid, Objective::Path);
    assert_eq!(best.unwrap().main, Half::of(Micrometres::from_mm(89)).halves().unsigned_abs());
    assert!(orders > 100, "{orders}");
}

fn example(name: &str) -> Shaft {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.yaml"));
    let text = fs::read_to_string(file).unwrap();
    let read = read_turned(name, &text, &KNOWLEDGE).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    read.shaft.unwrap()
}

#[test]
fn the_pages_of_the_examples() {
    insta::assert_snapshot!("turn_shaft_uk", text(&["examples/shaft.yaml", "--lang", "uk"]));
    insta::assert_snapshot!("turn_shaft_en", text(&["examples/shaft.yaml", "--lang", "en"]));
    let six =
        text(&["examples/shaft-six-steps.yaml", "--lang", "uk", "--objective", "path-and-passes", "--per-pass", "5"]);
    insta::assert_snapshot!("turn_six_uk", six);
    let time = text(&["examples/shaft-six-steps.yaml", "--lang", "en", "--objective", "time"]);
    insta::assert_snapshot!("turn_six_en_time", time);
}

#[test]
fn the_drawing_has_every_pass_of_every_variant() {
    let drawing = text(&["examples/shaft.yaml", "--format", "svg"]);
    assert!(drawing.starts_with("<svg ") && drawing.ends_with("</svg>\n"));
    // 4 + 11 + 7 + 8 arrows.
    assert_eq!(drawing.matches("stroke=\"#0072b2\" stroke-width=\"1\"").count(), 4 + 2 + 3);
    assert_eq!(drawing.matches("stroke=\"#d55e00\" stroke-width=\"1\"").count(), 11 + 5 + 5);
}

/// Eight passes, eight pictures: in the first all stock but that of the first pass still stands, in the last none.
#[test]
fn the_optimum_is_drawn_pass_by_pass() {
    let drawing = text(&["examples/shaft.yaml", "--show", "steps", "--format", "svg", "--lang", "en"]);
    for title in ["1. longitudinal, 34 mm, 34 in all", "8. transverse, 1 mm, 89 in all"] {
        assert!(drawing.contains(title), "{title}");
    }
    // Every text stands twice, first as its own white edge.
    let frames: Vec<&str> = drawing.split(" in all</text>").step_by(2).collect();
    assert_eq!(frames.len(), 9);
    let standing = |frame: &str| frame.matches("#f3ead2").count();
    assert!(standing(frames[1]) > standing(frames[2]) && standing(frames[7]) > 0);
    assert_eq!(standing(frames[8]), 0);
}

/// One pass of one level, with figures worked out by hand: from home (radius 22, Z 2 before the face) to radius 18 is
/// 4 mm; at the feed 2 + 10 mm; back by 0.5, out to radius 22 (3.5), along to home (11.5): rapids 0.5 + 3.5 + 11.5 + 4.
#[test]
fn the_time_of_one_pass_is_that_of_its_motions() {
    let shaft = shaft(40_000, &[(36_000, 10_000)], 4_000, 4_000, Division::Full);
    let rates = rates();
    let grid = Grid::of(&shaft);
    let passes = CostToGo::of(&grid, Objective::Time { rates }).passes();
    assert_eq!(passes.len(), 1);
    let time = total(&passes, Objective::Time { rates }, grid.bar).main as f64 / 60e9;
    let expected = 12.0 / 100.0 + (4.0 + 0.5 + 3.5 + 11.5) / 5000.0;
    assert!((time - expected).abs() < 1e-9, "{time} {expected}");
}

/// A step of 1 mm with 3 mm of stock, then one of 2 mm with 1 mm. By hand: lengthwise over the first alone, in levels
/// of 1 and 2 mm, is 2 × 1, and one slice over the second is 1. In the model a pass goes on to its shoulder: lengthwise
/// 3 + 1, crosswise 3 + 1, the first level lengthwise and the rest crosswise 3 + 2, a slice first 3 + 1.
#[test]
fn where_one_direction_per_step_beats_the_model_it_is_the_optimum_and_it_is_told() {
    let shaft = shaft(60_000, &[(54_000, 1_000), (58_000, 2_000)], 2_000, 2_000, Division::Full);
    let found = find(&shaft, Objective::Path, &KNOWLEDGE).unwrap();
    let of = |name: &str| found.variants.iter().find(|one| one.name == name).unwrap().cutting_path_mm.to_string();
    assert_eq!((of("per-step").as_str(), of("optimal").as_str()), ("3", "3"));
    assert_eq!(found.findings[0].note.code(), "variant-beyond-model");
    assert_eq!(CostToGo::of(&Grid::of(&shaft), Objective::Path).optimum().main, 2 * 4_000);
}

#[test]
fn every_bad_shaft_is_refused_with_every_mistake_at_its_place() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad-shafts");
    let mut seen = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|kind| kind != "yaml") {
            continue;
        }
        seen += 1;
        let expected = fs::read_to_string(path.with_extension("expected")).unwrap();
        let text = text_of("shaft", fs::read(&path).unwrap()).unwrap();
        let mistakes = read_turned("shaft", &text, &KNOWLEDGE).err().unwrap_or_default();
        let found: String = mistakes
            .iter()
            .map(|one| {
                let place = one.place().map_or_else(|| "-".to_owned(), |at| format!("{}:{}", at.line, at.column));
                format!("{place} {}\n", one.code())
            })
            .collect();
        assert_eq!(found, expected, "{}", path.display());
        for lang in ["uk", "en"] {
            let output = run(&[path.to_str().unwrap(), "--lang", lang]);
            let stderr = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(2), "{stderr}");
            assert!(output.stdout.is_empty());
            for (line, mistake) in expected.lines().zip(&mistakes) {
                let (place, code) = line.split_once(' ').unwrap();
                assert!(stderr.contains(&format!("{}:{place}", path.display())), "{stderr}");
                assert!(stderr.contains(&format!("[{code}]")), "{stderr}");
                assert_eq!(mistake.code(), code);
            }
            // The knowledge room has no remedy for a key that is missing or a number that is none: the message says it.
            let meant = mistakes.iter().filter(|one| matches!(one, Mistake::Meaning(..))).count();
            let helps = stderr.matches(if lang == "uk" { "= підказка:" } else { "= help:" }).count();
            assert!(helps >= meant, "{stderr}");
        }
    }
    assert!(seen >= 60, "{seen}");
}

/// The bound of docs/turned-part-format.md: 2,000 items. The mistake stands at the first item beyond it.
#[test]
fn a_contour_of_more_items_than_are_read_is_refused_at_the_first_of_them() {
    let file = |items: usize| {
        let cylinders = "  - {cylinder: {length: 1}}\n".repeat(items - 2);
        format!(
            "shaft: Long\nmaterial: steel-45\nblank: {{kind: bar, diameter: 30, length: 2100}}\nouter:\n  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 20}}\n{cylinders}"
        )
    };
    assert!(read_turned("long", &file(2000), &KNOWLEDGE).is_ok());
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("too-long.yaml");
    fs::write(&path, file(2001)).unwrap();
    let path = path.to_str().unwrap();
    for (lang, help) in [("uk", "= підказка:"), ("en", "= help:")] {
        let output = run(&[path, "--lang", lang]);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{stderr}");
        // Four lines before the first item: the 2001st stands in line 2005, behind its dash.
        for part in [&format!("{path}:2005:5"), "[too-many-items]", "2001", "2000", help] {
            assert!(stderr.contains(part), "{part}: {stderr}");
        }
        assert_eq!(stderr.matches(help).count(), 1, "{stderr}");
    }
}

/// The figures of the map at the paper's own length are those of the paper's shaft: L/D = 34/65 lies between the
/// ratios, so the shaft is made 65 mm long and compared with a shaft of that length.
#[test]
fn the_map_stretches_the_shaft() {
    let map = json(&["examples/shaft.yaml", "--show", "map"]);
    let map = map.as_array().unwrap();
    assert_eq!(map.len(), 21);
    let one = map.iter().find(|one| one["length_to_diameter"] == 1.0).unwrap();
    let shaft = shaft(65_000, &[(40_000, 30_588), (50_000, 34_412)], 4_000, 3_500, Division::Full);
    let grid = Grid::of(&shaft);
    let best = CostToGo::of(&grid, Objective::Path).optimum().main as f64;
    for (index, (_, passes)) in named(&grid, Objective::Path).iter().enumerate() {
        let above = (total(passes, Objective::Path, grid.bar).main as f64 / best - 1.0) * 100.0;
        assert!((above - one["above_optimum_percent"][index].as_f64().unwrap()).abs() <= 0.05, "{index}: {above}");
    }
    insta::assert_snapshot!("turn_map_uk", text(&["examples/shaft.yaml", "--show", "map", "--lang", "uk"]));
    let drawing = text(&["examples/shaft.yaml", "--show", "map", "--format", "svg"]);
    assert_eq!(drawing.matches("<circle").count(), 3 * 21);
}

#[test]
fn time_without_rates_is_refused_with_a_remedy() {
    let output = run(&["examples/shaft.yaml", "--objective", "time", "--lang", "en"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("no-rates") && stderr.contains("longitudinal_feed"), "{stderr}");
}

#[test]
fn what_a_pass_adds_is_no_less_than_nothing() {
    for bad in ["--per-pass=-3", "--per-pass=1e9", "--per-pass=99999999999", "--per-pass=0.00001"] {
        let output = run(&["examples/shaft.yaml", "--objective", "path-and-passes", bad]);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{bad}");
    }
}

/// The stock as columns: Z to which each reaches, and its radius. Passes are cut out of it one after the other.
struct Stock {
    columns: Vec<(Half, Half, Half)>,
    part: Vec<(Half, Half, Half)>,
}

impl Stock {
    /// Columns between all the places where anything begins or ends.
    fn of(grid: &Grid, passes: &[Pass]) -> Self {
        let ends = passes.iter().flat_map(|pass| [pass.from.z, pass.to.z]);
        let mut cuts: Vec<Half> = grid.slices.iter().map(|slice| slice.to).chain([Half::ZERO]).chain(ends).collect();
        cuts.sort_unstable();
        cuts.dedup();
        let columns = cuts.windows(2).map(|pair| (pair[0], pair[1], grid.bar)).collect();
        let under = |from: Half| grid.cylinders.iter().find(|one| one.from <= from && from < one.to).unwrap().radius;
        let part = cuts.windows(2).map(|pair| (pair[0], pair[1], under(pair[0]))).collect();
        Self { columns, part }
    }

    /// The largest radius strictly between two Z, or at one Z where they are equal.
    fn over(&self, a: Half, b: Half) -> Half {
        let (from, to) = (a.min(b), a.max(b));
        let inside = |(start, end, _): &&(Half, Half, Half)| {
            if from == to { *start < from && from < *end } else { *start < to && from < *end }
        };
        self.columns.iter().filter(inside).map(|column| column.2).max().unwrap_or(Half::ZERO)
    }

    /// Cuts a pass: what lies on its path outwards (or before it) is gone. Tells its length in metal and largest depth.
    fn cut(&mut self, pass: &Pass) -> (Half, Half) {
        let (mut length, mut depth) = (Half::ZERO, Half::ZERO);
        match pass.kind {
            PassDirection::Longitudinal => {
                for column in &mut self.columns {
                    if column.0 >= pass.from.z && column.1 <= pass.to.z && column.2 > pass.to.radius {
                        length = length + (column.1 - column.0);
                        depth = depth.max(column.2 - pass.to.radius);
                        column.2 = pass.to.radius;
                    }
                }
            }
            PassDirection::Transverse => {
                let mut thick = Half::ZERO;
                for column in &mut self.columns {
                    if column.1 <= pass.to.z && column.2 > pass.to.radius {
                        length = length.max(column.2 - pass.to.radius);
                        thick = thick + (column.1 - column.0);
                        column.2 = pass.to.radius;
                    }
                }
                depth = thick;
            }
        }
        (length, depth)
    }
}

/// Carries passes out on the stock: each takes what it says, none too much at once, none below the contour, no rapid goes
/// through metal, and in the end nothing is left.
fn carry_out(grid: &Grid, passes: &[Pass], rates: &Rates) {
    let mut stock = Stock::of(grid, passes);
    let mut before = None;
    let rapid = |stock: &Stock, (a, b): (Point, Point)| {
        let metal = stock.over(a.z, b.z);
        let low = a.radius.min(b.radius);
        assert!(low >= metal || a.z.max(b.z) <= Half::ZERO, "rapid {a:?} {b:?} below {metal}");
    };
    for pass in passes {
        legs(before, Some(pass.start()), grid.bar, rates).for_each(|leg| rapid(&stock, leg));
        let (length, depth) = stock.cut(pass);
        assert_eq!((length, depth), (pass.length(), pass.depth), "{pass:?}");
        let most =
            if pass.kind == PassDirection::Longitudinal { grid.longitudinal_depth } else { grid.transverse_depth };
        assert!(depth <= most && depth > Half::ZERO && length > Half::ZERO, "{pass:?}");
        for (column, part) in stock.columns.iter().zip(&stock.part) {
            assert!(column.2 >= part.2, "below the contour: {pass:?}");
        }
        before = Some(pass.end());
    }
    if before.is_some() {
        legs(before, None, grid.bar, rates).for_each(|leg| rapid(&stock, leg));
    }
    assert_eq!(stock.columns, stock.part, "stock is left");
}

/// The least cost of rich moves by trying every cut of every staircase, each staircase once.
fn by_recursion(
    lines: &Lines,
    stairs: &Stairs,
    objective: Objective,
    known: &mut std::collections::BTreeMap<Stairs, u64>,
) -> u64 {
    if let Some(cost) = known.get(stairs) {
        return *cost;
    }
    let mut cuts = Vec::new();
    lines.cuts(stairs, &mut cuts);
    let best = cuts.into_iter().map(|cut| {
        let mut next = stairs.clone();
        lines.cut(&mut next, cut);
        cut.cost(objective) + by_recursion(lines, &next, objective, known)
    });
    let cost = best.min().unwrap_or(0);
    assert!(lines.at_least(stairs, objective) <= cost, "the bound is none");
    known.insert(stairs.clone(), cost);
    cost
}

/// No sequence on the grid is below 89 mm: not with rich moves either.
#[test]
#[ignore = "takes long: a whole proof"]
fn the_optimum_of_the_paper_s_shaft_stays_with_rich_moves() {
    let grid = Grid::of(&example("shaft"));
    let (better, proof) = rich::find(&grid, Objective::Path, 2 * 89_000, 4_000_000);
    assert!(better.is_none() && proof.optimal_on_the_grid && proof.lower_bound == 89.0, "{proof:?}");
}

#[test]
fn rich_moves_shorten_the_six_steps_and_the_bound_is_close() {
    let shaft = example("shaft-six-steps");
    let grid = Grid::of(&shaft);
    let basic = CostToGo::of(&grid, Objective::Path).optimum().main;
    let (better, proof) = rich::find(&grid, Objective::Path, basic, 200_000);
    let passes = better.unwrap();
    carry_out(&grid, &passes, &rates());
    let cost = total(&passes, Objective::Path, grid.bar).main;
    assert!(cost < basic && proof.lower_bound <= cost as f64 / 2000.0, "{cost} {proof:?}");
    assert!(proof.lower_bound * 1.05 > cost as f64 / 2000.0, "{cost} {proof:?}");
}

#[test]
fn rich_moves_are_asked_for_by_the_file_or_the_flag_and_not_for_time() {
    let small = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rich.yaml");
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/shaft.yaml")).unwrap();
    fs::write(&small, text.replace("transverse_depth: 3.5", "transverse_depth: 9, moves: rich")).unwrap();
    let small = small.to_str().unwrap();
    let answer = json(&[small]);
    assert_eq!(json(&[small, "--moves", "basic"])["moves"], "basic");
    assert_eq!(answer["moves"], "rich");
    assert!(answer["proof"]["lower_bound"].as_f64().unwrap() <= path(&answer, "optimal"));
    assert!(json(&["examples/shaft.yaml"])["proof"].is_null());
    let output = run(&["examples/shaft-six-steps.yaml", "--moves", "rich", "--objective", "time", "--lang", "en"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("rich-has-no-time"), "{stderr}");
}

proptest! {
    // The exact answer of these is looked for in every way there is, which takes its time.
    #![proptest_config(technolog_laws::cases!(60))]

    #[test]
    fn rich_moves_are_exact_on_small_grids(shaft in shafts(7), per_pass in 0_i64..4_000) {
        let grid = Grid::of(&shaft);
        let lines = Lines::of(&grid);
        for objective in objectives(Half::new(per_pass), rates()) {
            if matches!(objective, Objective::Time { .. }) {
                continue;
            }
            let exact = by_recursion(&lines, &lines.bar(), objective, &mut std::collections::BTreeMap::new());
            let basic = CostToGo::of(&grid, objective).optimum().main;
            prop_assert!(exact <= basic);
            let (better, proof) = rich::find(&grid, objective, basic, 1_000_000);
            let passes = better.unwrap_or_else(|| CostToGo::of(&grid, objective).passes());
            prop_assert_eq!(total(&passes, objective, grid.bar).main, exact);
            prop_assert!(proof.optimal_on_the_grid, "{proof:?}");
            carry_out(&grid, &passes, &rates());
            let per_step = total(&per_step(&grid, objective), objective, grid.bar).main;
            prop_assert!(exact <= per_step);
        }
    }

    #[test]
    fn a_search_that_is_stopped_tells_a_true_bound(shaft in shafts(7), effort in 1_usize..400) {
        let grid = Grid::of(&shaft);
        let lines = Lines::of(&grid);
        let exact = by_recursion(&lines, &lines.bar(), Objective::Path, &mut std::collections::BTreeMap::new());
        let basic = CostToGo::of(&grid, Objective::Path).optimum().main;
        let (better, proof) = rich::find(&grid, Objective::Path, basic, effort);
        let cost = better.map_or(basic, |passes| total(&passes, Objective::Path, grid.bar).main);
        prop_assert!(proof.lower_bound <= exact as f64 / 2000.0 && exact <= cost, "{proof:?} {exact} {cost}");
        prop_assert_eq!(proof.optimal_on_the_grid, proof.lower_bound >= cost as f64 / 2000.0);
    }

}

proptest! {
    #![proptest_config(technolog_laws::cases!(200))]

    #[test]
    fn no_shaft_file_makes_the_reader_panic_and_none_is_refused_without_a_word(
        from in 0_usize..400, long in 0_usize..12, put in "[-0-9.,:{}\\[\\] a-zа-я\n\"']{0,6}"
    ) {
        let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/shaft.yaml")).unwrap();
        let letters: Vec<char> = text.lines().filter(|line| !line.starts_with('#')).collect::<Vec<_>>().join("\n").chars().collect();
        let from = from.min(letters.len());
        let rest = letters.iter().skip(from + long);
        let spoilt: String = letters.iter().take(from).copied().chain(put.chars()).chain(rest.copied()).collect();
        match read_turned("shaft", &spoilt, &KNOWLEDGE) {
            Err(mistakes) => prop_assert!(!mistakes.is_empty(), "{spoilt}"),
            Ok(read) => {
                let found = find(&read.shaft.unwrap(), Objective::Path, &KNOWLEDGE).unwrap();
                prop_assert_eq!(found.variants.len(), 4);
            }
        }
    }

    #[test]
    fn the_optimum_is_that_of_the_enumeration_and_of_petgraph(shaft in shafts(12), per_pass in 0_i64..20_000) {
        let grid = Grid::of(&shaft);
        prop_assert_eq!(((grid.levels.len() + 1) * (grid.slices.len() + 1)) as u64, states(&shaft));
        for objective in objectives(Half::new(per_pass), rates()) {
            let found = CostToGo::of(&grid, objective);
            let (best, _) = enumerate(&grid, objective);
            prop_assert_eq!(Some(found.optimum()), best);
            let passes = found.passes();
            prop_assert_eq!(total(&passes, objective, grid.bar), found.optimum());
        }
        let cost = |objective| CostToGo::of(&grid, objective).optimum().main;
        prop_assert_eq!(cost(Objective::Path), by_petgraph(&grid, 0));
        let added = Half::new(per_pass);
        prop_assert_eq!(cost(Objective::PathAndPasses { per_pass_mm: added }), by_petgraph(&grid, added.halves() as u64));
    }

    #[test]
    fn every_sequence_clears_the_stock_and_nothing_more(shaft in shafts(40)) {
        let grid = Grid::of(&shaft);
        for objective in objectives(Half::new(2_000), rates()) {
            carry_out(&grid, &CostToGo::of(&grid, objective).passes(), &rates());
        }
        for (_, passes) in named(&grid, Objective::Path) {
            carry_out(&grid, &passes, &rates());
        }
    }

    #[test]
    fn the_optimum_is_never_worse_than_a_named_variant(shaft in shafts(40)) {
        let grid = Grid::of(&shaft);
        for objective in objectives(Half::new(2_000), rates()) {
            let found = find(&shaft, objective, &KNOWLEDGE).unwrap();
            let best = total(&found.variants[3].drawn, objective, grid.bar);
            for variant in &found.variants {
                prop_assert!(best <= total(&variant.drawn, objective, grid.bar), "{}", variant.name);
            }
        }
    }

    #[test]
    fn one_direction_per_step_is_the_best_of_all_combinations(shaft in shafts(12)) {
        let grid = Grid::of(&shaft);
        for objective in objectives(Half::new(2_000), rates()) {
            let own = total(&per_step(&grid, objective), objective, grid.bar);
            let best: Option<Cost> = shafts::combinations(&grid).iter().map(|all| total(all, objective, grid.bar)).min();
            prop_assert_eq!(Some(own), best);
        }
    }
}
