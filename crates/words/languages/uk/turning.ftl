# Mistakes of a shaft file.
empty-name = назва порожня
    .help = назвіть вал
unknown-lathe = верстата `{ $lathe }` немає в каталозі; є: { $known }
    .help = назвіть один із них або приберіть `machine`
unknown-material = матеріалу `{ $material }` немає
    .help = матеріали дає `technolog table materials`
unknown-material-near = матеріалу `{ $material }` немає; можливо, `{ $near }`?
    .help = матеріали дає `technolog table materials`
no-such-choice = невідоме значення `{ $word }`; є { $known }
    .help = візьміть одне з них
not-above-zero = `{ $key }` дорівнює { $length }, а має бути більше за 0
    .help = пишіть міліметри без знака
length-too-large = `{ $key }` дорівнює { $length }, більше за { $most }
    .help = пишіть міліметри
no-steps = у вала немає жодного ступеня
    .help = опишіть ступені від вільного торця до патрона
step-beyond-blank = ступінь { $step }: Ø{ $diameter } більший за заготовку Ø{ $blank }
    .help = візьміть більшу заготовку
step-rises-to-the-free-end = ступінь { $step }: Ø{ $diameter } менший за Ø{ $before } ступеня { $other }, який ближче до вільного торця
    .help = перевірте порядок: від вільного торця до патрона діаметри не спадають; вузьке місце за ширшим точать з другого установа або канавковим різцем
steps-beyond-blank = ступені разом { $sum } мм довші за заготовку { $blank } мм; заготовка тут закінчується
    .help = візьміть довшу заготовку або вкоротіть ступені
grid-too-fine = рівнів і шарів забагато: { $states } станів, а можна не більше { $most }
    .help = візьміть більші глибини
# What the command cannot do with what it was given.
no-rates = для часу бракує подач: у файлі немає `rates`
    .help = допишіть подачі, мм/хв, наприклад `rates: {"{"}longitudinal_feed: 180, transverse_feed: 150, rapid: 6000{"}"}`
    .help = допишіть rates: {"{"}longitudinal_feed: 180, transverse_feed: 150, rapid: 6000{"}"}, мм/хв
way-without-tool = операція не має інструмента для чорнової обробки цього вала, тож жоден спосіб не можна записати
    .help = чого бракує, показує `--show operation`
rich-has-no-time = з розширеними ходами час не шукається
    .help = візьміть іншу мету: path, path-and-passes чи passes
# Why a pass.
pass-shorter = далі { $left } мм, з ходом іншого напряму { $otherwise } мм
pass-quicker = далі { $left } хв, з ходом іншого напряму { $otherwise } хв
pass-fewer = далі ходів { $left }, з ходом іншого напряму { $otherwise }
pass-as-good = обидва напрями однаково добрі, далі { $unit ->
        [min] { $left } хв
        [passes] ходів { $left }
       *[mm] { $left } мм
    }
pass-of-variant = так каже варіант
pass-of-step = напрям ступеня { $step }
pass-of-search = з пошуку розширених ходів, далі { $unit ->
        [passes] ходів { $left }
       *[mm] { $left } мм
    }
# Which variant, and what to know.
take-lengthwise = у центрах найменше ходів дає переміщення вздовж осі
take-searched = у патроні ходи вздовж і поперек осі можна поєднувати
take-contour = заготовку, близьку до форми деталі, обробляють паралельно контуру
contour-passes-elsewhere = ходи паралельно контуру, придатні для заготовки, близької до форми деталі, показує `--show operation`; ходи тутешніх способів прямі
way-across = має ходи поперек осі
way-full-cylinder = його ходи зняли б повний циліндр, а заготовка не така
way-by-proof = за перевіркою його програми: { $why }
way-quickest = { $variant }: { $length } мм за { $time } хв, найшвидший із придатних, що не лишають металу, на { $margin } хв ({ $percent } %) швидший, ніж { $rival }
way-as-quick = { $variant }: { $length } мм за { $time } хв, так само швидко, як { $rival }, і швидше за інші способи, що не лишають металу; лекція віддає перевагу першому
way-only = { $variant }: { $length } мм за { $time } хв, єдиний придатний
way-none = жоден із цих способів: кожен відхилено з причини, названої там
variant-beyond-model = варіант { $variant } коротший за найкращий у моделі: його поздовжні ходи зупиняються всередині рівня
nothing-to-turn = жоден ступінь не менший за заготовку: знімати нічого
