//! The legend under the panels: the meaning of the signs, and a scale bar.

use crate::report::Lang;
use crate::report::canvas::{Anchor, At, Canvas, Pen, width_of};
use crate::report::words::say;
use crate::units::Micrometres;

use super::{CLAMP, Frame};

/// The zero of the drawing: a quartered circle.
pub(super) fn zero(canvas: &mut Canvas, (x, y): At) {
    let pen = Pen::solid("#444", 1.0);
    canvas.circle((x, y), 4.5, "white", Some(pen));
    canvas.path(&format!("M{:.2} {y:.2} H{:.2} M{x:.2} {:.2} V{:.2}", x - 8.0, x + 8.0, y - 8.0, y + 8.0), pen);
}

/// The legend with its scale bar; returns its lower end.
pub(super) fn legend(
    canvas: &mut Canvas,
    (x, y): At,
    scale: f64,
    width: f64,
    frame: Option<&Frame<'_>>,
    lang: Lang,
) -> f64 {
    const INK: &str = "#333";
    let framed = frame.is_some();
    canvas.line(&[(x, y), (width - x, y)], Pen::solid("#ccc", 1.0));
    let (mut at, mut row) = (x, y + 22.0);
    let mut entry = |canvas: &mut Canvas, wide: f64, text: &str, sign: &dyn Fn(&mut Canvas, f64, f64)| {
        let long = wide + 6.0 + width_of(text, 11.0);
        if at > x && at + long > width {
            (at, row) = (x, row + 20.0);
        }
        sign(canvas, at, row);
        canvas.text((at + wide + 6.0, row + 4.0), 11.0, Anchor::Start, text);
        at += long + 16.0;
    };
    entry(canvas, 26.0, say!(lang, "drawing-rapid"), &|canvas, at, row| {
        canvas.line(&[(at, row), (at + 26.0, row)], Pen::dashed(INK, 1.0));
    });
    entry(canvas, 26.0, say!(lang, "drawing-feed"), &|canvas, at, row| {
        canvas.line(&[(at, row), (at + 26.0, row)], Pen::solid(INK, 1.6));
    });
    entry(canvas, 8.0, say!(lang, "backplot-plunge"), &|canvas, at, row| {
        canvas.circle((at + 4.0, row), 2.2, INK, None);
    });
    entry(canvas, 10.0, say!(lang, "backplot-tool-change"), &|canvas, at, row| {
        canvas.rectangle((at, row - 5.0), (at + 10.0, row + 5.0), INK, None);
    });
    if framed {
        entry(canvas, 16.0, say!(lang, "backplot-zero"), &|canvas, at, row| zero(canvas, (at + 8.0, row)));
    }
    if frame.is_some_and(|frame| !frame.standing.is_empty()) {
        entry(canvas, 16.0, say!(lang, "backplot-clamp"), &|canvas, at, row| {
            canvas.rectangle((at, row - 5.0), (at + 16.0, row + 5.0), CLAMP, Some(Pen::solid("#7a5c3e", 1.0)));
        });
    }
    // A round length of at most a quarter of the page.
    let room = (width / 4.0).min(200.0) / scale;
    let power = libm::pow(10.0, libm::floor(libm::log10(room)));
    let length = [5.0, 2.0, 1.0].into_iter().map(|step| step * power).find(|length| *length <= room).unwrap_or(power);
    let (bar, row) = (length * scale, row + 24.0);
    canvas.path(
        &format!(
            "M{x:.2} {:.2} V{:.2} M{x:.2} {row:.2} H{:.2} M{:.2} {:.2} V{:.2}",
            row - 4.0,
            row + 4.0,
            x + bar,
            x + bar,
            row - 4.0,
            row + 4.0
        ),
        Pen::solid(INK, 1.2),
    );
    let length = Micrometres::from_mm_rounded(length);
    let text = match framed {
        true => say!(lang, "backplot-scale-of-drawing", length = length),
        false => say!(lang, "backplot-scale-of-machine", length = length),
    };
    canvas.text((x + bar + 8.0, row + 4.0), 11.0, Anchor::Start, &text);
    row
}
