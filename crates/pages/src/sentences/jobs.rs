//! The words about jobs: why a cycle, and what does not fit on the machine.

/// Code, Ukrainian, English.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    ("machining-cycle", "цикл {cycle}, глибина {ratio} діаметра", "cycle {cycle}, {ratio} diameters deep"),
    (
        "no-room-under-part",
        "інструмент виходить на {below} мм під деталь, а пристрій заввишки {height} мм: він зайде в стіл",
        "a tool comes out {below} mm under the part and the fixture is {height} mm high: it goes into the table",
    ),
    (
        "supports-assumed",
        "висоту пристрою не задано (fixture.height), а інструмент виходить на {below} мм під деталь: прийнято опори {height} мм",
        "no height of the fixture is given (fixture.height) and a tool comes out {below} mm under the part: supports of {height} mm are assumed",
    ),
    (
        "change-over-part",
        "точка заміни інструмента X{x} Y{y} - над деталлю",
        "the place of the tool change, X{x} Y{y}, is over the part",
    ),
    (
        "ways-over-clamps",
        "шляхи інструментів ведуть над притискачами {clamps} на {height} мм над деталлю, а висота притискачів не відома",
        "ways of tools lead over the clamps at {clamps}, {height} mm over the part, and how high these are is not known",
    ),
    ("cooled", "{operation}: з охолодженням", "{operation}: with coolant"),
    ("dry", "{operation}: без охолодження", "{operation}: without coolant"),
    ("withdrawal", "між отворами на {height} мм над деталлю", "{height} mm over the part from hole to hole"),
    (
        "no-room-over-part",
        "від столу до торця шпинделя треба {needed} мм, а верстат дає найбільше {most}: інструмент довжиною {tool} не проходить над деталлю",
        "{needed} mm from table to spindle nose are needed and the machine gives {most} at most: a tool of {tool} does not pass over the part",
    ),
    (
        "quill-too-short",
        "інструменту T{tool} треба {way} мм ходу повзуна, а верстат має {travel}",
        "tool T{tool} needs {way} mm of the quill's travel and the machine has {travel}",
    ),
];
