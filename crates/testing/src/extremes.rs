//! Every figure of a file pushed to the limits that its reader accepts.

/// A figure of a file: where it stands in its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// Its first byte.
    pub from: usize,
    /// Behind its last byte.
    pub to: usize,
}

/// The figures of a text: every run of digits with at most one point in it, whatever it stands in.
pub fn figures(text: &str) -> Vec<Span> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        if !bytes[at].is_ascii_digit() {
            at += 1;
            continue;
        }
        let from = at;
        let mut points = 0;
        while at < bytes.len() && (bytes[at].is_ascii_digit() || (bytes[at] == b'.' && points == 0)) {
            points += usize::from(bytes[at] == b'.');
            at += 1;
        }
        found.push(Span { from, to: at });
    }
    found
}

impl Span {
    /// The text with another figure in its place, in thousandths.
    pub fn set(self, text: &str, thousandths: i64) -> String {
        let (whole, part) = (thousandths / 1000, thousandths % 1000);
        let written =
            if part == 0 { whole.to_string() } else { format!("{whole}.{part:03}").trim_end_matches('0').to_owned() };
        format!("{}{written}{}", &text[..self.from], &text[self.to..])
    }

    /// What stands there, in thousandths.
    pub fn value(self, text: &str) -> i64 {
        (text[self.from..self.to].parse::<f64>().unwrap_or(0.0) * 1000.0).round() as i64
    }
}

/// What may stand instead of a figure: the least and the greatest that are admitted next to it without one refused
/// between, found by halving; and every power of ten from a thousandth to a milliard that is admitted.
pub fn admitted(figure: Span, text: &str, admits: impl Fn(&str) -> bool) -> Vec<String> {
    let here = figure.value(text);
    let good = |value: i64| admits(&figure.set(text, value));
    let ladder = (0..=12).map(|power| 10_i64.pow(power));
    let mut values: Vec<i64> = ladder.filter(|value| good(*value)).collect();
    if good(here) {
        for far in [0, 1_000_000_000_000] {
            let (mut inside, mut outside) = (here, far);
            if good(far) {
                values.push(far);
                continue;
            }
            while (inside - outside).abs() > 1 {
                let middle = inside + (outside - inside) / 2;
                if good(middle) { inside = middle } else { outside = middle }
            }
            values.push(inside);
        }
    }
    values.sort_unstable();
    values.dedup();
    values.into_iter().map(|value| figure.set(text, value)).collect()
}
