//! Programs without a plan (tests/audit-alone): honest ones of other hands and all of ours are not blamed, and planted slips are found.

use std::path::Path;

use serde::Deserialize;
use technolog::audit::{Audit, ProgramAlone, read_table};
use technolog::note::Severity;
use technolog::part::Part;
use technolog::plan::CuttingMethod;
use technolog::program::proof::PlannedJob;
use technolog::program::written::Form;
use technolog::shop::Shop;
use technolog::{planner, sheets};
use technolog_testing::{AUDITOR, KNOWLEDGE, languages, read};

fn text(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/audit-alone").join(name)).unwrap()
}

fn audited(program: &str, text: &str, control: &str, part: Option<&Part>) -> Audit {
    let alone = ProgramAlone { file: program, text, control, setting: None, part, tools: None };
    AUDITOR.audit(&alone.read(&KNOWLEDGE).unwrap().unwrap()).unwrap()
}

fn form(part: &Part) -> Form {
    Form::read(&Shop::new(part, CuttingMethod::default(), &KNOWLEDGE).unwrap()).unwrap()
}

fn grave(audit: &Audit) -> Vec<String> {
    let grave = audit.findings.iter().filter(|finding| finding.is_wrong());
    grave.map(|one| format!("{:?} {} {}", one.severity, one.rule, one.field)).collect()
}

/// Programs of many hands: other zeros, words, cycles, written out, without comments.
const HONEST: [(&str, &str, &str); 11] = [
    ("plate-corner-zero.nc", "fanuc", "plate.yaml"),
    ("plate-words-in-ukrainian.ngc", "linuxcnc", "plate.yaml"),
    ("bracket-reamed-and-tapped.nc", "fanuc", "bracket.yaml"),
    ("cover-list-at-the-head.nc", "haas-ngc", "cover.yaml"),
    ("cover-zero-on-the-table.ngc", "linuxcnc", "cover.yaml"),
    ("bearing-no-comments.nc", "linuxcnc", "bearing.yaml"),
    ("bearing-haas.nc", "haas-ngc", "bearing.yaml"),
    ("bearing-grbl.gcode", "grbl", "bearing.yaml"),
    ("cover-mach3.tap", "mach3", "cover.yaml"),
    ("plate-no-comments.nc", "fanuc", "plate.yaml"),
    ("strip-2c42.nc", "2c42-65", "strip.yaml"),
];

#[test]
fn no_honest_program_of_another_hand_is_blamed() {
    for (program, control, part) in HONEST {
        let part = read(&text(part));
        for part in [Some(&part), None] {
            let audit = audited(program, &text(program), control, part);
            assert!(grave(&audit).is_empty(), "{program} with part {}: {:?}", part.is_some(), grave(&audit));
        }
    }
}

/// A part read, and what is judged of it is not silently nothing.
#[test]
fn every_known_cut_is_a_row() {
    for (program, control, part) in HONEST {
        let part = read(&text(part));
        let text = text(program);
        let alone = ProgramAlone { file: program, text: &text, control, setting: None, part: Some(&part), tools: None };
        let stated = alone.read(&KNOWLEDGE).unwrap().unwrap();
        for hole in &part.holes {
            assert!(stated.rows_of_hole(&hole.name).count() >= 2, "{program} {}", hole.name);
        }
    }
}

#[test]
fn no_program_of_ours_is_blamed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut parts = vec![root.join("examples/plate.yaml"), root.join("examples/variant-2.yaml")];
    parts.push(root.join("examples/variant-4.yaml"));
    parts.extend((1..=10).map(|number| root.join(format!("examples/hand-plans/{number}.yaml"))));
    let mut blamed = Vec::new();
    for path in parts {
        let part = read(&std::fs::read_to_string(&path).unwrap());
        let plan = planner::plan(&part, CuttingMethod::default(), &KNOWLEDGE).unwrap();
        for (control, language) in languages() {
            let planned = PlannedJob::of(plan.clone(), &language, &KNOWLEDGE).unwrap();
            let text = language.write(&planned.job, form(&part)).text();
            let audit = audited("program.nc", &text, control, Some(&part));
            if !grave(&audit).is_empty() {
                blamed.push(format!("{} {control}: {:?}", path.display(), grave(&audit)));
            }
        }
    }
    assert!(blamed.is_empty(), "{}", blamed.join("\n"));
}

/// A slip in a program.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Slip {
    name: String,
    program: String,
    control: String,
    part: String,
    #[serde(default)]
    from: String,
    #[serde(default)]
    to: String,
    #[serde(default)]
    all: bool,
    /// The lines from the one that has the first to the one before that which has the second.
    #[serde(default)]
    cut: Vec<String>,
    finds: String,
}

impl Slip {
    fn made(&self) -> String {
        let text = text(&self.program);
        if let [from, to] = self.cut.as_slice() {
            let lines: Vec<&str> = text.lines().collect();
            let at = |what: &str| lines.iter().position(|line| line.contains(what)).unwrap();
            return [&lines[..at(from)], &lines[at(to)..]].concat().join("\n");
        }
        let count = text.matches(&self.from).count();
        assert!(count == 1 || self.all && count > 1, "{}: {count} of `{}`", self.name, self.from);
        text.replace(&self.from, &self.to)
    }
}

#[test]
fn planted_slips_of_programs_are_found() {
    let slips: Vec<Slip> = serde_yaml::from_str(&text("slips.yaml")).unwrap();
    let mut missed = Vec::new();
    for slip in &slips {
        let audit = audited(&slip.program, &slip.made(), &slip.control, Some(&read(&text(&slip.part))));
        let found: Vec<String> = audit
            .findings
            .iter()
            .filter(|one| one.severity <= Severity::Doubtful)
            .map(|one| format!("{} {}", format!("{:?}", one.severity).to_lowercase(), one.rule))
            .collect();
        if !found.contains(&slip.finds) {
            missed.push(format!("{}: {found:?} without {}", slip.name, slip.finds));
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

/// What stands in the registers nobody says, and a list has the size that is made: a spot is no tool. The register of another tool is
/// told where it is called.
#[test]
fn a_list_beside_a_program_of_ours_blames_nothing() {
    let part =
        read(&std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/plate.yaml")).unwrap());
    let plan = planner::plan(&part, CuttingMethod::default(), &KNOWLEDGE).unwrap();
    let (control, language) = languages().into_iter().next().unwrap();
    let planned = PlannedJob::of(plan, &language, &KNOWLEDGE).unwrap();
    let program = language.write(&planned.job, form(&part)).text();
    let list = "Отвір;Перехід;Діаметр, мм;№ інструмента;Інструмент;Оправка\nA;центрування;6;T1;035-2317-0103;191113040\n\
                A;свердління;10;T2;035-2300-1273;191113040\nB;свердління;10;T2;035-2300-1273;191113040\n\
                B;розсвердлювання;20;T3;035-2301-1060;191831062\n";
    let tables = sheets::read(sheets::Kind::Csv, list.as_bytes()).unwrap();
    let none = |_: &str| Err(String::new());
    let tools = read_table("tools.csv", &tables, Some(&part), &KNOWLEDGE, &none).unwrap();
    let found = |text: &str| {
        let alone =
            ProgramAlone { file: "program.nc", text, control, setting: None, part: Some(&part), tools: Some(&tools) };
        grave(&AUDITOR.audit(&alone.read(&KNOWLEDGE).unwrap().unwrap()).unwrap())
    };
    assert!(found(&program).is_empty(), "{:?}", found(&program));
    let other = program.replacen("Z40 H2", "Z40 H3", 1);
    assert!(other != program && !found(&other).is_empty());
}

/// A control without comments is told its tools by a list.
#[test]
fn a_list_names_the_tools_of_a_program() {
    let list = "№ інструмента;Перехід;Діаметр, мм;Інструмент\n1;центрування;;035-2317-0103\n2;свердління;10;035-2300-1273\n\
                3;розсвердлювання;20;035-2301-1060\n";
    let part = read(&text("plate.yaml"));
    let plan = planner::plan(&part, CuttingMethod::default(), &KNOWLEDGE).unwrap();
    let (control, language) = languages().into_iter().next().unwrap();
    let planned = PlannedJob::of(plan, &language, &KNOWLEDGE).unwrap();
    let program = language.write(&planned.job, form(&part)).text();
    let audit_with = |list: &str| {
        let tables = sheets::read(sheets::Kind::Csv, list.as_bytes()).unwrap();
        let none = |_: &str| Err(String::new());
        let tools = read_table("tools.csv", &tables, Some(&part), &KNOWLEDGE, &none).unwrap();
        let alone = ProgramAlone {
            file: "program.nc",
            text: &program,
            control,
            setting: None,
            part: Some(&part),
            tools: Some(&tools),
        };
        AUDITOR.audit(&alone.read(&KNOWLEDGE).unwrap().unwrap()).unwrap()
    };
    let right = audit_with(list);
    assert!(right.findings.is_empty(), "{:?}", right.findings.iter().map(|one| &one.rule).collect::<Vec<_>>());
    let wrong = audit_with(&list.replace("20;035-2301-1060", "22.5;035-2301-1070"));
    assert!(grave(&wrong).iter().any(|one| one.contains("audit-last-diameter")), "{:?}", grave(&wrong));
}

/// A tool that the list does not have is told where it is called, with what the list has instead of it.
#[test]
fn a_tool_beside_the_list_is_told_where_it_is_called() {
    let list = "№ інструмента;Отвір;Перехід;Діаметр, мм;Інструмент\n1;B;центрування;;035-2317-0103\n2;B;свердління;10;035-2300-1273\n\
                3;B;розсвердлювання;20;035-2301-1060\n";
    let part = read(&text("plate.yaml"));
    let plan = planner::plan(&part, CuttingMethod::default(), &KNOWLEDGE).unwrap();
    let (control, language) = languages().into_iter().next().unwrap();
    let planned = PlannedJob::of(plan, &language, &KNOWLEDGE).unwrap();
    let program = language.write(&planned.job, form(&part)).text();
    let tables = sheets::read(sheets::Kind::Csv, list.as_bytes()).unwrap();
    let tools = read_table("tools.csv", &tables, Some(&part), &KNOWLEDGE, &|_: &str| Err(String::new())).unwrap();
    let found = |text: &str| {
        let alone =
            ProgramAlone { file: "program.nc", text, control, setting: None, part: Some(&part), tools: Some(&tools) };
        let audit = AUDITOR.audit(&alone.read(&KNOWLEDGE).unwrap().unwrap()).unwrap();
        let own = audit.findings.into_iter().filter(|one| one.rule.starts_with("audit-program-unlisted"));
        own.map(|one| (one.line, one.severity, technolog::words::Lang::EN.say(&one.note))).collect::<Vec<_>>()
    };
    assert_eq!(found(&program), []);
    let other = program.replacen("T3 M6", "T7 M6", 1);
    let line = other.lines().position(|line| line.contains("T7 M6")).map(|at| u32::try_from(at + 1).unwrap());
    let note =
        "T7 is called, but the list of tools does not have it; by the list there is then not made: T3 drilling out B";
    assert_eq!(found(&other), [(line, Severity::Wrong, note.to_owned())]);
}

/// Where the zero lies nobody said: a change that is too low is told without a height of the machine.
#[test]
fn a_low_change_names_no_height_that_nobody_set() {
    let low = text("four-tools.nc").replacen("N75 G80\no101 call\n", "N75 G80 M5 M9\n", 1);
    let audit = audited("low.nc", &low, "linuxcnc", Some(&read(&text("four-tools.yaml"))));
    let own: Vec<_> = audit.findings.iter().filter(|one| one.rule == "changes-elsewhere").collect();
    assert_eq!(own.len(), 1);
    assert!(!technolog::words::Lang::EN.say(&own[0].note).contains('Z'), "{:?}", own[0].note);
}

/// One tool that calls another zero than all others makes its holes elsewhere: told at the call.
#[test]
fn another_zero_of_one_tool_is_told_where_it_is_called() {
    let part = read(&text("plate.yaml"));
    let right = text("plate-corner-zero.nc");
    let other = right.replacen("G54 G90 G0 X50. Y50. S800", "G55 G90 G0 X50. Y50. S800", 1);
    let line = other.lines().position(|line| line.starts_with("G55")).map(|at| u32::try_from(at + 1).unwrap());
    let audit = audited("plate.nc", &other, "fanuc", Some(&part));
    let own: Vec<_> =
        audit.findings.iter().filter(|one| one.rule == "not-made" && one.follows_from.is_empty()).collect();
    assert!(!own.is_empty(), "{:?}", grave(&audit));
    for one in own {
        assert_eq!(one.line, line);
        assert!(technolog::words::Lang::EN.say(&one.note).starts_with("T2 works from G55, all other tools from G54"));
    }
}

/// A spindle that is not stopped before M6 is one slip.
#[test]
fn a_missing_stop_of_the_spindle_is_one_slip() {
    let text = text("plate-corner-zero.nc").replace("Z0. M5", "Z0.");
    let audit = audited("plate.nc", &text, "fanuc", Some(&read(&self::text("plate.yaml"))));
    let own: Vec<String> = grave(&audit).into_iter().filter(|one| one.contains("turn")).collect();
    let roots = audit.findings.iter().filter(|one| one.is_wrong() && one.follows_from.is_empty());
    assert_eq!(roots.count(), 1, "{own:?}");
}

/// A program that goes down nowhere where the drawing has a hole is not passed over in silence.
#[test]
fn a_program_of_another_part_is_told() {
    let part = read(&text("bearing.yaml"));
    let audit = audited("plate.nc", &text("plate-corner-zero.nc"), "fanuc", Some(&part));
    assert!(audit.findings.iter().any(|one| one.rule == "audit-program-nowhere" && one.severity == Severity::Doubtful));
}

/// One length without its point keeps the control from counting any; the route that the program states is read and judged all the same, and
/// only the point is missing.
#[test]
fn a_forgotten_point_does_not_take_the_route_away() {
    let (program, part) = (text("plate-corner-zero.nc"), read(&text("plate.yaml")));
    let (from, to) = ("R3. Q15. F160.", "R3. Q15 F160.");
    assert_eq!(program.matches(from).count(), 1);
    let audit = |text: &str| audited("plate-corner-zero.nc", text, "fanuc", Some(&part));
    let (whole, forgotten) = (audit(&program), audit(&program.replace(from, to)));
    let missing = |audit: &Audit| audit.coverage.iter().map(|own| (own.part, own.missing)).collect::<Vec<_>>();
    assert_eq!(missing(&forgotten), missing(&whole));
    assert_eq!(grave(&forgotten).len(), 1, "{:?}", grave(&forgotten));
    assert!(grave(&forgotten).iter().all(|one| one.contains("point-missing")), "{:?}", grave(&forgotten));
}
