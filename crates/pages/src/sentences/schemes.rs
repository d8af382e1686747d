//! The words about levels, zones and schemes of a shaft, and about the mistakes of a stepped blank.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    ("bar-with-steps", "пруток не має ступенів", "a bar has no steps"),
    (
        "blank-step-rises-to-the-free-end",
        "ступінь {step} заготовки: Ø{diameter} менший за Ø{before} перед ним",
        "step {step} of the blank: Ø{diameter} is smaller than Ø{before} before it",
    ),
    (
        "blank-step-beyond-blank",
        "ступінь {step} заготовки: Ø{diameter} більший за її найбільший Ø{blank}",
        "step {step} of the blank: Ø{diameter} is larger than its largest Ø{blank}",
    ),
    // What the schemes are.
    (
        "scheme-verticals",
        "припуск знімається над одним циліндром за іншим",
        "the stock is taken over one cylinder after the other",
    ),
    (
        "scheme-levels",
        "припуск знімається рівень за рівнем над усіма циліндрами",
        "level after level over all cylinders",
    ),
    (
        "scheme-horizontals-a",
        "прямі ходи лишають над кожним циліндром не більше за одну глибину, яку знімає хід уздовж контуру",
        "straight passes leave at most one depth over each cylinder, which a pass along the contour takes",
    ),
    (
        "scheme-horizontals-b",
        "прямі ходи лишають усюди менше за глибину, решту знімає хід уздовж контуру",
        "straight passes leave less than the depth everywhere, a pass along the contour takes the rest",
    ),
    (
        "scheme-quickest",
        "{variant}: швидше за всі, на {margin} хв ({percent} %) менше, ніж {rival}",
        "{variant}: the quickest, {margin} min ({percent} %) less than {rival}",
    ),
    (
        "scheme-as-quick",
        "{variant}: так само швидко, як {rival}; з двох перевага за першою",
        "{variant}: as quick as {rival}; of the two the first is preferred",
    ),
    // What the schemes of rough transitions are.
    (
        "transition-loop",
        "прямі ходи з відводом і поверненням через повітря",
        "straight passes, drawn back and returned through air",
    ),
    (
        "transition-loop-against-stop",
        "прямі ходи від упора: ступінь за ступенем на повну глибину до її уступу",
        "straight passes against a stop: step after step, at the full depth to its shoulder",
    ),
    (
        "transition-zigzag",
        "різання на прямій і зворотній подачі, врізання вздовж контуру на кінцях",
        "cuts there and back, and goes in along the contour at both ends",
    ),
    (
        "transition-descent",
        "припуск знімається радіальними ходами, шар за шаром",
        "the stock is taken by radial motions, slice by slice",
    ),
    (
        "transition-pick-up",
        "після кожного прямого ходу підбір уздовж контуру до рівня попереднього ходу",
        "after each straight pass along the contour up to the level of the pass before",
    ),
    (
        "transition-semi-finishing",
        "прямі ходи, потім один хід уздовж контуру, що зрізує всі гребінці",
        "straight passes, then one along the contour that cuts all ridges",
    ),
    (
        "transition-equidistant",
        "ходи еквідистантні чорновому контуру",
        "passes at equal distances from the rough contour",
    ),
    (
        "transition-contour",
        "ходи повторюють контур, зміщений вздовж прямої",
        "passes repeat the contour, shifted along a line",
    ),
    ("transition-as-quick", "{variant}: так само швидко, як {rival}", "{variant}: as quick as {rival}"),
    (
        "finishing-must-follow",
        "схема дає шорсткість до {finest}, а задано {asked}: потрібна чистова обробка після неї",
        "the scheme gives a roughness down to {finest}, and {asked} is asked: finishing must follow it",
    ),
    // Why a zone is not worked.
    (
        "zone-contour-not-monotone",
        "контур зони ({contour}) порожній, розірваний або веде назад до вільного торця",
        "the contour of the zone ({contour}) is empty, broken or leads back towards the free end",
    ),
    (
        "zone-contours-differ",
        "чорновий контур і заготовка зони не на одному відрізку Z або не з одного боку металу",
        "the rough contour and the blank of the zone differ in their stretch of Z or in their side",
    ),
    (
        "zone-settings-not-positive",
        "глибина ходу, недохід і відхід мають бути більші за нуль",
        "the depth of a pass, the approach and the retract must be greater than zero",
    ),
    (
        "rough-above-blank",
        "при Z{z} чорновий контур вищий за заготовку",
        "at Z{z} the rough contour is above the blank",
    ),
    (
        "flank-too-steep",
        "від Z{z} контур іде під кутом {angle}°, а різець допускає {limit}°",
        "from Z{z} the contour goes at {angle}°, and the tool allows {limit}°",
    ),
    (
        "stop-needs-steps",
        "від упора обробляють лише ступінчасті валики, що не спадають до патрона",
        "only stepped rollers that do not fall towards the chuck are worked against a stop",
    ),
    (
        "no-equidistant",
        "контуру на відстані {distance} мм не побудовано",
        "there is no contour at a distance of {distance} mm",
    ),
    (
        "too-many-passes",
        "проходів забагато: {passes}, а можна не більше {most}",
        "too many passes: {passes}, at most {most} are made",
    ),
    // What a zone is.
    ("zone-is", "зона: {kind}", "zone: {kind}"),
    ("zone-scheme", "схема для зони: {kind}", "scheme for the zone: {kind}"),
];

pub(super) const REMEDIES: &[(&str, &str, &str)] = &[
    (
        "zone-contour-not-monotone",
        "задайте контур від вільного торця до патрона, кожен елемент від кінця попереднього",
        "give the contour from the free end towards the chuck, each element from the end of the one before",
    ),
    (
        "zone-contours-differ",
        "обріжте обидва контури за межами зони",
        "cut both contours off at the bounds of the zone",
    ),
    ("zone-settings-not-positive", "задайте їх у мм, більші за нуль", "give them in mm, greater than zero"),
    (
        "rough-above-blank",
        "збільште заготовку або зменште припуск на чистову обробку там",
        "make the blank larger or the finishing allowance there smaller",
    ),
    (
        "flank-too-steep",
        "візьміть різець з більшим кутом або залиште цю ділянку для іншого переходу",
        "take a tool with a larger angle, or leave that stretch to another transition",
    ),
    ("stop-needs-steps", "візьміть схему петлі без упора", "take the loop without a stop"),
    (
        "no-equidistant",
        "візьміть меншу глибину ходу або контурну схему",
        "take a smaller depth of a pass, or the contour scheme",
    ),
    (
        "too-many-passes",
        "перевірте розміри заготовки і граничну глибину ходу",
        "check the size of the blank and the limiting depth of a pass",
    ),
    (
        "bar-with-steps",
        "напишіть kind: forging чи casting, або заберіть ступені заготовки",
        "write kind: forging or casting, or take the steps of the blank away",
    ),
    (
        "blank-step-rises-to-the-free-end",
        "перевірте порядок: від вільного торця до патрона діаметри заготовки не спадають",
        "check the order: from the free end towards the chuck no diameter of the blank falls",
    ),
    (
        "blank-step-beyond-blank",
        "diameter заготовки - найбільший; збільште його",
        "the diameter of the blank is its largest; raise it",
    ),
];

/// What the schemes and zones are called.
pub(super) const TERMS: &[(&str, &str, &str)] = &[
    ("verticals", "цикли вертикалей", "cycles of verticals"),
    ("levels", "цикли рівнів", "cycles of levels"),
    ("horizontals-a", "цикли горизонталей, форма а", "cycles of horizontals, form a"),
    ("horizontals-b", "цикли горизонталей, форма б", "cycles of horizontals, form b"),
    ("open", "відкрита", "open"),
    ("half-open", "напіввідкрита", "half-open"),
    ("closed", "закрита", "closed"),
    ("combined", "комбінована", "combined"),
    ("loop", "петля", "loop"),
    ("loop-against-stop", "петля від упора", "loop against a stop"),
    ("zigzag", "виток (зигзаг)", "zigzag"),
    ("descent", "спуск", "descent"),
    ("pick-up", "з підбором", "with pick-up"),
    ("semi-finishing", "з напівчистовим проходом", "with semi-finishing pass"),
    ("equidistant", "еквідистантна", "equidistant"),
    ("contour", "контурна", "contour"),
];
