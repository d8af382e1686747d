//! The files of a package that do not depend on what a page is about.

/// The head of an XML file.
pub const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";

/// What a page upright has between its margins, mm: A4 without 20 at left and 10 at right (DSTU 3008), and 20 above and below.
pub const WIDTH_MM: f64 = 180.0;
/// Its height, mm.
pub const HEIGHT_MM: f64 = 257.0;
/// The width of a page across, mm.
pub const LONG_MM: f64 = 267.0;

const MAIN: &str = "http://schemas.openxmlformats.org/wordprocessingml/2006/main";

pub const CONTENT_TYPES: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n\
<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
<Default Extension=\"xml\" ContentType=\"application/xml\"/>\
<Default Extension=\"svg\" ContentType=\"image/svg+xml\"/>\
<Default Extension=\"emf\" ContentType=\"image/x-emf\"/>\
<Override PartName=\"/word/document.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.wordprocessingml.document.main+xml\"/>\
<Override PartName=\"/word/styles.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.wordprocessingml.styles+xml\"/>\
<Override PartName=\"/word/numbering.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.wordprocessingml.numbering+xml\"/>\
<Override PartName=\"/word/settings.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.wordprocessingml.settings+xml\"/>\
<Override PartName=\"/word/header1.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.wordprocessingml.header+xml\"/>\
<Override PartName=\"/word/header2.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.wordprocessingml.header+xml\"/>\
<Override PartName=\"/docProps/core.xml\" ContentType=\"application/vnd.openxmlformats-package.core-properties+xml\"/>\
</Types>";

pub const RELATIONS: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n\
<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
<Relationship Id=\"rDocument\" Type=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument\" Target=\"word/document.xml\"/>\
<Relationship Id=\"rCore\" Type=\"http://schemas.openxmlformats.org/package/2006/relationships/metadata/core-properties\" Target=\"docProps/core.xml\"/>\
</Relationships>";

/// Settings of Word 2013 and later: without them it opens a file in the mode of an older one.
pub const SETTINGS: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n\
<w:settings xmlns:w=\"http://schemas.openxmlformats.org/wordprocessingml/2006/main\"><w:compat>\
<w:compatSetting w:name=\"compatibilityMode\" w:uri=\"http://schemas.microsoft.com/office/word\" w:val=\"15\"/>\
</w:compat></w:settings>";

/// The number of a page, at the top on the right.
pub const HEADER: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n\
<w:hdr xmlns:w=\"http://schemas.openxmlformats.org/wordprocessingml/2006/main\"><w:p><w:pPr><w:pStyle w:val=\"Header\"/></w:pPr>\
<w:r><w:fldChar w:fldCharType=\"begin\"/></w:r><w:r><w:instrText xml:space=\"preserve\"> PAGE </w:instrText></w:r>\
<w:r><w:fldChar w:fldCharType=\"separate\"/></w:r><w:r><w:t>1</w:t></w:r><w:r><w:fldChar w:fldCharType=\"end\"/></w:r></w:p></w:hdr>";

/// Nothing at the top.
pub const NO_HEADER: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n\
<w:hdr xmlns:w=\"http://schemas.openxmlformats.org/wordprocessingml/2006/main\"><w:p><w:pPr><w:pStyle w:val=\"Nothing\"/></w:pPr></w:p></w:hdr>";

/// Title and language, both escaped.
pub fn properties(title: &str, lang: &str) -> String {
    format!(
        "{HEAD}<cp:coreProperties xmlns:cp=\"http://schemas.openxmlformats.org/package/2006/metadata/core-properties\" \
         xmlns:dc=\"http://purl.org/dc/elements/1.1/\"><dc:title>{title}</dc:title><dc:language>{lang}</dc:language>\
         </cp:coreProperties>"
    )
}

/// The page around its contents.
pub fn document(body: &str) -> String {
    format!(
        "{HEAD}<w:document xmlns:w=\"{MAIN}\" \
         xmlns:r=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships\" \
         xmlns:wp=\"http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing\" \
         xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" \
         xmlns:pic=\"http://schemas.openxmlformats.org/drawingml/2006/picture\"><w:body>{body}</w:body></w:document>"
    )
}

/// How pages lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    /// A4 upright.
    Upright,
    /// A4 across, for wide tables.
    Across,
    /// A4 across with the frame of a form, 286 mm wide,.
    Form,
}

/// The paper of the pages up to here.
pub fn section(paper: Paper) -> String {
    // In twentieths of a point: 210 and 297 mm; the margins keep their sides of the sheet that is bound at the left.
    let size = match paper {
        Paper::Upright => "<w:pgSz w:w=\"11906\" w:h=\"16838\"/>",
        Paper::Across | Paper::Form => "<w:pgSz w:w=\"16838\" w:h=\"11906\" w:orient=\"landscape\"/>",
    };
    // A form has its frame where other pages have their numbers.
    let (header, [top, right, bottom, left]) = match paper {
        Paper::Form => ("rNoHeader", [340, 284, 227, 284]),
        Paper::Upright | Paper::Across => ("rHeader", [1134, 567, 1134, 1134]),
    };
    format!(
        "<w:sectPr><w:headerReference w:type=\"default\" r:id=\"{header}\"/>{size}\
         <w:pgMar w:top=\"{top}\" w:right=\"{right}\" w:bottom=\"{bottom}\" w:left=\"{left}\" w:header=\"227\" \
         w:footer=\"227\" w:gutter=\"0\"/></w:sectPr>"
    )
}

/// A style of paragraphs: its name, the style that it comes of, and what it has of its own.
type Style = (&'static str, &'static str, &'static str, &'static str, &'static str);

/// 14 points and 1.5 lines for running text (DSTU 3008), one line elsewhere.
const STYLES: [Style; 15] = [
    (
        "BodyText",
        "Body Text",
        "Normal",
        "<w:spacing w:line=\"360\" w:lineRule=\"auto\"/><w:ind w:firstLine=\"709\"/><w:jc w:val=\"both\"/>",
        "",
    ),
    (
        "Title",
        "Title",
        "Normal",
        "<w:keepNext/><w:spacing w:after=\"240\"/><w:jc w:val=\"center\"/>",
        "<w:b/><w:sz w:val=\"32\"/>",
    ),
    (
        "Field",
        "Field",
        "Normal",
        "<w:spacing w:line=\"360\" w:lineRule=\"auto\"/><w:ind w:left=\"709\" w:hanging=\"709\"/>",
        "",
    ),
    ("ListBullet", "List Bullet", "Normal", "<w:spacing w:line=\"360\" w:lineRule=\"auto\"/>", ""),
    ("TableText", "Table Text", "Normal", "", "<w:sz w:val=\"20\"/>"),
    ("TableHead", "Table Head", "TableText", "<w:keepNext/><w:jc w:val=\"center\"/>", "<w:b/>"),
    ("Note", "Note", "Normal", "<w:spacing w:before=\"60\" w:after=\"60\"/>", "<w:sz w:val=\"24\"/>"),
    ("Figure", "Figure", "Normal", "<w:spacing w:before=\"120\"/><w:jc w:val=\"center\"/>", ""),
    ("Caption", "caption", "Normal", "<w:spacing w:before=\"120\" w:after=\"240\"/><w:jc w:val=\"center\"/>", ""),
    (
        "Code",
        "Code",
        "Normal",
        "",
        "<w:rFonts w:ascii=\"Courier New\" w:hAnsi=\"Courier New\" w:cs=\"Courier New\"/><w:sz w:val=\"20\"/>",
    ),
    ("Break", "Break", "Normal", "", "<w:sz w:val=\"12\"/>"),
    ("FormText", "Form Text", "Normal", "", "<w:sz w:val=\"16\"/>"),
    ("FormMark", "Form Mark", "Normal", "<w:jc w:val=\"right\"/>", "<w:sz w:val=\"16\"/>"),
    ("Nothing", "Nothing", "Normal", "<w:spacing w:line=\"20\" w:lineRule=\"exact\"/>", "<w:sz w:val=\"2\"/>"),
    ("Header", "header", "Normal", "<w:jc w:val=\"right\"/>", ""),
];

/// The styles; running text is in the language of the page, which decides how words are checked and broken.
pub fn styles(lang: &str) -> String {
    let mut xml = format!(
        "{HEAD}<w:styles xmlns:w=\"{MAIN}\"><w:docDefaults><w:rPrDefault><w:rPr>\
         <w:rFonts w:ascii=\"Times New Roman\" w:hAnsi=\"Times New Roman\" w:eastAsia=\"Times New Roman\" \
         w:cs=\"Times New Roman\"/><w:sz w:val=\"28\"/><w:szCs w:val=\"28\"/><w:lang w:val=\"{lang}\"/></w:rPr></w:rPrDefault>\
         <w:pPrDefault/></w:docDefaults>\
         <w:style w:type=\"paragraph\" w:default=\"1\" w:styleId=\"Normal\"><w:name w:val=\"Normal\"/></w:style>\
         <w:style w:type=\"character\" w:styleId=\"CodeWords\"><w:name w:val=\"Code Words\"/><w:rPr>\
         <w:rFonts w:ascii=\"Courier New\" w:hAnsi=\"Courier New\" w:cs=\"Courier New\"/></w:rPr></w:style>"
    );
    for (id, name, base, paragraph, letters) in STYLES {
        xml.push_str(&style(id, name, base, paragraph, letters));
    }
    for level in 1..=5 {
        // From the indent, never last on a page.
        let paragraph = format!(
            "<w:keepNext/><w:keepLines/><w:spacing w:before=\"360\" w:after=\"240\"/><w:ind w:left=\"709\"/>\
             <w:outlineLvl w:val=\"{}\"/>",
            level - 1
        );
        xml.push_str(&style(&format!("Heading{level}"), &format!("heading {level}"), "Normal", &paragraph, "<w:b/>"));
    }
    xml.push_str("</w:styles>");
    xml
}

fn style(id: &str, name: &str, base: &str, paragraph: &str, letters: &str) -> String {
    format!(
        "<w:style w:type=\"paragraph\" w:styleId=\"{id}\"><w:name w:val=\"{name}\"/><w:basedOn w:val=\"{base}\"/>\
         <w:qFormat/><w:pPr>{paragraph}</w:pPr><w:rPr>{letters}</w:rPr></w:style>"
    )
}

/// Lists with dashes, each level further in.
pub fn numbering() -> String {
    let level = |at: usize| {
        format!(
            "<w:lvl w:ilvl=\"{at}\"><w:start w:val=\"1\"/><w:numFmt w:val=\"bullet\"/><w:lvlText w:val=\"–\"/>\
             <w:lvlJc w:val=\"left\"/><w:pPr><w:ind w:left=\"{}\" w:hanging=\"355\"/></w:pPr></w:lvl>",
            1064 + 355 * at
        )
    };
    let levels: String = (0..9).map(level).collect();
    format!(
        "{HEAD}<w:numbering xmlns:w=\"{MAIN}\"><w:abstractNum w:abstractNumId=\"0\">\
         <w:multiLevelType w:val=\"hybridMultilevel\"/>{levels}</w:abstractNum>\
         <w:num w:numId=\"1\"><w:abstractNumId w:val=\"0\"/></w:num></w:numbering>"
    )
}
