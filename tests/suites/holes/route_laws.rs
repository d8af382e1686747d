//! Laws of the routes, tried on random holes.
//!
//! - At least 95 % of random solid holes Ø3-30, IT 9-14, up to 5 diameters deep, get a complete route on the
//!   ГФ2171 without an error; each of the others has a finding that says what is missing.
//! - A hole with any of the features of the part format has a lawful plan: tools of the catalogs, no limit of
//!   the machine exceeded, every transition opens the hole further, from a
//!   diameter that an earlier one left.
//! - The allowances lie inside section 1.2.1.
//! - The ranking is a total order: it does not depend on the order of the groups nor of the keys of a file.

use std::collections::BTreeMap;

use proptest::prelude::*;
use technolog::machine::Machine;
use technolog::note::Severity;
use technolog::part::Hole;
use technolog::plan::{Alternative, AlternativeStep, CuttingMethod, Feature, HolePlan, Operation, Plan, Transition};
use technolog::units::Micrometres;
use technolog_laws::{count, seed_of};
use technolog_testing::lawful::{lawful, sound};
use technolog_testing::{KNOWLEDGE, holes, planned, read};

/// The same numbers in every run (a linear congruence; its high bits are even enough here).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }

    fn pick<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.below(from.len() as u64) as usize]
    }
}

/// A plain hole of the share that the issue speaks of: its keys and the thickness of a blank that bears it.
fn plain_hole(random: &mut Random) -> (String, Micrometres) {
    // Whole, half and tenth millimetres alike.
    let step = [1000, 500, 100][random.below(3) as usize];
    let diameter = Micrometres::new(((3_000 + random.below(27_001) as i64) / step * step).max(3_000));
    let grade = 9 + random.below(6);
    // A grade goes with a surface that a drawing would ask with it: table A.3's own and coarser.
    let roughness = match grade {
        9 => ["Ra 2.5", "Rz 20", "Ra 3.2"],
        10 => ["Ra 2.5", "Rz 20", "Ra 6.3"],
        11 => ["Rz 20", "Rz 40", "Ra 6.3"],
        _ => ["Rz 40", "Rz 80", "Ra 12.5"],
    };
    let roughness = random.pick(&roughness);
    let centre = random.pick(&["0.1", "0.2", "0.3", "0.46", "1"]);
    // In whole millimetres, at least half a diameter.
    let deep = Micrometres::from_mm((diameter.to_mm() * (0.5 + 4.5 * random.below(1001) as f64 / 1000.0)) as i64);
    let deep = deep.max(Micrometres::from_mm(2));
    let through = random.below(2) == 0;
    let (depth, thickness) = if through {
        ("through: true".to_owned(), deep)
    } else {
        (format!("depth: {deep}"), deep + diameter + Micrometres::from_mm(5))
    };
    (format!("diameter: {diameter}H{grade}, {depth}, roughness: {roughness}, centre_tolerance: {centre}"), thickness)
}

/// Holes tried, and how many of them must have a route.
const TRIED: usize = 160;
const ENOUGH: f64 = 0.95;

#[test]
fn nearly_every_plain_hole_has_a_route() {
    let tried = count(TRIED);
    let mut random = Random(seed_of("plain holes"));
    let mut missing: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for _ in 0..tried {
        let (keys, thickness) = plain_hole(&mut random);
        let plan = technolog_testing::plan_of_hole(
            "steel-45",
            "gf2171",
            &thickness.to_string(),
            &format!("{keys}, at: [[0, 0]]"),
        );
        let errors: Vec<&str> = plan
            .findings
            .iter()
            .filter(|finding| finding.severity == Severity::Error)
            .map(|finding| finding.note.code())
            .collect();
        let route = plan.holes[0].route.as_ref();
        if route.is_some_and(|route| !route.finish_elsewhere) && errors.is_empty() {
            lawful(&plan.part, &plan).unwrap_or_else(|error| panic!("{error}\n{keys}"));
            within_allowances(&plan.holes[0]).unwrap_or_else(|error| panic!("{error}\n{keys}"));
            ranked(&plan).unwrap_or_else(|error| panic!("{error}\n{keys}"));
            for other in route.iter().flat_map(|route| &route.alternatives) {
                alternative_within_allowances(&other.operations).unwrap_or_else(|error| panic!("{error}\n{keys}"));
            }
            continue;
        }
        assert!(!errors.is_empty(), "{keys} is not made here, and nobody says why: {:?}", plan.findings);
        missing.entry(errors.join(" ")).or_default().push(keys);
    }
    let number: usize = missing.values().map(Vec::len).sum();
    assert!(number as f64 <= (1.0 - ENOUGH) * tried as f64, "{number} of {tried}: {missing:#?}");
    println!("{number} of {tried}: {missing:#?}");
}

#[test]
fn a_hole_without_a_route_says_what_is_missing() {
    let mut random = Random(seed_of("fine surfaces"));
    let (mut planned, mut refused) = (0, 0);
    for _ in 0..count(80) {
        let (keys, thickness) = plain_hole(&mut random);
        let (size, _) = keys.split_once(", roughness").unwrap();
        // Surfaces and positions that nobody promises for the grade.
        let roughness = random.pick(&["Ra 2.5", "Ra 1.25", "Ra 0.63", "Ra 0.32"]);
        let centre = random.pick(&["0.02", "0.05", "0.2"]);
        let keys = format!("{size}, roughness: {roughness}, centre_tolerance: {centre}, at: [[0, 0]]");
        let plan = technolog_testing::plan_of_hole("steel-45", "gf2171", &thickness.to_string(), &keys);
        let Some(route) = &plan.holes[0].route else {
            assert!(plan.has_errors_of("A"), "{keys}");
            refused += 1;
            continue;
        };
        // A route that does not hold what is asked, or ends on another machine, is told of.
        let has_finding = |code: &str| plan.findings.iter().any(|finding| finding.note.code().starts_with(code));
        let told = has_finding("misses-") || has_finding("proof-grade") || has_finding("proof-surface");
        assert!(route.meets || told || has_finding("proof-position"), "{keys}: {:?}", plan.findings);
        let left = has_finding("finish-elsewhere") || has_finding("finer-than-this-machine");
        assert!(!route.finish_elsewhere || left, "{keys}: {:?}", plan.findings);
        planned += 1;
    }
    assert!(planned > 0 && refused > 0, "{planned} planned, {refused} refused");
}

/// The allowances on diameter, mm: of section 1.2.1 by my own reading of the text; of reamers by that of the pages on
/// stock before reaming, the widest of all diameters: 0.04 to 0.25 after another reamer, 0.1 to 1 of one alone, 0.1 to 0.5
/// of a rough one.
fn range(operation: Operation, before: Option<Operation>) -> Option<(f64, f64)> {
    Some(match operation {
        Operation::FinishReam if before == Some(Operation::RoughReam) => (0.04, 0.25),
        Operation::FinishReam => (0.1, 1.0),
        Operation::RoughReam => (0.1, 0.5),
        Operation::FinishBore => (0.2, 0.3),
        Operation::SemiFinishBore => (0.5, 1.0),
        Operation::RoughBore => (2.0, 3.0),
        _ => return None,
    })
}

/// The stock of every transition of the main cylinder inside its range, a pass at a time.
fn within_allowances(hole: &HolePlan) -> Result<(), TestCaseError> {
    let mut before = None;
    for step in hole.transitions.iter().filter(|step| step.feature == Feature::Bore) {
        let previous = before.replace(step.operation);
        let stock = (step.diameter_mm - step.from_diameter_mm).to_mm() / f64::from(step.passes);
        if let Some((low, high)) = range(step.operation, previous) {
            let inside = stock >= low - 1e-9 && stock <= high + 1e-9;
            prop_assert!(inside, "{:?} takes {stock}, not {low}-{high}: {step:?}", step.operation);
        }
        if step.operation == Operation::CoreDrill {
            // An eighth of the hole's diameter; the core drill before reaming stands for the hole.
            let last = hole.transitions.iter().rev().find(|step| step.feature == Feature::Bore);
            let most = last.map_or(0.0, |last| last.diameter_mm.to_mm()) / 8.0;
            prop_assert!(stock <= most + 1e-3, "core drilling takes {stock}, more than {most}: {step:?}");
        }
    }
    Ok(())
}

/// The stocks of a route that was not taken: of its diameters, with as many passes of rough boring as fit.
fn alternative_within_allowances(operations: &[AlternativeStep]) -> Result<(), TestCaseError> {
    for pair in operations.windows(2) {
        let [
            AlternativeStep { diameter_mm: from, operation: before, .. },
            AlternativeStep { diameter_mm: to, operation, .. },
        ] = pair
        else {
            continue;
        };
        let opened = !matches!(
            before,
            Operation::CentreDrill | Operation::Counterbore | Operation::Countersink | Operation::Chamfer
        );
        let Some((low, high)) = range(*operation, Some(*before)).filter(|_| opened) else { continue };
        let stock = (*to - *from).to_mm();
        let most = if *operation == Operation::RoughBore { 30 } else { 1 };
        let inside = (1..=most).any(|passes| {
            let stock = stock / f64::from(passes);
            stock >= low - 1e-9 && stock <= high + 1e-9
        });
        prop_assert!(inside, "{operation:?} takes {stock}, not {low}-{high}: {operations:?}");
    }
    Ok(())
}

/// Every transition of a cylinder opens it further, and none is deeper than the blank or goes nowhere.
fn grows(plan: &Plan) -> Result<(), TestCaseError> {
    for hole in &plan.holes {
        let mut widest: BTreeMap<(Feature, Option<usize>), Micrometres> = BTreeMap::new();
        for step in hole.transitions.iter().filter(|step| {
            matches!(step.feature, Feature::Bore | Feature::Step | Feature::Counterbore)
                && step.operation != Operation::CentreDrill
        }) {
            let before = widest.entry((step.feature, step.step)).or_default();
            // A flat floor is milled at the diameter that the drill left.
            let floor =
                step.operation == Operation::Mill && step.start_mm > Micrometres::ZERO && step.diameter_mm == *before;
            prop_assert!(floor || step.diameter_mm > *before, "{} does not grow: {:?}", hole.name, hole.transitions);
            *before = step.diameter_mm;
        }
    }
    Ok(())
}

/// Whether something that stands before time in the order of routes decided against it.
fn stands_back(other: &Alternative) -> bool {
    let code = other.why.code();
    code.starts_with("proof-") || code == "lost-by-floor"
}

/// The stated order of routes: one that meets what is asked goes before one that does not, then time decides; only where another
/// hole borrows a drill of the route may that go before time, and then the plan says so.
fn ranked(plan: &Plan) -> Result<(), TestCaseError> {
    for hole in &plan.holes {
        let Some(route) = &hole.route else { continue };
        let timed: Vec<_> =
            route.alternatives.iter().filter_map(|other| Some((other.meets, other.time_min?.0, other))).collect();
        let borrowed =
            timed.iter().any(|(.., other)| matches!(other.why.code(), "lost-by-borrowing" | "lost-by-two-passes"));
        for (meets, time, other) in &timed {
            prop_assert!(route.meets || !meets, "{}: {other:?} meets, {} does not", hole.name, route.scheme);
            // What holds a requirement only at best, and what leaves more over a flat floor, stands back whatever it takes.
            let at_best = stands_back(other);
            let slower = route.time_min.0 <= time + 1.5e-3 || (route.meets && !meets) || at_best;
            prop_assert!(slower || borrowed, "{}: {other:?} is quicker than {}", hole.name, route.time_min.0);
        }
        let known = timed.len();
        prop_assert!(
            route.alternatives[..known].iter().all(|other| other.time_min.is_some()),
            "{}: what can be carried out comes first",
            hole.name
        );
        if !borrowed {
            let ordinary = timed.iter().filter(|(.., other)| !stands_back(other));
            let keys: Vec<(bool, f64)> = ordinary.map(|(meets, time, _)| (!meets, *time)).collect();
            prop_assert!(
                keys.windows(2)
                    .all(|pair| pair[0].0 <= pair[1].0 && (pair[0].0 != pair[1].0 || pair[0].1 <= pair[1].1 + 1.5e-3)),
                "{}: {keys:?}",
                hole.name
            );
        }
        if let Some(margin) = route.margin_min {
            let runner_up = route.runner_up().and_then(|other| other.time_min).map_or(0.0, |time| time.0);
            prop_assert!((runner_up - route.time_min.0 - margin.0).abs() < 2e-3, "{}: margin {margin:?}", hole.name);
        }
    }
    Ok(())
}

/// What a plan decides of each group, whatever its number.
fn decided(plan: &Plan) -> BTreeMap<&str, String> {
    let of = |hole: &HolePlan| {
        let steps: Vec<_> = hole
            .transitions
            .iter()
            .map(|step| {
                let (tool, holder) = (&step.tool.designation, &step.holder.designation);
                (
                    step.operation,
                    step.feature,
                    step.step,
                    step.from_diameter_mm,
                    step.diameter_mm,
                    tool,
                    holder,
                    &step.conditions,
                )
            })
            .collect();
        let route = hole.route.as_ref().map(|route| {
            (route.source, &route.scheme, route.meets, route.time_min, route.margin_min, &route.alternatives)
        });
        format!("{route:#?}\n{steps:#?}")
    };
    plan.holes.iter().map(|hole| (hole.name.as_str(), of(hole))).collect()
}

/// The entries of a list or mapping in braces, split at its own commas.
fn entries(inside: &str) -> Vec<&str> {
    let (mut depth, mut start, mut found) = (0, 0, Vec::new());
    for (at, character) in inside.char_indices() {
        match character {
            '{' | '[' => depth += 1,
            '}' | ']' => depth -= 1,
            ',' if depth == 0 => {
                found.push(inside[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    found.push(inside[start..].trim());
    found
}

/// The same part with its groups in another order, the keys of each the other way round.
fn rearranged(text: &str, order: &[prop::sample::Index]) -> String {
    let (head, groups) = text.split_once("holes:\n").unwrap();
    let mut groups: Vec<String> = groups
        .lines()
        .map(|line| {
            let inside = line.trim().strip_prefix("- {").and_then(|line| line.strip_suffix('}')).unwrap();
            let mut keys = entries(inside);
            keys.reverse();
            format!("  - {{{}}}\n", keys.join(", "))
        })
        .collect();
    for (at, index) in order.iter().enumerate().take(groups.len()) {
        let other = index.index(groups.len());
        groups.swap(at, other);
    }
    format!("{head}holes:\n{}", groups.concat())
}

/// Every transition cuts from a diameter that is there: one that an earlier transition left, or the blank's.
fn there_before(hole: &Hole, plan: &HolePlan) -> Result<(), TestCaseError> {
    let cylinder = |step: &&Transition| {
        matches!(step.feature, Feature::Bore | Feature::Step | Feature::Counterbore | Feature::Thread)
            && step.operation != Operation::CentreDrill
    };
    for (at, step) in plan.transitions.iter().enumerate().filter(|(_, step)| cylinder(step)) {
        let from = step.from_diameter_mm;
        let made = plan.transitions[..at].iter().filter(cylinder).any(|earlier| {
            let here = earlier.feature == Feature::Bore || earlier.face == step.face;
            here && (earlier.diameter_mm == from || earlier.also_diameter_mm == Some(from))
        });
        let there = made || from == Micrometres::ZERO || hole.state.diameter() == Some(from);
        prop_assert!(there, "{} {:?} {}: nothing left {from}", hole.name, step.operation, step.diameter_mm);
    }
    Ok(())
}

proptest! {
    #![proptest_config(technolog_laws::cases!(8))]

    #[test]
    fn the_ranking_does_not_depend_on_the_order_of_a_file(
        text in prop_oneof![holes::part_files(), plain_parts()],
        order in prop::collection::vec(any::<prop::sample::Index>(), 12),
    ) {
        let plan = planned(&read(&text), CuttingMethod::Formula);
        ranked(&plan).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        let other_text = rearranged(&text, &order);
        let other = planned(&read(&other_text), CuttingMethod::Formula);
        for ((name, one), (_, other)) in decided(&plan).iter().zip(decided(&other)) {
            let apart = one.lines().zip(other.lines()).find(|(one, other)| one != other);
            prop_assert!(*one == other, "{name}: {apart:?}\n{text}\n{other_text}");
        }
        let tools = |plan: &Plan| {
            let mut tools: Vec<_> = plan.tools.iter().map(|tool| (tool.designation.clone(), tool.holder.clone(), tool.diameter_mm)).collect();
            tools.sort();
            tools
        };
        prop_assert_eq!(tools(&plan), tools(&other));
        let findings = |plan: &Plan| plan.findings.iter().map(|finding| format!("{finding:?}")).collect::<Vec<_>>();
        prop_assert_eq!(findings(&plan), findings(&other), "{}", text);
    }
}

/// Parts of several groups of plain holes that share tools or compete for the magazine.
fn plain_parts() -> impl Strategy<Value = String> {
    (any::<u64>(), 3_usize..=10).prop_map(|(seed, groups)| {
        let mut random = Random(seed);
        let lines = (0..groups).map(|group| {
            let diameter = 3 + random.below(38);
            let grade = [7, 9, 11, 12, 13][random.below(5) as usize];
            let roughness = if grade < 10 { "Ra 2.5" } else { "Rz 40" };
            let centre = random.pick(&["0.08", "0.2", "0.46"]);
            let (x, y) = (100 * (group as i64 % 5) - 200, 120 * (group as i64 / 5) - 60);
            format!(
                "  - {{name: H{group}, diameter: {diameter}H{grade}, through: true, roughness: {roughness}, \
                 centre_tolerance: {centre}, at: [[{x}, {y}]]}}\n"
            )
        });
        let lines: String = lines.collect();
        format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\n\
             blank: {{kind: plate, length: 600, width: 300, thickness: 20}}\nholes:\n{lines}"
        )
    })
}

/// Whatever its features.
fn has_a_lawful_plan(text: &str) -> Result<(), TestCaseError> {
    let part = read(text);
    let plan = planned(&part, CuttingMethod::Formula);
    let machine = Machine::find(&KNOWLEDGE, &part.machine).unwrap();
    for (hole, own) in part.holes.iter().zip(&plan.holes) {
        if own.route.is_none() {
            let is_reported = plan.findings.iter().any(|finding| {
                finding.severity == Severity::Error && finding.hole.as_deref() == Some(hole.name.as_str())
            });
            prop_assert!(is_reported, "{} is not planned, and nobody says why\n{text}", hole.name);
            prop_assert!(own.transitions.is_empty());
            continue;
        }
        for step in own.transitions.iter().filter(|step| !step.elsewhere) {
            sound(step, &plan, &machine).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        }
        within_allowances(own).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        there_before(hole, own).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
    }
    grows(&plan).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
    for tool in &plan.tools {
        prop_assert!(tool.length_mm <= machine.overhang_max, "{tool:?}");
        prop_assert!(tool.mass_kg.is_none_or(|mass| mass <= machine.tool_mass_max_kg), "{tool:?}");
    }
    Ok(())
}

#[test]
fn what_laws_found_has_lawful_plans() {
    for (name, text) in technolog_testing::found() {
        has_a_lawful_plan(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(20))]

    #[test]
    fn holes_with_any_features_have_lawful_plans(text in holes::part_files()) {
        has_a_lawful_plan(&text)?;
    }
}
