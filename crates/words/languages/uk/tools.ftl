# Tools.
tool-tables = { $operation }: інструмент шукано в { $tables-count ->
        [1] таблиці
       *[other] таблицях
    } { $order }
cutter = перший інструмент, що підходить
centre-drill-for-all = найменше свердло для зацентрування всіх груп отворів: Ø{ $needed }
centre-drill-for-all-over = найменше свердло для зацентрування всіх груп отворів: більше за Ø{ $needed }
centre-drill-for-all-least = найменше свердло для зацентрування всіх груп отворів: щонайменше Ø{ $needed }
holder = перший допоміжний інструмент, що приймає хвостовик ({ $shank })
overhang-cylindrical = виліт: { $free } мм поза посадкою + { $extra } мм
overhang-morse = виліт: { $projection } мм поза конусом
overhang-shell = насадний інструмент: виліт – його довжина
overhang-taper = інструмент із хвостовиком верстата
does-not-reach = { $tool } ({ $table }): робоча довжина { $reach } мм, а потрібно { $needed } мм
flutes-close = { $tool } ({ $table }): канавки { $flutes } мм < { $needed } мм в отворі + { $room } мм вільних для стружки
drill-too-large = { $tool } ({ $table }): Ø{ $diameter } більше за Ø{ $limit }, найбільше свердло верстата
bar-does-not-enter = { $tool } ({ $table }): борштанга Ø{ $bar } не входить в отвір Ø{ $hole }
no-cutter-of-size = { $operation }: у { $tables-count ->
        [1] таблиці
       *[other] таблицях
    } { $tables } немає Ø{ $diameter }{ $sides ->
        [below] ; найбільший із менших – { $below }
        [above] ; найменший із більших – { $above }
        [none] {""}
       *[both] ; найближчі { $below } і { $above }
    }
no-cutter = { $operation }: інструмента немає
shank-outside-clamp = { $holder }: хвостовик Ø{ $shank } поза діапазоном { $low }–{ $high } мм
other-morse = { $holder }: конус Морзе { $taken }, а в інструмента { $own }
other-taper = { $holder }: конус 7:24 № { $own }, а в шпинделя № { $spindle }
stands-out-too-little = { $holder }: виліт { $reach } мм < { $needed } мм в отворі + { $over_face } мм до торця, ближче не підводять патрон
arbor-does-not-enter = { $holder }: оправка Ø{ $arbor } не входить в отвір Ø{ $hole }
start-near-clamp = точка заміни інструмента за { $distance } мм від притискача, ближче ніж безпечні { $needed } мм: закріплюйте, коли шпиндель стоїть там, де каже установлення, або поставте упори, що обмежують поворот ключа (посібник, 1.11)
clamp-near-hole = притискач за { $distance } мм від осі отвору, ближче ніж { $needed } мм
other-bore = { $holder }: посадка { $taken } мм, а в інструмента { $own } мм
assembly-too-long = { $tool } у { $holder }: довжина { $length } мм, а найбільший виліт верстата – { $limit } мм
# Clamping, travel.
safety = коефіцієнт запасу k = { $value }
face-milled = жоден інструмент не цекує всієї торцевої площини, тож її обходить фреза: { $why }
support-friction = коефіцієнт тертя на опорі f2 = { $value }
clamping-turns = { $operation } з M = { $torque } Н·м повертає деталь: W = k·M/(f·d) = { $by_book } Н
clamping-pushes = { $operation } з M = { $torque } Н·м зсуває деталь із силою { $side } Н: проти ковзання W = k·P/(f + f2) = { $force } Н, більше за k·M/(f·d) = { $by_book } Н
friction = коефіцієнт тертя f = { $value }
least-screw = гвинт притискача не тонший за M{ $value }
screw = потрібен { $needed }, узято { $taken }: витримує { $bears } Н
no-screw = жоден гвинт не витримує { $force } Н на притискач ({ $clamps }), { $screw } витримує { $bears } Н: поставте притискачів { $enough }, не ближче до отворів (по { $share } Н) або ріжте щонайбільше з { $most } Н·м замість { $torque } Н·м
no-screw-for-slot = Т-подібні пази { $slot } мм приймають щонайбільше гвинт { $screw }: { $bears } Н < { $force } Н на притискач ({ $clamps }); поставте притискачів { $enough }, не ближче до отворів (по { $share } Н), ріжте щонайбільше з { $most } Н·м замість { $torque } Н·м або візьміть власне пристосування
straps-overlap = притискачі в { $one } та { $other } перекривалися б
strap-near-hole = притискач під гвинт { $screw } завширшки { $width } мм лишає інструментам отвору { $hole } менше ніж { $least } мм збоку
strap = притискач під гвинт { $screw }: ширина { $width } мм, з гайкою { $height } мм над поверхнею
screw-too-weak = гвинт { $screw } витримує { $bears } Н, а на притискач припадає { $force } Н; потрібен { $needed } або притискачів { $screw } { $enough }, не ближче до отворів (по { $share } Н), або різання щонайбільше з { $most } Н·м замість { $torque } Н·м
clamp-outlines-overlap = контури притискачів у { $one } і { $other } накладаються; розсуньте їх або виправте `outline`
clamps-overlap = два притискачі за { $distance } мм один від одного: їхні опори накладаються, кожна займає { $least } мм; дайте `outline`, якщо вони вужчі
one-clamp-turns = один притискач: отвір { $hole } повертає деталь навколо нього моментом { $moment } Н·м (із запасом), і ніщо цього не тримає; втримає другий притискач не ближче { $least } мм або упор там само
clamps-turn = притискачі стоять надто близько: отвір { $hole } повертає деталь навколо одного з них моментом { $moment } Н·м > { $holds } Н·м, що тримає тертя під рештою; двом притискачам досить { $least } мм
clamps-tip = бічна сила { $side } Н перекидає деталь через край моментом { $moment } Н·м > { $holds } Н·м, що там тримають притискачі; поставте їх далі від країв
clamps-one-side = усі притискачі з одного боку: деталь продовжується за ними на { $beyond } з { $width } мм і підіймається, коли свердло виходить; притисніть її з двох протилежних боків
beyond-travel = отвори по { $axis } займають { $span } мм, а хід стола – { $travel } мм
vice-grip = затиснуто щонайменше { $value } мм деталі
vice-grip-share = затиснуто щонайменше { $value } висоти деталі
vice-below-face = губки кінчаються щонайменше на { $value } мм нижче за поверхню
vice-room-below = під інструментом, що виходить, щонайменше { $value } мм
vice-holds = { $along } мм уздовж губок { $jaws } мм, { $between } мм між ними, розхил { $opening } мм
vice-parallels = підкладки { $height } мм: інструмент виходить на { $below } мм нижче від деталі
chuck-holds = Ø{ $diameter } на сходинці { $step }, яка тримає від Ø{ $least } до Ø{ $most }
fixture-kind = вид пристосування (посібник 1.6)
fixture-keying = ув’язка пристосування на столі (посібник 1.7)
part-locating = базування деталі (посібник 1.9)
keying-play = шпонки чи штирі { $size } мм: до { $play } мм зазору
locating-error = від деталі до деталі – до { $most } мм
chain-both-axes = похибку дають обидві осі: ні розділ 1.2.1, ні точність верстата не кажуть, осі чи відстані між двома стосується число; за другим прочитанням лічиться лише перше поле
pin-clearance = зазор пальця в отворі від { $least } до { $most } мм
no-locating-pin = у таблиці «Установні пальці» немає пальця для отвору { $hole } у точці { $at }: вона має від 3 до 50 мм
pin-does-not-enter = палець не входить в отвір { $hole } у точці { $at }: його найменший діаметр { $smallest } мм, а найбільший пальця { $field } – { $largest } мм
chain-term = поле { $field } мм у ланцюгу
chain-closing = чи замикається ланцюг
chain-zeros = скільки нулів має деталь (посібник, 5.2 п. 11.2)
