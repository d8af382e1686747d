# A program that was run.
check-title = Перевірка програми { $program }
check-made = Що вимагає план і що з цього робить програма
check-not-compared = програму не порівняно з деталлю: програма з помилкою в тексті не виконується
check-mend-first = виправте помилки, названі вище, і перевірте ще раз
check-trace = Переміщення: рядок, кадр, дія, положення осей верстата, мм
trace-rapid = прискор.
trace-feed = подача
trace-arc-cw = дуга G2
trace-arc-ccw = дуга G3
trace-dwell = пауза
trace-spindle = шпиндель
trace-coolant = МОР
trace-tool = інстр.
trace-length = довжина
trace-radius = радіус
trace-machine = верстат
trace-stop = зупинка
trace-end = кінець
trace-centre = центр
trace-turns = обертів
trace-s = с
trace-stopped = стоїть
trace-clockwise = за год. стрілкою
trace-counterclockwise = проти год. стрілки
trace-on = увімкнено
trace-off = вимкнено
trace-left = ліворуч
trace-right = праворуч
trace-min = хв
trace-lead = крок
trace-away = відвід
trace-thread = різь
trace-optional = за потреби
check-errors = { $count } { $count ->
        [one] помилка
        [few] помилки
       *[many] помилок
    }
check-warnings = { $count } { $count ->
        [one] попередження
        [few] попередження
       *[many] попереджень
    }
check-notes = { $count } { $count ->
        [one] зауваження
        [few] зауваження
       *[many] зауважень
    }
check-times = Час, хв
check-times-of = { $total } (робоча подача – { $feed }, холості ходи – { $rapid }, паузи – { $dwell }, заміна інструмента – { $change })
check-times-alone = робоча подача { $feed }, паузи { $dwell }; холостих ходів і замін інструмента не враховано: назвіть верстат через --machine
check-machine-assumed = верстат не названо: взято { $machine }, для якого описано мову { $control }; його меж не перевірено
check-name-machine = назвіть верстат через --machine, цей чи інший: тоді межі перевірять
check-lathe-times = робоча подача { $feed }, паузи { $dwell }; холостих ходів і замін інструмента не враховано: назвіть верстат через --machine
check-lathe-times-of = { $total } (робоча подача { $feed }, холості ходи { $rapid }, паузи { $dwell }); не враховано замін інструмента та холостих ходів невідомої довжини ({ $left })
check-lathe-trace = Переміщення: рядок, дія, положення (діаметр, Z), мм
# The knowledge base that was checked.
lint-title = Перевірка бази знань
lint-documentation = Графи й рядки лише для читача
lint-summary = { $tables }, { $rows }, { $findings }
