# The three ways.
auxiliary-scheme = схема { $scheme } для отвору «{ $kind }»
no-auxiliary-scheme = А.10 не дає схеми: { $kind } Ø{ $diameter }, допуск міжосьової відстані { $centre } мм
complex = комплекс { $complex } для отвору «{ $kind }»
complex-transitions = переходи комплексу { $complex }
no-complex = А.4 не дає комплексу: квалітет { $it }, Ø{ $diameter }, допуск міжосьової відстані { $centre } мм
no-complex-group = А.4 не має групи для отвору квалітету { $it }, Ø{ $diameter }, допуск { $centre } мм: вона для суцільного металу, квалітети 7-9 та 12 і грубіші
searched = знайдено пошуком за станами отвору: { $transitions }
searched-step = можливий перехід: { $operation }
no-path = жоден ланцюг переходів не дає квалітету { $it } і { $roughness }
state-unreachable = стан { $state } з Ø{ $diameter } нічим не досягається
bored-by-another = { $operation } тут робить інший перехід
no-centre-in-a-hole = центрування не потрібне: отвір уже є (квалітет { $it }, Ø{ $diameter }, { $ratio } D)
# What a route holds.
reaches = досягається квалітет { $it }, { $roughness }
rough-face = свердління по необробленій поверхні: точність міжцентрових відстаней нижча на { $percent } %; таблиці спитано з тіснішим допуском
misses-grade = за таблицями досягається квалітет { $it }, а потрібен { $asked }
misses-roughness = за таблицями досягається { $roughness }, а потрібно { $asked }
chamfer-inside-thread = фаска Ø{ $diameter } вужча за різь { $thread }: заходу мітчику не дає
reaches-again = те саме ще раз ширшим інструментом: квалітет { $it }, { $roughness }
reaches-by-itself = готує наступний перехід: сам по собі квалітет { $it }, { $roughness }
reaches-no-worse = готує наступний перехід і не погіршує зробленого: квалітет { $it }, { $roughness }
reaches-thread = різь: { $roughness }
drills-too-short = найбільше свердло, що сюди годиться, Ø{ $diameter }: сягає { $reach } мм < { $needed } мм
promised-finer = { $table } обіцяє квалітет { $it }, а за А.1 ці переходи дають { $own }
misses-position = положення осі { $position } > { $asked } мм допустимих
misses-axis = інструмент іде за віссю литого отвору, положення якої невідоме, а допустимо { $asked } мм
misses-unknown = таблиці не кажуть, що досягається
not-bored = положення осі просить розточувального інструменту (1.2), але жодна оправка сюди не годиться; маршрут без розточування
position-asks-boring = не розточує, хоч допустиме відхилення осі { $position } < 0.1 мм (1.2)
boring-not-asked = розточує, хоч допустиме відхилення осі { $position } >= 0.1 мм цього не просить (1.2)
milled-not-round = фрезерований отвір Ø{ $diameter }: некруглість верстата { $roundness } > { $most } мм, частки допуску
# Why a route lost.
lost-by-time = повільніше на { $slower } хв
lost-by-places = швидше на { $quicker } хв, але потребує більше місць у магазині, якого не вистачає
lost-by-order = рівний час; за порядком способів стоїть далі
ranked-later = за таблицями стоїть після { $first }, яку можна здійснити
same-as = той самий маршрут, що { $table } { $same }
# Diameters.
core-drill-stock = під зенкер лишають { $stock } мм на діаметр від Ø{ $nominal }
handbook-step = проміжний діаметр довідника Ø{ $advised }; взято Ø{ $taken } (1.2.1: { $low }-{ $high })
handbook-step-outside = проміжний діаметр довідника Ø{ $advised } поза межами 1.2.1 ({ $low }-{ $high }) або ряду свердел; взято Ø{ $taken }
handbook-first-drill = довідник свердлить спершу Ø{ $first }, потім Ø{ $diameter }
milled-instead = Ø{ $diameter } великий: замість першого розточування - фрезерування (контурна система)
no-drill-before = { $operation } до Ø{ $diameter }: немає свердла, що лишає припуск (до Ø{ $largest })
no-counterbore-in-allowance = { $operation } до Ø{ $diameter }: немає цеківки Ø{ $low }-{ $high } під припуск
step-finished-elsewhere = ступінь { $diameter } за таблицями остаточно обробляють на іншому верстаті; тут лишено припуск
no-hole-to-open = { $operation }: немає отвору, який розкривати
stock-too-small = { $operation } від Ø{ $start } до Ø{ $diameter }: припуск { $stock } мм < { $least } мм, інструмент не ріже
tapped-at-once = отвір заготовки Ø{ $start } вже під різь { $thread }: лишається нарізати
opened-already = { $operation } до Ø{ $diameter }: отвір уже Ø{ $start }
stock-outside-allowance = { $operation } до Ø{ $diameter }: припуск { $stock } мм поза { $low }-{ $high } мм
no-thread-to-tap = у цього отвору немає різі
# The rest of a hole.
edge = край: до Ø{ $diameter }, глибина { $depth } мм
flat-floor = плоске дно: свердло спиняється на { $stop } мм, фреза вирівнює до { $depth } мм
floor-not-flat = плоского дна не зробити: лишається конус свердла
flat-under-thread = під різь глибиною { $depth } мм отвір свердлять до { $drilled } мм і конусом: плоске дно на { $depth } мм неможливе; задайте `bottom: free`
too-shallow-for-flat = отвір глибиною { $depth } мм мілкіший за вершину свердла Ø{ $diameter }
no-flat-opening = Ø{ $diameter }: жоден інструмент не лишає плоского торця уступу; найближчі цеківки { $below } і { $above }
no-opening = Ø{ $diameter }: нічим розкрити з Ø{ $start }
step-too-deep = ступінь глибиною { $depth } >= { $limit } мм, товщини заготовки
groove-not-axial = канавку Ø{ $diameter } шириною { $width } мм на глибині { $depth } мм осьовий інструмент не обробляє: потрібен різець на іншому верстаті
thread-chamfer = фаска під різь на крок { $pitch } мм
thread-of-step = різь { $thread } на ступені
tap-elsewhere = різь { $thread }: верстат { $machine } різі не нарізає; останній перехід - на іншому верстаті, його режими - орієнтир
second-setup = ступені зі зворотного боку: другий установ після перевертання; координати - від першого; час перевертання не враховано
# Tools.
step-drill = ступінчасте свердло Ø{ $narrow }/Ø{ $wide } робить обидва діаметри за один хід
no-step-drill = немає ступінчастого свердла Ø{ $narrow }/Ø{ $wide }
cutter-ground-down = у каталогах немає цього розміру: Ø{ $own } перешліфувати на Ø{ $size }
mill-too-large = { $tool } ({ $table }): фреза Ø{ $diameter } > Ø{ $limit }
tool-too-wide = { $tool } ({ $table }): Ø{ $diameter } > Ø{ $limit }, найбільшого в магазині
assembly-too-heavy = комплект з { $holder }: маса { $mass } > { $limit } кг
practice-speed = швидкість за формулою { $formula } м/хв; практика цеху з швидкорізальною сталлю - до { $limit } м/хв
does-not-pass = { $tool } ({ $table }): Ø{ $diameter } >= Ø{ $within } ступеня, крізь який він мав би пройти
pilot-wider-than-hole = { $tool } ({ $table }): отвір під цапфу Ø{ $pilot } > Ø{ $hole }: середина лишиться невирізаною
chamfered-by-centring = фаску тут знімає центрування: ступінчасте свердло зайве
chamfer-in-countersink = фаска { $chamfer } мм і зенківка на тому самому краї: лишіть одну
promised = таблиця схем обіцяє квалітет { $it }; за А.1 цей ланцюг дає { $own }
no-drill-so-large = свердло Ø{ $diameter } > Ø{ $limit }, найбільшого для верстата
no-mill-enters = жодна кінцева фреза не входить в отвір Ø{ $hole } із зазором { $clearance } мм; найменша Ø10
no-tap = немає мітчика { $thread } у таблицях { $tables }
no-cone-of-angle = немає конічної зенківки { $angle }° (до Ø{ $diameter }); у { $tables } є { $angles }°
no-cone-so-wide = немає зенківки { $angle }° до Ø{ $diameter } для отвору Ø{ $hole }: найбільша в { $tables } Ø{ $widest }
overhang-tap = виліт мітчика { $free } мм
thread-outside-chuck = різь { $thread } поза патроном { $low }-{ $high }
magazine-reloaded = { $tools } інструментів на { $places } місць: з T{ $first } по T{ $last } ставлять вручну, коли попередні відпрацювали (завантажень магазину: { $loads }; час ручної заміни не враховано)
