//! Reports in a browser: what people need who read by ear, by keyboard or on a telephone. Without Chromium nothing is tried.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// Looks at the page from inside and writes its faults, a line each, into the page.
const LOOK: &str = r#"<script>addEventListener("load", () => {
  const faults = [], all = (what) => [...document.querySelectorAll(what)];
  if (!document.documentElement.lang || !document.title) faults.push("no language or title");
  if (all("main").length !== 1 || all("h1").length !== 1) faults.push("main and h1 are not one each");
  for (const image of all("img")) {
    if (!image.alt.trim()) faults.push("a drawing without words: " + image.src.slice(0, 80));
    if (!image.naturalWidth) faults.push("a drawing that is not shown: " + image.alt);
  }
  for (const head of all("th")) if (!head.scope) faults.push("a head of nothing: " + head.textContent);
  for (const table of all("table:not([role=presentation])")) if (!table.querySelector("thead th")) faults.push("a table without heads");
  let last = 0;
  for (const heading of all("h1,h2,h3,h4,h5,h6")) {
    const level = Number(heading.tagName[1]);
    if (level > last + 1) faults.push("a level is left out before: " + heading.textContent);
    last = level;
  }
  for (const cell of all(".form td.line, .form td.value"))
    if (cell.cellIndex > 0 && /^[0-9][0-9.,]*\*?$/.test(cell.textContent.trim())) faults.push("a figure of a form without its name: " + cell.textContent);
  for (const frame of all("[tabindex]")) if (!frame.getAttribute("aria-label")) faults.push("a frame without a name");
  // WCAG 2.1, 1.4.3: relative luminance, and 4.5 for letters of usual size.
  const part = (value) => (value /= 255) <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  const light = ([r, g, b]) => 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
  const tried = new Set();
  for (const element of all("body *")) {
    if (![...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim())) continue;
    let [r, g, b, own = 1] = getComputedStyle(element).color.match(/[\d.]+/g).map(Number), opacity = own;
    for (let at = element; at; at = at.parentElement) opacity *= Number(getComputedStyle(at).opacity);
    const shown = [r, g, b].map((value) => value * opacity + 255 * (1 - opacity));
    const contrast = 1.05 / (light(shown) + 0.05);
    if (contrast < 4.5 && !tried.has(element.className + element.tagName)) {
      tried.add(element.className + element.tagName);
      faults.push("too pale, " + contrast.toFixed(1) + ": " + element.textContent.slice(0, 40));
    }
  }
  const wide = document.documentElement.scrollWidth - innerWidth;
  if (wide > 1) faults.push("wider than a telephone by " + wide);
  const told = document.createElement("pre");
  told.id = "faults";
  told.textContent = "LOOKED\n" + faults.join("\n");
  document.body.append(told);
});</script>"#;

/// The name of the browser that is there.
fn chromium() -> Option<&'static str> {
    let is_there = |name: &&str| {
        let run = Command::new(name).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        run.is_ok_and(|status| status.success())
    };
    ["chromium", "chromium-browser", "google-chrome"].into_iter().find(is_there)
}

#[test]
fn reports_are_read_by_ear_by_keyboard_and_on_a_telephone() {
    let Some(chromium) = chromium() else {
        eprintln!("skipped: there is no Chromium");
        return;
    };
    let folder = std::env::temp_dir().join(format!("technolog-browser-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    for source in ["examples/plate.yaml", "examples/turned-bushing.yaml", "examples/appendix-g/plan.yaml"] {
        let page = folder.join("page.html");
        let made = Command::new(env!("CARGO_BIN_EXE_technolog"))
            .args(["report", source, "-o"])
            .arg(&page)
            .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")))
            .status()
            .unwrap();
        assert!(matches!(made.code(), Some(0 | 1)), "{source}");
        let html = fs::read_to_string(&page).unwrap();
        fs::write(&page, html.replace("</body>", &format!("{LOOK}</body>"))).unwrap();
        let output = Command::new(chromium)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--window-size=500,900", "--dump-dom"])
            .arg(format!("--user-data-dir={}", folder.join("profile").display()))
            .arg(format!("file://{}", page.display()))
            .stderr(Stdio::null())
            .output()
            .unwrap();
        let dom = String::from_utf8_lossy(&output.stdout).into_owned();
        let Some((_, told)) = dom.split_once("LOOKED\n") else {
            // A browser that may not start here, as in a container, says nothing of the page.
            assert!(dom.is_empty(), "{source}: the page was not looked at: {}", &dom[dom.len().saturating_sub(200)..]);
            eprintln!("skipped: Chromium does not start");
            return;
        };
        assert_eq!(told.split("</pre>").next().unwrap(), "", "{source}");
    }
    fs::remove_dir_all(&folder).unwrap();
}
