//! The page: its sections, its blocks and what the words above them say to do.

pub const PAGE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/adding.md"));

/// Every section of the page.
pub fn titles() -> Vec<&'static str> {
    PAGE.lines().filter_map(|line| line.strip_prefix("## ")).collect()
}

/// What is to be done with a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    /// The whole file.
    New,
    /// Lines behind the last one.
    Append,
    /// Lines go and come.
    Change,
    /// The same, until the next answer.
    Try,
    /// A command with its answer.
    Answer,
    /// Code, which stands in a file of this room too.
    Rust,
}

/// The words above a block, each in front of the first path.
const VERBS: [(&str, Doing); 5] = [
    ("New file `", Doing::New),
    ("At the end of `", Doing::Append),
    ("Try in `", Doing::Try),
    ("In `", Doing::Change),
    (" in `", Doing::Change),
];

/// A fenced block of the page.
#[derive(Debug)]
pub struct Block {
    /// Where it begins, for messages.
    pub place: String,
    pub doing: Doing,
    pub paths: Vec<String>,
    pub lines: Vec<&'static str>,
}

impl Block {
    pub fn text(&self) -> String {
        self.lines.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// What stands in back quotes.
pub fn quoted(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// The paragraph above a block: the last of its verbs, and the paths behind it.
fn instruction(paragraph: &str) -> Option<(Doing, Vec<String>)> {
    let paragraph = paragraph.strip_suffix(':')?;
    let found = VERBS.into_iter().filter_map(|(verb, doing)| Some((paragraph.rfind(verb)? + verb.len(), verb, doing)));
    // `Try in` and the `in` of it end together.
    let (end, _, doing) = found.max_by_key(|(end, verb, _)| (*end, verb.len()))?;
    Some((doing, quoted(&paragraph[end - 1..])))
}

/// The lines of the page under a heading, with their numbers.
pub fn section(title: &str) -> Vec<(usize, &'static str)> {
    let heading = format!("## {title}");
    let lines = PAGE.lines().enumerate().map(|(index, line)| (index + 1, line));
    let mut lines = lines.skip_while(|(_, line)| *line != heading);
    assert!(lines.next().is_some(), "the page has no section {title}");
    lines.take_while(|(_, line)| !line.starts_with("## ")).collect()
}

/// An item of a list of files.
pub struct Item {
    /// Whether they are not there yet.
    pub new: bool,
    /// The files.
    pub paths: Vec<String>,
    /// What is said of them.
    pub instruction: String,
}

/// The files that a recipe says it touches.
pub fn files(title: &str) -> Vec<Item> {
    let mut items: Vec<String> = Vec::new();
    let (mut item, mut block) = (false, false);
    for (_, line) in section(title) {
        block ^= line.starts_with("```");
        match line.strip_prefix("- ").filter(|_| !block) {
            Some(first) => items.push(first.to_owned()),
            None => {
                item &= line.starts_with("  ");
                let open = items.last_mut().filter(|_| item);
                open.into_iter().for_each(|open| open.push_str(&format!(" {}", line.trim())));
            }
        }
        item |= line.starts_with("- ") && !block;
    }
    let split = |item: &String| {
        let (head, instruction) =
            item.split_once("`: ").unwrap_or_else(|| panic!("{title}: {item}: what is done with it?"));
        Item { new: head.starts_with("new "), paths: quoted(&format!("{head}`")), instruction: instruction.to_owned() }
    };
    items.iter().map(split).collect()
}

pub fn blocks(title: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut paragraph = String::new();
    let mut lines = section(title).into_iter();
    while let Some((number, line)) = lines.next() {
        let Some(language) = line.strip_prefix("```") else {
            match line {
                "" if paragraph.ends_with(':') => {}
                "" => paragraph.clear(),
                line => paragraph = format!("{paragraph} {line}").trim_start().to_owned(),
            }
            continue;
        };
        let place = format!("docs/adding.md:{number}");
        let inside: Vec<&str> = lines.by_ref().map(|(_, line)| line).take_while(|line| *line != "```").collect();
        let (doing, paths) = match language {
            "rust" => (Doing::Rust, Vec::new()),
            "text" if inside[0].starts_with("$ ") => (Doing::Answer, Vec::new()),
            _ => instruction(&paragraph).unwrap_or_else(|| panic!("{place}: what is to be done with this block?")),
        };
        assert_eq!(language == "diff", matches!(doing, Doing::Change | Doing::Try), "{place}: a change is a diff");
        blocks.push(Block { place, doing, paths, lines: inside });
        paragraph.clear();
    }
    blocks
}

/// Whether a line of the page stands for a line; `…` stands for anything.
pub fn stands_for(page: &str, line: &str) -> bool {
    let Some((before, after)) = page.split_once('…') else { return page == line };
    let Some(rest) = line.strip_prefix(before) else { return false };
    rest.char_indices().map(|(at, _)| at).chain([rest.len()]).any(|at| stands_for(after, &rest[at..]))
}

/// Whether lines of the page stand for an answer; a line that is `…` alone stands for any number of lines.
pub fn is_answer(page: &[&str], answer: &[&str]) -> bool {
    match page.split_first() {
        None => answer.is_empty(),
        Some((&"…", after)) => (0..=answer.len()).any(|skipped| is_answer(after, &answer[skipped..])),
        Some((line, after)) => {
            answer.first().is_some_and(|first| stands_for(line, first.trim_end())) && is_answer(after, &answer[1..])
        }
    }
}

#[test]
fn an_ellipsis_stands_for_what_is_left_out() {
    for (page, line, same) in [
        ("a b", "a b", true),
        ("a b", "a b c", false),
        ("a …", "a b c", true),
        ("… c", "a c b c", true),
        ("a … b … d", "a x b y d", true),
        ("a … b", "a b c", false),
        ("b …", "a b c", false),
    ] {
        assert_eq!(stands_for(page, line), same, "{page}: {line}");
    }
    assert!(is_answer(&["…", "b", "…"], &["a", "b"]));
    assert!(!is_answer(&["a", "…", "c"], &["a", "b"]));
    assert!(!is_answer(&["a"], &["a", "b"]));
}
