//! Threads as written on drawings, and the hole under each.

use crate::knowledge::diagnostic::nearest;
use crate::knowledge::vocabulary::Operation;
use crate::knowledge::{Knowledge, TableError};
use crate::tables::holes::ThreadAccuracy;
use crate::tables::standards::{CoarseThread, ConicalThread};
use crate::tapping::{self, TapHole};
use crate::units::{Micrometres, Roughness};
use technolog_note::{Note, note};

use super::{Thread, ThreadKind};

/// A thread and the hole that is drilled for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ThreadedHole {
    pub thread: Thread,
    /// Diameter of the hole under the thread, mm.
    pub hole: Micrometres,
}

/// Why a thread cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ThreadError {
    pub code: &'static str,
    pub message: Note,
    pub help: Note,
}

impl ThreadError {
    fn invalid(text: &str, why: Note) -> Self {
        let help = note!("part-write-metric-thread-m-h");
        Self { code: "bad-thread", message: note!("part-no-thread", text = text, why = why), help }
    }

    fn unknown(text: &str, help: Note) -> Self {
        Self { code: "unknown-thread", message: note!("part-unknown-thread", text = text), help }
    }
}

/// Reads `M8-6H`, `M8`, `M8x1-6H`, or conical `К1/2"`, `K 3/4`; Cyrillic letters that look like the Latin
/// ones are read as these.
///
/// The coarse pitch and its tapping hole are those of the table `tap-drills`. The tapping hole of a fine pitch P is
/// the nominal diameter less P, as in ISO practice. Conical threads are those of the table `conical-threads`.
///
/// # Errors
/// It is no thread, or one that the tables do not hold.
pub(super) fn read(text: &str, knowledge: &Knowledge) -> Result<ThreadedHole, ThreadError> {
    let text = text.trim();
    let mut letters = text.chars();
    match letters.next() {
        Some('M' | 'm' | 'М' | 'м') => metric(text, letters.as_str(), knowledge),
        Some('K' | 'k' | 'К' | 'к') => conical(text, letters.as_str(), knowledge),
        _ => Err(ThreadError::invalid(text, note!("part-begins-with-neither-m-nor"))),
    }
}

/// The coarsest roughness that a tap leaves, by table A.3: it applies to a thread whose drawing gives none.
pub(super) fn roughness(knowledge: &Knowledge) -> Result<Roughness, Note> {
    let tapped = |row: &ThreadAccuracy<'_>| row.method == Operation::Tap;
    let row = knowledge.need(Operation::Tap.name(), tapped).map_err(|error| Note::from(&error))?;
    Ok(Roughness::from_ra(row.ra_coarsest))
}

fn metric(text: &str, rest: &str, knowledge: &Knowledge) -> Result<ThreadedHole, ThreadError> {
    let rest: String = rest
        .chars()
        .filter(|letter| !letter.is_whitespace())
        .map(|letter| match letter {
            'х' | 'Х' | 'X' | '×' | '*' => 'x',
            'Н' => 'H',
            '–' | '−' => '-',
            other => other,
        })
        .collect();
    let (sizes, field) = rest.split_once('-').map_or((rest.as_str(), None), |(sizes, field)| (sizes, Some(field)));
    if let Some(field) = field {
        tolerance_field(field).map_err(|why| ThreadError::invalid(text, why))?;
    }
    let (size, pitch) = sizes.split_once('x').map_or((sizes, None), |(size, pitch)| (size, Some(pitch)));
    let length = |figure: &str| figure.parse::<Micrometres>().map_err(|error| ThreadError::invalid(text, error.0));
    let (size, pitch) = (length(size)?, pitch.map(length).transpose()?);
    let lacking = |error: TableError| ThreadError::unknown(text, Note::from(&error));

    let Some(row) = tapping::coarse(size, knowledge).map_err(lacking)? else {
        let known: Vec<CoarseThread<'_>> = knowledge.rows().map_err(lacking)?;
        return Err(ThreadError::unknown(text, nearest_size(size, &known)));
    };
    let coarse = row.pitch;
    let pitch = pitch.unwrap_or(coarse);
    if pitch <= Micrometres::ZERO || pitch > coarse {
        let why = note!("part-pitch-must-above-zero-above", pitch = pitch, coarse = coarse, id = row.thread);
        return Err(ThreadError::invalid(text, why));
    }
    let TapHole { id, drill: hole, .. } = tapping::tap_hole(size, pitch, knowledge).map_err(lacking)?;
    let thread = Thread { written: format!("M{rest}"), kind: ThreadKind::Cylindrical, id, size, pitch };
    Ok(ThreadedHole { thread, hole })
}

/// A tolerance field of an internal thread: `6H`, or one of pitch and one of minor diameter, `4H5H`.
fn tolerance_field(field: &str) -> Result<(), Note> {
    let letters: Vec<char> = field.chars().collect();
    let fits = |letter: fn(&char) -> bool| {
        matches!(letters.len(), 2 | 4)
            && letters.chunks(2).all(|pair| pair[0].is_ascii_digit() && pair.get(1).is_some_and(letter))
    };
    if fits(char::is_ascii_uppercase) {
        Ok(())
    } else if fits(char::is_ascii_lowercase) {
        Err(note!("part-field-bolt-hole-has-capital", field = field))
    } else {
        Err(note!("part-no-tolerance-field-thread-such", field = field))
    }
}

/// The thread of the table with the nearest size, for a remedy.
fn nearest_size(size: Micrometres, known: &[CoarseThread<'_>]) -> Note {
    let named = |row: &CoarseThread<'_>| {
        let known: Micrometres = row.thread.strip_prefix('M')?.parse().ok()?;
        Some(((known - size).abs(), row.thread.to_owned()))
    };
    let known: Vec<(Micrometres, String)> = known.iter().filter_map(named).collect();
    match (known.iter().min_by_key(|(distance, _)| *distance), known.first(), known.last()) {
        (Some((_, near)), Some((_, first)), Some((_, last))) => {
            note!("part-nearest-known-technolog-table-tap", near = near, first = first, last = last)
        }
        _ => note!("part-table-tap-drills-empty"),
    }
}

fn conical(text: &str, rest: &str, knowledge: &Knowledge) -> Result<ThreadedHole, ThreadError> {
    // Inch marks and spaces differ between drawings; the figures do not.
    let figures = |name: &str| -> String {
        name.chars().filter(|letter| letter.is_ascii_digit() || matches!(letter, '/' | '.')).collect()
    };
    if let Some(wrong) = rest.chars().find(|letter| !letter.is_ascii_digit() && !" /.\"'″”“’\u{a0}".contains(*letter))
    {
        return Err(ThreadError::invalid(text, note!("part-does-belong-size-inches", wrong = wrong)));
    }
    let wanted = figures(rest);
    let known: Vec<ConicalThread<'_>> =
        knowledge.rows().map_err(|error| ThreadError::unknown(text, Note::from(&error)))?;
    let Some(row) = known.iter().find(|row| figures(row.thread) == wanted) else {
        let help = match nearest(&format!("K{wanted}"), known.iter().map(|row| row.thread)) {
            Some(near) => note!("part-nearest-known-technolog-table-conical", near = near),
            None => note!("part-technolog-table-conical-threads-lists"),
        };
        return Err(ThreadError::unknown(text, help));
    };
    let thread = Thread {
        written: text.to_owned(),
        kind: ThreadKind::Conical,
        id: row.thread.to_owned(),
        size: row.size,
        pitch: row.pitch,
    };
    Ok(ThreadedHole { thread, hole: row.drill })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::knowledge::SourceFile;
    use crate::shipped;

    #[test]
    fn a_metric_thread_names_its_pitch_and_its_hole() {
        let knowledge = shipped::knowledge().unwrap();
        for (text, written, id, size, pitch, hole) in [
            ("M8-6H", "M8-6H", "M8", 8_000, 1_250, 6_800),
            ("M8", "M8", "M8", 8_000, 1_250, 6_800),
            ("М8х1-6Н", "M8x1-6H", "M8x1", 8_000, 1_000, 7_000),
            (" M 12 × 1.25 - 4H5H", "M12x1.25-4H5H", "M12x1.25", 12_000, 1_250, 10_800),
            ("M8x1.25-7H", "M8x1.25-7H", "M8", 8_000, 1_250, 6_800),
            ("M3", "M3", "M3", 3_000, 500, 2_500),
        ] {
            let read = read(text, &knowledge).unwrap();
            let (size, pitch) = (Micrometres::new(size), Micrometres::new(pitch));
            let thread = Thread { written: written.into(), kind: ThreadKind::Cylindrical, id: id.into(), size, pitch };
            assert_eq!(read, ThreadedHole { thread, hole: Micrometres::new(hole) }, "{text}");
        }
    }

    #[test]
    fn what_is_no_thread_is_refused_with_the_remedy() {
        let knowledge = shipped::knowledge().unwrap();
        for (text, code, words) in [
            ("8", "bad-thread", "neither M nor K"),
            ("M8-6g", "bad-thread", "bolt"),
            ("M8-H", "bad-thread", "tolerance field"),
            ("M8-", "bad-thread", "tolerance field"),
            ("M8x2", "bad-thread", "1.25"),
            ("M8x0", "bad-thread", "above zero"),
            ("M8x-1", "bad-thread", "tolerance field"),
            ("M", "bad-thread", "digits"),
            ("M8,5", "bad-thread", "comma"),
            ("KM", "bad-thread", "inches"),
            ("M9", "unknown-thread", "`M8`"),
            ("M50x1.5", "unknown-thread", "`M48`"),
            ("K77/3", "unknown-thread", "conical-threads"),
        ] {
            let error = read(text, &knowledge).unwrap_err();
            assert_eq!(error.code, code, "{text}");
            let say = |note: &Note| technolog_words::Lang::EN.say(note);
            assert!(format!("{} {}", say(&error.message), say(&error.help)).contains(words), "{error:?}");
        }
    }

    #[test]
    fn a_thread_without_roughness_is_as_rough_as_a_tap_leaves_it() {
        assert_eq!(roughness(&shipped::knowledge().unwrap()).unwrap(), "Ra 6.3".parse().unwrap());
    }

    #[test]
    fn a_conical_thread_is_looked_up_by_its_figures() {
        let table = "table: conical-threads
title: {uk: Р, en: T}
kind: catalog
place: p
result: [drill]
key: [thread]
columns:
  - {name: thread, type: text}
  - {name: size, type: length, unit: mm}
  - {name: pitch, type: length, unit: mm}
  - {name: thread_length, type: length, unit: mm}
  - {name: drill, type: length, unit: mm}
rows:
  - {thread: K1/2, size: 21.223, pitch: 1.814, thread_length: 13.5, drill: 18.5, source: standard}
  - {thread: K1 1/4, size: 41.985, pitch: 2.209, thread_length: 18, drill: 38.5, source: standard}
";
        let knowledge = Knowledge::from_sources(&[SourceFile { path: "catalogs/t.yaml", text: table }]).unwrap();
        for (text, id) in [("К1/2\"", "K1/2"), ("K1/2", "K1/2"), ("К 1/2″", "K1/2"), ("K 1 1/4\"", "K1 1/4")] {
            let read = read(text, &knowledge).unwrap();
            assert_eq!((read.thread.id.as_str(), read.thread.written.as_str()), (id, text));
            assert_eq!(read.thread.kind, ThreadKind::Conical);
        }
        assert_eq!(read("K1/2", &knowledge).unwrap().hole, Micrometres::new(18_500));
        let error = read("K1/3", &knowledge).unwrap_err();
        assert_eq!(error.code, "unknown-thread");
        assert!(technolog_words::Lang::EN.say(&error.help).contains("`K1/2`"), "{error:?}");
    }
}
