# Schemes.
audit-scheme-mixed = рядок названо за схемою { $stated }, а інші рядки групи за { $other }
audit-scheme-uncentred = { $printed } дає схему { $stated }, але за 1.2.1 такий отвір спершу центрують, тож { $scheme } ({ $table })
audit-route-by-scheme = переходи { $printed } для схеми { $stated } слово в слово; `technolog plan` робить { $scheme } ({ $table }) так: { $better }
audit-one-drill = Ø{ $diameter } одним свердлом: за 1.2.1 свердлять двома, перше 0,5–0,6 діаметра
# Openings.
audit-opening-not-made = на кресленні є { $feature } Ø{ $diameter }, а жоден перехід цього не робить
audit-opening-not-centred = на кресленні є { $feature } Ø{ $diameter }, а жоден перехід цього не робить; центрувальне заглиблення Ø{ $spot } вужче
audit-opening-unasked = перехід «{ $operation }» зайвий: креслення цього в отворі не вимагає
audit-opening-diameter = за кресленням: { $feature }
audit-opening-depth = за кресленням: { $feature }
# Depths.
audit-depth-of-hole = отвір { $hole } креслення такої глибини не має
audit-spot-depth = глибина центрувального заглиблення t = (D/2)/tg φ за кутом центрувального свердла
audit-travel-short = довжина робочого ходу менша за глибину переходу, { $depth } мм, а до неї додаються ще врізання й перебіг
audit-breaks-through = вершина інструмента на { $end } мм, а деталь завтовшки { $thickness } мм: глухий отвір стане наскрізним
# Threads.
audit-tap-drill = отвір під { $thread } від { $low } до { $high } мм
audit-thread-short = різь { $thread } креслення завглибшки { $depth } мм
audit-thread-runout = під різь { $thread } завглибшки { $depth } мм бракує місця для забірної частини мітчика
audit-thread-deep = різь { $thread } креслення завглибшки лише { $depth } мм
audit-thread-elsewhere = різь { $thread } у плані не нарізають: цей верстат не може, отже її ріжуть на іншому (рядок `operation: tap` з `elsewhere: true` скаже це явно)
audit-cannot-tap = верстат { $machine } різь не нарізає: перехід роблять на іншому (`elsewhere: true`)
# Allowances.
audit-allowance = перехід { $row } ({ $operation }) знаходить { $stock } мм на діаметр, а за 1.2.1 від { $low } до { $high }
audit-transition-missing = перед переходом { $row } ({ $operation }) бракує переходу «{ $missing }»: інструмент знаходить { $stock } мм на діаметр, а за 1.2.1 може зняти щонайбільше { $high }
audit-passes = { $stock } мм на діаметр за 1.2.1 (до { $high } за робочий хід) розточують за стільки робочих ходів: { $needed }
# Cutters, holders, places.
bar-of-other-stage-rough = { $tool }: борштанга для чорнового розточування
bar-of-other-stage-finish = { $tool }: борштанга для чистового розточування
bar-of-other-range = { $tool } розточує Ø{ $low }…{ $high }, а перехід вимагає Ø{ $needed }
tap-of-other-thread = { $tool }: мітчик { $own }, а різь { $needed }
tool-of-other-angle = { $tool }: кут { $own }°, а перехід вимагає { $needed }°
tool-for-blind-holes = { $tool } для глухих отворів, а отвір наскрізний: для нього { $known }
tool-for-through-holes = { $tool } для наскрізних отворів, а отвір глухий: для нього { $known }
holder-of-whole-tool = { $tool } має власний конус 7:24 і стоїть у шпинделі сам: { $holder } його не тримає
holder-of-other-family = { $holder } не для такого хвостовика, як у { $tool }: для нього { $known }
audit-no-place = місця T{ $number } немає: у магазині їх { $places }
