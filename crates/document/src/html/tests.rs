use super::*;

#[test]
fn names_and_quantities_stay_whole() {
    for (inlines, html) in [
        (Inlines::from("за 2И20-5-80 до"), "за <span>2И20-5-80</span> до"),
        (Inlines::from("one-two"), "one-two"),
        (Inlines::from("t = ").quantity("0,5", "мм"), "t = <span>0,5 мм</span>"),
        (Inlines::sentence("`a<b`: \"c\" & 'd'"), "<code>a&lt;b</code>: &quot;c&quot; &amp; &#39;d&#39;"),
        (Inlines::default().link("a", "b c.html?x=1&y"), "<a href=\"b%20c.html?x=1&amp;y\">a</a>"),
        (Inlines::default().link("a", "javascript:alert(1)"), "a"),
        (Inlines::default().strong("a"), "<strong>a</strong>"),
    ] {
        assert_eq!(line(&inlines), html);
    }
}

#[test]
fn findings_one_after_the_other_are_a_list() {
    let one = |word: &str| Block::Finding(FindingBlock::new(crate::Severity::Note, word, "x"));
    let blocks = vec![one("a"), one("b"), Block::Paragraph("p".into()), one("c")];
    let words = Words { left_out: "", see_all: "", help: "", figure: "" };
    let page = html(&Document { blocks, ..Document::new("uk", "T") }, &words);
    let (_, body) = page.split_once("<main>\n").unwrap();
    let list = "<h1>T</h1>\n<ul class=\"findings\">\n<li class=\"note\"><b>a:</b> x</li>\n\
        <li class=\"note\"><b>b:</b> x</li>\n</ul>\n<p>p</p>\n<ul class=\"findings\">\n<li class=\"note\"><b>c:</b> x</li>\n</ul>\n";
    assert!(body.starts_with(list), "{body}");
    assert!(page.starts_with("<!doctype html>\n<html lang=\"uk\">"), "{page}");
}

#[test]
fn a_drawing_is_an_image_of_its_own() {
    let mut page = String::new();
    let svg = "<svg id=\"a\">Ø#</svg>".to_owned();
    figure(&mut page, &Drawing { svg, caption: "Шлях".into(), alternative: "10 \"точок\"".to_owned() });
    let image = "data:image/svg+xml,%3Csvg%20id=%22a%22%3E%C3%98%23%3C/svg%3E";
    assert_eq!(
        page,
        format!("<figure><img src=\"{image}\" alt=\"10 &quot;точок&quot;\">\n<figcaption>Шлях</figcaption></figure>\n")
    );
}

#[test]
fn the_colours_of_findings_are_the_same_on_every_page() {
    use crate::Severity;
    for severity in [Severity::Error, Severity::Wrong, Severity::Doubtful, Severity::Note] {
        let rule = format!("--{}: {};", severity.name(), severity.colour());
        assert!(STYLE.contains(&rule), "{rule}");
    }
}
