//! The words about a hole: how it is visited, its scheme, its diameters; and that a row is not confirmed.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // Visiting the holes.
    (
        "visiting-method",
        "{method} (квалітет {it}, допуск міжосьової відстані {centre} мм, K_T = {ratio})",
        "{method} (grade {it}, centre tolerance {centre} mm, K_T = {ratio})",
    ),
    (
        "position-lost-at-tool-change",
        "1.3.1 радить робити кінцеві переходи послідовно, не рухаючи деталь; верстат змінює інструмент у X {x} Y {y}, \
         тож стіл рухається і правила дотримати не можна: {tools} інструментами паралельно {parallel} хв, послідовно \
         {sequential} хв",
        "section 1.3.1 finishes each hole without moving the part; this machine changes tools at X {x} Y {y}, which \
         moves the table, so the rule cannot be kept: with {tools} tools {parallel} min in parallel, {sequential} min \
         in sequence",
    ),
    (
        "visited-in-parallel",
        "за 1.3.1 послідовний обхід був би швидший, але заміна інструмента в X {x} Y {y} рухає стіл: {tools} \
         інструментами паралельно {parallel} хв, послідовно {sequential} хв",
        "by 1.3.1 the sequential method would be quicker, but changing tools at X {x} Y {y} moves the table: with \
         {tools} tools {parallel} min in parallel, {sequential} min in sequence",
    ),
    // Schemes.
    (
        "stages",
        "етапи: {stages} (Δ0 = {delta} мм, σс = {sigma} мм)",
        "stages: {stages} (Δ0 = {delta} mm, σc = {sigma} mm)",
    ),
    ("no-stages", "для квалітету {it} етапів таблиця не дає", "the table gives no stages for grade {it}"),
    (
        "table-for-hole",
        "квалітет {it} шукаємо в {table} за рядками квалітету {asked-it}, допуск міжосьової відстані {centre} мм",
        "grade {it} is looked up in {table} by the rows of grade {asked-it}, centre tolerance {centre} mm",
    ),
    ("cell", "береться {take}", "taken: {take}"),
    ("scheme", "схема {scheme} (квалітет {it}, {roughness})", "scheme {scheme} (grade {it}, {roughness})"),
    ("which-of-two", "у клітинці {schemes}; береться {take}", "the cell offers {schemes}; taken: {take}"),
    (
        "centre",
        "центрувати: у суцільному металі, глибина {ratio} діаметра",
        "centre first: solid metal, {ratio} diameters deep",
    ),
    (
        "no-centre",
        "центрування не потрібне: квалітет {it}, Ø{diameter}, глибина {ratio} D",
        "no centring is asked for: grade {it}, Ø{diameter}, {ratio} D deep",
    ),
    ("twin", "схема {scheme} з центруванням - це схема {centred}", "scheme {scheme} with centring is scheme {centred}"),
    (
        "no-twin",
        "схема {scheme} не має пари з центруванням; воно додається",
        "scheme {scheme} has no centred twin; centring is added",
    ),
    ("transitions", "переходи схеми {scheme}", "the transitions of scheme {scheme}"),
    (
        "no-scheme",
        "таблиці не дають схеми: квалітет {it}, {roughness}, допуск {centre} мм; графи шорсткості {columns}",
        "the tables give no scheme: grade {it}, {roughness}, centre tolerance {centre} mm; roughness columns {columns}",
    ),
    (
        "no-route",
        "{diameter}: жодна зі схем не здійсненна (відхилено {tried})",
        "{diameter}: no scheme can be carried out ({tried} refused)",
    ),
    (
        "finish-elsewhere",
        "за таблицями отвір остаточно обробляють на верстаті іншого типу; тут схема {scheme}",
        "the tables finish this hole on a machine of another type; scheme {scheme} is what is done here",
    ),
    (
        "grade-without-distance",
        "centre_tolerance: IT{it} потребує двох отворів у групі; вкажіть ширину допуску в мм",
        "centre_tolerance: IT{it} needs two holes in the group; give the width in mm",
    ),
    (
        "grade-outside-table",
        "IT{it} на міжосьовій відстані {distance} мм поза таблицею: {why}",
        "IT{it} at a centre distance of {distance} mm is outside the table: {why}",
    ),
    (
        "point-breaks-through",
        "вершина свердла Ø{diameter} сягає {depth} >= {limit} мм товщини заготовки: глухий отвір проб’ється",
        "the point of the drill Ø{diameter} reaches {depth} >= {limit} mm, the blank's thickness: the blind hole breaks through",
    ),
    (
        "spot-too-deep",
        "лунка Ø{diameter} глибиною {depth} >= {limit} мм, глибини отвору",
        "the spot Ø{diameter} is {depth} >= {limit} mm deep, the depth of the hole",
    ),
    (
        "too-heavy",
        "маса {mass} > {limit} кг, найбільшої для верстата",
        "mass {mass} > {limit} kg, the most the machine takes",
    ),
    ("not-planned", "{operation}: цей перехід тут не проектується", "{operation}: not planned here"),
    ("rows-rejected", "рядки за графою {column}: {rows}", "rows by the column {column}: {rows}"),
    // Diameters.
    (
        "allowance",
        "{operation}: припуск {taken} мм на діаметр, діапазон {low}-{high} мм",
        "{operation}: allowance {taken} mm on diameter, range {low}-{high} mm",
    ),
    (
        "ground-to-size",
        "інструмент Ø{nominal} каталогу, виконаний на розмір Ø{size}",
        "the catalog's Ø{nominal} cutter, made to Ø{size}",
    ),
    (
        "rough-boring",
        "чорнове розточування: {stock} мм на діаметр за проходів: {passes}, по {low}-{high} мм",
        "rough boring: {stock} mm on diameter in passes: {passes}, {low}-{high} mm each at most",
    ),
    (
        "stock-for-elsewhere",
        "лишено {stock} мм на діаметр для іншого верстата",
        "{stock} mm on diameter left for the other machine",
    ),
    ("one-pass", "свердлити Ø{diameter} за один перехід", "drill Ø{diameter} in one pass"),
    (
        "two-passes",
        "свердлити у два переходи: спершу Ø{first}, далі Ø{diameter} (перше свердло {low}-{high} мм)",
        "drill in two passes: Ø{first} first, then Ø{diameter} (first drill {low}-{high} mm)",
    ),
    (
        "first-drill",
        "перше свердло Ø{first}: {share-min}-{share-max} від Ø{diameter}",
        "first drill Ø{first}: {share-min}-{share-max} of Ø{diameter}",
    ),
    (
        "two-passes-cost",
        "проти одного свердла: час {time} хв на отвір, осьова сила {thrust} Н замість {one-thrust} Н",
        "against one drill: {time} min per hole, thrust {thrust} N instead of {one-thrust} N",
    ),
    (
        "bored-by-stand-in",
        "Ø{diameter} замалий для оправки (від Ø{smallest}); замість розточування - {instead}",
        "Ø{diameter} is too small for a boring bar (from Ø{smallest}); {instead} stands in for boring",
    ),
    (
        "too-small-to-bore",
        "{operation}: Ø{diameter} < Ø{smallest}, найменшого отвору для оправки",
        "{operation}: Ø{diameter} < Ø{smallest}, the smallest hole a bar enters",
    ),
    (
        "no-drill",
        "немає свердла Ø{diameter}, що сягає дна; найближчі {below} і {above}",
        "no drill Ø{diameter} that reaches; the nearest are {below} and {above}",
    ),
    (
        "no-drill-in-allowance",
        "{operation} до Ø{diameter}: немає свердла від Ø{low} до Ø{high}",
        "{operation} to Ø{diameter}: no drill from Ø{low} to Ø{high}",
    ),
    (
        "no-drill-before-boring",
        "під розточування до Ø{diameter} немає свердла від Ø{smallest} до Ø{largest}",
        "boring to Ø{diameter}: no drill from Ø{smallest} to Ø{largest}",
    ),
    (
        "no-bar-enters",
        "до Ø{diameter}: жодна оправка не входить в отвір Ø{hole}",
        "to Ø{diameter}: no bar enters the hole Ø{hole}",
    ),
    (
        "bar-set-by-hand",
        "розточування за кілька проходів: між проходами оправку переналагоджують вручну; великі отвори доцільно фрезерувати (1.2.1)",
        "boring in several passes: the bar is set anew by hand between them; large holes are better milled (1.2.1)",
    ),
    ("spot-by-drill", "лунка Ø{spot}: {share} від свердла Ø{drill}", "spot Ø{spot}: {share} of the drill Ø{drill}"),
    (
        "spot-by-depth",
        "лунка Ø{spot}, не {share} від свердла Ø{drill}: глибша за половину отвору не буде",
        "spot Ø{spot}, not {share} of the drill Ø{drill}: no deeper than half of the hole",
    ),
    ("spot-by-chamfer", "лунка Ø{spot} утворює і фаску", "spot Ø{spot} makes the chamfer too"),
    ("travel", "недобіг {approach} мм, перебіг {overrun} мм", "approach {approach} mm, overrun {overrun} mm"),
    // Of any row.
    ("unconfirmed", "не підтверджено: {table}, рядок {row}: {why}", "unconfirmed: {table}, row {row}: {why}"),
];
