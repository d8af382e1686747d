//! The words of the proof: how a program deviates from the job of a part; what to do stands in `remedies`.

mod remedies;

pub(super) use remedies::REMEDIES;

/// Code, Ukrainian, English: what deviates.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // What is made and what is not.
    (
        "not-made",
        "{hole}: {operation} (T{tool}) не виконано, точок {count}: {points}",
        "{hole}: {operation} (T{tool}) is not made at {count} points: {points}",
    ),
    (
        "cut-again",
        "зайве: в {at} T{tool} ще раз іде до Z{z}, а це вже зроблено",
        "superfluous: at {at} T{tool} goes to Z{z} again, and that is made already",
    ),
    (
        "cut-not-planned",
        "зайве: в {at} T{tool} іде до Z{z}, а в цьому отворі такого переходу немає",
        "superfluous: at {at} T{tool} goes to Z{z}, and that hole has no such transition",
    ),
    (
        "cut-elsewhere",
        "зайве: в {at} T{tool} іде до Z{z}, а отвору там немає",
        "superfluous: at {at} T{tool} goes to Z{z}, and there is no hole",
    ),
    (
        "wrong-order",
        "{hole}: {operation} в {at} виконано після переходу, що йде за ним ({instead})",
        "{hole}: {operation} at {at} is made after a transition that follows it ({instead})",
    ),
    // Tools.
    (
        "wrong-tool",
        "{hole}: {operation} в {at} виконує T{tool}, а треба T{needed}",
        "{hole}: {operation} at {at} is made by T{tool}, and T{needed} is needed",
    ),
    ("tool-unknown", "інструмента T{tool} у плані немає", "the plan has no tool T{tool}"),
    (
        "tool-by-work",
        "T{tool} програми робить те, що в плані T{plan}",
        "T{tool} of the program does the work of the plan's T{plan}",
    ),
    (
        "not-loaded",
        "інструмент {tool} плану не поставлено в гніздо {place}: перед викликом немає зупинки",
        "the plan's tool {tool} is not put into place {place}: there is no stop before it is called",
    ),
    (
        "no-correction",
        "T{tool} ріже без корекції довжини; його H{own} дорівнює {needed} (діє H{corrector} = {value})",
        "T{tool} cuts without length correction; its H{own} is {needed} (H{corrector} = {value} acts)",
    ),
    (
        "wrong-correction",
        "T{tool} ріже з H{corrector} = {value}, а його корекція H{own} = {needed}",
        "T{tool} cuts with H{corrector} = {value}, and its correction is H{own} = {needed}",
    ),
    (
        "other-corrector",
        "T{tool} ріже з H{corrector}, а його коректор H{own}; величина та сама, {value} з {needed}",
        "T{tool} cuts with H{corrector}, and its corrector is H{own}; the value is the same, {value} of {needed}",
    ),
    (
        "wrong-sign",
        "T{tool}: H{corrector} = {value}, а за планом {needed}: знак протилежний",
        "T{tool}: H{corrector} = {value}, and {needed} by the plan: the sign is the opposite",
    ),
    (
        "feed-per-turn",
        "{hole}: {operation} в {at}: {made} мм/об замість {needed}",
        "{hole}: {operation} at {at}: {made} mm/rev instead of {needed}",
    ),
    (
        "changes-elsewhere",
        "інструмент замінюють у {at}, а не в точці заміни",
        "the tool is changed at {at}, not at the place of the tool change",
    ),
    (
        "no-corrector",
        "T{tool} ріже без свого коректора H{own}; він нульовий, тому рухи ті самі",
        "T{tool} cuts without its corrector H{own}; it holds 0, so the motions are the same",
    ),
    (
        "shared-corrector",
        "T{tool} ріже з H{corrector} = {value}, який має T{other}; за планом H{own} = {needed}",
        "T{tool} cuts with H{corrector} = {value}, which is that of T{other}; the plan has H{own} = {needed}",
    ),
    (
        "correction-otherwise",
        "H{corrector} = {value} для T{tool}, а за планом H{own} = {needed}: висоти прийнято за вказаною величиною",
        "H{corrector} = {value} for T{tool}, and the plan has H{own} = {needed}: heights are taken by the value given",
    ),
    // Dangerous motions.
    (
        "rapid-across",
        "прискорений рух у деталі: до {at} на висоті Z{z}",
        "a rapid across inside the part: to {at} at Z{z}",
    ),
    ("rapid-into-part", "прискорений рух у метал у {at} до Z{z}", "a rapid into the metal at {at} to Z{z}"),
    (
        "rapid-into-metal",
        "{hole}: {operation} в {at}: подача починається на Z{made}, а метал на Z{needed}",
        "{hole}: {operation} at {at}: the feed begins at Z{made}, and the metal at Z{needed}",
    ),
    ("spindle-stands", "в {at} T{tool} ріже при зупиненому шпинделі", "at {at} T{tool} cuts while the spindle stands"),
    (
        "wrong-turn",
        "в {at} T{tool} ріже при обертанні шпинделя проти годинникової стрілки",
        "at {at} T{tool} cuts while the spindle turns counterclockwise",
    ),
    (
        "slot",
        "{hole}: {operation} в {at}: подача вбік у металі до {to} на Z{z}",
        "{hole}: {operation} at {at}: a feed across in the metal to {to} at Z{z}",
    ),
    (
        "travel-low",
        "перехід до {at} на Z{made}, нижче за Z{needed}",
        "the way to {at} is at Z{made}, lower than Z{needed}",
    ),
    // Levels.
    (
        "too-shallow",
        "{hole}: {operation} в {at}: до Z{made}, а треба до Z{needed}",
        "{hole}: {operation} at {at}: to Z{made}, and Z{needed} is needed",
    ),
    (
        "less-overrun",
        "{hole}: {operation} в {at}: до Z{made} замість Z{needed}, перебіг менший",
        "{hole}: {operation} at {at}: to Z{made} instead of Z{needed}, with less overrun",
    ),
    (
        "deeper",
        "{hole}: {operation} в {at}: до Z{made}, глибше за Z{needed}",
        "{hole}: {operation} at {at}: to Z{made}, deeper than Z{needed}",
    ),
    (
        "begins-lower",
        "{hole}: {operation} в {at}: подача починається на Z{made}, недобіг менший, ніж із Z{needed}",
        "{hole}: {operation} at {at}: the feed begins at Z{made}, with less approach than from Z{needed}",
    ),
    (
        "begins-higher",
        "{hole}: {operation} в {at}: подача починається на Z{made} замість Z{needed}",
        "{hole}: {operation} at {at}: the feed begins at Z{made} instead of Z{needed}",
    ),
    // Conditions.
    (
        "other-speed",
        "{hole}: {operation} в {at}: {made} об/хв замість {needed}",
        "{hole}: {operation} at {at}: {made} 1/min instead of {needed}",
    ),
    (
        "other-feed",
        "{hole}: {operation} в {at}: подача {made} мм/хв замість {needed}",
        "{hole}: {operation} at {at}: feed {made} mm/min instead of {needed}",
    ),
    (
        "other-dwell",
        "{hole}: {operation} в {at}: витримка {made} с замість {needed}",
        "{hole}: {operation} at {at}: a dwell of {made} s instead of {needed}",
    ),
    (
        "dwell-elsewhere",
        "{hole}: {operation} в {at}: витримка {made} с не на дні",
        "{hole}: {operation} at {at}: a dwell of {made} s not at the bottom",
    ),
    ("coolant-missing", "{hole}: {operation} в {at}: без охолодження", "{hole}: {operation} at {at}: without coolant"),
    (
        "coolant-superfluous",
        "{hole}: {operation} в {at}: з охолодженням, якого план не має",
        "{hole}: {operation} at {at}: with coolant, which the plan has not",
    ),
    // Steps.
    (
        "steps-not-planned",
        "{hole}: {operation} в {at}: за {made} заходів замість одного",
        "{hole}: {operation} at {at}: in {made} steps instead of one",
    ),
    (
        "step-too-large",
        "{hole}: {operation} в {at}: крок {made} мм, більший за {needed}",
        "{hole}: {operation} at {at}: a step of {made} mm, more than {needed}",
    ),
    (
        "step-smaller",
        "{hole}: {operation} в {at}: крок {made} мм замість {needed}",
        "{hole}: {operation} at {at}: a step of {made} mm instead of {needed}",
    ),
    (
        "step-clearance",
        "{hole}: {operation} в {at}: новий крок за {made} мм до металу замість {needed}",
        "{hole}: {operation} at {at}: a step begins {made} mm before the metal instead of {needed}",
    ),
    (
        "step-return",
        "{hole}: {operation} в {at}: між кроками до Z{made} замість Z{needed}",
        "{hole}: {operation} at {at}: between steps to Z{made} instead of Z{needed}",
    ),
    // The way out.
    (
        "out-at-rapid",
        "{hole}: {operation} в {at}: вихід прискорено, а треба подачею",
        "{hole}: {operation} at {at}: out at rapid, and it must be at feed",
    ),
    (
        "out-at-feed",
        "{hole}: {operation} в {at}: вихід подачею {made} мм/хв, можна прискорено",
        "{hole}: {operation} at {at}: out at feed {made} mm/min, rapid would do",
    ),
    (
        "out-other-feed",
        "{hole}: {operation} в {at}: вихід подачею {made} мм/хв замість {needed}",
        "{hole}: {operation} at {at}: out at feed {made} mm/min instead of {needed}",
    ),
    (
        "out-too-high",
        "{hole}: {operation} в {at}: подачею до Z{made}, далі за Z{needed} можна прискорено",
        "{hole}: {operation} at {at}: at feed up to Z{made}, from Z{needed} rapid would do",
    ),
    (
        "out-too-low",
        "{hole}: {operation} в {at}: подачею лише до Z{made}, а треба до Z{needed}",
        "{hole}: {operation} at {at}: at feed only up to Z{made}, and Z{needed} is needed",
    ),
    (
        "out-elsewhere",
        "{hole}: {operation} в {at}: вихід на Z{made}, а не на Z{needed}",
        "{hole}: {operation} at {at}: the way out ends at Z{made} and not at Z{needed}",
    ),
    (
        "out-turning",
        "{hole}: {operation} в {at}: вихід при обертанні шпинделя, а він має стояти",
        "{hole}: {operation} at {at}: out while the spindle turns, and it must stand",
    ),
    (
        "out-standing",
        "{hole}: {operation} в {at}: вихід при зупиненому шпинделі",
        "{hole}: {operation} at {at}: out while the spindle stands",
    ),
    // Circles.
    (
        "circle-missing",
        "{hole}: {operation} в {at}: бракує кіл: {count}, перше на Z{z}",
        "{hole}: {operation} at {at}: {count} circles are missing, the first at Z{z}",
    ),
    (
        "circle-superfluous",
        "{hole}: {operation} в {at}: зайве коло на Z{z}",
        "{hole}: {operation} at {at}: a superfluous circle at Z{z}",
    ),
    (
        "circle-level",
        "{hole}: {operation} в {at}: коло на Z{z}, а треба на Z{needed}",
        "{hole}: {operation} at {at}: a circle at Z{z}, and Z{needed} is needed",
    ),
    (
        "circle-radius",
        "{hole}: {operation} в {at}: радіус кола {made} мм на Z{z}, а треба {needed}",
        "{hole}: {operation} at {at}: a circle of radius {made} mm at Z{z}, and {needed} is needed",
    ),
    (
        "circle-centre",
        "{hole}: {operation} в {at}: центр кола {made} на Z{z}",
        "{hole}: {operation} at {at}: the centre of the circle is {made} at Z{z}",
    ),
    (
        "circle-sense",
        "{hole}: {operation} в {at}: коло на Z{z} в інший бік",
        "{hole}: {operation} at {at}: the circle at Z{z} goes the other way round",
    ),
    (
        "circle-open",
        "{hole}: {operation} в {at}: на Z{z} лише {made} кола",
        "{hole}: {operation} at {at}: only {made} of a circle at Z{z}",
    ),
    (
        "circle-again",
        "{hole}: {operation} в {at}: на Z{z} {made} кола замість одного",
        "{hole}: {operation} at {at}: {made} circles at Z{z} instead of one",
    ),
    (
        "ways-between-circles",
        "{hole}: {operation} в {at}: прямих ходів у площині {made} замість {needed}",
        "{hole}: {operation} at {at}: {made} straight ways across instead of {needed}",
    ),
    (
        "ways-down",
        "{hole}: {operation} в {at}: ходів униз {made} замість {needed}",
        "{hole}: {operation} at {at}: {made} ways down instead of {needed}",
    ),
    (
        "oblique",
        "{hole}: {operation} в {at}: хід убік і вглиб водночас до Z{z}",
        "{hole}: {operation} at {at}: across and down at once to Z{z}",
    ),
    (
        "not-in-the-middle",
        "{hole}: {operation} в {at}: рух по Z в {to} до Z{z}, а не посередині отвору",
        "{hole}: {operation} at {at}: a motion along Z at {to} to Z{z}, not in the middle of the hole",
    ),
    // Pauses.
    (
        "no-stop-to-load",
        "немає зупинки, щоб поставити інструмент {tool} у гніздо {place}",
        "there is no stop to put tool {tool} into place {place}",
    ),
    ("no-stop-to-turn-over", "немає зупинки, щоб перевернути деталь", "there is no stop to turn the part over"),
    (
        "no-stop-to-set-bar",
        "немає зупинки, щоб виставити оправку на Ø{diameter}",
        "there is no stop to set the bar to Ø{diameter}",
    ),
    (
        "not-turned-over",
        "другий установ починається без зупинки, щоб перевернути деталь",
        "the second set-up begins without a stop to turn the part over",
    ),
    ("stop-for-nothing", "зупинка, якої план не має", "a stop that the plan has not"),
    // Around the cuts.
    (
        "other-order",
        "порядок точок не за планом з {at} (там {needed}): інших місць {count}, шлях {way} мм",
        "the points are not in the plan's order from {at} on (there {needed}): {count} other places, way {way} mm",
    ),
    ("idle-point", "рух до {at}, де нічого не роблять", "a motion to {at}, where nothing is done"),
    ("idle-height", "рух до Z{z}, якої цикл не має", "a motion to Z{z}, which the cycle has not"),
    (
        "air-at-feed",
        "над деталлю до Z{z} подачею {made} мм/хв, можна прискорено",
        "over the part to Z{z} at feed {made} mm/min, rapid would do",
    ),
    (
        "travel-at-feed",
        "перехід до {at} подачею {made} мм/хв, можна прискорено",
        "the way to {at} at feed {made} mm/min, rapid would do",
    ),
    (
        "travel-high",
        "перехід до {at} на Z{made}, вище за Z{needed}",
        "the way to {at} is at Z{made}, higher than Z{needed}",
    ),
    (
        "travel-not-up",
        "шлях від заміни інструмента чи до неї ({at}) на Z{z}, а не з піднятим повзуном",
        "the way from or to the tool change ({at}) is at Z{z}, not with the quill up",
    ),
    (
        "radius-correction",
        "діє корекція на радіус, якої план не має",
        "a radius correction acts, which the plan has not",
    ),
    ("approach-standing", "підхід до Z{z} при зупиненому шпинделі", "the way down to Z{z} while the spindle stands"),
    ("dwell-in-air", "витримка {made} с над деталлю", "a dwell of {made} s over the part"),
    (
        "turns-to-change",
        "шпиндель обертається на шляху до заміни інструмента",
        "the spindle turns on the way to the tool change",
    ),
    (
        "correction-at-change",
        "корекція на довжину діє ще під час заміни інструмента",
        "the length correction still acts at the tool change",
    ),
    ("turns-at-change", "шпиндель обертається до самої заміни інструмента", "the spindle turns until the tool change"),
    (
        "coolant-at-change",
        "охолодження не вимкнено перед заміною інструмента",
        "the coolant flows during a tool change",
    ),
    ("turns-at-end", "програма закінчується, а шпиндель обертається", "the program ends and the spindle turns"),
    ("coolant-at-end", "програма закінчується, а охолодження ввімкнено", "the program ends and the coolant flows"),
    (
        "ends-elsewhere",
        "програма закінчується в {at}, а не в точці заміни інструмента",
        "the program ends at {at}, not at the place of the tool change",
    ),
    ("no-end", "програма не доходить до кінця", "the program does not come to its end"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::proof::Code;
    use std::collections::BTreeSet;

    #[test]
    fn every_deviation_has_its_words_and_says_what_to_do() {
        let codes: BTreeSet<&str> = Code::ALL.iter().map(|code| code.name()).collect();
        assert_eq!(codes, SENTENCES.iter().map(|(code, ..)| *code).collect());
        assert_eq!(codes, REMEDIES.iter().map(|(code, _)| *code).collect());
    }

    #[test]
    fn the_page_tells_every_deviation() {
        let page = include_str!("../../../../docs/proof.md");
        let untold: Vec<_> = SENTENCES.iter().filter(|(code, ..)| !page.contains(&format!("`{code}`"))).collect();
        assert!(untold.is_empty(), "docs/proof.md does not name {untold:?}");
    }
}
