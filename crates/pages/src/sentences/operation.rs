//! The words about a turning operation as a whole.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    (
        "no-lathe",
        "верстат не названо (`machine:`): придатність поверхонь, глибина, режими і потужність не перевірені",
        "no lathe is named (`machine:`): what it can finish, depth, conditions and power are not checked",
    ),
    (
        "no-intermediate-contour",
        "проміжний припуск не можна накласти: {why}",
        "the intermediate allowance cannot be laid on: {why}",
    ),
    ("no-rough-contour", "чорновий контур не можна побудувати: {why}", "the rough contour cannot be laid: {why}"),
    (
        "set-up-not-held",
        "установ {number}: деталь нема за що тримати в патроні; тримайте в центрах або залиште довшу заготовку",
        "set-up {number}: nothing of the part is long enough for the jaws; hold it between centres or leave a longer blank",
    ),
    (
        "far-face-cut-away",
        "установ {number}: за деталлю лишається {length} мм заготовки; їх знято підрізанням торця, відрізання не \
         спроєктовано",
        "set-up {number}: {length} mm of the blank are left behind the part; they are faced away, parting is not planned",
    ),
    (
        "bore-drilled-first",
        "отвір спершу свердлять: Ø{diameter} на глибину {depth} мм; діаметр - наш вибір: кратний {step} мм, щонайменше на \
         {stock} мм на бік менше за чорновий отвір",
        "the bore is drilled first: Ø{diameter}, {depth} mm deep; the diameter is our choice: a multiple of {step} mm, at \
         least {stock} mm a side below the rough bore",
    ),
    (
        "bore-too-narrow-to-drill",
        "отвір Ø{diameter} завузький, щоб його засвердлити й розточити",
        "the bore of Ø{diameter} is too narrow to be drilled and bored",
    ),
    (
        "no-limiting-depth",
        "граничну глибину нема з чого взяти: вкажіть `roughing: {limiting_depth: …}` або верстат `machine:`",
        "nothing tells the limiting depth: give `roughing: {limiting_depth: …}` or a lathe, `machine:`",
    ),
    (
        "no-depth-allowed",
        "{tool}: не дозволено жодної глибини, бо {bound}; візьміть меншу подачу, міцніший різець або потужніший верстат",
        "{tool}: no depth is allowed by {bound}; take a lower feed, a stronger tool or a more powerful lathe",
    ),
    (
        "one-feed-for-all",
        "не вказано подач: {feeds}; узято основну, тож час наближений",
        "these feeds are not given: {feeds}; the main one is taken, so times are approximate",
    ),
    (
        "no-tool-for-zone",
        "зона {zone} ({side}): жоден різець каталогу не підходить: потрібно φ ≥ {main}°, φ1 ≥ {secondary}°",
        "zone {zone} ({side}): no tool of the catalog fits: φ ≥ {main}° and φ1 ≥ {secondary}° are needed",
    ),
    (
        "scheme-not-possible",
        "зона {zone}: схему {scheme} не можна застосувати, причина в наступному рядку; береться найшвидша з тих, що \
         лишають рівномірний припуск, якщо така є",
        "zone {zone}: the scheme {scheme} is not possible, for the reason in the next line; the quickest of those that \
         leave an even allowance is taken, if there is one",
    ),
    (
        "face-stock-thin",
        "припуск заготовки на торець менший за чистовий на {lack} мм: візьміть довшу заготовку",
        "the blank's stock on the face is {lack} mm less than the finishing allowance: take a longer blank",
    ),
    (
        "zone-behind-standing",
        "зона {zone}: різець не пройде, бо перед нею стоїть незнята зона {before}",
        "zone {zone}: the tool cannot come to it, because zone {before} before it is not cleared",
    ),
    (
        "groove-too-deep",
        "глибина {depth} мм більша за найбільшу для різця, {reach} мм",
        "it is {depth} mm deep, more than the {reach} mm of the tool",
    ),
    (
        "bounds-exceeded",
        "{tool}: за t_p = {depth} мм перевищено: {bounds}",
        "{tool}: at t_p = {depth} mm these are exceeded: {bounds}",
    ),
    ("tool-order", "з придатних береться: {prefer}", "of those that fit this one is taken: {prefer}"),
    ("turning-skin", "заготовка - {kind}, стан поверхні: {surface}", "blank: {kind}, its surface: {surface}"),
    (
        "returns-saved",
        "одна зона замість окремих над кожною ділянкою: на однакових рівнях по {depth} мм проходів і повернень {joined} \
         замість {split}",
        "one zone in place of one over each part: on the same levels of {depth} mm {joined} passes and returns in place \
         of {split}",
    ),
    ("turning-tool-taken", "{tool}: підходить для зон: {zones}", "{tool}: it fits this many zones: {zones}"),
    (
        "only-for-steps",
        "це показують лише для ступінчастого вала (`steps:`)",
        "this is shown for a stepped shaft (`steps:`) only",
    ),
];

pub(super) const REMEDIES: &[(&str, &str, &str)] = &[(
    "only-for-steps",
    "для контуру є `--show operation`, `program` і `cycle`",
    "for a contour there are `--show operation`, `program` and `cycle`",
)];

pub(super) const TERMS: &[(&str, &str, &str)] = &[
    ("outer", "зовні", "outside"),
    ("inner", "всередині", "inside"),
    ("tube", "труба", "tube"),
    ("face", "торець", "face"),
    ("cylinder", "циліндр", "cylinder"),
    ("cone", "конус", "cone"),
    ("ball", "опукла дуга", "bulging arc"),
    ("fillet", "увігнута дуга", "hollow arc"),
    ("thread", "різь", "thread"),
    ("grinding-relief", "канавка для шліфувального круга", "grinding relief"),
    ("thread-relief", "канавка для виходу різі", "thread relief"),
    ("rectangular-groove", "прямокутна канавка", "rectangular groove"),
    ("trapezoid-groove", "трапецеїдальна канавка", "trapezoid groove"),
    ("face-groove", "торцева канавка", "face groove"),
    ("pulley-groove", "жолоб під пас", "pulley groove"),
    ("main-element", "основний", "main"),
    ("other-side", "з другого боку", "from the other side"),
    ("outer-grinding", "шліфування", "grinding"),
    ("inner-grinding", "шліфування", "grinding"),
    ("face-grinding", "шліфування", "grinding"),
    ("error", "помилка", "error"),
    ("wrong", "неправильно", "wrong"),
    ("doubtful", "сумнівно", "doubtful"),
    ("note", "до відома", "note"),
];
