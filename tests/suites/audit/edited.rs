//! A plan by hand with some of its figures written otherwise. Its text stays as it was, so that figures keep their last places.

use std::ops::Range;

/// The lines of a plan.
pub(super) struct Lines(Vec<String>);

impl Lines {
    pub fn of(text: &str) -> Self {
        Self(text.lines().map(str::to_owned).collect())
    }

    pub fn text(&self) -> String {
        self.0.join("\n") + "\n"
    }

    /// The lines of `route.2`, `tools.T1`, `conditions.3` or a whole section, and what of the path is behind it.
    fn block<'p>(&self, path: &'p str) -> (Range<usize>, &'p str) {
        let (section, rest) = path.split_once('.').unwrap_or((path, ""));
        let indent = |line: &str| line.len() - line.trim_start().len();
        let start =
            self.0.iter().position(|line| line.starts_with(&format!("{section}:"))).unwrap_or_else(|| panic!("{path}"));
        let behind = |start: usize, most: usize| {
            let rest = self.0.iter().enumerate().skip(start + 1);
            let mut ends = rest.filter(|(_, line)| indent(line) <= most && !line.trim().is_empty());
            ends.next().map_or(self.0.len(), |(at, _)| at)
        };
        let end = behind(start, 0);
        if !["route", "tools", "conditions"].contains(&section) {
            return (start..end, rest);
        }
        let (of, key) = rest.split_once('.').unwrap_or((rest, ""));
        let is_item = |line: &&String| {
            indent(line) == 2
                && if section == "tools" { line.starts_with(&format!("  {of}:")) } else { line.starts_with("  - ") }
        };
        let number = of.parse::<usize>().map_or(0, |number| number - 1);
        let mut items = (start..end).filter(|at| is_item(&&self.0[*at]));
        let own = items.nth(number).unwrap_or_else(|| panic!("{path}"));
        (own..behind(own, 2).min(end), key)
    }

    /// Writes a value of a path; a key that is not there is added.
    pub fn set(&mut self, path: &str, value: &str) {
        let (block, key) = self.block(path);
        let (outer, inner) = key.split_once('.').map_or((None, key), |(outer, inner)| (Some(outer), inner));
        let text = self.0[block.clone()].join("\n");
        let start = outer.map_or(0, |outer| text.find(&format!("{outer}: ")).unwrap_or_else(|| panic!("{path}")));
        // A key of its own line before one inside braces.
        let mut places =
            [format!("\n    {inner}: "), format!("- {inner}: "), format!("{{{inner}: "), format!(", {inner}: ")]
                .into_iter()
                .skip(if outer.is_some() { 2 } else { 0 })
                .filter_map(|sign| text[start..].find(&sign).map(|at| start + at + sign.len()));
        let changed = if let Some(from) = places.next() {
            format!("{}{value}{}", &text[..from], &text[from + length(&text[from..])..])
        } else if text.trim_end().ends_with('}') && !text.contains("\n    ") {
            let end = text.rfind('}').unwrap();
            format!("{}, {inner}: {value}{}", &text[..end], &text[end..])
        } else {
            let end = text.find('\n').unwrap_or(text.len());
            format!("{}\n    {inner}: {value}{}", &text[..end], &text[end..])
        };
        self.0.splice(block, changed.lines().map(str::to_owned));
    }

    /// Takes out whole rows, tools, conditions or sections.
    pub fn drop(&mut self, paths: &[String]) {
        let mut blocks: Vec<Range<usize>> = paths.iter().map(|path| self.block(path).0).collect();
        blocks.sort_by_key(|block| block.start);
        for block in blocks.into_iter().rev() {
            self.0.drain(block);
        }
    }

    /// Exchanges two rows.
    pub fn swap(&mut self, first: &str, second: &str) {
        let (first, second) = (self.block(first).0.start, self.block(second).0.start);
        self.0.swap(first, second);
    }
}

/// How long a value is that a text begins with.
fn length(text: &str) -> usize {
    let close = match text.chars().next() {
        Some('{') => '}',
        Some('[') => ']',
        Some('"') => return text[1..].find('"').unwrap() + 2,
        _ => return text.find([',', '}', '\n']).unwrap_or(text.len()),
    };
    text.find(close).unwrap() + 1
}
