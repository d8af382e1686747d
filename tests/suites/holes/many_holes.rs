//! A part of a thousand holes of forty kinds is planned, every hole of it.

use technolog::machine::Machine;
use technolog::plan::CuttingMethod;
use technolog_testing::kinds::{EACH, part_of_kinds};
use technolog_testing::lawful::sound;
use technolog_testing::{KNOWLEDGE, planned, read};

#[test]
fn a_thousand_holes_of_forty_kinds_are_planned() {
    let part = read(&part_of_kinds(40));
    let plan = planned(&part, CuttingMethod::Formula);
    assert_eq!(plan.holes.iter().map(|hole| hole.count).sum::<usize>(), 1000);
    let machine = Machine::find(&KNOWLEDGE, &part.machine).unwrap();
    for hole in &plan.holes {
        assert!(hole.route.is_some(), "{}: {:?}", hole.name, plan.findings);
        for step in hole.transitions.iter().filter(|step| !step.elsewhere) {
            sound(step, &plan, &machine).unwrap();
        }
    }
    // Each point gets each transition that this machine makes, once.
    let stops: usize = plan.sequence.iter().map(|visit| visit.stops.len()).sum();
    let made = plan.holes.iter().map(|hole| hole.transitions.iter().filter(|step| !step.elsewhere).count() * EACH);
    assert_eq!(stops, made.sum::<usize>());
    // Forty kinds require more tools than the magazine holds: the plan says which are loaded by hand.
    assert!(plan.tools.len() > machine.magazine);
    assert!(plan.findings.iter().any(|finding| finding.note.code() == "magazine-reloaded"), "{:?}", plan.findings);
    for load in 1..=plan.tools.iter().map(|tool| tool.load).max().unwrap_or_default() {
        let places = plan.tools.iter().filter(|tool| tool.load == load).count();
        assert!(places > 0 && places <= machine.magazine, "load {load} has {places}");
    }
}
