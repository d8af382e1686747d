//! Mistakes of part files.

use super::Pair;

pub(super) const SENTENCES: &[Pair] = &[
    // The part.
    ("the part has no holes", "деталь не має отворів"),
    ("give at least one group", "задайте хоча б одну групу"),
    ("a name must not be empty", "назва не може бути порожньою"),
    ("`{0}` is {1}: it must be above zero", "`{0}` дорівнює {1}: має бути більше нуля"),
    ("give millimetres, without a sign", "задайте міліметри, без знака"),
    ("`mass` must be above zero, in kg", "`mass` має бути більше нуля, у кг"),
    (
        "did you mean `{0}`? `technolog table materials` lists them all",
        "може, `{0}`? Усі перелічує `technolog table materials`",
    ),
    ("`technolog table materials` lists them", "їх перелічує `technolog table materials`"),
    ("unknown material `{0}`", "невідомий матеріал `{0}`"),
    ("known machines: {0}", "відомі верстати: {0}"),
    ("unknown machine `{0}`", "невідомий верстат `{0}`"),
    ("`{0}` is neither {1} nor a distance in mm", "`{0}` - ні {1}, ні відстань у мм"),
    ("no clamp screw `{0}`", "немає затискного гвинта `{0}`"),
    ("a point has two coordinates [X, Y], not {0}", "точка має дві координати [X, Y], а не {0}"),
    ("separate coordinates with a comma, decimals with a point", "координати розділяйте комою, а десяткові - крапкою"),
    // Patterns.
    ("give one of grid, line and circle", "задайте щось одне: grid, line чи circle"),
    ("the pattern is of no kind", "не сказано, яке це розташування"),
    ("a pattern is of one kind", "розташування буває одне"),
    (
        "a step has two figures [X, Y] or is one for both, not {0}",
        "крок - це два числа [X, Y] або одне для обох, а не {0}",
    ),
    ("`{0}` is {1}: it must be a whole number, at least {2}", "`{0}` дорівнює {1}: має бути ціле число, не менше {2}"),
    ("the patterns make {0} points, and a part may have {1}", "розташування дають {0} точок, а деталь може мати {1}"),
    ("mind the counts", "перевірте кількості"),
    // A group of holes.
    (
        "a blind hole has a depth; a through hole `through: true`",
        "глухий отвір має глибину, наскрізний - `through: true`",
    ),
    ("`at` and `pattern` both say where the holes are", "і `at`, і `pattern` кажуть, де отвори"),
    ("the group has no points", "група не має точок"),
    ("a list of points is expected here", "тут очікується список точок"),
    (
        "`{0}` is outside IT5 to IT14, which the table it-grades covers",
        "`{0}` - поза IT5…IT14, які є в таблиці it-grades",
    ),
    (
        "`{0}` is outside {1} to {2}, which the table {3} covers",
        "`{0}` - поза межами від {1} до {2}, які є в таблиці {3}",
    ),
    ("roughness is in micrometres, `Ra 12.5` or `Rz 80`", "шорсткість - у мікрометрах, `Ra 12.5` чи `Rz 80`"),
    (
        "the face is Ø{0}, and the blank measures {1} across its corners",
        "торець має Ø{0}, а заготовка - {1} від кута до кута",
    ),
    ("give the diameter of the face around the hole, in mm", "дайте діаметр торця навколо отвору, у мм"),
    (
        "{0} mm is coarser than any tolerance of the tables A.8 and A.9",
        "{0} мм - грубше за будь-який допуск таблиць А.8 і А.9",
    ),
    (
        "give the full width of the tolerance in mm, `0.46`, or a grade, `IT12`",
        "задайте всю ширину допуску в мм, `0.46`, або квалітет, `IT12`",
    ),
    // Steps.
    (
        "`depth` counts from the entry face to the end of the step, `length` is the step's own",
        "`depth` рахується від торця входу до кінця ступеня, `length` - довжина самого ступеня",
    ),
    ("the steps end at {0}, but the blank is {1} thick", "ступені кінчаються на {0}, а товщина заготовки {1}"),
    ("the steps end at {0}, but the hole is {1} deep", "ступені кінчаються на {0}, а глибина отвору {1}"),
    ("give it here, or to the hole for all steps", "задайте її тут або отвору, для всіх ступенів"),
    ("`depth` and `length` both say where the step ends", "і `depth`, і `length` кажуть, де кінець ступеня"),
    ("step {0} ends at {1}, and the one before it at {2}", "ступінь {0} кінчається на {1}, а попередній на {2}"),
    (
        "the step before the last ends at {0}, and the blank is {1} thick",
        "передостанній ступінь кінчається на {0}, а товщина заготовки {1}",
    ),
    (
        "or `length`; only the last step of a through hole may leave both out",
        "або `length`; обидва може опустити лише останній ступінь наскрізного отвору",
    ),
    ("leave it out, or give the narrowest", "приберіть його або задайте найвужчий"),
    ("{0} of the hole is wider than Ø{1}, its narrowest step", "{0} отвору ширший за Ø{1}, його найвужчий ступінь"),
    ("{0} of the hole is {1} in its step", "{0} отвору - це {1} у його ступені"),
    ("write it once, or the same twice", "напишіть один раз або двічі те саме"),
    (
        "the hole's own diameter goes on behind the last step: say how deep",
        "діаметр самого отвору іде за останнім ступенем: скажіть, як глибоко",
    ),
    (
        "the steps end at {0}, which leaves nothing of a hole {1} deep for its own {2}",
        "ступені кінчаються на {0}, і від отвору глибиною {1} не лишається нічого для його {2}",
    ),
    ("the hole's own diameter goes on behind the last step", "діаметр самого отвору іде за останнім ступенем"),
    ("step {0} is Ø{1} like the one before it", "ступінь {0} - Ø{1}, як і попередній"),
    ("join the two", "об'єднайте їх"),
    ("step {0} is Ø{1}, wider than what leads to it", "ступінь {0} - Ø{1}, ширший за те, що до нього веде"),
    (
        "no axial tool reaches an inner chamber; give it as `groove`",
        "осьовий інструмент до внутрішньої камери не дістане; задайте її як `groove`",
    ),
    (
        "the chamfer at the entry is {0} here and {1} in the first step",
        "фаска на вході тут {0}, а в першому ступені {1}",
    ),
    // Cones, cast holes.
    ("`angle` and `taper` both say how fast the cone narrows", "і `angle`, і `taper` кажуть, як звужується конус"),
    (
        "or `taper`, the difference of the diameters over the length",
        "або `taper`, різниця діаметрів, поділена на довжину",
    ),
    ("an angle of {0}: it must lie between 0 and 180 degrees", "кут {0}: має бути між 0 і 180 градусами"),
    (
        "give the full angle of the cone in degrees, with at most three decimal places",
        "задайте повний кут конуса в градусах, не більше трьох знаків після крапки",
    ),
    (
        "give the difference of the diameters over the length between them: 0.02 for 1:50",
        "задайте різницю діаметрів, поділену на довжину між ними: 0.02 для 1:50",
    ),
    ("a taper of {0} is no cone", "конусність {0} - не конус"),
    (
        "say `state: cast` or `state: pre-machined`, or leave it out",
        "скажіть `state: cast` чи `state: pre-machined` або приберіть його",
    ),
    ("`state_diameter` is given, but the blank is solid there", "є `state_diameter`, а заготовка там суцільна"),
    (
        "`outer_wall: true` is for holes that are in the blank, and the blank is solid there",
        "`outer_wall: true` - для отворів, що вже є в заготовці, а вона там суцільна",
    ),
    // Diameters and threads.
    (
        "`diameter` is {0}, but {1} is Ø{2} and the hole under it Ø{3}",
        "`diameter` - {0}, а {1} - це Ø{2}, отвір під неї Ø{3}",
    ),
    ("leave `diameter` out: the thread says it", "приберіть `diameter`: його каже різь"),
    (
        "write a metric thread as `M8-6H` or `M8x1-6H`, a conical one as `K1/2`",
        "метричну різь пишіть як `M8-6H` чи `M8x1-6H`, конічну як `K1/2`",
    ),
    ("`{0}` is no thread: {1}", "`{0}` - не різь: {1}"),
    ("unknown thread `{0}`", "невідома різь `{0}`"),
    ("it begins with neither M nor K", "вона не починається ні з M, ні з K"),
    ("the table A.3 has no row `tap`", "таблиця А.3 не має рядка `tap`"),
    (
        "the pitch {0} must be above zero and not above {1}, the coarse one of {2}",
        "крок {0} має бути більше нуля й не більше за {1}, великий крок {2}",
    ),
    (
        "`{0}` is the field of a bolt; that of a hole has a capital letter, `6H`",
        "`{0}` - поле болта; поле отвору пишуть великою літерою, `6H`",
    ),
    ("`{0}` is no tolerance field of a thread, such as `6H`", "`{0}` - не поле допуску різі, як-от `6H`"),
    (
        "the nearest known is `{0}`; `technolog table tap-drills` lists them, {1} to {2}",
        "найближча відома - `{0}`; їх перелічує `technolog table tap-drills`, від {1} до {2}",
    ),
    ("the table tap-drills is empty", "таблиця tap-drills порожня"),
    ("`{0}` does not belong to its size in inches", "`{0}` не належить до її розміру в дюймах"),
    (
        "the nearest known is `{0}`; `technolog table conical-threads` lists them",
        "найближча відома - `{0}`; їх перелічує `technolog table conical-threads`",
    ),
    ("`technolog table conical-threads` lists them", "їх перелічує `technolog table conical-threads`"),
    ("{0}; write `10H12`", "{0}; напишіть `10H12`"),
    (
        "`{0}` is no tolerance field the tables know: they are for H6 to H14; give other fields as {nominal: {1}, upper: …, lower: …}",
        "`{0}` - поле допуску, якого таблиці не знають: вони для H6…H14; інші поля задайте як {nominal: {1}, upper: …, lower: …}",
    ),
    ("grade {0} is outside 1 to 18", "квалітет {0} - поза 1…18"),
    (
        "grade {0} is outside 6 to 14, which the tables A.8 and A.9 cover",
        "квалітет {0} - поза 6…14, які є в таблицях А.8 і А.9",
    ),
    ("`thread-hole-grade` {0} is no tolerance grade", "`thread-hole-grade` {0} - не квалітет"),
    ("the upper deviation {0} must be above the lower {1}", "верхнє відхилення {0} має бути більше за нижнє {1}"),
    (
        "the deviations {0} and {1} are not small beside Ø{2}; they are in mm",
        "відхилення {0} і {1} не малі проти Ø{2}; вони в мм",
    ),
    (
        "a tolerance of {0} mm is tighter than grade 6 at Ø{1}, the finest of the tables",
        "допуск {0} мм тісніший за квалітет 6 для Ø{1}, найточніший у таблицях",
    ),
    (
        "Ø{0} is outside Ø{1} to Ø{2}, which the drills of the catalogs begin",
        "Ø{0} - поза Ø{1}…Ø{2}, які починають свердла каталогів",
    ),
    ("no IT {0} at {1} mm in the table it-grades", "у таблиці it-grades немає IT {0} для {1} мм"),
    // What does not fit together.
    ("the {0} is {1} deep, and Ø{2} only to {3}", "{0} має глибину {1}, а Ø{2} - лише до {3}"),
    ("make it shallower than the hole", "зробіть мілкішим за отвір"),
    ("the groove reaches to {0}, and the hole only to {1}", "канавка сягає {0}, а отвір - лише {1}"),
    ("`depth` counts from the entry face to its nearer side", "`depth` рахується від торця входу до ближчого її боку"),
    (
        "the hole in the blank is Ø{0}, and the finished one may be Ø{1}",
        "отвір у заготовці Ø{0}, а готовий може бути Ø{1}",
    ),
    (
        "give the diameter that stands in the blank; it leaves something to cut",
        "задайте діаметр у заготовці; він лишає що різати",
    ),
    ("the {0} is Ø{1}, and the hole there Ø{2}", "{0} - Ø{1}, а отвір там Ø{2}"),
    ("make it wider than the hole, or leave it out", "зробіть ширшим за отвір або приберіть"),
    ("counterbore", "цеківка"),
    ("countersink", "зенківка"),
    ("chamfer", "фаска"),
    ("groove", "канавка"),
    ("cone", "конус"),
    ("face", "торець"),
    ("two groups of holes are named `{0}`", "дві групи отворів звуться `{0}`"),
    ("name each group once", "назвіть кожну групу один раз"),
    ("the clamp at [{0}, {1}] is not on the blank", "притискач у точці [{0}, {1}] не на заготовці"),
    ("the clamp at [{0}, {1}] presses on hole {2}", "притискач у точці [{0}, {1}] тисне на отвір {2}"),
    ("put it beside the hole", "поставте його поруч з отвором"),
    (
        "hole {0}: a through hole is {1} deep, but the blank is {2} thick",
        "отвір {0}: наскрізний отвір має глибину {1}, а товщина заготовки {2}",
    ),
    ("leave `depth` out, or make it the thickness", "приберіть `depth` або зробіть рівною товщині"),
    (
        "hole {0}: a blind hole is {1} deep in a blank {2} thick",
        "отвір {0}: глухий отвір має глибину {1} у заготовці товщиною {2}",
    ),
    ("say `through: true`, or make it shallower", "скажіть `through: true` або зробіть мілкішим"),
    ("hole {0}: {1} mm deep is a mark and no hole", "отвір {0}: глибина {1} мм - це слід, а не отвір"),
    ("mind the unit: depths are in mm, and {0} is the least", "зважте на одиницю: глибини в мм, найменша {0}"),
    ("hole {0}: Ø{1}", "отвір {0}: Ø{1}"),
    (
        "{0} is not inside the blank at any of its {1} points",
        "{0} не вміщується в заготовці в жодній зі своїх точок, яких {1}",
    ),
    ("{0}; `datum` says where its zeros lie", "{0}; де її нулі, каже `datum`"),
    ("the first at [{0}, {1}]", "перша - [{0}, {1}]"),
    (
        "{0} is not inside the blank at {1} of its {2} points, {3}",
        "{0} не вміщується в заготовці в {1} точках із {2}, {3}",
    ),
    ("{0} at [{1}, {2}] is not inside the blank", "{0} у точці [{1}, {2}] не вміщується в заготовці"),
    (
        "the blank reaches from X {0} to {1} and from Y {2} to {3}",
        "заготовка сягає від X {0} до {1} і від Y {2} до {3}",
    ),
    ("the holes of {0} run into each other", "отвори {0} заходять один в одного"),
    ("every hole of {0} runs into hole {1} at line {2}", "кожен отвір {0} заходить в отвір {1}, рядок {2}"),
    ("mind the diameter, and the points: {0}", "перевірте діаметр і точки: {0}"),
    (
        "{0} of the {1} holes of {2} run into others; the first: {3}",
        "{0} з {1} отворів {2} заходять в інші; перший: {3}",
    ),
    ("hole {0} {1}", "отвір {0} {1}"),
    ("the centres are {0} mm apart, and the holes need {1}", "між центрами {0} мм, а отворам треба {1}"),
    ("at [{0}, {1}] runs into hole {2} at line {3}", "у точці [{0}, {1}] заходить в отвір {2}, рядок {3}"),
];
