//! Random turned parts as the text of their file, so that one that breaks a law is at once a file that shows it.

use std::fmt;
use std::fmt::Write as _;

use proptest::prelude::*;
use technolog::units::Micrometres;

/// An item of an outer contour. All sizes in micrometres.
#[derive(Clone, Copy, Debug)]
pub enum OutlineItem {
    /// So long; fine: ground later.
    Cylinder(i64, bool),
    /// So much up, or down.
    Face(i64),
    /// So much up or down over a length.
    Cone(i64, i64),
    /// A quarter of a circle up or down, hollow or bulging.
    Arc(i64, bool),
    /// After a face up, before a cylinder.
    Chamfer(i64),
    /// So wide and so deep.
    Groove(&'static str, i64, i64),
    /// Down over a length by 20°, along, up a face.
    Neck(i64, i64),
    /// The thread of that number of a list, so long before its relief and a face up.
    Thread(usize, i64),
}

/// Threads: nominal radius, size, width of the relief (`thread-relief`).
const THREADS: [(i64, &str, i64); 5] = [
    (10_000, "M20x1.5", 4_000),
    (15_000, "M30x2", 5_000),
    (20_000, "M40x1.5", 4_000),
    (24_000, "M48x3", 6_000),
    (30_000, "M60x2", 5_000),
];

/// Materials of which parts are turned: steels, stainless steel, grey iron, aluminium, brass.
const MATERIALS: [&str; 6] =
    ["steel-45", "steel-40x", "stainless-12h18n10t", "cast-iron-sch20", "aluminium-d16", "brass-ls59-1"];

/// What a blank is.
#[derive(Clone, Copy, Debug)]
pub enum BlankForm {
    Bar,
    /// A tube, if there is a bore.
    Tube,
    /// A forging whose diameters rise to the chuck.
    Stepped,
    /// A casting in blocks, with upright faces, cones or hollows where they rise.
    Contoured(u8),
}

/// A bore.
#[derive(Clone, Debug)]
pub struct Bore {
    /// So much narrower or wider, so long, and whether by a cone or a face.
    pub steps: Vec<(i64, i64, bool)>,
    /// Whether it goes through.
    pub through: bool,
}

/// A turned part.
#[derive(Clone)]
pub struct TurnedDraft {
    /// Radius of the first face.
    pub start: i64,
    /// Length of the first cylinder.
    pub first: i64,
    /// The outer contour behind the first cylinder.
    pub items: Vec<OutlineItem>,
    /// The bore, if there is one.
    pub bore: Option<Bore>,
    pub kind: BlankForm,
    pub material: &'static str,
    /// Radial stock of the blank, that on its face, and what it is longer.
    pub stock: (i64, i64, i64),
    pub lathe: bool,
    pub centres: bool,
    /// Limiting depth.
    pub depth: Option<i64>,
    /// 0: table, 1: analytic, 2: stated.
    pub allowances: u8,
    pub scheme: Option<&'static str>,
    pub rates: bool,
}

impl fmt::Debug for TurnedDraft {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{}", self.text())
    }
}

fn mm(um: i64) -> Micrometres {
    Micrometres::new(um)
}

/// The outer contour as it is written.
struct OutlineText {
    radius: i64,
    z: i64,
    least: i64,
    lines: Vec<String>,
    /// From, to and the greatest radius between.
    spans: Vec<(i64, i64, i64)>,
    after_cylinder: bool,
    after_face_up: bool,
    /// Length of the last cylinder.
    last: i64,
}

impl OutlineText {
    fn push_line(&mut self, line: String, radius: i64, z: i64) {
        self.spans.push((self.z, z, self.radius.max(radius)));
        self.lines.push(line);
        (self.radius, self.z) = (radius, z);
        (self.after_cylinder, self.after_face_up) = (false, false);
    }

    fn cylinder(&mut self, length: i64, more: &str) {
        let z = self.z + length;
        self.push_line(format!("{{cylinder: {}{more}}}", mm(-z)), self.radius, z);
        self.after_cylinder = true;
        self.last = length;
    }

    fn face(&mut self, radius: i64) {
        let up = radius > self.radius;
        self.push_line(format!("{{face: {}}}", mm(2 * radius)), radius, self.z);
        self.after_face_up = up;
    }

    fn cone(&mut self, radius: i64, length: i64) {
        let z = self.z + length;
        self.push_line(format!("{{cone: {{d: {}, z: {}}}}}", mm(2 * radius), mm(-z)), radius, z);
    }

    fn item(&mut self, item: OutlineItem) {
        let most = 90_000;
        let other = |walk: &Self, by: i64| {
            let radius = walk.radius + by;
            if (walk.least..=most).contains(&radius) { radius } else { walk.radius - by }
        };
        let fits = |walk: &Self, radius: i64| (walk.least..=most).contains(&radius);
        match item {
            OutlineItem::Cylinder(length, fine) => {
                self.cylinder(length, if fine { ", grade: h6, roughness: Ra 0.8" } else { "" });
            }
            OutlineItem::Face(by) if self.after_cylinder => {
                let radius = other(self, by);
                if fits(self, radius) {
                    self.face(radius);
                }
            }
            OutlineItem::Cone(by, length) => {
                let radius = other(self, by);
                if fits(self, radius) {
                    self.cone(radius, length);
                }
            }
            OutlineItem::Arc(by, hollow) => {
                let radius = other(self, by);
                let size = (radius - self.radius).abs();
                if fits(self, radius) && size > 0 {
                    let z = self.z + size;
                    let bulge = if hollow { "in" } else { "out" };
                    let (d, to) = (mm(2 * radius), mm(-z));
                    self.push_line(
                        format!("{{arc: {{d: {d}, z: {to}}}, radius: {}, bulge: {bulge}}}", mm(size)),
                        radius,
                        z,
                    );
                }
            }
            OutlineItem::Chamfer(size) if self.after_face_up && self.radius + size <= most => {
                let z = self.z + size;
                self.push_line(format!("{{chamfer: {}}}", mm(size)), self.radius + size, z);
                self.cylinder(3_000, "");
            }
            OutlineItem::Groove(kind, width, depth) if self.after_cylinder && self.radius - depth >= self.least => {
                let mut line = format!("{{groove: {kind}, width: {}, depth: {}", mm(width), mm(depth));
                if kind == "trapezoid" {
                    line.push_str(", angle: 30");
                }
                line.push('}');
                self.push_line(line, self.radius, self.z + width);
                self.cylinder(4_000, "");
            }
            OutlineItem::Neck(depth, length) if self.radius - depth >= self.least => {
                let (top, radius) = (self.radius, self.radius - depth);
                self.cone(radius, 3 * depth);
                self.cylinder(length, "");
                self.face(top);
                self.cylinder(3_000, "");
            }
            OutlineItem::Thread(which, length) if self.after_cylinder => {
                let fit = THREADS.get(which % THREADS.len()).filter(|(radius, ..)| *radius > self.radius);
                let Some((radius, size, relief)) = fit else { return };
                let (top, z) = (radius + 5_000, self.z + length);
                if fits(self, top) && radius - 3_000 >= self.least {
                    self.face(*radius);
                    self.push_line(format!("{{thread: {size}-6g, to: {}}}", mm(-z)), *radius, z);
                    self.push_line("{groove: thread-relief}".to_owned(), *radius, self.z + relief);
                    self.face(top);
                    self.cylinder(4_000, "");
                }
            }
            _ => {}
        }
    }
}

impl TurnedDraft {
    /// Its file.
    pub fn text(&self) -> String {
        let least = if self.bore.is_some() { 32_000 } else { 6_000 };
        let start = self.start.max(least);
        let mut walk = OutlineText {
            radius: 0,
            z: 0,
            least,
            lines: Vec::new(),
            spans: Vec::new(),
            after_cylinder: false,
            after_face_up: false,
            last: 0,
        };
        // The bore: as wide as the thinnest place of the part allows, except for a wall of 4 mm.
        let widest = |spans: &[(i64, i64, i64)]| spans.iter().map(|span| span.2).max().unwrap_or(0);
        walk.radius = start;
        walk.cylinder(self.first, "");
        for item in &self.items {
            walk.item(*item);
        }
        if !walk.after_cylinder {
            walk.cylinder(5_000, "");
        }
        let (length, most) = (walk.z, widest(&walk.spans));
        let bore = self.bore.as_ref().map(|one| bore(&one.steps, one.through, least - 5_000, length));
        let mouth = bore.as_ref().map_or(0, |bore| bore.0);
        let mut text = format!("shaft: a\nmaterial: {}\n", self.material);
        // A shop saws to length only what ends with a cylinder for the jaws.
        let mut sawn = self.clone();
        if walk.last < 20_000 {
            sawn.stock.2 = sawn.stock.2.max(20_000);
        }
        let _ = writeln!(
            text,
            "blank: {}",
            sawn.blank(&walk.spans, length, most, bore.as_ref().map(|bore| (bore.1, bore.2)))
        );
        if self.lathe {
            text.push_str("machine: 16k20f3\n");
        }
        // Between centres a shop turns shafts: no rings, and no bore that a centre would stand in.
        if self.centres && bore.is_none() && length > 2 * most {
            text.push_str("holding: centres\n");
        }
        let _ = writeln!(text, "outer:\n  - {{from: {{d: {}, z: 0}}}}\n  - {{face: {}}}", mm(2 * mouth), mm(2 * start));
        for line in &walk.lines {
            let _ = writeln!(text, "  - {line}");
        }
        if let Some((.., lines)) = &bore {
            text.push_str("inner:\n");
            for line in lines {
                let _ = writeln!(text, "  - {line}");
            }
        }
        let scheme = self.scheme.map(|scheme| format!("scheme: {scheme}"));
        // Without a lathe nothing else says how deep a pass may be.
        let depth =
            self.depth.or_else(|| (!self.lathe).then_some(2_000)).map(|depth| format!("limiting_depth: {}", mm(depth)));
        let both: Vec<String> = scheme.into_iter().chain(depth).collect();
        if !both.is_empty() {
            let _ = writeln!(text, "roughing: {{{}}}", both.join(", "));
        }
        match self.allowances {
            0 => {}
            1 => text.push_str(
                "allowances: {method: analytic, errors: {rz_um: 50, defect_layer_um: 50, spatial_deviation_um: 80, setup_error_um: 120}}\n",
            ),
            _ => text.push_str("allowances: {method: stated, on_diameter: 0.8, on_face: 0.4}\n"),
        }
        if self.rates {
            text.push_str("rates: {longitudinal_feed: 180, transverse_feed: 150, rapid: 6000}\n");
        }
        text
    }

    /// The blank over spans of the part; of the bore its least radius and whether it goes through.
    fn blank(&self, spans: &[(i64, i64, i64)], length: i64, most: i64, bore: Option<(i64, bool)>) -> String {
        let (over, face, behind) = self.stock;
        let whole = length + face + behind;
        // The greatest radius of the part over a stretch, its ends counted.
        let under = |from: i64, to: i64| {
            let inside = spans.iter().filter(|span| span.0 <= to && span.1 >= from);
            inside.map(|span| span.2).max().unwrap_or(most)
        };
        let bar = |kind: &str, more: &str| {
            let d = mm(2 * (most + over));
            format!("{{kind: {kind}, diameter: {d}, length: {}, face: {}{more}}}", mm(whole), mm(face))
        };
        match (self.kind, bore) {
            (BlankForm::Tube, Some((narrow, true))) => {
                bar("tube", &format!(", bore: {}", mm(2 * (narrow - over.min(3_000)))))
            }
            (BlankForm::Bar | BlankForm::Tube, _) => bar("bar", ""),
            (BlankForm::Stepped, _) => {
                // Three steps of a third each; the last is the blank itself.
                let mut steps = Vec::new();
                for third in 1..3 {
                    let to = length * third / 3;
                    let radius = under(0, to) + over;
                    if radius < most + over {
                        let long = if steps.is_empty() { to + face } else { length / 3 };
                        steps.push((radius, long));
                    }
                }
                // The second begins where the first ends only if both are there.
                let texts: Vec<String> =
                    steps.iter().map(|(r, l)| format!("{{diameter: {}, length: {}}}", mm(2 * r), mm(*l))).collect();
                let more = if texts.is_empty() { String::new() } else { format!(", steps: [{}]", texts.join(", ")) };
                bar("forging", &more)
            }
            (BlankForm::Contoured(shape), _) => {
                let blocks = 4;
                let radii: Vec<i64> =
                    (0..blocks).map(|at| under(length * at / blocks, length * (at + 1) / blocks) + over).collect();
                let mut lines =
                    vec![format!("{{from: {{d: 0, z: {}}}}}", mm(face)), format!("{{face: {}}}", mm(2 * radii[0]))];
                for (at, radius) in radii.iter().enumerate() {
                    let last = at + 1 == radii.len();
                    let at = at as i64;
                    let end = if last { length + behind } else { length * (at + 1) / blocks };
                    let next = radii.get(at as usize + 1).copied().unwrap_or(*radius);
                    let rise = next - radius;
                    if rise > 0 && shape != 0 && rise < length / blocks {
                        lines.push(format!("{{cylinder: {}}}", mm(rise - end)));
                        let (d, z) = (mm(2 * next), mm(-end));
                        lines.push(if shape == 1 {
                            format!("{{cone: {{d: {d}, z: {z}}}}}")
                        } else {
                            format!("{{arc: {{d: {d}, z: {z}}}, radius: {}, bulge: in}}", mm(rise))
                        });
                    } else {
                        lines.push(format!("{{cylinder: {}}}", mm(-end)));
                        if rise != 0 {
                            lines.push(format!("{{face: {}}}", mm(2 * next)));
                        }
                    }
                }
                let mut inner = String::new();
                if let (Some((narrow, true)), true) = (bore, shape != 1) {
                    let d = mm(2 * (narrow - over.min(3_000)));
                    lines[0] = format!("{{from: {{d: {d}, z: {}}}}}", mm(face));
                    inner = format!(
                        ", inner: [{{from: {{d: {d}, z: {}}}}}, {{cylinder: {}}}]",
                        mm(face),
                        mm(-length - behind)
                    );
                }
                format!("{{kind: casting, outer: [{}]{inner}}}", lines.join(", "))
            }
        }
    }
}

/// A bore within a radius: that of its mouth, its least, whether it goes through, and its items.
fn bore(steps: &[(i64, i64, bool)], through: bool, within: i64, length: i64) -> (i64, i64, bool, Vec<String>) {
    // It begins two thirds as wide as it may be.
    let mouth = within * 2 / 3;
    let (mut radius, mut z, mut narrow) = (mouth, 0, mouth);
    let mut lines = vec![format!("{{from: {{d: {}, z: 0}}}}", mm(2 * mouth))];
    let put = |lines: &mut Vec<String>, line: String| lines.push(line);
    let mut flat = false;
    for (by, long, cone) in steps {
        if z + long + 10_000 > length {
            break;
        }
        let other = if (9_000..=within).contains(&(radius + by)) { radius + by } else { radius - by };
        if !(9_000..=within).contains(&other) {
            continue;
        }
        if *cone {
            z += long;
            put(&mut lines, format!("{{cone: {{d: {}, z: {}}}}}", mm(2 * other), mm(-z)));
            flat = false;
        } else {
            if flat && other != radius {
                put(&mut lines, format!("{{face: {}}}", mm(2 * other)));
            } else if other != radius {
                z += 2_000;
                put(&mut lines, format!("{{cylinder: {}}}", mm(-z)));
                put(&mut lines, format!("{{face: {}}}", mm(2 * other)));
            }
            z += long;
            put(&mut lines, format!("{{cylinder: {}}}", mm(-z)));
            flat = true;
        }
        radius = other;
        narrow = narrow.min(radius);
    }
    let end = if through { length } else { z + 4_000 };
    put(&mut lines, format!("{{cylinder: {}}}", mm(-end)));
    if !through {
        put(&mut lines, "{face: 0}".to_owned());
    }
    (mouth, narrow, through, lines)
}

fn item() -> impl Strategy<Value = OutlineItem> {
    let tens = |from: i64, to: i64| (from..to).prop_map(|tens| tens * 10);
    let by = || (50_i64..1_500, any::<bool>()).prop_map(|(tens, up)| if up { tens * 10 } else { -tens * 10 });
    prop_oneof![
        3 => (tens(300, 4_000), prop::bool::weighted(0.2)).prop_map(|(length, fine)| OutlineItem::Cylinder(length, fine)),
        3 => tens(50, 2_000).prop_map(OutlineItem::Face),
        1 => by().prop_map(OutlineItem::Face),
        2 => (by(), tens(200, 3_000)).prop_map(|(by, length)| OutlineItem::Cone(by, length)),
        2 => (by(), any::<bool>()).prop_map(|(by, hollow)| OutlineItem::Arc(by, hollow)),
        1 => tens(50, 300).prop_map(OutlineItem::Chamfer),
        1 => (prop::sample::select(vec!["rectangular", "trapezoid"]), tens(300, 700), tens(30, 110))
            .prop_map(|(kind, width, depth)| OutlineItem::Groove(kind, width, depth)),
        2 => (tens(50, 900), tens(300, 3_000)).prop_map(|(depth, length)| OutlineItem::Neck(depth, length)),
        1 => (0..THREADS.len(), tens(800, 4_000)).prop_map(|(which, length)| OutlineItem::Thread(which, length)),
    ]
}

/// Any part.
pub fn drafts() -> impl Strategy<Value = TurnedDraft> {
    let kind = prop_oneof![
        3 => Just(BlankForm::Bar),
        1 => Just(BlankForm::Tube),
        1 => Just(BlankForm::Stepped),
        2 => (0_u8..3).prop_map(BlankForm::Contoured),
    ];
    let step = (-1_000_i64..600, 300_i64..2_500, prop::bool::weighted(0.3));
    let step = step.prop_map(|(by, long, cone)| (by * 10, long * 10, cone));
    let bore = prop::option::weighted(
        0.4,
        (prop::collection::vec(step, 0..4), prop::bool::weighted(0.7))
            .prop_map(|(steps, through)| Bore { steps, through }),
    );
    let schemes = vec!["loop", "zigzag", "descent", "pick-up", "semi-finishing", "equidistant", "contour"];
    let scheme = prop::option::weighted(0.2, prop::sample::select(schemes));
    // Most blanks have something behind the part to be held by; some are sawn to length, or nearly.
    let behind = prop_oneof![5 => 2_000_i64..7_000, 1 => Just(0_i64), 1 => 0_i64..1_500];
    let stock = (50_i64..800, 0_i64..300, behind).prop_map(|(over, face, behind)| (over * 10, face * 10, behind * 10));
    let how = (
        prop::bool::weighted(0.9),
        prop::bool::weighted(0.3),
        prop::option::weighted(0.6, (50_i64..600).prop_map(|tens| tens * 10)),
        0_u8..3,
        scheme,
        prop::bool::weighted(0.3),
    );
    // Most are of steel 45, so that what fails is told of the shape first.
    let material = prop_oneof![2 => Just(MATERIALS[0]), 3 => prop::sample::select(MATERIALS.to_vec())];
    let kind = (kind, material);
    // Most begin with something long enough for the jaws of the second set-up.
    let first = prop_oneof![1 => 300_i64..1_000, 3 => 1_000_i64..4_000];
    let outside = (600_i64..4_000, first, prop::collection::vec(item(), 1..9));
    (outside, bore, kind, stock, how).prop_map(
        |((start, first, items), bore, (kind, material), stock, (lathe, centres, depth, allowances, scheme, rates))| {
            TurnedDraft {
                start: start * 10,
                first: first * 10,
                items,
                bore,
                kind,
                material,
                stock,
                lathe,
                centres,
                depth,
                allowances,
                scheme,
                rates,
            }
        },
    )
}
