//! Divides a line for any control into words: letters with their values, comments, and other statements.

/// A piece of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Word {
    /// An address and its number, as written: `X`, `-200.`; the number may be an expression of the control.
    Address(char, String),
    /// A comment in brackets or after a semicolon: the control ignores it.
    Comment(String),
    /// `/`: the rest is skipped when the operator has switched the block skip on.
    Skip,
    /// `%`: the beginning or end of a tape or file.
    Tape,
    /// A statement that is no word: `o100 sub`, `#1 = 5`.
    Statement(String),
}

/// The words of a line. Nothing is refused: a sheet also shows what its control would reject.
pub(super) fn words_of_line(line: &str) -> Vec<Word> {
    let letters: Vec<char> = line.trim().chars().collect();
    let mut words = Vec::new();
    let mut at = 0;
    while let Some(&letter) = letters.get(at) {
        at += 1;
        let upper = letter.to_ascii_uppercase();
        match upper {
            ' ' | '\t' => {}
            '%' => words.push(Word::Tape),
            '/' => words.push(Word::Skip),
            ';' => {
                words.push(Word::Comment(letters[at..].iter().collect::<String>().trim().to_owned()));
                break;
            }
            '(' => {
                let inside: String = letters[at..].iter().take_while(|letter| **letter != ')').collect();
                at += inside.chars().count() + 1;
                words.push(Word::Comment(inside.trim().to_owned()));
            }
            // Expressions and named subprograms: the rest of the line is one statement.
            '#' => {
                words.push(Word::Statement(letters[at - 1..].iter().collect()));
                break;
            }
            'O' if is_statement(&letters[at..]) => {
                words.push(Word::Statement(letters[at - 1..].iter().collect()));
                break;
            }
            _ => {
                let end = number_end(&letters, at);
                words.push(Word::Address(upper, letters[at..end].iter().filter(|c| !c.is_whitespace()).collect()));
                at = end;
            }
        }
    }
    words
}

/// Whether an O begins a LinuxCNC statement and not a program number: it has a name, or a word after its number.
fn is_statement(behind: &[char]) -> bool {
    let rest: String = behind.iter().collect();
    let rest = rest.trim_start_matches(|letter: char| letter.is_ascii_digit()).trim_start();
    rest.starts_with('<') || rest.starts_with(|letter: char| letter.is_ascii_lowercase())
}

/// The end of the number, variable or bracketed expression of an address.
fn number_end(letters: &[char], from: usize) -> usize {
    let mut depth = 0_usize;
    let mut end = from;
    for (index, letter) in letters.iter().enumerate().skip(from) {
        match letter {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            '0'..='9' | '.' | '-' | '+' | '#' | '<' | '>' | ' ' => {}
            '_' | 'a'..='z' if depth > 0 || letters[from..index].contains(&'<') => {}
            _ if depth > 0 => {}
            _ => break,
        }
        if *letter != ' ' {
            end = index + 1;
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(line: &str) -> Vec<String> {
        words_of_line(line)
            .into_iter()
            .map(|word| match word {
                Word::Address(letter, number) => format!("{letter}{number}"),
                Word::Comment(text) => format!("({text})"),
                Word::Skip => "/".to_owned(),
                Word::Tape => "%".to_owned(),
                Word::Statement(text) => format!("<{text}>"),
            })
            .collect()
    }

    #[test]
    fn lines_of_three_controls_fall_into_their_words() {
        for (line, expected) in [
            ("N115 G1G43 H10 Z15 F2000 G9", vec!["N115", "G1", "G43", "H10", "Z15", "F2000", "G9"]),
            (":01", vec![":01"]),
            ("/N5 G0 X-.5", vec!["/", "N5", "G0", "X-.5"]),
            ("g0 x 10. y-2 (to the hole) ; end", vec!["G0", "X10.", "Y-2", "(to the hole)", "(end)"]),
            ("O0001 (PLATE)", vec!["O0001", "(PLATE)"]),
            ("o100 sub", vec!["<o100 sub>"]),
            ("o<hole> call [1]", vec!["<o<hole> call [1]>"]),
            ("#1 = 5", vec!["<#1 = 5>"]),
            ("G1 X[#1 + 2] Y#<depth> F100", vec!["G1", "X[#1+2]", "Y#<depth>", "F100"]),
            ("%", vec!["%"]),
            ("(never closed", vec!["(never closed)"]),
            ("що це", vec!["щ", "о", "ц", "е"]),
        ] {
            assert_eq!(shown(line), expected, "{line}");
        }
    }
}
