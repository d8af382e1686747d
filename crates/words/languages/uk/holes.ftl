# Visiting the holes.
visiting-method = { $method } (квалітет { $it }, допуск міжосьової відстані { $centre } мм, { "К" }т = { $ratio })
position-lost-at-tool-change = 1.3.1 радить робити кінцеві переходи послідовно, не рухаючи деталь; верстат замінює інструмент у X { $x } Y { $y }, тож стіл рухається і правила дотримати не можна: { $tools } інструментами паралельно – { $parallel } хв, послідовно – { $sequential } хв
visited-in-parallel = за 1.3.1 послідовний обхід був би швидший, але заміна інструмента в X { $x } Y { $y } рухає стіл: { $tools } інструментами паралельно – { $parallel } хв, послідовно – { $sequential } хв
# Schemes.
stages = етапи: { $stages } (Δ0 = { $delta } мм, σс = { $sigma } мм)
no-stages = для квалітету { $it } етапів таблиця не дає
table-for-hole = квалітет { $it } шукано в { $table } за рядками квалітету { $asked-it }, допуск міжосьової відстані { $centre } мм
cell = взято: { $take }
scheme = схема { $scheme } (квалітет { $it }, { $roughness })
which-of-two = у клітинці { $schemes }; взято: { $take }
centre = центрувати: у суцільному металі, глибина { $ratio } D
no-centre = центрування не потрібне: квалітет { $it }, Ø{ $diameter }, глибина { $ratio } D
twin = схема { $scheme } з центруванням – це схема { $centred }
no-twin = схема { $scheme } не має пари з центруванням; його додано
transitions = переходи схеми { $scheme }
no-scheme = таблиці не дають схеми: квалітет { $it }, { $roughness }, допуск { $centre } мм; графи шорсткості { $columns }
no-route = { $diameter }: жодна зі схем не здійсненна (відхилено { $tried })
nearest-depth = найближча глибина, на якій цей отвір тут можна зробити, – { $depth } мм, а не { $asked } мм
nearest-thickness = крізь заготовку завтовшки { $depth } мм цей отвір тут можна зробити, крізь { $asked } мм – ні
nearest-machine = на верстаті { $machine } цей отвір можна зробити за кресленням
finish-elsewhere = за таблицями отвір остаточно обробляють на верстаті іншого типу: схема { $scheme } лишає для нього { $stock } мм на діаметр, а квалітету, шорсткості й положення досягають уже там
grade-without-distance = centre_tolerance: IT{ $it } потребує двох отворів у групі; вкажіть ширину допуску в мм
grade-outside-table = IT{ $it } на міжосьовій відстані { $distance } мм поза таблицею: { $why }
point-breaks-through = вершина свердла Ø{ $diameter } сягає { $depth } мм, а заготовка завтовшки { $limit } мм: глухий отвір проб’ється
spot-too-deep = центрувальне заглиблення Ø{ $diameter } завглибшки { $depth } мм, а отвір – { $limit } мм
countersink-too-deep = торець зенківки для Ø{ $diameter } доходить до { $depth } мм, а глибина отвору { $limit } мм: вона вперлася б у дно
too-heavy = маса { $mass } кг, а верстат приймає щонайбільше { $limit } кг
plate-too-heavy = суцільна заготовка такого розміру має масу { $mass } кг, а верстат приймає щонайбільше { $limit } кг: задайте `mass`, якщо заготовка легша
not-planned = { $operation }: цей перехід тут не проєктують
rows-rejected = рядки за графою «{ $column }»: { $rows }
# Diameters.
allowance = { $operation }: припуск { $taken } мм на діаметр, діапазон { $low }–{ $high } мм
ground-to-size = інструмент Ø{ $nominal } каталогу, виконаний на розмір Ø{ $size }
rough-boring = чорнове розточування: { $stock } мм на діаметр робочих ходів – { $passes }, по { $low }–{ $high } мм
nearest-grade = такий самий отвір можливий за квалітету { $it } і { $roughness }
finer-than-this-machine = квалітету { $it } і { $roughness } на цьому верстаті не досягає жоден маршрут: отвір лишають Ø{ $from }, а решту { $stock } мм на діаметр знімає { $operation } на іншому верстаті; квалітету й шорсткості досягають уже там
finer-elsewhere = { $operation } на іншому верстаті досягає квалітету { $it } і { $roughness }
stock-left = { $operation } має припуск від { $least } до { $most } мм на діаметр
stock-for-elsewhere = лишено { $stock } мм на діаметр для іншого верстата
one-pass = свердлити Ø{ $diameter } за один перехід
two-passes = свердлити у два переходи: спершу Ø{ $first }, далі Ø{ $diameter } (перше свердло { $low }–{ $high } мм)
first-drill = перше свердло Ø{ $first }: { $share-min }–{ $share-max } від Ø{ $diameter }
two-passes-cost = проти одного свердла: час { $time } хв на отвір, осьова сила { $thrust } Н замість { $one-thrust } Н
bored-by-stand-in = Ø{ $diameter } замалий для борштанги (від Ø{ $smallest }); замість розточування – { $instead }
too-small-to-bore = { $operation }: Ø{ $diameter } < Ø{ $smallest }, найменшого отвору для борштанги
no-drill = немає свердла Ø{ $diameter }, що сягає дна{ $sides ->
        [below] ; найбільше з менших – { $below }
        [above] ; найменше з більших – { $above }
        [none] {""}
       *[both] ; найближчі { $below } і { $above }
    }
no-drill-in-allowance = { $operation } до Ø{ $diameter }: немає свердла від Ø{ $low } до Ø{ $high }
no-drill-before-boring = під розточування до Ø{ $diameter } немає свердла від Ø{ $smallest } до Ø{ $largest }
no-bar-enters = розточування до Ø{ $diameter }: жодна борштанга, що дістає на таку глибину, не входить в отвір Ø{ $hole } і не налаштовується на Ø{ $hole } + { $most } мм першого ходу чи менше
bar-set-by-hand = розточування за кілька робочих ходів: між ними борштангу переналагоджують вручну; великі отвори доцільно фрезерувати (1.2.1)
spot-by-drill = центрувальне заглиблення Ø{ $spot }: { $share } від свердла Ø{ $drill }
spot-by-depth = центрувальне заглиблення Ø{ $spot }, не { $share } від свердла Ø{ $drill }: глибшим за половину отвору воно не буде
spot-by-chamfer = центрувальне заглиблення Ø{ $spot } утворює і фаску
travel = недобіг { $approach } мм, перебіг { $overrun } мм
# Of any row.
unconfirmed-counted = числа спираються на { $count ->
    [one] { $count } непідтверджений рядок
    [few] { $count } непідтверджені рядки
    [many] { $count } непідтверджених рядків
   *[other] { $count } непідтвердженого рядка
} { $tables-count ->
    [1] таблиці
   *[other] таблиць
} { $tables }: перелік із причинами дає `--all-problems`
to-be-ground = { $table }, ряд. { $row }: { $why }
unconfirmed = не підтверджено: { $table }, ряд. { $row }: { $why }
names-look-alike = { $count } { $count ->
        [one] групу
        [few] групи
       *[many] груп
    } названо { $name }: літери на вигляд однакові, але одні латинські, інші кириличні; пишіть назви однією абеткою
