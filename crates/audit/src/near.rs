//! Designations and standards as people write them: found even if a prefix is missing or a letter is misread.

use std::collections::BTreeMap;

/// The result of looking a name up.
#[derive(Clone, Debug, PartialEq)]
pub enum NameMatch<T> {
    /// No name was stated.
    Unstated,
    /// It is there.
    Found(T),
    /// It is not there as written, but one name is, with its prefix lost or one sign misread.
    Meant(T, String),
    /// It is not there; the most similar name, if any is similar.
    Unknown(Option<String>),
}

impl<T> NameMatch<T> {
    /// The value that was found or clearly meant.
    pub fn value(&self) -> Option<&T> {
        match self {
            Self::Found(found) | Self::Meant(found, _) => Some(found),
            Self::Unstated | Self::Unknown(_) => None,
        }
    }
}

/// A list of names for look-ups, normalised once.
#[derive(Debug)]
pub struct Names<'n, T> {
    all: Vec<(T, &'n str, Vec<char>)>,
    /// The same names without dashes.
    bare: Vec<Vec<char>>,
    /// The indices of each name.
    exact: BTreeMap<Vec<char>, Vec<usize>>,
}

impl<'n, T: Clone> Names<'n, T> {
    /// The names with what they name.
    pub fn new(names: impl Iterator<Item = (&'n str, T)>) -> Self {
        let all: Vec<(T, &str, Vec<char>)> = names.map(|(name, value)| (value, name, plain(name))).collect();
        let mut exact: BTreeMap<Vec<char>, Vec<usize>> = BTreeMap::new();
        for (at, (_, _, name)) in all.iter().enumerate() {
            exact.entry(name.clone()).or_default().push(at);
        }
        let bare = all.iter().map(|(_, _, name)| without_dashes(name)).collect();
        Self { all, bare, exact }
    }

    /// What the names name, in their order.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.all.iter().map(|(value, ..)| value)
    }

    /// The known names that differ in no more than a sign.
    pub fn alike(&self, name: &str) -> impl Iterator<Item = &'n str> {
        let wanted = plain(name);
        self.all
            .iter()
            .filter(move |(_, _, other)| distance_within(&wanted, other, 1).is_some())
            .map(|(_, known, _)| *known)
    }

    /// Looks a name up among those for which `may_be` holds.
    pub fn find(&self, name: Option<&str>, may_be: impl Fn(&T) -> bool) -> NameMatch<T> {
        let Some(name) = name else { return NameMatch::Unstated };
        let wanted = plain(name);
        let mut same = self.exact.get(&wanted).into_iter().flatten().filter_map(|at| self.all.get(*at));
        if let Some((value, ..)) = same.find(|(value, ..)| may_be(value)) {
            return NameMatch::Found(value.clone());
        }
        // Spaces stand for dashes: `035 2300 1273`. Two names that differ by their dashes alone count as equal.
        let bare = without_dashes(&wanted);
        let alike = self.all.iter().zip(&self.bare).filter(|(other, own)| **own == bare && may_be(&other.0));
        let mut spaced = alike.map(|(other, _)| other);
        if let (Some((value, _, first)), true) = (spaced.next(), bare.len() >= 6)
            && spaced.all(|(_, _, other)| other == first)
        {
            return NameMatch::Found(value.clone());
        }
        // The source prints some numbers with an extra zero; the regular form is right too.
        let regular = |(value, _, other): &&(T, &str, Vec<char>)| may_be(value) && has_surplus_zero(other, &wanted);
        let mut regular = self.all.iter().filter(regular);
        if let Some((value, _, first)) = regular.next()
            && regular.all(|(_, _, other)| other == first)
        {
            return NameMatch::Found(value.clone());
        }
        // A tail long enough to distinguish designations.
        let is_tail = |other: &[char]| wanted.len() >= 6 && other.len() > wanted.len() && other.ends_with(&wanted);
        let mut lost = self.all.iter().filter(|(value, _, other)| is_tail(other) && may_be(value));
        if let (Some((value, known, _)), None) = (lost.next(), lost.next()) {
            return NameMatch::Meant(value.clone(), (*known).to_owned());
        }
        let mut best: Option<(usize, &str)> = None;
        for (_, known, other) in self.all.iter().filter(|(value, ..)| may_be(value)) {
            let most = best.map_or(Some(3), |(least, _)| least.checked_sub(1));
            if let Some(away) = most.and_then(|most| distance_within(&wanted, other, most)) {
                best = Some((away, known));
            }
        }
        NameMatch::Unknown(best.map(|(_, known)| known.to_owned()))
    }
}

/// Whether two names of tables are one: `А.18б` of the book is `A.18b` here.
pub fn same_table(a: &str, b: &str) -> bool {
    let folded = |name: &str| -> Vec<char> {
        plain(name).into_iter().map(|letter| if letter == 'Б' { 'B' } else { letter }).collect()
    };
    folded(a) == folded(b)
}

/// Whether two names of schemes are one: 7 is 07.
pub fn same_scheme(a: &str, b: &str) -> bool {
    let bare =
        |name: &str| -> String { plain(name).into_iter().collect::<String>().trim_start_matches('0').to_owned() };
    bare(a) == bare(b)
}

fn without_dashes(name: &[char]) -> Vec<char> {
    name.iter().copied().filter(|letter| *letter != '-').collect()
}

/// Whether a printed name is the regular one with an extra zero in its last number, which has four digits: `00015`
/// for `0015`, `01010` for `0110`.
fn has_surplus_zero(printed: &[char], regular: &[char]) -> bool {
    const DIGITS: usize = 4;
    let last = printed.iter().rposition(|letter| *letter == '-').map_or(0, |dash| dash + 1);
    let is_number = printed[last..].iter().all(char::is_ascii_digit);
    let without = |at: usize| printed[..at].iter().chain(&printed[at + 1..]).eq(regular);
    is_number && printed.len() == last + DIGITS + 1 && (last..printed.len()).any(|at| printed[at] == '0' && without(at))
}

/// Whether a standard is the one meant: as written, or with a sign or two misread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Likeness {
    /// The same.
    Same,
    /// Another in a sign or two of the same number.
    Misread,
    /// Another.
    Other,
}

/// Compares a written standard with the right one. A standard without the type that the catalog adds, `ГОСТ 1672-80`
/// for `ГОСТ 1672-80, тип 2`, is the same.
pub fn likeness(written: &str, right: &str) -> Likeness {
    let (a, b) = (plain(written), plain(right));
    let without_type = right.split_once(',').map(|(number, _)| plain(number));
    if a == b || without_type.as_ref() == Some(&a) {
        Likeness::Same
    } else if distance_within(&a, &b, 2).is_some() {
        Likeness::Misread
    } else {
        Likeness::Other
    }
}

/// A name without spaces, with one kind of dash, and with Latin letters for the Cyrillic ones that look alike.
pub fn plain(name: &str) -> Vec<char> {
    let alike = |letter: char| match letter {
        '–' | '—' | '−' | '‑' => '-',
        'А' | 'а' => 'A',
        'В' | 'в' => 'B',
        'С' | 'с' => 'C',
        'Е' | 'е' => 'E',
        'Н' | 'н' => 'H',
        'К' | 'к' => 'K',
        'М' | 'м' => 'M',
        'О' | 'о' => 'O',
        'Р' | 'р' => 'P',
        'Т' | 'т' => 'T',
        'Х' | 'х' => 'X',
        other => other,
    };
    name.chars().filter(|letter| !letter.is_whitespace()).map(alike).flat_map(char::to_uppercase).collect()
}

/// How far two names are from each other, in signs.
pub fn away(a: &str, b: &str) -> usize {
    distance_within(&plain(a), &plain(b), usize::MAX - 1).unwrap_or(usize::MAX)
}

/// The edit distance of two names, if at most `most`; two neighbours exchanged are one edit (Damerau's distance without repeats).
fn distance_within(a: &[char], b: &[char], most: usize) -> Option<usize> {
    if a.len().abs_diff(b.len()) > most {
        return None;
    }
    // What both begin and end with alike costs nothing, and leaves little to compare.
    let same = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[same..], &b[same..]);
    let same = a.iter().rev().zip(b.iter().rev()).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[..a.len() - same], &b[..b.len() - same]);
    let [mut before, mut above, mut row] = [Vec::new(), Vec::new(), (0..=b.len()).collect::<Vec<usize>>()];
    for (i, sign) in a.iter().enumerate() {
        std::mem::swap(&mut before, &mut above);
        std::mem::swap(&mut above, &mut row);
        row.clear();
        row.push(i + 1);
        for (j, other) in b.iter().enumerate() {
            let changed = above[j] + usize::from(sign != other);
            let mut least = changed.min(row[j] + 1).min(above[j + 1] + 1);
            if i > 0 && j > 0 && *sign == b[j - 1] && a[i - 1] == *other {
                least = least.min(before[j - 1] + 1);
            }
            row.push(least);
        }
        // No path through these rows gets shorter.
        if row.iter().chain(&above).min().is_none_or(|least| *least > most) {
            return None;
        }
    }
    Some(row[b.len()]).filter(|away| *away <= most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lost_prefix_is_found_and_another_number_is_not() {
        let names = ["035-2317-0103", "035-2317-0104", "035-2300-1273"];
        let names = Names::new(names.iter().map(|name| (*name, ())));
        let look = |name: &str| names.find(Some(name), |()| true);
        assert_eq!(look("035 - 2300 – 1273"), NameMatch::Found(()));
        assert_eq!(look("035 2300 1273"), NameMatch::Found(()));
        assert_eq!(look("2317-0103"), NameMatch::Meant((), "035-2317-0103".to_owned()));
        assert_eq!(look("035-2317-0109"), NameMatch::Unknown(Some("035-2317-0103".to_owned())));
        assert_eq!((away("035-2300-1237", "035-2300-1273"), away("2305", "2350"), away("1237", "1723")), (1, 1, 2));
        assert_eq!(names.alike("035-2317-0130").collect::<Vec<_>>(), ["035-2317-0103"]);
        assert_eq!(look("191113040"), NameMatch::Unknown(None));
    }

    #[test]
    fn a_number_without_the_surplus_zero_of_the_print_is_right() {
        let names = ["035-2320-0005", "035-2320-00015", "035-2350-01010"];
        let names = Names::new(names.iter().map(|name| (*name, *name)));
        let look = |name: &str| names.find(Some(name), |_| true);
        assert_eq!(look("035-2320-0015"), NameMatch::Found("035-2320-00015"));
        assert_eq!(look("035-2350-0110"), NameMatch::Found("035-2350-01010"));
        assert_eq!(look("035-2320-005"), NameMatch::Unknown(Some("035-2320-0005".to_owned())));
    }

    #[test]
    fn tables_and_schemes_are_written_in_several_ways() {
        assert!(same_table("А.9", "A.9") && same_table("А.18б", "A.18b") && !same_table("A.9", "A.19"));
        assert!(same_scheme("7", "07") && same_scheme("04 + centre", "4+centre") && !same_scheme("7", "70"));
    }

    #[test]
    fn a_misread_standard_is_told_from_another() {
        assert_eq!(likeness("ОСТ 2420-5-80", "ОСТ 2И20-5-80"), Likeness::Misread);
        assert_eq!(likeness("ТУ 2 – 035 – 986 – 85", "ТУ 2-035-986-85"), Likeness::Same);
        assert_eq!(likeness("ГОСТ 1672-80", "ГОСТ 1672-80, тип 2"), Likeness::Same);
        assert_eq!(likeness("ГОСТ 1672-80, тип 3", "ГОСТ 1672-80, тип 2"), Likeness::Misread);
        assert_eq!(likeness("ГОСТ 10902-77", "ОСТ 2И20-1-80"), Likeness::Other);
    }
}
