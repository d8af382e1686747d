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
    // What a zone is.
    ("zone-is", "зона: {kind}", "zone: {kind}"),
    ("zone-scheme", "схема для зони: {kind}", "scheme for the zone: {kind}"),
];

pub(super) const REMEDIES: &[(&str, &str, &str)] = &[
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
    ("zigzag", "виток (зигзаг)", "zigzag"),
    ("descent", "спуск", "descent"),
    ("pick-up", "з підбором", "with pick-up"),
    ("semi-finishing", "з напівчистовим проходом", "with semi-finishing pass"),
    ("equidistant", "еквідистантна", "equidistant"),
    ("contour", "контурна", "contour"),
];
