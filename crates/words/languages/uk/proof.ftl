# What is made and what is not.
not-made = { $hole }: { $operation } (T{ $tool }) не виконано в { $count ->
        [one] { $count } точці
        [few] { $count } точках
       *[many] { $count } точках
    }: { $points }
    .help = { $count ->
        [1] додайте цю точку
       *[other] додайте ці точки
    }
cut-again = зайве: в { $at } T{ $tool } ще раз іде до Z{ $z }, а це вже зроблено
    .help = приберіть повтор
cut-not-planned = зайве: в { $at } T{ $tool } іде до Z{ $z }, а в цьому отворі такого переходу немає
    .help = перевірте координати й підпрограму
cut-elsewhere = зайве: в { $at } T{ $tool } іде до Z{ $z }, а отвору там немає
    .help = перевірте координати й підпрограму
wrong-order = { $hole }: { $operation } в { $at } виконано після переходу, що йде за ним ({ $instead })
    .help = поставте переходи отвору в порядку плану
# Tools.
wrong-tool = { $hole }: { $operation } в { $at } виконує T{ $tool }, а треба T{ $needed }
    .help = перевірте T і H цього інструмента
program-tool-called = викликано T{ $tool }, а { $hole }: { $operation } в { $at } потребує T{ $needed }
program-tools-exchanged = T{ $tool } і T{ $needed } переплутано: кожен викликано для роботи іншого
program-correctors-exchanged = коректори H{ $corrector } і H{ $own } переплутано: кожен інструмент ріже з коректором іншого
tool-unknown = інструмента T{ $tool } у плані немає
    .help = перевірте T і H цього інструмента
tool-by-work = T{ $tool } програми робить те, що в плані T{ $plan }
    .help = перевірте, що стоїть у магазині
not-loaded = інструмент { $tool } плану не поставлено в гніздо { $place }: перед викликом немає зупинки
    .help = поставте M00 перед цим інструментом
no-correction = T{ $tool } ріже без корекції довжини; його H{ $own } дорівнює { $needed } (діє H{ $corrector } = { $value })
    .help = введіть корекцію: G43 H
wrong-correction = T{ $tool } ріже з H{ $corrector } = { $value }{ $whose ->
        [none] {""}
       *[tool] {""}, коректором T{ $other }
    }, а його корекція H{ $own } = { $needed }
    .help = { $whose ->
        [none] перевірте T і H цього інструмента
       *[tool] напишіть H{ $own } там, де T{ $tool } бере корекцію довжини, або T{ $other } там, де змінюють інструмент
    }
other-corrector = T{ $tool } ріже з H{ $corrector }, а його коректор H{ $own }; величина та сама, { $value } з { $needed }
    .help = перевірте T і H цього інструмента
wrong-sign = T{ $tool }: H{ $corrector } = { $value }, а за планом { $needed }: знак протилежний
    .help = коректор – це довжина інструмента мінус довжина найдовшого
feed-per-turn = { $hole }: { $operation } в { $at }: { $made } мм/об замість { $needed }
    .help = узгодьте F і S
changes-elsewhere = інструмент замінюють у { $at }, а не в точці заміни
    .help = перед заміною відведіть стіл і повзун
no-corrector = T{ $tool } ріже без свого коректора H{ $own }, нульового лише за домовленістю
    .help = задайте корекцію на довжину: G43 H{ $own }
shared-corrector = T{ $tool } ріже з H{ $corrector } = { $value }, який має T{ $other }; за планом H{ $own } = { $needed }
    .help = перевірте T і H цього інструмента
correction-otherwise = H{ $corrector } = { $value } для T{ $tool }, а за планом H{ $own } = { $needed }: висоти прийнято за вказаною величиною
    .help = перевірте довжину інструмента
# Dangerous motions.
rapid-across = прискорене переміщення в деталі: до { $at } на висоті Z{ $z }
    .help = спершу вийдіть з деталі
through-obstacle = шлях до { $to } – на Z{ $made }, а притискач чи перешкода у { $at } стоїть до Z{ $needed }
    .help = спершу підніміть інструмент над нею або обійдіть її
holder-through-obstacle = T{ $tool }: { $whose ->
        [holder] патрон чи оправка { $own }
        [collar] фланець оправки { $own }
       *[nose] торець шпинделя
    }, Ø{ $diameter }, опускається до Z{ $made } поряд із притискачем чи перешкодою у { $at }, що стоїть до Z{ $needed }
    .help = візьміть довший інструмент або поставте її далі чи нижче
holder-unknown = { $tools }: яка завтовшки оправка { $own }, ніхто не каже; якщо як її фланець, Ø{ $diameter }, вона зустріне те, що стоїть у { $points }; найгірше в { $at }: T{ $tool } опускає її до Z{ $made } поруч із тим, що стоїть до Z{ $needed }
    .help = виміряйте її: до Ø{ $free } вона всюди проходить (тоді скажіть це у власних таблицях, --with: max_diameter її рядка); інакше поставте те, що вона зустріне, на { $aside } мм далі від її шляхів або на { $lower } мм нижче
holder-into-part = T{ $tool }: оправка { $own }, Ø{ $diameter }, опускається до Z{ $made } у { $at }, а поверхня деталі – на Z{ $needed }
    .help = візьміть довший інструмент
rapid-into-part = прискорене переміщення в метал у { $at } до Z{ $z }
    .help = заходьте в метал подачею
rapid-into-metal = { $hole }: { $operation } в { $at }: подача починається на Z{ $made }, а метал на Z{ $needed }
    .help = перевірте рівні циклу, нуль деталі й коректор
tap-not-followed = у { $at } різь нарізають без { $word } перед тим: шпиндель не йде за подачею
    .help = дайте { $word } з S перед циклом нарізання різі
spindle-stands = в { $at } T{ $tool } ріже, коли шпиндель зупинений
    .help = запустіть шпиндель: S і M03
wrong-turn = в { $at } T{ $tool } ріже, коли шпиндель обертається проти годинникової стрілки
    .help = для правого інструмента M03
slot-gouged = { $hole }: { $operation } в { $at }: фреза врізається на { $made } мм за межі паза на шляху до { $to } на Z{ $z }
slot-uncut = { $hole }: { $operation } в { $at }: у пазу лишився метал у { $to } на Z{ $z }
slot-plunge-aside = { $hole }: { $operation } в { $at }: фреза врізається вниз збоку від середини паза, в { $to } до Z{ $z }
slot = { $hole }: { $operation } в { $at }: подача вбік у металі до { $to } на Z{ $z }
    .help = перевірте координати й підпрограму
travel-low = перехід до { $at } на Z{ $made }, нижче за Z{ $needed }
    .help = підніміть інструмент перед переходом
# Levels.
too-shallow = { $hole }: { $operation } в { $at }: до Z{ $made }, а треба до Z{ $needed }
    .help = перевірте рівні циклу, нуль деталі й коректор
less-overrun = { $hole }: { $operation } в { $at }: до Z{ $made } замість Z{ $needed }, перебіг менший
    .help = перевірте рівні циклу, нуль деталі й коректор
into-table = { $hole }: { $operation } в { $at }: до Z{ $made }, а стіл на Z{ $needed }: інструмент врізається у стіл
deeper = { $hole }: { $operation } в { $at }: до Z{ $made }, глибше за Z{ $needed }
    .help = перевірте рівні циклу, нуль деталі й коректор
begins-lower = { $hole }: { $operation } в { $at }: подача починається на Z{ $made }, недобіг менший, ніж із Z{ $needed }
    .help = перевірте рівні циклу, нуль деталі й коректор
begins-higher = { $hole }: { $operation } в { $at }: подача починається на Z{ $made } замість Z{ $needed }
    .help = перевірте рівні циклу, нуль деталі й коректор
# Conditions.
other-speed = { $hole }: { $operation } в { $at }: { $made } об/хв замість { $needed }
    .help = візьміть величину плану або переконайтеся, що ця годиться
other-feed = { $hole }: { $operation } в { $at }: подача { $made } мм/хв замість { $needed }
    .help = візьміть величину плану або переконайтеся, що ця годиться
other-dwell = { $hole }: { $operation } в { $at }: витримка { $made } с замість { $needed }
    .help = візьміть величину плану або переконайтеся, що ця годиться
dwell-elsewhere = { $hole }: { $operation } в { $at }: витримка { $made } с не на дні
    .help = приберіть зайве або переконайтеся, що це навмисно
coolant-missing = { $hole }: { $operation } в { $at }: без МОР
    .help = увімкніть подавання МОР
coolant-superfluous = { $hole }: { $operation } в { $at }: з МОР, якої план не має
    .help = приберіть зайве або переконайтеся, що це навмисно
# Steps.
steps-not-planned = { $hole }: { $operation } в { $at }: за { $made } заходів замість одного
    .help = візьміть цикл, якого вимагає перехід
step-too-large = { $hole }: { $operation } в { $at }: крок { $made } мм, більший за { $needed }
    .help = візьміть величину плану або переконайтеся, що ця годиться
step-smaller = { $hole }: { $operation } в { $at }: крок { $made } мм замість { $needed }
    .help = візьміть величину плану або переконайтеся, що ця годиться
step-clearance = { $hole }: { $operation } в { $at }: новий крок за { $made } мм до металу замість { $needed }
    .help = візьміть величину плану або переконайтеся, що ця годиться
step-return = { $hole }: { $operation } в { $at }: між кроками до Z{ $made } замість Z{ $needed }
    .help = візьміть цикл, якого вимагає перехід
# The way out.
out-at-rapid = { $hole }: { $operation } в { $at }: вихід прискорено, а треба подачею
    .help = візьміть цикл, якого вимагає перехід
out-at-feed = { $hole }: { $operation } в { $at }: вихід подачею { $made } мм/хв, можна прискорено
    .help = візьміть цикл, якого вимагає перехід
out-other-feed = { $hole }: { $operation } в { $at }: вихід подачею { $made } мм/хв замість { $needed }
    .help = візьміть величину плану або переконайтеся, що ця годиться
out-too-high = { $hole }: { $operation } в { $at }: подачею до Z{ $made }, далі за Z{ $needed } можна прискорено
    .help = візьміть цикл, якого вимагає перехід
out-too-low = { $hole }: { $operation } в { $at }: подачею лише до Z{ $made }, а треба до Z{ $needed }
    .help = візьміть цикл, якого вимагає перехід
out-elsewhere = { $hole }: { $operation } в { $at }: вихід на Z{ $made }, а не на Z{ $needed }
    .help = візьміть цикл, якого вимагає перехід
out-turning = { $hole }: { $operation } в { $at }: вихід, коли шпиндель обертається, а він має стояти
    .help = візьміть цикл, якого вимагає перехід
out-standing = { $hole }: { $operation } в { $at }: вихід, коли шпиндель зупинений
    .help = візьміть цикл, якого вимагає перехід
# Circles.
circle-missing = { $hole }: { $operation } в { $at }: бракує кіл: { $count }, перше на Z{ $z }
    .help = перевірте коло: рівень, радіус, центр, бік
circle-superfluous = { $hole }: { $operation } в { $at }: зайве коло на Z{ $z }
    .help = перевірте коло: рівень, радіус, центр, бік
circle-level = { $hole }: { $operation } в { $at }: коло на Z{ $z }, а треба на Z{ $needed }
    .help = перевірте коло: рівень, радіус, центр, бік
circle-radius = { $hole }: { $operation } в { $at }: радіус кола { $made } мм на Z{ $z }, а треба { $needed }
    .help = перевірте коло: рівень, радіус, центр, бік
circle-centre = { $hole }: { $operation } в { $at }: центр кола { $made } на Z{ $z }
    .help = перевірте коло: рівень, радіус, центр, бік
circle-sense = { $hole }: { $operation } в { $at }: коло на Z{ $z } в інший бік
    .help = перевірте коло: рівень, радіус, центр, бік
circle-open = { $hole }: { $operation } в { $at }: на Z{ $z } лише { $made } кола
    .help = перевірте коло: рівень, радіус, центр, бік
circle-again = { $hole }: { $operation } в { $at }: на Z{ $z } { $made } кола замість одного
    .help = перевірте коло: рівень, радіус, центр, бік
ways-between-circles = { $hole }: { $operation } в { $at }: прямих ходів у площині { $made } замість { $needed }
    .help = приберіть зайве або переконайтеся, що це навмисно
ways-down = { $hole }: { $operation } в { $at }: ходів униз { $made } замість { $needed }
    .help = приберіть зайве або переконайтеся, що це навмисно
oblique = { $hole }: { $operation } в { $at }: хід убік і вглиб водночас до Z{ $z }
    .help = перевірте координати й підпрограму
not-in-the-middle = { $hole }: { $operation } в { $at }: рух по Z в { $to } до Z{ $z }, а не посередині отвору
    .help = перевірте координати й підпрограму
# Pauses.
no-stop-to-load = немає зупинки, щоб поставити інструмент { $tool } у гніздо { $place }
    .help = поставте M00 перед цим інструментом
no-stop-to-turn-over = немає зупинки, щоб перевернути деталь
    .help = поставте M00 перед цим інструментом
no-stop-to-set-bar = немає зупинки, щоб налагодити борштангу на Ø{ $diameter }
    .help = поставте M00 перед цим інструментом
not-turned-over = другий установ починається без зупинки, щоб перевернути деталь
    .help = поставте M00 перед цим інструментом
stop-for-nothing = зупинка, якої план не має
    .help = приберіть зайве або переконайтеся, що це навмисно
# Around the cuts.
other-order = порядок точок не за планом з { $at } (там { $needed }): місць з іншим порядком – { $count }, шлях { $way } мм
    .help = порівняйте з `technolog order`
idle-point = рух до { $at }, де нічого не роблять
    .help = приберіть зайве або переконайтеся, що це навмисно
idle-height = рух до Z{ $z }, якої цикл не має
    .help = приберіть зайве або переконайтеся, що це навмисно
air-at-feed = над деталлю до Z{ $z } подачею { $made } мм/хв, можна прискорено
    .help = приберіть зайве або переконайтеся, що це навмисно
travel-at-feed = перехід до { $at } подачею { $made } мм/хв, можна прискорено
    .help = приберіть зайве або переконайтеся, що це навмисно
travel-high = перехід до { $at } на Z{ $made }, вище за Z{ $needed }
    .help = приберіть зайве або переконайтеся, що це навмисно
travel-not-up = шлях від заміни інструмента чи до неї ({ $at }) на Z{ $z }, а не з піднятим повзуном
    .help = спершу підніміть повзун
radius-correction = діє корекція на радіус, якої план не має
    .help = скасуйте її: G40
approach-standing = підхід до Z{ $z }, коли шпиндель зупинений
    .help = запустіть шпиндель раніше: S і M03
dwell-in-air = витримка { $made } с над деталлю
    .help = приберіть зайве або переконайтеся, що це навмисно
turns-to-change = шпиндель обертається на шляху до заміни інструмента
    .help = зупиніть шпиндель: M05
correction-at-change = корекція на довжину діє ще під час заміни інструмента
    .help = скасуйте її: G49
turns-at-change = шпиндель обертається до самої заміни інструмента
    .help = зупиніть шпиндель: M05
coolant-at-change = подавання МОР не вимкнено перед заміною інструмента
    .help = вимкніть подавання МОР: M09
turns-at-end = програма закінчується, а шпиндель обертається
    .help = зупиніть шпиндель: M05
coolant-at-end = програма закінчується, а подавання МОР увімкнено
    .help = вимкніть подавання МОР: M09
ends-elsewhere = програма закінчується в { $at }, а не в точці заміни інструмента
    .help = відведіть стіл і повзун до точки заміни
no-end = програма не доходить до кінця
    .help = закінчіть програму M02 або M30
