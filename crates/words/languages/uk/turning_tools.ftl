# What is not known, and what does not fit.
lathe-lacks = каталог верстата { $lathe } не має `{ $quantity }`
turning-tool-lacks = рядок різця { $tool } не має `{ $quantity }`
bound-not-reckoned = обмежень за величиною «{ $what }» не враховано: у даних верстата { $of } її немає
limit-not-known = граничну глибину різання не знайти: { $of } не має величини «{ $what }» ({ $bound })
angle-beyond-table = кут { $angle }° поза таблицею { $table }
lathe-too-small = верстат { $lathe }: { $is } мм більше за його `{ $quantity }`, { $most } мм
shank-too-high = верстат { $lathe }: державка різця { $tool } заввишки { $is } мм, а вміщається { $most } мм
nothing-to-cut = `{ $quantity }` дорівнює { $is }, а має бути більше за 0
tool-has-no-depth = різець { $tool } не має глибини різання, яку можна вибирати: канавку він ріже на свою ширину, різь – на її профіль
threads-not-reckoned = режими нарізання різі різцем { $tool } ще не рахуються
too-fine-to-turn = { $roughness } – чистіше, ніж мають таблиці подач точіння
too-fine-for-lathe = верстат { $lathe }: { $roughness } чистіше за найкращу для нього { $best }
# Why a figure.
feed-bound-by-nose = вершина витримує не більше: { $feed } мм/об = { $share } її радіуса { $radius } мм
turning-feed = подача { $feed } мм/об, різець { $tool }
turning-finish-feed = подача за шорсткістю { $feed } мм/об
force-coefficients = коефіцієнти сили { $component }
grade-factor = швидкість × { $factor }: сплав { $grade } замість { $reference }
internal-factor = швидкість × { $factor }: в отворі
angle-speed-factor = швидкість × { $factor }: кут { $angle }°
angle-force-factor = сила × { $factor }: кут { $angle }°
rake-force-factor = сила × { $factor }: передній кут { $angle }°
practice-range = за цеховими таблицями { $low }–{ $high } м/хв; формули для цього матеріалу довідник не має
specific-force = питома сила різання групи { $group } за VDI 3323: kc1 = { $kc } МПа, mc = { $mc }
force-share = × { $factor }: частка від головної складової сили
lathe-limit = верстат дає { $limit }
turning-limit = { $name } = { $value }
overhang = виліт { $length } мм
insert-edge = у роботі не більше { $share } кромки { $edge } мм: { $depth } мм глибини
chip-width = стружка ламається за глибини до { $ratio } подач: { $depth } мм за { $feed } мм/об
elastic-modulus = модуль пружності { $modulus } МПа
bar-too-long = { $tool }: виліт борштанги { $overhang } мм більший за допустимі { $most } мм
part-too-slender = деталь ({ $support }, довжина { $ratio } діаметра) прогинається раніше, ніж досягнуто доцільної глибини різання; потрібно: { $ask }
part-bears-little = деталь ({ $support }, довжина { $ratio } діаметра) витримує лише робочі ходи по { $depth } мм; для глибших потрібно: { $ask }
feed-of-nose = подача { $feed } мм/об: вершина радіусом { $radius } мм не лишає грубішої поверхні, а справжня шорсткість у { $factor } раза більша за геометричну
roughness-unsaid = кресленик не називає шорсткості; чистове точіння як для { $roughness }
cuts-back = { $tool }: допоміжна кромка ріже на зворотному ході, φ1 = { $angle }°
cuts-not-back = { $tool }: допоміжна кромка на зворотному ході терлася б, φ1 = { $angle }°
feed-within-jaws = подача { $feed } (з { $before }) мм/об за { $rpm } об/хв, щоб кулачки втримали деталь під різцем
feed-within-part = подача { $feed } замість { $before } мм/об, щоб прогин деталі не перевищив своєї частки допуску
