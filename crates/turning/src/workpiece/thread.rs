//! A metric thread of a turned surface, as drawings designate it.

use crate::knowledge::Knowledge;
use crate::tapping;
use crate::turning::contour::Side;
use crate::units::Micrometres;

use super::thread_limits::class_of;

/// A thread by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ThreadSize {
    /// As the drawing writes it, in Latin letters.
    pub written: String,
    /// Nominal diameter, mm.
    pub size: Micrometres,
    /// Pitch, mm.
    pub pitch: Micrometres,
    /// The least minor diameter in a bore, that of the basic profile (ISO 965-1); none where its table lacks a constant, which
    /// the planner of a thread in a bore then names.
    pub minor: Option<Micrometres>,
}

impl ThreadSize {
    /// Whether its tolerance class is one of the other side: by ISO 965-1 a lower-case letter is of a thread outside, a
    /// capital letter of one in a bore.
    pub fn has_class_of_other_side(&self, side: Side) -> bool {
        class_of(&self.written).unwrap_or_default().chars().any(|letter| match side {
            Side::Outer => letter.is_ascii_uppercase(),
            Side::Inner => letter.is_ascii_lowercase(),
        })
    }

    /// Whether it may be cut on a diameter: outside on the nominal one; in a bore from the minor diameter on, as long as
    /// something is left of its crests.
    pub fn stands_on(&self, diameter: Micrometres, side: Side) -> bool {
        match side {
            Side::Outer => diameter == self.size,
            Side::Inner => diameter < self.size && self.minor.is_none_or(|minor| diameter >= minor),
        }
    }
}

/// Reads `M36x2`, `M36x2-6g`, `M36`: the coarse pitch and the drill are those of the table `tap-drills`.
///
/// # Errors
/// The code of the mistake: it is no metric thread, a left-hand one, or its coarse pitch is not known.
pub(super) fn read(text: &str, knowledge: &Knowledge) -> Result<ThreadSize, &'static str> {
    let latin = |letter: char| match letter {
        'х' | 'Х' | 'X' | '×' | '*' => 'x',
        'М' | 'м' | 'm' => 'M',
        'Н' => 'H',
        '–' | '−' => '-',
        other => other,
    };
    let written: String = text.chars().filter(|letter| !letter.is_whitespace()).map(latin).collect();
    let rest = written.strip_prefix('M').ok_or("bad-turned-thread")?;
    if rest.contains(',') {
        return Err("turned-thread-comma");
    }
    let (sizes, field) = rest.split_once('-').map_or((rest, None), |(sizes, field)| (sizes, Some(field)));
    if field.is_some_and(|field| !field.starts_with(|first: char| first.is_ascii_digit())) {
        return Err("bad-turned-thread");
    }
    // Passes are planned for right-hand threads alone.
    if rest.split('-').any(|mark| mark.ends_with("LH")) {
        return Err("left-hand-turned-thread");
    }
    let (size, pitch) = sizes.split_once('x').map_or((sizes, None), |(size, pitch)| (size, Some(pitch)));
    let length = |figure: &str| figure.parse::<Micrometres>().map_err(|_| "bad-turned-thread");
    let (size, pitch) = (length(size)?, pitch.map(length).transpose()?);
    let coarse = tapping::coarse(size, knowledge).ok().flatten();
    let pitch = pitch.or(coarse.map(|row| row.pitch)).ok_or("no-coarse-pitch")?;
    // The profile is 0.54 P deep on each side (ISO 68-1), and a core must be left.
    if size <= Micrometres::ZERO || pitch <= Micrometres::ZERO || pitch + pitch >= size {
        return Err("bad-turned-thread");
    }
    let minor = tapping::minor_diameter(size, pitch, knowledge).ok().map(|(least, _)| least);
    Ok(ThreadSize { written, size, pitch, minor })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    /// By ISO 965-1 capital letters are of threads in bores; the hand or the length of engagement may follow the class.
    #[test]
    fn a_class_belongs_to_one_side() {
        let knowledge = shipped::knowledge().unwrap();
        for (text, outside, inside) in [
            ("M30x2-6g", true, false),
            ("M30x2-6H", false, true),
            ("М30х2-6Н", false, true),
            ("M10-4g6g", true, false),
            ("M36x2-6g-30", true, false),
            ("M12-6H-30", false, true),
            ("M10", true, true),
        ] {
            let thread = read(text, &knowledge).unwrap();
            let fits = |side| !thread.has_class_of_other_side(side);
            assert_eq!((fits(Side::Outer), fits(Side::Inner)), (outside, inside), "{text}");
        }
    }

    #[test]
    fn threads_are_read() {
        let knowledge = shipped::knowledge().unwrap();
        for (text, size, pitch, minor) in [
            ("M36x2", 36_000, 2_000, 33_835),
            ("М 36 х 2 - 6g", 36_000, 2_000, 33_835),
            // ISO 724, D1: M6 4.917, M8 6.647, M10 8.376, M12 10.106, M20 17.294, M24 20.752, M30 26.211, M48 42.587, M64 57.505.
            ("M6", 6_000, 1_000, 4_917),
            ("M8", 8_000, 1_250, 6_647),
            ("M10", 10_000, 1_500, 8_376),
            ("M12", 12_000, 1_750, 10_106),
            ("M20", 20_000, 2_500, 17_294),
            ("M24", 24_000, 3_000, 20_752),
            ("M30", 30_000, 3_500, 26_211),
            ("M48", 48_000, 5_000, 42_587),
            ("M64x6", 64_000, 6_000, 57_505),
            ("M200x3", 200_000, 3_000, 196_752),
        ] {
            let named = read(text, &knowledge).unwrap();
            assert_eq!((named.size.micrometres(), named.pitch.micrometres()), (size, pitch), "{text}");
            let within = |micrometres| named.stands_on(Micrometres::new(micrometres), Side::Inner);
            assert!(!within(minor - 1) && within(minor) && within(size - 1) && !within(size), "{text}");
            let on = |micrometres| named.stands_on(Micrometres::new(micrometres), Side::Outer);
            assert!(on(size) && !on(size - 1), "{text}");
        }
        for (text, code) in [
            ("Tr36x6", "bad-turned-thread"),
            ("M", "bad-turned-thread"),
            ("M8x4", "bad-turned-thread"),
            ("M8-g", "bad-turned-thread"),
            ("M30x2,5-6g", "turned-thread-comma"),
            ("M201", "no-coarse-pitch"),
            ("M36x2-6g-LH", "left-hand-turned-thread"),
            ("М36х2LH-6g", "left-hand-turned-thread"),
        ] {
            assert_eq!(read(text, &knowledge).unwrap_err(), code, "{text}");
        }
    }
}
