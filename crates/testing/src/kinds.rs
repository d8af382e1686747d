//! A part of many kinds of holes, the same in every run: for the bench and for a test.

/// Holes of each kind.
pub const EACH: usize = 25;

/// A part file of that many kinds, at most 40, each of [`EACH`] holes, on a plate as large as the travels of
/// the ГФ2171: two kinds to a row of fifty holes, 20 mm apart.
pub fn part_of_kinds(kinds: usize) -> String {
    let mut text = String::from(
        "part: P\nmaterial: steel-45\nmachine: gf2171\n\
         blank: {kind: plate, length: 1020, width: 420, thickness: 20}\nholes:\n",
    );
    for kind in 0..kinds {
        let (x, y) = (-490 + 500 * (kind as i64 % 2), -190 + 20 * (kind as i64 / 2));
        text.push_str(&format!(
            "  - {{name: K{kind}, {}, pattern: {{line: {{start: [{x}, {y}], count: {EACH}, step: 20}}}}}}\n",
            keys(kind)
        ));
    }
    text
}

/// The keys of a kind: every element of section 1.1 that fits 20 mm, no two kinds alike.
fn keys(kind: usize) -> String {
    // Small and large of them mixed, so that the first ten cost a quarter of all.
    let round = (kind % 10 + kind / 10) % 4;
    let plain = |diameter: usize, grade: u8, roughness: &str| {
        format!("diameter: {diameter}H{grade}, through: true, roughness: {roughness}, centre_tolerance: 0.2")
    };
    match kind % 10 {
        0 => plain(5 + 2 * round, 12, "Ra 12.5"),
        1 => plain(6 + 2 * round, 9, "Ra 2.5"),
        2 => plain(8 + 2 * round, 7, "Ra 2.5"),
        3 => plain(10 + round, 11, "Rz 40"),
        4 => format!("{}, chamfer: 1", plain(9 + round, 13, "Ra 12.5")),
        5 => {
            let thread = ["M5", "M6", "M8", "M10"][round % 4];
            format!("thread: {thread}, depth: 10, centre_tolerance: 0.3")
        }
        6 => {
            let (hole, wide) = [("7", 11), ("9", 15), ("8", 17), ("10", 18)][round % 4];
            format!(
                "diameter: {hole}H13, through: true, roughness: Ra 12.5, centre_tolerance: 0.2, \
                 counterbore: {{diameter: {wide}, depth: 8}}"
            )
        }
        7 => format!("{}, countersink: {{diameter: {}}}", plain(6 + round, 13, "Ra 12.5"), 12 + round),
        8 => format!(
            "through: true, roughness: Ra 12.5, centre_tolerance: 0.46, \
             steps: [{{diameter: {}, length: 8, bottom: free}}, {{diameter: {}}}]",
            14 + round,
            7 + round
        ),
        _ => {
            format!("diameter: {}H12, depth: 12, roughness: Ra 12.5, centre_tolerance: 0.46", [6, 8, 11, 13][round % 4])
        }
    }
}
