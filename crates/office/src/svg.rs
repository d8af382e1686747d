//! Reads the drawings of our own pages: lines, areas, circles and texts of SVG, as shapes with absolute points. What else
//! SVG has is passed over.

use std::collections::BTreeMap;

/// A point, to the right and down, in units of the drawing.
pub type At = (f64, f64);

/// A colour: red, green, blue.
pub type Colour = (u8, u8, u8);

/// The inside of an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// Nothing.
    None,
    /// A colour.
    Solid(Colour),
    /// Lines in a colour, as metal that is cut.
    Hatched(Colour),
}

/// The pen of a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Pen {
    /// Its colour.
    pub colour: Colour,
    /// Its width.
    pub width: f64,
    /// Lengths of strokes and gaps; none for an unbroken line.
    pub dashes: Vec<f64>,
}

/// Where a text stands at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// To the right of it.
    Start,
    /// On both sides of it.
    Middle,
    /// To the left of it.
    End,
}

/// A piece of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Lines through points, each closed or not, with what is inside.
    Lines {
        /// The lines.
        lines: Vec<(Vec<At>, bool)>,
        /// What is inside.
        fill: Fill,
        /// The pen; none for an area without an edge.
        pen: Option<Pen>,
    },
    /// A text at its base line.
    Text {
        /// Its point.
        at: At,
        /// The size of its letters.
        size: f64,
        /// Where it stands.
        anchor: Anchor,
        /// Its words.
        text: String,
    },
    /// What follows is cut off outside of a rectangle.
    Clip(At, At),
    /// Nothing is cut off any more.
    Unclip,
}

/// A drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
    /// Its shapes, the lowest first.
    pub shapes: Vec<Shape>,
}

/// The shapes of a drawing.
pub fn read(svg: &str) -> Picture {
    let mut picture = Picture::default();
    let (mut hatches, mut clips) = (BTreeMap::new(), BTreeMap::new());
    let mut inside: Option<(&'static str, String)> = None;
    let mut rest = svg;
    while let Some((_, tag)) = rest.split_once('<') {
        let Some((tag, after)) = tag.split_once('>') else { break };
        rest = after;
        let element = Element::of(tag);
        match (element.name, &inside) {
            ("svg", _) => (picture.width, picture.height) = (element.number("width"), element.number("height")),
            ("pattern", _) => inside = Some(("pattern", element.text("id").to_owned())),
            ("clipPath", _) => inside = Some(("clip", element.text("id").to_owned())),
            ("/pattern" | "/clipPath", _) => inside = None,
            ("path", Some(("pattern", id))) => {
                hatches.insert(id.clone(), colour(element.text("stroke")).unwrap_or_default());
            }
            ("rect", Some(("clip", id))) => {
                clips.insert(id.clone(), element.corners());
            }
            (_, Some(_)) => {}
            ("g", _) => {
                let clip = referred(element.text("clip-path")).and_then(|id| clips.get(id));
                picture.shapes.extend(clip.map(|(low, high)| Shape::Clip(*low, *high)));
            }
            ("/g", _) => picture.shapes.push(Shape::Unclip),
            // The white outline of a text is drawn with the text itself.
            ("text", _) if element.text("stroke").is_empty() => {
                let text = after.split_once('<').map_or("", |(text, _)| text);
                picture.shapes.push(Shape::Text {
                    at: (element.number("x"), element.number("y")),
                    size: element.number("font-size"),
                    anchor: match element.text("text-anchor") {
                        "middle" => Anchor::Middle,
                        "end" => Anchor::End,
                        _ => Anchor::Start,
                    },
                    text: unescaped(text),
                });
            }
            _ => picture.shapes.extend(element.lines(&hatches)),
        }
    }
    picture
}

/// An element by its name and attributes.
struct Element<'e> {
    name: &'e str,
    attributes: BTreeMap<&'e str, &'e str>,
}

impl<'e> Element<'e> {
    fn of(tag: &'e str) -> Self {
        let (name, mut rest) = tag.split_once(char::is_whitespace).unwrap_or((tag.trim_end_matches('/'), ""));
        let mut attributes = BTreeMap::new();
        while let Some((key, after)) = rest.split_once("=\"") {
            let Some((value, after)) = after.split_once('"') else { break };
            attributes.insert(key.trim(), value);
            rest = after;
        }
        Self { name, attributes }
    }

    fn text(&self, key: &str) -> &'e str {
        self.attributes.get(key).copied().unwrap_or_default()
    }

    fn number(&self, key: &str) -> f64 {
        self.text(key).parse().unwrap_or_default()
    }

    fn corners(&self) -> (At, At) {
        let low = (self.number("x"), self.number("y"));
        (low, (low.0 + self.number("width"), low.1 + self.number("height")))
    }

    /// Its lines; none for an element that is no line.
    fn lines(&self, hatches: &BTreeMap<String, Colour>) -> Option<Shape> {
        let lines = match self.name {
            "polyline" => vec![(points(self.text("points")), false)],
            "polygon" => vec![(points(self.text("points")), true)],
            "path" => path(self.text("d")),
            "circle" => {
                let (x, y, r) = (self.number("cx"), self.number("cy"), self.number("r"));
                let around = |at: u32| {
                    let angle = f64::from(at) * std::f64::consts::TAU / f64::from(CORNERS);
                    (x + r * libm::cos(angle), y + r * libm::sin(angle))
                };
                vec![((0..CORNERS).map(around).collect(), true)]
            }
            // The white of the page is the paper.
            "rect" if !self.text("width").ends_with('%') => {
                let (low, high) = self.corners();
                vec![(vec![low, (high.0, low.1), high, (low.0, high.1)], true)]
            }
            _ => return None,
        };
        let fill = match (self.text("fill"), referred(self.text("fill"))) {
            (_, Some(id)) => hatches.get(id).map_or(Fill::None, |own| Fill::Hatched(*own)),
            ("", _) => Fill::Solid((0, 0, 0)),
            (name, _) => colour(name).map_or(Fill::None, Fill::Solid),
        };
        let pen = colour(self.text("stroke")).map(|colour| Pen {
            colour,
            width: self.text("stroke-width").parse().unwrap_or(1.0),
            dashes: numbers(self.text("stroke-dasharray")),
        });
        Some(Shape::Lines { lines, fill, pen })
    }
}

/// How many corners a circle has.
const CORNERS: u32 = 48;

/// The id in `url(#id)`.
fn referred(text: &str) -> Option<&str> {
    text.strip_prefix("url(#")?.strip_suffix(')')
}

fn numbers(text: &str) -> Vec<f64> {
    text.split([' ', ',']).filter_map(|one| one.parse().ok()).collect()
}

fn points(text: &str) -> Vec<At> {
    numbers(text).chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
}

/// A colour: `#rgb`, `#rrggbb`, or one of the names that our drawings have.
fn colour(text: &str) -> Option<Colour> {
    match text {
        "white" => return Some((255, 255, 255)),
        "black" => return Some((0, 0, 0)),
        _ => {}
    }
    let digits = text.strip_prefix('#')?;
    let short = digits.len() == 3;
    let digit = |at: usize| u8::from_str_radix(digits.get(at..=at)?, 16).ok();
    let part = |at: usize| {
        let (high, low) = if short { (at, at) } else { (2 * at, 2 * at + 1) };
        Some(digit(high)? * 16 + digit(low)?)
    };
    Some((part(0)?, part(1)?, part(2)?))
}

fn unescaped(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&#39;", "'").replace("&amp;", "&")
}

/// The lines of a path of `M`, `L`, `H`, `V`, `A` and `Z`, all absolute; arcs as chords.
fn path(text: &str) -> Vec<(Vec<At>, bool)> {
    let mut lines: Vec<(Vec<At>, bool)> = Vec::new();
    let mut rest = text.trim();
    while let Some(command) = rest.chars().next() {
        let after = &rest[command.len_utf8()..];
        let end = after.find(|sign: char| sign.is_ascii_alphabetic() && sign != 'e').unwrap_or(after.len());
        let own = numbers(&after[..end]);
        rest = &after[end..];
        let here = lines.last().and_then(|(line, _)| line.last()).copied().unwrap_or_default();
        if command == 'M' {
            lines.push((Vec::new(), false));
        }
        let Some((line, closed)) = lines.last_mut() else { continue };
        match command {
            'M' | 'L' => line.extend(own.chunks_exact(2).map(|pair| (pair[0], pair[1]))),
            'H' => line.extend(own.iter().map(|x| (*x, here.1))),
            'V' => line.extend(own.iter().map(|y| (here.0, *y))),
            'A' => {
                for arc in own.chunks_exact(7) {
                    let from = line.last().copied().unwrap_or(here);
                    line.extend(chords(from, arc[0], (arc[3] != 0.0, arc[4] != 0.0), (arc[5], arc[6])));
                }
            }
            'Z' | 'z' => *closed = true,
            _ => {}
        }
    }
    lines
}

/// The points of an arc of a circle behind its first one; SVG 1.1, appendix F.6.5.
fn chords(from: At, radius: f64, (large, sweep): (bool, bool), to: At) -> Vec<At> {
    let (dx, dy) = ((from.0 - to.0) / 2.0, (from.1 - to.1) / 2.0);
    let half = libm::hypot(dx, dy);
    if half < 1e-9 || radius < 1e-9 {
        return vec![to];
    }
    // A radius that is too small for the chord is half the chord.
    let radius = radius.max(half);
    let high = libm::sqrt((radius * radius - half * half).max(0.0)) / half;
    let side = if large == sweep { -high } else { high };
    let centre = ((from.0 + to.0) / 2.0 + side * dy, (from.1 + to.1) / 2.0 - side * dx);
    let angle = |at: At| libm::atan2(at.1 - centre.1, at.0 - centre.0);
    let (begin, mut turn) = (angle(from), angle(to) - angle(from));
    if sweep && turn < 0.0 {
        turn += std::f64::consts::TAU;
    } else if !sweep && turn > 0.0 {
        turn -= std::f64::consts::TAU;
    }
    let around = |at: u32| {
        let angle = begin + turn * f64::from(at) / f64::from(CORNERS);
        (centre.0 + radius * libm::cos(angle), centre.1 + radius * libm::sin(angle))
    };
    (1..CORNERS).map(around).chain([to]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_goes_through_the_points_that_geometry_says() {
        // Half a circle of radius 10 from (0, 0) to (20, 0): its middle is (10, −10) clockwise on a page.
        let over = chords((0.0, 0.0), 10.0, (false, true), (20.0, 0.0));
        let middle = over[23];
        assert!((middle.0 - 10.0).abs() < 1e-9 && (middle.1 + 10.0).abs() < 1e-9, "{middle:?}");
        // A quarter of it the other way about (0, 10): from (0, 0) to (10, 10), through (7.07, 2.93) when swept.
        let quarter = chords((0.0, 0.0), 10.0, (false, true), (10.0, 10.0));
        assert!((quarter[23].0 - 7.071).abs() < 1e-3 && (quarter[23].1 - 2.929).abs() < 1e-3, "{:?}", quarter[23]);
    }

    #[test]
    fn shapes_are_read_with_their_pens() {
        let svg = "<svg width=\"30\" height=\"20\"><rect width=\"100%\" height=\"100%\" fill=\"white\"/>\
                   <path d=\"M1 2 H5 V7Z\" fill=\"none\" stroke=\"#d55e00\" stroke-width=\"2\" stroke-dasharray=\"6 4\"/>\
                   <text x=\"3\" y=\"4\" font-size=\"12\" text-anchor=\"middle\">a &lt; b</text></svg>";
        let picture = read(svg);
        assert_eq!((picture.width, picture.height), (30.0, 20.0));
        let [Shape::Lines { lines, fill, pen: Some(pen) }, Shape::Text { text, anchor, .. }] =
            picture.shapes.as_slice()
        else {
            panic!("{picture:?}")
        };
        assert_eq!(lines, &[(vec![(1.0, 2.0), (5.0, 2.0), (5.0, 7.0)], true)]);
        assert_eq!((*fill, pen.colour, pen.dashes.as_slice()), (Fill::None, (0xd5, 0x5e, 0), [6.0, 4.0].as_slice()));
        assert_eq!((text.as_str(), *anchor), ("a < b", Anchor::Middle));
    }
}
