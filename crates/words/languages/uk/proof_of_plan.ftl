# Чого не доведено в плані: кожна нерівність, яка не виконується.
proof-no-stock = { $operation }: немає припуску в найгіршому разі: отвір Ø{ $before } може вийти Ø{ $may_be }, осі можуть розійтися на { $shift } мм; лишається { $least } мм, а має бути понад 0
proof-grade = { $operation } не дає квалітету { $asked }: на практиці IT{ $ordinary }, щонайліпше IT{ $best }
proof-grade-at-best = { $operation } дає квалітет { $asked } лише за найкращих умов: звичайно IT{ $ordinary }, щонайліпше IT{ $best }
proof-surface = { $operation } не дає { $asked }: на практиці { $ordinary }, щонайліпше { $best }
proof-surface-at-best = { $operation } дає { $asked } лише за найкращих умов: звичайно { $ordinary }, щонайліпше { $best }
proof-position = { $operation }: положення осі { $best }…{ $ordinary } мм > { $asked } мм допустимих
proof-position-at-best = { $operation }: положення осі звичайно { $ordinary } мм > { $asked } мм допустимих; щонайліпше { $best } мм
proof-too-wide = { $operation } Ø{ $diameter }: отвір може вийти Ø{ $may_be } > Ø{ $limit }, верхньої межі
proof-not-finished = останній перехід лишає Ø{ $left }, а за кресленням має бути Ø{ $smallest }…{ $largest }
proof-enters = { $operation }: інструмент Ø{ $tool } ширший за готовий отвір, Ø{ $limit }
proof-spot-stays = лунка центрування Ø{ $spot } ширша за отвір і його фаску, Ø{ $limit }: слід лишиться на деталі
proof-too-shallow = { $operation }: повний діаметр до { $depth } мм, а потрібно { $asked } мм
proof-breaks-through = { $operation }: вершина на глибині { $tip } мм виходить крізь дно; товщина { $thickness } мм
proof-floor = { $operation }: інструмент іде до { $tip } мм, а отвір повного діаметра відкрито до { $opened } мм
proof-tap-hole = свердло Ø{ $diameter } під різь поза межами внутрішнього діаметра 6H: { $smallest }…{ $largest } мм
proof-thrust = { $operation }: осьова сила { $value } Н > { $percent } % від допустимих { $limit } Н
proof-torque = { $operation }: крутний момент { $value } Н·м > { $percent } % від допустимих { $limit } Н·м
proof-power = { $operation }: потужність { $value } кВт > { $percent } % від { $limit } кВт привода
not-proven = план не доведено: { $why }
reamed-short = над плоским дном розвертка лишає { $lead } мм глибини нерозгорнутими: її забірна частина
lost-by-preference = перевагу надано таблицям; цей маршрут швидший на { $quicker } хв
tables-preferred = перевагу надано таблицям: { $own } хв; найкращий план – { $best } хв, заощаджує { $saves } хв
no-place-for-clamps = двом чи чотирьом притискачам немає місця на площині, де вони втримали б деталь: { $why }; потрібні лещата або спеціальне пристосування, що витримають M = { $torque } Н·м
proof-too-fast = { $operation }: швидкість { $value } м/хв > { $percent } % верхньої межі практики, { $usual } м/хв
proof-twists = { $operation }: крутний момент { $value } Н·м > { $limit } Н·м, які витримує свердло Ø{ $drill }
proof-bar-slender = { $operation }: виліт оправки { $reach } мм > { $ratio } її діаметра, { $bar } мм
proof-bar-springs = { $operation }: оправка відтискається на { $spring } мм діаметра через нерівний припуск > { $tolerance } мм допуску
