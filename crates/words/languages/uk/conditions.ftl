# Conditions.
feed = подача: верхня межа { $upper } мм/об × { $multiple }
feed-choice = звідки взято подачу
feed-before-finishing = подача × { $factor }: далі розвертання чи різь
depth-feed-factor = подача × { $factor } за глибиною
depth-speed-factor = швидкість × { $factor } за глибиною
material-speed-factor = швидкість × { $factor } за матеріалом
speed-alloy-factor = швидкість × { $factor } за сплавом
material-force-factor = сили × { $factor } за матеріалом
force-alloy-factor = сили × { $factor } за сплавом
surface-factor = швидкість × { $factor } за станом поверхні
tool-life = період стійкості { $minutes } хв
speed-coefficients = коефіцієнти швидкості, Cv = { $cv }
load-coefficients = коефіцієнти моменту й осьової сили
boring-feed = подача розточування { $feed } мм/об
boring-finish-feed = подача за шорсткістю { $feed } мм/об
too-fine-to-bore = { $roughness } розточуванням не досягти
spindle-step = розрахункова частота { $computed }; сусідні ступені частоти обертання { $below } і { $above } (вищий на { $excess } %): { $step } об/хв
spindle-step-in-practice = розрахункова частота { $computed }; сусідні ступені частоти обертання { $below } і { $above }; вищий швидший за практику, яка має щонайбільше { $fastest } об/хв: { $step } об/хв
spindle-fastest = розрахункова частота { $computed } вища за найбільшу: { $step } об/хв
spindle-slowest = розрахункова частота { $computed } нижча за найменшу: { $step } об/хв
feed-reduced = подачу зменшено з { $from } до { $to } мм/об: { $by }, межа { $limit }
load-margin = навантаження може брати { $percent } % межі верстата
speed-for-feed = швидкість узято для подачі { $feed } мм/об: { $speed } м/хв замість { $before }
life-for-feed = для подачі { $feed } мм/об формула дає { $speed } м/хв: період стійкості пораховано від неї
tap-lead = забірна частина мітчика { $lead } мм проходить далі за повну різь
thread-runout = під глуху різь свердлять на { $runout } мм глибше
thread-runout-short = під глуху різь свердлять на { $runout } мм глибше, на довжину забірної частини мітчика: на звичайні { $usual } мм немає місця
mill-clearance = фреза менша за отвір, у який входить, щонайменше на { $clearance } мм
countersink-goes-round = жодна зенківка не досить широка: менша обходить край по колу, її торець за { $clearance } мм від стінки нижче
mill-cuts-down = торцеві зубці фрези доходять до середини, тож вона врізається прямо вниз; до { $percent } % того, що фрезерують, її центрові лишається подача
mill-over-hole = фреза не мусить входити в отвір Ø{ $hole }: без зубів лише середина, { $percent } % її діаметра
ground-within = перешліфовується щонайбільше на { $limit } мм
feed-held = подачу обмежено { $limit } мм/хв
stand-in = { $table } не має числа для матеріалу { $material }; узято: { $group }
no-figure = { $operation }: таблиця { $table } не має числа для матеріалу { $material }
stand-in-operation = { $operation }: власних чисел немає; взято числа переходу «{ $instead }»
stand-in-tool-material = { $table } не має числа для інструментального матеріалу { $tool }; узято: { $other }
no-cutter-shape = { $operation }: фрезу не вказано
no-pitch = { $operation }: крок різі не вказано
mill-does-not-enter = { $operation }: фреза Ø{ $diameter } не входить в отвір Ø{ $hole }
milling-rounds = робочих ходів { $passes }, рівнів { $levels }: t = { $t } мм, B = { $b } мм; шлях осі фрези { $path } мм, її подача × { $factor }
slot-passes = робочих ходів { $passes }, рівнів { $levels }: t = { $t } мм, B = { $b } мм; шлях осі фрези в пазу { $path } мм
slot-arc-feed = обходів уздовж стінок { $passes }; на дугах стінка лежить далі за вісь фрези, тож подача осі там – r/R подачі вздовж стінок, де r – радіус її шляху, R – радіус стінки: на найтіснішій дузі { $percent } %, але не менше { $least } мм/зуб
slot-finished = та сама фреза лишає на стінках { $stock } мм і знімає їх ще одним обходом
slot-milled-at-once = чистового обходу стінки не потребують
milling-finish-round = останнє коло знімає { $stock } мм на бік: воно чистове
plunge-feed = униз іде з { $percent } % подачі вздовж стінки
feed-per-tooth = подача на зуб { $feed } мм
milling-finish-feed = подача на зуб × { $factor }: останній робочий хід, { $roughness }
milling-load-coefficients = коефіцієнти сили Pz фрези
tapping-coefficients = коефіцієнти швидкості мітчика, Cv = { $cv }, T = { $minutes } хв
tapping-load-coefficients = коефіцієнти моменту мітчика
feed-is-pitch = подача дорівнює крокові { $pitch } мм
spindle-step-below = розрахункова частота { $computed }; ступінь не вище неї: { $step } об/хв
no-step-below = { $operation }: жоден ступінь шпинделя не нижчий за { $computed } об/хв з достатньою потужністю й подачею
torque-beyond-spindle = { $operation }: момент { $torque } Н·м, а шпиндель дає { $limit } Н·м
reaming-feed = подача розвертання × { $factor }
feed-within-practice = довідник дає { $table } мм/об, практика щонайбільше { $practice } у суцільному металі: взято { $multiple } × це
reaming-feed-practice = довідник дає { $table } мм/об, практика щонайбільше { $feed } мм/об, її й узято
reaming-feed-blind = глухий отвір: подача в межах { $low }–{ $high } мм/об
reaming-load-coefficients = коефіцієнти сили різання зуба розвертки
reamer-teeth = зубів розвертки { $teeth }
too-deep = { $operation }: глибина { $ratio } D поза таблицею { $table }
card-calibration = карта: { $name } × { $factor } до того, що дає формула
card-point = карта друкує тут V = { $speed } м/хв, P = { $thrust } Н, N = { $power } кВт
card-point-forces-differ = карта друкує тут V = { $speed } м/хв, P = { $thrust } Н, N = { $power } кВт; силу й потужність формула не відтворює; навантаження взято за формулою
card-corrections = поправки прикладу: швидкість × { $product }, матеріал { $material }
card-without-depth = глибина { $ratio } D: коефіцієнт { $factor } ({ $table }) не враховано, поправки карт на глибину невідомі
card-other-grade = поправки карт відомі лише для { $example }, марки з прикладу; для { $material } їх немає
card-other-material = поправки карт для матеріалу { $material } невідомі
stock-of-practice = на практиці розвертка знаходить від { $low } до { $high } мм на діаметр
force-opinion = за формулами виробника { $thrust } Н і { $torque } Н·м; наші становлять { $thrust_percent } % і { $torque_percent } % від них
torque-opinion = за питомою силою різання { $torque } Н·м за { $feed } мм/об; формула дає { $percent } % від цього
torque-by-specific-force = формула дає менше ніж дві третини: береться більший момент
reamed-for-surface = остання розвертка обертається не швидше за чорнову, що знімає { $stock } мм: { $speed } м/хв
hardness-no-force = вказана твердість HB { $stated } не змінює сил: таблиці мають сили для { $material } в одному стані, HB { $own }; твердіший метал потребує більших
strength-no-force = вказана міцність { $stated } МПа не змінює сил: таблиці мають сили для { $material } в одному стані, { $own } МПа; міцніший метал потребує більших
