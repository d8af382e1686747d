//! The passes of a shaft as its reader sees them: the variants side by side, and the best one pass by pass.

mod drawing;
mod frames;
mod map;
mod operation;
mod operation_drawing;
mod schemes;
mod schemes_drawing;
mod view;

use std::fmt::Display;

use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::units::round_to;
use technolog_turning::passes::cost::Objective;
use technolog_turning::passes::pass::Kind;
use technolog_turning::passes::{Sequences, Variant};
use technolog_turning::schemes::Schemes;
use technolog_turning::shaft::{Division, Moves};

use super::sentences::term;
use super::{Lang, grid, sentence};

pub use drawing::drawing;
pub use frames::frames;
pub use map::{map_drawing, map_page};
pub use operation::{operation_page, programs_list};
pub use operation_drawing::operation_drawing;

/// The whole page of a shaft.
pub fn page(found: &Sequences, schemes: &Schemes, knowledge: &Knowledge, lang: Lang) -> String {
    let mut page = head(found, knowledge, lang);
    page.push_str(&format!("\n1. {}\n", lang.pick("Варіанти", "Variants")));
    page.push_str(&variants(found, lang));
    if let Some(proof) = found.proof {
        let line = match proof.optimal_on_the_grid {
            true => lang.pick(
                "Доведено: на сітці з {radii} радіусів і {zs} Z кращої послідовності немає.",
                "Proven: on the grid of {radii} radii and {zs} Z no sequence is better.",
            ),
            false => lang.pick(
                "На сітці з {radii} радіусів і {zs} Z жодна послідовність не нижча за {bound}; показана - найкраща знайдена.",
                "On the grid of {radii} radii and {zs} Z no sequence is below {bound}; the one shown is the best found.",
            ),
        };
        let line = line.replace("{radii}", &proof.lines.0.to_string()).replace("{zs}", &proof.lines.1.to_string());
        page.push_str(&grid::paragraph(&line.replace("{bound}", &figure(proof.lower_bound, lang)), 0));
    }
    if let Some(best) = found.variants.last().filter(|best| !best.passes.is_empty()) {
        page.push_str(&format!("\n2. {}\n", lang.pick("Оптимум, прохід за проходом", "The optimum, pass by pass")));
        page.push_str(&passes(best, lang));
    }
    page.push_str(&format!("\n3. {}\n", lang.pick("Що взяти", "What to take")));
    let name = match found.recommended.variant {
        Some(name) => term(name, lang),
        None => lang.pick("жоден із цих варіантів", "none of these variants"),
    };
    let because = &found.recommended.because;
    let why = sentence(&because.note, lang);
    let row = because.row.unwrap_or_default();
    let place = &because.place;
    let line =
        lang.pick("{name}: {why} ({table}, рядок {row}; {place})", "{name}: {why} ({table}, row {row}; {place})");
    let line = line.replace("{name}", name).replace("{why}", &why).replace("{table}", &because.table);
    page.push_str(&grid::paragraph(&line.replace("{row}", &row.to_string()).replace("{place}", place), 2));
    for finding in &found.findings {
        page.push_str(&grid::paragraph(&sentence(&finding.note, lang), 2));
    }
    page.push_str(&schemes::sections(schemes, 4, lang));
    page
}

/// A figure as people write it.
fn figure(value: impl Display, lang: Lang) -> String {
    let text = value.to_string();
    lang.pick(&text.replace('.', ","), &text).to_owned()
}

fn head(found: &Sequences, knowledge: &Knowledge, lang: Lang) -> String {
    let shaft = &found.shaft;
    let number = |value: &dyn Display| figure(value, lang);
    let material = Material::find(knowledge, &shaft.material)
        .map_or_else(|_| shaft.material.clone(), |material| material.designation().to_owned());
    let steps: Vec<String> =
        shaft.steps.iter().map(|step| format!("Ø{} × {}", number(&step.diameter), number(&step.length))).collect();
    let blank = &shaft.blank;
    let mut page = grid::paragraph(
        &format!(
            "{}. {material}. {}: {} Ø{} × {} {}, {}.",
            shaft.shaft,
            lang.pick("Заготовка", "Blank"),
            term(blank.kind.name(), lang),
            number(&blank.diameter),
            number(&blank.length),
            lang.pick("мм", "mm"),
            term(shaft.holding.name(), lang),
        ),
        0,
    );
    let from = lang.pick("Ступені від вільного торця", "Steps from the free end");
    page.push_str(&grid::paragraph(&format!("{from}: {}.", steps.join(", ")), 0));
    let mut radii = vec![number(&shaft.blank.diameter)];
    radii.extend(found.levels.iter().map(|level| number(&level.to_diameter_mm)));
    let levels = lang.pick("Рівні, до", "Levels, up to");
    let depths = (number(&shaft.roughing.longitudinal_depth), number(&shaft.roughing.transverse_depth));
    let unit = lang.pick("мм", "mm");
    page.push_str(&grid::paragraph(&format!("{levels} {} {unit}: Ø{}.", depths.0, radii.join(" → ")), 0));
    let mut faces = vec!["0".to_owned()];
    faces.extend(found.slices.iter().map(|slice| number(&slice.to_z_mm)));
    let slices = lang.pick("Шари, до", "Slices, up to");
    page.push_str(&grid::paragraph(&format!("{slices} {} {unit}: Z {}.", depths.1, faces.join(" → ")), 0));
    if shaft.roughing.division == Division::Equal {
        let text =
            lang.pick("Припуск між уступами поділено порівну.", "The stock between shoulders is divided equally.");
        page.push_str(&grid::paragraph(text, 0));
    }
    let objective = match found.objective {
        Objective::Path => lang.pick("найменший шлях різання", "the shortest cutting path").to_owned(),
        Objective::PathAndPasses { per_pass_mm } => lang
            .pick(
                "найменший шлях різання, і {} мм на кожен прохід",
                "the shortest cutting path, and {} mm for each pass",
            )
            .replace("{}", &number(&per_pass_mm)),
        Objective::Time { .. } => lang.pick("найменший час", "the shortest time").to_owned(),
        Objective::Passes => lang.pick("найменше проходів", "the fewest passes").to_owned(),
    };
    page.push_str(&grid::paragraph(&format!("{}: {objective}.", lang.pick("Мета", "Objective")), 0));
    if found.moves == Moves::Rich {
        let text = lang.pick(
            "Ходи розширені: прохід може зупинитися будь-де на сітці й брати менше за повну глибину.",
            "Rich moves: a pass may stop anywhere on the grid and take less than the full depth.",
        );
        page.push_str(&grid::paragraph(text, 0));
    }
    page
}

fn variants(found: &Sequences, lang: Lang) -> String {
    let timed = found.variants.iter().any(|variant| variant.time_min.is_some());
    let mut head = vec![
        lang.pick("Варіант", "Variant").to_owned(),
        lang.pick("Шлях різання, мм", "Cutting path, mm").to_owned(),
        lang.pick("Проходів", "Passes").to_owned(),
        lang.pick("поздовжніх", "longitudinal").to_owned(),
        lang.pick("поперечних", "transverse").to_owned(),
        lang.pick("Понад оптимум, %", "Above the optimum, %").to_owned(),
    ];
    if timed {
        head.insert(5, lang.pick("Час, хв", "Time, min").to_owned());
    }
    let mut rows = Vec::new();
    for variant in &found.variants {
        let along = variant.passes.iter().filter(|pass| pass.kind == Kind::Longitudinal).count();
        let mut row = vec![
            term(variant.name, lang).to_owned(),
            figure(variant.cutting_path_mm, lang),
            variant.passes.len().to_string(),
            along.to_string(),
            (variant.passes.len() - along).to_string(),
            figure(variant.above_optimum_percent, lang),
        ];
        if timed {
            let time = variant.time_min.map(|time| figure(round_to(time.0, 3), lang));
            row.insert(5, time.unwrap_or_default());
        }
        rows.push(row);
    }
    grid::table(&head, &rows, 2)
}

fn passes(variant: &Variant, lang: Lang) -> String {
    let head = [
        "№",
        lang.pick("Хід", "Pass"),
        lang.pick("Ø, мм", "Ø, mm"),
        lang.pick("Z, мм", "Z, mm"),
        lang.pick("Глибина, мм", "Depth, mm"),
        lang.pick("Довжина, мм", "Length, mm"),
        lang.pick("Чому", "Why"),
    ]
    .map(str::to_owned);
    let arrow = |from: String, to: String| if from == to { to } else { format!("{from} → {to}") };
    let mut rows = Vec::new();
    for pass in &variant.passes {
        let number = |value: &dyn Display| figure(value, lang);
        rows.push(vec![
            pass.number.to_string(),
            term(pass.kind.name(), lang).to_owned(),
            arrow(number(&pass.from.diameter_mm), number(&pass.to.diameter_mm)),
            arrow(number(&pass.from.z_mm), number(&pass.to.z_mm)),
            number(&pass.depth_mm),
            number(&pass.length_mm),
            sentence(&pass.reason, lang),
        ]);
    }
    grid::table(&head, &rows, 2)
}
