//! The words about contours of turned parts and their blanks: what is wrong in a file, and how a blank is prepared; what to do
//! stands in `remedies`.

mod remedies;

pub(super) use remedies::REMEDIES;

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    (
        "tube-with-steps",
        "труба має отвір, а для нього коротка форма зі `steps` не має слів",
        "a tube has a bore, for which the short form with `steps` has no words",
    ),
    (
        "neither-steps-nor-outer",
        "файл не має ні `steps`, ні `outer`: деталі немає",
        "the file has neither `steps` nor `outer`: there is no part",
    ),
    (
        "both-steps-and-outer",
        "файл має і `steps`, і `outer`: це дві різні форми",
        "the file has both `steps` and `outer`, which are two forms",
    ),
    ("name-twice", "назва `{surface}` уже стоїть у рядку {line}", "the name `{surface}` already stands at line {line}"),
    (
        "allowance-of-another-method",
        "`{key}` належить методу `{owner}`, а вибрано інший",
        "`{key}` belongs to the method `{owner}`, and another is chosen",
    ),
    (
        "no-items",
        "контур має починатися з `from` і мати хоча б одну поверхню",
        "a contour begins with `from` and has at least one surface",
    ),
    (
        "item-without-surface",
        "тут не сказано, що це за поверхня; є {known}",
        "this says not what surface it is; there are {known}",
    ),
    ("two-surfaces-in-one", "`{one}` і `{other}` в одному елементі", "`{one}` and `{other}` in one item"),
    ("item-of-a-part", "заготовка не має `{key}`", "a blank has no `{key}`"),
    (
        "bad-grade",
        "`{grade}` не є ні квалітетом, ні полем допуску",
        "`{grade}` is neither a tolerance grade nor a tolerance field",
    ),
    (
        "field-of-the-other-side",
        "поле `{grade}` не для цього боку: в отворів велика літера, зовні мала",
        "the field `{grade}` is not for this side: bores have a capital letter, outsides a small one",
    ),
    (
        "below-zero",
        "`{key}` дорівнює {length}, а має бути не менше за 0",
        "`{key}` is {length}, and must not be below 0",
    ),
    (
        "negative-diameter",
        "`{key}`: діаметр {diameter} менший за 0, контур зайшов би за вісь",
        "`{key}`: the diameter {diameter} is below 0, the contour would go beyond the axis",
    ),
    (
        "z-before-the-face",
        "Z {z} лежить перед чистовим торцем: у бік патрона Z від'ємне",
        "Z {z} lies before the finished face: towards the chuck Z is negative",
    ),
    (
        "arc-over-half-a-circle",
        "радіус {radius}: мінус означає дугу, більшу за півколо",
        "the radius {radius}: a minus means an arc of more than half a circle",
    ),
    ("bad-turned-thread", "`{thread}` не є метричною різьбою", "`{thread}` is no metric thread"),
    (
        "no-coarse-pitch",
        "великого кроку різьби `{thread}` у таблицях немає",
        "the tables have no coarse pitch of `{thread}`",
    ),
    (
        "end-said-twice",
        "кінець різьби задано двічі: `to` і `length`",
        "the end of the thread is given twice: `to` and `length`",
    ),
    (
        "bore-begins-on-the-axis",
        "отвір починається на осі: отвору там немає",
        "the bore begins on the axis: there is no bore",
    ),
    ("from-not-first", "`from` стоїть не першим", "`from` does not come first"),
    ("first-item-not-from", "контур не починається з `from`", "the contour does not begin with `from`"),
    ("cone-without-slant", "цей конус не має нахилу", "this cone has no slant"),
    (
        "leads-nowhere",
        "контур уже стоїть у точці Ø{d}, Z {z}: тут нічого немає",
        "the contour already stands at Ø{d}, Z {z}: there is nothing here",
    ),
    (
        "arc-does-not-reach",
        "дуга R{radius} не сягає кінця: треба щонайменше R{least}, половина відстані між кінцями",
        "an arc of R{radius} does not reach its end: it takes at least R{least}, half the distance of its ends",
    ),
    (
        "groove-over-neighbour",
        "канавка перед цим закінчується на Z {from}, далі за кінець цієї поверхні, Z {to}",
        "the groove before ends at Z {from}, beyond the end of this surface at Z {to}",
    ),
    (
        "runs-back",
        "контур повертається до вільного торця: з Z {from} на Z {to}",
        "the contour runs back towards the free end: from Z {from} to Z {to}",
    ),
    (
        "arc-swings-out",
        "дуга виходить за Z своїх кінців, до Z {z}",
        "the arc swings beyond the Z of its ends, to Z {z}",
    ),
    ("below-the-axis", "ця поверхня заходить за вісь", "this surface goes beyond the axis"),
    (
        "along-the-axis",
        "на Z {z} контур стоїть на осі: металу там немає",
        "at Z {z} the contour stands on the axis: there is no metal",
    ),
    (
        "chamfer-which-way",
        "не видно, куди нахилена фаска: поряд немає торця",
        "it does not show which way the chamfer slants: there is no face beside it",
    ),
    (
        "chamfer-larger-than-face",
        "фаска {chamfer} більша за торець після неї: він має лише {face} на бік",
        "the chamfer of {chamfer} is larger than the face after it, which has {face} on a side",
    ),
    (
        "thread-on-another-diameter",
        "різьба {thread} на Ø{diameter}, а її номінальний діаметр {least}",
        "the thread {thread} is on Ø{diameter}, and its nominal diameter is {least}",
    ),
    (
        "thread-in-another-bore",
        "різьба {thread} в отворі Ø{diameter}, а отвір під неї від {least} до {most}",
        "the thread {thread} is in a bore of Ø{diameter}, and the bore for it is {least} to {most}",
    ),
    ("groove-not-in-a-face", "канавка `face` не стоїть на торці", "the groove `face` stands on no face"),
    (
        "groove-deeper-than-radius",
        "канавка завглибшки {depth} на радіусі {radius}: металу не лишається",
        "a groove {depth} deep at the radius {radius}: no metal is left",
    ),
    (
        "groove-walls-meet",
        "стінки канавки {width} завширшки сходяться вище за дно на глибині {depth}",
        "the walls of a groove {width} wide meet above its floor, {depth} deep",
    ),
    (
        "groove-radius-too-large",
        "заокруглення не вміщається в канавку {width} завширшки, {depth} завглибшки",
        "the rounding has no room in a groove {width} wide and {depth} deep",
    ),
    (
        "angle-of-a-straight-groove",
        "канавка `{kind_of_groove}` не має кута",
        "a groove `{kind_of_groove}` has no angle",
    ),
    (
        "bad-groove-angle",
        "кут між стінками {angle}°, а має бути між 0 і 180",
        "the angle between the walls is {angle}°, and must lie between 0 and 180",
    ),
    ("groove-sizes-needed", "для цієї канавки бракує: {keys}", "this groove lacks {keys}"),
    (
        "contour-crosses-itself",
        "поверхня `{surface}` перетинає поверхню `{other}` або торкається її",
        "the surface `{surface}` crosses or touches the surface `{other}`",
    ),
    (
        "does-not-begin-at-zero",
        "контур починається на Z {z}, а чистовий торець — це Z 0",
        "the contour begins at Z {z}, and the finished face is Z 0",
    ),
    (
        "contours-do-not-meet",
        "отвір починається в Ø{d}, Z {z}, а зовнішній контур у Ø{outer_d}, Z {outer_z}",
        "the bore begins at Ø{d}, Z {z}, and the outside at Ø{outer_d}, Z {outer_z}",
    ),
    (
        "bore-ends-nowhere",
        "отвір закінчується на Z {z}: не на осі і не на дальньому торці, Z {far}",
        "the bore ends at Z {z}: neither on the axis nor at the far end, Z {far}",
    ),
    (
        "does-not-begin-on-the-axis",
        "контур починається на Ø{d}, а має починатися на Ø{bore}",
        "the contour begins at Ø{d}, and must begin at Ø{bore}",
    ),
    (
        "no-wall",
        "отвір на поверхні `{surface}` доходить до зовнішньої поверхні `{other}`: стінки немає",
        "the bore at the surface `{surface}` reaches the outer surface `{other}`: there is no wall",
    ),
    (
        "blank-begins-behind",
        "заготовка починається на Z {face}, за чистовим торцем деталі",
        "the blank begins at Z {face}, behind the finished face of the part",
    ),
    (
        "part-longer-than-blank",
        "поверхня `{surface}` доходить до Z {z}, а заготовка лише до Z {blank}",
        "the surface `{surface}` goes to Z {z}, and the blank only to Z {blank}",
    ),
    (
        "part-beyond-blank",
        "поверхня `{surface}` на Z {z} має Ø{diameter}, а заготовка там Ø{blank}",
        "the surface `{surface}` has Ø{diameter} at Z {z}, and the blank is Ø{blank} there",
    ),
    (
        "blank-bore-beyond-part",
        "поверхня `{surface}` на Z {z} має Ø{diameter}, а отвір заготовки там Ø{blank}",
        "the surface `{surface}` has Ø{diameter} at Z {z}, and the bore of the blank is Ø{blank} there",
    ),
    (
        "blank-key-beside-outer",
        "`{key}` не потрібен: заготовку описує її `outer`",
        "`{key}` is not needed: the blank is described by its `outer`",
    ),
    ("blank-key-of-another-kind", "заготовка `{stock}` не має `{key}`", "a blank `{stock}` has no `{key}`"),
    (
        "bore-beyond-diameter",
        "отвір Ø{bore} не менший за саму трубу Ø{diameter}",
        "the bore Ø{bore} is not smaller than the tube Ø{diameter}",
    ),
    (
        "face-beyond-length",
        "припуск на торці {face} не менший за всю заготовку {length}",
        "the stock on the face, {face}, is not less than the whole blank, {length}",
    ),
    (
        "blank-for-one-part",
        "заготовка Ø{diameter}: мірна, на одну деталь",
        "the blank of Ø{diameter} is cut to length, for one part",
    ),
    (
        "blank-for-several-parts",
        "заготовка Ø{diameter}: одна може бути на кілька деталей",
        "one blank of Ø{diameter} may serve for several parts",
    ),
    (
        "blank-length-deviation",
        "довжина заготовки може відхилятись щонайбільше на {most} мм",
        "the length of the blank may deviate by at most {most} mm",
    ),
    (
        "blank-length-too-coarse",
        "довжина заготовки відхиляється на {given} мм, а можна щонайбільше на {most} мм",
        "the length of the blank deviates by {given} mm, and may by at most {most} mm",
    ),
    (
        "blank-centre-both-ends",
        "перед верстатом заготовку центрують з обох боків",
        "before the lathe the blank is centred at both ends",
    ),
    ("blank-cut-one-face", "перед верстатом один торець підрізають", "before the lathe one face is cut"),
    (
        "blank-pre-turn-where-held",
        "поверхні поковки, за які її закріплюють, обточують заздалегідь",
        "the forging is turned beforehand where it is held",
    ),
    (
        "blank-heat-treat-before",
        "термообробку роблять перед обробкою на цьому верстаті",
        "heat treatment comes before this lathe",
    ),
];
