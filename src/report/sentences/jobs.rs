//! The words about jobs: why a cycle, and what does not fit on the machine.

/// Code, Ukrainian, English.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    ("machining-cycle", "цикл {cycle}, глибина {ratio} діаметра", "cycle {cycle}, {ratio} diameters deep"),
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
