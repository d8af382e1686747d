//! A drawing: SVG for Words that know it, from 2019 on, and the same as a metafile for all others.

use std::fmt::Write as _;

use technolog_document::{Drawing, escaped};

use super::parts::{HEIGHT_MM, WIDTH_MM};
use crate::svg::{self, Picture};

/// English metric units in a pixel of 96 to the inch, and in a millimetre (ECMA-376, part 1, 20.1.2.1).
const EMU_OF_PIXEL: f64 = 9525.0;
const EMU_OF_MM: f64 = 36_000.0;
/// What the caption needs of a page, mm.
const CAPTION_MM: f64 = 20.0;

/// The least scale at which the letters of a drawing, of 9 to 12 pixels, are read without effort.
const LEGIBLE: f64 = 0.72;

/// A drawing in its place.
pub struct Figure<'d> {
    number: usize,
    /// The file as the page has it.
    pub svg: &'d str,
    alternative: &'d str,
    picture: Picture,
}

impl<'d> Figure<'d> {
    /// The drawing with its number in the file.
    pub fn of(drawing: &'d Drawing, number: usize) -> Self {
        let picture = svg::read(&drawing.svg);
        Self { number, svg: &drawing.svg, alternative: &drawing.alternative, picture }
    }

    /// The name of its files, without ending.
    pub fn name(&self) -> String {
        format!("figure{}", self.number)
    }

    /// Its metafile.
    pub fn emf(&self) -> Vec<u8> {
        crate::emf::emf(&self.picture)
    }

    /// Its run: as large as it is, but no larger than a page.
    pub fn xml(&self) -> String {
        let (width, height) = (self.picture.width * EMU_OF_PIXEL, self.picture.height * EMU_OF_PIXEL);
        let room = (WIDTH_MM * EMU_OF_MM, (HEIGHT_MM - CAPTION_MM) * EMU_OF_MM);
        let scale = (room.0 / width.max(1.0)).min(room.1 / height.max(1.0)).min(1.0);
        // Two stand on a page where their letters bear it.
        let half = (HEIGHT_MM / 2.0 - CAPTION_MM) * EMU_OF_MM / height.max(1.0);
        let scale = if half >= LEGIBLE { scale.min(half) } else { scale };
        let (wide, high) = (format!("{:.0}", width * scale), format!("{:.0}", height * scale));
        let (number, name, told) = (self.number, self.name(), escaped(self.alternative));
        format!(
            "<w:r><w:drawing><wp:inline distT=\"0\" distB=\"0\" distL=\"0\" distR=\"0\">\
             <wp:extent cx=\"{wide}\" cy=\"{high}\"/><wp:docPr id=\"{number}\" name=\"{name}\" descr=\"{told}\"/>\
             <a:graphic><a:graphicData uri=\"http://schemas.openxmlformats.org/drawingml/2006/picture\"><pic:pic>\
             <pic:nvPicPr><pic:cNvPr id=\"{number}\" name=\"{name}\" descr=\"{told}\"/><pic:cNvPicPr/></pic:nvPicPr>\
             <pic:blipFill><a:blip r:embed=\"rEmf{number}\"><a:extLst>\
             <a:ext uri=\"{{96DAC541-7B7A-43D3-8B79-37D633B846F1}}\">\
             <asvg:svgBlip xmlns:asvg=\"http://schemas.microsoft.com/office/drawing/2016/SVG/main\" \
             r:embed=\"rSvg{number}\"/></a:ext></a:extLst></a:blip><a:stretch><a:fillRect/></a:stretch></pic:blipFill>\
             <pic:spPr><a:xfrm><a:off x=\"0\" y=\"0\"/><a:ext cx=\"{wide}\" cy=\"{high}\"/></a:xfrm>\
             <a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom></pic:spPr></pic:pic></a:graphicData></a:graphic>\
             </wp:inline></w:drawing></w:r>"
        )
    }
}

/// What the page refers to: its other parts and the files of its drawings.
pub fn relations(figures: &[Figure<'_>]) -> String {
    const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let mut xml = super::parts::HEAD.to_owned();
    xml.push_str("<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">");
    let mut add = |id: &str, kind: &str, target: &str| {
        // Writing to a text cannot fail.
        let _ = write!(xml, "<Relationship Id=\"{id}\" Type=\"{OFFICE}/{kind}\" Target=\"{target}\"/>");
    };
    for (id, kind) in [("rStyles", "styles"), ("rNumbers", "numbering"), ("rSettings", "settings")] {
        add(id, kind, &format!("{kind}.xml"));
    }
    add("rHeader", "header", "header1.xml");
    add("rNoHeader", "header", "header2.xml");
    for figure in figures {
        for (id, ending) in [("rEmf", "emf"), ("rSvg", "svg")] {
            add(&format!("{id}{}", figure.number), "image", &format!("media/{}.{ending}", figure.name()));
        }
    }
    xml.push_str("</Relationships>");
    xml
}
