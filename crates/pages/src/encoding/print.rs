//! The sheet for people and for other programs: text, Markdown, CSV. JSON is the sheet itself.

use crate::report::{Lang, grid};

use super::{Row, Sheet};

impl Sheet {
    /// The names of the columns; those that the textbook's sheet does not have carry a `*`.
    pub fn head(&self) -> [String; 4] {
        let names = match self.lang {
            _ if self.lang == Lang::UK => {
                ["Зміст переходу", "Інструмент / коректор*", "Код (кадр)", "Зміст кадру словами*"]
            }
            _ => ["Transition", "Tool / corrector*", "Code (block)", "The block in words*"],
        };
        names.map(str::to_owned)
    }

    fn title(&self) -> String {
        let title = self.lang.pick("Карта кодування інформації", "Encoding sheet");
        format!("{title} ({})", self.form)
    }

    fn fields(&self) -> Vec<(String, String)> {
        let pick = |uk, en| self.lang.pick(uk, en).to_owned();
        let mut fields = Vec::new();
        if let Some(part) = &self.part {
            fields.push((pick("Деталь", "Part"), part.clone()));
        }
        fields.push((pick("Обладнання, пристрій ЧПК", "Equipment, control"), self.equipment.clone()));
        if !self.instructions.is_empty() {
            fields.push((pick("Особливі вказівки*", "Special instructions*"), self.instructions.join("; ")));
        }
        fields
    }

    fn note(&self) -> &'static str {
        self.lang.pick("* - доповнено: у зразку посібника цього немає", "* ours: the textbook's sheet does not have it")
    }

    /// The sheet as a page.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n", self.title());
        for (name, value) in self.fields() {
            text.push_str(&grid::paragraph(&format!("{name}: {value}"), 0));
        }
        text.push('\n');
        let rows: Vec<Vec<String>> = self.rows.iter().map(|row| cells(row).into()).collect();
        text.push_str(&grid::table(&self.head(), &rows, 0));
        text.push_str(self.note());
        text.push('\n');
        text
    }

    /// The sheet in Markdown.
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n\n", self.title());
        for (name, value) in self.fields() {
            text.push_str(&format!("{}: {}  \n", plain(&name), plain(&value)));
        }
        text.push_str(&format!("\n| {} |\n|---|---|---|---|\n", self.head().map(|cell| plain(&cell)).join(" | ")));
        for row in &self.rows {
            let [transition, tool, code, meaning] = cells(row);
            // A block stands as code, where nothing has to be escaped but what ends a cell.
            let code = code.replace('`', "'").replace('|', "\\|");
            text.push_str(&format!("| {} | {} | `{code}` | {} |\n", plain(&transition), plain(&tool), plain(&meaning)));
        }
        text.push_str(&format!("\n{}\n", plain(self.note())));
        text
    }

    /// The rows as CSV (RFC 4180), with the number of the line in front.
    pub fn csv(&self) -> String {
        let mut text = String::from("line,transition,tool,code,meaning\r\n");
        for row in &self.rows {
            let cells = cells(row).map(|cell| quoted(&cell));
            text.push_str(&format!("{},{}\r\n", row.line, cells.join(",")));
        }
        text
    }
}

fn cells(row: &Row) -> [String; 4] {
    let text = |cell: &Option<String>| cell.clone().unwrap_or_default();
    [text(&row.transition), text(&row.tool), row.code.clone(), row.meaning.clone()]
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.to_owned() }
}

/// A text in which Markdown sees no marks.
fn plain(text: &str) -> String {
    let mut shown = String::new();
    for letter in text.chars() {
        if matches!(letter, '|' | '*' | '_' | '`' | '<' | '[' | '#' | '\\') {
            shown.push('\\');
        }
        shown.push(letter);
    }
    shown
}
