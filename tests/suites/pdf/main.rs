//! Reports as PDF, read back as text by pdftotext (Debian: poppler-utils). Only with the feature `pdf`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "as in the other suites")]

use std::path::Path;
use std::process::{Command, Output};

use technolog::note::IntoFigure;
use technolog::plan::CuttingMethod;
use technolog::report::Lang;
use technolog::report::laboratory::Form;
use technolog::units::round_to;
use technolog_testing::{planned, read};

fn run(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    Command::new(env!("CARGO_BIN_EXE_technolog")).args(arguments).current_dir(root).output().unwrap()
}

/// The file of a report, and its text with single spaces; none where there is no pdftotext.
fn printed(name: &str, arguments: &[&str]) -> (Vec<u8>, Option<String>) {
    let folder = std::env::temp_dir().join(format!("technolog-pdf-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("report.pdf").display().to_string();
    let output = run(&[&["report", "-o", &file], arguments].concat());
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}", String::from_utf8_lossy(&output.stderr));
    let bytes = std::fs::read(&file).unwrap();
    assert!(bytes.starts_with(b"%PDF-"));
    let text = Command::new("pdftotext").args(["-layout", &file, "-"]).output().ok();
    let text =
        text.map(|told| String::from_utf8(told.stdout).unwrap().split_whitespace().collect::<Vec<_>>().join(" "));
    if text.is_none() {
        eprintln!("pdftotext is not here: what the file says was not read");
    }
    std::fs::remove_dir_all(&folder).unwrap();
    (bytes, text)
}

/// Nothing of the plan is lost on the way onto paper, and the text is that of the other formats, Ukrainian letters too.
#[test]
fn every_figure_of_the_plan_is_in_its_pdf() {
    for name in ["plate", "variant-4", "bracket"] {
        let path = format!("examples/{name}.yaml");
        let (_, text) = printed(name, &[&path, "--title", "examples/report.yaml", "--lang", "uk"]);
        let Some(text) = text else { return };
        let part = read(&std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(&path)).unwrap());
        let plan = planned(&part, CuttingMethod::default());
        let has = |what: &str| assert!(text.contains(what), "{path}: {what} is not in the file");
        for said in ["О. Ковальчук", "16. Висновки", "Рисунок 1"] {
            has(said);
        }
        for tool in &plan.tools {
            has(&tool.designation);
            has(&tool.holder);
            has(&Lang::UK.figure(&tool.length_mm.into_figure()));
            has(&Lang::UK.figure(&tool.overhang_mm.into_figure()));
        }
        for own in plan.holes.iter().flat_map(|hole| &hole.transitions) {
            has(&Lang::UK.figure(&own.diameter_mm.into_figure()));
            if own.elsewhere {
                continue;
            }
            let its = &own.conditions;
            let optional = [
                (its.axial_force_n.map(|it| it.0), 0),
                (its.torque_n_m.map(|it| it.0), 1),
                (its.power_kw.map(|it| it.0), 2),
            ];
            let optional = optional.into_iter().filter_map(|(figure, places)| Some((figure?, places)));
            let figures = [
                (its.depth_of_cut_mm, 2),
                (its.feed_mm_per_rev.0, 3),
                (its.speed_m_per_min.0, 1),
                (its.spindle_rpm.0, 0),
                (its.feed_mm_per_min.0, usize::from(its.feed_mm_per_min.0.fract().abs() >= 0.05)),
                (its.machine_time_min.0, 2),
            ];
            for (figure, places) in figures.into_iter().chain(optional) {
                let figure = round_to(figure, u32::try_from(places).unwrap());
                has(&format!("{figure:.places$}").replace('.', ","));
            }
        }
        if let Some(own) = &plan.clamping {
            has(&format!("Q = {:.0}", own.force_per_clamp_n.0));
            let formula = if own.side_force_n.is_some() { "k·P/(f + f2)" } else { "k·M/(f·d)" };
            has(&format!("W = {formula} = {:.0}", own.force_n.0));
        }
        for stop in plan.sequence.iter().flat_map(|visit| &visit.stops) {
            let point = [stop.at.x, stop.at.y].map(|at| Lang::UK.figure(&at.into_figure()));
            has(&format!("{} [{}; {}]", stop.hole, point[0], point[1]));
        }
        has(&format!("{:.2}", plan.time.total_min.0).replace('.', ","));
    }
}

#[test]
fn every_form_is_printed_with_the_same_bytes_each_time() {
    for (form, _) in Form::NAMES {
        let once = || printed(form, &["examples/plate.yaml", "--only", form]);
        let ((bytes, text), (again, _)) = (once(), once());
        assert!(bytes == again, "{form}: other bytes");
        if let Some(text) = text {
            assert!(
                text.contains("035-2300-1273") || form == "encoding-sheet" && text.contains("N5"),
                "{form}: {text}"
            );
        }
    }
}
