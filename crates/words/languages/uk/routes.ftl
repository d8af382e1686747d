# The three ways.
auxiliary-scheme = схема { $scheme } для отвору «{ $kind }»
no-auxiliary-scheme = A.10 не дає схеми: { $kind } Ø{ $diameter }, допуск міжосьової відстані { $centre } мм
complex = комплекс { $complex } для отвору «{ $kind }»
complex-transitions = переходи комплексу { $complex }
no-complex = A.4 не дає комплексу: квалітет { $it }, Ø{ $diameter }, допуск міжосьової відстані { $centre } мм
no-complex-group = A.4 не має групи для отвору квалітету { $it }, Ø{ $diameter }, допуск { $centre } мм: вона для суцільного металу, квалітети 7–9 та 12 і грубіші
searched = знайдено пошуком за станами отвору: { $transitions }
searched-step = можливий перехід: { $operation }
no-path = жоден ланцюг переходів не дає квалітету { $it } і { $roughness }
state-unreachable = стан { $state } з Ø{ $diameter } нічим не досягається
bored-by-another = { $operation } тут робить інший перехід
no-centre-in-a-hole = центрування не потрібне: отвір уже є (квалітет { $it }, Ø{ $diameter }, { $ratio } D)
# What a route holds.
reaches = досяжні квалітет { $it }, { $roughness }
rough-face = свердління по необробленій поверхні: точність міжосьових відстаней нижча на { $percent } %; у таблицях шукано з тіснішим допуском
misses-grade = за таблицями досягається квалітет { $it }, а потрібен { $asked }
misses-roughness = за таблицями досягається { $roughness }, а потрібно { $asked }
chamfer-inside-thread = фаска Ø{ $diameter } вужча за різь { $thread }: заходу мітчику не дає
reaches-again = те саме ще раз ширшим інструментом: квалітет { $it }, { $roughness }
reaches-by-itself = готує наступний перехід: сам по собі квалітет { $it }, { $roughness }
reaches-no-worse = готує наступний перехід і не погіршує зробленого: квалітет { $it }, { $roughness }
reaches-before-next = залишає IT{ $it }, { $roughness } з діапазону свого рядка: після нього йде перехід, що тонше не залишає
reaches-thread = різь: { $roughness }
drills-too-short = найбільше свердло, що сюди годиться, Ø{ $diameter }, сягає { $reach } мм, а потрібно { $needed } мм разом із вершиною та місцем для стружки
bought-for = { $operation } на Ø{ $size }: інструмент Ø{ $nominal } має бути придбаний для H{ $it }, не зношений: після інструмента для точнішого поля отвір буде замалий
promised-finer = { $table } обіцяє квалітет { $it }, а за A.1 ці переходи дають { $own }
misses-position = положення осі витримується до { $position } мм, а дозволено { $asked } мм
misses-axis = інструмент іде за віссю литого отвору, стрижень якого може бути зсунутий на { $shift } мм, а допустимо { $asked } мм
misses-floor = надто багато лишається необробленим над плоским дном
misses-unknown = таблиці не кажуть, що досягається
not-bored = положення осі потребує розточування (1.2), але жодна борштанга сюди не годиться; маршрут без розточування, а розвертка йде за віссю свердла. Точніше її тримає координатно-розточувальний верстат, кондукторна втулка чи суцільне твердосплавне свердло (hole-position-reach)
position-asks-boring = не містить розточування, хоча допустиме відхилення осі { $position } < 0,1 мм (1.2)
boring-not-asked = містить розточування, якого допустиме відхилення осі { $position } ≥ 0,1 мм не потребує (1.2)
finished-here = лишає остаточне оброблення іншому верстату, а інший маршрут завершує отвір тут
not-surely-finished-here = таблиці лишають остаточне оброблення цього отвору іншому верстату, а цей маршрут витримує креслення щонайкраще або не витримує
milled-not-round = фрезерований отвір Ø{ $diameter }: некруглість верстата { $roundness } мм, а її частка допуску – { $most } мм
# Why a route lost.
lost-by-time = довше на { $slower } хв
lost-by-little = довше на { $slower } хв, менш ніж { $percent } % часу: не гірший
lost-by-floor = лишає над плоским дном { $left } мм без чистової обробки, а не { $instead } мм
lost-by-borrowing = коротше на { $quicker } хв, але тоді маршрут іншого отвору лишається без спільного свердла
lost-by-two-passes = коротше на { $quicker } хв, але тоді його свердло є й для іншого отвору, і за правилом той свердлять у два ходи
lost-by-order = рівний час; за порядком способів стоїть далі
ranked-later = у таблиці стоїть нижче за { $first }, здійсненну
same-as = той самий маршрут, що { $table } { $same }
# Diameters.
core-drill-stock = під зенкер лишають { $stock } мм на діаметр від Ø{ $nominal }
handbook-step = проміжний діаметр довідника Ø{ $advised }; взято Ø{ $taken } (1.2.1: { $low }–{ $high })
handbook-step-outside = проміжний діаметр довідника Ø{ $advised } поза межами 1.2.1 ({ $low }–{ $high }) або ряду свердел; взято Ø{ $taken }
handbook-step-lower = проміжний діаметр довідника Ø{ $advised } – для поля H; це поле лежить нижче: взято Ø{ $taken } (1.2.1: { $low }–{ $high })
handbook-first-drill = довідник свердлить спершу Ø{ $first }, потім Ø{ $diameter }
milled-instead = Ø{ $diameter } великий: замість першого розточування – фрезерування (контурна система)
no-drill-before = { $operation } до Ø{ $diameter }: немає свердла, що лишає припуск (до Ø{ $largest })
no-counterbore-in-allowance = { $operation } до Ø{ $diameter }: немає інструмента Ø{ $low }–{ $high } під припуск
step-finished-elsewhere = ступінь { $diameter } за таблицями остаточно обробляють на іншому верстаті; тут лишено припуск
no-hole-to-open = { $operation }: немає отвору, який розкривати
stock-too-small = { $operation } від Ø{ $start } до Ø{ $diameter }: припуск { $stock } мм, а інструмент ріже щонайменше { $least } мм
tapped-at-once = отвір заготовки Ø{ $start } вже під різь { $thread }: залишається нарізати різь
opened-already = { $operation } до Ø{ $diameter }: отвір уже Ø{ $start }
stock-outside-allowance = { $operation } до Ø{ $diameter }: припуск { $stock } мм поза { $low }–{ $high } мм
no-thread-to-tap = у цього отвору немає різі
# The rest of a hole.
edge = край: до Ø{ $diameter }, глибина { $depth } мм
flat-floor = плоске дно: свердло спиняється на { $stop } мм, фреза вирівнює до { $depth } мм
floor-not-flat = плоского дна не зробити: лишається конус свердла
free-floor-flat = жоден маршрут не лишає конуса свердла: вільне дно роблять плоским
flat-under-thread = під різь завглибшки { $depth } мм отвір свердлять до { $drilled } мм і конусом: плоске дно на { $depth } мм неможливе; задайте `bottom: free`
too-shallow-for-flat = отвір завглибшки { $depth } мм мілкіший за вершину свердла Ø{ $diameter }
no-flat-opening = Ø{ $diameter }: жоден інструмент не лишає плоского торця уступу{ $sides ->
        [below] ; найбільша з менших цеківок – { $below }
        [above] ; найменша з більших цеківок – { $above }
        [none] {""}
       *[both] ; найближчі цеківки { $below } і { $above }
    }
no-opening = Ø{ $diameter }: нічим розкрити з Ø{ $start }
step-too-deep = ступінь завглибшки { $depth } мм, а заготовка завтовшки лише { $limit } мм
groove-not-axial = канавку Ø{ $diameter } завширшки { $width } мм на глибині { $depth } мм осьовий інструмент не обробляє: потрібен різець на іншому верстаті
thread-chamfer = фаска під різь на крок { $pitch } мм
thread-of-step = різь { $thread } на ступені
tap-elsewhere = різь { $thread }: верстат { $machine } різі не нарізає; останній перехід – на іншому верстаті, приміром { $other }; його режими лише орієнтовні
no-machine-taps = різь { $thread }: верстат { $machine } різі не нарізає, і жоден верстат таблиць теж; режими останнього переходу лише орієнтовні
tap-nowhere = різь { $thread }: верстат { $machine } різі не нарізає, і жоден верстат таблиць її мітчиком не наріже (на { $other }: { $why }); знайдіть верстат, що наріже, або фрезеруйте чи точіть різь
second-setup = ступені зі зворотного боку: другий установ після перевертання; координати – від першого
# Tools.
step-drill = ступінчасте свердло Ø{ $narrow }/Ø{ $wide } робить обидва діаметри за один хід
no-step-drill = немає ступінчастого свердла Ø{ $narrow }/Ø{ $wide }
cutter-ground-down = у каталогах немає цього розміру: Ø{ $own } перешліфувати на Ø{ $size }
mill-too-large = { $tool } ({ $table }): Ø{ $diameter } більше за Ø{ $limit }, найбільшу кінцеву фрезу верстата
tool-too-wide = { $tool } ({ $table }): Ø{ $diameter } більше за Ø{ $limit }, найбільший у магазині
assembly-too-heavy = комплект з { $holder }: маса { $mass } кг, а дозволено { $limit } кг
second-opinion = загальнодоступні таблиці мають { $low }…{ $high } м/хв; формула дає { $formula } м/хв, { $percent } % їх звичайної швидкості
second-opinion-softer = загальнодоступні таблиці такої твердості не мають; для HB { $hardness }, найтвердішого в них, вони мають до { $high } м/хв; формула дає { $formula } м/хв, { $percent } % тамтешньої звичайної швидкості
practice-speed = взято швидкість за практикою: { $speed } м/хв
no-teeth-in-middle = { $tool } ({ $table }): торцеві зубці цієї фрези не доходять до середини, тож прямо вниз у метал Ø{ $diameter } не врізається
no-teeth-over-hole = { $tool } ({ $table }): торцеві зубці цієї фрези не доходять до середини, а над цим отвором прямо вниз ідуть такі фрези лише до Ø{ $widest }
does-not-pass = { $tool } ({ $table }): Ø{ $diameter } ≥ Ø{ $within } ступеня, крізь який він мав би пройти
pilot-wider-than-hole = { $tool } ({ $table }): отвір під цапфу Ø{ $pilot } > Ø{ $hole }: середина лишиться невирізаною
chamfered-by-centring = фаску тут знімає центрування: ступінчасте свердло зайве
chamfer-in-countersink = фаска { $chamfer } мм і зенківка на тому самому краї: лишіть одну
promised = таблиця схем обіцяє квалітет { $it }; за A.1 цей ланцюг дає { $own }
no-drill-so-large = свердло Ø{ $diameter } > Ø{ $limit }, найбільшого для верстата
no-mill-enters = жодна кінцева фреза таблиць не входить в отвір завширшки { $hole } мм із зазором { $clearance } мм
no-tap = немає мітчика { $thread } у { $tables-count ->
        [1] таблиці
       *[other] таблицях
    } { $tables }
no-taper-reamer = конус 1:{ $ratio } до Ø{ $diameter } роблять конічною розверткою після ступінчастого свердління, а в каталогах її немає, бо її довжин немає на жодній знайденій сторінці: конус лишається не зроблений; сплануйте тут циліндр, а конус розверніть вручну
no-cone-of-angle = немає конічної зенківки { $angle }° (до Ø{ $diameter }); у { $tables-count ->
        [1] таблиці
       *[other] таблицях
    } { $tables } є { $angles }°
no-cone-so-pointed = немає зенківки { $angle }° до Ø{ $diameter } для отвору Ø{ $hole }: у достатньо широких із { $tables-count ->
        [1] таблиці
       *[other] таблиць
    } { $tables } торець Ø{ $tip } і більше, а він має ввійти в отвір
no-cone-so-wide = немає зенківки { $angle }° до Ø{ $diameter } для отвору Ø{ $hole }: найбільша в { $tables-count ->
        [1] таблиці
       *[other] таблицях
    } { $tables } – Ø{ $widest }
overhang-tap = виліт мітчика { $free } мм
thread-outside-chuck = різь { $thread } поза патроном { $low }–{ $high }
magazine-reloaded = інструментів – { $tools }, а місць у магазині – { $places }: { $count ->
        [1] T{ $last }
       *[other] з T{ $first } по T{ $last }
    } ставлять вручну, коли попередні відпрацювали (завантажень магазину: { $loads })
