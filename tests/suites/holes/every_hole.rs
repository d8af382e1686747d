//! Every kind of hole of the textbook's section 1.1, by hand: tests/holes.
//!
//! A case names the transitions in order as a reader of the source finds them, and what the plan must say.
//! A transition is written as its operation, then in any order what is known of it: the diameter it leaves,
//! what of the hole it makes where that is not the main cylinder (`chamfer`, `counterbore`, `thread`, …),
//! `step:2`, `back` (entered from the back face), `also:15` (the wide diameter of a step drill), `elsewhere`.
//! `a|b` is one or the other, an `*` behind an operation makes it optional. `starts` and `ends` stand for
//! `operations` where the middle is free.

use std::fs;
use std::path::Path;

use serde::Deserialize;
use technolog::note::Severity;
use technolog::part::Face;
use technolog::plan::{CuttingMethod, Feature, HolePlan, Operation, Plan, Transition, Way};
use technolog_testing::{planned, read, routes};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    name: String,
    #[serde(default = "steel")]
    material: String,
    #[serde(default = "gf2171")]
    machine: String,
    #[serde(default = "twenty")]
    thickness: u32,
    /// Keys of the part beside the usual ones.
    #[serde(default)]
    head: String,
    /// Keys of the hole, without its place.
    hole: String,
    #[serde(default)]
    operations: Option<Vec<String>>,
    /// The scheme that the tables give, whether it was taken or another way was quicker.
    #[serde(default)]
    tables: Option<String>,
    #[serde(default)]
    starts: Vec<String>,
    #[serde(default)]
    ends: Vec<String>,
    /// Findings that must be there.
    #[serde(default)]
    findings: Vec<String>,
    /// Whether an error must say that the hole cannot be made; no other case may have one.
    #[serde(default)]
    impossible: bool,
    because: String,
}

fn steel() -> String {
    "steel-45".to_owned()
}

fn gf2171() -> String {
    "gf2171".to_owned()
}

const fn twenty() -> u32 {
    20
}

impl Case {
    fn plan(&self) -> Plan {
        let Self { material, machine, thickness, head, hole, .. } = self;
        let text = format!(
            "part: P\nmaterial: {material}\nmachine: {machine}\n{head}\n\
             blank: {{kind: plate, length: 400, width: 200, thickness: {thickness}}}\nholes:\n  \
             - {{name: A, {hole}, at: [[0, 0]]}}\n"
        );
        planned(&read(&text), CuttingMethod::Formula)
    }
}

/// A transition as a case writes it.
struct Pattern {
    operations: Vec<Operation>,
    optional: bool,
    diameter: Option<f64>,
    feature: Feature,
    step: Option<usize>,
    face: Face,
    also: Option<f64>,
    elsewhere: bool,
}

impl Pattern {
    fn read(written: &str) -> Self {
        let mut words = written.split(' ');
        let operations = words.next().unwrap().split('|').map(|name| Operation::from_name(name).unwrap()).collect();
        let mut own = Self {
            operations,
            optional: false,
            diameter: None,
            feature: Feature::Bore,
            step: None,
            face: Face::Entry,
            also: None,
            elsewhere: false,
        };
        for word in words {
            if let Ok(diameter) = word.parse() {
                own.diameter = Some(diameter);
            } else if let Some(step) = word.strip_prefix("step:") {
                own.step = Some(step.parse().unwrap());
            } else if let Some(also) = word.strip_prefix("also:") {
                own.also = Some(also.parse().unwrap());
            } else {
                match word {
                    "*" => own.optional = true,
                    "back" => own.face = Face::Back,
                    "elsewhere" => own.elsewhere = true,
                    _ => own.feature = serde_yaml::from_str(word).unwrap_or_else(|_| panic!("{word} in {written}")),
                }
            }
        }
        own
    }

    fn fits(&self, step: &Transition) -> bool {
        self.operations.contains(&step.operation)
            && self.diameter.is_none_or(|diameter| diameter == step.diameter_mm.to_mm())
            && self.feature == step.feature
            && self.step == step.step
            && self.face == step.face
            && self.also == step.also_diameter_mm.map(|also| also.to_mm())
            && self.elsewhere == step.elsewhere
    }
}

fn patterns(written: &[String]) -> Vec<Pattern> {
    written.iter().map(|written| Pattern::read(written)).collect()
}

/// Whether the transitions begin with the patterns; with `whole`, whether nothing follows them.
fn begins(steps: &[Transition], patterns: &[Pattern], whole: bool) -> bool {
    let Some((first, rest)) = patterns.split_first() else { return !whole || steps.is_empty() };
    let taken = steps.split_first().is_some_and(|(step, tail)| first.fits(step) && begins(tail, rest, whole));
    taken || (first.optional && begins(steps, rest, whole))
}

fn ends(steps: &[Transition], patterns: &[Pattern]) -> bool {
    (0..=steps.len()).any(|from| begins(&steps[from..], patterns, true))
}

/// What does not fit, empty where all does.
fn against(case: &Case, plan: &Plan) -> Vec<String> {
    let HolePlan { transitions, .. } = &plan.holes[0];
    let mut wrong = Vec::new();
    let whole = case.operations.as_ref().is_none_or(|operations| begins(transitions, &patterns(operations), true));
    if !whole || !begins(transitions, &patterns(&case.starts), false) || !ends(transitions, &patterns(&case.ends)) {
        let shown = |step: &Transition| {
            let Transition { operation, feature, step, face, diameter_mm, also_diameter_mm, elsewhere, .. } = step;
            format!(
                "{} {diameter_mm} {feature:?} {step:?} {face:?} {also_diameter_mm:?}{}",
                operation.name(),
                if *elsewhere { " elsewhere" } else { "" }
            )
        };
        wrong.push(format!("planned {:#?}", transitions.iter().map(shown).collect::<Vec<_>>()));
    }
    let errors: Vec<&str> = plan
        .findings
        .iter()
        .filter(|finding| finding.severity <= Severity::Wrong)
        .map(|finding| finding.note.code.as_str())
        .collect();
    if case.impossible == errors.is_empty() {
        wrong.push(format!("errors {errors:?}"));
    }
    if let Some(scheme) = &case.tables {
        let all = routes(plan);
        if !all
            .iter()
            .any(|found| found.way == Some(Way::Tables) && found.scheme == *scheme && found.why != "ranked-later")
        {
            let there: Vec<_> = all.iter().map(|found| (found.way, &found.scheme, &found.why)).collect();
            wrong.push(format!("no scheme {scheme} of the tables among {there:?}"));
        }
    }
    for code in &case.findings {
        if !plan.findings.iter().any(|finding| finding.note.code == *code) {
            let codes: Vec<_> = plan.findings.iter().map(|finding| &finding.note.code).collect();
            wrong.push(format!("no finding {code} among {codes:?}"));
        }
    }
    wrong
}

#[test]
fn every_kind_of_hole_is_planned_as_the_source_says() {
    let mut counts = Vec::new();
    let mut failed = Vec::new();
    let mut files: Vec<_> = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/holes"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    for file in files {
        let cases: Vec<Case> = serde_yaml::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
        counts.push(cases.len());
        for case in cases {
            let wrong = against(&case, &case.plan());
            if !wrong.is_empty() {
                failed.push(format!("{}: {}\n  {}", case.name, wrong.join("\n  "), case.because));
            }
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
    assert_eq!(counts, [18, 31, 8, 12], "auxiliary elements, main elements, requirements, stepped holes");
}

#[test]
fn a_pattern_of_holes_is_planned_as_the_list_of_its_points() {
    let keys = "diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46";
    // Each pattern with its points worked out by hand, in the order of docs/part-format.md.
    let cases = [
        (
            "grid: {start: [-50, -20], columns: 3, rows: 2, step: [25, 40]}",
            "[-50, -20], [-25, -20], [0, -20], [-50, 20], [-25, 20], [0, 20]",
        ),
        ("line: {start: [-50, 0], count: 4, step: 20, angle: 90}", "[-50, 0], [-50, 20], [-50, 40], [-50, 60]"),
        ("circle: {centre: [10, 0], diameter: 60, count: 4}", "[40, 0], [10, 30], [-20, 0], [10, -30]"),
    ];
    for (pattern, points) in cases {
        let plan =
            |places: &str| technolog_testing::plan_of_hole("steel-45", "gf2171", "20", &format!("{keys}, {places}"));
        let (one, other) = (plan(&format!("pattern: {{{pattern}}}")), plan(&format!("at: [{points}]")));
        assert_eq!(one, other, "{pattern}");
        let stops: usize = one.sequence.iter().map(|visit| visit.stops.len()).sum();
        assert_eq!(stops, 2 * one.holes[0].count, "{pattern}: each point is centred and drilled once");
    }
}
