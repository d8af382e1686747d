//! Results of cases as JUnit XML for continuous integration. It contains no times, so the same cases give the same
//! file.

use technolog::document::cleaned_lines;

use super::super::Context;
use super::super::diagnostics::render_all;
use super::{CaseFileRun, CaseRun, page};

/// The document.
pub fn document(runs: &[CaseFileRun], context: &Context) -> String {
    let cases: usize = runs.iter().map(|run| run.cases.len() + errors(run)).sum();
    let failed: usize = runs.iter().map(CaseFileRun::failed).sum();
    let unusable: usize = runs.iter().map(errors).sum();
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.push_str(&format!(
        "<testsuites name=\"technolog test\" tests=\"{cases}\" failures=\"{failed}\" errors=\"{unusable}\">\n"
    ));
    for run in runs {
        text.push_str(&suite(run, context));
    }
    text + "</testsuites>\n"
}

/// A file that cannot be used is one case with an error.
fn errors(run: &CaseFileRun) -> usize {
    usize::from(!run.mistakes.is_empty())
}

fn suite(run: &CaseFileRun, context: &Context) -> String {
    let (file, errors) = (escaped(&run.file), errors(run));
    let mut text = format!(
        "  <testsuite name=\"{file}\" tests=\"{}\" failures=\"{}\" errors=\"{errors}\">\n",
        run.cases.len() + errors,
        run.failed()
    );
    for ran in &run.cases {
        text.push_str(&case(ran, &file, context));
    }
    if let Some(first) = run.mistakes.first() {
        let all = render_all(&run.mistakes, &run.texts, context.lang);
        text.push_str(&format!(
            "    <testcase name=\"{file}\" classname=\"{file}\" file=\"{file}\">\n      \
             <error type=\"{}\" message=\"{}\">{}</error>\n    </testcase>\n",
            escaped(first.code),
            escaped(&context.lang.say(&first.message)),
            escaped(&all)
        ));
    }
    text + "  </testsuite>\n"
}

fn case(ran: &CaseRun, file: &str, context: &Context) -> String {
    let name = escaped(&format!("{}. {}", ran.case.number, ran.case.name));
    let line = ran.case.place.line;
    let head = format!("    <testcase name=\"{name}\" classname=\"{file}\" file=\"{file}\" line=\"{line}\"");
    let Some(first) = ran.failures.first() else { return head + "/>\n" };
    let lines = ran.failures.iter().flat_map(|failure| page::failure_lines(failure, context.lang));
    let text: String = lines.chain(page::origin(ran, context.lang)).map(|line| line + "\n").collect();
    format!(
        "{head}>\n      <failure type=\"expectation\" message=\"{}\">{}</failure>\n    </testcase>\n",
        escaped(&page::short(first, context.lang)),
        escaped(&text)
    )
}

/// A text between tags or in an attribute, whatever signs are in it.
fn escaped(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for letter in cleaned_lines(text).chars() {
        match letter {
            '&' => shown.push_str("&amp;"),
            '<' => shown.push_str("&lt;"),
            '>' => shown.push_str("&gt;"),
            '"' => shown.push_str("&quot;"),
            '\'' => shown.push_str("&apos;"),
            '\n' => shown.push_str("&#10;"),
            '\t' => shown.push_str("&#9;"),
            other => shown.push(other),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn no_sign_of_a_text_is_one_of_xml() {
        assert_eq!(
            escaped("<a b='c'>\"&\"\u{7}\u{202e}\r\n"),
            "&lt;a b=&apos;c&apos;&gt;&quot;&amp;&quot;\u{fffd}\u{fffd}&#10;"
        );
        assert_eq!(escaped("Ø9,8 ± 0,1"), "Ø9,8 ± 0,1");
    }
}
