//! Drawings as enhanced metafiles (MS-EMF), the vectors that every Word and LibreOffice shows, also those that know no SVG.
//!
//! A picture is drawn in twentieths of its unit, a unit being a pixel of 96 to the inch, as in HTML.

mod letters;

use crate::svg::{Anchor, At, Colour, Fill, Pen, Picture, Shape};

/// Logical units in a unit of the drawing.
const FINE: f64 = 20.0;
/// Pixels and hundredths of a millimetre of the reference screen, 96 pixels to the inch.
const SCREEN: [i32; 2] = [1920, 1080];
const SCREEN_UM: [i32; 2] = [508_000, 285_750];
/// Objects that every device has.
const NO_BRUSH: u32 = 0x8000_0005;
const NO_PEN: u32 = 0x8000_0008;
/// Handles of our own: the metafile itself is 0.
const PEN: u32 = 1;
const BRUSH: u32 = 2;
const FONT: u32 = 3;
/// The white around letters, in units of the drawing.
const HALO: f64 = 1.3;

/// The metafile of a picture.
pub fn emf(picture: &Picture) -> Vec<u8> {
    let mut file = Metafile::default();
    let (width, height) = (whole(picture.width), whole(picture.height));
    let fine = [scaled(picture.width), scaled(picture.height)];
    // Anisotropic units: window to viewport.
    file.record(17, &[8]);
    file.record(10, &[0, 0]);
    file.record(9, &[fine[0], fine[1]]);
    file.record(12, &[0, 0]);
    file.record(11, &[width, height]);
    // Transparent ground of texts; an area inside an area is a hole.
    file.record(18, &[1]);
    file.record(19, &[1]);
    let mut clipped = false;
    for shape in &picture.shapes {
        match shape {
            Shape::Lines { lines, fill, pen } => file.lines(lines, *fill, pen.as_ref()),
            Shape::Text { at, size, anchor, text } => file.text(*at, *size, *anchor, text),
            Shape::Clip(low, high) => {
                file.record(33, &[]);
                file.record(30, &[scaled(low.0), scaled(low.1), scaled(high.0), scaled(high.1)]);
                clipped = true;
            }
            Shape::Unclip if clipped => {
                file.record(34, &[-1]);
                clipped = false;
            }
            Shape::Unclip => {}
        }
    }
    file.record(14, &[0, 0, 20]);
    file.whole([width, height])
}

#[derive(Default)]
struct Metafile {
    records: Vec<u8>,
    count: u32,
}

impl Metafile {
    /// A record of whole numbers.
    fn record(&mut self, kind: u32, data: &[i32]) {
        let data: Vec<u8> = data.iter().flat_map(|one| one.to_le_bytes()).collect();
        self.bytes(kind, &data);
    }

    /// A record; its length is made a multiple of four.
    fn bytes(&mut self, kind: u32, data: &[u8]) {
        let long = data.len().next_multiple_of(4);
        self.records.extend(kind.to_le_bytes());
        self.records.extend(length(long + 8).to_le_bytes());
        self.records.extend(data);
        self.records.resize(self.records.len() + long - data.len(), 0);
        self.count += 1;
    }

    /// The file: the header, 108 bytes, and the records.
    fn whole(self, [width, height]: [i32; 2]) -> Vec<u8> {
        const HEAD: usize = 108;
        let mut file: Vec<u8> = Vec::with_capacity(HEAD + self.records.len());
        let whole = length(HEAD + self.records.len());
        // In hundredths of a millimetre: 25.4 mm are 96 pixels.
        let frame = |pixels: i32| whole_of(f64::from(pixels) * 2540.0 / 96.0);
        let mut put = |bytes: &[u8]| file.extend(bytes);
        put(&1_u32.to_le_bytes());
        put(&length(HEAD).to_le_bytes());
        for one in [0, 0, width, height, 0, 0, frame(width), frame(height)] {
            put(&one.to_le_bytes());
        }
        put(b" EMF");
        for one in [0x0001_0000, whole, self.count + 1] {
            put(&one.to_le_bytes());
        }
        put(&4_u16.to_le_bytes());
        put(&0_u16.to_le_bytes());
        // No description, no palette.
        [0_u32; 3].iter().for_each(|one| put(&one.to_le_bytes()));
        let millimetres = SCREEN_UM.map(|one| (one + 500) / 1000);
        SCREEN.iter().chain(&millimetres).chain(&[0; 3]).chain(&SCREEN_UM).for_each(|one| put(&one.to_le_bytes()));
        file.extend(self.records);
        file
    }

    fn select(&mut self, object: u32) {
        self.bytes(37, &object.to_le_bytes());
    }

    fn delete(&mut self, object: u32) {
        self.bytes(40, &object.to_le_bytes());
    }

    fn lines(&mut self, lines: &[(Vec<At>, bool)], fill: Fill, pen: Option<&Pen>) {
        if fill != Fill::None {
            let (style, colour) = match fill {
                Fill::Solid(colour) => (0, colour),
                Fill::Hatched(colour) => (2, colour),
                Fill::None => (1, (0, 0, 0)),
            };
            // Hatching 3 rises to the right.
            self.record(39, &[BRUSH.cast_signed(), style, packed(colour), 3]);
            self.select(BRUSH);
            self.select(NO_PEN);
            self.areas(lines);
            self.select(NO_BRUSH);
            self.delete(BRUSH);
        }
        if let Some(pen) = pen {
            let width = scaled(pen.width).max(1);
            self.record(38, &[PEN.cast_signed(), 0, width, 0, packed(pen.colour)]);
            self.select(PEN);
            for (points, closed) in lines {
                let mut points = points.clone();
                points.extend(points.first().copied().filter(|_| *closed));
                for stroke in strokes(&points, &pen.dashes) {
                    self.points(4, &stroke);
                }
            }
            self.select(NO_PEN);
            self.delete(PEN);
        }
    }

    /// All lines as the edges of one area.
    fn areas(&mut self, lines: &[(Vec<At>, bool)]) {
        let lines: Vec<&Vec<At>> = lines.iter().map(|(points, _)| points).filter(|points| points.len() > 2).collect();
        if let [one] = lines.as_slice() {
            return self.points(3, one);
        }
        let counts = lines.iter().map(|points| whole_of_count(points.len()));
        let all = || lines.iter().copied().flatten().copied();
        let mut data = bounds(all()).to_vec();
        data.extend([whole_of_count(lines.len()), whole_of_count(all().count())]);
        data.extend(counts);
        data.extend(all().flat_map(|(x, y)| [scaled(x), scaled(y)]));
        if !lines.is_empty() {
            self.record(8, &data);
        }
    }

    fn points(&mut self, kind: u32, points: &[At]) {
        let mut data = bounds(points.iter().copied()).to_vec();
        data.push(whole_of_count(points.len()));
        data.extend(points.iter().flat_map(|(x, y)| [scaled(*x), scaled(*y)]));
        self.record(kind, &data);
    }

    /// A text, with white around its letters so that lines under it do not disturb.
    fn text(&mut self, at: At, size: f64, anchor: Anchor, text: &str) {
        self.font(size);
        self.select(FONT);
        let align = match anchor {
            Anchor::Start => 0,
            Anchor::End => 2,
            Anchor::Middle => 6,
        };
        self.record(22, &[24 + align]);
        self.record(24, &[packed((255, 255, 255))]);
        for (dx, dy) in [(-HALO, 0.0), (HALO, 0.0), (0.0, -HALO), (0.0, HALO)] {
            self.words((at.0 + dx, at.1 + dy), size, text);
        }
        self.record(24, &[0]);
        self.words(at, size, text);
        // Stock object 13: the font of the system.
        self.select(0x8000_000d);
        self.delete(FONT);
    }

    fn font(&mut self, size: f64) {
        let mut data: Vec<u8> = Vec::with_capacity(324);
        let mut put = |one: i32| data.extend(one.to_le_bytes());
        put(FONT.cast_signed());
        put(-scaled(size));
        [0, 0, 0, 400].iter().for_each(|one| put(*one));
        // Default signs, outlines where there are any, swiss and of different widths.
        data.extend([0, 0, 0, 1, 4, 0, 0, 0x22]);
        let name: Vec<u8> = "Arial".encode_utf16().flat_map(u16::to_le_bytes).collect();
        data.extend(name);
        data.resize(324, 0);
        self.bytes(82, &data);
    }

    fn words(&mut self, at: At, size: f64, text: &str) {
        let letters: Vec<u16> = text.encode_utf16().collect();
        let widths: Vec<i32> = text.chars().flat_map(|sign| steps(sign, size)).collect();
        let string = 76_usize;
        let behind = (string + 2 * letters.len()).next_multiple_of(4);
        let mut data: Vec<u8> = Vec::new();
        let mut put = |one: i32| data.extend(one.to_le_bytes());
        [0, 0, -1, -1].iter().for_each(|one| put(*one));
        put(1);
        // The scale of the page, of no meaning to units that are anisotropic.
        put(1.0_f32.to_bits().cast_signed());
        put(1.0_f32.to_bits().cast_signed());
        put(scaled(at.0));
        put(scaled(at.1));
        put(whole_of_count(letters.len()));
        put(whole_of_count(string));
        put(0);
        [0, 0, -1, -1].iter().for_each(|one| put(*one));
        put(whole_of_count(behind));
        data.extend(letters.iter().flat_map(|one| one.to_le_bytes()));
        data.resize(behind - 8, 0);
        data.extend(widths.iter().flat_map(|one| one.to_le_bytes()));
        self.bytes(84, &data);
    }
}

/// How far each of its codes goes on, in logical units: the second half of a pair nowhere.
fn steps(sign: char, size: f64) -> impl Iterator<Item = i32> {
    let width = scaled(size * letters::width(sign));
    [width, 0].into_iter().take(sign.len_utf16())
}

/// The strokes of a broken line.
fn strokes(points: &[At], dashes: &[f64]) -> Vec<Vec<At>> {
    if dashes.is_empty() || dashes.iter().sum::<f64>() < 0.1 {
        return vec![points.to_vec()];
    }
    let mut all: Vec<Vec<At>> = Vec::new();
    let mut pattern = dashes.iter().copied().cycle();
    let (mut left, mut drawn) = (pattern.next().unwrap_or(1.0), true);
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let long = libm::hypot(to.0 - from.0, to.1 - from.1);
        let at = |gone: f64| (from.0 + (to.0 - from.0) * gone / long, from.1 + (to.1 - from.1) * gone / long);
        let mut gone = 0.0;
        let mut begun = false;
        while gone < long {
            let step = left.min(long - gone);
            if drawn {
                match all.last_mut().filter(|_| begun || gone == 0.0) {
                    Some(stroke) if stroke.last() == Some(&at(gone)) => stroke.push(at(gone + step)),
                    _ => all.push(vec![at(gone), at(gone + step)]),
                }
            }
            begun = true;
            gone += step;
            left -= step;
            if left < 1e-9 {
                left = pattern.next().unwrap_or(1.0);
                drawn = !drawn;
            }
        }
    }
    all
}

fn bounds(points: impl Iterator<Item = At>) -> [i32; 4] {
    points.fold([i32::MAX, i32::MAX, i32::MIN, i32::MIN], |[left, top, right, bottom], (x, y)| {
        let (x, y) = (scaled(x), scaled(y));
        [left.min(x), top.min(y), right.max(x), bottom.max(y)]
    })
}

const fn packed((red, green, blue): Colour) -> i32 {
    i32::from_le_bytes([red, green, blue, 0])
}

fn scaled(value: f64) -> i32 {
    whole_of(value * FINE)
}

fn whole(value: f64) -> i32 {
    whole_of(libm::ceil(value))
}

#[expect(clippy::cast_possible_truncation, reason = "what is outside of the numbers is at their ends")]
fn whole_of(value: f64) -> i32 {
    libm::round(value) as i32
}

fn whole_of_count(count: usize) -> i32 {
    i32::try_from(count).unwrap_or(i32::MAX)
}

fn length(bytes: usize) -> u32 {
    u32::try_from(bytes).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The header says how long the file is, and how many records; each says its length, a multiple of four.
    #[test]
    fn the_records_fill_the_file() {
        let svg = "<svg width=\"40\" height=\"20\"><polyline points=\"1,1 30,1\" fill=\"none\" stroke=\"#333\" \
                   stroke-width=\"1\" stroke-dasharray=\"6 4\"/><text x=\"3\" y=\"9\" font-size=\"12\">Ø10</text></svg>";
        let file = emf(&crate::svg::read(svg));
        let at = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&file[40..44], at(48)), (b" EMF".as_slice(), file.len()));
        let (mut here, mut records, mut last) = (0, 0, 0);
        while here < file.len() {
            last = at(here);
            assert!(at(here + 4) >= 8 && at(here + 4).is_multiple_of(4), "record {records} of kind {last}");
            here += at(here + 4);
            records += 1;
        }
        assert_eq!((here, records, last), (file.len(), at(52), 14));
    }

    #[test]
    fn a_broken_line_has_its_gaps() {
        let strokes = strokes(&[(0.0, 0.0), (8.0, 0.0), (8.0, 8.0)], &[6.0, 4.0]);
        assert_eq!(strokes, [vec![(0.0, 0.0), (6.0, 0.0)], vec![(8.0, 2.0), (8.0, 8.0)]]);
    }
}
