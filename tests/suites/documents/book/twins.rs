//! The pages that a user needs exist in Ukrainian too, with the same content: headings, commands, examples, tables,
//! links and names of things are those of the English page.

use std::collections::BTreeSet;

use technolog_testing::root;

use super::links::target;
use super::page::{Block, Page, pages};

/// What a user needs, and so stands in both languages.
const NEEDED: [&str; 11] = [
    "audit",
    "index",
    "limits",
    "outputs",
    "part-format",
    "program",
    "quick-start",
    "reading-a-plan",
    "report",
    "turned-part-format",
    "worked-example",
];

/// The pages of docs/uk with their English twins.
fn twins() -> Vec<(Page, Page)> {
    let ukrainian = pages().into_iter().filter(|page| page.path.starts_with("docs/uk/"));
    ukrainian.map(|page| (Page::read(&page.path.replace("/uk/", "/")), page)).collect()
}

/// A block without what differs between languages: the remarks, the titles, what is printed, the language asked for.
fn bare(block: &Block) -> Vec<String> {
    let titles = ["part: ", "shaft: ", "plan: ", "scheme: "];
    let lines = block.lines.iter();
    let lines: Vec<String> = match block.language() {
        "console" => lines
            .filter(|line| line.starts_with("$ "))
            .map(|line| line.split(" | ").next().unwrap().to_owned())
            .collect(),
        "sh" | "yaml" => lines
            .map(|line| line.split_once('#').map_or(&**line, |(line, _)| line).trim_end().to_owned())
            .filter(|line| !titles.iter().any(|title| line.starts_with(title)))
            .collect(),
        _ => Vec::new(),
    };
    lines.into_iter().map(|line| line.replace(" --lang en", "").replace("uk/", "").replace("-uk.", ".")).collect()
}

/// How many lines each table of a page has.
fn tables(page: &Page) -> Vec<usize> {
    let mut sizes = vec![0];
    for line in page.prose() {
        if line.starts_with('|') {
            *sizes.last_mut().unwrap() += 1;
        } else if sizes.last() != Some(&0) {
            sizes.push(0);
        }
    }
    sizes
}

/// What the links of a page lead to, the Ukrainian pages by their English twins.
fn linked(page: &Page) -> Vec<String> {
    let files = page.links().into_iter().filter(|link| !link.contains("://"));
    let files = files.map(|link| link.split('#').next().unwrap().to_owned()).filter(|file| !file.is_empty());
    let english = |file: String| target(page, &file).replace("docs/uk/", "docs/").replace("README.uk", "README");
    files.map(|file| english(file).replace("-uk.", ".")).collect()
}

/// What stands in back quotes and is no prose: keys, options, names of files.
fn names(page: &Page) -> BTreeSet<String> {
    let prose = page.prose().join("\n");
    let quoted = prose.split('`').skip(1).step_by(2);
    quoted.filter(|name| name.is_ascii()).map(|name| name.replace(" --lang en", "")).collect()
}

fn same(english: &Page, ukrainian: &Page) {
    let name = &ukrainian.path;
    let depths = |page: &Page| page.headings().iter().map(|(depth, _)| *depth).collect::<Vec<_>>();
    assert_eq!(depths(english), depths(ukrainian), "{name}: headings");
    let languages = |page: &Page| page.blocks().into_iter().map(|block| block.info).collect::<Vec<_>>();
    assert_eq!(languages(english), languages(ukrainian), "{name}: blocks");
    for (english, ukrainian) in english.blocks().iter().zip(ukrainian.blocks()) {
        assert_eq!(bare(english), bare(&ukrainian), "{name}:{}", ukrainian.line);
    }
    assert_eq!(tables(english), tables(ukrainian), "{name}: lines of tables");
    assert_eq!(linked(english), linked(ukrainian), "{name}: links");
    let (english, ukrainian) = (names(english), names(ukrainian));
    let missing: Vec<_> = english.difference(&ukrainian).collect();
    let more: Vec<_> = ukrainian.difference(&english).collect();
    assert!(missing.is_empty() && more.is_empty(), "{name}: names {missing:?} are missing, {more:?} are more");
}

#[test]
fn pages_in_both_languages_say_the_same() {
    for (english, ukrainian) in twins() {
        same(&english, &ukrainian);
    }
    same(&Page::read("README.md"), &Page::read("README.uk.md"));
}

#[test]
fn what_a_user_needs_stands_in_both_languages() {
    let there: Vec<String> = twins().into_iter().map(|(english, _)| english.path).collect();
    assert_eq!(there, NEEDED.map(|name| format!("docs/{name}.md")));
}

/// A reader of Ukrainian stays in Ukrainian where there is a page. A page may lead to its own twin.
#[test]
fn ukrainian_pages_lead_to_ukrainian_pages() {
    let readme = Page::read("README.uk.md");
    for page in twins().into_iter().map(|(_, page)| page).chain([readme]) {
        for link in page.links().into_iter().filter(|link| !link.contains("://") && !link.starts_with('#')) {
            let path = target(&page, link.split('#').next().unwrap());
            let own = path.replace("docs/", "docs/uk/");
            let strays = path.ends_with(".md") && !path.starts_with("docs/uk/") && own != path && own != page.path;
            assert!(!(strays && root().join(&own).exists()), "{}: {link} stands in Ukrainian as {own}", page.path);
        }
    }
}

/// `technolog` answers a Ukrainian page in Ukrainian, which is the default.
#[test]
fn commands_are_of_the_language_of_their_page() {
    for page in pages() {
        let ukrainian = page.path.starts_with("docs/uk/") || page.path == "README.uk.md";
        for block in page.blocks().iter().filter(|block| block.language() == "console") {
            for command in block.lines.iter().filter(|line| line.starts_with("$ ")) {
                assert!(!(ukrainian && command.contains("--lang")), "{}: {command}", page.path);
            }
        }
    }
}
