//! The words for lists of points: what is wrong in one, and what to do about it.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    ("no-points", "у списку немає точок", "there are no points in the list"),
    ("too-many-points", "точок {count}, а можна не більше {most}", "{count} points are more than {most}"),
    ("coordinate-too-large", "`{word}` виходить за {most} мм", "`{word}` is beyond {most} mm"),
    ("not-a-number", "`{word}` не є числом", "`{word}` is not a number"),
    ("not-a-point", "точка має дві координати, а тут їх {count}", "a point has two coordinates, here are {count}"),
    (
        "not-a-node",
        "вузол записують як `номер x y`, а тут слів: {count}",
        "a node is `number x y`, the words here are {count}",
    ),
    ("not-a-node-number", "`{word}` не є номером вузла", "`{word}` is not the number of a node"),
    ("node-twice", "вузол {word} стоїть двічі", "the node {word} stands twice"),
    ("distance-kind", "відстаней виду {word} програма не знає", "distances of the kind {word} are not read"),
    ("distance-kind-missing", "бракує EDGE_WEIGHT_TYPE", "EDGE_WEIGHT_TYPE is missing"),
    (
        "dimension",
        "DIMENSION дорівнює `{word}`, а вузлів {count}",
        "DIMENSION is `{word}`, and there are {count} nodes",
    ),
];

pub(super) const REMEDIES: &[(&str, &str, &str)] = &[
    ("no-points", "напишіть для кожної рядок `x,y`", "write a line `x,y` for each"),
    ("too-many-points", "поділіть список", "split the list"),
    ("coordinate-too-large", "пишіть координату в міліметрах", "write the coordinate in millimetres"),
    (
        "not-a-number",
        "пишіть міліметри: 12.5, а між `;` також 12,5",
        "write millimetres: 12.5, or between `;` also 12,5",
    ),
    (
        "not-a-point",
        "пишіть `x,y` з десятковою крапкою (12.5,-40) або `x;y` з десятковою комою (12,5;-40)",
        "write `x,y` with a decimal point (12.5,-40), or `x;y` with a decimal comma (12,5;-40)",
    ),
    ("not-a-node", "пишіть, наприклад, `1 12.5 -40`", "write, for example, `1 12.5 -40`"),
    ("not-a-node-number", "нумеруйте вузли цілими числами від 1", "number the nodes from 1"),
    ("node-twice", "дайте кожному вузлу свій номер", "number each node once"),
    ("distance-kind", "пишіть EUC_2D: інших немає", "write EUC_2D: no other kind is known"),
    ("distance-kind-missing", "напишіть `EDGE_WEIGHT_TYPE : EUC_2D`", "write `EDGE_WEIGHT_TYPE : EUC_2D`"),
    ("dimension", "напишіть, скільки вузлів далі", "write the number of nodes that follow"),
];
