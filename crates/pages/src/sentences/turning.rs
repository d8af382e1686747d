//! The words about shafts and their passes: what is wrong in a shaft file, what to do, and why a pass was taken.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // Mistakes of a shaft file.
    ("empty-name", "назва порожня", "the name is empty"),
    (
        "unknown-lathe",
        "верстата `{lathe}` немає в каталозі; є: {known}",
        "no catalog has the lathe `{lathe}`; there are: {known}",
    ),
    ("unknown-material", "матеріалу `{material}` немає", "there is no material `{material}`"),
    (
        "unknown-material-near",
        "матеріалу `{material}` немає; мабуть, `{near}`?",
        "there is no material `{material}`; did you mean `{near}`?",
    ),
    ("no-such-choice", "`{word}` тут невідоме; є {known}", "`{word}` is not known here; there are {known}"),
    ("not-above-zero", "`{key}` дорівнює {length}, а має бути більше за 0", "`{key}` is {length}, and must be above 0"),
    ("length-too-large", "`{key}` дорівнює {length} > {most}", "`{key}` is {length} > {most}"),
    ("no-steps", "у вала немає жодного ступеня", "the shaft has no step"),
    (
        "step-beyond-blank",
        "ступінь {step}: Ø{diameter} більший за заготовку Ø{blank}",
        "step {step}: Ø{diameter} is larger than the blank Ø{blank}",
    ),
    (
        "step-rises-to-the-free-end",
        "ступінь {step}: Ø{diameter} менший за Ø{before} ступеня {other}, який ближче до вільного торця",
        "step {step}: Ø{diameter} is smaller than Ø{before} of step {other}, which is nearer to the free end",
    ),
    (
        "steps-beyond-blank",
        "ступені разом {sum} мм довші за заготовку {blank} мм; тут вона скінчилась",
        "all steps are {sum} mm, longer than the blank of {blank} mm, which ends here",
    ),
    (
        "grid-too-fine",
        "рівнів і шарів забагато: {states} станів, а можна не більше {most}",
        "too many levels and slices: {states} states, at most {most} are looked through",
    ),
    // What the command cannot do with what it was given.
    (
        "no-rates",
        "для часу бракує подач: у файлі немає `rates`",
        "no feeds to reckon time with: the file has no `rates`",
    ),
    (
        "rich-has-no-time",
        "з розширеними ходами час не шукається",
        "with the rich moves the time is not what can be searched for",
    ),
    // Why a pass.
    (
        "pass-shorter",
        "далі {left} мм, з ходом іншого напряму {otherwise} мм",
        "{left} mm to go, {otherwise} mm with the other direction",
    ),
    (
        "pass-quicker",
        "далі {left} хв, з ходом іншого напряму {otherwise} хв",
        "{left} min to go, {otherwise} min with the other direction",
    ),
    (
        "pass-fewer",
        "далі проходів {left}, з ходом іншого напряму {otherwise}",
        "{left} passes to go, {otherwise} with the other direction",
    ),
    ("pass-as-good", "обидва напрями однаково добрі, далі {left}", "both directions are as good, {left} to go"),
    ("pass-of-variant", "так каже варіант", "the variant says so"),
    ("pass-of-step", "напрям ступеня {step}", "the direction of step {step}"),
    ("pass-of-search", "з пошуку розширених ходів, далі {left}", "from the search over rich moves, {left} to go"),
    // Which variant, and what to know.
    (
        "take-lengthwise",
        "у центрах найменше ходів дає переміщення вздовж осі",
        "between centres the fewest passes run along the axis",
    ),
    (
        "take-searched",
        "у патроні ходи вздовж і поперек осі можна поєднувати",
        "in a chuck passes along and across the axis may be combined",
    ),
    (
        "take-contour",
        "заготовку, близьку до форми деталі, обробляють паралельно контуру",
        "a blank near the shape of the part is turned parallel to the contour",
    ),
    (
        "contour-passes-elsewhere",
        "ходи паралельно контуру показує `--show operation`; показані тут ходи зняли б повний циліндр",
        "passes parallel to the contour are shown by `--show operation`; those shown here would take a full cylinder",
    ),
    (
        "variant-beyond-model",
        "варіант {variant} коротший за найкращий у моделі: його поздовжні ходи зупиняються всередині рівня",
        "the variant {variant} beats the best of the model: its longitudinal passes stop within a level",
    ),
    (
        "nothing-to-turn",
        "жоден ступінь не менший за заготовку: знімати нічого",
        "no step is smaller than the blank: nothing to turn",
    ),
];

pub(super) const REMEDIES: &[(&str, &str, &str)] = &[
    ("empty-name", "назвіть вал", "name the shaft"),
    ("unknown-lathe", "назвіть один із них або приберіть `machine`", "name one of them, or leave `machine` out"),
    ("unknown-material", "матеріали дає `technolog table materials`", "`technolog table materials` lists them"),
    ("unknown-material-near", "матеріали дає `technolog table materials`", "`technolog table materials` lists them"),
    ("no-such-choice", "візьміть одне з них", "take one of them"),
    ("not-above-zero", "пишіть міліметри без знака", "give millimetres, without a sign"),
    ("length-too-large", "пишіть міліметри", "give millimetres"),
    ("no-steps", "опишіть ступені від вільного торця до патрона", "list the steps from the free end towards the chuck"),
    ("step-beyond-blank", "візьміть більшу заготовку", "take a larger blank"),
    (
        "step-rises-to-the-free-end",
        "перевірте порядок: від вільного торця до патрона діаметри не спадають; вузьке місце за ширшим точать з другого установа або канавковим різцем",
        "check the order: from the free end towards the chuck no diameter falls; a neck behind a wider step is turned in a second set-up or with a grooving tool",
    ),
    (
        "steps-beyond-blank",
        "візьміть довшу заготовку або вкоротіть ступені",
        "take a longer blank, or shorten the steps",
    ),
    ("grid-too-fine", "візьміть більші глибини", "take larger depths"),
    (
        "no-rates",
        "допишіть rates: {longitudinal_feed: 180, transverse_feed: 150, rapid: 6000}, мм/хв",
        "add rates: {longitudinal_feed: 180, transverse_feed: 150, rapid: 6000}, mm/min",
    ),
    (
        "rich-has-no-time",
        "візьміть іншу мету: path, path-and-passes чи passes",
        "take another objective: path, path-and-passes or passes",
    ),
];
