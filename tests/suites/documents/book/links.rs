//! All links work, and docs/SUMMARY.md, the contents of the book, has every page once.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use technolog_testing::root;

use super::page::{Page, pages};

/// The anchor of a heading, as mdBook and most hosts of repositories make it.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|letter| letter.is_alphanumeric() || [' ', '-', '_'].contains(letter));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

/// The path from the root that a link of a page leads to.
pub fn target(page: &Page, file: &str) -> String {
    let mut path = PathBuf::new();
    for part in Path::new(&page.path).parent().unwrap().join(file).components() {
        match part {
            Component::ParentDir => assert!(path.pop(), "{}: {file} leads out of the repository", page.path),
            part => path.push(part),
        }
    }
    path.to_str().unwrap().to_owned()
}

#[test]
fn links_lead_somewhere() {
    let mut lost = Vec::new();
    for page in pages() {
        for link in page.links().into_iter().filter(|link| !link.contains("://")) {
            let (file, heading) = link.split_once('#').map_or((&*link, None), |(file, heading)| (file, Some(heading)));
            let path = if file.is_empty() { page.path.clone() } else { target(&page, file) };
            let found = root().join(&path).exists()
                && heading.is_none_or(|heading| {
                    Page::read(&path).headings().iter().any(|(_, words)| anchor(words) == heading)
                });
            if !found {
                lost.push(format!("{}: {link}", page.path));
            }
        }
    }
    assert!(lost.is_empty(), "links that lead nowhere:\n{}", lost.join("\n"));
}

#[test]
fn the_summary_has_every_page_once() {
    let summary = Page::read("docs/SUMMARY.md");
    let listed: Vec<String> =
        summary.links().iter().filter(|link| !link.is_empty()).map(|link| target(&summary, link)).collect();
    let once: BTreeSet<&String> = listed.iter().collect();
    assert_eq!(once.len(), listed.len(), "a page stands twice in docs/SUMMARY.md");
    let paths: Vec<String> = pages().into_iter().map(|page| page.path).collect();
    let all: BTreeSet<&String> =
        paths.iter().filter(|path| path.starts_with("docs/") && *path != &summary.path).collect();
    assert_eq!(once, all);
}
