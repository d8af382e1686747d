//! The words about programs for LinuxCNC and Fanuc that those for 2С42-65 do not have.

/// Code, Ukrainian, English: what is wrong.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    ("unknown-word", "слово {word} тут не виконується", "the word {word} is not carried out here"),
    (
        "number-too-long",
        "у числі адреси {address} більше шести знаків після точки",
        "the number of {address} has more than six places behind the point",
    ),
    (
        "number-without-point",
        "число адреси {address} без точки: узято міліметри (калькуляторний запис)",
        "the number of {address} has no point: taken as millimetres (calculator-type input)",
    ),
    ("comment-open", "коментар не закрито", "the comment is not closed"),
    (
        "group-exclusive",
        "{first} і {second} з однієї групи в одному кадрі",
        "{first} and {second} of one group in one block",
    ),
    ("sub-without-pair", "sub, return чи endsub без своєї пари", "sub, return or endsub without the one it belongs to"),
    ("call-without-number", "M98 без номера P", "M98 without a number P"),
    ("motion-missing", "розмір є, а функції руху немає", "there is a dimension and no function of motion for it"),
    ("machine-position-with-g91", "G53 при G91", "G53 while G91 acts"),
    ("axes-missing", "{function} без жодної осі", "{function} names no axis"),
    (
        "axes-taken-twice",
        "{first} і {second} обидві беруть осі кадру",
        "{first} and {second} both take the axes of the block",
    ),
    ("dwell-time-missing", "G4 без часу: {words}", "G4 without a time: {words}"),
    ("corrector-missing", "G43 без H", "G43 without H"),
    (
        "arc-radius-alone",
        "радіус R не дає дуги: кінець збігається з початком або R 0",
        "the radius R makes no arc: its end is its start, or R is 0",
    ),
    (
        "arc-radius-short",
        "радіус {radius} мм не дістає кінця дуги: треба щонайменше {needed} мм",
        "the radius {radius} mm does not reach the end of the arc: at least {needed} mm are needed",
    ),
    ("cycle-levels", "дно циклу Z{z} вище за площину R{r}", "the bottom of the cycle Z{z} is above its plane R{r}"),
    ("cycle-plane", "постійний цикл не в площині G17", "a fixed cycle outside the plane G17"),
    (
        "tap-counterclockwise",
        "нарізання різі при шпинделі проти годинникової стрілки",
        "tapping while the spindle turns counterclockwise",
    ),
];

/// Code, Ukrainian, English: what to do.
pub(super) const REMEDIES: &[(&str, &str, &str)] = &[
    (
        "unknown-word",
        "виконувані слова дають `technolog table iso-addresses`, `iso-g-functions`, `iso-m-functions`",
        "`technolog table iso-addresses`, `iso-g-functions` and `iso-m-functions` list what is carried out",
    ),
    ("number-too-long", "заокругліть число", "round the number"),
    ("number-without-point", "пишіть точку: X10.", "write the point: X10."),
    ("comment-open", "допишіть )", "write the )"),
    ("group-exclusive", "поділіть кадр на два або лишіть одну", "make two blocks of it or keep one of them"),
    (
        "sub-without-pair",
        "закінчіть o… sub рядком o… endsub з тим самим ім'ям; одна в одній не стоять",
        "end o… sub with o… endsub of the same name; none stands within another",
    ),
    ("call-without-number", "задайте P", "give P"),
    ("motion-missing", "задайте G0, G1, G2 або G3; з G53 - G0 чи G1", "give G0, G1, G2 or G3; with G53 G0 or G1"),
    ("machine-position-with-g91", "задайте перед нею G90", "give G90 before it"),
    ("axes-missing", "задайте осі, наприклад G91 G28 Z0", "name the axes, as in G91 G28 Z0"),
    ("axes-taken-twice", "поділіть кадр на два", "make two blocks of it"),
    ("dwell-time-missing", "задайте час", "give the time"),
    ("corrector-missing", "задайте H", "give H"),
    ("arc-radius-alone", "повне коло задають I, J, K", "give a full circle by I, J, K"),
    ("arc-radius-short", "перевірте кінцеву точку й радіус", "check end and radius"),
    ("cycle-levels", "задайте Z, нижчу за R", "give a Z below R"),
    ("cycle-plane", "задайте перед циклом G17", "give G17 before the cycle"),
    ("tap-counterclockwise", "задайте M3", "give M3"),
];
