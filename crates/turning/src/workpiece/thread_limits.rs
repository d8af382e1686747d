//! The limits of a metric thread: of the pitch diameter, which its flanks make, and outside of the crests too (ISO 965-1,
//! tables `thread-deviations` and `thread-pitch-tolerance`).

use serde::Serialize;

use crate::knowledge::Knowledge;
use crate::knowledge::table::RowRef;
use crate::tables::standards::{ThreadDeviations, ThreadPitchTolerance};
use crate::tables::turning::jobs::ThreadRunOut;
use crate::turning::contour::Side;
use crate::turning::length::Half;
use crate::units::Micrometres;

use super::Thread;
use super::thread::ThreadSize;

/// The limits that a tolerance class gives a diameter of a thread.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ThreadLimits {
    /// The class, such as `6g`.
    #[serde(skip)]
    pub class: String,
    /// The least diameter.
    #[serde(rename = "least_mm")]
    pub least: Micrometres,
    /// The largest diameter.
    #[serde(rename = "most_mm")]
    pub most: Micrometres,
    /// From the basic profile to the nearer limit.
    #[serde(skip)]
    pub deviation: Micrometres,
}

impl ThreadLimits {
    /// Between the limits.
    pub fn tolerance(&self) -> Micrometres {
        self.most - self.least
    }

    /// The diameter in the middle.
    pub fn middle(&self) -> Micrometres {
        Micrometres::new((self.least.micrometres() + self.most.micrometres()) / 2)
    }

    /// The radius in the middle.
    pub fn middle_radius(&self) -> Half {
        Half::radius_of(self.middle())
    }
}

/// D2 = D − 3/4 H (ISO 724), with H = √3/2 · P: 0.649519 P below the nominal diameter.
pub(super) fn basic_pitch_diameter(size: Micrometres, pitch: Micrometres) -> Micrometres {
    Micrometres::new(size.micrometres() - (pitch.micrometres() * 649_519 + 500_000) / 1_000_000)
}

/// The limits of the crests and of the pitch diameter; 6g outside and 6H in a bore where the drawing writes no class, as
/// ISO 965-1 says of medium fits. Crests of a bore are what it was bored to.
pub(super) fn of(
    thread: &ThreadSize,
    side: Side,
    knowledge: &Knowledge,
) -> (Option<ThreadLimits>, Option<ThreadLimits>) {
    let (size, pitch) = (thread.size, thread.pitch);
    let Some(deviations) = deviations(pitch, knowledge) else { return (None, None) };
    let (of_flanks, of_crests) = classes(&thread.written, side);
    let limits = |basic: Micrometres, class: &str, tolerance: Micrometres| {
        let deviation = deviation(class, side, &deviations)?;
        let (least, most) = match side {
            Side::Outer => (basic - deviation - tolerance, basic - deviation),
            Side::Inner => (basic + deviation, basic + deviation + tolerance),
        };
        Some(ThreadLimits { class: class.to_owned(), least, most, deviation })
    };
    let crests = of_crests
        .filter(|_| side == Side::Outer)
        .and_then(|class| limits(size, class, crest_tolerance(class, &deviations)?));
    let flanks = of_flanks.and_then(|class| {
        let tolerance = pitch_tolerance(class, side, &pitch_tolerances(size, pitch, knowledge)?)?;
        limits(basic_pitch_diameter(size, pitch), class, tolerance)
    });
    (crests, flanks)
}

/// The row of the longest run-out of a thread; for a pitch between two of the table that of the finer one, which is shorter.
pub fn longest_run_out(side: Side, pitch: Micrometres, knowledge: &Knowledge) -> Option<ThreadRunOut<'_>> {
    let rows = knowledge.rows::<ThreadRunOut<'_>>().ok()?;
    rows.into_iter().filter(|row| row.side == side && row.pitch <= pitch).max_by_key(|row| row.pitch)
}

/// A row behind the limits of a thread.
#[derive(Clone, Copy, Debug)]
pub enum ToleranceRow<'k> {
    /// Of the deviation.
    Deviation(RowRef<'k>),
    /// Of the tolerance of the pitch diameter.
    Pitch(RowRef<'k>),
}

/// The rows behind the limits of the pitch diameter.
pub fn tolerance_rows<'k>(thread: &Thread, knowledge: &'k Knowledge) -> Vec<ToleranceRow<'k>> {
    let deviation = deviations(thread.pitch, knowledge).map(|row| ToleranceRow::Deviation(row.row));
    let pitch = pitch_tolerances(thread.size, thread.pitch, knowledge).map(|row| ToleranceRow::Pitch(row.row));
    deviation.into_iter().chain(pitch).collect()
}

fn deviations(pitch: Micrometres, knowledge: &Knowledge) -> Option<ThreadDeviations<'_>> {
    knowledge.find(|row: &ThreadDeviations<'_>| row.pitch == pitch).ok().flatten()
}

fn pitch_tolerances(size: Micrometres, pitch: Micrometres, knowledge: &Knowledge) -> Option<ThreadPitchTolerance<'_>> {
    let is_of = |row: &ThreadPitchTolerance<'_>| row.over < size && size <= row.up_to && row.pitch == pitch;
    knowledge.find(is_of).ok().flatten()
}

/// The tolerance class of a designation: `6g` of `M36x2-6g-LH`. The length of engagement or the hand, which may follow, are
/// left out.
pub(super) fn class_of(written: &str) -> Option<&str> {
    written.split('-').nth(1)
}

/// The classes of the pitch diameter and of the crests: `5g6g` has two, `6g` one for both.
fn classes(written: &str, side: Side) -> (Option<&str>, Option<&str>) {
    let medium = if side == Side::Outer { "6g" } else { "6H" };
    let field = class_of(written).unwrap_or(medium);
    match field.len() {
        2 => (Some(field), Some(field)),
        4 => (field.get(..2), field.get(2..)),
        _ => (None, None),
    }
}

/// How far the nearer limit of a class lies from the basic profile, into the metal.
fn deviation(class: &str, side: Side, row: &ThreadDeviations<'_>) -> Option<Micrometres> {
    match (side, class.get(1..)?) {
        (Side::Outer, "h") | (Side::Inner, "H") => Some(Micrometres::ZERO),
        (Side::Outer, "g") | (Side::Inner, "G") => Some(row.g),
        (Side::Outer, "f") => Some(row.f),
        (Side::Outer, "e") => Some(row.e),
        _ => None,
    }
}

fn crest_tolerance(class: &str, row: &ThreadDeviations<'_>) -> Option<Micrometres> {
    match class.get(..1)? {
        "4" => Some(row.crest_4),
        "6" => Some(row.crest_6),
        "8" => row.crest_8,
        _ => None,
    }
}

fn pitch_tolerance(class: &str, side: Side, row: &ThreadPitchTolerance<'_>) -> Option<Micrometres> {
    match (side, class.get(..1)?) {
        (Side::Outer, "4") => Some(row.outer_4),
        (Side::Outer, "5") => Some(row.outer_5),
        (Side::Outer, "6") => Some(row.outer_6),
        (Side::Outer, "7") => Some(row.outer_7),
        (Side::Outer, "8") => row.outer_8,
        (Side::Inner, "4") => Some(row.inner_4),
        (Side::Inner, "5") => Some(row.inner_5),
        (Side::Inner, "6") => Some(row.inner_6),
        (Side::Inner, "7") => Some(row.inner_7),
        (Side::Inner, "8") => row.inner_8,
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::thread::read;
    use super::*;
    use crate::shipped;

    fn limits(written: &str, side: Side) -> (Option<[i64; 2]>, Option<[i64; 2]>) {
        let knowledge = shipped::knowledge().unwrap();
        let (crests, flanks) = of(&read(written, &knowledge).unwrap(), side, &knowledge);
        let both = |limits: Option<ThreadLimits>| limits.map(|one| [one.least, one.most].map(Micrometres::micrometres));
        (both(crests), both(flanks))
    }

    /// Limits of the major and of the pitch diameter, µm, as ISO 965-2 and charts by ASME B1.13M have them: M6, M8 and M10
    /// by scribd.com/document/604040407; M72x2, M75x1.5, M80x6 and M95x2 by Machinery's Handbook, 27th ed., p. 1802.
    #[test]
    fn limits_outside_are_those_of_the_published_tables() {
        for (written, crests, flanks) in [
            ("M6-6g", [5_794, 5_974], [5_212, 5_324]),
            ("M6-4g6g", [5_794, 5_974], [5_253, 5_324]),
            ("M8", [7_760, 7_972], [7_042, 7_160]),
            ("M10-6g", [9_732, 9_968], [8_862, 8_994]),
            ("M10-4g6g", [9_732, 9_968], [8_909, 8_994]),
            ("M12-6g", [11_701, 11_966], [10_679, 10_829]),
            ("M20x1.5-6g", [19_732, 19_968], [18_854, 18_994]),
            ("M20-6h", [19_665, 20_000], [18_206, 18_376]),
            ("M30x2-6g", [29_682, 29_962], [28_493, 28_663]),
            ("M72x2-6g", [71_682, 71_962], [70_483, 70_663]),
            ("M75x1.5-4g6g", [74_732, 74_968], [73_894, 73_994]),
            ("M80x6-6g", [79_320, 79_920], [75_743, 76_023]),
            ("M95x2-6g", [94_682, 94_962], [93_473, 93_663]),
        ] {
            let found = limits(written, Side::Outer);
            // The tables round diameters by themselves: 1 µm.
            let near = |found: Option<[i64; 2]>, wanted: [i64; 2]| {
                found.is_some_and(|found| found.iter().zip(wanted).all(|(one, wanted)| (one - wanted).abs() <= 1))
            };
            assert!(near(found.0, crests) && near(found.1, flanks), "{written}: {found:?}");
        }
    }

    /// Limits of the pitch diameter in a bore: M10x1.25 to M14x2 by engineersedge.com, metric-internal-thread-sizes1 (ASME
    /// B1.13M); the tolerance of M36x2, 0.224, by scribd.com/document/177953705, of M24x2 the same; G is by 38 above H.
    #[test]
    fn limits_in_a_bore_are_those_of_the_published_tables() {
        for (written, flanks) in [
            ("M10x1.25-6H", [9_188, 9_348]),
            ("M12x1.5", [11_026, 11_216]),
            ("M14x2-6H", [12_701, 12_913]),
            ("M24x2-6H", [22_701, 22_925]),
            ("M36x2-6G", [34_739, 34_963]),
        ] {
            assert_eq!(limits(written, Side::Inner), (None, Some(flanks)), "{written}");
        }
    }

    #[test]
    fn other_classes_and_threads_are_not_guessed() {
        assert_eq!(limits("M10-7g7d", Side::Outer), (None, Some([8_824, 8_994])), "crests have grades 4, 6 and 8");
        assert_eq!(limits("M10-6", Side::Outer), (None, None));
        assert_eq!(limits("M10-6H", Side::Outer), (None, None));
        assert_eq!(limits("M10-6g", Side::Inner), (None, None));
        assert_eq!(limits("M20x3-6g", Side::Outer).1, None, "the standard has no pitch of 3 for 20 mm");
        assert_eq!(limits("M36x2.1", Side::Outer), (None, None));
    }

    /// ISO 965-1 gives the formulas that its tables round to preferred numbers, µm: a figure that was read wrongly would be a
    /// step of the series, 6 %, off or more.
    #[test]
    fn the_tables_are_the_formulas_of_the_standard_rounded() {
        let knowledge = shipped::knowledge().unwrap();
        let near = |figure: Micrometres, formula: f64| {
            let ratio = figure.to_mm() * 1000.0 / formula;
            assert!((0.945..1.06).contains(&ratio), "{figure} for {formula}");
        };
        for row in knowledge.rows::<ThreadDeviations<'_>>().unwrap() {
            let pitch = row.pitch.to_mm();
            near(row.g, 15.0 + 11.0 * pitch);
            near(row.f, 30.0 + 11.0 * pitch);
            // The smallest pitches have less.
            if pitch > 0.65 {
                near(row.e, 50.0 + 11.0 * pitch);
            }
            let six = 180.0 * libm::cbrt(pitch * pitch) - 3.15 / libm::sqrt(pitch);
            near(row.crest_6, six);
            near(row.crest_4, 0.63 * six);
            row.crest_8.into_iter().for_each(|figure| near(figure, 1.6 * six));
        }
        for row in knowledge.rows::<ThreadPitchTolerance<'_>>().unwrap() {
            let mean = libm::sqrt(row.over.to_mm() * row.up_to.to_mm());
            let six = 90.0 * libm::pow(row.pitch.to_mm(), 0.4) * libm::pow(mean, 0.1);
            let outer = [Some(row.outer_4), Some(row.outer_5), Some(row.outer_6), Some(row.outer_7), row.outer_8];
            let inner = [Some(row.inner_4), Some(row.inner_5), Some(row.inner_6), Some(row.inner_7), row.inner_8];
            for (figure, ratio) in outer.into_iter().zip([0.63, 0.8, 1.0, 1.25, 1.6]) {
                figure.into_iter().for_each(|figure| near(figure, ratio * six));
            }
            for (figure, ratio) in inner.into_iter().zip([0.85, 1.06, 1.32, 1.7, 2.12]) {
                figure.into_iter().for_each(|figure| near(figure, ratio * six));
            }
        }
    }
}
