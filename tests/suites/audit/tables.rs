//! Plans and lists of tools as tables: CSV in the forms of several countries and XLSX, with their places, and the templates that the
//! program writes.

use std::fs;

use serde_yaml::Value;
use technolog::audit::{Audit, Unreadable, by_tables, read_plan, read_table};
use technolog::knowledge::Diagnostic;
use technolog::note::Severity;
use technolog::part::{Part, read_part};
use technolog::plan::CuttingMethod;
use technolog::sheets::{self, Kind, Sheet};
use technolog::words::Lang;
use technolog_testing::{AUDITOR, KNOWLEDGE, planned, root};

use super::honest;

fn none(name: &str) -> Result<String, String> {
    fs::read_to_string(root().join(name)).map_err(|error| error.to_string())
}

fn audited(sheets: &[Sheet], part: Option<&Part>) -> Result<Audit, Unreadable> {
    Ok(AUDITOR.audit(&read_table("list.csv", sheets, part, &KNOWLEDGE, &none)?).unwrap())
}

fn of_text(text: &str, part: Option<&Part>) -> Result<Audit, Vec<Diagnostic>> {
    let sheets = sheets::read(Kind::Csv, text.as_bytes()).unwrap();
    audited(&sheets, part).map_err(|why| why.problems)
}

fn plate() -> Part {
    read_part("plate.yaml", &none("examples/plate.yaml").unwrap(), &KNOWLEDGE).unwrap()
}

/// The findings that are no notes: `wrong minute-feed 2:9 200`.
fn found(audit: &Audit) -> Vec<String> {
    let grave = audit.findings.iter().filter(|one| one.severity < Severity::Note && one.follows_from.is_empty());
    let place = |line: Option<u32>| line.unwrap_or_default();
    let of = |one: &technolog::audit::AuditFinding| {
        let severity = format!("{:?}", one.severity).to_lowercase();
        format!(
            "{severity} {} {}:{} {}",
            one.rule,
            place(one.line),
            place(one.column),
            one.stated.clone().unwrap_or_default()
        )
    };
    grave.map(of).collect()
}

/// A list of the drill of Appendix Г, at figures of the book's card (l. 10096-10130): 27.46 m/min is 874.5 turns, of which 800 are a step.
const LIST: &str = "Матеріал;Сталь 45\r\nВерстат;gf2171\r\nОтвір;Перехід;Діаметр, мм;Глибина, мм;Різальний інструмент;Оправка;S, мм/об;n, об/хв;F, мм/хв\r\n\
A;свердління;10;40;Свердло 035-2300-1273 ОСТ 2И20-1-80;191113040;0,25;800;200\r\n";

#[test]
fn a_list_is_read_as_people_write_it() {
    let wrong = LIST.replacen("800;200", "800;260", 1);
    let english = "material,steel-45\nmachine,gf2171\nhole,operation,\"D, mm\",\"depth, mm\",cutter,chuck,\"feed (mm/rev)\",\"n, rpm\",\"F, mm/min\"\n\
A,drilling,10,40,035-2300-1273,191113040,0.25,800,260\n";
    let cp1251: Vec<u8> = wrong
        .chars()
        .map(|sign| match sign {
            'А'..='я' => u8::try_from(u32::from(sign) - 0x410 + 0xc0).unwrap(),
            'і' => 0xb3,
            'І' => 0xb2,
            'ї' => 0xbf,
            'є' => 0xba,
            sign => u8::try_from(u32::from(sign)).unwrap(),
        })
        .collect();
    let tabs = wrong.replace(';', "\t");
    let marked = format!("\u{feff}{wrong}");
    for bytes in [wrong.as_bytes(), english.as_bytes(), &cp1251, tabs.as_bytes(), marked.as_bytes()] {
        let list = sheets::read(Kind::Csv, bytes).unwrap();
        assert_eq!(found(&audited(&list, None).unwrap()), ["wrong minute-feed 4:9 260"]);
        assert_eq!(found(&audited(&list, Some(&plate())).unwrap()), ["wrong minute-feed 4:9 260"]);
        // The same as a workbook: figures are figures there.
        let named = Sheet { name: "Аркуш1".to_owned(), ..list[0].clone() };
        let book = sheets::read(Kind::Xlsx, &sheets::xlsx(&[named]).unwrap()).unwrap();
        assert_eq!(found(&audited(&book, None).unwrap()), ["wrong minute-feed 4:9 260"]);
    }
    assert_eq!(found(&of_text(LIST, None).unwrap()), [""; 0]);
}

#[test]
fn choices_of_a_list_are_judged_by_what_is_known() {
    // Ø22.5 for a hole Ø20; and 2 mm/rev for 0.2.
    let other = LIST.replacen("035-2300-1273", "035-2301-1070", 1);
    assert_eq!(found(&of_text(&other, None).unwrap())[0], "error tool-of-other-size 4:5 ");
    let feed = LIST.replacen("0,25;800;200", "2,5;800;2000", 1);
    assert_eq!(found(&of_text(&feed, None).unwrap()), ["wrong audit-by-table 4:7 2,5".replace(',', ".")]);
    // Without the material nobody knows, and a note says so.
    let bare = feed.replacen("Матеріал;Сталь 45\r\nВерстат;gf2171\r\n", "", 1);
    let audit = of_text(&bare, None).unwrap();
    assert_eq!(found(&audit), [""; 0]);
    assert!(audit.findings.iter().any(|one| one.rule == "audit-list-without-part"));
    // A Morse drill in a collet chuck; a spindle speed that the machine has not.
    let chuck = LIST.replacen("10;40;Свердло 035-2300-1273", "20;40;Свердло 035-2301-1060", 1);
    let chuck = found(&of_text(&chuck, None).unwrap());
    assert!(chuck.iter().any(|one| one.starts_with("error holder-of-other-shank 4:6")), "{chuck:?}");
    let step = LIST.replacen("800;200", "810;202,5", 1);
    let step = found(&of_text(&step, None).unwrap());
    assert!(step.iter().any(|one| one.contains("4:8 810")), "{step:?}");
}

#[test]
fn bad_tables_are_told_with_place_and_remedy() {
    let part = plate();
    let problems = |text: &str, part: Option<&Part>| -> Vec<String> {
        let problems = of_text(text, part).unwrap_err();
        assert!(problems.iter().all(|one| one.help.is_some()), "{problems:?}");
        problems.iter().map(|one| format!("{} {}", one.code, one.place.clone().unwrap())).collect()
    };
    assert_eq!(problems("a;b\n1;2\n", None), ["no-head list.csv:1:1"]);
    // S alone may be the feed or the spindle speed.
    assert_eq!(
        problems("Перехід;Інструмент;S\nсвердління;035-2300-1273;0,2\n", None),
        ["ambiguous-column list.csv:1:3"]
    );
    assert_eq!(problems("Перехід;D;Діаметр\nсвердління;10;10\n", None), ["duplicate-column list.csv:1:3"]);
    let rows = "Отвір;Перехід;Діаметр;Інструмент;S, мм/об\n";
    assert_eq!(problems(&format!("{rows}A;свердловина;10;;0,2\n"), Some(&part)), ["bad-value list.csv:2:2"]);
    assert_eq!(problems(&format!("{rows}Z;свердління;10;;0,2\n"), Some(&part)), ["unknown-hole list.csv:2:1"]);
    assert_eq!(problems(&format!("{rows}A;свердління;десять;;0,2\n"), Some(&part)), ["bad-value list.csv:2:3"]);
    assert_eq!(problems(&format!("{rows}A;;10;;0,2\n"), Some(&part)), ["missing-key list.csv:2:1"]);
    for bytes in [b"\x00\x01\x02".as_slice(), b"", b"\n;;\n"] {
        assert!(sheets::read(Kind::Csv, bytes).is_err());
    }
}

/// What is done may stand under many headings; where it stands under none that is told once, with the headings that were not read.
#[test]
fn a_list_that_does_not_say_what_is_done_is_no_work() {
    let wrong = LIST.replacen("800;200", "800;260", 1);
    for heading in ["Найменування переходу", "Найменування операції", "Назва операції", "Зміст операції"]
    {
        let list = wrong.replacen("Перехід", heading, 1);
        assert_eq!(found(&of_text(&list, Some(&plate())).unwrap()), ["wrong minute-feed 4:9 260"], "{heading}");
    }
    // A card has the operation beside the transition.
    let card =
        wrong.replacen("Перехід", "Найменування операції;Зміст переходу", 1).replacen("A;", "A;005 Свердлильна;", 1);
    assert_eq!(found(&of_text(&card, Some(&plate())).unwrap()), ["wrong minute-feed 4:10 260"]);
    let other =
        format!("{}B;свердління;10;40;035-2300-1273;191113040;0,25;800;200\n", LIST.replacen("Перехід", "Робота", 1));
    for part in [None, Some(&plate())] {
        let told = of_text(&other, part).unwrap_err();
        assert_eq!(told.len(), 1, "{told:?}");
        assert_eq!(told[0].place.clone().unwrap().to_string(), "list.csv:3:1");
        assert!(Lang::EN.say(told[0].help.as_ref().unwrap()).contains("Робота"), "{told:?}");
    }
}

/// S and F without units are words of a program: 800 turns, 200 mm/min; a note says how they were read.
#[test]
fn words_of_programs_are_read_and_told() {
    let audit = of_text("hole,operation,D,tool,S,F\nA,drill,10,035-2300-1273,800,200\n", Some(&plate())).unwrap();
    let read: Vec<_> = audit.findings.iter().filter(|one| one.rule == "audit-column-read-as").collect();
    assert_eq!(read.len(), 2);
    assert_eq!(Lang::EN.say(&read[0].note), "column “S” was read as spindle speed in rpm, as in a program");
    // What is not read is told, too.
    let audit = of_text("hole,operation,D,tool,price\nA,drill,10,035-2300-1273,7\n", Some(&plate())).unwrap();
    assert!(audit.findings.iter().any(|one| one.rule == "audit-column-unread" && one.column == Some(5)));
}

/// A list goes hole by hole, which is no order of tool changes; without the width of a spot nobody knows how deep it should be; and a
/// step that practice holds lower needs no word that says so.
#[test]
fn what_a_list_does_not_say_is_not_wrong() {
    let list = "Отвір;Перехід;Інструмент;Оправка;S, мм/об;n, об/хв;Глибина, мм\n\
                A;центрування;035-2317-0103;191113040;0,1;1600;6\nA;свердління;035-2300-1273;191113040;0,225;1000;40\n\
                B;центрування;035-2317-0103;191113040;0,1;1600;6\nB;свердління;035-2300-1273;191113040;0,225;1000;40\n\
                B;розсвердлювання;035-2301-1060;191831062;0,76;400;40\n";
    let doubts = found(&of_text(list, Some(&plate())).unwrap());
    assert_eq!(doubts, ["doubtful audit-spot-depth 2:7 6", "doubtful audit-spot-depth 4:7 6"]);
}

/// What people write in lists, and what was blamed or passed over once.
#[test]
fn a_list_is_judged_by_what_standards_and_practice_allow() {
    let head = "Отвір;Перехід;Діаметр, мм;Глибина, мм;Інструмент;Подача S, мм/об;n, об/хв;F, мм/хв\n";
    let all = |audit: &Audit| -> Vec<String> {
        let grave = audit.findings.iter().filter(|one| one.severity < Severity::Note);
        grave.map(|one| one.rule.clone()).collect()
    };
    // A drill by its standard and its size is that of the catalog: its feed and speed are judged. The depth has the overrun in it.
    let drills = format!(
        "{head}A;центрування;3;;035-2317-0103;0,1;1600;160\nA;свердління;10;46;Свердло ГОСТ 10902-77;0,225;1000;225\n\
         B;розсвердлювання;20;49;Свердло ГОСТ 10903-77;0,76;400;304\n"
    );
    let right = of_text(&drills, Some(&plate())).unwrap();
    assert_eq!(all(&right), [""; 0]);
    assert!(right.findings.iter().all(|one| one.rule != "audit-column-unread"), "the name with its symbol is read");
    let fast = of_text(&drills.replace("0,76;400;304", "0,76;1600;1216"), Some(&plate())).unwrap();
    assert!(all(&fast).contains(&"spindle-step".to_owned()), "{:?}", all(&fast));
    let feed = of_text(&drills.replace("0,225;1000;225", "2,25;1000;2250"), Some(&plate())).unwrap();
    assert!(found(&feed).iter().any(|one| one.contains("3:6")), "{:?}", found(&feed));

    let hand = |number: u32| {
        let path = format!("{}/examples/hand-plans/{number}.yaml", env!("CARGO_MANIFEST_DIR"));
        technolog_testing::read(&std::fs::read_to_string(path).unwrap())
    };
    // ISO 965: the minor diameter of M10-6H is 8.376 to 8.676.
    let thread = |drill: &str| {
        let list = format!("{head}A;свердління;{drill};28;;0,2;2000;400\n");
        found(&of_text(&list, Some(&hand(5))).unwrap()).iter().any(|one| one.contains("tap-drill"))
    };
    assert!(!thread("8,6") && thread("8,8") && thread("8,2"));

    // A reamer after a drill, and no core drill between: that is missing, and no drill is of a wrong size.
    let reamed = format!(
        "{head}A;центрування;;;035-2317-0103;0,1;1250;125\nA;свердління;11;20;035-2300-1283;0,28;630;176,4\n\
         A;чорнове розвертання;11,95;20;;0,9;250;225\nA;чистове розвертання;12;20;;0,61;200;122\n"
    );
    let reamed = found(&of_text(&reamed, Some(&hand(4))).unwrap());
    assert!(reamed.iter().any(|one| one.starts_with("wrong audit-transition-missing 4:2")), "{reamed:?}");
    assert!(!reamed.iter().any(|one| one.contains("audit-allowance")), "{reamed:?}");

    // The author's own speed, a little slower than the formula's, is no slip, and a spot is no drilled hole.
    let own = "Отвір;Перехід;Діаметр, мм;Інструмент;V, м/хв;S, мм/об;n, об/хв;F, мм/хв\n\
               A;центрування;6;035-2317-0103;24;0,1;1250;125\nA;свердління;10;035-2300-1273;25;0,25;800;200\n";
    assert_eq!(all(&of_text(own, Some(&plate())).unwrap()), [""; 0]);

    // Through a blind hole.
    let blind = format!(
        "{head}A;центрування;4,8;2,4;035-2317-0102;0,1;2240;224\nA;свердління;8;28;035-2300-1253;0,36;2240;806,4\n"
    );
    let cover =
        std::fs::read_to_string(format!("{}/tests/audit-alone/cover.yaml", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let blind = found(&of_text(&blind, Some(&technolog_testing::read(&cover))).unwrap());
    assert!(blind.iter().any(|one| one.starts_with("error audit-breaks-through 3:4")), "{blind:?}");
}

/// A rule that there is not would never be asked whether it needs a part.
#[test]
fn every_need_is_of_a_rule() {
    let codes = Lang::codes();
    for row in KNOWLEDGE.rows::<technolog::tables::audit::AuditNeeds<'_>>().unwrap() {
        let known = technolog::audit::rules::all().any(|rule| rule.id == row.rule)
            || codes.iter().any(|code| code.as_str() == row.rule);
        assert!(known, "{}", row.rule);
    }
}

/// Every plan of another hand as a list of its tools: of its part, of its material and machine, of nothing. None is blamed.
#[test]
fn no_honest_list_is_blamed() {
    let mut blamed = Vec::new();
    let mut lists = 0;
    for (name, text) in honest::plans() {
        let plan: Value = serde_yaml::from_str(&text).unwrap();
        let (Some(list), Some(part)) = (list_of(&plan), part_of(&plan)) else { continue };
        lists += 1;
        let said = format!("material;{}\nmachine;{}\n", part.material, part.machine);
        let by_material = if part.material_state.is_none() { said } else { String::new() };
        for (how, text, part) in [
            ("part", list.clone(), Some(&part)),
            ("material", format!("{by_material}{list}"), None),
            ("alone", list, None),
        ] {
            let audit = of_text(&text, part).unwrap_or_else(|why| panic!("{name}: {why:?}\n{text}"));
            let grave = audit.findings.iter().filter(|one| one.is_wrong());
            blamed.extend(grave.map(|one| format!("{name} {how}: {} {:?} {:?}", one.rule, one.stated, one.right)));
        }
    }
    assert!(lists >= 15, "{lists}");
    assert_eq!(blamed, [""; 0]);
}

fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        _ => String::new(),
    }
}

fn part_of(plan: &Value) -> Option<Part> {
    let part = plan.get("part")?;
    let text = match part {
        Value::String(path) => fs::read_to_string(honest::folder().join(path)).unwrap(),
        part => serde_yaml::to_string(part).unwrap(),
    };
    read_part("part.yaml", &text, &KNOWLEDGE).ok()
}

/// The tools of a plan as rows with all that the plan says of each.
fn list_of(plan: &Value) -> Option<String> {
    let keys = ["hole", "operation", "diameter", "from", "depth", "passes"];
    let figures = ["feed", "speed", "rpm_computed", "rpm", "minute_feed"];
    let mut lines = vec![
        "hole;operation;D;D0;depth;passes;cutter;chuck;feed, mm/rev;V, m/min;computed rpm;n, rpm;F, mm/min".to_owned(),
    ];
    let empty = Vec::new();
    let conditions = plan.get("conditions").and_then(Value::as_sequence).unwrap_or(&empty);
    for (at, row) in plan.get("route")?.as_sequence()?.iter().enumerate() {
        if row.get("elsewhere").is_some() || row.get("step").is_some() || row.get("feature").is_some() {
            continue;
        }
        let number = row.get("row").map_or_else(|| (at + 1).to_string(), text);
        let tool_of = row.get("tool").map(text).unwrap_or_default();
        let tool = plan.get("tools").and_then(|tools| tools.get(tool_of.as_str()));
        let named = |value: Option<&Value>| value.and_then(|own| own.get("designation")).map(text).unwrap_or_default();
        let is_own = |own: &&Value| match own.get("for") {
            Some(Value::Sequence(rows)) => rows.iter().any(|row| text(row) == number),
            Some(row) => text(row) == number || text(row) == tool_of,
            None => false,
        };
        let own = conditions.iter().find(is_own);
        let mut cells: Vec<String> = keys.iter().map(|key| row.get(*key).map(text).unwrap_or_default()).collect();
        cells.push(named(tool));
        cells.push(named(tool.and_then(|tool| tool.get("holder"))));
        cells.extend(figures.iter().map(|key| own.and_then(|own| own.get(*key)).map(text).unwrap_or_default()));
        lines.push(cells.join(";"));
    }
    Some(lines.join("\n"))
}

/// What the program writes is read back as the same plan: nothing is found that is not found in its form of YAML.
#[test]
fn templates_are_plans() {
    let parts = ["examples/plate.yaml", "examples/bracket.yaml", "tests/audit/aluminium-part.yaml"];
    let mut seen = 0;
    for path in parts {
        let Ok(text) = none(path) else { continue };
        seen += 1;
        let part = read_part(path, &text, &KNOWLEDGE).unwrap();
        let plan = planned(&part, CuttingMethod::Formula);
        let hand = read_plan("plan.yaml", &technolog::audit::by_hand(&plan, path), &KNOWLEDGE, &none).unwrap();
        let expected = said(&AUDITOR.audit(&hand).unwrap());
        for lang in [Lang::UK, Lang::EN] {
            let tables = by_tables(&plan, path, lang);
            let csv = sheets::csv(&tables, if lang.tag() == "uk" { ',' } else { '.' }).unwrap();
            let books = [
                sheets::read(Kind::Csv, csv.as_bytes()).unwrap(),
                sheets::read(Kind::Xlsx, &sheets::xlsx(&tables).unwrap()).unwrap(),
            ];
            for book in books {
                let audit = audited(&book, None).unwrap_or_else(|why| panic!("{path}: {:?}", why.problems));
                assert_eq!(said(&audit), expected, "{path} {}", lang.tag());
            }
        }
    }
    assert!(seen >= 2, "{seen}");
}

/// Every finding but its place, which is of the table.
fn said(audit: &Audit) -> Vec<String> {
    audit.findings.iter().map(|one| format!("{:?} {} {} {:?}", one.severity, one.rule, one.field, one.stated)).collect()
}

#[test]
fn keys_and_words_of_a_plan_may_be_ukrainian() {
    let right = none("tests/audit/right.yaml").unwrap().replace("../../examples", "examples");
    let mut plan = right.clone();
    for (key, own) in [
        ("plan:", "план:"),
        ("part:", "деталь:"),
        ("cutting: card", "режими за: картами"),
        ("route:", "маршрут:"),
        ("operation: centre-drill", "перехід: центрування"),
        ("operation: drill,", "перехід: свердління,"),
        ("hole:", "отвір:"),
        ("diameter:", "діаметр:"),
        ("depth:", "глибина:"),
        ("tools:", "інструменти:"),
        ("overhang:", "виліт:"),
        ("conditions:", "режими різання:"),
        ("depth_of_cut:", "глибина різання:"),
        ("feed:", "подача:"),
        ("minute_подача:", "хвилинна подача:"),
        ("clamping:", "закріплення:"),
        ("times:", "час деталі:"),
    ] {
        assert!(plan.contains(key), "{key}");
        plan = plan.replace(key, own);
    }
    let audit = |text: &str| {
        let text = text
            .replace("program: {file: plate.nc", "program: {file: tests/audit/plate.nc")
            .replace("setting: plate", "setting: tests/audit/plate");
        AUDITOR
            .audit(&read_plan("plan.yaml", &text, &KNOWLEDGE, &none).unwrap_or_else(|why| panic!("{:?}", why.problems)))
            .unwrap()
    };
    assert_eq!(said(&audit(&plan)), said(&audit(&right)));
}

/// A sign too much, a nought and half a hole are slips, and the rest of the plan is judged.
#[test]
fn impossible_figures_are_slips() {
    let right = none("tests/audit/right.yaml")
        .unwrap()
        .replace("../../examples", "examples")
        .replace("plate.nc", "tests/audit/plate.nc");
    let right = right.replace("setting: plate", "setting: tests/audit/plate");
    let of = |text: &str| {
        let audit = AUDITOR.audit(&read_plan("plan.yaml", text, &KNOWLEDGE, &none).unwrap()).unwrap();
        let slips = audit.findings.into_iter().filter(|one| one.is_wrong() && one.follows_from.is_empty());
        slips.map(|one| format!("{} {} {}", one.rule, one.field, one.stated.unwrap_or_default())).collect::<Vec<_>>()
    };
    assert_eq!(of(&right), [""; 0]);
    assert_eq!(of(&right.replacen("distance: 283", "distance: -283", 1)), ["audit-impossible distance -283"]);
    assert_eq!(of(&right.replacen("distance: 283", "distance: 0", 1)), ["audit-impossible distance 0"]);
    assert_eq!(of(&right.replacen("count: 6", "count: 6.5", 1)), ["audit-impossible count 6.5"]);
}

/// A list that names its part in a line above may name holes by their size, too: a hole, a thread; a size that no hole has is told once,
/// whatever rows stand below it.
#[test]
fn holes_are_named_by_their_size_whoever_names_the_part() {
    let part = "part: P\nmaterial: steel-45\nblank: {kind: plate, length: 99, width: 99, thickness: 20}\nmachine: gf2171\nholes:\n  \
                - {name: A, diameter: 10H7, through: true, roughness: Ra 1.6, centre_tolerance: 0.1, at: [[0, 0]]}\n  \
                - {name: M, thread: M8, through: true, depth: 20, centre_tolerance: 0.4, at: [[20, 0]]}\n";
    let files = |_: &str| Ok(part.to_owned());
    let read = |last: &str| {
        let text = format!(
            "Деталь;p.yaml\nОтвір;Перехід;Діаметр;Інструмент\nØ10H7;центрування;5;035-2317-0102\n;свердління;9,8;035-2300-1271\n\
             {last};центрування;5;035-2317-0102\n;свердління;6,8;035-2300-1242\n"
        );
        let sheets = sheets::read(Kind::Csv, text.as_bytes()).unwrap();
        read_table("list.csv", &sheets, None, &KNOWLEDGE, &files)
    };
    for thread in ["M8", "М8", "M"] {
        let stated = read(thread).unwrap_or_else(|why| panic!("{thread}: {why:?}"));
        assert_eq!((stated.rows_of_hole("A").count(), stated.rows_of_hole("M").count()), (2, 2), "{thread}");
    }
    for unknown in ["M10", "Ø11H7"] {
        let told = read(unknown).unwrap_err().problems;
        assert_eq!(told.iter().map(|one| one.code).collect::<Vec<_>>(), ["unknown-hole"], "{unknown}");
    }
}
