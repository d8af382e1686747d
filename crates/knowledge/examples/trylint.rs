use technolog_knowledge::*;
fn main() {
    let dir = std::env::args().nth(1).unwrap();
    let files = Knowledge::read_folder(std::path::Path::new(&dir)).unwrap();
    let sources: Vec<_> = files.iter().map(|(p, t)| SourceFile { path: p, text: t }).collect();
    let (k, problems) = Knowledge::read_sources(&sources);
    for p in &problems { println!("{p}"); }
    println!("-- {} load problems; {} tables", problems.len(), k.tables().count());
    let f = lint::lint(&k);
    for p in &f { println!("{p}"); }
    println!("-- {} findings", f.len());
}
