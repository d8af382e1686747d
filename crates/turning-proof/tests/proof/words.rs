//! Every finding has a text in both languages, with all its figures and no gap left.

use technolog_note::{Figure, Note};
use technolog_turning_proof::{Block, Fault, Mm, MotionKind, Refused};
use technolog_words::Lang;

use crate::made::{Named, at};

fn all() -> Vec<Note> {
    let (tool, at, block, count) = ("PCLNR".to_owned(), at(-12.3456, 20.0), Block(7), 3);
    let surface = Some(Figure::from_name("neck"));
    let width = Mm(1.25);
    let holder = |kind| Fault::Holder { tool: tool.clone(), width, at, kind, block, count };
    let faults = [
        Fault::Gouge { surface: surface.clone(), depth: Mm(0.281), at, block, count },
        Fault::RapidCut { tool: tool.clone(), width, at, block, count },
        holder(MotionKind::Feed),
        holder(MotionKind::Rapid),
        Fault::Struck { tool: tool.clone(), body: Figure::from_name("jaws"), width, at, block, count },
        Fault::OffAxis { tool: tool.clone(), at, block, count },
        Fault::Stands { surface: None, thickness: Mm(0.3), at, from_z: Mm(-1.0), to_z: Mm(-5.0) },
        Fault::Corner { surface: surface.clone(), radius: Mm(0.8), left: Mm(0.2343), at, count },
        Fault::ThreadShallow { surface: surface.clone(), left: Mm(0.125) },
        Fault::ThreadPart { surface: surface.clone(), left: Mm(14.5), from_z: Mm(-16.0), to_z: Mm(-30.5) },
        Fault::TapBlocked { tool: tool.clone(), width, at, block, count },
        Fault::ThreadLead { surface: surface.clone(), pitch: Mm(2.0), lead: Mm(1.5), at, block, count },
        Fault::Buried { tool: tool.clone(), depth: Mm(4.5), at, block, count },
        Fault::ThreadPhase { surface: surface.clone(), pitch: Mm(2.0), shift: Mm(0.625), at, block, count },
        Fault::TapOutOfStep { tool: tool.clone(), pitch: Mm(1.75), lead: Mm(1.5), at, block, count },
        Fault::TapHoleWide { surface: surface.clone(), width, at, block, count },
        Fault::ThreadShort { surface, left: Mm(3.25) },
    ];
    let refused =
        [Refused::NoContour, Refused::NoTool { block }, Refused::Place { limit: Mm(5000.0) }, Refused::Tool { tool }];
    faults.iter().map(Fault::note).chain(refused.iter().map(Refused::note)).collect()
}

#[test]
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
fn every_finding_is_said_with_all_its_figures() {
    for lang in Lang::all() {
        for note in all() {
            let said = lang.say(&note);
            assert!(!said.contains(note.code()) && !said.contains('{'), "{said}");
            for (name, figure) in note.figures() {
                let shown = match figure {
                    Figure::Word(_) => lang.word("word-surface-without-name").to_owned(),
                    other if lang.tag() == "uk" => other.text().replace('-', "−").replace('.', ","),
                    other => other.text().into_owned(),
                };
                assert!(said.contains(&shown), "{name} = {shown}: {said}");
            }
        }
    }
}

#[test]
fn what_it_says() {
    let said = |lang: Lang| lang.say(&all()[0]);
    assert_eq!(said(Lang::EN), "neck: cut 0.281 mm too deep at Z-12.346 Ø40; 3 places in all");
    assert_eq!(said(Lang::UK), "neck: підрізано на 0,281 мм у точці Z−12,346 Ø40; усього 3 місця");
}
