//! Parts and benches for the tests of jobs.

use crate::material::Material;
use crate::shipped;
use crate::turning::operation::Sizes;
use crate::turning::operation::tools::Bench;
use crate::turning::tooling::Lathe;
use crate::turning::workpiece::{Workpiece, read_turned};

/// A part out of a bar of 120 mm on a 16K20F3, by the lists of its file.
pub fn part(outer: &str, inner: &str, material: &str) -> Workpiece {
    let inner = if inner.is_empty() { String::new() } else { format!("inner:\n{inner}") };
    let text = format!(
        "shaft: P\nmaterial: {material}\nblank: {{kind: bar, diameter: 120, length: 130, face: 1}}\nmachine: 16k20f3\n\
         outer:\n{outer}{inner}"
    );
    read_turned("part", &text, &shipped::knowledge().unwrap()).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// A plain part of a material.
pub fn plain(material: &str) -> Workpiece {
    part("  - {from: {d: 0, z: 0}}\n  - {face: 30}\n  - {cylinder: -40}\n", "", material)
}

/// What comes of a part at its bench.
pub fn at_bench<T>(workpiece: &Workpiece, of: impl FnOnce(&Bench<'_, '_>) -> T) -> T {
    let knowledge = shipped::knowledge().unwrap();
    let lathe = Lathe::find(&knowledge, "16k20f3").unwrap();
    let material = Material::find(&knowledge, &workpiece.material).unwrap();
    let sizes = Sizes::default();
    of(&Bench::of(workpiece, Some(&lathe), material, &sizes, &knowledge))
}
