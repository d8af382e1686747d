//! The usual mistakes of formulas: each is found, told first at its root, and recognised as what it is.

use std::collections::BTreeMap;

use serde::Deserialize;
use technolog::audit::rules;
use technolog::tables::audit::Mistakes;
use technolog_testing::KNOWLEDGE;

/// A mistake with everything that was computed after it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Planted {
    plan: String,
    name: String,
    /// The figure that is to be named first.
    at: String,
    /// The row of `audit-mistakes`.
    mistake: String,
    /// The figures as they are then, by their paths.
    set: BTreeMap<String, String>,
}

/// The plan with one figure written otherwise: the first `key:` behind the start of its block.
fn with(text: &str, path: &str, value: &str) -> String {
    let mut parts = path.split('.');
    let (section, rest): (&str, Vec<&str>) = (parts.next().unwrap(), parts.collect());
    let (start, key) = match rest.as_slice() {
        [number, key] if section == "conditions" => {
            let number: usize = number.parse().unwrap();
            let mut blocks = text.match_indices("\n  - for:");
            (blocks.nth(number - 1).unwrap().0, *key)
        }
        [tool, key] => (text.find(&format!("\n  {tool}:")).unwrap(), *key),
        [key] => (text.find(&format!("\n{section}:")).unwrap(), *key),
        _ => panic!("{path}"),
    };
    let own = text[start + 1..].find("\n  - for:").or_else(|| text[start + 1..].find("\n  T"));
    let block = &text[start..own.map_or(text.len(), |own| start + 1 + own)];
    // A key of its own line before one of a card or of factors.
    let mut found = ["\n    ", "{", " "].iter().filter_map(|before| {
        let at = block.find(&format!("{before}{key}: "))?;
        Some(start + at + before.len() + key.len() + 2)
    });
    let from = found.next().unwrap_or_else(|| panic!("{path}"));
    let end = text[from..].find([',', '}', '\n']).unwrap() + from;
    format!("{}{value}{}", &text[..from], &text[end..])
}

#[test]
fn usual_mistakes_are_found_and_recognised() {
    let table = std::fs::read_to_string(super::honest::folder().join("mistakes/table.yaml")).unwrap();
    let planted: Vec<Planted> = serde_yaml::from_str(&table).unwrap();
    assert!(planted.len() >= 60);
    let (mut found, mut root, mut named, mut missed) = (0, 0, 0, Vec::new());
    for one in &planted {
        let file = format!("{}.yaml", one.plan);
        let right = std::fs::read_to_string(super::honest::folder().join(&file)).unwrap();
        let text = one.set.iter().fold(right, |text, (path, value)| with(&text, path, value));
        let audit = super::honest::audited(&file, &text);
        let own = audit.findings.iter().find(|finding| finding.field == one.at);
        let is_root = audit.first_root().is_some_and(|first| first.field == one.at);
        let there = audit.findings.iter().filter(|finding| finding.field == one.at);
        let mistake =
            there.filter_map(|own| own.mistake.as_ref()).map(|note| serde_json::to_value(note).unwrap()).next();
        let is_named = mistake.as_ref().is_some_and(|note| note["params"]["id"] == one.mistake.as_str());
        found += usize::from(own.is_some());
        root += usize::from(is_root);
        named += usize::from(is_named);
        if !(own.is_some() && is_root && is_named) {
            let first = audit.first_root().map(|first| (&first.field, first.severity));
            missed.push(format!(
                "{}: {}: {:?}, first {first:?}, {mistake:?}",
                one.plan,
                one.name,
                own.map(|own| own.severity)
            ));
        }
    }
    let all = planted.len();
    println!("{all} planted: {found} found, {root} named first, {named} recognised\n{}", missed.join("\n"));
    assert!(found * 100 >= all * 98 && root * 100 >= all * 95 && named * 100 >= all * 95, "{}", missed.join("\n"));
}

/// A row of a rule that there is not would never be asked.
#[test]
fn every_mistake_is_of_a_rule() {
    for mistake in KNOWLEDGE.rows::<Mistakes<'_>>().unwrap() {
        assert!(rules::all().any(|rule| rule.id == mistake.rule), "{}", mistake.rule);
        assert!(
            mistake.law.is_some()
                || mistake.value.is_some()
                || mistake.instead.is_some()
                || mistake.times.is_some()
                || mistake.power.is_some(),
            "{} {} changes nothing",
            mistake.rule,
            mistake.id
        );
    }
}
