#![allow(clippy::unwrap_used)]
#[test]
fn dump() {
    let k = technolog::shipped::knowledge().unwrap();
    let mut files: Vec<_> = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/bad"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "yaml"))
        .collect();
    files.sort();
    for f in files {
        let Ok(text) = String::from_utf8(std::fs::read(&f).unwrap()) else { continue };
        println!("== {}", f.file_stem().unwrap().to_string_lossy());
        if std::env::var("ONLY").is_ok_and(|o| !f.to_string_lossy().contains(&o)) {
            continue;
        }
        match technolog::part::read_part("p", &text, &k) {
            Ok(_) => println!("   OK!!"),
            Err(ps) => {
                for p in ps.iter().take(8) {
                    println!("   {}", p.to_string().chars().take(300).collect::<String>())
                }
            }
        }
    }
}
