//! Names in letters that every control can show.

/// A name for a comment in a program: Ukrainian in Latin letters (the table of 2010), in capitals, which is all that older
/// controls know, and without characters that a control cannot show or that would end the comment.
pub fn ascii(text: &str) -> String {
    const LATIN: [(char, &str); 40] = [
        ('а', "a"),
        ('б', "b"),
        ('в', "v"),
        ('г', "h"),
        ('ґ', "g"),
        ('д', "d"),
        ('е', "e"),
        ('є', "ie"),
        ('ж', "zh"),
        ('з', "z"),
        ('и', "y"),
        ('і', "i"),
        ('ї', "i"),
        ('й', "i"),
        ('к', "k"),
        ('л', "l"),
        ('м', "m"),
        ('н', "n"),
        ('о', "o"),
        ('п', "p"),
        ('р', "r"),
        ('с', "s"),
        ('т', "t"),
        ('у', "u"),
        ('ф', "f"),
        ('х', "kh"),
        ('ц', "ts"),
        ('ч', "ch"),
        ('ш', "sh"),
        ('щ', "shch"),
        ('ь', ""),
        ('ю', "iu"),
        ('я', "ia"),
        ('ø', "D"),
        ('φ', "phi"),
        ('°', " deg"),
        ('µ', "u"),
        ('×', "x"),
        ('≤', "<="),
        ('≥', ">="),
    ];
    let mut latin = String::with_capacity(text.len());
    // In other languages the name of the standards is written so.
    for letter in text.replace("ГОСТ", "GOST").chars() {
        let small = letter.to_lowercase().next().unwrap_or(letter);
        match LATIN.iter().find(|(known, _)| *known == small) {
            Some((_, written)) if letter == small => latin.push_str(written),
            Some((_, written)) => latin.push_str(&written.to_uppercase()),
            None if matches!(letter, '(' | ')' | '%' | ';') => latin.push(' '),
            None if letter.is_ascii() && !letter.is_ascii_control() => latin.push(letter),
            None => latin.push('?'),
        }
    }
    latin.make_ascii_uppercase();
    if is_active_comment(&latin) { format!("- {}", latin.trim_start()) } else { latin }
}

/// Longer words may have an ending: DRILLING.
const SHORT: usize = 3;

/// Whether a comment in capitals says a phrase: where a word begins with it, or is it where it is short (TAP is no TAPER).
pub fn says(comment: &str, phrase: &str) -> bool {
    comment.match_indices(phrase).any(|(at, found)| {
        let (before, behind) = (&comment[..at], &comment[at + found.len()..]);
        !before.ends_with(|sign: char| sign.is_ascii_alphanumeric())
            && (phrase.len() > SHORT || !behind.starts_with(|sign: char| sign.is_ascii_alphabetic()))
    })
}

/// Whether LinuxCNC would execute the comment: it begins as those of table `iso-active-comments`, with which a test
/// compares this list.
fn is_active_comment(remark: &str) -> bool {
    const BEGINNINGS: [&str; 13] = [
        "msg,",
        "debug,",
        "print,",
        "log,",
        "logopen,",
        "logappend,",
        "logclose",
        "probeopen",
        "probeclose",
        "py,",
        "pyrun,",
        "pyreload",
        "abort,",
    ];
    let remark = remark.trim_start().to_ascii_lowercase();
    BEGINNINGS.iter().any(|begins| remark.starts_with(begins))
}
