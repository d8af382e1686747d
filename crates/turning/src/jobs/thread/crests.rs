//! The turned diameter of an outer thread's cylinder: the tolerance of the crests is below the nominal diameter (ISO
//! 965-1).

use crate::turning::length::Half;
use crate::turning::workpiece::Thread;
use crate::units::Micrometres;

/// The limits of the crests by the tolerance class of an outer thread.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Crests {
    /// The class of the crests, such as `6g`.
    pub class: String,
    /// The least diameter, to 0.01 mm inwards.
    pub least: Micrometres,
    /// The largest diameter, to 0.01 mm inwards.
    pub most: Micrometres,
}

impl Crests {
    /// The crests of an outer thread; 6g if the drawing gives no class, as ISO 965-1 says of medium fits. None for a
    /// class that these formulas do not cover.
    ///
    /// ISO 965-1: the fundamental deviation es is 0 for h, −(15 + 11 P) µm for g, −(30 + 11 P) for f, −(50 + 11 P) for e;
    /// the tolerance of grade 6 is Td = 180·P^(2/3) − 3.15/√P µm, of grade 4 it is 0.63 of that, of grade 8 1.6 of that.
    pub fn of(thread: &Thread) -> Option<Self> {
        // The class of the pitch diameter may precede that of the crests.
        let field = classes(thread);
        let class = field.get(field.len().checked_sub(2)?..)?;
        let pitch = thread.pitch.to_mm();
        let (upper, share) = deviation(class, pitch)?;
        let tolerance = share * (180.0 * libm::cbrt(pitch * pitch) - 3.15 / libm::sqrt(pitch));
        let size = thread.size.to_mm() * 1000.0;
        let hundredth = |um: f64| Micrometres::new(um as i64 * 10);
        let least = hundredth(libm::ceil((size + upper - tolerance) / 10.0));
        let most = hundredth(libm::floor((size + upper) / 10.0));
        Some(Self { class: class.to_owned(), least, most })
    }

    /// How much the pitch diameter in the middle of its tolerance is below the basic profile, where pitch and crests
    /// have one class. ISO 965-1: the pitch diameter has the same es, and its tolerance of grade 6 is Td2 =
    /// 90·P^0.4·d^0.1 µm (d of the thread for the mean of its range: within 3 %), of grades 4 and 8 the same shares.
    pub fn pitch_below(thread: &Thread) -> Option<Micrometres> {
        let class = Some(classes(thread)).filter(|class| class.len() == 2)?;
        let (upper, share) = deviation(class, thread.pitch.to_mm())?;
        let tolerance = share * 90.0 * libm::pow(thread.pitch.to_mm(), 0.4) * libm::pow(thread.size.to_mm(), 0.1);
        Some(Micrometres::from_mm_rounded(libm::round((tolerance / 2.0 - upper) / 10.0) / 100.0))
    }

    /// The diameter in the middle of the limits.
    pub fn middle(&self) -> Micrometres {
        Micrometres::new((self.least.micrometres() + self.most.micrometres()) / 2)
    }

    /// The radius in the middle of the limits.
    pub fn middle_radius(&self) -> Half {
        Half::radius_of(self.middle())
    }
}

/// The tolerance classes of a thread as on the drawing, 6g if it gives none; without the length of engagement, which
/// comes last.
fn classes(thread: &Thread) -> &str {
    let written = thread.written.split_once('-').map_or("6g", |(_, classes)| classes);
    written.split_once('-').map_or(written, |(classes, _)| classes)
}

/// The fundamental deviation es of a class, µm, and the ratio of its grade's tolerances to those of grade 6.
fn deviation(class: &str, pitch: f64) -> Option<(f64, f64)> {
    let upper = match class.get(1..)? {
        "h" => 0.0,
        "g" => -(15.0 + 11.0 * pitch),
        "f" => -(30.0 + 11.0 * pitch),
        "e" => -(50.0 + 11.0 * pitch),
        _ => return None,
    };
    let share = match class.get(..1)? {
        "4" => 0.63,
        "6" => 1.0,
        "8" => 1.6,
        _ => return None,
    };
    Some((upper, share))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crests(written: &str, size: i64, pitch: i64) -> Option<Crests> {
        let (size, pitch) = (Micrometres::new(size), Micrometres::new(pitch));
        Crests::of(&Thread { surface: String::new(), written: written.to_owned(), size, pitch })
    }

    /// The limits of the major diameter by the tables of ISO 965-2, µm, which round es and Td to preferred numbers: up to 6 µm away, beside the hundredth.
    #[test]
    fn limits_are_those_of_iso_965_2_to_a_hundredth() {
        for (written, size, pitch, least, most) in [
            ("M6-6g", 6_000, 1_000, 5_794, 5_974),
            ("M8", 8_000, 1_250, 7_760, 7_972),
            ("M10-6g", 10_000, 1_500, 9_732, 9_968),
            ("M12-6g", 12_000, 1_750, 11_701, 11_966),
            ("M20-6g", 20_000, 2_500, 19_623, 19_958),
            ("M30x2-6g", 30_000, 2_000, 29_682, 29_962),
            ("M20-6h", 20_000, 2_500, 19_665, 20_000),
            ("M10-5g6g", 10_000, 1_500, 9_732, 9_968),
        ] {
            let found = crests(written, size, pitch).unwrap();
            let [low, high] = [found.least.micrometres() - least, found.most.micrometres() - most];
            assert!((-3..=16).contains(&low) && (-10..=3).contains(&high), "{written}: {found:?}");
            assert!(least < found.middle().micrometres() && found.middle().micrometres() < most, "{written}");
        }
    }

    /// Tables of ISO 965-2: d2 of M30x2-6g is 28.663 to 28.493, 0.123 below the basic 28.701 in the middle; of M10-6g 8.994 to
    /// 8.862, 0.098 below 9.026.
    #[test]
    fn the_pitch_diameter_lies_below_the_basic_profile() {
        for (written, size, pitch, below) in [("M30x2-6g", 30_000, 2_000, 120), ("M10-6g", 10_000, 1_500, 100)] {
            let (size, pitch) = (Micrometres::new(size), Micrometres::new(pitch));
            let thread = Thread { surface: String::new(), written: written.to_owned(), size, pitch };
            assert_eq!(Crests::pitch_below(&thread), Some(Micrometres::new(below)), "{written}");
        }
    }

    #[test]
    fn other_classes_are_not_guessed() {
        assert_eq!(crests("M10-7g7d", 10_000, 1_500), None);
        assert_eq!(crests("M10-6", 10_000, 1_500), None);
        assert_eq!(crests("M10-6H", 10_000, 1_500), None);
    }
}
