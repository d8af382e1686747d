//! The words about programs for lathes: why one is not written, and what to do.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    (
        "lathe-language-not-documented",
        "для {control} нічого не написано: загальнодоступного опису мови не знайдено, з токарних слів відомі лише назви {words}",
        "nothing is written for {control}: no public description of its language was found, of its words for turning only \
         the names {words} are known",
    ),
    ("lathe-way-empty", "шлях не має жодного ходу", "the way has no move"),
    ("lathe-contour-empty", "контур не має жодного елемента", "the contour has no piece"),
    (
        "lathe-contour-apart",
        "елемент {piece} контуру починається не там, де закінчується попередній",
        "piece {piece} of the contour does not begin where the one before it ends",
    ),
    ("lathe-arc-without-radius", "дуга {piece} не має радіуса", "arc {piece} has no radius"),
    (
        "lathe-arc-too-small",
        "радіус дуги {piece} {radius} мм, а до її кінця треба щонайменше {needed} мм",
        "the radius of arc {piece} is {radius} mm, and its end needs at least {needed} mm",
    ),
    ("lathe-rapid-arc", "хід {piece}: прискорений хід по дузі", "move {piece}: a rapid along an arc"),
    ("lathe-no-tool", "номер інструмента 0", "the number of the tool is 0"),
    (
        "lathe-no-speed",
        "швидкість різання, її межа чи частота обертання не більша за 0",
        "the cutting speed, its limit or the spindle speed is not above 0",
    ),
    ("lathe-no-feed", "подача {feed} мм/об не більша за 0", "the feed {feed} mm/rev is not above 0"),
    (
        "lathe-contour-turns-back",
        "елемент {piece} контуру веде назад до вільного торця: поздовжній цикл його не обійде",
        "piece {piece} of the contour leads back towards the free end: a longitudinal cycle cannot follow it",
    ),
    (
        "lathe-contour-falls",
        "елемент {piece} контуру утворює западину впоперек осі: поперечний цикл його не обійде",
        "piece {piece} of the contour makes a hollow across the axis: a facing cycle cannot follow it",
    ),
    (
        "lathe-contour-beyond-blank",
        "контур сягає Ø{diameter}, за поверхню заготовки Ø{blank}",
        "the contour reaches Ø{diameter}, beyond the surface of the blank at Ø{blank}",
    ),
    (
        "lathe-contour-before-face",
        "контур починається перед торцем заготовки",
        "the contour begins before the face of the blank",
    ),
    (
        "lathe-nothing-to-cut",
        "контур починається на поверхні заготовки або закінчується на її торці: циклові немає з чого почати",
        "the contour begins on the surface of the blank or ends at its face: the cycle has nothing to begin with",
    ),
    ("lathe-not-above-zero", "`{key}` циклу не більше за 0", "`{key}` of the cycle is not above 0"),
    (
        "lathe-retract-beyond-clearance",
        "відвід {retract} мм більший за відстань до заготовки {clearance} мм: повернення зачепить її",
        "the retract of {retract} mm is more than the clearance of {clearance} mm: the way back would meet the blank",
    ),
    (
        "lathe-bore-too-narrow",
        "отвір Ø{bore} завузький: цикл починається на {clearance} мм ближче до осі",
        "the bore Ø{bore} is too narrow: the cycle begins {clearance} mm nearer to the axis",
    ),
    (
        "lathe-allowance",
        "цикл {control} не лишає припуску надійно",
        "the cycle of {control} does not leave an allowance reliably",
    ),
];

pub(super) const REMEDIES: &[(&str, &str, &str)] = &[
    (
        "lathe-language-not-documented",
        "візьміть linuxcnc чи sinumerik, або додайте рядки таблиць lathe-… з посібника",
        "take linuxcnc or sinumerik, or add rows to the tables lathe-… from its manual",
    ),
    ("lathe-way-empty", "перевірте, чи є над контуром припуск", "check whether there is stock over the contour"),
    ("lathe-contour-empty", "задайте контур", "give a contour"),
    ("lathe-contour-apart", "з'єднайте елементи", "join the pieces"),
    ("lathe-arc-without-radius", "задайте радіус більший за 0", "give a radius above 0"),
    (
        "lathe-arc-too-small",
        "збільшіть радіус або зблизьте кінці дуги",
        "make the radius larger or the ends nearer to each other",
    ),
    ("lathe-rapid-arc", "дайте дузі подачу", "give the arc a feed"),
    ("lathe-no-tool", "дайте інструменту номер від 1", "give the tool a number from 1"),
    (
        "lathe-no-speed",
        "задайте `--spindle` або назвіть верстат у файлі (`machine:`)",
        "give `--spindle`, or name a lathe in the file (`machine:`)",
    ),
    ("lathe-no-feed", "задайте подачу від 0.0001 мм/об", "give a feed from 0.0001 mm/rev"),
    (
        "lathe-contour-turns-back",
        "поділіть контур на дві зони або візьміть програму з окремих ходів",
        "divide the contour into two zones, or take the program of single moves",
    ),
    (
        "lathe-contour-falls",
        "візьміть поздовжній цикл або програму з окремих ходів",
        "take the longitudinal cycle, or the program of single moves",
    ),
    ("lathe-contour-beyond-blank", "перевірте розміри заготовки", "check the sizes of the blank"),
    ("lathe-contour-before-face", "перевірте припуск на торець", "check the stock on the face"),
    (
        "lathe-nothing-to-cut",
        "почніть контур там, де є припуск, або візьміть програму з окремих ходів",
        "begin the contour where there is stock, or take the program of single moves",
    ),
    ("lathe-not-above-zero", "задайте довжину більшу за 0", "give a length above 0"),
    (
        "lathe-retract-beyond-clearance",
        "зменшіть відвід або збільшіть відстань",
        "make the retract smaller or the clearance larger",
    ),
    ("lathe-bore-too-narrow", "зменшіть відстань до заготовки", "make the clearance smaller"),
    (
        "lathe-allowance",
        "дайте цикл за чорновим контуром, без припуску",
        "give the cycle the rough contour, without an allowance",
    ),
];
