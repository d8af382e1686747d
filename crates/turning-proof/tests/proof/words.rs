//! Every finding has a text in both languages, with all its figures and no gap left.

use technolog_note::{Figure, Note};
use technolog_turning_proof::{Block, Fault, Mm, MotionKind, Refused, What, Whose};
use technolog_words::Lang;

use crate::made::{Named, at};

fn all() -> Vec<Note> {
    let (block, width, pitch, lead) = (Block(7), Mm(1.25), Mm(1.75), Mm(1.5));
    let place = (Some(at(-12.3456, 20.0)), Some(block));
    let of_tool = |what| (what, Whose::Tool("PCLNR".to_owned()), place);
    let of_surface = |what| (what, Whose::Surface(Some(Figure::from_name("neck"))), place);
    let of_thread = |what| (what, Whose::Surface(Some(Figure::from_name("neck"))), (None, None));
    let faults = [
        of_surface(What::Gouge { depth: Mm(0.281) }),
        of_tool(What::RapidCut { width }),
        of_tool(What::Holder { width, kind: MotionKind::Feed }),
        of_tool(What::Holder { width, kind: MotionKind::Rapid }),
        of_tool(What::Struck { body: Figure::from_name("jaws"), width }),
        of_tool(What::OffAxis),
        (What::Stands { thickness: Mm(0.3), from_z: Mm(-1.0), to_z: Mm(-5.0) }, Whose::Surface(None), place),
        of_surface(What::Corner { radius: Mm(0.8), left: Mm(0.2343) }),
        of_thread(What::ThreadShallow { left: Mm(0.125) }),
        of_thread(What::ThreadPart { left: Mm(14.5), from_z: Mm(-16.0), to_z: Mm(-30.5) }),
        of_tool(What::TapBlocked { width }),
        of_surface(What::ThreadLead { pitch: Mm(2.0), lead }),
        of_tool(What::Buried { depth: Mm(4.5) }),
        of_surface(What::ThreadPhase { pitch: Mm(2.0), shift: Mm(0.625) }),
        of_tool(What::TapOutOfStep { pitch, lead }),
        of_surface(What::TapHoleWide { width }),
        of_thread(What::ThreadShort { left: Mm(3.25) }),
    ];
    let faults = faults.map(|(what, whose, (at, block))| Fault { what, whose, at, block, count: 3 });
    let tool = "PCLNR".to_owned();
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
